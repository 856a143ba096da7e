// SPDX-License-Identifier: GPL-3.0-or-later

// What is printed against the numbers it was made from: every text with a radius, and every bound, read as
// decimals, must enclose the doubles of the JSON beside it. The judge reads JSON by another library and
// compares rational numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "radcert/factors/factor_mesh.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/result/factors_json.h"
#include "radcert/formats/result/reference_json.h"
#include "radcert/formats/result/result_json.h"
#include "radcert/formats/table/csv.h"
#include "radcert/formats/table/latex_table.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/scalar/real.h"
#include "tables/factors_table.h"
#include "tables/solve_table.h"
#include "tests/attack/attack.h"
#include "verification/report/report_text.h"

namespace radcert::attack {
namespace {

using Json = nlohmann::json;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string exact_text(double x) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%a", x);
  return buffer.data();
}

/// Powers of ten and their neighbours, 9.99..., halves of a last digit, denormal numbers, any bits.
double nasty(Draw& draw) {
  const auto neighbour = [&](double x) {
    for (std::size_t steps = draw.below(3); steps > 0; --steps)
      x = std::nextafter(x, draw.below(2) == 0 ? infinity : 0.0);
    return x;
  };
  const double ten = std::pow(10.0, static_cast<double>(draw.below(617)) - 308);
  const double near_one = std::pow(10.0, -static_cast<double>(draw.below(18)));
  double x = 0;
  switch (draw.below(6)) {
    case 0: {
      const std::uint64_t bits = draw.bits();
      std::memcpy(&x, &bits, sizeof x);
      break;
    }
    case 1: x = neighbour(ten); break;
    case 2: x = neighbour(ten * static_cast<double>(1 + draw.below(9999)) / 16); break;
    case 3: x = static_cast<double>(draw.bits() >> (12 + draw.below(52))) * 5e-324; break;
    case 4: x = neighbour((1 - near_one) * ten); break;
    default: x = draw.number();
  }
  return std::isfinite(x) ? x : 1.0;
}

double size(Draw& draw) { return std::abs(nasty(draw)); }

/// Mostly as numbers of a computation are: of moderate size, the radius far smaller.
double value_like(Draw& draw) {
  return draw.below(3) == 0 ? nasty(draw) : (draw.unit() - 0.3) * std::pow(10.0, 4 - 12 * draw.unit());
}
double radius_like(Draw& draw, double value) {
  if (draw.below(6) == 0) return 0;
  return draw.below(3) == 0 ? size(draw) : std::abs(value) * std::pow(10.0, -16 * draw.unit());
}

Rational exactly(double x) { return Rational::exactly(x); }

std::optional<Rational> read(const std::string& text) {
  const Outcome<Rational> number = Rational::parse(text);
  return number ? std::optional(*number) : std::nullopt;
}

/// Collects what does not hold.
class Faults {
public:
  void expect(bool holds, const std::string& what) {
    if (!holds && text_.empty()) text_ = what;
  }
  /// [value - radius, value + radius] in [text - around, text + around].
  void encloses(const std::string& text, const std::string& around, double value, double radius,
                const std::string& what) {
    encloses(text, around, exactly(value), exactly(radius), what);
  }
  void encloses(const std::string& text, const std::string& around, const Rational& value,
                const Rational& radius, const std::string& what) {
    const std::string said =
        what + ": '" + text + "' +- '" + around + "' for " + value.to_text() + " +- " + radius.to_text();
    const auto t = read(text);
    const auto s = read(around);
    expect(t && s && abs(value - *t) + radius <= *s, said);
  }
  void is_above(const std::string& text, const Rational& bound, const std::string& what) {
    const auto t = read(text);
    expect(t && bound <= *t, what + ": '" + text + "' is no bound of " + bound.to_text());
  }
  [[nodiscard]] Judgement judgement() const {
    return text_.empty() ? Judgement::held() : Judgement::violated(text_);
  }

private:
  std::string text_;
};

/// The cells of a line of a table: two blanks or more part them.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out;
  for (std::size_t at = line.find_first_not_of(' '); at < line.size();) {
    const std::size_t end = std::min(line.find("  ", at), line.size());
    out.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(' ', end);
  }
  return out;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

/// What stands between two words of a text; empty where they are not there.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos) return {};
  const std::size_t end = text.find(after, begin + before.size());
  return text.substr(begin + before.size(), end == std::string::npos ? end : end - begin - before.size());
}

