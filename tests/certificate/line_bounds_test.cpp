// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/line_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>

#include "radcert/certificate/ball_transport.h"
#include "radcert/certificate/gauss_rule.h"
#include "tests/certificate/bench.h"
#include "tests/certificate/samples.h"

namespace radcert::certificate {
namespace {

using radcert::test::bare_certificate;
using radcert::test::Draw;
using test::Bench;

/// A part of an element at an edge, and near it.
Box drawn_box(const Element& x, Draw& draw) {
  const double width = (x.s1 - x.s0) * std::exp2(-6 * draw());
  const double from = x.s0 + (x.s1 - x.s0 - width) * draw();
  if (x.t0 > 0 || draw() < 0.2) {
    const double depth = (x.t1 - x.t0) * std::exp2(-4 * draw());
    const double at = x.t0 + (x.t1 - x.t0 - depth) * (0.1 + 0.9 * draw());
    return {.s0 = from, .s1 = from + width, .t0 = at, .t1 = at + depth};
  }
  const double top = x.t1 * std::exp2(-12 * draw());
  return {.s0 = from, .s1 = from + width, .t0 = top / 4, .t1 = top};
}

using Complex = std::complex<double>;

/// T_j w_k at the complex point P(s,t), s or t complex, by rules on small parts of each element.
Complex sent(const Bench& bench, std::size_t e, Complex s, Complex t, std::size_t face, std::size_t k) {
  const SideTriangle& own = bench.lines.triangle(e);
  const Vector<double>& normal = bench.scene.normal(own.face);
  const Vector<double>& other_normal = bench.scene.normal(face);
  const auto coordinate = [&](double a, double along, double inward) {
    return a + s * (1.0 - t) * along + t * inward;
  };
  const std::array<Complex, 3> p{coordinate(own.a.x, own.along.x, own.inward.x),
                                 coordinate(own.a.y, own.along.y, own.inward.y),
                                 coordinate(own.a.z, own.along.z, own.inward.z)};
  const GaussRule& rule = gauss_rule(10);
  Complex sum = 0;
  for (const std::size_t y : bench.lines.elements_of(face)) {
    if (bench.densities.size_of(y, k) < 1e-12) continue;
    const Element& x = bench.c.elements[y];
    const SideTriangle& triangle = bench.lines.triangle(y);
    constexpr int parts = 4;
    for (int i = 0; i < parts * parts; ++i)
      for (std::size_t m = 0; m < rule.near_nodes.size(); ++m)
        for (std::size_t l = 0; l < rule.near_nodes.size(); ++l) {
          const double x_at = (2 * (i % parts) + 1 + rule.near_nodes[m]) / parts - 1;
          const double y_at = (2 * (i / parts) + 1 + rule.near_nodes[l]) / parts - 1;
          const double at_s = 0.5 * (x.s0 + x.s1) + 0.5 * (x.s1 - x.s0) * x_at;
          const double at_t = 0.5 * (x.t0 + x.t1) + 0.5 * (x.t1 - x.t0) * y_at;
          const Vector<double> q = triangle.point(at_s, at_t);
          const std::array<Complex, 3> d{q.x - p[0], q.y - p[1], q.z - p[2]};
          const Complex squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
          const Complex before = d[0] * normal.x + d[1] * normal.y + d[2] * normal.z;
          const Complex height = -(d[0] * other_normal.x + d[1] * other_normal.y + d[2] * other_normal.z);
          const std::vector<double> p_x = legendre(bench.densities.degree(), x_at);
          const std::vector<double> p_y = legendre(bench.densities.degree(), y_at);
          double w = 0;
          for (std::size_t a = 0; a < bench.densities.powers(); ++a)
            for (std::size_t b = 0; b < bench.densities.powers(); ++b)
              w += bench.densities.w(y)[(a * bench.densities.powers() + b) * bench.densities.stride() + k] *
                   p_x[a] * p_y[b];
          const double weight = triangle.jacobian * (1 - at_t) * 0.25 * (x.s1 - x.s0) * (x.t1 - x.t0) /
                                (parts * parts) * rule.near_weights[m] * rule.near_weights[l];
          sum += weight * w * before * height / (squared * squared) * std::numbers::inv_pi;
        }
  }
  return sum;
}

/// w_0 = 1 on one element, and 0 on all others; all other functions are 0.
PolyhedronCertificate lonely(PolyhedronCertificate c, std::size_t element) {
  for (Face& face : c.faces) face.emission = {{Rational(0)}};
  const std::size_t size = c.powers() * c.powers();
  std::fill(c.coefficients.begin(), c.coefficients.end(), 0.0);
  c.coefficients[element * size] = 2;
  for (std::size_t e = 0; e < c.elements.size(); ++e)
    c.coefficients[((1 + c.faces[c.elements[e].face].piece) * c.elements.size() + e) * size] = -1;
  return c;
}

/// The face whose w_0 is not 0, if only one is.
std::size_t lonely_face(const Bench& bench, std::size_t otherwise) {
  for (std::size_t e = 0; e < bench.c.elements.size(); ++e)
    if (bench.densities.size_of(e, 0) > 0.5) return bench.c.elements[e].face;
  return otherwise;
}

/// On ellipses that do not reach the face, where the integral is that over real points; from one small
/// element alone, whose distance counts, and from whole faces.
TEST(LineBounds, HoldAtComplexPoints) {
  double closest = 0;
  double closest_slid = 0;
  int tried = 0;
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const PolyhedronCertificate whole = bare_certificate(name, 3, 0, 21);
    std::optional<Bench> made;
    Draw draw(22);
    for (int n = 0; n < 400; ++n) {
      const std::size_t source = draw.below(whole.elements.size());
      if (n % 8 == 0) made.emplace(n % 16 == 0 ? bare_certificate(name, 2, 1, 21) : lonely(whole, source));
      const Bench& bench = *made;
      const std::size_t e = draw.below(bench.c.elements.size());
      const Element& x = bench.c.elements[e];
      const double width = (x.s1 - x.s0) * std::exp2(-5 * draw());
      const double from = x.s0 + (x.s1 - x.s0 - width) * draw();
      const double depth = (x.t1 - x.t0) * std::exp2(-5 * draw());
      const double below = std::max(x.t0, 0.05) + (x.t1 - depth - std::max(x.t0, 0.05)) * draw();
      const Box box{.s0 = from, .s1 = from + width, .t0 = below, .t1 = below + depth};
      if (!(box.t1 <= x.t1 && box.t0 < box.t1)) continue;
      const SideTriangle& own = bench.lines.triangle(e);
      const bool in_s = draw() < 0.6;
      const std::size_t face =
          n % 16 < 8 ? draw.below(bench.scene.faces()) : lonely_face(bench, draw.below(bench.scene.faces()));
      if (bench.scene.coplanar(face, own.face)) continue;
      const EllipseBounds bounds = bench.lines.on_ellipses(e, box, in_s, face);
      const std::size_t axis = draw.below(10);
      const double angle = 2 * std::numbers::pi * draw();
      const Complex z(ellipse_axes[axis] * std::cos(angle),
                      std::sqrt(ellipse_axes[axis] * ellipse_axes[axis] - 1) * std::sin(angle));
      const double across = draw();
      const double real_s = box.s0 + width * across;
      const double real_t = box.t0 + depth * across;
      const Complex s = in_s ? box.middle_s() + 0.5 * width * z : Complex(real_s);
      const Complex t = in_s ? Complex(real_t) : box.middle_t() + 0.5 * depth * z;
      // How far the point is from its line, against the distance of the face.
      const double half =
          in_s ? 0.5 * width * own.length : 0.5 * depth * norm(own.inward - real_s * own.along);
      double distance = 1e9;
      for (const std::size_t y : bench.lines.elements_of(face)) {
        const Element& other = bench.c.elements[y];
        const Quadrilateral quadrilateral(bench.lines.triangle(y), bench.scene.normal(face),
                                          {other.s0, other.s1, other.t0, other.t1});
        distance = std::min(distance, quadrilateral.distance(in_s ? own.point(box.middle_s(), real_t)
                                                                  : own.point(real_s, box.middle_t())));
      }
      if (!(half * ellipse_axes[axis] < 0.8 * distance) || !(bounds[axis] < 1e6)) continue;
      ++tried;
      for (std::size_t k = 0; k < 2; ++k) {
        if (bench.densities.vanishes(k)) continue;
        const double size = std::abs(sent(bench, e, s, t, face, k));
        EXPECT_LE(size, bounds[axis] * (1 + 1e-6))
            << name << " " << e << " axis " << ellipse_axes[axis] << " " << n;
        closest = std::max(closest, size / bounds[axis]);
        if (in_s && bench.scene.parallel(bench.lines.triangle_place(e), face))
          closest_slid = std::max(closest_slid, size / bounds[axis]);
      }
    }
  }
  EXPECT_GT(tried, 60);
  EXPECT_GT(closest, 0.3);
  EXPECT_GT(closest_slid, 0.1);
}

/// What interpolation at Gauss nodes of a line leaves of T w_k there is at most (1 + n) times the bound.
TEST(LineBounds, HoldForInterpolantsOnLines) {
  double closest = 0;
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const Bench bench(bare_certificate(name, 3, 2, 11));
    Draw draw(12);
    for (int tried = 0; tried < 60; ++tried) {
      const std::size_t e = draw.below(bench.c.elements.size());
      const Box box = drawn_box(bench.c.elements[e], draw);
      for (const bool in_s : {true, false}) {
        const PolynomialErrors left = bench.lines.left(e, box, in_s, nullptr);
        const double across = draw();
        const auto observers = [&](const std::vector<double>& at) {
          Observers out{.triangle = bench.lines.triangle_place(e), .s = {}, .t = {}};
          for (const double x : at) {
            const double along = 0.5 * (1 + x);
            const double s = box.s0 + (box.s1 - box.s0) * (in_s ? along : across);
            const double t = box.t0 + (box.t1 - box.t0) * (in_s ? across : along);
            out.s.push_back(BoundedDouble::exactly(s));
            out.t.push_back(BoundedDouble::exactly(t));
          }
          return out;
        };
        for (const int n : {1, 2, 4}) {
          const double bound = left[static_cast<std::size_t>(n - 1)];
          if (!(bound < 1e3)) continue;
          const GaussRule& rule = gauss_rule(n);
          const BallTransport::Values at_nodes =
              bench.transport(observers(rule.near_nodes), 1e-10, std::nullopt);
          const std::vector<double> places{-1, -0.7, 0.1, 0.5, 1};
          const BallTransport::Values between = bench.transport(observers(places), 1e-10, std::nullopt);
          const std::size_t stride = bench.densities.stride();
          for (std::size_t p = 0; p < places.size(); ++p)
            for (std::size_t k = 0; k < bench.densities.count(); ++k) {
              double interpolant = 0;
              double radius = between.radii[p];
              for (int i = 0; i < n; ++i) {
                double basis = 1;
                for (int j = 0; j < n; ++j) {
                  const auto [x, y] = std::pair(rule.near_nodes[static_cast<std::size_t>(i)],
                                                rule.near_nodes[static_cast<std::size_t>(j)]);
                  if (i != j) basis *= (places[p] - y) / (x - y);
                }
                const auto at = static_cast<std::size_t>(i);
                interpolant += basis * at_nodes.values[at * stride + k];
                radius += std::abs(basis) * at_nodes.radii[at];
              }
              const double off = std::abs(between.values[p * stride + k] - interpolant);
              EXPECT_LE(off - radius, (1 + n) * bound)
                  << name << " element " << e << (in_s ? " s " : " t ") << n << " " << box.s0 << " " << box.s1
                  << " " << box.t0 << " " << box.t1;
              if (off > 10 * radius) closest = std::max(closest, off / ((1 + n) * bound));
            }
        }
      }
    }
  }
  EXPECT_GT(closest, 0.001);
}

