// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/edge_records.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <stdexcept>
#include <utility>

#include "radcert/core/errors.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/result/reference_json.h"
#include "radcert/reference/edge_symbol_integral.h"

namespace radcert::app {

namespace {

constexpr int most_digits = 100;
constexpr int most_second_digits = 25;

Rational number_in(const std::string& option, const std::string& text, const std::string& allowed,
                   const std::function<bool(const Rational&)>& allows) {
  const Outcome<Rational> value = Rational::parse(text);
  if (!value || !allows(*value)) throw InputError({.source = option, .value = text, .allowed = allowed});
  return *value;
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

/// The least power of r with which u may be behind smooth functions: the exponent, or 1 for r log r.
double least_power(const EdgeRecord& record) { return record.smallest ? record.smallest->to_double() : 1; }

}  // namespace

bool EdgeRequest::has_singular_part() const {
  return faces_see_each_other() && (rho.sign() > 0 || rho_other.sign() > 0);
}

double EdgeRecord::uniform_order(int degree) const {
  return std::min<double>(degree + 1, least_power(*this));
}

double EdgeRecord::wanted_grading(int degree) const {
  return std::max(1.0, (degree + 1) / least_power(*this));
}

int digits_of_second_route(const EdgeRequest& request) {
  return std::min(request.digits, most_second_digits - 1);
}

EdgeRequest edge_request(const EdgeWish& wish, OptionStyle style) {
  const auto reflectivity = [style](const std::string& option, const std::string& text) {
    return number_in(option_name(style, option), text, "a number in [0, 1), decimal or fraction",
                     [](const Rational& x) { return x.sign() >= 0 && x < Rational(1); });
  };
  EdgeRequest request;
  const std::string angles = "a number of degrees in (0, 360), decimal or fraction";
  if (wish.angle.empty())
    throw InputError({.source = option_name(style, "angle"), .problem = "is missing", .allowed = angles});
  request.angle = number_in(option_name(style, "angle"), wish.angle, angles,
                            [](const Rational& x) { return x.sign() > 0 && x < Rational(360); });
  request.rho = reflectivity("rho", wish.rho);
  request.rho_other = wish.rho_other.empty() ? request.rho : reflectivity("rho-other", wish.rho_other);
  request.up_to = number_in(option_name(style, "up-to"), wish.up_to, "a number in (0, 20]",
                            [](const Rational& x) { return x.sign() > 0 && x <= Rational(20); });
  const std::string& digits = wish.digits;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), request.digits);
  if (error != std::errc() || end != digits.data() + digits.size() || request.digits < 1 ||
      request.digits > most_digits)
    throw InputError({.source = option_name(style, "digits"),
                      .value = digits,
                      .allowed = "a whole number from 1 to " + std::to_string(most_digits)});
  return request;
}

EdgeRecord edge_record(const EdgeRequest& request, const EdgeListener& listener) {
  EdgeRecord answer{.request = request, .smallest = std::nullopt, .exponents = {}, .not_counted = {}};
  if (!request.faces_see_each_other() || !request.both_reflect()) return answer;
  const Edge edge = edge_of_degrees(request.angle, request.rho, request.rho_other);
  const Outcome<Ball> smallest =
      smallest_edge_exponent(edge, Rational(1) / power(Rational(10), request.digits + 1));
  if (!smallest) throw AccuracyNotReached("the smallest exponent", smallest.reason());
  answer.smallest = *smallest;
  const Outcome<std::vector<EdgeExponent>> all =
      edge_exponents(edge, request.up_to, request.digits + 1, listener.counted);
  if (!all) {
    answer.not_counted = all.reason();
    return answer;
  }
  const Rational radius = Rational(1) / power(Rational(10), std::min(request.digits + 1, most_second_digits));
  for (const EdgeExponent& exponent : *all) {
    listener.confirmed(answer.exponents.size(), all->size());
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

JsonValue edge_json(const EdgeRecord& answer, const std::string& command) {
  const EdgeRequest& request = answer.request;
  JsonValue out = document_head("edge", command);
  out.set("angle", request.angle.to_text());
  out.set("reflectivities", JsonValue::array({request.rho.to_text(), request.rho_other.to_text()}));
  out.set("up_to", request.up_to.to_text());
  out.set("digits", request.digits);
  const bool sees = request.faces_see_each_other();
  out.set("faces_see_each_other", sees);
  out.set("logarithms", request.has_singular_part() && !answer.smallest);
  out.set("smallest", answer.smallest ? ball_json(*answer.smallest, request.digits) : JsonValue());
  JsonValue list = JsonValue::array();
  for (const ConfirmedExponent& c : answer.exponents) {
    JsonValue entry = exponent_json(c.exponent.value, request.digits);
    entry.set("symmetry", c.exponent.symmetric ? "symmetric" : "antisymmetric");
    entry.set("second_route", exponent_json(c.again, digits_of_second_route(request)));
    list.push(std::move(entry));
  }
  out.set("exponents", answer.not_counted.empty() ? std::move(list) : JsonValue());
  out.set("not_counted", answer.not_counted.empty() ? JsonValue() : JsonValue(answer.not_counted));
  JsonValue degrees = JsonValue::array();
  for (int degree = 0; degree <= most_degree_at_edges; ++degree) {
    const bool is_singular = request.has_singular_part();
    degrees.push(JsonValue::object(
        {{"degree", degree},
         {"uniform_order", is_singular ? answer.uniform_order(degree) : static_cast<double>(degree + 1)},
         {"grading", is_singular ? answer.wanted_grading(degree) : 1.0}}));
  }
  out.set("degrees", std::move(degrees));
  return out;
}

}  // namespace radcert::app
