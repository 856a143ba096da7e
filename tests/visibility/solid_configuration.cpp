// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/visibility/solid_configuration.h"

#include <cmath>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"
#include "radcert/visibility/sight_geometry.h"

namespace radcert {
namespace {

using Side = SightGeometry::Side;
using Corner = SightGeometry::Corner;

/// The sides of a part and the corners where each begins.
struct Outline {
  std::vector<Side> sides;
  std::vector<Corner> corners;
};

Outline outline(SightGeometry& geometry, const VisiblePart& part) {
  expects(part.planes.size() >= 3, "a part with three sides at least", named("sides", part.planes.size()));
  Outline result;
  for (const SightPlane& plane : part.planes) result.sides.push_back(geometry.side_of(plane));
  for (std::size_t k = 0; k < result.sides.size(); ++k) {
    const Side& before = k == 0 ? result.sides.back() : result.sides[k - 1];
    result.corners.push_back(geometry.corner(before, result.sides[k]));
  }
  return result;
}

using Wide = long double;

Vector<Wide> unit_vector(const Vector<Wide>& v) { return (Wide(1) / norm(v)) * v; }

/// A unit vector within 2^-53 of the direction: as it is where its bound says so, else from whole numbers.
template <class Exactly>
Vector<Wide> direction_of(const SizedVector<Wide>& rounded, int roundings, Exactly&& exactly) {
  constexpr Wide accuracy = 0x1p-53L;
  const Wide error = static_cast<Wide>(roundings) * unit_roundoff<Wide>() * norm(rounded.size);
  if (error <= accuracy * norm(rounded.value)) return unit_vector(rounded.value);
  return unit_vector(leading_digits(exactly()));
}

/// The angle between two directions, for exact vectors not both zero, neither of them opposite.
Ball angle_between(const Vector<Rational>& a, const Vector<Rational>& b) {
  const Vector<Rational> across = cross(a, b);
  const Rational along = dot(a, b);
  const Ball sine = sqrt(Ball(dot(across, across)));
  if (along.sign() == 0) return Ball::pi() / Ball(2);
  const Ball acute = atan(sine / Ball(abs(along)));
  return along.sign() > 0 ? acute : Ball::pi() - acute;
}

}  // namespace

Ball solid_configuration(const Scene& scene, const Viewpoint& from, std::size_t triangle,
                         const VisibleRegion& region) {
  expects(triangle < scene.triangle_count(), "a triangle of the scene", named("triangle", triangle));
  SightGeometry geometry(scene, from);
  const Vector<Rational> normal{Rational::exactly(from.normal.x), Rational::exactly(from.normal.y),
                                Rational::exactly(from.normal.z)};
  const Rational normal_square = dot(normal, normal);
  Ball sum = 0;
  for (const VisiblePart& part : region.parts) {
    const Outline lines = outline(geometry, part);
    std::vector<Vector<Rational>> corners;
    for (const Corner& corner : lines.corners)
      corners.push_back(to_rational(geometry.whole_direction(corner)));
    for (std::size_t k = 0; k < lines.sides.size(); ++k) {
      const Vector<Rational> m = to_rational(geometry.whole_normal(lines.sides[k]));
      const Rational product = dot(m, normal);
      if (product.sign() == 0) continue;
      const Ball cosine = Ball(product) / sqrt(Ball(normal_square * dot(m, m)));
      sum += angle_between(corners[k], corners[(k + 1) % corners.size()]) * cosine;
    }
  }
  return sum / Ball(2);
}

double solid_configuration_in_double(const Scene& scene, const Viewpoint& from, std::size_t triangle,
                                     const VisibleRegion& region) {
  expects(triangle < scene.triangle_count(), "a triangle of the scene", named("triangle", triangle));
  SightGeometry geometry(scene, from);
  const Vector<Wide> normal = unit_vector(
      {static_cast<Wide>(from.normal.x), static_cast<Wide>(from.normal.y), static_cast<Wide>(from.normal.z)});
  Wide sum = 0;
  for (const VisiblePart& part : region.parts) {
    const Outline lines = outline(geometry, part);
    std::vector<Vector<Wide>> corners;
    for (const Corner& corner : lines.corners)
      corners.push_back(direction_of(geometry.direction<Wide>(corner), SightGeometry::rounding_of_direction,
                                     [&] { return geometry.whole_direction(corner); }));
    for (std::size_t k = 0; k < lines.sides.size(); ++k) {
      const Side& side = lines.sides[k];
      const Vector<Wide> m = direction_of(geometry.normal<Wide>(side), SightGeometry::rounding_of_normal,
                                          [&] { return geometry.whole_normal(side); });
      const Vector<Wide>& a = corners[k];
      const Vector<Wide>& b = corners[(k + 1) % corners.size()];
      sum += std::atan2(norm(cross(a, b)), dot(a, b)) * dot(m, normal);
    }
  }
  return static_cast<double>(sum / 2);
}

}  // namespace radcert