/// |T_j (w - xi)| against the bound of a closing, at a point of the box.
struct Held {
  double off = 0;  ///< the largest of all k
  double radius = 0;
};
Held held(const Bench& bench, std::size_t e, const EdgeClosing& closing, double s, double t) {
  const Observers one{.triangle = bench.lines.triangle_place(e),
                      .s = {BoundedDouble::exactly(s)},
                      .t = {BoundedDouble::exactly(t)}};
  const BallTransport::Values all = bench.transport(one, 1e-8, std::nullopt);
  const BallTransport::Values rest = bench.transport(one, 1e-8, closing.face);
  const Element& y = bench.c.elements[closing.element];
  const double place = closing.at ? closing.at->value() : (2 * (1 - s) - y.s0 - y.s1) / (y.s1 - y.s0);
  const std::vector<double> p = legendre((bench.densities.degree()), place);
  Held out;
  for (std::size_t k = 0; k < bench.densities.count(); ++k) {
    double xi = 0;
    for (std::size_t i = 0; i < bench.densities.powers(); ++i)
      for (std::size_t j = 0; j < bench.densities.powers(); ++j)
        xi += bench.densities.w(
                  closing.element)[(i * bench.densities.powers() + j) * bench.densities.stride() + k] *
              p[i] * (j % 2 == 0 ? 1 : -1);
    const double beyond = all.values[k] - rest.values[k];
    const double one_beyond = 1 - rest.values[bench.densities.constant()];
    out.off = std::max(out.off, std::abs(beyond - xi * one_beyond));
    out.radius = std::max(out.radius, all.radii[0] + (1 + std::abs(xi)) * rest.radii[0]);
  }
  return out;
}

