// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/clusters/certified/enclosed_tables.h"

#include <cmath>
#include <map>
#include <span>

#include "radcert/clusters/mode_tables.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/polynomial/lagrange_basis.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/triangle_modes.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/scalar/bounded_double.h"

namespace radcert {
namespace {

using Corners = std::array<Barycentric<double>, 3>;

constexpr Corners whole{Barycentric<double>{{1, 0, 0}}, Barycentric<double>{{0, 1, 0}},
                        Barycentric<double>{{0, 0, 1}}};

/// The corners of the parts that some symmetric refinements make of a triangle: dyadic numbers, exact.
std::vector<Corners> corners_of_parts(int refinements) {
  std::vector<Corners> parts;
  const std::vector<Barycentric<double>> points = points_of_parts(refinements, whole);
  for (std::size_t i = 0; i < points.size(); i += 3)
    parts.push_back({points[i], points[i + 1], points[i + 2]});
  return parts;
}

Barycentric<Ball> point_in(const Corners& corners, const Barycentric<Ball>& y) {
  Barycentric<Ball> x;
  for (std::size_t i = 0; i < 3; ++i)
    x.x[i] = y.x[0] * Ball(corners[0].x[i]) + y.x[1] * Ball(corners[1].x[i]) + y.x[2] * Ball(corners[2].x[i]);
  return x;
}

Barycentric<Ball> entered(const Barycentric<Rational>& q) {
  return {{Ball(q.x[0]), Ball(q.x[1]), Ball(q.x[2])}};
}

/// A rule with weights that sum to 1, exact for a degree.
TriangleRule<Ball> mean_rule(int degree) {
  TriangleRule<Ball> rule = conical_rule<Ball>(degree / 2 + 1, Grading::none);
  for (Ball& weight : rule.weights) weight = Ball(2) * weight;
  return rule;
}

/// The mode of each place is of this degree.
std::vector<std::size_t> degree_of_modes(int degree) {
  std::vector<std::size_t> degrees;
  for (std::size_t m = 0; m <= static_cast<std::size_t>(degree); ++m) degrees.insert(degrees.end(), m + 1, m);
  return degrees;
}

/// The coefficients of a polynomial of degree r on a part, from those on the whole.
class Blossoms {
public:
  explicit Blossoms(int degree) : degree_(degree) {
    for (int d = 0; d <= degree; ++d) {
      lattices_.push_back(lattice_indices(d));
      std::map<std::array<int, 3>, std::size_t> places;
      for (std::size_t k = 0; k < lattices_.back().size(); ++k) places[lattices_.back()[k]] = k;
      places_.push_back(std::move(places));
    }
  }
  /// A bound of the sizes of the coefficients on the part with these corners.
  double largest(std::vector<BoundedDouble> coefficients, const Corners& corners) const {
    double found = 0;
    for (const std::array<int, 3>& index : lattices_.back()) {
      std::vector<BoundedDouble> now = coefficients;
      int left = degree_;
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (int times = 0; times < index[corner]; ++times) step(now, left--, corners[corner]);
      found = larger_bound(found, (std::abs(now[0].value()) + now[0].error()) * (1 + 0x1p-50));
    }
    return found;
  }

private:
  void step(std::vector<BoundedDouble>& c, int degree, const Barycentric<double>& u) const {
    const auto d = static_cast<std::size_t>(degree);
    std::vector<BoundedDouble> lower(lattices_[d - 1].size());
    for (std::size_t k = 0; k < lower.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        std::array<int, 3> index = lattices_[d - 1][k];
        ++index[i];
        lower[k] = lower[k] + BoundedDouble::exactly(u.x[i]) * c[places_[d].at(index)];
      }
    c = std::move(lower);
  }

