// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "radcert/closed_form/edge/edge_exponents.h"
#include "radcert/core/option_name.h"
#include "radcert/formats/json/json_value.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/complex_ball.h"
#include "radcert/scalar/rational.h"

namespace radcert::app {

/// What is asked for of an edge, in the words of users.
struct EdgeWish {
  std::string angle;      ///< in degrees
  std::string rho;        ///< of one face
  std::string rho_other;  ///< empty: the same
  std::string up_to = "3";
  std::string digits = "12";
};

/// The same, read.
struct EdgeRequest {
  Rational angle;
  Rational rho;
  Rational rho_other;
  Rational up_to;
  int digits = 0;

  [[nodiscard]] bool faces_see_each_other() const { return angle < Rational(180); }
  [[nodiscard]] bool both_reflect() const { return rho.sign() > 0 && rho_other.sign() > 0; }
  /// Whether u has a part there that is not smooth, however smooth E is.
  [[nodiscard]] bool has_singular_part() const;
};

/// Result    InputError at the option for a word that is not allowed
[[nodiscard]] EdgeRequest edge_request(const EdgeWish& wish, OptionStyle style);

/// An exponent, and the same by the second route.
struct ConfirmedExponent {
  EdgeExponent exponent;
  ComplexBall again;
};

/// The exponents at an edge, and what they ask of a mesh.
struct EdgeRecord {
  EdgeRequest request;
  std::optional<Ball> smallest;              ///< of two reflecting faces that see each other
  std::vector<ConfirmedExponent> exponents;  ///< all of them up to the size, where they were counted
  std::string not_counted;                   ///< why they were not

  /// The order on a uniform mesh with functions of a degree.
  [[nodiscard]] double uniform_order(int degree) const;
  /// The exponent of the grading that brings the order degree + 1.
  [[nodiscard]] double wanted_grading(int degree) const;
};

/// Who is told how far that has come.
struct EdgeListener {
  std::function<void(double part)> counted = [](double) {};
  std::function<void(std::size_t done, std::size_t all)> confirmed = [](std::size_t, std::size_t) {};
};

/// Result    proved, each exponent on two routes; AccuracyNotReached where one is not found
[[nodiscard]] EdgeRecord edge_record(const EdgeRequest& request, const EdgeListener& listener = {});

/// The digits that are shown of the second route.
[[nodiscard]] int digits_of_second_route(const EdgeRequest& request);

/// The document radcert/edge/1.
[[nodiscard]] JsonValue edge_json(const EdgeRecord& record, const std::string& command);

/// Up to which degree of functions orders and gradings are told.
inline constexpr int most_degree_at_edges = 4;

}  // namespace radcert::app
