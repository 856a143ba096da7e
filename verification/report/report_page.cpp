// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/report_page.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "radcert/core/base64.h"
#include "radcert/core/text.h"
#include "radcert/core/version.h"
#include "radcert/formats/json/json_value.h"
#include "radcert/formats/plot/experiment_plots.h"
#include "radcert/formats/plot/svg_plot.h"
#include "verification/framework/reading/embedded.h"
#include "verification/report/report_text.h"

namespace radcert::verification {
namespace {

constexpr std::string_view data_gap = "/*DATA*/";

// Single precision, least byte first: what a Float32Array reads.
std::string floats(const std::vector<double>& values) {
  std::string bytes;
  bytes.reserve(4 * values.size());
  for (const double value : values) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (unsigned shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<char>(bits >> shift & 0xFFU));
  }
  return base64(bytes);
}

void append(std::vector<double>& out, const Vector<double>& v) { out.insert(out.end(), {v.x, v.y, v.z}); }

// The inner normal at a node of each element; zero where there is none.
std::vector<Vector<double>> element_normals(const ProblemTrace& problem) {
  std::vector<Vector<double>> normals(problem.elements.size(), Vector<double>{0, 0, 0});
  for (const NodeValue& node : problem.nodes)
    if (node.element < normals.size()) normals[node.element] = node.normal;
  return normals;
}

// Corners run counterclockwise as the inner normal sees them.
JsonValue picture_json(const ProblemTrace& problem) {
  if (problem.elements.empty()) return {};
  std::vector<double> corners;
  std::vector<double> corner_values;
  const std::vector<Vector<double>> normals = element_normals(problem);
  for (std::size_t k = 0; k < problem.elements.size(); ++k) {
    const ElementValue& element = problem.elements[k];
    const auto& [a, b, c] = element.corners;
    const bool turned = dot(cross(b - a, c - a), normals[k]) < 0;
    for (const std::size_t j :
         turned ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2}) {
      append(corners, element.corners[j]);
      corner_values.push_back(element.corner_values[j]);
    }
  }
  std::vector<double> nodes;
  std::vector<double> node_values;
  std::vector<double> node_errors;
  // An element is painted with the largest error at its nodes: the error between them is not known.
  std::map<std::size_t, double> element_error;
  for (const NodeValue& node : problem.nodes) {
    append(nodes, node.point);
    node_values.push_back(node.u_n.value);
    if (!node.u) continue;
    const double error = std::abs(*node.u - node.u_n.value);
    node_errors.push_back(error);
    element_error[node.element] = std::max(element_error[node.element], error);
  }
  JsonValue out = JsonValue::object();
  out.set("level", problem.drawn_level);
  out.set("corners", floats(corners));
  out.set("corner_values", floats(corner_values));
  out.set("nodes", floats(nodes));
  out.set("node_values", floats(node_values));
  if (node_errors.size() != problem.nodes.size()) {
    out.set("node_errors", JsonValue());
    out.set("corner_errors", JsonValue());
    return out;
  }
  std::vector<double> corner_errors;
  for (std::size_t k = 0; k < problem.elements.size(); ++k)
    corner_errors.insert(corner_errors.end(), 3, element_error[k]);
  out.set("node_errors", floats(node_errors));
  out.set("corner_errors", floats(corner_errors));
  return out;
}

// "# Atkinson and Chandler 1998" and the paragraph that names the publication.
struct PaperHead {
  std::string title;
  std::string reference;
};

PaperHead head_of(std::string_view readme) {
  PaperHead head;
  std::size_t at = 0;
  while (at < readme.size()) {
    const std::size_t end = std::min(readme.find('\n', at), readme.size());
    const std::string_view line = readme.substr(at, end - at);
    at = end + 1;
    if (head.title.empty()) {
      if (line.starts_with("# ")) head.title = line.substr(2);
    } else if (!line.empty()) {
      head.reference += (head.reference.empty() ? "" : " ") + std::string(line);
    } else if (!head.reference.empty()) {
      break;
    }
  }
  return head;
}

