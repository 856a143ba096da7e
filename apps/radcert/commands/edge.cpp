// SPDX-License-Identifier: GPL-3.0-or-later

// radcert edge: the exponents of the solution at an edge, and what they ask of a mesh.
#include <algorithm>
#include <charconv>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "output.h"
#include "progress.h"
#include "radcert/closed_form/edge/edge_exponents.h"
#include "radcert/core/errors.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/result/reference_json.h"
#include "radcert/reference/edge_symbol_integral.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/scalar/rational.h"

namespace radcert::app {

namespace {

constexpr int most_digits = 100;
constexpr int most_second_digits = 25;
constexpr int most_degree = 4;

struct EdgeOptions {
  std::string angle;
  std::string rho;
  std::string rho_other;
  std::string up_to = "3";
  std::string digits = "12";
};

Rational number_in(const std::string& option, const std::string& text, const std::string& allowed,
                   const std::function<bool(const Rational&)>& allows) {
  const Outcome<Rational> value = Rational::parse(text);
  if (!value || !allows(*value)) throw InputError({.source = option, .value = text, .allowed = allowed});
  return *value;
}

/// What the options say.
struct EdgeRequest {
  Rational angle;
  Rational rho;
  Rational rho_other;
  Rational up_to;
  int digits = 0;

  [[nodiscard]] bool faces_see_each_other() const { return angle < Rational(180); }
  [[nodiscard]] bool both_reflect() const { return rho.sign() > 0 && rho_other.sign() > 0; }
};

EdgeRequest request_of(const EdgeOptions& options) {
  const auto reflectivity = [](const std::string& option, const std::string& text) {
    return number_in(option, text, "a number in [0, 1), decimal or fraction",
                     [](const Rational& x) { return x.sign() >= 0 && x < Rational(1); });
  };
  EdgeRequest request;
  const std::string angles = "a number of degrees in (0, 360), decimal or fraction";
  if (options.angle.empty())
    throw InputError({.source = "--angle", .problem = "is missing", .allowed = angles});
  request.angle = number_in("--angle", options.angle, angles,
                            [](const Rational& x) { return x.sign() > 0 && x < Rational(360); });
  request.rho = reflectivity("--rho", options.rho);
  request.rho_other =
      options.rho_other.empty() ? request.rho : reflectivity("--rho-other", options.rho_other);
  request.up_to = number_in("--up-to", options.up_to, "a number in (0, 20]",
                            [](const Rational& x) { return x.sign() > 0 && x <= Rational(20); });
  const std::string& digits = options.digits;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), request.digits);
  if (error != std::errc() || end != digits.data() + digits.size() || request.digits < 1 ||
      request.digits > most_digits)
    throw InputError({.source = "--digits",
                      .value = digits,
                      .allowed = "a whole number from 1 to " + std::to_string(most_digits)});
  return request;
}

/// An exponent, and the same by the second route.
struct Confirmed {
  EdgeExponent exponent;
  ComplexBall again;
};

struct EdgeAnswer {
  std::optional<Ball> smallest;      ///< of two reflecting faces that see each other
  std::vector<Confirmed> exponents;  ///< all of them up to the size, where they were counted
  std::string not_counted;           ///< why they were not
};

