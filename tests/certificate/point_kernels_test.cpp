// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/point_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "tests/certificate/samples.h"

namespace radcert::certificate {
namespace {

using test::Draw;

struct Kernels {
  PolyhedronCertificate c;
  Scene scene;
  Densities densities;
  Sight sight;
  PointKernels kernels;
  explicit Kernels(const std::string& surface)
      : c(test::furnace_value_certificate(surface, 0.25, 1.2, 0.02)),
        scene(c),
        densities(c),
        sight(c, scene),
        kernels(c, scene, densities, sight) {}

  [[nodiscard]] std::size_t triangle(const Element& x) const { return scene.triangle(x.face, x.side); }
  [[nodiscard]] double value(const Element& x, double s, double t) const {
    return test::point_kernel(c, c.points[0], x.face, test::element_point(c, x, s, t));
  }
};

TEST(PointKernels, AreTheKernelAtPoints) {
  Draw draw(51);
  for (const std::string name : {"tetrahedron", "cube", "octahedron", "box"}) {
    const Kernels of(name);
    ASSERT_EQ(of.kernels.count(), 1U);
    for (const Element& x : of.c.elements) {
      const double s = x.s0 + (x.s1 - x.s0) * draw();
      const double t = x.t0 + (x.t1 - x.t0) * draw();
      const BoundedDouble found =
          of.kernels.at(0, of.triangle(x), BoundedDouble::exactly(s), BoundedDouble::exactly(t));
      const double expected = x.face == of.c.points[0].face ? 0 : of.value(x, s, t);
      EXPECT_NEAR(found.value(), expected, found.error() + 1e-12 * expected) << name;
      EXPECT_LE(found.error(), 1e-9 * (1 + expected));
    }
  }
}

TEST(PointKernels, HaveTheirSizeOnBoxes) {
  Draw draw(52);
  double closest = 0;
  for (const std::string name : {"tetrahedron", "cube", "octahedron"}) {
    const Kernels of(name);
    for (const Element& x : of.c.elements) {
      const double size =
          of.kernels.size(0, of.triangle(x), {.s0 = x.s0, .s1 = x.s1, .t0 = x.t0, .t1 = x.t1});
      if (x.face == of.c.points[0].face) {
        EXPECT_EQ(size, 0);
        continue;
      }
      for (int k = 0; k < 20; ++k) {
        const double value = of.value(x, x.s0 + (x.s1 - x.s0) * draw(), x.t0 + (x.t1 - x.t0) * draw());
        EXPECT_LE(value, size) << name;
        closest = std::max(closest, value / size);
      }
    }
  }
  EXPECT_GT(closest, 0.2);
}

/// |Int f P_n| sqrt(2n+1)/2 is at most the distance of f from polynomials of degree n - 1, as Int |P_n| is at
/// most 2/sqrt(2n+1).
TEST(PointKernels, BoundWhatPolynomialsLeave) {
  double closest = 0;
  const GaussRule& rule = gauss_rule(20);
  for (const std::string name : {"tetrahedron", "cube", "octahedron"}) {
    const Kernels of(name);
    for (const Element& x : of.c.elements) {
      if (x.face == of.c.points[0].face) continue;
      const Box box{.s0 = x.s0, .s1 = x.s1, .t0 = x.t0, .t1 = x.t1};
      const std::vector<Seen> seen(1, Seen::whole);
      for (const bool in_s : {true, false}) {
        const PolynomialErrors left = of.kernels.left(of.triangle(x), box, in_s, seen);
        for (const double other : {-1.0, 0.0, 0.7}) {
          const double s = box.middle_s() + 0.5 * (x.s1 - x.s0) * other;
          const double t = box.middle_t() + 0.5 * (x.t1 - x.t0) * other;
          for (int n = 1; n <= 12; ++n) {
            double sum = 0;
            for (std::size_t k = 0; k < rule.near_nodes.size(); ++k) {
              const double at = rule.near_nodes[k];
              const double f = in_s ? of.value(x, box.middle_s() + 0.5 * (x.s1 - x.s0) * at, t)
                                    : of.value(x, s, box.middle_t() + 0.5 * (x.t1 - x.t0) * at);
              sum += rule.near_weights[k] * f * legendre(n, at).back();
            }
            const double least = std::abs(sum) * std::sqrt(2 * n + 1.0) / 2;
            EXPECT_LE(least, left[static_cast<std::size_t>(n - 1)] + 1e-14) << name << " " << n;
            closest = std::max(closest, least / left[static_cast<std::size_t>(n - 1)]);
          }
        }
      }
    }
  }
  EXPECT_GT(closest, 0.02);
}

/// On the borders of ellipses about lines of a box, by complex arithmetic.
TEST(PointKernels, HaveBoundsOnEllipses) {
  using Complex = std::complex<double>;
  Draw draw(53);
  double closest = 0;
  for (const std::string name : {"tetrahedron", "cube", "octahedron"}) {
    const Kernels of(name);
    const Point& point = of.c.points[0];
    for (const Element& x : of.c.elements) {
      if (x.face == point.face) continue;
      const Box box{.s0 = x.s0, .s1 = x.s1, .t0 = x.t0, .t1 = x.t1};
      for (const bool in_s : {true, false}) {
        const EllipseBounds bounds = of.kernels.on_ellipses(0, of.triangle(x), box, in_s);
        for (int line = 0; line < 4; ++line) {
          const double s = x.s0 + (x.s1 - x.s0) * draw();
          const double t = x.t0 + (x.t1 - x.t0) * draw();
          const Vector<double> from = test::element_point(of.c, x, in_s ? x.s0 : s, in_s ? t : x.t0);
          const Vector<double> to = test::element_point(of.c, x, in_s ? x.s1 : s, in_s ? t : x.t1);
          const Vector<double> middle = 0.5 * (from + to);
          const Vector<double> half = 0.5 * (to - from);
          for (std::size_t k = 0; k < ellipse_axes.size(); ++k) {
            if (!std::isfinite(bounds[k])) continue;
            const double axis = ellipse_axes[k];
            for (int n = 0; n < 12; ++n) {
              const double angle = 6.283185307179586 * draw();
              const Complex z(axis * std::cos(angle), std::sqrt(axis * axis - 1) * std::sin(angle));
              const double found = std::abs(test::point_kernel(of.c, point, x.face, middle, half, z));
              EXPECT_LE(found, bounds[k] * (1 + 1e-12)) << name << " " << axis;
              closest = std::max(closest, found / bounds[k]);
            }
          }
        }
      }
    }
  }
  EXPECT_GT(closest, 0.3);
}

TEST(PointKernels, AreOfPointsInsideTheirFacesAlone) {
  PolyhedronCertificate c = test::furnace_value_certificate("cube", 0.25, 1.2, 0.02);
  EXPECT_FALSE(points_fault(c));
  const std::vector<Vector<Rational>>& p = c.faces[1].corners;
  for (const Vector<Rational>& wrong :
       {p[0], Rational(1, 2) * (p[0] + p[1]), p[0] - Rational(1, 9) * (p[1] - p[0]),
        Rational(1, 2) * (c.faces[0].corners[0] + c.faces[0].corners[2])}) {
    c.points[0].at = wrong;
    EXPECT_TRUE(points_fault(c));
  }
}

/// Faces of a room are cut: on lines and at corners of parts that have others all about them points are
/// inside, on edges and at the corners of the room they are not.
TEST(PointKernels, AreOfPointsBetweenFacesOfOnePlane) {
  PolyhedronCertificate c = test::bare_certificate("cube_in_a_cube", 2, 0, 1);
  const auto is_on = [](const Face& face) {
    return std::all_of(face.corners.begin(), face.corners.end(),
                       [](const Vector<Rational>& p) { return p.z.sign() == 0; });
  };
  const Rational half(1, 2);
  const Rational third(4, 3);
  const auto is_inside = [&](const Rational& x, const Rational& y) {
    int found = 0;
    for (std::size_t f = 0; f < c.faces.size(); ++f) {
      if (!is_on(c.faces[f])) continue;
      c.points = {{.face = f, .at = {x, y, 0}}};
      if (!points_fault(c)) ++found;
    }
    return found;
  };
  EXPECT_EQ(is_inside(half, third), 1);
  EXPECT_EQ(is_inside(1, third), 2);
  EXPECT_EQ(is_inside(half, 2), 2);
  EXPECT_EQ(is_inside(1, 2), 4);
  for (const Rational& other : {half, Rational(1), Rational(3)}) {
    EXPECT_EQ(is_inside(0, other), 0);
    EXPECT_EQ(is_inside(other, 3), 0);
  }
  EXPECT_EQ(is_inside(4, 1), 0);
  // Where a corner of another face touches the floor.
  for (const Vector<Rational>& at :
       {Vector<Rational>{half, third, 0}, Vector<Rational>{1, third, 0}, Vector<Rational>{1, 2, 0}}) {
    c.faces.push_back(c.faces.front());
    c.faces.back().corners = {at, at + Vector<Rational>{1, 0, 1}, at + Vector<Rational>{0, 1, 1}};
    EXPECT_EQ(is_inside(at.x, at.y), 0);
    // A face that looks the other way.
    c.faces.back().corners = {at, at + Vector<Rational>{0, 1, 0}, at + Vector<Rational>{1, 0, 0}};
    EXPECT_EQ(is_inside(at.x, at.y), 0);
    c.faces.pop_back();
  }
}

}  // namespace
}  // namespace radcert::certificate