// ---- the function itself ----

struct Printed {
  double value = 0;
  double radius = 0;
  int digits = 1;
  int form = 0;
};

DecimalForm form_of(const Printed& printed) {
  switch (printed.form) {
    case 0: return DecimalForm::scientific(printed.digits);
    case 1: return DecimalForm::general(printed.digits);
    case 2: return DecimalForm::padded(printed.digits);
    default: return DecimalForm::fixed(printed.digits);
  }
}

TEST(TextAttack, NumbersWithARadius) {
  hold(Attack<Printed>{
      .name = "text: a number with its radius",
      .usual_instances = 30000,
      .make =
          [](Draw& draw) {
            const double value = nasty(draw);
            return Printed{.value = value,
                           .radius = draw.below(2) == 0 ? size(draw) : radius_like(draw, value),
                           .digits = 1 + static_cast<int>(draw.below(18)),
                           .form = static_cast<int>(draw.below(4))};
          },
      .judge =
          [](const Printed& printed) {
            Faults faults;
            const DecimalForm form = form_of(printed);
            if (std::isfinite(printed.radius)) {
              const EnclosingText text = enclosing_text(printed.value, printed.radius, form);
              faults.encloses(text.value, text.radius, printed.value, printed.radius, "enclosing_text");
            }
            faults.is_above(upper_text(printed.value, form), exactly(printed.value), "upper_text");
            faults.is_above(upper_text(printed.value), exactly(printed.value), "upper_text as a radius");
            faults.is_above(upper_text(-std::abs(printed.value), form), exactly(-std::abs(printed.value)),
                            "upper_text of a negative number");
            const auto below = read(lower_text(printed.value, form));
            faults.expect(below && *below <= exactly(printed.value), "lower_text");
            // printf rounds to nearest, correctly.
            if (printed.form == 0) {
              std::array<char, 64> buffer{};
              std::snprintf(buffer.data(), buffer.size(), "%.*e", printed.digits - 1, printed.value);
              faults.expect(read(buffer.data()) == read(nearest_text(printed.value, form)), "nearest_text");
            }
            return faults.judgement();
          },
      .text =
          [](const Printed& printed) {
            return exact_text(printed.value) + " +- " + exact_text(printed.radius) + ", form " +
                   std::to_string(printed.form) + ", " + std::to_string(printed.digits) + " digits";
          },
      .smaller =
          [](const Printed& printed) {
            std::vector<Printed> out;
            for (const double value : {1.0, 0.0, std::trunc(printed.value)})
              if (value != printed.value)
                out.push_back({value, printed.radius, printed.digits, printed.form});
            if (printed.radius != 0) out.push_back({printed.value, 0, printed.digits, printed.form});
            if (printed.digits > 1) out.push_back({printed.value, printed.radius, 1, printed.form});
            return out;
          },
  });
}

/// What siunitx reads in "1.484(21)e-3".
void judge_parenthesised(Faults& faults, const std::string& text, double value, double radius,
                         const std::string& what) {
  const std::size_t open = text.find('(');
  const std::size_t e = std::min(text.find('e'), text.size());
  const std::string power = e == text.size() ? "0" : text.substr(e + 1);
  const std::string mantissa = text.substr(0, std::min(open, e));
  const std::size_t point = mantissa.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : mantissa.size() - point - 1;
  const std::string units =
      open == std::string::npos ? "0" : text.substr(open + 1, text.find(')') - open - 1);
  faults.encloses(mantissa + "e" + power,
                  units + "e" + std::to_string(std::stol(power) - static_cast<long>(decimals)), value, radius,
                  what);
}

// ---- results of solve ----

