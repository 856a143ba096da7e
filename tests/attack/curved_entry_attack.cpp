// SPDX-License-Identifier: GPL-3.0-or-later
// Proved integrals over curved and interpolated elements, against the judge in balls of curved_judge.h.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "radcert/collocation/certified/certified_chart_entries.h"
#include "radcert/core/text.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/quadrature/certified/certified_kernel_sums.h"
#include "radcert/quadrature/certified/kernel_rule.h"
#include "radcert/scalar/ball_precision.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/paraboloid_cap.h"
#include "radcert/surface/catalogue/spherical_cap.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/triangulation/interpolated_surface.h"
#include "tests/attack/attack.h"
#include "tests/attack/curved_judge.h"
#include "tests/quadrature/one_and_coordinate.h"

namespace radcert::attack {
namespace {

/// Chebyshev's polynomial of degree 4 over an element: the rule of order 2 is off by about as much as its
/// bound allows.
class Oscillating final : public ElementFunctions {
public:
  explicit Oscillating(std::size_t coordinate) : coordinate_(coordinate) {}
  std::size_t size() const override { return 1; }
  void values(const ElementPoint<BoundedDouble>& at, std::span<BoundedDouble> out) const override {
    out[0] = of(at.in_element.x[coordinate_]);
  }
  double bound(const ElementPoint<TaylorModel>& at) const override {
    return of(at.in_element.x[coordinate_]).magnitude_bound();
  }
  /// T_4(2x - 1) = 1 - 32 x + 160 x^2 - 256 x^3 + 128 x^4.
  std::vector<ElementPolynomial> exactly() const {
    ElementPolynomial f;
    int power = 0;
    for (const int coefficient : {1, -32, 160, -256, 128}) {
      f.terms.push_back({coefficient, coordinate_ == 0 ? power : 0, coordinate_ == 0 ? 0 : power});
      ++power;
    }
    return {f};
  }

private:
  template <class R>
  static R of(const R& x) {
    const R z = R(2) * x - R(1);
    const R square = z * z;
    return R(8) * (square * (square - R(1))) + R(1);
  }
  std::size_t coordinate_;
};

/// 1, told as a number that is as far off as its bound says.
class Displaced final : public ElementFunctions {
public:
  explicit Displaced(double by) : by_(by) {}
  std::size_t size() const override { return 1; }
  void values(const ElementPoint<BoundedDouble>& /*at*/, std::span<BoundedDouble> out) const override {
    out[0] = {1 + by_, std::abs(by_) * (1 + 0x1p-20)};
  }
  double bound(const ElementPoint<TaylorModel>& /*at*/) const override { return 1; }
  static std::vector<ElementPolynomial> exactly() { return {{{{1, 0, 0}}}}; }

private:
  double by_;
};

enum class Beside { one_and_coordinate, oscillating, displaced };

struct Entry {
  Beside beside = Beside::one_and_coordinate;
  std::size_t surface = 0;
  std::size_t element = 0;
  SurfacePoint<double> point;  ///< dyadic parameters
  double demand = 1e-9;        ///< for displaced values: how far they are off
  std::size_t coordinate = 0;  ///< in which one a function oscillates
};

struct Subject {
  std::string name;
  Surface surface;
  Triangulation triangulation;
  std::vector<JudgedPatch> patches;
};

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = [] {
    std::vector<Subject> found;
    const auto add = [&found](const std::string& name, const Surface& surface) {
      for (const int level : {0, 1, 2, 3})
        found.push_back({name + ", level " + std::to_string(level), surface, triangulate(surface, level),
                         judged_patches(surface, 0)});
      for (const int degree : {1, 2, 3}) {
        InterpolatedSurface made = interpolate(surface, triangulate(surface, 1), degree);
        std::vector<JudgedPatch> patches = judged_patches(made.surface, degree);
        found.push_back({name + ", interpolated by degree " + std::to_string(degree), std::move(made.surface),
                         std::move(made.triangulation), std::move(patches)});
      }
    };
    // Small elements that are seen in the face: the first subject.
    found.push_back({"two_piece 2, level 5", two_piece(2), triangulate(two_piece(2), 5),
                     judged_patches(two_piece(2), 0)});
    add("two_piece 2", two_piece(2));
    add("two_piece 4", two_piece(4));
    add("sphere", sphere());
    add("ellipsoid 1 2 3", ellipsoid(1, 2, 3));
    add("ellipsoid 1 1 1/20", ellipsoid(1, 1, Rational(1, 20)));
    add("ellipsoid 1/50 1 2", ellipsoid(Rational(1, 50), 1, 2));
    add("paraboloid_cap", paraboloid_cap());
    add("spherical_cap 1/3", spherical_cap(Rational(1, 3)));
    add("cylinder 1 2", cylinder(1, 2));
    add("cylinder 1 1/30", cylinder(1, Rational(1, 30)));
    return found;
  }();
  return all;
}

/// A dyadic number of [0,1], often near an end.
double dyadic(Draw& draw) {
  const double x = static_cast<double>(1 + draw.below(1023)) / 1024;
  switch (draw.below(5)) {
    case 0: return std::ldexp(x, -static_cast<int>(draw.below(24)));
    case 1: return 1 - std::ldexp(x, -static_cast<int>(draw.below(24)));
    default: return x;
  }
}

/// A point of an element; its parameters are dyadic.
SurfacePoint<double> point_in(const ParameterTriangle& t, double b, double c) {
  return {t.chart, t.vertices[0] + b * (t.vertices[1] - t.vertices[0]) + c * (t.vertices[2] - t.vertices[0])};
}

SurfacePoint<double> drawn_point_in(const ParameterTriangle& t, Draw& draw) {
  double b = dyadic(draw);
  double c = dyadic(draw);
  if (b + c > 1) {
    b = 1 - b;
    c = 1 - c;
  }
  return point_in(t, b, c);
}

Entry make_entry(Draw& draw) {
  Entry e;
  e.surface = draw.below(subjects().size());
  const std::vector<ParameterTriangle>& triangles = subjects()[e.surface].triangulation.triangles;
  e.element = draw.below(triangles.size());
  const std::size_t from = draw.below(3) == 0 ? e.element : draw.below(triangles.size());
  e.point = drawn_point_in(triangles[from], draw);
  e.demand = std::array{1e-3, 1e-6, 1e-9, 1e-11, 1e-12, 1e-13, 1e-14}[draw.below(7)];
  return e;
}

/// Where the bounds are close to the errors: small elements that are seen in the face, or from a corner of
/// their own.
Entry make_close_entry(Draw& draw) {
  Entry e;
  e.beside = draw.below(3) == 0 ? Beside::displaced : Beside::oscillating;
  const bool own = draw.below(2) == 0;
  do {
    e.surface = own || draw.below(2) == 0 ? draw.below(subjects().size()) : 0;
  } while (subjects()[e.surface].triangulation.triangles.size() < 128);
  const Subject& s = subjects()[e.surface];
  const std::vector<ParameterTriangle>& triangles = s.triangulation.triangles;
  const std::size_t count = triangles.size();
  do {
    e.element = draw.below(count);
  } while (own && s.surface.charts[triangles[e.element].chart].facts().flat_in());
  e.point = own ? point_in(triangles[e.element], 0, 0)
                : drawn_point_in(triangles[(e.element + count / 2) % count], draw);
  e.demand = std::ldexp(draw.below(2) == 0 ? 1.0 : -1.0, -static_cast<int>(8 + draw.below(36)));
  e.coordinate = draw.below(2);
  return e;
}

std::string text(const Entry& e) {
  return subjects()[e.surface].name + ", element " + std::to_string(e.element) + ", point (" +
         shortest(e.point.at.s) + ", " + shortest(e.point.at.t) + ") of chart " +
         std::to_string(e.point.chart) + ", demand " + shortest(e.demand) + ", functions " +
         std::to_string(static_cast<int>(e.beside));
}

/// Whether a value lies within its radius of the truth.
Judgement held_against(const std::string& what, double value, double radius, const Ball& truth) {
  const BallPrecision precision(160);
  const Ball off = abs(Ball(value) - truth);
  if (!truth.is_finite() || !std::isfinite(radius) || certainly_less(Ball(radius), off))
    return Judgement::violated(what + ": " + shortest(value) + " +- " + shortest(radius) + ", truth " +
                               truth.to_text());
  return Judgement::held();
}

/// The integrals over one element at one demand after the other.
Judgement judged_at(const Entry& e, const ElementFunctions& functions,
                    const std::vector<ElementPolynomial>& exactly, std::span<const double> demands) {
  const Subject& s = subjects()[e.surface];
  const ParameterTriangle& element = s.triangulation.triangles[e.element];
  const Triangulation alone{{element}};
  const std::vector<SurfacePoint<Rational>> points{
      {e.point.chart, {Rational::exactly(e.point.at.s), Rational::exactly(e.point.at.t)}}};
  std::optional<std::vector<Ball>> truth;
  for (const double demand : demands) {
    const CertifiedKernelSums sums(s.surface, alone, functions, points, demand);
    std::vector<double> values(functions.size());
    std::vector<double> radius(functions.size());
    if (!sums.element(0, values, radius)) continue;
    if (!truth) truth = judged_integrals(s.patches, points[0], element, exactly);
    if (!truth) return Judgement::refused();
    for (std::size_t j = 0; j < values.size(); ++j)
      if (Judgement found =
              held_against("function " + std::to_string(j) + " at the demand " + shortest(demand), values[j],
                           radius[j], (*truth)[j]);
          found.kind != Judgement::Kind::held)
        return found;
  }
  return truth ? Judgement::held() : Judgement::refused();
}

Judgement judge(const Entry& e) {
  switch (e.beside) {
    case Beside::one_and_coordinate:
      return judged_at(e, sample::OneAndCoordinate(), {{{{1, 0, 0}}}, {{{1, 0, 1}}}}, std::array{e.demand});
    case Beside::displaced:
      return judged_at(e, Displaced(e.demand), Displaced::exactly(), std::array{std::abs(e.demand)});
    case Beside::oscillating: {
      // A rule has its largest error, next to its bound, where it is only just allowed.
      std::vector<double> demands;
      for (double demand = 0x1p-7; demand < 0x1p8; demand *= 1.06) demands.push_back(demand);
      const Oscillating functions(e.coordinate);
      return judged_at(e, functions, functions.exactly(), demands);
    }
  }
  return Judgement::refused();
}

/// A row of the matrix for two elements.
struct Row {
  std::size_t surface = 0;
  std::array<std::size_t, 2> elements{};
  int degree = 0;
  Rational inset;
  double demand = 1e-9;
  std::vector<double> reflectivity;  ///< a node
  std::size_t row = 0;
};

Row make_row(Draw& draw) {
  Row r;
  // Polynomials on small elements that are not very thin, where a row costs little.
  const auto costs_little = [](const Subject& s) {
    return s.patches.front().kind == JudgedPatch::Kind::polynomial &&
           s.triangulation.triangles.size() >= 16 && s.name.find('/') == std::string::npos;
  };
  do {
    r.surface = draw.below(subjects().size());
  } while (!costs_little(subjects()[r.surface]));
  const std::size_t count = subjects()[r.surface].triangulation.triangles.size();
  for (std::size_t& element : r.elements) element = draw.below(count);
  if (r.elements[0] == r.elements[1]) r.elements[1] = (r.elements[0] + 1) % count;
  r.degree = static_cast<int>(draw.below(3));
  const std::array insets{Rational(1, 6), Rational(1, 10), Rational(1, 4)};
  r.inset = r.degree == 0 ? Rational(0) : insets[draw.below(3)];
  r.demand = std::array{1e-6, 1e-9, 1e-11, 1e-12}[draw.below(4)];
  const std::size_t nodes = static_cast<std::size_t>((r.degree + 1) * (r.degree + 2));
  for (std::size_t i = 0; i < nodes; ++i) {
    // A reflectivity beyond 1 is taken as well: the radius grows with it.
    const std::array values{0.0, 1.0, 0.5, -0.75, draw.unit(), 1e-3, 1e9, -1e9 * draw.unit()};
    r.reflectivity.push_back(values[draw.below(values.size())]);
  }
  r.row = draw.below(nodes);
  return r;
}

std::string text(const Row& r) {
  std::string line = subjects()[r.surface].name + ", elements " + std::to_string(r.elements[0]) + " and " +
                     std::to_string(r.elements[1]) + ", degree " + std::to_string(r.degree) + ", inset " +
                     r.inset.to_text() + ", demand " + shortest(r.demand) + ", row " + std::to_string(r.row) +
                     ", reflectivity";
  for (const double rho : r.reflectivity) line += " " + shortest(rho);
  return line;
}

Judgement judge_row(const Row& r) {
  const Subject& s = subjects()[r.surface];
  const auto& all = s.triangulation.triangles;
  const Triangulation pair{{all[r.elements[0]], all[r.elements[1]]}};
  const LagrangeFunctions functions = lagrange_functions(inset_nodes(r.degree, r.inset)).value();
  const std::size_t p = functions.size();
  const Outcome<CertifiedEntries> found =
      certified_chart_entries(s.surface, pair, functions, r.reflectivity, r.demand);
  if (!found) return Judgement::refused();
  // A radius is much larger than the error: that it grows with the reflectivity is held against the radii
  // without one.
  const std::vector<double> ones(r.reflectivity.size(), 1.0);
  const Outcome<CertifiedEntries> unscaled =
      certified_chart_entries(s.surface, pair, functions, ones, r.demand);
  if (!unscaled) return Judgement::violated("refused for the reflectivity 1: " + unscaled.reason());
  for (std::size_t i = 0; i < ones.size(); ++i)
    for (std::size_t j = 0; j < ones.size(); ++j) {
      const double least = std::abs(r.reflectivity[i]) * unscaled->radius(i, j) * (1 - 1e-9);
      if (!(found->radius(i, j) >= least))
        return Judgement::violated("entry " + std::to_string(i) + ", " + std::to_string(j) +
                                   " has the radius " + shortest(found->radius(i, j)) +
                                   ", without reflectivity " + shortest(unscaled->radius(i, j)));
    }
  std::vector<std::array<Rational, 2>> points;
  for (const Barycentric<Rational>& node : functions.nodes()) points.push_back({node.x[0], node.x[1]});
  const std::vector<ElementPolynomial> lagrange = judged_lagrange(points, r.degree);
  const ParameterTriangle& of_row = pair.triangles[r.row / p];
  SurfacePoint<Rational> at{of_row.chart, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational& x = functions.nodes()[r.row % p].x[i];
    at.at.s += x * Rational::exactly(of_row.vertices[i].s);
    at.at.t += x * Rational::exactly(of_row.vertices[i].t);
  }
  bool judged = false;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto integrals = judged_integrals(s.patches, at, pair.triangles[k], lagrange);
    if (!integrals) continue;
    judged = true;
    const BallPrecision precision(128);
    for (std::size_t j = 0; j < p; ++j) {
      const Ball truth = Ball(r.reflectivity[r.row]) / Ball::pi() * (*integrals)[j];
      const std::size_t column = k * p + j;
      if (Judgement judgement =
              held_against("column " + std::to_string(column), found->entries(r.row, column),
                           found->radius(r.row, column), truth);
          judgement.kind != Judgement::Kind::held)
        return judgement;
    }
  }
  return judged ? Judgement::held() : Judgement::refused();
}