std::vector<std::string> papers_of(const Report& report) {
  std::vector<std::string> keys;
  for (const ClaimReport& claim : report.claims)
    if (keys.empty() || keys.back() != claim.paper) keys.push_back(claim.paper);
  return keys;
}

JsonValue paper_json(const Report& report, const std::string& key) {
  const auto found = std::find_if(report.papers.begin(), report.papers.end(),
                                  [&](const PaperText& each) { return each.key == key; });
  const PaperText texts =
      found == report.papers.end() ? PaperText{.key = key, .folder = {}, .readme = {}, .errata = {}} : *found;
  const PaperHead head = head_of(texts.readme);
  return JsonValue::object({{"key", key},
                            {"title", head.title.empty() ? key : head.title},
                            {"reference", head.reference},
                            {"folder", texts.folder},
                            {"errata", texts.errata}});
}

// A plot's name: the error, the problems that it is of, and what it is against.
std::string plot_name(const ErrorKind& kind, std::span<const std::size_t> problems, ErrorAgainst against) {
  std::string name = kind.name + ":";
  for (const std::size_t i : problems) name += (name.back() == ':' ? "" : ",") + std::to_string(i);
  return name + (against == ErrorAgainst::mesh_size ? ":mesh_size" : ":unknowns");
}

// Of the titles of problems, whose parts semicolons separate, what not all of them have in common.
std::vector<std::string> short_names(const Report& report, std::span<const std::size_t> problems) {
  std::vector<std::vector<std::string>> parts;
  for (const std::size_t i : problems) {
    std::vector<std::string>& own = parts.emplace_back();
    const std::string& name = report.problems[i].name;
    for (std::size_t at = 0; at <= name.size();) {
      const std::size_t end = std::min(name.find("; ", at), name.size());
      own.push_back(name.substr(at, end - at));
      at = end + 2;
    }
  }
  const auto is_common = [&](const std::string& part) {
    return std::all_of(parts.begin(), parts.end(), [&](const std::vector<std::string>& each) {
      return std::find(each.begin(), each.end(), part) != each.end();
    });
  };
  std::vector<std::string> names;
  for (const std::vector<std::string>& own : parts) {
    std::string& name = names.emplace_back();
    for (const std::string& part : own)
      if (!is_common(part)) name += (name.empty() ? "" : "; ") + part;
  }
  return names;
}

// Each error of the problems of each statement against h, where one of them has two levels; the page shows
// what it needs.
std::map<std::string, std::string> plots_of(const Report& report) {
  std::map<std::string, std::string> plots;
  for (const ClaimReport& claim : report.claims) {
    const std::vector<std::string> names = short_names(report, claim.problems);
    std::vector<ErrorHistory> problems;
    for (std::size_t k = 0; k < claim.problems.size(); ++k)
      problems.push_back({.name = names[k],
                          .levels = report.problems[claim.problems[k]].levels,
                          .orders = report.problems[claim.problems[k]].orders});
    for (const ErrorKind& kind : error_kinds()) {
      const std::string name = plot_name(kind, claim.problems, ErrorAgainst::mesh_size);
      if (plots.contains(name)) continue;
      const Plot plot = convergence_plot(in_words(kind), kind, ErrorAgainst::mesh_size, problems);
      if (!plot.curves.empty()) plots.emplace(name, svg_text(plot));
    }
  }
  return plots;
}

std::map<std::string, std::string> plots_of(const Experiment& experiment, std::span<const Result> results) {
  std::map<std::string, std::string> plots;
  for (const std::vector<std::size_t>& question : questions(experiment))
    for (const ErrorKind& kind : error_kinds())
      for (const ErrorAgainst against : {ErrorAgainst::mesh_size, ErrorAgainst::unknowns})
        if (const Plot plot = combinations_plot(experiment, results, question, kind, against);
            !plot.curves.empty())
          plots.emplace(plot_name(kind, question, against), svg_text(plot));
  return plots;
}

