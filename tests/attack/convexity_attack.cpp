// SPDX-License-Identifier: GPL-3.0-or-later

// Convex containment: of meshes, pushed by units in the last place, and of charts with parameters at the ends
// of their ranges. The judge of a mesh is the definition, in rational numbers, vertex by plane; that of
// charts is a formula of its own for points and normals of the surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/hypotheses/convex_containment.h"
#include "radcert/surface/catalogue.h"
#include "tests/attack/attack.h"

namespace radcert::attack {
namespace {

using Point = std::array<Rational, 3>;

Point exact(const Vector<double>& v) {
  return {Rational::exactly(v.x), Rational::exactly(v.y), Rational::exactly(v.z)};
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Point crossed(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational product(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Mesh {
  TriangleMesh mesh;
  bool inwards = true;  ///< the inner normals are against the cross products
};

// The hull of points, by trying every triple: a triangle counts if no point lies on its outer side. Points of
// one facet make overlapping triangles, which the certificate allows.
TriangleMesh hull(const std::vector<Vector<double>>& points) {
  TriangleMesh mesh;
  mesh.vertices = points;
  mesh.group_names = {""};
  std::vector<Point> p;
  for (const Vector<double>& v : points) p.push_back(exact(v));
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = i + 1; j < p.size(); ++j)
      for (std::size_t k = j + 1; k < p.size(); ++k) {
        const Point n = crossed(minus(p[j], p[i]), minus(p[k], p[i]));
        if (n[0] == 0 && n[1] == 0 && n[2] == 0) continue;
        int signs = 0;
        for (const Point& q : p) signs |= 1 << (product(n, minus(q, p[i])).sign() + 1);
        if ((signs & 5) == 5) continue;
        if ((signs & 4) != 0)
          mesh.triangles.push_back({i, k, j});
        else
          mesh.triangles.push_back({i, j, k});
        mesh.group.push_back(0);
        mesh.face.push_back(mesh.face.size());
      }
  return mesh;
}

Vector<double> corner(Draw& draw, std::size_t kind) {
  const auto small = [&] { return static_cast<double>(draw.below(4)); };
  switch (kind) {
    case 0: return {small(), small(), small()};
    case 1: return {small() * 0.1, small() * 0.1, 1 + small() * 0.1};  // decimals, not quite on a lattice
    case 2: return {draw.unit(), draw.unit(), 1e-9 * draw.unit()};     // a thin slab
    case 3:
      return {std::ldexp(1 + draw.unit(), 190), std::ldexp(draw.unit(), 190), std::ldexp(draw.unit(), 190)};
    case 4: return {std::ldexp(draw.unit(), -1000), std::ldexp(draw.unit(), -1000), 5e-324 * small()};
    case 5: return {1e15 + small(), 1e15 + small(), 1e15 + small()};
    default: {
      const double z = 2 * draw.unit() - 1;
      const double angle = 6.283185307179586 * draw.unit();
      const double r = std::sqrt(std::max(0.0, 1 - z * z));
      return {r * std::cos(angle), r * std::sin(angle), z};
    }
  }
}

double pushed(Draw& draw, double x) {
  switch (draw.below(4)) {
    case 0: return std::nextafter(x, HUGE_VAL);
    case 1: return std::nextafter(x, -HUGE_VAL);
    case 2: return x + (draw.below(2) == 0 ? 5e-324 : -5e-324);
    default: return x * (1 + 1e-9 * (draw.unit() - 0.5));
  }
}

Mesh mesh(Draw& draw) {
  while (true) {
    const std::size_t kind = draw.below(7);
    std::vector<Vector<double>> points;
    for (std::size_t n = 4 + draw.below(6); points.size() < n;) points.push_back(corner(draw, kind));
    Mesh out{.mesh = hull(points), .inwards = draw.below(8) != 0};
    if (out.mesh.triangles.empty()) continue;
    // Some of the triangles only: an open surface; and vertices pushed by a little.
    if (draw.below(3) == 0) {
      const std::size_t left = 1 + draw.below(out.mesh.triangles.size());
      out.mesh.triangles.resize(left), out.mesh.group.resize(left), out.mesh.face.resize(left);
    }
    for (std::size_t k = draw.below(3); k-- > 0;) {
      Vector<double>& v = out.mesh.vertices[draw.below(out.mesh.vertices.size())];
      double& x = draw.below(3) == 0 ? v.x : draw.below(2) == 0 ? v.y : v.z;
      x = pushed(draw, x);
    }
    const bool degenerate =
        std::any_of(out.mesh.triangles.begin(), out.mesh.triangles.end(), [&](const VertexTriple& t) {
          const Point a = exact(out.mesh.vertices[t[0]]);
          const Point n =
              crossed(minus(exact(out.mesh.vertices[t[1]]), a), minus(exact(out.mesh.vertices[t[2]]), a));
          return n[0] == 0 && n[1] == 0 && n[2] == 0;
        });
    if (!degenerate) return out;
  }
}

std::string text(const Mesh& m) {
  std::string out = m.inwards ? "against the cross products" : "along the cross products";
  for (const Vector<double>& v : m.mesh.vertices)
    out += "\nv " + shortest(v.x) + " " + shortest(v.y) + " " + shortest(v.z);
  for (const VertexTriple& t : m.mesh.triangles)
    out += "\nt " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]);
  return out;
}

// A vertex that no triangle has is no point of the surface.
Judgement judge(const Mesh& m) {
  std::vector<char> used(m.mesh.vertices.size(), 0);
  for (const VertexTriple& t : m.mesh.triangles)
    for (const std::size_t v : t) used[v] = 1;
  std::size_t behind = 0;
  for (const VertexTriple& t : m.mesh.triangles) {
    const Point a = exact(m.mesh.vertices[t[0]]);
    Point n = crossed(minus(exact(m.mesh.vertices[t[1]]), a), minus(exact(m.mesh.vertices[t[2]]), a));
    if (m.inwards) n = {-n[0], -n[1], -n[2]};
    for (std::size_t v = 0; v < used.size(); ++v)
      if (used[v] && product(n, minus(exact(m.mesh.vertices[v]), a)).sign() < 0) ++behind;
  }
  const ConvexContainment found = convex_containment(
      m.mesh, m.inwards ? Orientation::against_the_cross_product : Orientation::along_the_cross_product, 0);
  if (found.verdict == Containment::undecided) return Judgement::refused();
  if ((found.verdict == Containment::certified) != (behind == 0))
    return Judgement::violated(containment_word(found.verdict) + ", but " + std::to_string(behind) +
                               " pairs of a vertex behind a plane");
  if (found.verdict == Containment::certified) return Judgement::held();
  if (!found.witness) return Judgement::violated("refuted without a witness");
  const ContainmentWitness& w = *found.witness;
  const VertexTriple& t = m.mesh.triangles.at(w.triangle);
  const Point a = exact(m.mesh.vertices[t[0]]);
  const Point b = exact(m.mesh.vertices[t[1]]);
  const Point c = exact(m.mesh.vertices[t[2]]);
  Point n = crossed(minus(b, a), minus(c, a));
  if (m.inwards) n = {-n[0], -n[1], -n[2]};
  const Point p{w.p.x, w.p.y, w.p.z};
  const Point q{w.q.x, w.q.y, w.q.z};
  const bool is_centroid =
      3 * p[0] == a[0] + b[0] + c[0] && 3 * p[1] == a[1] + b[1] + c[1] && 3 * p[2] == a[2] + b[2] + c[2];
  if (!is_centroid || q != exact(m.mesh.vertices.at(w.vertex)) || product(n, minus(q, p)).sign() >= 0)
    return Judgement::violated("the witness is none");
  return Judgement::held();
}

std::vector<Mesh> smaller(const Mesh& m) {
  std::vector<Mesh> out;
  for (std::size_t k = 0; k < m.mesh.triangles.size() && m.mesh.triangles.size() > 1; ++k) {
    Mesh other = m;
    const auto at = static_cast<std::ptrdiff_t>(k);
    other.mesh.triangles.erase(other.mesh.triangles.begin() + at);
    other.mesh.group.pop_back(), other.mesh.face.pop_back();
    out.push_back(std::move(other));
  }
  return out;
}

TEST(ConvexityAttack, OfMeshes) {
  const Attack<Mesh> attack{.name = "convexity of meshes",
                            .usual_instances = 1500,
                            .make = mesh,
                            .judge = [](const Mesh& m) { return judge(m); },
                            .text = [](const Mesh& m) { return text(m); },
                            .smaller = smaller};
  EXPECT_EQ(hold(attack).violated, 0U);
}

// Surfaces of the catalogue with parameters at the ends of their ranges.
struct Named {
  std::size_t surface = 0;
  std::vector<Rational> values;
  std::uint64_t seed = 0;
};

Rational extreme(Draw& draw) {
  switch (draw.below(6)) {
    case 0: return 1 / power(Rational(10), static_cast<int>(draw.below(13)));
    case 1: return power(Rational(10), static_cast<int>(draw.below(7)));
    case 2: return 1 - 1 / power(Rational(10), 1 + static_cast<int>(draw.below(13)));
    case 3: return Rational(1 + static_cast<long>(draw.below(20)));
    default: return Rational(1 + static_cast<long>(draw.below(99)), 100);
  }
}

Named named(Draw& draw) {
  const auto& catalogue = surface_catalogue();
  while (true) {
    Named out{.surface = draw.below(catalogue.size()), .values = {}, .seed = draw.bits()};
    const SurfaceDescription& description = catalogue[out.surface];
    if (description.parameters.empty() && draw.below(8) != 0) continue;
    for (const ParameterDescription& parameter : description.parameters) {
      Rational value = Rational::parse(parameter.default_text).value();
      for (int tries = 0; tries < 20; ++tries) {
        const Rational other = extreme(draw);
        if (!parameter.admits(other)) continue;
        value = other;
        break;
      }
      out.values.push_back(value);
    }
    return out;
  }
}

std::string text(const Named& n) {
  const SurfaceDescription& description = surface_catalogue()[n.surface];
  std::string out = description.name;
  for (std::size_t k = 0; k < n.values.size(); ++k)
    out += ", " + description.parameters[k].name + " = " + n.values[k].to_text();
  return out + ", seed " + std::to_string(n.seed);
}

// A point of the domain that is a fraction: on sides and at corners too.
ParameterPoint<Rational> place(Draw& draw, ChartDomain domain) {
  while (true) {
    const auto coordinate = [&] { return Rational(static_cast<long>(draw.below(9)), 8); };
    ParameterPoint<Rational> at{coordinate(), coordinate()};
    if (domain == ChartDomain::unit_square || at.s + at.t <= 1) return at;
  }
}

// Points of the charts at 512 bits, normals by differences of them: nothing that the certificate rests on but
// the points.
Judgement judge(const Named& n) {
  const SurfaceDescription& description = surface_catalogue()[n.surface];
  const Surface surface = description.make(n.values);
  const ConvexContainment found = convex_containment(surface, {.boxes_a_pair = 300, .boxes = 1000});
  if (found.verdict == Containment::undecided) return Judgement::refused();
  const BallPrecision scope(512);
  if (found.verdict == Containment::refuted) {
    if (!found.chart_witness) return Judgement::violated("refuted without a witness");
    const ChartWitness& w = *found.chart_witness;
    const auto point = [&](std::size_t chart, const ParameterPoint<Rational>& at) {
      return surface.charts.at(chart).in<Ball>().frame({Ball(at.s), Ball(at.t)});
    };
    const auto p = point(w.chart_p, w.at_p);
    const auto q = point(w.chart_q, w.at_q);
    const Ball behind = dot(q.point - p.point, w.inner_normal);
    return certainly_negative(behind) ? Judgement::held() : Judgement::violated("the witness is none");
  }
  Draw draw(n.seed);
  for (int k = 0; k < 40; ++k) {
    const std::size_t at_p = draw.below(surface.chart_count());
    const std::size_t at_q = draw.below(surface.chart_count());
    const auto& p = surface.charts[at_p].in<Ball>();
    const ParameterPoint<Rational> x = place(draw, surface.charts[at_p].facts().domain);
    const ParameterPoint<Rational> y = place(draw, surface.charts[at_q].facts().domain);
    const auto frame = p.frame({Ball(x.s), Ball(x.t)});
    const auto other = surface.charts[at_q].in<Ball>().frame({Ball(y.s), Ball(y.t)});
    if (certainly_negative(dot(other.point - frame.point, frame.area_normal)))
      return Judgement::violated("certified, but chart " + std::to_string(at_q) + " at (" + y.s.to_text() +
                                 ", " + y.t.to_text() + ") is behind chart " + std::to_string(at_p) +
                                 " at (" + x.s.to_text() + ", " + x.t.to_text() + ")");
  }
  return Judgement::held();
}

TEST(ConvexityAttack, OfCharts) {
  const Attack<Named> attack{.name = "convexity of charts",
                             .usual_instances = 20,
                             .make = named,
                             .judge = [](const Named& n) { return judge(n); },
                             .text = [](const Named& n) { return text(n); }};
  EXPECT_EQ(hold(attack).violated, 0U);
}

}  // namespace
}  // namespace radcert::attack
