// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/plane_classes.h"

#include <algorithm>
#include <compare>
#include <numeric>
#include <tuple>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/geometry/orientation.h"

namespace radcert {
namespace {

/// One name for each oriented plane: the coefficients over the size of the first that is not zero.
struct PlaneName {
  Vector<Rational> normal;
  Rational offset;
};

PlaneName name_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto corners = mesh.corners(triangle);
  const Vector<Rational> a = exactly(corners[0]);
  PlaneName plane;
  plane.normal = cross(exactly(corners[1]) - a, exactly(corners[2]) - a);
  plane.offset = dot(plane.normal, a);
  const Vector<Rational>& n = plane.normal;
  const Rational scale = abs(n.x.sign() != 0 ? n.x : n.y.sign() != 0 ? n.y : n.z);
  expects(scale.sign() != 0, "triangles that are not degenerate", named("triangle", triangle));
  plane.normal = (Rational(1) / scale) * plane.normal;
  plane.offset /= scale;
  return plane;
}

}  // namespace

PlaneClasses plane_classes(const TriangleMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  std::vector<PlaneName> names(count);
  parallel_for(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) names[k] = name_of(mesh, k);
  });
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t k) {
    return std::tie(names[k].normal.x, names[k].normal.y, names[k].normal.z, names[k].offset);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const std::strong_ordering by_name = key(a) <=> key(b);
    return by_name != 0 ? by_name < 0 : a < b;
  });
  // Within a class triangles stand in their order: its first names it.
  std::vector<std::size_t> first(count);
  for (std::size_t k = 0; k < count; ++k)
    first[order[k]] = k > 0 && key(order[k]) == key(order[k - 1]) ? first[order[k - 1]] : order[k];
  PlaneClasses classes;
  classes.of_triangle.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    if (first[k] == k) {
      classes.of_triangle[k] = classes.count();
      classes.first_triangle.push_back(k);
    } else {
      classes.of_triangle[k] = classes.of_triangle[first[k]];
    }
  }
  return classes;
}

}  // namespace radcert