std::optional<Approximation> some_figure(Draw& draw) {
  if (draw.below(8) == 0) return std::nullopt;
  const double value = draw.below(2) == 0 ? std::abs(value_like(draw)) : value_like(draw);
  Approximation figure{
      .value = value, .radius = std::numeric_limits<double>::infinity(), .guaranteed = false};
  if (draw.below(4) != 0)
    figure = {.value = value, .radius = radius_like(draw, value), .guaranteed = draw.below(2) == 0};
  return figure;
}

const Problem& some_problem() {
  static const Problem problem = parse_problem(R"json({"schema": "radcert/problem/1",
    "surface": {"name": "cube"}, "triangulation": {"levels": [0]}, "basis": {"family": "inset", "degree": 0},
    "reflectivity": "1/2", "solution": "1"})json",
                                               "text_attack");
  return problem;
}

Result some_result(Draw& draw) {
  Result result{.problem = some_problem(), .levels = {}, .orders = {}, .timing = {}};
  const std::size_t count = 1 + draw.below(4);
  const bool verified = draw.below(2) == 0;
  const bool iterated = !verified && draw.below(2) == 0;
  for (std::size_t i = 0; i < count; ++i) {
    LevelResult level;
    level.level = static_cast<int>(i);
    level.elements = 1 + draw.below(100000);
    level.unknowns = 1 + draw.below(100000);
    level.mesh_size = size(draw);
    level.discretisation_error = some_figure(draw);
    level.node_error = some_figure(draw);
    level.uniform_error = some_figure(draw);
    if (draw.below(2) == 0) level.discretisation_ratio = nasty(draw);
    const double norm = draw.unit();
    level.norm_K = {.value = norm, .radius = std::numeric_limits<double>::infinity(), .guaranteed = false};
    if (draw.below(2) == 0)
      level.norm_K = {.value = norm, .radius = radius_like(draw, norm), .guaranteed = true};
    level.piece_means = {{"a piece", Approximation::without_radius(value_like(draw))}};
    if (verified) {
      for (auto* figure : {&level.discretisation_error, &level.node_error})
        if (*figure) {
          (*figure)->guaranteed = true;
          if (!(*figure)->radius) (*figure)->radius = size(draw);
        }
      level.verified = VerifiedReport{.theta = draw.unit()};
      level.solution_radius = size(draw);
    }
    if (iterated)
      level.iteration = IterationReport{
          .iterations = draw.below(100),
          .contraction =
              draw.below(3) == 0 ? 1 - std::ldexp(1.0, -static_cast<int>(1 + draw.below(53))) : draw.unit(),
          .error_bound = size(draw)};
    result.levels.push_back(level);
  }
  for (const char* quantity : {"discretisation_error", "node_error"}) {
    OrderFit fit{.quantity = quantity,
                 .order = 10 * draw.unit() - 2,
                 .halfwidth = draw.unit(),
                 .levels = {0},
                 .left_out = {}};
    for (int i = 1; i < static_cast<int>(1 + draw.below(4)); ++i) fit.levels.push_back(i);
    result.orders.push_back(fit);
  }
  return result;
}

/// A column and the one that holds its radius, against a number and its radius in JSON.
void judge_pair(Faults& faults, const std::vector<std::string>& head, const std::vector<std::string>& row,
                const std::string& column, const Json& figure) {
  const auto place = static_cast<std::size_t>(std::find(head.begin(), head.end(), column) - head.begin());
  if (place >= row.size()) return faults.expect(false, "no column " + column);
  const bool has_radius = place + 1 < head.size() && head[place + 1] == "+-";
  if (figure.is_null()) return faults.expect(row[place] == "-", column + ": '" + row[place] + "' for null");
  if (figure["radius"].is_null())
    return faults.expect(!has_radius || row[place + 1] == "-", column + ": a radius where none is known");
  if (!has_radius) return faults.expect(false, column + ": no radius is shown");
  faults.encloses(row[place], row[place + 1], figure["value"], figure["radius"], column);
}

