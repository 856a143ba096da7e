// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/vertex_disks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using test::Draw;
using test::panels_of;

/// The corners of a scene's panels, each once.
std::vector<Vector<double>> vertices_of(const SectorScene& scene) {
  std::vector<Vector<double>> out;
  for (const Sector& sector : scene.sectors()) {
    const bool is_new = std::none_of(out.begin(), out.end(),
                                     [&](const Vector<double>& v) { return norm(v - sector.a) < 1e-9; });
    if (is_new) out.push_back(sector.a);
  }
  return out;
}

double to_nearest(const std::vector<Vector<double>>& vertices, const Vector<double>& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector<double>& v : vertices) least = std::min(least, norm(p - v));
  return least;
}

/// (1/pi) Int G y over the surface near the vertices: a polar rule about each vertex on each sector that has
/// it.
class PolarTransport {
public:
  explicit PolarTransport(const SectorScene& scene) : scene_(scene) {}

  /// For a function y of the distance from the vertex, on 0 < distance < radius; radius below half an edge
  /// and below the distance of the opposite sides.
  double operator()(std::size_t panel, const Vector<double>& p, double radius,
                    const std::function<double(double)>& y) const {
    double sum = 0;
    for (const Sector& sector : scene_.sectors()) {
      if (sector.panel == panel) continue;
      sum += about(sector.a, sector.b - sector.a, sector.c - sector.a, panel, sector.panel, p, radius, y);
      sum += about(sector.b, sector.a - sector.b, sector.c - sector.b, panel, sector.panel, p, radius, y);
    }
    return sum * std::numbers::inv_pi;
  }

private:
  double about(const Vector<double>& vertex, const Vector<double>& along, const Vector<double>& inwards,
               std::size_t observer, std::size_t panel, const Vector<double>& p, double radius,
               const std::function<double(double)>& y) const {
    const Vector<double> e = (1 / norm(along)) * along;
    const Vector<double> off = inwards - dot(inwards, e) * e;
    const Vector<double> f = (1 / norm(off)) * off;
    const double angle = std::atan2(norm(off), dot(inwards, e));
    constexpr int n = 60;
    double sum = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double q = radius * (i + 0.5) / n;
        const double phi = angle * (j + 0.5) / n;
        const Vector<double> at = vertex + q * (std::cos(phi) * e + std::sin(phi) * f);
        const Vector<double> way = at - p;
        const double kernel = dot(scene_.normal(observer), way) * -dot(scene_.normal(panel), way) /
                              (dot(way, way) * dot(way, way));
        sum += std::max(0.0, kernel) * y(q) * q * (radius / n) * (angle / n);
      }
    return sum;
  }

  const SectorScene& scene_;
};

class VertexDisksOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Polyhedra, VertexDisksOf, testing::Values("cube", "tetrahedron", "octahedron"));

TEST_P(VertexDisksOf, BoundWhatPointsSee) {
  const SectorScene scene(panels_of(GetParam()));
  const VertexDisks disks(scene);
  const PolarTransport transport(scene);
  const std::vector<Vector<double>> vertices = vertices_of(scene);
  Draw draw(3);
  double largest_quotient = 0;
  for (int k = 0; k < 400; ++k) {
    const Sector& sector = scene.sectors()[draw.below(scene.sectors().size())];
    const double t = std::exp2(-1 - 8 * draw());
    const double s = 0.5 * std::exp2(-7 * draw());
    const Vector<double> p = sector.point(s, t);
    const double distance = to_nearest(vertices, p);
    const double radius = std::min(disks.largest_radius(), distance * (0.1 + 0.8 * draw()));
    const double bound = disks.mass(radius, distance);
    const double seen = transport(sector.panel, p, radius, [](double) { return 1.0; });
    EXPECT_LE(seen, bound * 1.02) << distance << " " << radius;
    largest_quotient = std::max(largest_quotient, seen / bound);
  }
  EXPECT_GT(largest_quotient, 0.2);
}

TEST_P(VertexDisksOf, KnowHowFarBoxesAreFromVertices) {
  const SectorScene scene(panels_of(GetParam()));
  const VertexDisks disks(scene);
  const std::vector<Vector<double>> vertices = vertices_of(scene);
  Draw draw(4);
  for (int k = 0; k < 200; ++k) {
    const Sector& sector = scene.sectors()[draw.below(scene.sectors().size())];
    SectorBox box{.s0 = draw(), .t0 = 0.9 * draw()};
    box.s1 = box.s0 + (1 - box.s0) * draw();
    box.t1 = box.t0 + (1 - box.t0) * draw();
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0;
    for (int i = 0; i <= 6; ++i)
      for (int j = 0; j <= 6; ++j) {
        const Vector<double> p =
            sector.point(box.s0 + (box.s1 - box.s0) * i / 6, box.t0 + (box.t1 - box.t0) * j / 6);
        nearest = std::min(nearest, to_nearest(vertices, p));
        farthest = std::max(farthest, to_nearest(vertices, p));
      }
    EXPECT_LE(disks.distance_at_least(sector, box), nearest);
    EXPECT_GE(disks.distance_at_most(sector, box), farthest);
  }
}

/// A panel with these corners, seen from a point within the body.
Panel panel_of(std::vector<Vector<Rational>> corners, const Vector<Rational>& within) {
  if (dot(cross(corners[1] - corners[0], corners[2] - corners[0]), within - corners[0]).sign() < 0)
    std::reverse(corners.begin(), corners.end());
  Vector<Rational> sum = corners[0];
  for (std::size_t i = 1; i < corners.size(); ++i) sum = sum + corners[i];
  return {.piece = 0,
          .corners = corners,
          .centre = Rational(1, static_cast<int>(corners.size())) * sum,
          .normal = cross(corners[1] - corners[0], corners[2] - corners[0])};
}

