// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/scalar/rational.h"
#include "radcert/solve/verified_system.h"
#include "tests/attack/attack.h"

namespace radcert::attack {
namespace {

/// (I - K) u = e with radii: what verified_system takes.
struct System {
  std::size_t n = 0;
  std::vector<double> k;         ///< by columns
  std::vector<double> k_radius;  ///< the same, or empty
  std::vector<double> e;
  std::vector<double> e_radius;     ///< or empty
  std::uint64_t seed_of_members{};  ///< of the systems within the radii that are tried
};

Matrix<double> matrix_of(std::size_t n, const std::vector<double>& values) {
  if (values.empty()) return {};
  Matrix<double> matrix = Matrix<double>::uninitialised(n, n);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) matrix(i, j) = values[j * n + i];
  return matrix;
}

double sign(Draw& draw) { return draw.below(2) == 0 ? 1 : -1; }

/// One entry's size: ordinary, of any scale, or at the ends of the range.
double radius_for(Draw& draw, double value) {
  switch (draw.below(6)) {
    case 0: return 0;
    case 1: return 0x1p-1074;
    case 2: return 0x1p-53 * std::abs(value);
    case 3: return std::ldexp(draw.unit(), -static_cast<int>(draw.below(60)));
    case 4: return std::ldexp(std::abs(value), -static_cast<int>(draw.below(40)));
    default: return 1e-13 * draw.unit();
  }
}

System make_system(Draw& draw) {
  System s;
  s.n = 1 + draw.below(5);
  const std::size_t n = s.n;
  s.k.resize(n * n);
  const auto at = [&s, n](std::size_t i, std::size_t j) -> double& { return s.k[j * n + i]; };
  switch (draw.below(7)) {
    case 0:  // any
      for (double& x : s.k) x = sign(draw) * draw.unit() * (draw.below(8) == 0 ? 100 : 1);
      break;
    case 1: {  // row sums of 1 less a little, as for reflectivities just below 1
      const double rest = std::ldexp(1.0, -1 - static_cast<int>(draw.below(54)));
      for (std::size_t i = 0; i < n; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < n; ++j) sum += at(i, j) = draw.unit();
        for (std::size_t j = 0; j < n; ++j) at(i, j) *= (1 - rest) / sum;
      }
      break;
    }
    case 2: {  // I - K almost singular: two rows that differ by a little
      for (double& x : s.k) x = sign(draw) * draw.unit();
      const std::size_t a = draw.below(n);
      const std::size_t b = draw.below(n);
      const double apart = std::ldexp(draw.unit(), -static_cast<int>(draw.below(60)));
      for (std::size_t j = 0; j < n && a != b; ++j)
        at(b, j) = (j == b ? 1 : 0) - ((j == a ? 1 : 0) - at(a, j)) * (1 + (j == 0 ? apart : 0));
      break;
    }
    case 3: {  // badly scaled rows and columns: D K D^-1 keeps the solution's existence
      std::vector<double> scale;
      for (std::size_t i = 0; i < n; ++i)
        scale.push_back(std::ldexp(1.0, static_cast<int>(draw.below(400)) - 200));
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          at(i, j) = scale[i] / scale[j] * sign(draw) * draw.unit() / static_cast<double>(n);
      break;
    }
    case 4:  // triangular with an inverse that grows
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
          at(i, j) = 1 + std::ldexp(draw.unit(), static_cast<int>(draw.below(30)));
      break;
    case 5:  // denormal and huge
      for (double& x : s.k) {
        const double number = draw.number();
        x = std::abs(number) > 1e100 ? 1 / number : number;
      }
      break;
    default: {  // a Hilbert matrix in the place of I - K, rounded
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          at(i, j) = (i == j ? 1.0 : 0.0) - 1.0 / static_cast<double>(i + j + 1 + draw.below(2));
    }
  }
  if (draw.below(3) != 0)
    for (const double x : s.k) s.k_radius.push_back(radius_for(draw, x));
  for (std::size_t i = 0; i < n; ++i) switch (draw.below(4)) {
      case 0: s.e.push_back(0); break;
      case 1: s.e.push_back(sign(draw)); break;
      case 2:
        s.e.push_back(sign(draw) * std::ldexp(1 + draw.unit(), static_cast<int>(draw.below(600)) - 300));
        break;
      default: s.e.push_back(sign(draw) * draw.unit());
    }
  if (draw.below(2) == 0)
    for (const double x : s.e) s.e_radius.push_back(radius_for(draw, x));
  s.seed_of_members = draw.bits();
  return s;
}

using Row = std::vector<Rational>;