void judge_orders(Faults& faults, const std::vector<std::string>& text, const Json& orders) {
  for (const auto& [quantity, words] :
       {std::pair("node_error", "|u-u_n| at the nodes"), std::pair("discretisation_error", "|K(I-P_n)u|")}) {
    const std::string start = std::string("Order of ") + words + " in h: ";
    const auto line = std::find_if(text.begin(), text.end(),
                                   [&](const std::string& each) { return each.starts_with(start); });
    if (line == text.end()) {
      faults.expect(false, start);
      continue;
    }
    const std::string said = between(*line, start, " (levels");
    const std::size_t sign = said.find(" +- ");
    if (orders[quantity]["levels"].size() < 3)
      faults.expect(sign == std::string::npos, "two levels have no spread: " + said);
    else
      faults.encloses(said.substr(0, sign), sign == std::string::npos ? "" : said.substr(sign + 4),
                      orders[quantity]["order"], orders[quantity]["halfwidth"], start);
  }
}

TEST(TextAttack, TablesOfSolve) {
  hold(Attack<Result>{
      .name = "text: the table of solve",
      .usual_instances = 1500,
      .make = some_result,
      .judge =
          [](const Result& result) {
            Faults faults;
            const std::string text = app::solve_table(result);
            const std::vector<std::string> all = lines(text);
            const Json json = Json::parse(result_text(result, "radcert solve"));
            const std::vector<std::string> head = cells(all.front());
            Rational contraction = 0;
            Rational error_bound = 0;
            for (std::size_t i = 0; i < json["levels"].size(); ++i) {
              const Json& level = json["levels"][i];
              const std::vector<std::string> row = cells(all.at(i + 1));
              judge_pair(faults, head, row, "|K(I-P_n)u|", level["discretisation_error"]);
              judge_pair(faults, head, row, "|u-u_n| nodes", level["node_error"]);
              judge_pair(faults, head, row, "|u-u_n| sample", level["uniform_error"]);
              judge_pair(faults, head, row, "norm K", level["norm_K"]);
              const std::string norm = row.at(
                  static_cast<std::size_t>(std::find(head.begin(), head.end(), "norm K") - head.begin()));
              faults.expect(level["norm_K"]["guaranteed"] != norm.ends_with("(estimate)"), "norm K: " + norm);
              if (!level["verified"].is_null() && text.find("\nGuaranteed") != std::string::npos) {
                // "1.6e-13 (level 0), 1.7e-13 (level 1)"
                std::string before = between(text, "is known within\n", " (level " + std::to_string(i) + ")");
                before = before.substr(before.find_last_of(' ') + 1);
                faults.is_above(before, exactly(level["verified"]["solution_radius"]), "u_n is known within");
              }
              if (level["iteration"].is_null()) continue;
              contraction = std::max(contraction, exactly(level["iteration"]["contraction"]));
              error_bound = std::max(error_bound, exactly(level["iteration"]["error_bound"]));
            }
            if (!json["levels"][0]["iteration"].is_null()) {
              const std::string theta = between(text, "contraction at most ", ", error");
              faults.is_above(theta, contraction, "contraction");
              faults.expect(read(theta) && *read(theta) < Rational(1), "a contraction is below 1: " + theta);
              faults.is_above(between(text, "linear system at most ", "\n"), error_bound,
                              "error of the linear system");
            }
            judge_orders(faults, all, json["orders"]);
            // The table for LaTeX, its errors in parentheses.
            std::size_t seen = 0;
            for (const std::string& line : lines(levels_latex(result))) {
              if (line.find(" & ") == std::string::npos || !line.ends_with(" \\\\") ||
                  line.find_first_of("0123456789") != line.find_first_not_of(' '))
                continue;
              std::vector<std::string> row;
              for (std::size_t at = 0; at <= line.size();) {
                const std::size_t end = std::min(line.find(" & ", at), line.size());
                row.push_back(line.substr(at, end - at));
                at = end + 3;
              }
              const Json& level = json["levels"].at(seen++);
              for (const auto& [place, key] :
                   {std::pair(3, "discretisation_error"), std::pair(5, "node_error")}) {
                const Json& figure = level[key];
                const std::string& cell = row.at(static_cast<std::size_t>(place));
                if (figure.is_null())
                  faults.expect(cell == "{--}", "LaTeX: " + cell);
                else if (figure["radius"].is_null())
                  faults.expect(cell.find('(') == std::string::npos,
                                "LaTeX: a radius where none is known: " + cell);
                else
                  judge_parenthesised(faults, cell, figure["value"], figure["radius"], "LaTeX");
              }
            }
            faults.expect(seen == json["levels"].size(), "LaTeX: a row a level");
            return faults.judgement();
          },
      .text = [](const Result& result) { return result_text(result, ""); },
      .smaller =
          [](const Result& result) {
            std::vector<Result> out;
            for (std::size_t i = 0; i < result.levels.size() && result.levels.size() > 1; ++i) {
              out.push_back(result);
              out.back().levels.erase(out.back().levels.begin() + static_cast<std::ptrdiff_t>(i));
            }
            return out;
          },
  });
}

