// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/latex_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <variant>

#include "radcert/core/contract.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/table/order_text.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/errors/error_order.h"

namespace radcert {

namespace {

constexpr int error_digits = 4;
constexpr std::string_view absent = "{--}";
constexpr std::string_view in_parentheses = "in parentheses their radius, in units of the last digit";

// Columns of siunitx: room for a mantissa of error_digits digits, its uncertainty and a negative power of two
// digits.
LatexColumn error_column(std::string head) { return {std::move(head), "S[table-format=1.3(2)e-2]"}; }
LatexColumn count_column(std::string head) { return {std::move(head), "r"}; }
LatexColumn order_column() { return {"EOC", "r"}; }

std::string fixed(double value, int decimals) { return nearest_text(value, DecimalForm::fixed(decimals)); }

std::string cell(const std::optional<Approximation>& figure) {
  if (!figure || !std::isfinite(figure->value)) return std::string(absent);
  return latex_number(figure->value, figure->has_radius() ? std::optional(figure->radius) : std::nullopt,
                      error_digits);
}

std::string order_cell(const std::optional<double>& order) {
  return order && std::isfinite(*order) ? "$" + fixed(*order, 2) + "$" : "--";
}

std::string order_text(const OrderFit& fit) {
  return "$" + fitted_order_text(fit, " \\pm ").value_or("") + "$";
}

/// Of every quantity of which an order is fitted.
std::string symbol(const std::string& quantity) {
  static const std::map<std::string, std::string> symbols = {
      {"discretisation_error", "$|K(I-P_n)u|$"},
      {"node_error", "$|u-u_n|$"},
      {"l2_error", "$\\|u-u_n\\|_{L^2}$"},
      {"mean_error", "means of $u-u_n$"},
      {"iterated_error", "$|u-E-Ku_n|$ over check points"},
      {"u_n_error", "$|u-u_n|$ over check points"}};
  const auto found = symbols.find(quantity);
  expects(found != symbols.end(), "an error with a symbol", named("quantity", quantity));
  return found->second;
}

bool is_galerkin(const Result& result) { return std::holds_alternative<Galerkin>(result.problem.method); }

/// The errors of a table: at the nodes those of collocation, in means those that Galerkin's method is made
/// for, which has no discretisation error.
std::vector<ErrorKind> shown_errors(std::span<const Result> results) {
  const auto is_shown = [&](const ErrorKind& kind) {
    if (kind.name == "node_error") return true;
    if (kind.name == "discretisation_error")
      return results.empty() || !std::all_of(results.begin(), results.end(), is_galerkin);
    if (kind.name == "l2_error" || kind.name == "mean_error")
      return std::any_of(results.begin(), results.end(), is_galerkin);
    return false;
  };
  std::vector<ErrorKind> shown;
  std::copy_if(error_kinds().begin(), error_kinds().end(), std::back_inserter(shown), is_shown);
  return shown;
}

/// Level, unknowns, h, and of each error the value and its observed order.
std::vector<LatexColumn> level_heads(std::span<const ErrorKind> errors) {
  std::vector<LatexColumn> heads = {count_column("Level"), count_column("Unknowns"), {"$h$", "r"}};
  for (const ErrorKind& error : errors) {
    heads.push_back(error_column("{" + symbol(error.name) + "}"));
    heads.push_back(order_column());
  }
  return heads;
}

std::optional<double> order_at(const Result& result, std::size_t k, const ErrorKind& error) {
  const LevelResult& now = result.levels[k];
  if (error.name == "discretisation_error") return now.discretisation_order;
  if (error.name == "node_error") return now.node_order;
  if (k == 0) return std::nullopt;
  const LevelResult& before = result.levels[k - 1];
  return error_order(before.*error.figure, before.mesh_size, now.*error.figure, now.mesh_size);
}

void add_levels(LatexTable& table, const Result& result, std::span<const ErrorKind> errors) {
  for (std::size_t k = 0; k < result.levels.size(); ++k) {
    const LevelResult& level = result.levels[k];
    std::vector<std::string> row = {std::to_string(level.level), std::to_string(level.unknowns),
                                    fixed(level.mesh_size, 4)};
    for (const ErrorKind& error : errors) {
      row.push_back(cell(level.*error.figure));
      row.push_back(order_cell(order_at(result, k, error)));
    }
    table.add(row);
  }
}

/// "2--5", "0, 2, 3".
std::string level_list(const std::vector<int>& levels) {
  const bool in_a_row =
      levels.size() > 2 && levels.back() - levels.front() + 1 == static_cast<int>(levels.size());
  if (in_a_row) return std::to_string(levels.front()) + "--" + std::to_string(levels.back());
  std::string out;
  for (const int level : levels) out += (out.empty() ? "" : ", ") + std::to_string(level);
  return out;
}

/// "$|u-u_n|$: $3.99 \pm 0.12$ on levels 2--5", or why there is none.
std::string fit_text(const OrderFit& fit) {
  if (fitted_order_text(fit, ""))
    return symbol(fit.quantity) + ": " + order_text(fit) + " on levels " + level_list(fit.levels);
  return symbol(fit.quantity) + ": none, the slopes are not steady";
}

bool has_fit(const OrderFit& fit) { return fit.order || fit.pre_asymptotic.size() > 1; }

void add_about_errors(LatexTable& table, std::span<const ErrorKind> errors) {
  const std::string maxima = "Errors are maxima over the nodes";
  const std::string order = "EOC is the observed order in $h$;";
  if (errors.back().name == "mean_error") {
    table.add_line(maxima + ", norms in $L^2(S)$ and the largest of the means over pieces;");
    table.add_line(order);
  } else {
    table.add_line(maxima + "; " + order);
  }
  table.add_line(std::string(in_parentheses) + ".");
}

std::string errors_latex(const Result& result) {
  const std::vector<ErrorKind> errors = shown_errors({&result, 1});
  LatexTable table(level_heads(errors));
  add_levels(table, result, errors);
  table.add_rule();
  add_about_errors(table, errors);
  for (const OrderFit& fit : result.orders)
    if (has_fit(fit)) table.add_line("Fitted order of " + fit_text(fit));
  return table.text();
}

/// The errors of the iterated solution, beside those of u_n at the same points.
std::string iterated_latex(const Result& result) {
  LatexTable table({count_column("Level"),
                    count_column("Unknowns"),
                    {"$h$", "r"},
                    count_column("Points"),
                    error_column("{$|u-E-Ku_n|$}"),
                    order_column(),
                    error_column("{$|u-u_n|$}"),
                    order_column()});
  for (const LevelResult& level : result.levels)
    if (level.iterated)
      table.add(std::array{std::to_string(level.level), std::to_string(level.unknowns),
                           fixed(level.mesh_size, 4), std::to_string(level.iterated->check_points),
                           cell(level.iterated_error), order_cell(level.iterated->order),
                           cell(level.iterated->u_n_error), order_cell(level.iterated->u_n_order)});
  table.add_rule();
  table.add_line("Errors are maxima over check points inside the elements;");
  table.add_line(std::string(in_parentheses) + ".");
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

void LatexTable::add_paragraph(const std::string& latex) {
  rows_ += "  \\multicolumn{" + std::to_string(columns_.size()) +
           "}{@{}p{0.9\\linewidth}@{}}{\\raggedright " + latex + "} \\\\\n";
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
         "}.\n" + std::string(over_pages_ ? "" : "\\par\\noindent\n") +
         "{\\small\\setlength{\\tabcolsep}{4pt}%\n\\begin{" + name + "}{@{}" + formats + "@{}}\n" + heads +
         (over_pages_ ? "  \\endhead\n  \\bottomrule\n  \\endfoot\n" + rows_ : rows_ + "  \\bottomrule\n") +
         "\\end{" + name + "}}\n";
}

std::string levels_latex(const Result& result) {
  if (!result.problem.solution) return means_latex(result);
  return errors_latex(result) + (result.problem.iterated ? iterated_latex(result) : "");
}

std::string combinations_latex(const Experiment& experiment, std::span<const Result> results) {
  expects(results.size() == experiment.combinations.size(), "a result for each combination",
          named("results", results.size()));
  constexpr std::size_t most_rows_of_a_page = 36;
  std::size_t rows = 0;
  for (const Result& result : results) rows += result.levels.size() + 2;
  const std::vector<ErrorKind> errors = shown_errors(results);
  LatexTable table(level_heads(errors), rows > most_rows_of_a_page);
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (results[i].levels.empty()) continue;
    if (i > 0) table.add_rule();
    table.add_paragraph("\\textit{" + latex_escaped(experiment.combinations[i].name) + "}");
    add_levels(table, results[i], errors);
    std::string orders;
    for (const OrderFit& fit : results[i].orders)
      if (has_fit(fit)) orders += (orders.empty() ? "Fitted order of " : "; of ") + fit_text(fit);
    if (!orders.empty()) table.add_paragraph(orders);
  }
  table.add_rule();
  add_about_errors(table, errors);
  return table.text();
}

}  // namespace radcert
