// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated rows of collocation matrices between plane triangles in nasty positions, against closed forms in
// balls.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "radcert/collocation/assembly.h"
#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/collocation/certified/plane_entries.h"
#include "radcert/collocation/nodes.h"
#include "radcert/core/contract.h"
#include "radcert/core/text.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/mesh_surface.h"
#include "tests/attack/attack.h"

namespace radcert::attack {
namespace {

/// Two triangles that nothing hides from each other.
struct Pair {
  std::array<Vector<double>, 3> first;
  std::array<Vector<double>, 3> second;
  int degree = 0;
  int alpha = 0;  ///< a place in `insets`
  double tolerance = 1e-13;
};

const std::vector<Rational>& insets() {
  static const std::vector<Rational> all{Rational(1, 6), Rational(1, 4), Rational(1, 100),
                                         Rational(1, 1000000)};
  return all;
}

double small(Draw& draw, int most_bits) {
  return std::ldexp(1 + draw.unit(), -static_cast<int>(draw.below(static_cast<std::size_t>(most_bits))));
}

Vector<double> anywhere(Draw& draw) {
  return {2 * draw.unit() - 1, 2 * draw.unit() - 1, 2 * draw.unit() - 1};
}

Vector<double> unit(const Vector<double>& v) { return (1 / norm(v)) * v; }

Pair make_pair_of_triangles(Draw& draw) {
  Pair pair;
  auto& [a, b, c] = pair.first;
  a = anywhere(draw);
  b = anywhere(draw);
  c = anywhere(draw);
  if (draw.below(4) == 0) c = 0.5 * (a + b) + small(draw, 30) * anywhere(draw);  // a sliver
  const Vector<double> n = unit(cross(b - a, c - a));
  auto& [p, q, r] = pair.second;
  switch (draw.below(6)) {
    case 0:  // a common side, the planes almost one
    case 1: {
      const Vector<double> along = unit(b - a);
      const Vector<double> off = cross(along, n);
      const double turn = draw.below(2) == 0 ? small(draw, 50) : 3.14159265358979 - small(draw, 50);
      const Vector<double> across = std::cos(turn) * off + (draw.below(2) == 0 ? 1 : -1) * std::sin(turn) * n;
      p = b;
      q = a;
      r = a + draw.unit() * (b - a) + small(draw, 12) * across;
      break;
    }
    case 2: {  // parallel, close
      const double gap = small(draw, 60);
      p = a + gap * n;
      q = c + gap * n;
      r = b + gap * n;
      break;
    }
    case 3:  // a common corner
      p = a;
      q = a + small(draw, 30) * anywhere(draw);
      r = a + anywhere(draw);
      break;
    case 4: {  // hovering over a point of the first
      const double size = small(draw, 40);
      const Vector<double> foot = a + 0.3 * (b - a) + 0.4 * draw.unit() * (c - a);
      p = foot + small(draw, 60) * n;
      q = p + size * anywhere(draw);
      r = p + size * anywhere(draw);
      break;
    }
    default:  // far away, or large
      p = small(draw, 1) * 100 * anywhere(draw);
      q = p + small(draw, 20) * 1000 * anywhere(draw);
      r = p + small(draw, 20) * anywhere(draw);
  }
  if (draw.below(4) == 0) {  // far from the origin
    const Vector<double> off = std::ldexp(1.0, static_cast<int>(draw.below(40))) * anywhere(draw);
    for (auto* triangle : {&pair.first, &pair.second})
      for (Vector<double>& corner : *triangle) corner = corner + off;
  }
  const double scale = std::ldexp(1.0, static_cast<int>(draw.below(100)) - 50);
  for (auto* triangle : {&pair.first, &pair.second})
    for (Vector<double>& corner : *triangle) corner = scale * corner;
  pair.degree = static_cast<int>(draw.below(4));
  pair.alpha = static_cast<int>(draw.below(insets().size()));
  pair.tolerance = draw.below(4) == 0 ? 1e-6 : 1e-13;
  return pair;
}

std::string point_text(const Vector<double>& p) {
  return "(" + shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + ")";
}

std::string text(const Pair& pair) {
  std::string out;
  for (const auto* triangle : {&pair.first, &pair.second})
    for (const Vector<double>& corner : *triangle) out += point_text(corner) + " ";
  return out + "degree " + std::to_string(pair.degree) + ", alpha " +
         insets()[static_cast<std::size_t>(pair.alpha)].to_text() + ", tolerance " + shortest(pair.tolerance);
}

using Exact = std::array<Vector<Rational>, 3>;

Exact exactly(const std::array<Vector<double>, 3>& t) {
  Exact out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = {Rational::exactly(t[i].x), Rational::exactly(t[i].y), Rational::exactly(t[i].z)};
  return out;
}

/// On which side of a triangle's plane the corners of another lie: 1 where its cross product points to, -1,
/// or 0: on both or on none.
int side_of(const Exact& other, const Exact& t) {
  const Vector<Rational> n = cross(t[1] - t[0], t[2] - t[0]);
  int side = 0;
  for (const Vector<Rational>& corner : other) {
    const Rational height = dot(n, corner - t[0]);
    if (height == Rational(0)) continue;
    const int here = height > Rational(0) ? 1 : -1;
    if (side == -here) return 0;
    side = here;
  }
  return side;
}

/// The pair with its triangles turned so that each faces the other, as on the boundary of a convex body;
/// nothing if that is not to be had.
std::optional<Pair> face_to_face(Pair pair) {
  const int of_second = side_of(exactly(pair.second), exactly(pair.first));
  const int of_first = side_of(exactly(pair.first), exactly(pair.second));
  if (of_second == 0 || of_first == 0) return std::nullopt;
  // The inner normal is against the cross product.
  if (of_second > 0) std::swap(pair.first[1], pair.first[2]);
  if (of_first > 0) std::swap(pair.second[1], pair.second[2]);
  return pair;
}

Judgement judge(const Pair& drawn) {
  const std::optional<Pair> turned = face_to_face(drawn);
  if (!turned) return Judgement::refused();
  const Pair& pair = *turned;
  TriangleMesh mesh;
  for (const auto* triangle : {&pair.first, &pair.second}) {
    const std::size_t at = mesh.vertices.size();
    mesh.vertices.insert(mesh.vertices.end(), triangle->begin(), triangle->end());
    mesh.triangles.push_back({at, at + 1, at + 2});
    mesh.group.push_back(0);
    mesh.face.push_back(mesh.face.size());
  }
  mesh.group_names = {""};
  const std::vector<std::size_t> pieces{0, 1};
  const std::vector<std::string> names{"first", "second"};
  const Surface surface = mesh_surface("pair", mesh, pieces, names, {.closed = false, .unoccluded = true});
  const Triangulation triangulation = triangulate(surface, 0);
  const Rational& alpha = insets()[static_cast<std::size_t>(pair.alpha)];
  const LagrangeFunctions functions = lagrange_functions(inset_nodes(pair.degree, alpha)).value();
  std::vector<PlaneChart> elements;
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    std::array<ParameterPoint<Rational>, 3> corners;
    for (std::size_t c = 0; c < 3; ++c)
      corners[c] = {Rational::exactly(triangle.vertices[c].s), Rational::exactly(triangle.vertices[c].t)};
    elements.push_back(plane_chart(surface, triangle.chart)->over(corners));
  }
  std::optional<CertifiedEntries> exact;
  try {
    Outcome<CertifiedEntries> found = plane_entries_in_balls(elements, functions);
    if (!found) return Judgement::refused();
    exact = std::move(found).value();
  } catch (const ContractViolation&) {
    return Judgement::refused();  // a node on the border of the other triangle
  }
  const InsetBasis<double> basis(pair.degree, pair.degree == 0 ? 0 : alpha.to_double());
  const auto nodes = collocation_nodes<double>(surface, triangulation, basis);
  const CollocationMatrix<double> matrix =
      assemble<double>(surface, triangulation, basis, nodes, std::vector<double>(nodes.size(), 1.0),
                       Tolerance(pair.tolerance));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    double off = 0;
    double size = 0;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      off += std::max(0.0, std::abs(matrix.entries(i, j) - exact->entries(i, j)) - exact->radius(i, j));
      size += std::abs(exact->entries(i, j));
    }
    if (!(off <= matrix.row_radius[i]))
      return Judgement::violated("row " + std::to_string(i) + " is off by " + shortest(off) + ", radius " +
                                 shortest(matrix.row_radius[i]) + ", sum of sizes " + shortest(size));
  }
  return Judgement::held();
}

std::vector<Pair> smaller(const Pair& pair) {
  std::vector<Pair> found;
  for (int degree = 0; degree < pair.degree; ++degree) {
    found.push_back(pair);
    found.back().degree = degree;
  }
  const auto rounded = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  Pair shorter = pair;
  bool changed = false;
  for (auto* triangle : {&shorter.first, &shorter.second})
    for (Vector<double>& corner : *triangle) {
      const Vector<double> now{rounded(corner.x), rounded(corner.y), rounded(corner.z)};
      changed = changed || norm(now - corner) > 0;
      corner = now;
    }
  if (changed) found.push_back(shorter);
  return found;
}

TEST(PlaneRowsAttack, LieWithinTheRadiiOfTheirRows) {
  hold(Attack<Pair>{.name = "estimated rows of plane entries",
                    .usual_instances = 60,
                    .make = make_pair_of_triangles,
                    .judge = judge,
                    .text = text,
                    .smaller = smaller});
}

}  // namespace
}  // namespace radcert::attack