EdgeAnswer answer_to(const EdgeRequest& request, bool quiet) {
  EdgeAnswer answer;
  if (!request.faces_see_each_other() || !request.both_reflect()) return answer;
  const Edge edge = edge_of_degrees(request.angle, request.rho, request.rho_other);
  const Outcome<Ball> smallest =
      smallest_edge_exponent(edge, Rational(1) / power(Rational(10), request.digits + 1));
  if (!smallest) throw AccuracyNotReached("the smallest exponent", smallest.reason());
  answer.smallest = *smallest;
  ProgressDisplay progress(quiet);
  const Outcome<std::vector<EdgeExponent>> all =
      edge_exponents(edge, request.up_to, request.digits + 1,
                     [&](double part) { progress.at(part, "exponents are counted"); });
  if (!all) {
    answer.not_counted = all.reason();
    return answer;
  }
  const Rational radius = Rational(1) / power(Rational(10), std::min(request.digits + 1, most_second_digits));
  for (const EdgeExponent& exponent : *all) {
    progress.counted(answer.exponents.size(), all->size(), "exponents by the second route");
    const Outcome<ComplexBall> again = reference::edge_zero_near(
        request.angle, request.rho * request.rho_other, exponent.symmetric ? 1 : -1, exponent.value, radius);
    if (!again)
      throw AccuracyNotReached("the exponent " + exponent.value.to_text(12) + " by the second route",
                               again.reason());
    if (!overlaps(*again, exponent.value))
      throw std::logic_error("two proofs contradict each other: " + exponent.value.to_text(20) + ", " +
                             again->to_text(20));
    answer.exponents.push_back({.exponent = exponent, .again = *again});
  }
  return answer;
}

/// The least power of r with which u may be behind smooth functions: the exponent, or 1 for r log r.
double least_power(const EdgeAnswer& answer) { return answer.smallest ? answer.smallest->to_double() : 1; }

bool has_singular_part(const EdgeRequest& request) {
  return request.faces_see_each_other() && (request.rho.sign() > 0 || request.rho_other.sign() > 0);
}

double uniform_order(const EdgeAnswer& answer, int degree) {
  return std::min<double>(degree + 1, least_power(answer));
}
double wanted_grading(const EdgeAnswer& answer, int degree) {
  return std::max(1.0, (degree + 1) / least_power(answer));
}

std::string rounded(double x) { return nearest_text(x, DecimalForm::fixed(4)); }

std::string text_of(const EdgeRequest& request, const EdgeAnswer& answer) {
  std::string out = "edge of " + request.angle.to_text() + " degrees, reflectivities " +
                    request.rho.to_text() + " and " + request.rho_other.to_text() + "\n";
  if (!has_singular_part(request)) {
    out += request.faces_see_each_other()
               ? "Neither face reflects: u = E, and no exponent belongs to this edge.\n"
               : "The faces do not see each other: no exponent belongs to this edge. There u is as smooth on "
                 "either\nface as E and what else the face sees let it.\n";
    return out + "A uniform mesh loses no order at this edge.\n";
  }
  if (!answer.smallest) {
    out +=
        "One face reflects nothing: no power of r but whole ones. On the other u has terms r^n log r, n >= "
        "1.\n";
  } else if (!answer.not_counted.empty()) {
    out += "smallest exponent  " + reference_decimal(*answer.smallest, request.digits).midpoint + " +- " +
           reference_decimal(*answer.smallest, request.digits).radius + " (proved)\n";
  } else if (answer.exponents.empty()) {
    out += "No exponent is as small as " + request.up_to.to_text() + " (proved).\n";
  } else {
    std::vector<std::vector<std::string>> rows{{"", "exponent", "radius", "second route", "radius"}};
    const auto row = [&](const std::string& head, const Ball& value, const Ball& again) {
      const int second = std::min(request.digits, most_second_digits - 1);
      const BallDecimal first = reference_decimal(value, request.digits);
      const BallDecimal other = reference_decimal(again, second);
      rows.push_back({head, first.midpoint, first.radius, other.midpoint, other.radius});
    };
    for (const Confirmed& c : answer.exponents) {
      row(c.exponent.symmetric ? "symmetric" : "antisymmetric", c.exponent.value.real(), c.again.real());
      if (!c.exponent.value.is_real()) row("  +- i", c.exponent.value.imag(), c.again.imag());
    }
    out += aligned(rows) + "All exponents with 0 < Re b <= " + request.up_to.to_text() +
           ": their number is " + "proved, and each of them on both routes.\n";
  }
  std::vector<std::vector<std::string>> rows{{"degree", "order, uniform mesh", "grading for degree + 1"}};
  for (int degree = 0; degree <= most_degree; ++degree)
    rows.push_back({std::to_string(degree), rounded(uniform_order(answer, degree)),
                    rounded(wanted_grading(answer, degree))});
  out += "\n" + aligned(rows);
  if (!answer.smallest) out += "Orders up to a factor |log h|.\n";
  return out;
}

