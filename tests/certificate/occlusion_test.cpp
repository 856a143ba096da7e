// SPDX-License-Identifier: GPL-3.0-or-later
// Where parts hide each other, beside the judge of segments.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/certificate/element_check.h"
#include "radcert/certificate/occlusion/shade.h"
#include "radcert/certificate/occlusion/sight.h"
#include "radcert/certificate/occlusion/solid_facts.h"
#include "radcert/certificate/point_kernels.h"
#include "radcert/certificate/polyhedron_facts.h"
#include "radcert/closed_form/point_to_polygon.h"
#include "tests/certificate/bench.h"
#include "tests/certificate/samples.h"
#include "tests/certificate/segments.h"

namespace radcert::certificate {
namespace {

using radcert::test::bare_certificate;
using radcert::test::Draw;
using radcert::test::Segments;
using test::Bench;

const std::array<std::string, 2> rooms{"l_room", "cube_in_a_cube"};

TEST(SolidFault, FindsNoneInRooms) {
  for (const std::string& name : rooms) {
    const PolyhedronCertificate c = bare_certificate(name, 2, 0, 1);
    EXPECT_FALSE(is_convex(c)) << name;
    const std::optional<Refusal> fault = surface_fault(c);
    EXPECT_FALSE(fault) << name << " " << (fault ? fault->pointer + " " + fault->says : "");
  }
  EXPECT_TRUE(is_convex(bare_certificate("octahedron", 2, 0, 1)));
}

TEST(SolidFault, SeesFacesThatAreMissingTurnedOrMoved) {
  Draw draw(3);
  for (const std::string& name : rooms) {
    const PolyhedronCertificate whole = bare_certificate(name, 2, 0, 1);
    for (int n = 0; n < 12; ++n) {
      const std::size_t f = draw.below(whole.faces.size());
      PolyhedronCertificate missing = whole;
      missing.faces.erase(missing.faces.begin() + static_cast<std::ptrdiff_t>(f));
      EXPECT_TRUE(solid_fault(missing)) << name << " " << f;
      PolyhedronCertificate turned = whole;
      std::reverse(turned.faces[f].corners.begin(), turned.faces[f].corners.end());
      EXPECT_TRUE(solid_fault(turned)) << name << " " << f;
      PolyhedronCertificate twice = whole;
      twice.faces.push_back(whole.faces[f]);
      EXPECT_TRUE(solid_fault(twice)) << name << " " << f;
      PolyhedronCertificate moved = whole;
      moved.faces[f].corners[draw.below(4)].y += Rational(1, 1000000);
      EXPECT_TRUE(surface_fault(moved)) << name << " " << f;
    }
  }
}

/// Closed surfaces all of them, whose front is not the inside of a body.
TEST(SolidFault, SeesBodiesThatAreInsideOut) {
  const PolyhedronCertificate whole = bare_certificate("cube_in_a_cube", 2, 0, 1);
  const auto is_inside = [&](const Face& face) { return face.piece >= 6; };
  PolyhedronCertificate filled = whole;
  PolyhedronCertificate outside = whole;
  PolyhedronCertificate apart = whole;
  for (Face& face : filled.faces)
    if (is_inside(face)) std::reverse(face.corners.begin(), face.corners.end());
  for (Face& face : outside.faces) std::reverse(face.corners.begin(), face.corners.end());
  std::erase_if(apart.faces, [&](const Face& face) { return !is_inside(face); });
  EXPECT_TRUE(solid_fault(filled));
  EXPECT_TRUE(solid_fault(outside));
  EXPECT_TRUE(solid_fault(apart));
}

TEST(SolidFault, SeesFacesThatCross) {
  PolyhedronCertificate c = bare_certificate("cube_in_a_cube", 2, 0, 1);
  for (Face& face : c.faces)
    if (face.piece >= 6)
      for (Vector<Rational>& p : face.corners) p.x += Rational(3, 2);
  const std::optional<Refusal> fault = solid_fault(c);
  ASSERT_TRUE(fault);
  EXPECT_NE(fault->says.find("both sides"), std::string::npos);
}

Box whole_box(const Element& x) { return {.s0 = x.s0, .s1 = x.s1, .t0 = x.t0, .t1 = x.t1}; }

/// A part of an element, at its borders more often than not.
Box drawn_box(const Element& x, Draw& draw, int smallest) {
  const auto part = [&](double from, double to, double& low, double& high) {
    const double width =
        (to - from) * std::ldexp(1.0, -static_cast<int>(draw.below(static_cast<std::size_t>(smallest))));
    const std::size_t where = draw.below(3);
    low = where == 0   ? from
          : where == 1 ? to - width
                       : from + std::floor(draw() * (to - from) / width) * width;
    high = low + width;
  };
  Box box;
  part(x.s0, x.s1, box.s0, box.s1);
  part(x.t0, x.t1, box.t0, box.t1);
  return box;
}

Vector<double> point_of(const PolyhedronCertificate& c, std::size_t element, double s, double t) {
  return radcert::test::element_point(c, c.elements[element], s, t);
}

bool has(const Box& box, double s, double t) {
  return box.s0 <= s && s <= box.s1 && box.t0 <= t && t <= box.t1;
}

/// What a view says of a point of an element: 1 seen by all, 0 unknown, -1 seen by none.
int said(const PolyhedronCertificate& c, const View& view, std::size_t element, double s, double t) {
  for (const View::OfFace& seen : view.faces) {
    if (seen.face != c.elements[element].face) continue;
    if (seen.is_whole) return 1;
    for (const SourcePart& part : seen.parts)
      if (part.element == element && has(part.box, s, t)) return 1;
  }
  for (const ShadedPart& shaded : view.shaded)
    if (shaded.part.element == element && has(shaded.part.box, s, t)) return 0;
  return -1;
}

TEST(Sight, SaysNothingThatASegmentContradicts) {
  for (const std::string& name : rooms) {
    const Bench bench(bare_certificate(name, 2, 0, 1));
    const PolyhedronCertificate& c = bench.c;
    const Segments segments(c);
    Draw draw(11);
    std::array<int, 3> counts{};
    for (int n = 0; n < 40; ++n) {
      const std::size_t e = draw.below(c.elements.size());
      const Box box = drawn_box(c.elements[e], draw, 6);
      const View view = bench.sight.view(bench.lines.triangle_place(e), box, 1e-4);
      for (int k = 0; k < 300; ++k) {
        const std::size_t y = draw.below(c.elements.size());
        if (!bench.sight.face_each_other(c.elements[e].face, c.elements[y].face)) continue;
        const Element& x = c.elements[y];
        const double s = x.s0 + (x.s1 - x.s0) * draw();
        const double t = x.t0 + (x.t1 - x.t0) * draw();
        const int says = said(c, view, y, s, t);
        ++counts[static_cast<std::size_t>(says + 1)];
        const Vector<double> p =
            point_of(c, e, box.s0 + (box.s1 - box.s0) * draw(), box.t0 + (box.t1 - box.t0) * draw());
        const int is_hidden = segments.hidden(p, point_of(c, y, s, t));
        // Seen by all is 1, and so is hidden: they contradict each other where they are equal.
        const bool contradicts = is_hidden != 0 && says == is_hidden;
        EXPECT_FALSE(contradicts) << name << " " << e << " " << y;
      }
    }
    // Much is seen and much is hidden, and little is left open from small boxes.
    EXPECT_GT(counts[0], 300) << name;
    EXPECT_GT(counts[2], 300) << name;
    EXPECT_LT(counts[1], counts[0] + counts[2]) << name;
  }
}

TEST(Sight, SaysOfOnePartWhatSegmentsSay) {
  for (const std::string& name : rooms) {
    const Bench bench(bare_certificate(name, 2, 0, 1));
    const PolyhedronCertificate& c = bench.c;
    const Segments segments(c);
    Draw draw(13);
    std::array<int, 3> counts{};
    for (int n = 0; n < 600; ++n) {
      const std::size_t e = draw.below(c.elements.size());
      const std::size_t y = draw.below(c.elements.size());
      if (!bench.sight.face_each_other(c.elements[e].face, c.elements[y].face)) continue;
      const Box box = drawn_box(c.elements[e], draw, 8);
      const Box part = drawn_box(c.elements[y], draw, 4);
      const Seen seen = bench.sight.seen(bench.lines.triangle_place(e), box, {y, part});
      ++counts[static_cast<std::size_t>(seen)];
      for (int k = 0; k < 20; ++k) {
        const auto within = [&](const Box& of, std::size_t element) {
          return point_of(c, element, of.s0 + (of.s1 - of.s0) * draw(), of.t0 + (of.t1 - of.t0) * draw());
        };
        const int is_hidden = segments.hidden(within(box, e), within(part, y));
        EXPECT_FALSE(seen == Seen::whole && is_hidden == 1) << name << " " << e << " " << y;
        EXPECT_FALSE(seen == Seen::none && is_hidden == -1) << name << " " << e << " " << y;
      }
    }
    EXPECT_GT(counts[0], 30) << name;
    EXPECT_GT(counts[2], 100) << name;
    EXPECT_LT(counts[1], counts[0] + counts[2]) << name;
  }
}

double kernel(const PolyhedronCertificate& c, std::size_t face, const Vector<double>& p, std::size_t other,
              const Vector<double>& q) {
  return radcert::test::kernel_between(p, radcert::test::unit_normal(c, face), q,
                                       radcert::test::unit_normal(c, other));
}

/// What arrives at a point from what a box does not know to be seen, less the constants: within the radii.
TEST(Shade, HoldsWhatArrives) {
  for (const std::string& name : rooms) {
    const Bench bench(bare_certificate(name, 2, 1, 7));
    const PolyhedronCertificate& c = bench.c;
    const Segments segments(c);
    Draw draw(13);
    double largest = 0;
    for (int n = 0; n < 6; ++n) {
      const std::size_t e = draw.below(c.elements.size());
      const Element& x = c.elements[e];
      Box box = drawn_box(x, draw, 5);
      // Off the edge, where kernels are large.
      if (box.t0 == 0) box.t0 = 0.5 * box.t1;
      const View view = bench.sight.view(bench.lines.triangle_place(e), box, 1e-3);
      const Shade shade = bench.shades.of(view.shaded);
      const Vector<double> p = point_of(c, e, 0.3 * box.s0 + 0.7 * box.s1, 0.6 * box.t0 + 0.4 * box.t1);
      std::vector<double> arrives(2);
      for (const ShadedPart& own : view.shaded) {
        const std::size_t y = own.part.element;
        const Element& whole = c.elements[y];
        const Box& b = own.part.box;
        constexpr int parts = 4;
        for (int i = 0; i < parts * parts; ++i) {
          const double s = b.s0 + (b.s1 - b.s0) * (i % parts + 0.5) / parts;
          const double t =
              b.t0 + (b.t1 - b.t0) * (i / parts + 0.5) / parts;  // NOLINT(bugprone-integer-division)
          const Vector<double> q = point_of(c, y, s, t);
          if (segments.hidden(p, q) > 0) continue;
          const double area =
              radcert::test::element_area(
                  c,
                  {.face = whole.face, .side = whole.side, .s0 = b.s0, .s1 = b.s1, .t0 = b.t0, .t1 = b.t1}) /
              (parts * parts);
          const double sent = kernel(c, x.face, p, whole.face, q) * area;
          const LegendreTable p_s(1, std::vector<BoundedDouble>{BoundedDouble::exactly(
                                         (2 * s - whole.s0 - whole.s1) / (whole.s1 - whole.s0))});
          const LegendreTable p_t(1, std::vector<BoundedDouble>{BoundedDouble::exactly(
                                         (2 * t - whole.t0 - whole.t1) / (whole.t1 - whole.t0))});
          std::vector<double> w(bench.densities.stride());
          Densities::values(bench.densities.w(y), bench.densities.stride(), p_s.values.data(),
                            p_t.values.data(), 2, w);
          for (std::size_t k = 0; k < 2; ++k) arrives[k] += sent * (w[k] - shade.constants[k]);
        }
      }
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_LE(std::abs(arrives[k] - shade.shifts[k]), 1.02 * shade.radii[k] + 1e-12) << name << " " << n;
        largest = std::max(largest,
                           shade.radii[k] > 0 ? std::abs(arrives[k] - shade.shifts[k]) / shade.radii[k] : 0);
      }
    }
    // No hundred times too large.
    EXPECT_GT(largest, 0.01) << name;
  }
}

/// The parts that are seen, by closed forms.
TEST(BallTransport, SumsThePartsThatAreSeen) {
  for (const std::string& name : rooms) {
    const Bench bench(bare_certificate(name, 2, 0, 5));
    const PolyhedronCertificate& c = bench.c;
    Draw draw(17);
    int tried = 0;
    while (tried < 3) {
      const std::size_t e = draw.below(c.elements.size());
      const Box box = drawn_box(c.elements[e], draw, 4);
      const View view = bench.sight.view(bench.lines.triangle_place(e), box, 1e-2);
      if (view.shaded.empty() || box.t0 == 0) continue;
      ++tried;
      const Observers one{.triangle = bench.lines.triangle_place(e),
                          .s = {BoundedDouble::exactly(box.middle_s())},
                          .t = {BoundedDouble::exactly(box.middle_t())}};
      const BallTransport::Values found = bench.transport(one, 1e-9, std::nullopt, &view);
      ASSERT_TRUE(std::isfinite(found.radii[0]));
      const Face& own = c.faces[c.elements[e].face];
      const auto at = [&](const Face& face, std::size_t side, double s, double t) {
        Vector<Rational> sum;
        for (const Vector<Rational>& corner : face.corners) sum = sum + corner;
        const Vector<Rational> centre = Rational(1, static_cast<long>(face.corners.size())) * sum;
        const Vector<Rational>& a = face.corners[side];
        const Vector<Rational> along = face.corners[(side + 1) % face.corners.size()] - a;
        return a + (Rational::exactly(s) * (Rational(1) - Rational::exactly(t))) * along +
               Rational::exactly(t) * (centre - a);
      };
      const auto normal = cross(own.corners[1] - own.corners[0], own.corners[2] - own.corners[0]);
      const Vector<Rational> p = at(own, c.elements[e].side, box.middle_s(), box.middle_t());
      Ball all;
      Ball sent;
      for (const View::OfFace& seen : view.faces) {
        std::vector<SourcePart> parts = seen.parts;
        for (std::size_t y = 0; seen.is_whole && y < c.elements.size(); ++y)
          if (c.elements[y].face == seen.face) parts.push_back({y, whole_box(c.elements[y])});
        for (const SourcePart& part : parts) {
          const Face& face = c.faces[seen.face];
          const std::size_t side = c.elements[part.element].side;
          const Box& b = part.box;
          std::vector<Vector<Rational>> corners{at(face, side, b.s0, b.t0), at(face, side, b.s1, b.t0),
                                                at(face, side, b.s1, b.t1)};
          if (b.t1 < 1) corners.push_back(at(face, side, b.s0, b.t1));
          const Ball factor =
              point_to_polygon(p, normal, plane_polygon(corners).value(), constant_polynomial(Rational(1))) /
              Ball::pi();
          Rational w = face.reflectivity * Rational::exactly(c.coefficient(0, part.element, 0, 0));
          w += face.emission[0][0];
          all += factor;
          sent += Ball(w) * factor;
        }
      }
      sent *= power(Ball(2), -bench.densities.exponent());
      const std::size_t one_place = bench.densities.constant();
      EXPECT_TRUE(overlaps(all, widened(Ball(found.values[one_place]), Ball(found.radii[0])))) << name;
      EXPECT_TRUE(overlaps(sent, widened(Ball(found.values[0]), Ball(found.radii[0])))) << name;
      EXPECT_LT(found.radii[0], 1e-6);
    }
  }
}

/// The room around a corner, whose east wall shines and is black; q_0 is a constant c: t_0 = F + c (1 - F)/2
/// - c, F the share of the wall in what is seen.
PolyhedronCertificate lit_room(double constant) {
  PolyhedronCertificate lit = bare_certificate("l_room", 2, 3, 1);
  std::fill(lit.coefficients.begin(), lit.coefficients.end(), 0);
  for (std::size_t e = 0; e < lit.elements.size(); ++e) lit.coefficients[16 * e] = constant;
  for (Face& face : lit.faces) {
    face.emission = {{Rational(face.piece == 4 ? 1 : 0)}};
    face.reflectivity = face.piece == 4 ? Rational(0) : Rational(1, 2);
  }
  return lit;
}

/// What a point sees of the shining wall past the corner at (1, 1): all of its height, up to some y.
TEST(ValuesOf, AreWhatTheCornerLetsThrough) {
  for (const Vector<Rational>& at :
       {Vector<Rational>{Rational(3, 4), Rational(6, 5), 0},
        Vector<Rational>{Rational(3, 5), Rational(6, 5), 1},
        Vector<Rational>{0, Rational(11, 10), Rational(1, 3)}, Vector<Rational>{Rational(1, 2), 1, 0},
        Vector<Rational>{Rational(1, 2), Rational(7, 4), 0}}) {
    PolyhedronCertificate c = lit_room(0);
    for (std::size_t f = 0; f < c.faces.size(); ++f) {
      c.points = {{.face = f, .at = at}};
      if (!points_fault(c)) break;
    }
    ASSERT_FALSE(points_fault(c));
    c.coefficients.resize(c.functions() * c.elements.size() * c.powers() * c.powers());
    // The ray past the corner meets the wall x = 2 there; nothing is seen of more than the height allows.
    Rational most = 1;
    if (at.y > Rational(1))
      most = std::clamp(at.y + (Rational(1) - at.y) * (Rational(2) - at.x) / (Rational(1) - at.x),
                        Rational(0), Rational(1));
    Ball sees;
    if (most.sign() > 0) {
      const std::vector<Vector<Rational>> wall{{2, 0, 0}, {2, 0, 1}, {2, most, 1}, {2, most, 0}};
      sees = point_to_polygon(at, normal_of(c.faces[c.points[0].face]), plane_polygon(wall).value(),
                              constant_polynomial(Rational(1))) /
             Ball::pi();
    }
    const Ball half = sees / 2;
    for (const double radius : {1e-3, 1e-9}) {
      const Ball value = values_of(c, {.norms = {0, 0}, .products = {0}, .radii = {radius}}, Ball(1)).at(0);
      EXPECT_TRUE(overlaps(value, half))
          << at.x.to_text() << " " << at.y.to_text() << " " << value.to_text(12) << " " << half.to_text(12);
      EXPECT_GE(value.radius(), 0.5 * radius);
      EXPECT_LE(value.radius(), std::max(0.55 * radius, 3e-5));
    }
  }
}

/// What points see of the shining wall, by the judge at many points. Shade is a
/// good part of what is not known, and in one of both signs it leaves out some of the norm.
TEST(Occlusion, OfElementsEnclosesWhatPointsSee) {
  struct Judged {
    std::size_t element;
    double mean;
    double mean_square;
  };
  std::vector<Judged> judged;
  for (const double constant : {1.0, -1.0}) {
    const Bench bench(lit_room(constant));
    const PolyhedronCertificate& c = bench.c;
    const Segments segments(c);
    std::size_t wall = 0;
    while (c.faces[wall].piece != 4) ++wall;
    for (std::size_t e = 0; e < c.elements.size() && constant > 0 && judged.size() < 12; ++e) {
      const Element& x = c.elements[e];
      if (x.t0 == 0 || x.face == wall) continue;
      const View view = bench.sight.view(bench.lines.triangle_place(e), whole_box(x), 1e-3);
      const bool is_shaded = std::any_of(view.shaded.begin(), view.shaded.end(), [&](const ShadedPart& own) {
        return c.elements[own.part.element].face == wall;
      });
      if (!is_shaded) continue;
      constexpr int points = 4;
      constexpr int parts = 30;
      double weights = 0;
      double sum = 0;
      double squares = 0;
      for (int n = 0; n < points * points; ++n) {
        const double t = x.t0 + (x.t1 - x.t0) * (n % points + 0.5) / points;
        const double s = x.s0 + (x.s1 - x.s0) * (std::floor(1.0 * n / points) + 0.5) / points;
        const Vector<double> p = point_of(c, e, s, t);
        double sees = 0;
        // The wall x = 2, 0 <= y, z <= 1.
        for (int m = 0; m < parts * parts; ++m) {
          const Vector<double> q{2, (m % parts + 0.5) / parts, (std::floor(1.0 * m / parts) + 0.5) / parts};
          if (segments.hidden(p, q) <= 0) sees += kernel(c, x.face, p, wall, q) / (parts * parts);
        }
        weights += 1 - t;
        sum += (1 - t) * sees;
        squares += (1 - t) * sees * sees;
      }
      judged.push_back({e, sum / weights, squares / weights});
    }
    const PointKernels kernels(c, bench.scene, bench.densities, bench.sight);
    const ElementCheck elements(c, bench.scene, bench.densities, bench.lines, bench.transport, kernels,
                                bench.sight, bench.shades);
    const double unit = std::ldexp(1.0, -bench.densities.exponent());
    for (const Judged& own : judged) {
      const std::size_t e = own.element;
      const double area =
          std::ldexp(radcert::test::element_area(c, c.elements[e]), -2 * bench.scene.exponent());
      double residual = 0;
      for (std::size_t k = 0; k < bench.densities.count(); ++k)
        residual = std::max(residual, bench.densities.largest_of(k) + bench.densities.q_size_of(e, k));
      const ResidualBounds found =
          elements.bounds(e, {.norm = 0.3 * std::sqrt(0.5 * area) * unit,
                              .product = 2 * area * bench.densities.size_of_w(e) * residual});
      const std::size_t piece = c.faces[c.elements[e].face].piece;
      const double slope = 1 - 0.5 * constant;
      const double product = 0.5 * (slope * own.mean - 0.5 * constant) * area * unit;
      EXPECT_LE(std::abs(found.products[piece] - product), found.radii[piece] + 1e-3 * area * unit) << e;
      const double square = slope * slope * own.mean_square - slope * constant * own.mean + 0.25;
      EXPECT_GE(found.norms[0], (std::sqrt(square) - 2e-3) * std::sqrt(0.5 * area) * unit) << e;
    }
  }
  EXPECT_GE(judged.size(), 8U);
}

/// Norms of V j_1 - q_1, q_1 = 0 and T w_1 = 0: near the truth where the point sees all of an element or
/// nothing, and not below it where it sees a part, however large the cells.
TEST(Occlusion, OfPointsIsThatOfTheirKernels) {
  std::array<int, 3> tried{};
  for (const std::string& name : rooms) {
    const Bench bench(radcert::test::furnace_value_certificate(name, 0.25, 1.1, 0.02));
    const PolyhedronCertificate& c = bench.c;
    const PointKernels kernels(c, bench.scene, bench.densities, bench.sight);
    const ElementCheck elements(c, bench.scene, bench.densities, bench.lines, bench.transport, kernels,
                                bench.sight, bench.shades);
    const double unit = std::ldexp(1.0, bench.scene.exponent() + bench.densities.exponent(1));
    std::array<int, 3> in_room{};
    for (std::size_t e = 0; e < c.elements.size(); ++e) {
      const Element& x = c.elements[e];
      if (bench.scene.coplanar(x.face, c.points[0].face)) continue;
      const Seen seen = kernels.seen({e, whole_box(x)})[0];
      if (tried[static_cast<std::size_t>(seen)] >= 6) continue;
      const double norm = radcert::test::kernel_norm(c, c.points[0], x) * std::sqrt(0.5);
      if (seen == Seen::partly) {
        // Rules leave little, and there is room for all of the kernel: it is not why the element is cut.
        const double root = std::sqrt(0.5 * radcert::test::element_area(c, x));
        const double most = root * kernels.size(0, bench.lines.triangle_place(e), whole_box(x)) /
                            std::ldexp(1.0, bench.scene.exponent());
        if (norm < 0.6 * unit * most) continue;
        const double found = unit * elements.bounds(e, {.norm = 0.05 * most, .norm_room = {1, 400}}).norms[1];
        EXPECT_GE(found, 0.95 * norm) << name << " " << e;
        EXPECT_LE(found, 2.2 * norm) << name << " " << e;
        ++tried[1];
        continue;
      }
      if (++in_room[static_cast<std::size_t>(seen)] > 2) continue;
      ++tried[static_cast<std::size_t>(seen)];
      constexpr double left = 1e-3;
      const double found = unit * elements.bounds(e, {.norm = left / unit}).norms[1];
      EXPECT_GE(found, norm) << name << " " << e;
      EXPECT_LE(found, norm + 1.1 * left) << name << " " << e;
    }
  }
  EXPECT_GE(tried[0], 2);
  EXPECT_GE(tried[1], 3);
  EXPECT_GE(tried[2], 2);
}

/// Of a function: no bound of |t_0| is below what points have, none is far above.
TEST(Occlusion, OfAFunctionEnclosesWhatPointsSee) {
  PolyhedronCertificate c = lit_room(1);
  c.by_distance = {{.outside = 0, .sup = 1}};
  c.coefficients.resize(c.elements.size() * c.powers() * c.powers());
  const Bench bench(c);
  const Segments segments(c);
  const PointKernels kernels(c, bench.scene, bench.densities, bench.sight);
  const ElementCheck elements(c, bench.scene, bench.densities, bench.lines, bench.transport, kernels,
                              bench.sight, bench.shades);
  std::size_t wall = 0;
  while (c.faces[wall].piece != 4) ++wall;
  int tried = 0;
  double nearest = 0;
  for (std::size_t e = 0; e < c.elements.size() && tried < 8; ++e) {
    const Element& x = c.elements[e];
    if (x.t0 == 0 || x.face == wall) continue;
    const View view = bench.sight.view(bench.lines.triangle_place(e), whole_box(x), 1e-3);
    if (view.shaded.empty()) continue;
    ++tried;
    double most = 0;
    for (int n = 0; n < 25; ++n) {
      const Vector<double> p =
          point_of(c, e, x.s0 + (x.s1 - x.s0) * (n % 5) / 4, x.t0 + (x.t1 - x.t0) * std::floor(n / 5.0) / 4);
      double sees = 0;
      constexpr int parts = 40;
      for (int m = 0; m < parts * parts; ++m) {
        const Vector<double> q{2, (m % parts + 0.5) / parts, (std::floor(1.0 * m / parts) + 0.5) / parts};
        if (segments.hidden(p, q) <= 0) sees += kernel(c, x.face, p, wall, q) / (parts * parts);
      }
      // T w_0 = F + (1 - F)/2, q_0 = 1, rho = 1/2.
      most = std::max(most, 0.5 * std::abs(0.5 * sees - 0.5));
    }
    const double unit = std::ldexp(1.0, bench.densities.exponent());
    const ResidualBounds found = elements.bounds(e, {.largest = 0.05 / unit, .claim = 0});
    EXPECT_GE(found.largest * unit, most - 2e-3) << e;
    EXPECT_LE(found.largest * unit, most + 0.095) << e;
    const double inside = elements.residual_inside(e, 1e-6) * unit;
    EXPECT_LE(inside, most + 2e-3) << e;
    nearest = std::max(nearest, inside / most);
  }
  EXPECT_EQ(tried, 8);
  EXPECT_GT(nearest, 0.8);
}

}  // namespace
}  // namespace radcert::certificate
