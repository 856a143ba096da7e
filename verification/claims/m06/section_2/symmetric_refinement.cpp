// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/m06/section_2/symmetric_refinement.h"

#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"

namespace radcert::verification::m06 {

TriangleOf<Polynomial> any_triangle() {
  TriangleOf<Polynomial> v;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < 2; ++c)
      v[i][c] = Polynomial::variable("v" + std::to_string(i) + std::to_string(c));
  return v;
}

Rational terms_of_halved_sides(const Rational& part) {
  const TriangleOf<Polynomial> parent = any_triangle();
  const std::array<TriangleOf<Polynomial>, 4> all = children(parent, part);
  Rational terms = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Polynomial half = Rational(k == 3 ? -1 : 1, 2);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 2; ++c)
        terms += differing_terms(
            all[k][(i + 1) % 3][c] - all[k][i][c] - half * (parent[(i + 1) % 3][c] - parent[i][c]), 0);
  }
  return terms;
}

std::vector<Triangle> triangles_of(const Surface& surface, int level, std::size_t chart,
                                   const TriangulationOptions& options) {
  std::vector<Triangle> triangles;
  for (const ParameterTriangle& each : triangulate(surface, level, options).triangles) {
    if (each.chart != chart) continue;
    Triangle exact;
    for (std::size_t i = 0; i < 3; ++i)
      exact[i] = {Rational::exactly(each.vertices[i].s), Rational::exactly(each.vertices[i].t)};
    triangles.push_back(exact);
  }
  return triangles;
}

Rational differing_children(const Surface& surface, int levels, const TriangulationOptions& options) {
  long count = 0;
  for (std::size_t chart = 0; chart < surface.charts.size(); ++chart)
    for (int level = 1; level <= levels; ++level) {
      const std::vector<Triangle> fine = triangles_of(surface, level, chart, options);
      std::vector<Triangle> expected;
      for (const Triangle& parent : triangles_of(surface, level - 1, chart, options))
        for (const Triangle& child : children(parent)) expected.push_back(child);
      if (fine.size() != expected.size()) ++count;
      for (std::size_t k = 0; k < std::min(fine.size(), expected.size()); ++k)
        if (fine[k] != expected[k]) ++count;
    }
  return {count};
}

std::vector<Domain> domains(int level) {
  const std::vector<Corner> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Surface on_square = two_piece(2);
  TriangulationOptions other;
  other.diagonals = std::vector<Diagonal>(on_square.charts.size(), Diagonal::anti);
  return {{"unit square", square, triangles_of(on_square, level, 0)},
          {"unit square, the other diagonal", square, triangles_of(on_square, level, 0, other)},
          {"unit triangle", {{0, 0}, {1, 0}, {0, 1}}, triangles_of(sphere(), level, 0)}};
}

std::string named(const Domain& domain, int level) {
  return ", " + domain.name + ", level " + std::to_string(level);
}

}  // namespace radcert::verification::m06
