// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/element_integrator.h"

#include <algorithm>
#include <cmath>

#include "radcert/quadrature/bernstein.h"
#include "radcert/quadrature/chart_inverse.h"

namespace radcert {
namespace {

/// A piece is bisected unseen while the observer is nearer to its centre than this many radii of its ball.
constexpr double admissible_ratio = 1.8;
/// The finer rule has this much more order; more where the rules are gathered and converge slowly. Odd: see `samples`.
constexpr int check_step_analytic = 1;
constexpr int check_step_gathered = 3;
constexpr int order_step = 3;
/// Each two bisections halve a piece; at this depth its area is 2^-52 of the element's.
constexpr int deepest_bisection = 52;
/// Two rules that still differ on a far piece after so many bisections differ by rounding, which no bisection mends: the
/// difference goes into the radius.
constexpr int most_failures = 8;

template <Real R>
R largest_coordinate(const Vector<R>& p) {
  using std::abs;
  return std::max({abs(p.x), abs(p.y), abs(p.z)});
}

}  // namespace

template <Real R>
ElementIntegrator<R>::ElementIntegrator(const Surface& surface, const ParameterTriangle& triangle,
                                        const InsetBasis<R>& basis)
    : surface_(surface),
      chart_(surface.charts[triangle.chart]),
      chart_index_(triangle.chart),
      basis_(basis),
      element_(whole_element<R>(triangle)),
      ball_(ball_about(element_)),
      extent_(largest_coordinate(ball_.centre) + ball_.radius),
      kept_(ConicalRules<R>::largest_order + 1) {
  for (const Chart& other : surface.charts) in_plane_of_.push_back(in_one_plane(other, chart_));
}

template <Real R>
typename ElementIntegrator<R>::Ball ElementIntegrator<R>::ball_about(const Cell<R>& cell) const {
  const ChartIn<R>& formula = chart_.in<R>();
  const auto& v = cell.vertices;
  Ball ball;
  ball.centre = formula.frame((R(1) / R(3)) * (v[0] + v[1] + v[2])).point;
  ball.radius = R(0);
  for (std::size_t i = 0; i < 3; ++i) {
    ball.corners[i] = formula.frame(v[i]).point;
    ball.radius = std::max(ball.radius, norm(ball.corners[i] - ball.centre));
  }
  return ball;
}

template <Real R>
const Samples<R>& ElementIntegrator<R>::samples(const Cell<R>& cell, bool whole, int order) {
  if (!whole) {
    Samples<R>& fresh = scratch_[static_cast<std::size_t>(order % 2)];
    sample(chart_, cell, basis_, order, fresh);
    return fresh;
  }
  std::optional<Samples<R>>& kept = kept_[static_cast<std::size_t>(order)];
  if (!kept) sample(chart_, cell, basis_, order, kept.emplace());
  return *kept;
}

template <Real R>
KernelSums<R> ElementIntegrator<R>::sums(const Observer<R>& p, const Cell<R>& cell, bool whole, int order) {
  const Samples<R>& points = samples(cell, whole, order);
  const bool same_curved_piece_nearby = !whole && p.at.chart == chart_index_;
  return same_curved_piece_nearby ? chord_sums(p, chart_, points)
                                  : kernel_sums(p, points, std::max(extent_, largest_coordinate(p.point)));
}

template <Real R>
std::optional<CheckedSums<R>> ElementIntegrator<R>::try_piece(const Observer<R>& p, const Cell<R>& cell,
                                                              bool whole, double ratio, Insistence insist) {
  using std::abs;
  const double rho = ratio + std::sqrt(std::max(ratio * ratio - 1, 0.0));
  const bool analytic = chart_.facts().singular == SingularLine::none;
  const int check_step = analytic ? check_step_analytic : check_step_gathered;
  const int last = ConicalRules<R>::largest_order - check_step;
  int order = std::clamp(points_for(rho, basis_.degree()), ConicalRules<R>::smallest_order, last);
  while (true) {
    const KernelSums<R> coarse = sums(p, cell, whole, order);
    CheckedSums<R> fine(sums(p, cell, whole, order + check_step));
    R difference = R(0);
    R size = R(0);
    R noise = R(0);
    for (std::size_t j = 0; j < basis_.size(); ++j) {
      fine.difference[j] = abs(fine.sums.value[j] - coarse.value[j]);
      difference = std::max(difference, fine.difference[j]);
      size = std::max(size, fine.sums.size[j]);
      noise = std::max(noise, fine.sums.tilt[j]);
    }
    noise = R(4) * unit_roundoff<R>() * noise;
    if (difference <= R(converged_difference) * size + noise) return fine;
    if (order == last) {
      if (insist == Insistence::none) return std::nullopt;
      if (insist == Insistence::rounding) return fine;
      for (std::size_t j = 0; j < basis_.size(); ++j)
        fine.difference[j] = std::max(fine.difference[j], fine.sums.size[j]);
      return fine;
    }
    order = std::min(order + order_step, last);
  }
}

template <Real R>
CheckedSums<R> ElementIntegrator<R>::integrate_away(const Observer<R>& p) {
  CheckedSums<R> result(basis_.size());
  pending_.assign(1, {element_, 0, 0});
  while (!pending_.empty()) {
    Piece piece = pending_.back();
    pending_.pop_back();
    const bool whole = piece.depth == 0;
    const bool deepest = piece.depth == deepest_bisection;
    const Ball fresh = whole ? ball_ : ball_about(piece.cell);
    const auto ratio = static_cast<double>(norm(p.point - fresh.centre) / fresh.radius);
    if (ratio >= admissible_ratio || deepest) {
      const Insistence insist = deepest                           ? Insistence::deepest
                                : piece.failures == most_failures ? Insistence::rounding
                                                                  : Insistence::none;
      const auto checked = try_piece(p, piece.cell, whole, std::max(ratio, 1.0), insist);
      if (checked) {
        result += *checked;
        continue;
      }
      ++piece.failures;
    }
    std::size_t opposite = 0;  // the vertex opposite to the longest side
    R longest = R(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const R side = norm(fresh.corners[(i + 1) % 3] - fresh.corners[(i + 2) % 3]);
      if (side > longest) {
        longest = side;
        opposite = i;
      }
    }
    for (const Cell<R>& half : piece.cell.bisected(opposite))
      pending_.push_back({half, piece.depth + 1, piece.failures});
  }
  return result;
}

template <Real R>
ElementIntegral<R> ElementIntegrator<R>::with_radius(const CheckedSums<R>& checked) const {
  ElementIntegral<R> result;
  result.absolute = checked.sums.total_size;
  for (std::size_t j = 0; j < basis_.size(); ++j) {
    result.value[j] = checked.sums.value[j];
    result.radius[j] = checked.difference[j] + rounding(checked.sums, j);
  }
  return result;
}

template <Real R>
ElementIntegral<R> ElementIntegrator<R>::integrate(const Observer<R>& p) {
  if (in_plane_of_[p.at.chart]) return {};
  const Chart& own = surface_.charts[p.at.chart];
  if (p.at.chart == chart_index_) {
    if (contains(element_, p.at.at)) return with_radius(integrate_around(p, chart_, element_, basis_));
  } else if (own.facts().piece == chart_.facts().piece &&
             norm(p.point - ball_.centre) < R(2) * ball_.radius) {
    if (const auto at = parameters_on(chart_, element_, p.point, extent_)) {
      Observer<R> seen = p;
      seen.at = {chart_index_, *at};
      return with_radius(integrate_around(seen, chart_, element_, basis_));
    }
  }
  return with_radius(integrate_away(p));
}

template class ElementIntegrator<double>;

}  // namespace radcert