TEST(VertexDisks, CountAVertexSeenFromBelowWhole) {
  // The base of a flat pyramid sees all about the apex, head on.
  const auto corner = [](int x, int y, int z) {
    return Vector<Rational>{Rational(x), Rational(y), Rational(z)};
  };
  const Vector<Rational> within{Rational(0), Rational(0), Rational(1, 2)};
  const std::vector<Vector<Rational>> base{corner(40, 40, 0), corner(-40, 40, 0), corner(-40, -40, 0),
                                           corner(40, -40, 0)};
  std::vector<Panel> panels{panel_of(base, within)};
  for (std::size_t k = 0; k < 4; ++k)
    panels.push_back(panel_of({base[k], base[(k + 1) % 4], corner(0, 0, 1)}, within));
  const SectorScene scene(panels);
  const VertexDisks disks(scene);
  const Vector<double> below = scene.place({Rational(0), Rational(0), Rational(0)});
  for (const double radius : {0.25, 0.025}) {
    // (1/pi) Int_0^a 2 pi q/(1+q^2)^2 dq about.
    const double seen = PolarTransport(scene)(0, below, radius, [](double) { return 1.0; });
    const double bound = disks.mass(radius, 40);
    EXPECT_LE(seen, bound * (1 + 1e-3)) << radius;
    EXPECT_GT(seen, 0.5 * bound) << radius;
    EXPECT_LT(bound, 1) << radius;
  }
}

TEST(VertexDisks, SeeNothingOfFarVertices) {
  const SectorScene scene(panels_of("cube"));
  const VertexDisks disks(scene);
  EXPECT_LT(disks.mass(1e-4, 0.25), 1e-6);
  // Half of a small cone is 2/(3 pi) (a/r)^3; four vertices lie at the height 1.
  EXPECT_NEAR(disks.mass(1e-4, 1e-2), 2 / (3 * std::numbers::pi) * 1e-6 + 4e-8, 1e-9);
}

TEST(VertexDisks, SendHalfAtMostToPointsBesideThem) {
  const SectorScene scene(panels_of("cube"));
  const VertexDisks disks(scene);
  EXPECT_EQ(disks.mass(0.1 * (1 + 1e-15), 0.1), 1);
  // The other three corners of a face are 1/2 or more away, and four lie above it.
  EXPECT_NEAR(disks.mass(0.1, 0.1), 0.5 + 3 * 2 / (3 * std::numbers::pi) * std::pow(0.2, 3) + 4 * 0.01, 2e-4);
  for (const double x : {1e-8, 1e-4, 0.1, 0.5, 0.9, 0.999}) {
    const double alpha = std::asin(x);
    const double phi = (alpha - std::sin(alpha) * std::cos(alpha)) / std::numbers::pi;
    const double mass = disks.mass(1e-3 * x, 1e-3);
    EXPECT_GE(mass, phi * (1 - 1e-14)) << x;
    EXPECT_LE(mass, phi + 1e-15 * x + 5e-6 * x * x) << x;
  }
}

TEST(Supersolution, IsTheGeometricSeriesOfAConstant) {
  const SectorScene scene(panels_of("cube"));
  const VertexDisks disks(scene);
  const std::vector<double> radii{0.1, 0.05, 0.01};
  const std::vector<double> residuals(4, 2.0);
  for (const double gap : {1.0, 0.5, 0.1}) {
    for (const double z : supersolution(disks, radii, residuals, gap)) {
      EXPECT_GE(z, 2 * (1 - gap) / gap);
      EXPECT_LE(z, 2 * (1 - gap) / gap * (1 + 1e-6) + 1e-12);
    }
  }
}

TEST_P(VertexDisksOf, GiveASupersolution) {
  // z >= s T (R + z) at points at every distance, with a rule of its own: what is large sits at the vertices.
  const SectorScene scene(panels_of(GetParam()));
  const VertexDisks disks(scene);
  const PolarTransport transport(scene);
  const std::vector<Vector<double>> vertices = vertices_of(scene);
  std::vector<double> radii;
  for (double radius = disks.largest_radius(); radius > 1e-3; radius *= std::exp2(-0.25))
    radii.push_back(radius);
  std::vector<double> residuals(radii.size() + 1, 1e-3);
  for (std::size_t m = radii.size() - 8; m < residuals.size(); ++m) residuals[m] = 1;
  for (const double s : {0.5, 0.8}) {
    const std::vector<double> z = supersolution(disks, radii, residuals, 1 - s);
    const auto shell = [&](double distance) {
      return static_cast<std::size_t>(
          std::find_if(radii.begin(), radii.end(), [&](double r) { return r <= distance; }) - radii.begin());
    };
    const auto y = [&](double q) { return residuals[shell(q)] + z[shell(q)]; };
    // It falls off, as what is seen of the vertices does.
    EXPECT_LT(z[0], (s < 0.6 ? 0.1 : 0.6) * z.back());
    Draw draw(6);
    double closest = 0;
    for (int k = 0; k < 300; ++k) {
      const Sector& sector = scene.sectors()[draw.below(scene.sectors().size())];
      const Vector<double> p = sector.point(0.5 * std::exp2(-10 * draw()), std::exp2(-1 - 10 * draw()));
      const double distance = to_nearest(vertices, p);
      // The polar rule needs a point that is not close to what it integrates over.
      const double reach = std::min(0.7 * distance, disks.largest_radius());
      const double sent = s * transport(sector.panel, p, reach, y);
      EXPECT_LE(sent, z[shell(distance)] * 1.02);
      closest = std::max(closest, sent / z[shell(distance)]);
    }
    EXPECT_GT(closest, 0.05);
  }
}

}  // namespace
}  // namespace radcert
