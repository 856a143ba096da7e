// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/element_integrator.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/work_limit.h"
#include "radcert/quadrature/bernstein.h"
#include "radcert/quadrature/chart_inverse.h"
#include "radcert/quadrature/even_shape.h"

namespace radcert {
namespace {

/// A piece is divided unseen while the collocation point is nearer to its centre than this many radii of its
/// ball.
constexpr double admissible_ratio = 1.8;
/// A whole element, whose samples are kept, counts as far down to this ratio.
constexpr double admissible_ratio_of_whole = 1.35;
/// A block of collocation points is integrated side by side from this ratio on: nearer, the bounds of
/// FarBounds are too wide.
constexpr double admissible_ratio_of_block = 2.5;
constexpr int order_step = 3;
/// Parameters of P on another chart come from an iteration.
constexpr double parameter_roundings = 64;
/// From this loss on nothing is known of the element but that it holds no more than a hemisphere.
constexpr double lost_parameters = 0x1p-6;
/// A block whose two rules differ is tried again so often with the next finer ones.
const WorkLimit most_tries("quadrature/element_integrator: tries with finer rules", 4, 1,
                           "the observers are integrated one by one");
/// Each two divisions halve a piece or more; at this depth its corners are neighbouring doubles.
const WorkLimit deepest_bisection("quadrature/element_integrator: bisections", 104, 0,
                                  "all that the element may hold joins the radius");
const WorkLimit most_pieces("quadrature/element_integrator: pieces", 5000, 0,
                            "all that the element may hold joins the radius");
/// Two rules that still differ on a far piece after so many bisections differ by rounding, which no bisection
/// mends: the difference goes into the radius.
const WorkLimit most_failures("quadrature/element_integrator: bisections of a far piece", 8, 0,
                              "the difference of two rules goes into the radius");

template <Real R>
R largest_coordinate(const Vector<R>& p) {
  using std::abs;
  return std::max({abs(p.x), abs(p.y), abs(p.z)});
}

/// Of a thin element, what its parameters and those of P are off by against its width: they are at most 1.
template <Real R>
R loss_of_parameters(const ElementPart<R>& element) {
  using std::abs;
  using std::sqrt;
  R longest = R(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const ParameterPoint<R> side = element.vertices[(i + 1) % 3] - element.vertices[i];
    longest = std::max(longest, static_cast<R>(sqrt(side.s * side.s + side.t * side.t)));
  }
  const R width = abs(element.doubled_area) / longest;
  if (!(width < longest / R(8))) return R(0);
  return R(parameter_roundings) * unit_roundoff<R>() / width;
}

}  // namespace

template <Real R>
ElementIntegrator<R>::ElementIntegrator(std::shared_ptr<const IntegrationScheme<R>> scheme,
                                        const ParameterTriangle& triangle)
    : scheme_(std::move(scheme)),
      chart_(scheme_->surface().charts[triangle.chart]),
      chart_index_(triangle.chart),
      element_(whole_element<R>(triangle)),
      ball_(ball_about(element_)),
      shape_(shape_of(element_)),
      parameter_loss_(loss_of_parameters(element_)),
      extent_(largest_coordinate(ball_.centre) + ball_.radius),
      kept_(ConicalRules<R>::largest_order + 1) {}

template <Real R>
typename ElementIntegrator<R>::BoundingBall ElementIntegrator<R>::ball_about(
    const ElementPart<R>& cell) const {
  const ChartIn<R>& formula = chart_.in<R>();
  const auto& v = cell.vertices;
  BoundingBall ball;
  ball.centre = formula.frame((R(1) / R(3)) * (v[0] + v[1] + v[2])).point;
  ball.radius = R(0);
  for (std::size_t i = 0; i < 3; ++i) {
    ball.corners[i] = formula.frame(v[i]).point;
    ball.radius = std::max(ball.radius, norm(ball.corners[i] - ball.centre));
  }
  return ball;
}

template <Real R>
ElementShape ElementIntegrator<R>::shape_of(const ElementPart<R>& cell) const {
  if (chart_.facts().plane) return {};
  const auto normal = [&](const ParameterPoint<R>& at) { return chart_.in<R>().frame(at).area_normal; };
  std::array<Vector<R>, 6> at;  // corners, and the middles of the sides that begin there
  for (std::size_t i = 0; i < 3; ++i) {
    at[i] = normal(cell.vertices[i]);
    at[3 + i] = normal((R(1) / R(2)) * (cell.vertices[i] + cell.vertices[(i + 1) % 3]));
  }
  R uneven = R(0);
  R change = R(0);
  R largest = R(0);
  for (std::size_t i = 0; i < 3; ++i)
    uneven = std::max(uneven, unevenness(at[i], at[3 + i], at[(i + 1) % 3]));
  for (std::size_t i = 0; i < 6; ++i) {
    largest = std::max(largest, norm(at[i]));
    for (std::size_t k = 0; k < i; ++k) change = std::max(change, norm(at[i] - at[k]));
  }
  return {largest > R(0) ? nearest_double<R>(change / largest) : 0, nearest_double<R>(uneven)};
}

template <Real R>
const Samples<R>& ElementIntegrator<R>::kept(int order) {
  std::optional<Samples<R>>& kept = kept_[static_cast<std::size_t>(order)];
  if (!kept) take_samples(chart_, element_, basis(), order, kept.emplace());
  return *kept;
}

template <Real R>
const Samples<R>& ElementIntegrator<R>::samples(const ElementPart<R>& cell, bool whole, int order) {
  if (whole) return kept(order);
  Samples<R>& fresh = scratch_[static_cast<std::size_t>(order % 2)];
  take_samples(chart_, cell, basis(), order, fresh);
  return fresh;
}

template <Real R>
R ElementIntegrator<R>::extent_for(const R& coordinate, std::size_t chart_of_p, const R& reach) const {
  const R loss = std::max(scheme_->normal_loss(chart_of_p), scheme_->normal_loss(chart_index_));
  return std::max({extent_, coordinate, static_cast<R>(loss / R(2) * reach)});
}

template <Real R>
KernelSums<R> ElementIntegrator<R>::sums(const CollocationPoint<R>& p, const ElementPart<R>& cell, bool whole,
                                         const R& extent, int order) {
  const Samples<R>& points = samples(cell, whole, order);
  const bool same_curved_piece_nearby = !whole && p.at.chart == chart_index_;
  return same_curved_piece_nearby ? chord_sums(p, chart_, points) : kernel_sums(p, points, extent);
}

template <Real R>
std::optional<CheckedSums<R>> ElementIntegrator<R>::try_piece(const CollocationPoint<R>& p,
                                                              const ElementPart<R>& cell, bool whole,
                                                              double ratio, const R& extent,
                                                              Insistence insist) {
  using std::abs;
  const int check_step = scheme_->check_step(chart_.facts(), shape_.unevenness);
  const int last = ConicalRules<R>::largest_order - check_step;
  int order = std::min(scheme_->order_by_model(ratio), last);
  while (true) {
    const KernelSums<R> coarse = sums(p, cell, whole, extent, order);
    CheckedSums<R> fine(sums(p, cell, whole, extent, order + check_step));
    R difference = R(0);
    R size = R(0);
    R noise = R(0);
    for (std::size_t j = 0; j < basis().size(); ++j) {
      fine.difference[j] = abs(fine.sums.value[j] - coarse.value[j]);
      difference = std::max(difference, fine.difference[j]);
      size = std::max(size, fine.sums.size[j]);
      noise = std::max(noise, fine.sums.tilt[j]);
    }
    share_largest_difference(fine, R(scheme_->tolerance().intended_truncation()));
    noise = R(4) * unit_roundoff<R>() * noise;
    if (difference <= R(scheme_->tolerance().converged()) * size + noise) return fine;
    if (order == last) {
      if (insist == Insistence::none) return std::nullopt;
      return fine;
    }
    order = std::min(order + order_step, last);
  }
}

template <Real R>
CheckedSums<R> ElementIntegrator<R>::integrate_away(const CollocationPoint<R>& p, const ElementPart<R>& cell,
                                                    bool is_element) {
  CheckedSums<R> result(basis().size());
  const R coordinate = largest_coordinate(p.point);
  const R told_apart = least_distance(std::max(extent_, coordinate));
  const long deepest = deepest_bisection.value();
  const long failures = most_failures.value();
  const std::size_t most = most_pieces.count();
  pending_.assign(1, {cell, 0, 0});
  for (std::size_t pieces = 0; !pending_.empty(); ++pieces) {
    if (pieces == most) {
      result.complete = false;
      break;
    }
    Piece piece = pending_.back();
    pending_.pop_back();
    const bool whole = is_element && piece.depth == 0;
    const BoundingBall fresh = whole ? ball_ : ball_about(piece.cell);
    const R distance = norm(p.point - fresh.centre);
    const auto ratio = nearest_double<R>(distance / fresh.radius);
    const bool admissible = ratio >= (whole ? admissible_ratio_of_whole : admissible_ratio);
    if (admissible && distance - fresh.radius >= told_apart &&
        (whole ? shape_ : shape_of(piece.cell)).unevenness < uneven_for_any_rule) {
      const Insistence insist = piece.failures == failures ? Insistence::rounding : Insistence::none;
      const R extent = extent_for(coordinate, p.at.chart, distance + fresh.radius);
      const auto checked = try_piece(p, piece.cell, whole, ratio, extent, insist);
      if (checked) {
        result += *checked;
        continue;
      }
      ++piece.failures;
    }
    // No part of a piece that small, and that near, is farther away than what rounding hides.
    if (!(fresh.radius >= told_apart) || piece.depth == deepest) {
      result.complete = false;
      continue;
    }
    for (const ElementPart<R>& part : division_.divide(piece.cell, fresh.corners, p.point))
      pending_.push_back({part, piece.depth + 1, piece.failures});
  }
  return result;
}

template <Real R>
ElementIntegral<R> ElementIntegrator<R>::with_radius(const CheckedSums<R>& checked) const {
  ElementIntegral<R> result;
  result.absolute = checked.sums.total_size;
  for (std::size_t j = 0; j < basis().size(); ++j) {
    result.value[j] = checked.sums.value[j];
    result.radius[j] = checked.difference[j] + rounding(checked.sums, j);
    if (!checked.complete) result.radius[j] += pi<R>() * scheme_->largest_value(j);
  }
  return result;
}

/// As integrate_around has it. Where the element is thin, the rounding of parameters, P's above all, moves
/// what it holds by as much as it is of the width.
template <Real R>
ElementIntegral<R> ElementIntegrator<R>::around(const CollocationPoint<R>& p) const {
  CheckedSums<R> sums = integrate_around(p, chart_, element_, shape_, basis(), scheme_->tolerance());
  if (!(parameter_loss_ < R(lost_parameters))) sums.complete = false;
  ElementIntegral<R> result = with_radius(sums);
  for (std::size_t j = 0; j < basis().size(); ++j)
    result.radius[j] += parameter_loss_ * result.absolute * scheme_->largest_value(j);
  return result;
}

template <Real R>
bool ElementIntegrator<R>::is_near(const Vector<R>& p) const {
  return norm(p - ball_.centre) < R(admissible_ratio_of_whole) * ball_.radius;
}

template <Real R>
ElementIntegral<R> ElementIntegrator<R>::integrate(const CollocationPoint<R>& p) {
  if (scheme_->in_plane(p.at.chart, chart_index_)) return {};
  const Chart& own = scheme_->surface().charts[p.at.chart];
  if (p.at.chart == chart_index_) {
    if (contains(element_, p.at.at) || (chart_.facts().singular == SingularLine::none && is_near(p.point)))
      return around(p);
  } else if (scheme_->surface().charts_join_smoothly && own.facts().piece == chart_.facts().piece &&
             norm(p.point - ball_.centre) < R(2) * ball_.radius) {
    const auto at = parameters_on(chart_, element_, p.point, extent_);
    if (at && (contains(element_, *at) || (shape_.unevenness < uneven_for_few_points && is_near(p.point)))) {
      CollocationPoint<R> seen = p;
      seen.at = {chart_index_, *at};
      return around(seen);
    }
  }
  return with_radius(integrate_away(p));
}

template <Real R>
ElementIntegral<R> ElementIntegrator<R>::integrate_part(const CollocationPoint<R>& p,
                                                        const ElementPart<R>& part) {
  return with_radius(integrate_away(p, part, false));
}

template <Real R>
void ElementIntegrator<R>::integrate_lane(const CollocationPointBlock<R>& block,
                                          std::span<const CollocationPoint<R>> observers, std::size_t lane,
                                          BlockIntegral<R>& integral) {
  const ElementIntegral<R> alone = integrate(observers[block.first + lane]);
  Block<R>::set_lane(integral.absolute, lane, alone.absolute);
  for (std::size_t j = 0; j < basis().size(); ++j) {
    Block<R>::set_lane(integral.value[j], lane, alone.value[j]);
    Block<R>::set_lane(integral.radius[j], lane, alone.radius[j]);
  }
}

/// What rounding may have done to value j of a far block, by two bounds for the sums of |g l_j|: the whole of
/// |g| at the largest |l_j|, and the largest |G| over the whole of |l_j|.
template <Real R>
typename Block<R>::Type ElementIntegrator<R>::far_rounding(std::size_t points, const FarBounds<R>& bounds,
                                                           std::size_t j) const {
  using std::min;
  const R u = unit_roundoff<R>();
  const B largest_value = B(scheme_->largest_value(j));
  const B share = B(view_->share[j]);
  const B by_value = rounding_bound(points, basis().size(), far_[0].size, B(view_->area) * bounds.lean, u);
  const B by_kernel = rounding_bound(points, basis().size(), bounds.largest, bounds.lean, u);
  return min(largest_value * by_value, share * by_kernel);
}

/// On a plane element: one rule, whose truncation is bounded.
template <Real R>
void ElementIntegrator<R>::integrate_far_by_bound(const CollocationPointBlock<R>& block,
                                                  const FarBounds<R>& bounds, int order,
                                                  BlockIntegral<R>& integral) {
  const Samples<R>& points = kept(order);
  far_sums(block, points, g_, far_[0]);
  const B left_out = B(R(scheme_->flat_truncation())) * bounds.solid_angle;
  integral.absolute = far_[0].size;
  for (std::size_t j = 0; j < basis().size(); ++j) {
    integral.value[j] = far_[0].value[j];
    integral.radius[j] = B(scheme_->largest_value(j)) * left_out + far_rounding(points.count, bounds, j);
  }
}

/// Elsewhere: two rules, finer ones if they differ. A lane in which those of the last try still differ is
/// integrated alone.
template <Real R>
void ElementIntegrator<R>::integrate_far_by_comparison(const CollocationPointBlock<R>& block,
                                                       std::span<const CollocationPoint<R>> observers,
                                                       const FarBounds<R>& bounds, int order,
                                                       BlockIntegral<R>& integral) {
  using std::abs;
  using std::max;
  const Tolerance& tolerance = scheme_->tolerance();
  const int step = scheme_->check_step(chart_.facts(), shape_.unevenness);
  const B noise = B(R(4) * unit_roundoff<R>() * view_->area) * bounds.lean;
  B excess = B(R(0));
  B largest_relative = B(R(0));
  std::size_t points = 0;
  const long most = most_tries.value();
  for (int tries = 0; tries < most && order + step <= ConicalRules<R>::largest_order; ++tries, ++order) {
    const Samples<R>& fine = kept(order + step);
    far_sums(block, fine, g_, far_[0]);
    far_sums(block, kept(order), g_, far_[1]);
    points = fine.count;
    B largest_difference = B(R(0));
    largest_relative = B(R(0));
    for (std::size_t j = 0; j < basis().size(); ++j) {
      const B difference = abs(far_[0].value[j] - far_[1].value[j]);
      largest_difference = max(largest_difference, difference);
      largest_relative = max(largest_relative, difference * B(R(1) / view_->share[j]));
    }
    excess = largest_difference - (B(R(tolerance.converged())) * far_[0].size + noise);
    if (Block<R>::largest(excess) <= R(0)) break;
  }
  // As share_largest_difference does.
  const B intended = B(R(tolerance.intended_truncation()) / view_->area) * far_[0].size;
  integral.absolute = far_[0].size;
  for (std::size_t j = 0; j < basis().size(); ++j) {
    integral.value[j] = far_[0].value[j];
    integral.radius[j] = B(view_->share[j]) * (largest_relative + intended) + far_rounding(points, bounds, j);
  }
  for (std::size_t lane = 0; lane < block.count; ++lane)
    if (!(Block<R>::lane(excess, lane) <= R(0))) integrate_lane(block, observers, lane, integral);
}

template <Real R>
void ElementIntegrator<R>::integrate(const CollocationPointBlock<R>& block,
                                     std::span<const CollocationPoint<R>> observers,
                                     BlockIntegral<R>& integral) {
  if (scheme_->in_plane(block.chart, chart_index_)) {
    integral.absolute = B(R(0));
    for (std::size_t j = 0; j < basis().size(); ++j) integral.value[j] = integral.radius[j] = B(R(0));
    return;
  }
  const R distance = norm(block.centre - ball_.centre);
  const auto ratio = nearest_double<R>((distance - block.radius) / ball_.radius);
  const R extent = extent_for(block.extent, block.chart, distance + block.radius + ball_.radius);
  const bool told_apart =
      distance - block.radius - ball_.radius >= least_distance(std::max(extent_, block.extent));
  if (!(ratio >= admissible_ratio_of_block) || !told_apart || shape_.unevenness >= uneven_for_any_rule) {
    for (std::size_t lane = 0; lane < block.count; ++lane) integrate_lane(block, observers, lane, integral);
    return;
  }
  if (!view_) view_.emplace(kept(ConicalRules<R>::smallest_order + 2), ball_.centre);
  const FarBounds<R> bounds(block, *view_, ball_.centre, ball_.radius, extent);
  const FarRule rule = scheme_->far_rule(chart_.facts(), ratio, shape_.unevenness);
  if (rule.compared_with)
    integrate_far_by_comparison(block, observers, bounds, *rule.compared_with, integral);
  else
    integrate_far_by_bound(block, bounds, rule.order, integral);
}

template class ElementIntegrator<double>;
template class ElementIntegrator<Mpfr<50>>;

}  // namespace radcert