JsonValue ball_json(const Ball& value, int digits) {
  const BallDecimal decimal = reference_decimal(value, digits);
  return JsonValue::object({{"midpoint", decimal.midpoint}, {"radius", decimal.radius}});
}

JsonValue exponent_json(const ComplexBall& value, int digits) {
  JsonValue out = JsonValue::object({{"real", ball_json(value.real(), digits)}});
  out.set("imaginary", value.is_real() ? JsonValue() : ball_json(value.imag(), digits));
  return out;
}

JsonValue edge_json(const EdgeRequest& request, const EdgeAnswer& answer, const std::string& command) {
  JsonValue out = document_head("edge", command);
  out.set("angle", request.angle.to_text());
  out.set("reflectivities", JsonValue::array({request.rho.to_text(), request.rho_other.to_text()}));
  out.set("up_to", request.up_to.to_text());
  out.set("digits", request.digits);
  const bool sees = request.faces_see_each_other();
  out.set("faces_see_each_other", sees);
  out.set("logarithms", has_singular_part(request) && !answer.smallest);
  out.set("smallest", answer.smallest ? ball_json(*answer.smallest, request.digits) : JsonValue());
  JsonValue list = JsonValue::array();
  for (const Confirmed& c : answer.exponents) {
    JsonValue entry = exponent_json(c.exponent.value, request.digits);
    entry.set("symmetry", c.exponent.symmetric ? "symmetric" : "antisymmetric");
    entry.set("second_route", exponent_json(c.again, std::min(request.digits, most_second_digits - 1)));
    list.push(std::move(entry));
  }
  out.set("exponents", answer.not_counted.empty() ? std::move(list) : JsonValue());
  out.set("not_counted", answer.not_counted.empty() ? JsonValue() : JsonValue(answer.not_counted));
  JsonValue degrees = JsonValue::array();
  for (int degree = 0; degree <= most_degree; ++degree) {
    const bool is_singular = has_singular_part(request);
    degrees.push(JsonValue::object(
        {{"degree", degree},
         {"uniform_order", is_singular ? uniform_order(answer, degree) : static_cast<double>(degree + 1)},
         {"grading", is_singular ? wanted_grading(answer, degree) : 1.0}}));
  }
  out.set("degrees", std::move(degrees));
  return out;
}

ExitCode show_edge(const Common& common, const EdgeOptions& options) {
  const EdgeRequest request = request_of(options);
  const Outputs outputs(common);
  const EdgeAnswer answer = answer_to(request, common.quiet);
  print_result(common, outputs, text_of(request, answer),
               edge_json(request, answer, common.command).pretty() + "\n");
  if (answer.not_counted.empty()) return ExitCode::done;
  complain(answer.not_counted);
  return ExitCode::differs;
}

}  // namespace

void add_edge(Program& program) {
  Subcommand command = program.add("edge", "The exponents of the solution at an edge, proved");
  auto options = std::make_shared<EdgeOptions>();
  command.option("--angle", options->angle, "The dihedral angle, in (0, 360)", "DEGREES");
  command.option("--rho", options->rho, "The reflectivity of one face, in [0, 1)", "RHO");
  command.option("--rho-other", options->rho_other, "That of the other face. Default: the same", "RHO");
  command.option_with_default("--up-to", options->up_to, "The exponents whose real part is at most this");
  command.option_with_default("--digits", options->digits, "Radii of at most 10^-DIGITS");
  command.footer(
      "At an edge u is u_0 + c r^b + ..., r the distance from it: each b is a zero of rho rho' k(b)^2 = 1,\n"
      "k the symbol of the operator between two half planes. Exit code 0: all exponents are proved, and\n"
      "their number; 1: they were not counted; 2: no such angle or reflectivity.");
  command.runs([&common = program.common(), options] { return show_edge(common, *options); });
}

}  // namespace radcert::app
