// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "radcert/geometry/mesh_defects.h"

namespace radcert {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using BoundingBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;

/// Enough is found: box_self_intersection_d has no other way to end.
struct Enough {};

class Crossing {
public:
  explicit Crossing(const TriangleMesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] Kernel::Point_3 point(std::size_t vertex) const {
    const Vector<double>& v = mesh_.vertices[vertex];
    return {v.x, v.y, v.z};
  }
  [[nodiscard]] Kernel::Triangle_3 triangle(const VertexTriple& t) const {
    return {point(t[0]), point(t[1]), point(t[2])};
  }

  [[nodiscard]] bool operator()(std::size_t i, std::size_t j) const {
    const VertexTriple& s = mesh_.triangles[i];
    const VertexTriple& t = mesh_.triangles[j];
    std::vector<std::size_t> shared;
    std::vector<std::size_t> of_s;
    std::vector<std::size_t> of_t;
    for (const std::size_t v : s) (std::find(t.begin(), t.end(), v) != t.end() ? shared : of_s).push_back(v);
    for (const std::size_t v : t)
      if (std::find(s.begin(), s.end(), v) == s.end()) of_t.push_back(v);
    switch (shared.size()) {
      case 3: return true;
      case 2: return folded(shared[0], shared[1], of_s[0], of_t[0]);
      case 1: {
        const Kernel::Segment_3 opposite_s(point(of_s[0]), point(of_s[1]));
        const Kernel::Segment_3 opposite_t(point(of_t[0]), point(of_t[1]));
        return CGAL::do_intersect(triangle(s), opposite_t) || CGAL::do_intersect(triangle(t), opposite_s);
      }
      default: return CGAL::do_intersect(triangle(s), triangle(t));
    }
  }

private:
  /// Two triangles on a common side overlap if they lie in one plane, on the same side of it.
  [[nodiscard]] bool folded(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
    return CGAL::coplanar(point(a), point(b), point(c), point(d)) &&
           CGAL::coplanar_orientation(point(a), point(b), point(c), point(d)) == CGAL::POSITIVE;
  }

  const TriangleMesh& mesh_;
};

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> crossing_triangles(const TriangleMesh& mesh,
                                                                    std::size_t most) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  if (most == 0) return found;
  const Crossing crossing(mesh);
  std::vector<BoundingBox> boxes;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const Kernel::Triangle_3 triangle = crossing.triangle(mesh.triangles[k]);
    if (!triangle.is_degenerate()) boxes.emplace_back(triangle.bbox(), k);
  }
  std::vector<const BoundingBox*> pointers;
  for (const BoundingBox& box : boxes) pointers.push_back(&box);
  constexpr std::ptrdiff_t smallest_split = 2000;  // below it all pairs are tried
  try {
    CGAL::box_self_intersection_d(
        pointers.begin(), pointers.end(),
        [&](const BoundingBox* a, const BoundingBox* b) {
          if (!crossing(a->info(), b->info())) return;
          found.emplace_back(std::min(a->info(), b->info()), std::max(a->info(), b->info()));
          if (found.size() == most) throw Enough{};
        },
        smallest_split);
  } catch (const Enough&) {
    // The pairs found so far are kept.
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace radcert