/// A rule for the kernel whose nodes and points are off by as much as is said of them.
struct Rule {
  int order = 2;
  std::uint64_t seed = 0;
  double size = 1e-2;   ///< of the cloud of nodes, at the distance 1
  double slant = 0;     ///< of the normals against the line of sight
  double position = 0;  ///< what each is off by
  double position_of_p = 0;
  double normal = 0;
  double normal_of_p = 0;
  double weight = 0;
};

Rule make_rule(Draw& draw) {
  Rule r;
  r.order = std::array{2, 3, 5, 12}[draw.below(4)];
  r.seed = draw.bits();
  r.size = std::ldexp(1.0, -static_cast<int>(draw.below(20)));
  r.slant = draw.below(2) == 0 ? 0 : draw.unit();
  // Mostly one of them alone: the parts of the bound are seen one by one.
  const std::array<double*, 5> each{&r.position, &r.position_of_p, &r.normal, &r.normal_of_p, &r.weight};
  const std::size_t alone = draw.below(7);
  for (std::size_t i = 0; i < each.size(); ++i)
    if (alone == i || alone == 5) *each[i] = std::ldexp(1.0, -24 - static_cast<int>(draw.below(24)));
  return r;
}

Judgement judge_rule(const Rule& r) {
  Draw draw(r.seed);
  const BallPrecision precision(160);
  using Numbers = std::array<double, 3>;
  const auto signed_unit = [&draw] { return 2 * draw.unit() - 1; };
  // P is near 0 and sees the nodes around (0, 0, 1); the normals lean in the plane of x and z.
  const Numbers point{signed_unit() * r.size, signed_unit() * r.size, 0};
  const auto normal = [&r](double sign) {
    const double along = std::sqrt(1 - r.slant * r.slant);
    return Numbers{sign * r.slant, 0, sign * along};
  };
  const Numbers n_p = normal(1);
  const double towards = draw.below(2) == 0 ? 1 : -1;  // all errors make the sum larger, or all smaller
  const auto displaced = [](const Numbers& of, const Numbers& by) {
    return std::array<Ball, 3>{Ball(of[0]) + Ball(by[0]), Ball(of[1]) + Ball(by[1]),
                               Ball(of[2]) + Ball(by[2])};
  };
  const std::array<Ball, 3> true_point = displaced(point, {0, 0, towards * r.position_of_p});
  // A normal turns towards the line of sight, or away from it, or is longer, which the bound allows for as
  // well.
  const std::array<Ball, 3> true_n_p = displaced(n_p, {0, 0, towards * r.normal_of_p});

  KernelRule rule(1);
  rule.begin(r.order);
  Ball truth;
  for (int k = 0; k < r.order * r.order; ++k) {
    const Numbers q{signed_unit() * r.size, signed_unit() * r.size, 1 + signed_unit() * r.size};
    const Numbers n_q = normal(-1);
    const double w = 0.5 + draw.unit();
    rule.add(
        {BoundedDouble::exactly(q[0]), BoundedDouble::exactly(q[1]), BoundedDouble(q[2], r.position)},
        {BoundedDouble::exactly(n_q[0]), BoundedDouble::exactly(n_q[1]), BoundedDouble(n_q[2], r.normal)},
        std::array{BoundedDouble(w, r.weight)});
    const std::array<Ball, 3> true_q = displaced(q, {0, 0, -towards * r.position});
    const std::array<Ball, 3> true_n_q = displaced(n_q, {0, 0, -towards * r.normal});
    Ball squared;
    Ball at_p;
    Ball at_q;
    for (std::size_t i = 0; i < 3; ++i) {
      const Ball d = true_q[i] - true_point[i];
      squared += d * d;
      at_p += d * true_n_p[i];
      at_q += d * true_n_q[i];
    }
    truth += -(at_p * at_q) / (squared * squared) * (Ball(w) + Ball(towards * r.weight));
  }
  KernelRule::Points points;
  for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
    points.position.x.set_lane(lane, point[0]);
    points.position.y.set_lane(lane, point[1]);
    points.position.z.set_lane(lane, point[2]);
    points.normal.x.set_lane(lane, n_p[0]);
    points.normal.y.set_lane(lane, n_p[1]);
    points.normal.z.set_lane(lane, n_p[2]);
  }
  KernelRule::Sums sums;
  rule.take_sums(points, sums);
  std::array<double, 1> radius{};
  rule.rounding(sums, 3, {.position = r.position_of_p, .normal = r.normal_of_p}, radius);
  if (!std::isfinite(radius[0])) return Judgement::refused();
  return held_against("the sum", sums.sum[0].lane(3), radius[0], truth);
}