// ---- factors ----

FactorReport some_report(Draw& draw) {
  FactorReport report;
  report.name = "a scene";
  report.by = "triangle";
  report.open = draw.below(2) == 0;
  report.matrix.guaranteed = draw.below(2) == 0;
  const std::size_t count = 1 + draw.below(6);
  for (std::size_t i = 0; i < count; ++i) {
    report.names.push_back("t" + std::to_string(i));
    const auto number = [&](double value) { return Approximation{value, radius_like(draw, value)}; };
    FactorRow row{
        .area = number(size(draw)),
        .sum = number(draw.below(2) == 0 ? 1 + (draw.unit() - 0.5) * std::pow(10.0, -16 * draw.unit())
                                         : size(draw)),
        .to_space = std::nullopt};
    if (report.open) row.to_space = number(value_like(draw));
    report.matrix.rows.push_back(row);
    for (std::size_t j = 0; j < count; ++j) report.matrix.entries.push_back({i, j, number(draw.unit())});
  }
  report.matrix.largest_reciprocity_defect = size(draw);
  std::vector<FactorComparison> pairs;
  for (std::size_t k = 0; k < 3; ++k) {
    const double ours = draw.unit();
    const double near = draw.below(2) == 0 ? std::nextafter(ours, 2.0) : draw.unit();
    const Rational theirs = exactly(near) * Rational(1000 + static_cast<long>(draw.below(2)), 1000);
    pairs.push_back({.from = "t0",
                     .to = "t0",
                     .ours = {ours, radius_like(draw, ours)},
                     .theirs = {theirs, exactly(radius_like(draw, near))}});
  }
  report.comparison = pairs;
  return report;
}

/// The table of factors against its JSON.
void judge_factors(Faults& faults, const FactorReport& report) {
  const std::string text = app::factors_table(report);
  const std::vector<std::string> all = lines(text);
  const Json json = Json::parse(factors_report(report).pretty());
  const std::vector<std::string> head = cells(all.at(1));
  const auto pair = [](const Json& row, const char* value, const char* radius) {
    return Json{{"value", row[value]}, {"radius", row[radius]}};
  };
  Rational closure = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(json["surfaces"].size(), 20); ++i) {
    const Json& row = json["surfaces"][i];
    const std::vector<std::string> shown = cells(all.at(i + 2));
    judge_pair(faults, head, shown, "area", pair(row, "area", "area_radius"));
    judge_pair(faults, head, shown, "row sum", pair(row, "row_sum", "row_radius"));
    if (json["open"]) judge_pair(faults, head, shown, "to space", pair(row, "to_space", "to_space_radius"));
    closure = std::max(closure, abs(exactly(row["row_sum"]) - Rational(1)));
  }
  Rational largest = 0;
  for (const Json& entry : json["factors"]) largest = std::max(largest, exactly(entry["radius"]));
  faults.is_above(between(text, "largest radius of a factor: ", ", "), largest, "largest radius");
  faults.expect(largest <= exactly(json["largest_radius"]), "largest radius in JSON");
  faults.is_above(between(text, "|A_i F_ij - A_j F_ji| <= ", " sqrt"), exactly(json["reciprocity_defect"]),
                  "reciprocity");
  if (!json["open"]) {
    faults.is_above(between(text, "as given are within ", " of 1"), closure, "closure");
    faults.expect(closure <= exactly(json["closure_defect"]), "closure in JSON");
  }
  faults.expect((text.find(", guaranteed\n") != std::string::npos) == json["guaranteed"], "guaranteed");
}