  int degree_;
  std::vector<std::vector<std::array<int, 3>>> lattices_;
  std::vector<std::map<std::array<int, 3>, std::size_t>> places_;
};

}  // namespace

StepFunctions::StepFunctions(const LagrangeFunctions& functions) {
  const Blossoms blossoms(functions.degree());
  double squares = 0;
  for (const Corners& part : corners_of_parts(cuts)) {
    std::vector<double> of_part;
    double sum = 0;
    for (std::size_t j = 0; j < functions.size(); ++j) {
      std::vector<BoundedDouble> coefficients;
      for (const Rational& c : functions.bernstein_coefficients(j))
        coefficients.push_back(from_rational<BoundedDouble>(c));
      of_part.push_back(blossoms.largest(std::move(coefficients), part));
      sum += of_part.back();
    }
    squares += sum * sum;
    bounds.push_back(std::move(of_part));
  }
  size = std::sqrt(squares / static_cast<double>(bounds.size())) * (1 + 0x1p-40);
}

EnclosedTables::EnclosedTables(const LagrangeFunctions& functions, const StepFunctions& steps,
                               int refinements, int degree)
    : unknowns((std::size_t{1} << static_cast<unsigned>(2 * refinements)) * functions.size()),
      moments(mode_count(degree), unknowns),
      sizes(mode_count(degree), unknowns),
      values(unknowns, mode_count(degree)) {
  const std::size_t k = mode_count(degree);
  const std::size_t p = functions.size();
  const std::vector<std::size_t> degrees = degree_of_modes(degree);
  const long bits = BallPrecision::current();

  const TriangleRule<Ball> of_modes = mean_rule(2 * degree);
  const std::vector<Corners> children = corners_of_parts(1);
  parallel_for(children.size(), 1, [&](std::size_t begin, std::size_t end) {
    const BallPrecision inside(bits);
    std::vector<Ball> in_parent(k);
    std::vector<Ball> in_child(k);
    for (std::size_t c = begin; c < end; ++c) {
      transfer[c] = Matrix<Ball>(k, k);
      for (std::size_t q = 0; q < of_modes.points.size(); ++q) {
        triangle_modes<Ball>(degree, point_in(children[c], of_modes.points[q]), in_parent);
        triangle_modes<Ball>(degree, of_modes.points[q], in_child);
        for (std::size_t m = 0; m < k; ++m) {
          const Ball factor = of_modes.weights[q] * in_child[m];
          for (std::size_t n = 0; n < k; ++n)
            if (degrees[n] >= degrees[m]) transfer[c](n, m) += factor * in_parent[n];
        }
      }
    }
  });

  const std::vector<Corners> elements = corners_of_parts(refinements);
  const Ball share = Ball(1) / Ball(static_cast<long>(elements.size()));
  const LagrangeBasis<Ball> basis(functions);
  const TriangleRule<Ball> exact = mean_rule(degree + functions.degree());
  parallel_for(elements.size(), 1, [&](std::size_t begin, std::size_t end) {
    const BallPrecision inside(bits);
    std::vector<Ball> modes(k);
    std::vector<Ball> at(p);
    for (std::size_t e = begin; e < end; ++e) {
      for (std::size_t q = 0; q < exact.points.size(); ++q) {
        basis.values<Ball>(exact.points[q], at);
        triangle_modes<Ball>(degree, point_in(elements[e], exact.points[q]), modes);
        for (std::size_t j = 0; j < p; ++j) {
          const Ball factor = share * exact.weights[q] * at[j];
          for (std::size_t n = 0; n < k; ++n) moments(n, e * p + j) += factor * modes[n];
        }
      }
      for (std::size_t j = 0; j < p; ++j) {
        triangle_modes<Ball>(degree, point_in(elements[e], entered(functions.nodes()[j])), modes);
        for (std::size_t n = 0; n < k; ++n) values(e * p + j, n) = modes[n];
      }
    }
  });

  // The moments of the functions that are 1 on one part of the leaf: from part to parent, a quarter of the
  // transfer each.
  std::vector<std::vector<Ball>> ones{std::vector<Ball>(k)};
  ones[0][0] = 1;
  for (int depth = 0; depth < refinements + StepFunctions::cuts; ++depth) {
    std::vector<std::vector<Ball>> finer(4 * ones.size(), std::vector<Ball>(k));
    parallel_for(finer.size(), [&](std::size_t begin, std::size_t end) {
      const BallPrecision inside(bits);
      for (std::size_t i = begin; i < end; ++i) {
        const Matrix<Ball>& t = transfer[i / ones.size()];
        const std::vector<Ball>& of_child = ones[i % ones.size()];
        for (std::size_t n = 0; n < k; ++n) {
          for (std::size_t m = 0; m < k && degrees[m] <= degrees[n]; ++m)
            finer[i][n] += t(n, m) * of_child[m];
          finer[i][n] = finer[i][n] / Ball(4);
        }
      }
    });
    ones = std::move(finer);
  }
  const std::size_t parts = steps.bounds.size();
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (std::size_t i = 0; i < parts; ++i)
      for (std::size_t j = 0; j < p; ++j)
        for (std::size_t n = 0; n < k; ++n)
          sizes(n, e * p + j) += Ball(steps.bounds[i][j]) * ones[e * parts + i][n];
}

}  // namespace radcert