/// At points up to the edge.
TEST(LineBounds, ClosingsHold) {
  double closest = 0;
  int tried = 0;
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const Bench bench(bare_certificate(name, 3, 2, 13));
    Draw draw(14);
    for (int n = 0; n < 400; ++n) {
      const std::size_t e = draw.below(bench.c.elements.size());
      const Element& x = bench.c.elements[e];
      if (x.t0 > 0) continue;
      const double width = (x.s1 - x.s0) * std::exp2(-4 * draw());
      const double from = x.s0 + (x.s1 - x.s0 - width) * draw();
      const Box box{.s0 = from, .s1 = from + width, .t0 = 0, .t1 = x.t1 * std::exp2(-3 - 12 * draw())};
      const std::optional<EdgeClosing> closing = bench.lines.closing(e, box);
      ASSERT_TRUE(closing);
      if (!(closing->beside < 1)) continue;
      ++tried;
      const double s = from + width * draw();
      const double t = box.t1 * (0.05 + 0.95 * draw());
      const Held found = held(bench, e, *closing, s, t);
      EXPECT_LE(found.off - found.radius, closing->beside) << name << " " << e << " " << s << " " << t;
      if (found.off > 10 * found.radius) closest = std::max(closest, found.off / closing->beside);
    }
  }
  EXPECT_GT(tried, 50);
  EXPECT_GT(closest, 0.02);
}