TEST(TextAttack, TablesOfFactors) {
  hold(Attack<FactorReport>{
      .name = "text: the table of factors",
      .usual_instances = 1500,
      .make = some_report,
      .judge =
          [](const FactorReport& report) {
            Faults faults;
            judge_factors(faults, report);
            const std::vector<std::string> all = lines(app::comparison_table(*report.comparison));
            const std::vector<std::string> head = cells(all.at(1));
            for (std::size_t k = 0; k < report.comparison->size(); ++k) {
              const FactorComparison& pair = (*report.comparison)[k];
              const std::vector<std::string> row = cells(all.at(k + 2));
              judge_pair(faults, head, row, "ours",
                         {{"value", pair.ours.value}, {"radius", pair.ours.radius}});
              faults.encloses(row.at(4), row.at(5), pair.theirs.value, pair.theirs.halfwidth, "theirs");
              const Approximation theirs = pair.theirs.in_double();
              faults.expect(abs(exactly(theirs.value) - pair.theirs.value) + pair.theirs.halfwidth <=
                                exactly(theirs.radius),
                            "theirs in doubles");
              faults.is_above(row.at(6), abs(exactly(pair.ours.value) - pair.theirs.value), "apart");
            }
            return faults.judgement();
          },
      .text = [](const FactorReport& report) { return factors_report(report).pretty(); },
  });
}

// ---- factors of scenes ----

/// A tetrahedron with its normals inwards, of many scales, some of its corners a rounding apart from a plane.
TriangleMesh some_tetrahedron(Draw& draw) {
  const double scale = std::ldexp(1.0, static_cast<int>(draw.below(60)) - 30);
  std::array<Vector<double>, 4> at;
  for (Vector<double>& p : at) p = {scale * draw.unit(), scale * draw.unit(), scale * draw.unit()};
  const auto volume = [&] { return dot(cross(at[1] - at[0], at[2] - at[0]), at[3] - at[0]); };
  while (std::abs(volume()) < 1e-3 * scale * scale * scale)
    at[draw.below(4)] = {scale * draw.unit(), scale * draw.unit(), scale * draw.unit()};
  if (volume() < 0) std::swap(at[0], at[1]);
  TriangleMesh mesh;
  mesh.vertices.assign(at.begin(), at.end());
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}};
  mesh.group = {0, 0, 0, 0};
  mesh.group_names = {""};
  mesh.face = {0, 1, 2, 3};
  return mesh;
}

TEST(TextAttack, FactorsOfTetrahedra) {
  hold(Attack<TriangleMesh>{
      .name = "text: factors of a tetrahedron as published",
      .usual_instances = 300,
      .make = some_tetrahedron,
      .judge =
          [](const TriangleMesh& mesh) {
            Faults faults;
            const FacetScene scene(mesh);
            const FactorUnits units{.of_triangle = {0, 1, 2, 3}, .names = {"a", "b", "c", "d"}};
            FactorReport report;
            report.by = "triangle";
            report.names = units.names;
            report.matrix = factor_matrix(scene, units, {}, {});
            judge_factors(faults, report);
            faults.expect(report.matrix.entries.size() == 12, "each face sees the others");
            // The defect of the numbers that are published, by the definition.
            const Json json = Json::parse(factors_report(report).pretty());
            const auto area = [&](const std::string& name) {
              return exactly(json["surfaces"][static_cast<std::size_t>(name[0] - 'a')]["area"]);
            };
            const Rational bound = exactly(json["reciprocity_defect"]);
            for (const Json& there : json["factors"])
              for (const Json& back : json["factors"]) {
                if (there["from"] != back["to"] || there["to"] != back["from"]) continue;
                const Rational a = area(there["from"]);
                const Rational b = area(there["to"]);
                const Rational defect = abs(a * exactly(there["factor"]) - b * exactly(back["factor"]));
                faults.expect(defect * defect <= bound * bound * a * b,
                              "reciprocity of the published doubles");
              }
            return faults.judgement();
          },
      .text =
          [](const TriangleMesh& mesh) {
            std::string out;
            for (const Vector<double>& p : mesh.vertices)
              out += exact_text(p.x) + " " + exact_text(p.y) + " " + exact_text(p.z) + "\n";
            return out;
          },
  });
}