std::string text(const Rule& r) {
  return "order " + std::to_string(r.order) + ", size " + shortest(r.size) + ", slant " + shortest(r.slant) +
         ", off by: positions " + shortest(r.position) + ", P " + shortest(r.position_of_p) + ", normals " +
         shortest(r.normal) + ", that at P " + shortest(r.normal_of_p) + ", weights " + shortest(r.weight);
}

TEST(CurvedEntryAttack, EnclosesScaledEntries) {
  hold(Attack<Row>{.name = "certified curved entries times reflectivities",
                   .usual_instances = 5,
                   .make = make_row,
                   .judge = judge_row,
                   .text = [](const Row& r) { return text(r); }});
}

TEST(CurvedEntryAttack, EnclosesSumsOverRulesThatAreOff) {
  hold(Attack<Rule>{.name = "sums of the kernel over rules that are off",
                    .usual_instances = 400,
                    .make = make_rule,
                    .judge = judge_rule,
                    .text = [](const Rule& r) { return text(r); }});
}

TEST(CurvedEntryAttack, EnclosesTheIntegrals) {
  hold(Attack<Entry>{.name = "certified curved and interpolated entries",
                     .usual_instances = 12,
                     .make = make_entry,
                     .judge = judge,
                     .text = [](const Entry& e) { return text(e); },
                     .smaller =
                         [](const Entry& e) {
                           std::vector<Entry> found;
                           for (const double demand : {1e-3, 1e-6})
                             if (demand > e.demand) {
                               found.push_back(e);
                               found.back().demand = demand;
                             }
                           return found;
                         }});
}

TEST(CurvedEntryAttack, EnclosesWhatIsAsFarOffAsItsBound) {
  hold(Attack<Entry>{.name = "certified curved entries close to their bounds",
                     .usual_instances = 36,
                     .make = make_close_entry,
                     .judge = judge,
                     .text = [](const Entry& e) { return text(e); }});
}

}  // namespace
}  // namespace radcert::attack
