// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/latex_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/table/order_text.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {

namespace {

constexpr int error_digits = 4;
constexpr std::string_view absent = "{--}";
constexpr std::string_view in_parentheses = "in parentheses their radius, in units of the last digit";

// Columns of siunitx: room for a mantissa of error_digits digits, its uncertainty and a negative power of two
// digits.
LatexColumn error_column(std::string head) { return {std::move(head), "S[table-format=1.3(2)e-2]"}; }
LatexColumn count_column(std::string head) { return {std::move(head), "r"}; }
LatexColumn ratio_column(std::string head) { return {std::move(head), "r"}; }

std::string fixed(double value, int decimals) { return nearest_text(value, DecimalForm::fixed(decimals)); }

std::string cell(const std::optional<Approximation>& figure) {
  if (!figure || !std::isfinite(figure->value)) return std::string(absent);
  return latex_number(figure->value, figure->has_radius() ? std::optional(figure->radius) : std::nullopt,
                      error_digits);
}

std::string ratio_cell(const std::optional<double>& ratio) {
  return ratio && std::isfinite(*ratio) ? fixed(*ratio, 2) : "--";
}

std::string order_text(const OrderFit& fit) {
  return "$" + fitted_order_text(fit, " \\pm ").value_or("") + "$";
}

std::string symbol(const std::string& quantity) {
  return quantity == "node_error" ? "$|u-u_n|$" : "$|K(I-P_n)u|$";
}

std::string errors_latex(const Result& result) {
  LatexTable table({count_column("Level"),
                    count_column("Elements"),
                    count_column("Unknowns"),
                    {"$h$", "r"},
                    error_column("{" + symbol("discretisation_error") + "}"),
                    ratio_column("Ratio"),
                    error_column("{" + symbol("node_error") + "}"),
                    ratio_column("Ratio")});
  for (const LevelResult& level : result.levels)
    table.add(std::array{std::to_string(level.level), std::to_string(level.elements),
                         std::to_string(level.unknowns), fixed(level.mesh_size, 4),
                         cell(level.discretisation_error), ratio_cell(level.discretisation_ratio),
                         cell(level.node_error), ratio_cell(level.node_ratio)});
  table.add_rule();
  table.add_line("Errors are maxima over the nodes; " + std::string(in_parentheses) + ".");
  for (const OrderFit& fit : result.orders) {
    if (!fitted_order_text(fit, "")) continue;
    table.add_line("Fitted order of " + symbol(fit.quantity) + " in $h$: " + order_text(fit));
  }
  return table.text();
}

std::string means_latex(const Result& result) {
  std::vector<LatexColumn> columns = {
      count_column("Level"), count_column("Elements"), count_column("Unknowns"), {"$h$", "r"}};
  if (!result.levels.empty())
    for (const auto& [piece, mean] : result.levels.front().piece_means)
      columns.push_back({"{" + latex_escaped(piece) + "}", "S[table-format=1.7e-2]"});
  LatexTable table(std::move(columns));
  for (const LevelResult& level : result.levels) {
    std::vector<std::string> row = {std::to_string(level.level), std::to_string(level.elements),
                                    std::to_string(level.unknowns), fixed(level.mesh_size, 4)};
    for (const auto& [piece, mean] : level.piece_means)
      row.push_back(latex_number(mean.value, std::nullopt, 2 * error_digits));
    table.add(row);
  }
  table.add_rule();
  table.add_line("Means of $u_n$ over the pieces.");
  return table.text();
}

}  // namespace

std::string latex_escaped(std::string_view text) {
  std::string out;
  for (const char c : as_utf8(text)) switch (c) {
      case '#':
      case '$':
      case '%':
      case '&':
      case '{':
      case '}':
        out += '\\';
        out += c;
        break;
      case '_': out += "\\_\\allowbreak{}"; break;
      case '/': out += "/\\allowbreak{}"; break;
      case '\\': out += "\\textbackslash{}"; break;
      case '~': out += "\\textasciitilde{}"; break;
      case '^': out += "\\textasciicircum{}"; break;
      case '<': out += "\\textless{}"; break;
      case '>': out += "\\textgreater{}"; break;
      case '|': out += "\\textbar{}"; break;
      case '"': out += "\\textquotedbl{}"; break;
      default: out += c;
    }
  return out;
}

