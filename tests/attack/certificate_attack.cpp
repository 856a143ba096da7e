// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates whose claims are true or false by a little, on skew polyhedra and rooms whose parts hide each
// other: in a furnace with u = 1 and
// constant functions the residuals are known exactly, and the check must refuse what is false; of values at
// points as well, whose duals' residuals are known by integrals of kernels; and on spheres and ellipsoids.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "radcert/certificate/certificate.h"
#include "radcert/certificate/check.h"
#include "radcert/certificate/function_facts.h"
#include "radcert/core/text.h"
#include "tests/attack/attack.h"
#include "tests/certificate/closed_form_transport.h"
#include "tests/certificate/ellipsoid_samples.h"
#include "tests/certificate/samples.h"
#include "tests/continuous/skew_map.h"

namespace radcert::attack {
namespace {

using certificate::Claim;
using certificate::PolyhedronCertificate;

/// A furnace with one reflectivity, as a certificate with one claim that is false or nearly so.
/// Maths     E = 1 - rho, q_0 = 1 - d, q_k = b: w_0 = 1 - rho d, t_0 = d (1 - rho) by T 1 = 1, w_k = rho
///           (1 on piece k, else 0, + b), |t_k| <= rho (1 + b) + b. On the element X the norm of t_0 is d (1
///           - rho) (rho |X|)^(1/2), and Int_X w_k t_0 = w_k d (1 - rho) |X|. The claim has `norm` times the
///           one and `off` radii beside the other
struct Instance {
  std::string surface;
  SkewMap map;
  long reflectivity = 50;  ///< in hundredths
  double d = 0.25;
  double b = 0.25;
  int layers = 2;
  std::size_t element = 0;  ///< of as many as there are
  std::size_t piece = 0;
  double norm = 1.1;
  double off = 0;
  double size = 1;  ///< of E and u
};

std::string text(const Instance& x) {
  return x.surface + ", " + x.map.text() + ", rho " + std::to_string(x.reflectivity) + ", d " +
         shortest(x.d) + ", b " + shortest(x.b) + ", layers " + std::to_string(x.layers) + ", element " +
         std::to_string(x.element) + ", piece " + std::to_string(x.piece) + ", norm " + shortest(x.norm) +
         ", off " + shortest(x.off) + ", size " + shortest(x.size);
}

struct Made {
  PolyhedronCertificate certificate;
  std::size_t element = 0;
};

Made certificate_of(const Instance& x) {
  Made out{.certificate = test::bare_certificate(x.surface, x.layers, 0, 1)};
  PolyhedronCertificate& c = out.certificate;
  const Rational rho = hundredths(x.reflectivity);
  const double r = rho.to_double();
  for (certificate::Face& face : c.faces) {
    face.reflectivity = rho;
    face.emission = {{(Rational(1) - rho) * Rational::exactly(x.size)}};
    for (Vector<Rational>& p : face.corners) p = x.map(p);
  }
  for (std::size_t i = 0; i < c.coefficients.size(); ++i)
    c.coefficients[i] = i < c.elements.size() ? (1 - x.d) * x.size : x.b;
  const double residual = x.d * (1 - r) * x.size;
  // Generous, so that the claim in question alone is at stake.
  const double room = 0.05 * residual;
  for (const certificate::Element& element : c.elements) {
    const double area = test::element_area(c, element);
    Claim claim{
        .norms = std::vector<double>(c.functions(), 1.1 * (r * (1 + x.b) + x.b) * std::sqrt(r * area)),
        .products = {},
        .radii = std::vector<double>(c.pieces.size(), room * area)};
    claim.norms[0] = 1.1 * residual * std::sqrt(r * area);
    for (std::size_t k = 0; k < c.pieces.size(); ++k)
      claim.products.push_back(r * ((c.faces[element.face].piece == k ? 1 : 0) + x.b) * area * residual);
    c.claims.push_back(std::move(claim));
  }
  out.element = x.element % c.elements.size();
  Claim& claim = c.claims[out.element];
  claim.norms[0] *= x.norm / 1.1;
  const std::size_t piece = x.piece % c.pieces.size();
  claim.products[piece] += x.off * claim.radii[piece];
  test::put_sums(c);
  return out;
}

Instance drawn_of(Draw& draw, std::size_t kinds) {
  Instance x;
  const std::array<std::string, 6> surfaces{"tetrahedron", "cube",   "octahedron",
                                            "box",         "l_room", "cube_in_a_cube"};
  x.surface = surfaces[draw.below(std::min(kinds, surfaces.size()))];
  x.map = SkewMap::drawn(draw, 40, 160, 60);
  x.reflectivity = 1 + static_cast<long>(draw.below(98));
  x.d = std::ldexp(1 + draw.unit(), -1 - static_cast<int>(draw.below(5)));
  x.b = std::ldexp(1 + draw.unit(), -1 - static_cast<int>(draw.below(5)));
  x.element = draw.below(1000);
  x.piece = draw.below(8);
  x.size = std::ldexp(1.0, static_cast<int>(draw.below(60)) - 30);
  // One of both is false in two of three instances, by little or much.
  const double by = std::pow(10.0, -4 + 4 * draw.unit());
  const std::size_t which = draw.below(3);
  if (which == 0) x.norm = 1 - by / 2;
  if (which == 1) x.off = (draw.below(2) == 0 ? 1 : -1) * (1 + by);
  return x;
}

Instance drawn(Draw& draw) { return drawn_of(draw, 6); }

std::vector<Instance> smaller(const Instance& x) {
  std::vector<Instance> out;
  const Instance plain;
  const auto with = [&](auto member) {
    if (x.*member == plain.*member) return;
    out.push_back(x);
    out.back().*member = plain.*member;
  };
  with(&Instance::reflectivity);
  with(&Instance::d);
  with(&Instance::b);
  with(&Instance::size);
  x.map.each_simpler([&](const SkewMap& map) {
    out.push_back(x);
    out.back().map = map;
  });
  return out;
}

/// A part that is the element in question alone, or few others beside it.
certificate::Part part_with(std::size_t element, std::size_t count) {
  certificate::Part part{.elements = 1, .seed = {}};
  for (int k = 0;; ++k) {
    part.seed = std::to_string(k);
    if (certificate::chosen_elements(count, part).front() == element) return part;
  }
}

Judgement judge(const Instance& x) {
  const Made made = certificate_of(x);
  const PolyhedronCertificate& c = made.certificate;
  const certificate::Report report = certificate::check(c, part_with(made.element, c.elements.size()));
  // The doubles of the claims are off by some roundings.
  constexpr double roundings = 1e-9;
  const bool is_false = x.norm < 1 - roundings || std::abs(x.off) > 1 + roundings;
  if (is_false) return report.refusal ? Judgement::held(1) : Judgement::violated("a false claim is verified");
  if (report.refusal) return Judgement::refused();
  for (const certificate::Enclosure& mean : c.enclosures)
    if (abs(mean.midpoint - Rational::exactly(x.size)) > mean.radius)
      return Judgement::violated("a mean of 1 lies outside what is verified");
  return Judgement::held(1 + c.enclosures.size());
}

TEST(CertificateAttack, FalseClaimsAreRefused) {
  const Count count = hold(Attack<Instance>{.name = "claims of certificates",
                                            .usual_instances = 5,
                                            .make = drawn,
                                            .judge = judge,
                                            .text = text,
                                            .smaller = smaller});
  // True claims with room are verified: a check that refuses everything holds nothing.
  EXPECT_LE(count.refused, count.instances / 4);
}

/// The value of u = 1 in a furnace at a point, as a certificate with one norm that is false or nearly so.
/// Maths     E = 1 - rho, q_0 = 1 - d as above; y = b: w = rho b, t = j - (1 - rho) b, j = G(P,.)/pi, or 0 on
///           the face of P; Int_X w t_0 = rho b d (1 - rho) |X|
struct ValueInstance {
  Instance scene;
  std::size_t face = 0;
  std::array<long, 3> weights{1, 1, 1};
};

std::string text_of_value(const ValueInstance& x) {
  std::string out = text(x.scene) + ", face " + std::to_string(x.face) + ", weights";
  for (const long weight : x.weights) out += " " + std::to_string(weight);
  return out;
}

Made certificate_of_value(const ValueInstance& x) {
  Made out{.certificate = test::bare_certificate(x.scene.surface, x.scene.layers, 0, 1)};
  PolyhedronCertificate& c = out.certificate;
  const Rational rho = hundredths(x.scene.reflectivity);
  const double r = rho.to_double();
  for (certificate::Face& face : c.faces) {
    face.reflectivity = rho;
    face.emission = {{Rational(1) - rho}};
    for (Vector<Rational>& p : face.corners) p = x.scene.map(p);
  }
  const std::size_t own = x.face % c.faces.size();
  const std::vector<Vector<Rational>>& p = c.faces[own].corners;
  const Rational all(x.weights[0] + x.weights[1] + x.weights[2]);
  c.points = {{.face = own,
               .at = (Rational(1) / all) * (Rational(x.weights[0]) * p[0] + Rational(x.weights[1]) * p[1] +
                                            Rational(x.weights[2]) * p[2])}};
  c.coefficients.assign(2 * c.elements.size(), x.scene.b);
  std::fill_n(c.coefficients.begin(), c.elements.size(), 1 - x.scene.d);
  const double residual = x.scene.d * (1 - r);
  for (const certificate::Element& element : c.elements) {
    const double area = test::element_area(c, element);
    const double less = (1 - r) * x.scene.b;
    const double norm =
        element.face == own ? less * std::sqrt(area) : test::kernel_norm(c, c.points[0], element, less);
    c.claims.push_back({.norms = {1.1 * residual * std::sqrt(r * area), 1.1 * std::sqrt(r) * norm},
                        .products = {r * x.scene.b * residual * area},
                        .radii = {0.05 * residual * area}});
  }
  out.element = x.scene.element % c.elements.size();
  c.claims[out.element].norms[1] *= x.scene.norm / 1.1;
  test::put_sums(c);
  return out;
}

/// Whether segments from the point meet faces on their way to some points of an element, and to others not.
bool is_seen_in_part(const PolyhedronCertificate& c, const certificate::Element& x) {
  const test::Segments segments(c);
  constexpr int points = 24;
  int hidden = 0;
  for (int n = 0; n < points * points; ++n) {
    const double s = x.s0 + (x.s1 - x.s0) * (n % points) / (points - 1);
    const double t = x.t0 + (x.t1 - x.t0) * (n / points) / (points - 1);
    if (segments.hidden(test::rounded(c.points[0].at), test::element_point(c, x, s, t)) >= 0) ++hidden;
  }
  return 0 < hidden && hidden < points * points;
}

Judgement judge_value(const ValueInstance& x) {
  const Made made = certificate_of_value(x);
  const PolyhedronCertificate& c = made.certificate;
  const certificate::Report report = certificate::check(c, part_with(made.element, c.elements.size()));
  // Of the rule of 16 x 16 nodes for the square of the kernel, which jumps where the element is seen in part.
  const double of_rule = is_seen_in_part(c, c.elements[made.element]) ? 0.25 : 1e-3;
  if (x.scene.norm < 1 - of_rule)
    return report.refusal ? Judgement::held(1) : Judgement::violated("a false claim is verified");
  if (report.refusal) return Judgement::refused();
  if (abs(c.enclosures[0].midpoint - Rational(1)) > c.enclosures[0].radius)
    return Judgement::violated("a value of 1 lies outside what is verified");
  return Judgement::held(2);
}

ValueInstance drawn_value(Draw& draw) {
  ValueInstance x{.scene = drawn_of(draw, 6)};
  x.scene.map = SkewMap::drawn(draw, 70, 60, 25);
  x.scene.size = 1;
  x.scene.off = 0;
  x.scene.norm = draw.below(2) == 0 ? 1.1 : 1 - std::pow(10.0, -2.5 + 2 * draw.unit());
  x.face = draw.below(8);
  for (long& weight : x.weights) weight = 3 + static_cast<long>(draw.below(4));
  return x;
}

TEST(CertificateAttack, FalseClaimsOfValuesAreRefused) {
  const Count count = hold(Attack<ValueInstance>{.name = "claims of certificates of values",
                                                 .usual_instances = 5,
                                                 .make = drawn_value,
                                                 .judge = judge_value,
                                                 .text = text_of_value});
  EXPECT_LE(count.refused, std::max<std::size_t>(1, count.instances / 3));
}

/// A function that is a constant on each element, near the ones of a furnace, as a certificate with one claim
/// that may be false.
/// Maths     E = 1 - rho, q_0 = 1 - d_e on the element e: w_0 = 1 - rho d_e, |u - w_0| = rho d_e, and T w_0
///           by closed forms at points; where parts hide each other all d_e are one, T w_0 = w_0. Claims are
///           so many times the largest residual that was found; at vertices, where none is known, |t_0| <=
///           sup|w_0| + sup|q_0|
struct FunctionInstance {
  Instance scene;
  std::uint64_t seed = 0;
};

std::string text_of_function(const FunctionInstance& x) {
  return text(x.scene) + ", seed " + std::to_string(x.seed);
}

FunctionInstance drawn_function(Draw& draw) {
  FunctionInstance x{.scene = drawn_of(draw, 6)};
  x.scene.map = SkewMap::drawn(draw, 60, 80, 30);
  x.scene.size = 1;
  x.scene.norm = draw.below(2) == 0 ? 1.6 : 1 - std::pow(10.0, -3 + 2 * draw.unit());
  x.seed = draw.below(1000);
  return x;
}

Judgement judge_function(const FunctionInstance& x) {
  PolyhedronCertificate c = test::bare_certificate(x.scene.surface, x.scene.layers, 0, 1);
  const Rational rho = hundredths(x.scene.reflectivity);
  for (certificate::Face& face : c.faces) {
    face.reflectivity = rho;
    face.emission = {{Rational(1) - rho}};
    for (Vector<Rational>& p : face.corners) p = x.scene.map(p);
  }
  Draw draw(x.seed);
  std::vector<double> d;
  const bool is_room = !test::room_of(x.scene.surface).empty();
  for (std::size_t e = 0; e < c.elements.size(); ++e)
    d.push_back(x.scene.d * (1 + (is_room ? 0 : 0.2 * draw.unit())));
  c.coefficients.clear();
  for (const double own : d) c.coefficients.push_back(1 - own);
  c.by_distance = {{1, 0}, {Rational(1, 2), 0}, {Rational(1, 4), 0}, {Rational(1, 8), 0}, {0, 0}};
  const auto at_vertex = [](const certificate::Element& y) { return y.t0 == 0 && (y.s0 == 0 || y.s1 == 1); };
  // The largest residual of a few points of each element.
  const std::size_t chosen = x.scene.element % c.elements.size();
  std::size_t element = chosen;
  while (at_vertex(c.elements[element])) element = (element + 1) % c.elements.size();
  const auto residual = [&](std::size_t e, double s, double t) {
    if (is_room) return rho.to_double() * (1 - rho.to_double()) * d[e];
    const certificate::Element& y = c.elements[e];
    const Rational at_s = Rational::exactly(y.s0 + (y.s1 - y.s0) * s);
    const Rational at_t = Rational::exactly(y.t0 + (y.t1 - y.t0) * t);
    const Ball sent =
        certificate::test::sent(c, 0, y.face, certificate::test::point_of(c, y.face, y.side, at_s, at_t));
    return rho.to_double() * std::abs(sent.to_double() - (1 - d[e]));
  };
  double largest = 0;
  for (int k = 0; k < 12; ++k) largest = std::max(largest, residual(element, draw.unit(), draw.unit()));
  const double generous = 3 * rho.to_double() * x.scene.d;
  for (const certificate::Element& y : c.elements)
    c.claims.push_back({.largest = at_vertex(y) ? 2.5 : generous});
  c.claims[element].largest = x.scene.norm * largest;
  const std::vector<Rational> bounds = certificate::bounds_by_distance(c);
  for (std::size_t m = 0; m < bounds.size(); ++m) c.by_distance[m].sup = bounds[m];
  c.width = Rational(2) * bounds.back();
  const certificate::Report report = certificate::check(c, part_with(element, c.elements.size()));
  if (x.scene.norm < 1 - 1e-9)
    return report.refusal ? Judgement::held(1) : Judgement::violated("a false claim is verified");
  // What is verified of the function itself, where the other claims hold as well.
  for (std::size_t e = 0; e < c.elements.size(); ++e) {
    if (at_vertex(c.elements[e]) || residual(e, 0.5, 0.5) <= c.claims[e].largest) continue;
    return Judgement::refused();
  }
  const certificate::Element& y = c.elements[element];
  for (int k = 0; k < 20; ++k) {
    const Vector<Rational> at =
        certificate::test::point_of(c, y.face, y.side, Rational::exactly(y.s0 + (y.s1 - y.s0) * draw.unit()),
                                    Rational::exactly(y.t0 + (y.t1 - y.t0) * draw.unit()));
    Rational nearest = 100;
    for (const certificate::Face& face : c.faces)
      for (const Vector<Rational>& p : face.corners) nearest = std::min(nearest, dot(at - p, at - p));
    for (const certificate::BoundAtDistance& bound : c.by_distance)
      if (nearest >= bound.outside * bound.outside && rho * Rational::exactly(d[element]) > bound.sup)
        return Judgement::violated("u lies further from the function than is verified");
  }
  return report.refusal ? Judgement::refused() : Judgement::held(2);
}

TEST(CertificateAttack, FalseClaimsOfFunctionsAreRefused) {
  const Count count = hold(Attack<FunctionInstance>{.name = "claims of certificates of functions",
                                                    .usual_instances = 6,
                                                    .make = drawn_function,
                                                    .judge = judge_function,
                                                    .text = text_of_function});
  EXPECT_LE(count.refused, std::max<std::size_t>(1, count.instances / 3));
}

/// A furnace on a sphere or an ellipsoid whose residual is known, as test::furnace_ellipsoid has it, claimed
/// by so much.
struct EllipsoidInstance {
  std::array<long, 3> axes{100, 100, 100};  ///< in hundredths
  long reflectivity = 50;
  double d = 0.25;
  double e = 0;  ///< on a sphere alone
  int m = 0;
  double claim = 3;
  std::size_t of = 0;
};

std::string text_of_ellipsoid(const EllipsoidInstance& x) {
  std::string out = "axes";
  for (const long axis : x.axes) out += " " + std::to_string(axis);
  return out + ", rho " + std::to_string(x.reflectivity) + ", d " + shortest(x.d) + ", e " + shortest(x.e) +
         ", m " + std::to_string(x.m) + ", claim " + shortest(x.claim) + ", of " + std::to_string(x.of);
}

Judgement judge_ellipsoid(const EllipsoidInstance& x) {
  const Rational rho = hundredths(x.reflectivity);
  const double sup = (1 - rho.to_double()) * x.d + x.e;
  const certificate::EllipsoidCertificate c =
      test::furnace_ellipsoid({hundredths(x.axes[0]), hundredths(x.axes[1]), hundredths(x.axes[2])}, rho, x.d,
                              x.e, x.m, x.claim * sup, static_cast<certificate::OnEllipsoid>(x.of));
  const certificate::Report report =
      certificate::check(c, {.elements = certificate::part_count(c), .seed = {}});
  if (x.claim < 1 - 1e-9)
    return report.refusal ? Judgement::held(1) : Judgement::violated("a false residual is verified");
  if (report.refusal) return Judgement::refused();
  for (const certificate::Enclosure& one : c.enclosures)
    if (abs(one.midpoint - Rational(1)) > one.radius)
      return Judgement::violated("1 lies outside what is verified");
  if (x.claim < 1.5) return Judgement::violated("what lies between points is not accounted for");
  return Judgement::held(1 + c.enclosures.size());
}

EllipsoidInstance drawn_ellipsoid(Draw& draw) {
  EllipsoidInstance x;
  const auto axis = [&] { return 20 + static_cast<long>(draw.below(40)); };
  const bool is_sphere = draw.below(2) == 0;
  const long radius = axis();
  x.axes = {is_sphere ? radius : axis(), is_sphere ? radius : axis(), is_sphere ? radius : axis()};
  x.reflectivity = 1 + static_cast<long>(draw.below(98));
  x.d = std::ldexp(1 + draw.unit(), -1 - static_cast<int>(draw.below(20)));
  if (is_sphere) {
    x.m = 1 + static_cast<int>(draw.below(24));
    x.e = x.d * std::ldexp(1 + draw.unit(), 3 - static_cast<int>(draw.below(6)));
  }
  x.claim = draw.below(2) == 0 ? 2.7 : 1 - std::pow(10.0, -4 * draw.unit()) / 2;
  x.of = draw.below(3);
  return x;
}

TEST(CertificateAttack, FalseResidualsOnEllipsoidsAreRefused) {
  const Count count = hold(Attack<EllipsoidInstance>{.name = "residuals of certificates on ellipsoids",
                                                     .usual_instances = 40,
                                                     .make = drawn_ellipsoid,
                                                     .judge = judge_ellipsoid,
                                                     .text = text_of_ellipsoid});
  EXPECT_LE(count.refused, count.instances / 4);
}

/// A problem on an ellipsoid with random polynomials, searched twice, and what certificates say of it.
struct EllipsoidProblemInstance {
  std::array<long, 3> axes{100, 100, 100};  ///< in hundredths
  std::array<long, 4> rho{};                ///< of 1, x, y z, z^2, in hundredths of what keeps rho below 1
  std::array<long, 4> emission{};           ///< of 1, x, y^2, x y z, in tenths
  int digits = 4;                           ///< of the width
};

std::string text_of_problem(const EllipsoidProblemInstance& x) {
  std::string out = "axes";
  for (const long axis : x.axes) out += " " + std::to_string(axis);
  out += ", rho";
  for (const long c : x.rho) out += " " + std::to_string(c);
  out += ", E";
  for (const long c : x.emission) out += " " + std::to_string(c);
  return out + ", digits " + std::to_string(x.digits);
}

EllipsoidProblem problem_of(const EllipsoidProblemInstance& x) {
  const auto sum = [](const std::array<long, 4>& c, const std::array<std::string, 4>& of, long over) {
    std::string out = "0";
    for (std::size_t k = 0; k < 4; ++k) {
      const std::string part = std::to_string(std::abs(c[k])) + "/" + std::to_string(over) + of[k];
      out += (c[k] < 0 ? " - " : " + ") + part;
    }
    return parse_expression(out).value();
  };
  // The half axes are at most 2: the four together are at most 1/2 in size.
  return {.half_axes = {hundredths(x.axes[0]), hundredths(x.axes[1]), hundredths(x.axes[2])},
          .reflectivity = sum(x.rho, {"", "*x/16", "*y*z/32", "*z^2/32"}, 100),
          .emission = sum(x.emission, {"", "*x", "*y^2", "*x*y*z"}, 10)};
}

/// The finer search's enclosure lies within the certificate's, or near it: both hold u.
Judgement judge_problem(const EllipsoidProblemInstance& x) {
  const EllipsoidProblem problem = problem_of(x);
  const double wanted = std::pow(10.0, -x.digits);
  const Outcome<EllipsoidEnclosure> coarse = enclose_on_ellipsoid(problem, wanted);
  const Outcome<EllipsoidEnclosure> fine = enclose_on_ellipsoid(problem, 1e-2 * wanted);
  if (!coarse || !fine || !std::isfinite(coarse->bound)) return Judgement::refused();
  const std::vector<Vector<Rational>> points{
      {problem.half_axes.x, 0, 0},
      {0, Rational(-3, 5) * problem.half_axes.y, Rational(4, 5) * problem.half_axes.z}};
  std::size_t values = 0;
  for (const certificate::OnEllipsoid of :
       {certificate::OnEllipsoid::mean, certificate::OnEllipsoid::values}) {
    const bool of_values = of == certificate::OnEllipsoid::values;
    const certificate::EllipsoidCertificate c = ellipsoid_certificate(
        problem, *coarse, "ellipsoid", of, of_values ? points : std::vector<Vector<Rational>>{});
    const certificate::Report report = certificate::check(c, {.elements = 12, .seed = "attack"});
    if (report.refusal)
      return Judgement::violated("what the search proved is refused: " + report.refusal->pointer + " " +
                                 report.refusal->says);
    for (std::size_t k = 0; k < c.enclosures.size(); ++k) {
      const Approximation near =
          of_values ? (k == 0 ? fine->at({1, 0, 0}) : fine->at({0, -0.6, 0.8})) : fine->mean;
      const double off = std::abs(c.enclosures[k].midpoint.to_double() - near.value);
      if (!(off <= (c.enclosures[k].radius.to_double() + near.radius) * (1 + 1e-9)))
        return Judgement::violated("a certificate and a finer search contradict each other");
      ++values;
    }
  }
  return Judgement::held(values);
}

EllipsoidProblemInstance drawn_problem(Draw& draw) {
  EllipsoidProblemInstance x;
  for (long& axis : x.axes) axis = 90 + static_cast<long>(draw.below(60));
  x.rho[0] = 50;
  for (std::size_t k = 1; k < 4; ++k)
    x.rho[k] = draw.below(3) == 0 ? 0 : static_cast<long>(draw.below(200)) - 100;
  for (long& c : x.emission) c = draw.below(3) == 0 ? 0 : static_cast<long>(draw.below(20)) - 10;
  x.emission[0] += 1;
  x.digits = 2 + static_cast<int>(draw.below(3));
  return x;
}

TEST(CertificateAttack, SearchesOnEllipsoidsAreVerified) {
  const Count count = hold(Attack<EllipsoidProblemInstance>{.name = "certificates of searches on ellipsoids",
                                                            .usual_instances = 5,
                                                            .make = drawn_problem,
                                                            .judge = judge_problem,
                                                            .text = text_of_problem});
  EXPECT_LE(count.refused, count.instances / 3);
}

}  // namespace
}  // namespace radcert::attack
