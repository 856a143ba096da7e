// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoreboard/page.h"

#include <algorithm>
#include <string_view>

#include "radcert/core/version.h"
#include "radcert/formats/plot/scoreboard_plots.h"
#include "radcert/formats/plot/svg_plot.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::app {

namespace {

constexpr std::size_t unknowns = 0;
constexpr std::size_t bytes = 1;
constexpr std::size_t seconds = 2;

std::string in_html(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  return out;
}

std::string cell(const std::string& text, bool marked = false) {
  return marked ? "<td class=\"best\">" + text + "</td>" : "<td>" + text + "</td>";
}

std::string head(const std::vector<std::string>& names) {
  std::string out = "<tr>";
  for (const std::string& name : names) out += "<th scope=\"col\">" + name + "</th>";
  return out + "</tr>\n";
}

std::string error_cell(const BoardPoint& point, std::size_t error, std::size_t cost,
                       const std::string& mark) {
  const std::optional<double>& value = point.errors[error];
  if (!value) return cell("–");
  const bool on_frontier = point.on_frontier[error][cost];
  return cell(nearest_text(*value, DecimalForm::scientific(3)) + (on_frontier ? mark : ""), on_frontier);
}

/// The levels of all methods; of a method that does not serve the problem the reason.
std::string level_table(const BoardProblem& problem) {
  std::string out = "<table>\n" + head({"method", "level", "unknowns", "MB", "maximum", "mean square",
                                        "means", "on the frontier of memory"});
  for (const BoardCell& of_method : problem.cells) {
    if (of_method.points.empty())
      out += "<tr><th scope=\"row\">" + in_html(of_method.method) +
             "</th><td colspan=\"7\" class=\"why\">not served: " + in_html(of_method.refusal) +
             "</td></tr>\n";
    for (std::size_t k = 0; k < of_method.points.size(); ++k) {
      const BoardPoint& point = of_method.points[k];
      constexpr double million = 1e6;
      out += "<tr><th scope=\"row\">" + (k == 0 ? in_html(of_method.method) : "") + "</th>" +
             cell(std::to_string(point.level)) + cell(std::to_string(point.unknowns)) +
             cell(nearest_text(static_cast<double>(point.bytes) / million, DecimalForm::general(3)));
      std::string in_memory;
      for (std::size_t error = 0; error < board_errors.size(); ++error) {
        out += error_cell(point, error, unknowns, " ★");
        constexpr std::array<const char*, 3> words = {"maximum", "mean square", "means"};
        if (point.on_frontier[error][bytes])
          in_memory += (in_memory.empty() ? "" : ", ") + std::string(words[error]);
      }
      out += cell(in_memory) + "</tr>\n";
    }
  }
  return out + "</table>\n";
}

std::string seconds_table(const BoardProblem& problem) {
  std::string out = "<table>\n" + head({"method", "level", "seconds", "maximum", "mean square", "means"});
  for (const BoardCell& of_method : problem.cells)
    for (std::size_t k = 0; k < of_method.points.size(); ++k) {
      const BoardPoint& point = of_method.points[k];
      out += "<tr><th scope=\"row\">" + (k == 0 ? in_html(of_method.method) : "") + "</th>" +
             cell(std::to_string(point.level)) + cell(nearest_text(point.seconds, DecimalForm::general(3)));
      for (std::size_t error = 0; error < board_errors.size(); ++error)
        out += error_cell(point, error, seconds, " ★");
      out += "</tr>\n";
    }
  return out + "</table>\n";
}

constexpr std::string_view style =
    "body{font:16px/1.5 sans-serif;max-width:72rem;margin:1rem auto;padding:0 1rem}"
    "table{border-collapse:collapse;font-variant-numeric:tabular-nums}"
    "td,th{text-align:right;padding:.1rem .7rem;white-space:nowrap;font-weight:normal}"
    "th[scope=col]{font-weight:bold;border-bottom:1px solid}th[scope=row]{text-align:left}"
    "td.best{font-weight:bold}td.why{text-align:left;white-space:normal;font-style:italic}"
    "svg{max-width:100%;height:auto}";

}  // namespace

std::string scoreboard_page(const std::vector<BoardProblem>& problems, const std::string& command) {
  std::string out =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
      "<meta name=\"color-scheme\" content=\"light dark\"><title>Scoreboard</title>\n<style>" +
      std::string(style) + "</style></head><body>\n<h1>Scoreboard</h1>\n<p>radcert " + in_html(version()) +
      ", <code>" + in_html(command) +
      "</code>.</p>\n<p>All methods on all problems, level by level. ★ stands on the frontier: no method has "
      "at "
      "any level a smaller error of that kind with no more unknowns. Maximum: over a sample of the surface, "
      "of "
      "iterated solutions over their check points; mean square: the root of the integral of the squared "
      "error; "
      "means: the largest error of the mean over a piece. Memory is as planned. The seconds, which no two "
      "runs "
      "share, are at the end.</p>\n";
  for (const BoardProblem& problem : problems) {
    out += "<h2>" + in_html(problem.name) + "</h2>\n<p>" + in_html(problem.words) +
           ". Known: " + in_html(problem.truth);
    if (problem.truth_radius) out += ", within " + upper_text(*problem.truth_radius);
    out += ".</p>\n";
    const std::size_t error =
        std::any_of(problem.cells.begin(), problem.cells.end(),
                    [](const BoardCell& of_method) {
                      return std::any_of(of_method.points.begin(), of_method.points.end(),
                                         [](const BoardPoint& p) { return p.errors[0].has_value(); });
                    })
            ? 0
            : 2;
    if (const Plot plot = scoreboard_plot(problem, error, unknowns); !plot.curves.empty()) {
      const std::string svg = svg_text(plot);
      out += "<figure>" + svg.substr(std::min(svg.find("<svg"), svg.size())) + "</figure>\n";
    }
    out += level_table(problem);
  }
  out +=
      "<h2>Seconds</h2>\n<p>Of assembly and solution on this machine, of iterated solutions with K u_n at "
      "their points. ★: no method has at any level a smaller error in no more seconds.</p>\n";
  for (const BoardProblem& problem : problems)
    out += "<h3>" + in_html(problem.name) + "</h3>\n" + seconds_table(problem);
  return out + "</body></html>\n";
}

}  // namespace radcert::app