// ---- verification ----

verification::Report some_verification(Draw& draw) {
  using namespace verification;
  Report report;
  for (std::size_t i = 0; i < 1 + draw.below(4); ++i) {
    ClaimReport claim;
    claim.paper = "p";
    claim.label = "c" + std::to_string(i);
    claim.recorded = claim.found = Verdict::supported;
    const double value = value_like(draw);
    claim.ours =
        Approximation{.value = value, .radius = radius_like(draw, value), .guaranteed = draw.below(2) == 0};
    Finding finding;
    finding.require("a number", AtMost{.value = 1, .slack = 0, .why = ""}, *claim.ours);
    finding.remark("another", *claim.ours);
    claim.evidence = finding.evidence();
    claim.remarks = finding.remarks();
    report.claims.push_back(claim);
  }
  return report;
}

TEST(TextAttack, TablesOfVerify) {
  hold(Attack<verification::Report>{
      .name = "text: the table of verify",
      .usual_instances = 1500,
      .make = some_verification,
      .judge =
          [](const verification::Report& report) {
            Faults faults;
            const std::vector<std::string> all = lines(verification::report_table(report));
            const Json json = Json::parse(verification::report_json_text(report, ""));
            const auto encloses = [&](const std::string& text, const std::string& sign, const Json& ours) {
              const std::size_t place = text.find(sign);
              // An exact number stands alone.
              if (place == std::string::npos)
                return faults.encloses(text, "0", ours["value"], ours["radius"], text);
              faults.encloses(text.substr(0, place), text.substr(place + sign.size()), ours["value"],
                              ours["radius"], text);
            };
            for (std::size_t i = 0; i < json["claims"].size(); ++i) {
              const Json& claim = json["claims"][i];
              encloses(cells(all.at(i + 1)).at(3), " ± ", claim["ours"]);
              const Json& evidence = claim["evidence"][0];
              faults.encloses(evidence["value"], evidence["radius"], claim["ours"]["value"],
                              claim["ours"]["radius"], "evidence");
              encloses(claim["remarks"][0].get<std::string>().substr(std::string("another: ").size()), " +- ",
                       claim["ours"]);
            }
            return faults.judgement();
          },
      .text = [](const verification::Report& report) { return verification::report_json_text(report, ""); },
  });
}

// ---- reference values ----

struct SomeBall {
  Ball ball;
  int digits = 1;
};

TEST(TextAttack, ReferenceValues) {
  hold(Attack<SomeBall>{
      .name = "text: a reference value",
      .usual_instances = 5000,
      .make =
          [](Draw& draw) {
            Ball ball(value_like(draw));
            if (draw.below(2) == 0) ball = ball / Ball(3);
            if (draw.below(3) != 0) ball = widened(ball, Ball(radius_like(draw, ball.to_double())));
            return SomeBall{.ball = ball, .digits = 1 + static_cast<int>(draw.below(40))};
          },
      .judge =
          [](const SomeBall& some) {
            Faults faults;
            ReferenceRecord record;
            record.name = "a_value";
            record.digits = some.digits;
            record.routes = {{"a route", some.ball}};
            const Json json = Json::parse(reference_json(record, "").pretty());
            const auto binary = [](const Json& number) {
              return *read(number["mantissa"]) *
                     power(Rational(2), std::stol(number["exponent"].get<std::string>()));
            };
            const auto midpoint = read(json["midpoint"]);
            const auto radius = read(json["radius"]);
            faults.expect(
                midpoint && radius &&
                    abs(*midpoint - binary(json["midpoint_binary"])) + binary(json["radius_binary"]) <=
                        *radius,
                "decimal and binary: " + json.dump());
            return faults.judgement();
          },
      .text =
          [](const SomeBall& some) {
            return some.ball.to_text(50) + ", " + std::to_string(some.digits) + " digits";
          },
  });
}

}  // namespace
}  // namespace radcert::attack
