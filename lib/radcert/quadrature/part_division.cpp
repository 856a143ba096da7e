// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/part_division.h"

#include <algorithm>
#include <cmath>

namespace radcert {
namespace {

/// A part whose height is less than this share of its longest side is thin.
constexpr double thin = 0.125;
/// Where the foot of its height is no more heights than this from an end of the longest side, a thin part has
/// a side across its length.
constexpr double across = 2;
/// The foot of a height is rounded to a multiple of a power of two: at most the height, in shares of the
/// longest side, and between these.
constexpr int coarsest_step = -4;
constexpr int finest_step = -52;
/// A slice is far whose middle lies so many times its length away: its triangles have a rule then.
constexpr double far_lengths = 1.8;
/// No slice shorter than this share of the way is halved.
constexpr double least_share = 0x1p-50;

/// A corner of a part.
template <Real R>
struct Corner {
  ParameterPoint<R> vertex;
  Barycentric<R> place;
};

template <Real R>
Corner<R> corner(const ElementPart<R>& part, std::size_t i) {
  return {part.vertices[i], part.corners[i]};
}

/// The point that divides the way from corner i to corner k.
template <Real R>
Corner<R> between(const ElementPart<R>& part, std::size_t i, std::size_t k, const R& share) {
  Corner<R> out{(R(1) - share) * part.vertices[i] + share * part.vertices[k], {}};
  for (std::size_t c = 0; c < 3; ++c)
    out.place.x[c] = (R(1) - share) * part.corners[i].x[c] + share * part.corners[k].x[c];
  return out;
}

template <Real R>
ElementPart<R> part_of(const Corner<R>& a, const Corner<R>& b, const Corner<R>& c, const R& doubled_area) {
  return {{a.vertex, b.vertex, c.vertex}, {a.place, b.place, c.place}, doubled_area};
}

/// The share of the longest side at which a thin part is cut, if the foot of its height is there; the height
/// in the same unit.
double rounded_foot(double foot, double height) {
  const int exponent = height > 0 ? std::ilogb(height) : finest_step;
  const double step = std::ldexp(1, std::clamp(exponent, finest_step, coarsest_step));
  return std::clamp(step * std::round(foot / step), step, 1 - step);
}

}  // namespace

template <Real R>
std::span<const ElementPart<R>> PartDivision<R>::divide(const ElementPart<R>& part,
                                                        const std::array<Vector<R>, 3>& at,
                                                        const Vector<R>& p) {
  parts_.clear();
  std::array<R, 3> side;  // opposite to each corner
  for (std::size_t i = 0; i < 3; ++i) side[i] = norm(at[(i + 1) % 3] - at[(i + 2) % 3]);
  const auto place = [&](auto found) { return static_cast<std::size_t>(found - side.begin()); };
  const std::size_t longest = place(std::max_element(side.begin(), side.end()));
  const R& length = side[longest];
  const Vector<R> along = at[(longest + 2) % 3] - at[(longest + 1) % 3];
  const Vector<R> to_corner = at[longest] - at[(longest + 1) % 3];
  const auto height = nearest_double<R>(norm(cross(along, to_corner)) / (length * length));
  if (!(height < thin)) {
    cut_at(part, longest, 0.5);
    return parts_;
  }
  const auto foot = nearest_double<R>(dot(along, to_corner) / (length * length));
  if (std::min(foot, 1 - foot) <= across * height)
    slice(part, place(std::min_element(side.begin(), side.end())), at, p);
  else
    cut_at(part, longest, rounded_foot(foot, height));
  return parts_;
}

/// Into two, from a corner to the point that divides the side opposite to it.
template <Real R>
void PartDivision<R>::cut_at(const ElementPart<R>& part, std::size_t opposite, double share) {
  const std::size_t j = (opposite + 1) % 3;
  const std::size_t k = (opposite + 2) % 3;
  const Corner<R> foot = between(part, j, k, R(share));
  const R& area = part.doubled_area;
  parts_.push_back(part_of<R>(corner(part, opposite), corner(part, j), foot, R(share) * area));
  parts_.push_back(part_of<R>(corner(part, opposite), foot, corner(part, k), R(1 - share) * area));
}

template <Real R>
void PartDivision<R>::slice(const ElementPart<R>& part, std::size_t apex, const std::array<Vector<R>, 3>& at,
                            const Vector<R>& p) {
  const std::size_t j = (apex + 1) % 3;
  const std::size_t k = (apex + 2) % 3;
  const Vector<R> axis = R(1) / R(2) * (at[j] + at[k]) - at[apex];
  const R length = norm(axis);
  const R width = norm(at[j] - at[k]);
  pending_.assign({{0.5, 1}, {0, 0.5}});
  while (!pending_.empty()) {
    const auto [begin, end] = pending_.back();
    pending_.pop_back();
    const double middle = (begin + end) / 2;
    const R extent = R(end - begin) * length + R(end) * width;
    const bool is_near = norm(at[apex] + R(middle) * axis - p) < R(far_lengths) * extent;
    if (is_near && R(end - begin) * length > R(2) * R(end) * width && end - begin > least_share) {
      pending_.push_back({middle, end});
      pending_.push_back({begin, middle});
      continue;
    }
    const Corner<R> from_j = between(part, apex, j, R(begin));
    const Corner<R> to_j = between(part, apex, j, R(end));
    const Corner<R> to_k = between(part, apex, k, R(end));
    const R between_them = R(end - begin) * part.doubled_area;
    parts_.push_back(part_of<R>(from_j, to_j, to_k, R(end) * between_them));
    if (begin > 0)
      parts_.push_back(part_of<R>(from_j, to_k, between(part, apex, k, R(begin)), R(begin) * between_them));
  }
}

template class PartDivision<double>;
template class PartDivision<Mpfr<50>>;

}  // namespace radcert