std::string latex_number(double value, std::optional<double> radius, int digits) {
  expects(std::isfinite(value), "a finite value", named("value", value));
  if (radius && std::isfinite(*radius)) return parenthesised_text(value, *radius, digits);
  const std::string text = nearest_text(value, DecimalForm::scientific(digits));
  if (value == 0) return "0";
  const std::size_t e = text.find('e');
  std::string power = text.substr(e + 1);
  const bool negative = power.front() == '-';
  power.erase(0, power.find_first_not_of("+-0"));
  if (power.empty()) return text.substr(0, e);
  return text.substr(0, e) + "e" + (negative ? "-" : "") + power;
}

LatexTable::LatexTable(std::vector<LatexColumn> columns, bool over_pages)
    : columns_(std::move(columns)), over_pages_(over_pages) {
  expects(!columns_.empty(), "a column", named("columns", columns_.size()));
}

void LatexTable::add(std::span<const std::string> cells) {
  expects(cells.size() == columns_.size(), "as many cells as columns", named("cells", cells.size()),
          named("columns", columns_.size()));
  for (std::size_t i = 0; i < cells.size(); ++i) rows_ += (i == 0 ? "  " : " & ") + cells[i];
  rows_ += " \\\\\n";
}

void LatexTable::add_line(const std::string& latex) {
  rows_ += "  \\multicolumn{" + std::to_string(columns_.size()) + "}{@{}l}{" + latex + "} \\\\\n";
}

void LatexTable::add_rule() { rows_ += "  \\midrule\n"; }

std::string LatexTable::text() const {
  std::string formats;
  std::string heads = "  ";
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    formats += columns_[i].format;
    heads += (i == 0 ? "" : " & ") + columns_[i].head;
  }
  heads = "  \\toprule\n" + heads + " \\\\\n  \\midrule\n";
  const std::string name = over_pages_ ? "longtable" : "tabular";
  return "% Needs \\usepackage{array,booktabs,siunitx" + std::string(over_pages_ ? ",longtable" : "") +
         "}.\n{\\small\\setlength{\\tabcolsep}{4pt}%\n\\begin{" + name + "}{@{}" + formats + "@{}}\n" +
         heads +
         (over_pages_ ? "  \\endhead\n  \\bottomrule\n  \\endfoot\n" + rows_ : rows_ + "  \\bottomrule\n") +
         "\\end{" + name + "}}\n";
}

std::string levels_latex(const Result& result) {
  return result.problem.solution ? errors_latex(result) : means_latex(result);
}

std::string combinations_latex(const Experiment& experiment, std::span<const Result> results) {
  expects(results.size() == experiment.combinations.size(), "a result for each combination",
          named("results", results.size()));
  LatexTable table({{"Combination", ">{\\raggedright}p{0.22\\linewidth}"},
                    count_column("Unknowns"),
                    error_column("{" + symbol("discretisation_error") + "}"),
                    error_column("{" + symbol("node_error") + "}"),
                    {"Order", "l"}});
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].levels.empty()) continue;
    const LevelResult& level = results[i].levels.back();
    std::string order = "--";
    for (const OrderFit& fit : results[i].orders)
      if (fit.quantity == "node_error" && fitted_order_text(fit, "")) order = order_text(fit);
    table.add(std::array{latex_escaped(experiment.combinations[i].name), std::to_string(level.unknowns),
                         cell(level.discretisation_error), cell(level.node_error), order});
  }
  table.add_rule();
  table.add_line("Maxima over the nodes at the finest level; " + std::string(in_parentheses) + ".");
  table.add_line("The order is that of " + symbol("node_error") + " in $h$.");
  return table.text();
}

}  // namespace radcert
