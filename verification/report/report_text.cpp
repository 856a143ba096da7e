// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/report/report_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/core/text.h"
#include "radcert/core/version.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/result/result_json.h"
#include "radcert/scalar/enclosing_text.h"
#include "verification/report/report_page.h"

namespace radcert::verification {
namespace {

using Row = std::array<std::string, 6>;

// Characters, not bytes: two columns hold a sign beyond ASCII.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string seconds_text(double seconds) { return nearest_text(seconds, DecimalForm::fixed(1)); }

bool is_finite(const Approximation& m) { return std::isfinite(m.value) && std::isfinite(m.radius); }

std::string ours_text(const std::optional<Approximation>& ours) {
  if (!ours || !is_finite(*ours)) return "";
  if (ours->radius == 0)
    if (const EnclosingText text = enclosing_text(ours->value, 0, DecimalForm::general(6));
        text.radius == "0")
      return text.value;
  const EnclosingText text = enclosing_text(ours->value, ours->radius, DecimalForm::scientific(6));
  return text.value + " ± " + text.radius;
}

/// "certified, at 5 instances". A cell of a table is one number.
std::string verdict_text(const ClaimReport& claim) {
  std::string out(name(claim.found));
  if (!claim.printed && claim.account.scope && claim.found != Verdict::failed)
    out += ", " + reach_text(*claim.account.scope, claim.account.tried.size());
  return out;
}

/// "12 certified (3 for all, 4 for a family, 5 at instances), 2 undecided".
std::string counts_text(const Report& report) {
  std::map<Verdict, std::size_t> counts;
  std::map<std::pair<Verdict, Scope>, std::size_t> reaching;
  for (const ClaimReport& claim : report.claims) {
    ++counts[claim.found];
    if (!claim.printed && claim.account.scope) ++reaching[{claim.found, *claim.account.scope}];
  }
  std::string out;
  for (const auto& [verdict, count] : counts) {
    std::string reach;
    const auto add = [&](Scope scope, const std::string& words) {
      const auto found = reaching.find({verdict, scope});
      if (found != reaching.end())
        reach += (reach.empty() ? "" : ", ") + std::to_string(found->second) + " " + words;
    };
    add(Scope::all, "for all");
    add(Scope::family, "for a family");
    add(Scope::instances, "at instances");
    out += (out.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(name(verdict));
    if (!reach.empty()) out += " (" + reach + ")";
  }
  return out;
}

std::string evidence_text(const Evidence& evidence) {
  std::string out = evidence.role == Role::requirement ? "" : std::string(name(evidence.role)) + ": ";
  if (evidence.what.starts_with(out)) out.clear();
  out += evidence.what + ": " + observed_text(evidence);
  return out + "; allowed " + evidence.allowed + "; " + std::string(name(evidence.standing));
}

std::string in_markdown_cell(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

/// Nothing that settles nothing.
JsonValue figure_json(const std::optional<Approximation>& figure) {
  return figure && is_finite(*figure) ? approximation_json(figure) : JsonValue();
}

JsonValue evidence_json(const Evidence& evidence) {
  return JsonValue::object({{"what", evidence.what},
                            {"value", evidence.value},
                            {"radius", evidence.radius},
                            {"allowed", evidence.allowed},
                            {"standing", name(evidence.standing)},
                            {"role", name(evidence.role)},
                            {"control", evidence.role == Role::control},
                            {"proved", evidence.proved}});
}

JsonValue order_json(const OrderFit& fit) {
  return JsonValue::object({{"quantity", fit.quantity},
                            {"order", fit.order},
                            {"halfwidth", fit.halfwidth},
                            {"levels", json_array(fit.levels)}});
}

JsonValue problem_trace_json(const ProblemTrace& problem) {
  return JsonValue::object({{"name", problem.name},
                            {"problem", problem.text},
                            {"levels", json_array(problem.levels, radcert::level_json)},
                            {"orders", json_array(problem.orders, order_json)}});
}

JsonValue claim_json(const ClaimReport& claim) {
  return JsonValue::object(
      {{"paper", claim.paper},
       {"label", claim.label},
       {"says", claim.says},
       {"covers", json_array(claim.covers)},
       {"page", claim.page},
       {"needs", json_array(claim.needs)},
       {"verdict", name(claim.found)},
       {"recorded", name(claim.recorded)},
       {"as_recorded", claim.as_recorded()},
       {"printed", claim.printed},
       {"ours", figure_json(claim.ours)},
       {"note", claim.note},
       {"failure", claim.failure},
       {"evidence", json_array(claim.evidence, evidence_json)},
       {"remarks", json_array(claim.remarks)},
       {"formula", claim.account.formula},
       {"met", json_array(claim.account.met)},
       {"scope", claim.account.scope ? JsonValue(name(*claim.account.scope)) : JsonValue()},
       {"tried", json_array(claim.account.tried)},
       {"unchecked", claim.account.unchecked},
       {"erratum", claim.account.erratum},
       {"problems", json_array(claim.problems)}});
}

double total_seconds(const Report& report) {
  double total = 0;
  for (const ClaimReport& claim : report.claims) total += claim.seconds;
  return total;
}

constexpr std::string_view between_columns = "  ";

// The cells of a row that are not empty columns, the last two to the right.
std::string cells_text(const Row& row, const std::array<std::size_t, 6>& widths,
                       std::span<const std::size_t> columns) {
  std::string line;
  for (const std::size_t i : columns) {
    const std::string padding(widths[i] - width(row[i]), ' ');
    const bool to_the_right = i >= 4;
    line += (line.empty() ? "" : std::string(between_columns)) +
            (to_the_right ? padding + row[i] : row[i] + padding);
  }
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

// The statement with the reach of its verdict, which leaves the column of verdicts.
Row with_reach_beside_statement(Row row) {
  if (const std::size_t comma = row[1].find(", "); comma != std::string::npos) {
    row[0] += ", " + row[1].substr(comma + 2);
    row[1].resize(comma);
  }
  return row;
}

// A line a row; where that is too wide the statement on a line of its own, and what is known of it below, but
// for the recorded verdict, which is told apart where it is another.
std::string rows_text(std::vector<Row> rows, std::size_t most_columns) {
  std::array<std::size_t, 6> widths{};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  std::size_t needed = between_columns.size() * (widths.size() - 1);
  for (const std::size_t each : widths) needed += each;
  if (needed > most_columns) {
    for (Row& row : rows) row = with_reach_beside_statement(std::move(row));
    widths[1] = 0;
    for (const Row& row : rows) widths[1] = std::max(widths[1], width(row[1]));
  }
  constexpr std::array<std::size_t, 6> all{0, 1, 2, 3, 4, 5};
  constexpr std::array<std::size_t, 4> below{1, 3, 4, 5};
  std::string out;
  for (const Row& row : rows)
    if (needed <= most_columns)
      out += cells_text(row, widths, all) + "\n";
    else
      out += row[0] + "\n    " + cells_text(row, widths, below) + "\n";
  return out;
}

}  // namespace

std::string observed_text(const Evidence& evidence) {
  const bool alone = !evidence.radius || *evidence.radius == "0";
  return alone ? evidence.value : evidence.value + " ± " + *evidence.radius;
}

std::string report_table(const Report& report, std::size_t most_columns) {
  std::vector<Row> rows{{"  statement", "verdict", "recorded", "ours", "printed", "seconds"}};
  for (const ClaimReport& claim : report.claims)
    rows.push_back({(claim.as_recorded() ? "  " : "! ") + claim.paper + "/" + claim.label,
                    verdict_text(claim), std::string(name(claim.recorded)), ours_text(claim.ours),
                    claim.printed.value_or(""), seconds_text(claim.seconds)});
  std::string out = rows_text(std::move(rows), most_columns);
  for (const ClaimReport& claim : report.claims) {
    if (claim.as_recorded()) continue;
    out += "\n! " + claim.paper + "/" + claim.label + ": " + std::string(name(claim.found)) +
           ", recorded is " + std::string(name(claim.recorded)) + "\n";
    if (claim.failure) out += "    " + *claim.failure + "\n";
    for (const Evidence& evidence : claim.evidence) out += "    " + evidence_text(evidence) + "\n";
  }
  out += "\n" + std::to_string(report.claims.size()) + " statements: " + counts_text(report) + ". ";
  out += report.as_recorded() ? "Every verdict is as recorded.\n"
                              : std::to_string(report.differing()) + " differ from the record.\n";
  return out;
}

std::string report_markdown(const Report& report, const std::string& command) {
  std::string out = "# Verification\n\nradcert " + std::string(version()) + ", `" + command + "`, budget " +
                    std::string(name(report.budget)) +
                    ". What was tried to break it: version " RADCERT_ROBUSTNESS_VERSION
                    " of tests/robust/README.md.\n\n";
  out += std::to_string(report.claims.size()) + " statements: " + counts_text(report) + ". ";
  out += report.as_recorded() ? "Every verdict is as recorded.\n"
                              : std::to_string(report.differing()) + " differ from the record.\n";
  std::string paper;
  for (const ClaimReport& claim : report.claims) {
    if (claim.paper == paper) continue;
    paper = claim.paper;
    out +=
        "\n## " + paper + "\n\n| statement | verdict | recorded | ours | printed |\n|---|---|---|---|---|\n";
    for (const ClaimReport& each : report.claims) {
      if (each.paper != paper) continue;
      out += "| " + each.label + " | " + (each.as_recorded() ? "" : "**") + verdict_text(each) +
             (each.as_recorded() ? "" : "**") + " | " + std::string(name(each.recorded)) + " | " +
             ours_text(each.ours) + " | " + each.printed.value_or("") + " |\n";
    }
    for (const ClaimReport& each : report.claims) {
      // A cell that agrees has said everything in its line of the table.
      const bool speaks = !each.printed || !each.note.empty() || each.failure || !each.as_recorded();
      if (each.paper != paper || !speaks) continue;
      out += "\n### " + each.label + "\n\n" + each.says + "\n\n";
      if (!each.note.empty()) out += each.note + "\n\n";
      if (!each.printed && !each.account.tried.empty())
        out += "Tried: " + listed(each.account.tried) + ".\n\n";
      if (each.failure) out += "Failed: " + *each.failure + "\n\n";
      for (const Evidence& evidence : each.evidence)
        out += "* " + in_markdown_cell(evidence_text(evidence)) + "\n";
      for (const std::string& remark : each.remarks) out += "* " + remark + "\n";
    }
  }
  return out;
}

JsonValue report_json(const Report& report, const std::string& command) {
  JsonValue out = document_head("verification", command);
  out.set("budget", name(report.budget));
  out.set("as_recorded", report.as_recorded());
  out.set("claims", json_array(report.claims, claim_json));
  out.set("problems", json_array(report.problems, problem_trace_json));
  out.set("timing", JsonValue::object({{"total_seconds", total_seconds(report)},
                                       {"claims", json_array(report.claims, [](const ClaimReport& claim) {
                                          return JsonValue::object({{"paper", claim.paper},
                                                                    {"label", claim.label},
                                                                    {"seconds", claim.seconds}});
                                        })}}));
  return out;
}

std::string report_json_text(const Report& report, const std::string& command) {
  std::string text = report_json(report, command).pretty();
  if (!text.ends_with('\n')) text += '\n';
  return text;
}

std::vector<std::pair<std::filesystem::path, std::string>> report_files(const Report& report,
                                                                        const std::filesystem::path& folder,
                                                                        const std::string& command) {
  return {{folder / "report.json", report_json_text(report, command)},
          {folder / "report.md", report_markdown(report, command)},
          {folder / "report.html", report_page(report, command)}};
}

}  // namespace radcert::verification