/// The solution of A u = e by Gauss and Jordan over the rational numbers; nothing if A is singular.
std::optional<Row> solution(std::vector<Row> a, Row e) {
  const std::size_t n = e.size();
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    while (pivot < n && a[pivot][column] == Rational(0)) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(a[pivot], a[column]);
    std::swap(e[pivot], e[column]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == column || a[i][column] == Rational(0)) continue;
      const Rational factor = a[i][column] / a[column][column];
      for (std::size_t j = column; j < n; ++j) a[i][j] -= factor * a[column][j];
      e[i] -= factor * e[column];
    }
  }
  for (std::size_t i = 0; i < n; ++i) e[i] /= a[i][i];
  return e;
}

/// A number within a radius: an end, the middle, or between.
Rational member(Draw& draw, double value, double radius) {
  const Rational middle = Rational::exactly(value);
  const Rational r = Rational::exactly(radius);
  switch (draw.below(5)) {
    case 0:
    case 1: return middle + r;
    case 2:
    case 3: return middle - r;
    default: return middle + Rational::exactly(2 * draw.unit() - 1) * r;
  }
}

std::string number_text(double x) { return shortest(x); }

std::string text(const System& s) {
  const auto list = [](const std::vector<double>& x) {
    std::string out;
    for (const double v : x) out += (out.empty() ? "" : ", ") + number_text(v);
    return "{" + out + "}";
  };
  return "n = " + std::to_string(s.n) + ", K by columns " + list(s.k) + " +- " + list(s.k_radius) + ", e " +
         list(s.e) + " +- " + list(s.e_radius);
}

Judgement judge(const System& s) {
  const std::size_t n = s.n;
  const Outcome<VerifiedSystem> system = verified_system(matrix_of(n, s.k), matrix_of(n, s.k_radius));
  if (!system) return Judgement::refused();
  const Outcome<VerifiedSolution> solved = system->solve(s.e, s.e_radius);
  if (!solved) return Judgement::refused();
  Draw draw(s.seed_of_members);
  const std::size_t members = s.k_radius.empty() && s.e_radius.empty() ? 1 : 4;
  for (std::size_t m = 0; m < members; ++m) {
    std::vector<Row> a(n, Row(n));
    Row e(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        a[i][j] = Rational(i == j ? 1 : 0) -
                  member(draw, s.k[j * n + i], s.k_radius.empty() ? 0.0 : s.k_radius[j * n + i]);
      e[i] = member(draw, s.e[i], s.e_radius.empty() ? 0.0 : s.e_radius[i]);
    }
    const std::optional<Row> exact = solution(std::move(a), std::move(e));
    if (!exact) return Judgement::violated("a matrix within the radii is singular");
    for (std::size_t i = 0; i < n; ++i) {
      const Rational off = (*exact)[i] - Rational::exactly(solved->values[i]);
      const Rational radius = Rational::exactly(solved->radius[i]);
      if (off > radius || -off > radius)
        return Judgement::violated("u_" + std::to_string(i) + " = " + number_text(solved->values[i]) +
                                   " +- " + number_text(solved->radius[i]) + " is off by " +
                                   number_text(off.to_double()) + " for a system within the radii");
    }
  }
  return Judgement::held();
}

/// Without a row and its column; without radii; with e in one place only.
std::vector<System> smaller(const System& s) {
  std::vector<System> found;
  for (std::size_t drop = 0; drop < s.n && s.n > 1; ++drop) {
    System t{
        .n = s.n - 1, .k = {}, .k_radius = {}, .e = {}, .e_radius = {}, .seed_of_members = s.seed_of_members};
    for (std::size_t j = 0; j < s.n; ++j) {
      if (j == drop) continue;
      t.e.push_back(s.e[j]);
      if (!s.e_radius.empty()) t.e_radius.push_back(s.e_radius[j]);
      for (std::size_t i = 0; i < s.n; ++i) {
        if (i == drop) continue;
        t.k.push_back(s.k[j * s.n + i]);
        if (!s.k_radius.empty()) t.k_radius.push_back(s.k_radius[j * s.n + i]);
      }
    }
    found.push_back(std::move(t));
  }
  if (!s.k_radius.empty()) {
    found.push_back(s);
    found.back().k_radius.clear();
  }
  if (!s.e_radius.empty()) {
    found.push_back(s);
    found.back().e_radius.clear();
  }
  return found;
}

TEST(VerifiedSystemAttack, EnclosesTheSolutionsOfAllSystemsWithinTheRadii) {
  const Count count = hold(Attack<System>{.name = "verified systems",
                                          .usual_instances = 1000,
                                          .make = make_system,
                                          .judge = judge,
                                          .text = text,
                                          .smaller = smaller});
  EXPECT_LT(count.refused, count.instances);
}

}  // namespace
}  // namespace radcert::attack