/// Beside ends of the elements beyond, where w jumps from one to the next.
TEST(LineBounds, ClosingsAtEndsHold) {
  double closest = 0;
  int tried = 0;
  for (const std::string name : {"cube", "tetrahedron", "octahedron"}) {
    const Bench bench(bare_certificate(name, 3, 2, 15));
    Draw draw(16);
    for (int n = 0; n < 600; ++n) {
      const std::size_t e = draw.below(bench.c.elements.size());
      const Element& x = bench.c.elements[e];
      if (x.t0 > 0) continue;
      // Parameters of certificates have 40 bits.
      const double width = (x.s1 - x.s0) * std::exp2(-2 - static_cast<double>(draw.below(12)));
      const bool at_start = draw() < 0.5;
      const double from = at_start ? x.s0 : x.s1 - width;
      const double end = at_start ? x.s0 : x.s1;
      if (end == 0 || end == 1) continue;
      const Box box{.s0 = from, .s1 = from + width, .t0 = 0, .t1 = std::exp2(-3 - 14 * draw())};
      EXPECT_EQ(bench.lines.nearest_end(e, box), end);
      const std::optional<EdgeClosing> closing = bench.lines.closing_at_end(e, box);
      ASSERT_TRUE(closing);
      EXPECT_GE(closing->beside, closing->jump);
      if (!(closing->beside < 3)) continue;
      ++tried;
      // On both sides of what bounds the box, and far along it.
      const double s = from + width * (draw() < 0.3 ? (at_start ? 1e-3 : 0.999) : draw());
      const double t = box.t1 * (0.05 + 0.95 * draw());
      const Held found = held(bench, e, *closing, s, t);
      EXPECT_LE(found.off - found.radius, closing->beside) << name << " " << e << " " << s << " " << t;
      if (found.off > 10 * found.radius) closest = std::max(closest, found.off / closing->beside);
    }
  }
  EXPECT_GT(tried, 100);
  EXPECT_GT(closest, 0.2);
}