JsonValue json_of(const std::map<std::string, std::string>& plots) {
  JsonValue out = JsonValue::object();
  for (const auto& [name, text] : plots) out.set(name, text);
  return out;
}

JsonValue page_data(const Report& report, const std::string& command) {
  return JsonValue::object(
      {{"report", report_json(report, command)},
       {"papers",
        json_array(papers_of(report), [&](const std::string& key) { return paper_json(report, key); })},
       {"pictures", json_array(report.problems, picture_json)},
       {"plots", json_of(plots_of(report))}});
}

// Inside a script element no "<" may begin a tag or a comment.
std::string without_tags(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

std::string page_with(const JsonValue& data) {
  const std::string_view page = embedded_page().front().content;
  const std::size_t gap = page.find(data_gap);
  return std::string(page.substr(0, gap)) + without_tags(data.compact()) +
         std::string(page.substr(gap + data_gap.size()));
}

std::string in_html(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '&': out += "&amp;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

constexpr std::string_view built_without_node =
    "This page is plain: radcert was built without Node, which brings typeset formulas, plots and views in "
    "space. "
    "Install nodejs and npm and build again to have them.";

std::string plain_head(const std::string& title) {
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
         "<meta name=\"color-scheme\" content=\"light dark\"><title>radcert report</title>\n"
         "<style>body{font:16px/1.5 sans-serif;max-width:70rem;margin:1rem auto;padding:0 1rem}"
         "td,th{text-align:left;vertical-align:top;padding:.2rem .8rem .2rem 0}</style></head><body>\n<h1>" +
         in_html(title) + "</h1>\n<p>" + std::string(built_without_node) + "</p>\n";
}

std::string plain_page(const Report& report, const std::string& command) {
  std::string out = plain_head("What the papers say, and what a run found") + "<p>radcert " +
                    in_html(std::string(version())) + ", <code>" + in_html(command) + "</code>, budget " +
                    std::string(name(report.budget)) + ".</p>\n";
  for (const std::string& key : papers_of(report)) {
    out += "<h2>" + in_html(key) + "</h2>\n";
    for (const ClaimReport& claim : report.claims) {
      if (claim.paper != key) continue;
      out += "<h3>" + in_html(claim.label) + ": " + std::string(name(claim.found)) + "</h3>\n<p>" +
             in_html(claim.says) + "</p>\n";
      if (!claim.note.empty()) out += "<p>" + in_html(claim.note) + "</p>\n";
      if (claim.evidence.empty()) continue;
      out += "<table><tr><th>observed</th><th>value</th><th>allowed</th><th>so it</th></tr>\n";
      for (const Evidence& line : claim.evidence)
        out +=
            "<tr><td>" +
            in_html((line.role == Role::requirement ? "" : std::string(name(line.role)) + ": ") + line.what) +
            "</td><td>" + in_html(observed_text(line)) + "</td><td>" + in_html(line.allowed) + "</td><td>" +
            std::string(name(line.standing)) + "</td></tr>\n";
      out += "</table>\n";
    }
  }
  return out + "</body></html>\n";
}

}  // namespace

bool has_full_page() { return !embedded_page().empty() && !embedded_page().front().content.empty(); }

std::string report_page(const Report& report, const std::string& command) {
  return has_full_page() ? page_with(page_data(report, command)) : plain_page(report, command);
}

std::string experiment_page(const JsonValue& document, const Experiment& experiment,
                            std::span<const Result> results) {
  if (!has_full_page())
    return plain_head("An experiment") +
           "<p>The figures are in experiment.json, errors.csv and the plots beside this "
           "file.</p></body></html>\n";
  JsonValue data = JsonValue::object();
  data.set("experiment", document);
  data.set("plots", json_of(plots_of(experiment, results)));
  return page_with(data);
}

}  // namespace radcert::verification