/// w_0 on the elements beyond an edge rises from it as fast as its slope says, or is bright far away alone.
TEST(LineBounds, ClosingsAreNearWhatSlopesAndFarElementsSend) {
  for (const bool rises : {true, false}) {
    double closest = 0;
    PolyhedronCertificate c = bare_certificate("cube", 3, 1, 17);
    for (Face& face : c.faces) face.emission = {{Rational(0)}};
    std::fill(c.coefficients.begin(), c.coefficients.end(), 0.0);
    const std::size_t size = c.powers() * c.powers();
    for (std::size_t e = 0; e < c.elements.size(); ++e) {
      const Element& x = c.elements[e];
      // The slope ends at t = 1/16; or noise up to t = 1/4.
      const double middle = rises         ? std::min(1.0, 8 * (x.t0 + x.t1))
                            : x.t0 < 0.25 ? 1e-7 * static_cast<double>(e)
                                          : 1;
      c.coefficients[e * size] = rises && x.t0 == 0 ? 0.5 : middle;
      if (rises && x.t0 == 0) c.coefficients[e * size + 1] = 0.5;
      // Of means: rho (1 + q_k) on a piece is to be 0 for all other functions.
      c.coefficients[((1 + c.faces[x.face].piece) * c.elements.size() + e) * size] = -1;
    }
    const Bench bench(std::move(c));
    Draw draw(18);
    for (std::size_t e = 0; e < bench.c.elements.size(); ++e) {
      const Element& x = bench.c.elements[e];
      if (x.t0 > 0 || x.s0 == 0 || x.s1 == 1) continue;
      for (int n = 0; n < 3; ++n) {
        const double width = (x.s1 - x.s0) * 0x1p-8;
        const double from = 0.5 * (x.s0 + x.s1);
        const Box box{.s0 = from, .s1 = from + width, .t0 = 0, .t1 = x.t1 * std::exp2(-8 - 4 * draw())};
        const std::optional<EdgeClosing> closing = bench.lines.closing(e, box);
        ASSERT_TRUE(closing);
        const Held found = held(bench, e, *closing, from + 0.5 * width, box.t1 * (0.9 + 0.1 * draw()));
        EXPECT_LE(found.off - found.radius, closing->beside) << e;
        if (found.off > 10 * found.radius) closest = std::max(closest, found.off / closing->beside);
      }
    }
    EXPECT_GT(closest, rises ? 0.15 : 0.1) << rises;
  }
}

}  // namespace
}  // namespace radcert::certificate
