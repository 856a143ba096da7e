// SPDX-License-Identifier: GPL-3.0-or-later
// Proved integrals over curved and interpolated elements, against an adaptive product rule of this file's own.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "radcert/collocation/certified_kernel_sums.h"
#include "radcert/core/text.h"
#include "radcert/surface/catalogue/cylinder.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/paraboloid_cap.h"
#include "radcert/surface/catalogue/spherical_cap.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/triangulation/interpolated_surface.h"
#include "tests/attack/attack.h"

namespace radcert::attack {
namespace {

using Point = ParameterPoint<double>;

/// A Gauss rule on [0,1]: zeros of Legendre's polynomial by Newton's method.
struct Gauss {
  std::vector<long double> x;
  std::vector<long double> w;
  explicit Gauss(int n) {
    for (int i = 0; i < n; ++i) {
      long double z = std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (n + 0.5L));
      long double slope = 1;
      for (int step = 0; step < 8; ++step) {
        long double p = 1;
        long double before = 0;
        for (int k = 1; k <= n; ++k) {
          const long double next = ((2 * k - 1) * z * p - (k - 1) * before) / k;
          before = p;
          p = next;
        }
        slope = n * (before - z * p) / (1 - z * z);
        z -= p / slope;
      }
      x.push_back((1 - z) / 2);
      w.push_back(1 / ((1 - z * z) * slope * slope));
    }
  }
};

/// Int G over a triangle of parameters, and Int G x_2: adaptive halving of the unit square, from which rays from a corner or from P
/// run over the triangle.
class Judge {
public:
  struct Sum {
    std::array<long double, 2> value{};
    long double error = 0;
    bool complete = true;
  };

  Judge(const Surface& surface, const SurfacePoint<double>& p, const ParameterTriangle& element)
      : chart_(surface.charts[element.chart].in<double>()), element_(element) {
    const Frame<double> frame = surface.charts[p.chart].in<double>().frame(p.at);
    p_ = frame.point;
    normal_ = unit_normal(frame);
    const auto& v = element.vertices;
    const bool own = p.chart == element.chart && least_coordinate(p.at) > 0;
    if (own) {
      for (std::size_t i = 0; i < 3; ++i) triangles_.push_back({p.at, v[i], v[(i + 1) % 3]});
    } else {
      triangles_.push_back({v[0], v[1], v[2]});
    }
  }

  Sum sum() {
    for (const std::array<Point, 3>& triangle : triangles_) halve(triangle, 0, 1, 0, 1, 0);
    return sum_;
  }

private:
  double least_coordinate(const Point& q) const {
    const std::array<double, 3> x = coordinates(q);
    return std::min({x[0], x[1], x[2]});
  }
  std::array<double, 3> coordinates(const Point& q) const {
    const auto& v = element_.vertices;
    const double whole = cross(v[1] - v[0], v[2] - v[0]);
    return {cross(v[1] - q, v[2] - q) / whole, cross(v[2] - q, v[0] - q) / whole,
            cross(v[0] - q, v[1] - q) / whole};
  }

  std::array<long double, 2> rule(const Gauss& gauss, const std::array<Point, 3>& t, double l0, double l1,
                                  double m0, double m1) const {
    std::array<long double, 2> found{};
    const Point a = t[1] - t[0];
    const Point b = t[2] - t[0];
    const long double area = std::abs(cross(a, b));
    for (std::size_t i = 0; i < gauss.x.size(); ++i)
      for (std::size_t k = 0; k < gauss.x.size(); ++k) {
        const double l = l0 + (l1 - l0) * static_cast<double>(gauss.x[i]);
        const double m = m0 + (m1 - m0) * static_cast<double>(gauss.x[k]);
        const Point q = t[0] + l * ((1 - m) * a + m * b);
        const Frame<double> frame = chart_.frame(q);
        const Vector<double> d = frame.point - p_;
        const auto squared = static_cast<long double>(dot(d, d));
        const long double g =
            -static_cast<long double>(dot(d, normal_)) * dot(d, frame.area_normal) / (squared * squared);
        const long double term = gauss.w[i] * gauss.w[k] * (l1 - l0) * (m1 - m0) * l * area * g;
        found[0] += term;
        found[1] += term * coordinates(q)[1];
      }
    return found;
  }

  void halve(const std::array<Point, 3>& t, double l0, double l1, double m0, double m1, int depth) {
    static const Gauss coarse(10);
    static const Gauss fine(16);
    if (++cells_ > 4000) {
      sum_.complete = false;
      return;
    }
    const auto a = rule(coarse, t, l0, l1, m0, m1);
    const auto b = rule(fine, t, l0, l1, m0, m1);
    const long double difference = std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1]));
    if (difference <= 1e-15L || (depth > 20 && difference <= 1e-13L)) {
      for (std::size_t j = 0; j < 2; ++j) sum_.value[j] += b[j];
      sum_.error += difference;
      return;
    }
    const double l = (l0 + l1) / 2;
    const double m = (m0 + m1) / 2;
    halve(t, l0, l, m0, m, depth + 1);
    halve(t, l0, l, m, m1, depth + 1);
    halve(t, l, l1, m0, m, depth + 1);
    halve(t, l, l1, m, m1, depth + 1);
  }

  const ChartIn<double>& chart_;
  const ParameterTriangle& element_;
  Vector<double> p_;
  Vector<double> normal_;
  std::vector<std::array<Point, 3>> triangles_;
  std::size_t cells_ = 0;
  Sum sum_;
};

/// 1 and the second barycentric coordinate.
class OneAndCoordinate final : public ElementFunctions {
public:
  std::size_t size() const override { return 2; }
  void values(const ElementPoint<BoundedDouble>& at, std::span<BoundedDouble> out) const override {
    out[0] = 1;
    out[1] = at.in_element.x[1];
  }
  double bound(const ElementPoint<TaylorModel>& at) const override {
    return std::max(1.0, at.in_element.x[1].magnitude_bound());
  }
};

struct Entry {
  std::size_t surface = 0;
  std::size_t element = 0;
  SurfacePoint<double> point;  ///< dyadic parameters
  double demand = 1e-9;
};

struct Subject {
  std::string name;
  Surface surface;
  Triangulation triangulation;
};

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = [] {
    std::vector<Subject> found;
    const auto add = [&found](const std::string& name, const Surface& surface) {
      for (const int level : {0, 1, 2})
        found.push_back({name + ", level " + std::to_string(level), surface, triangulate(surface, level)});
      for (const int degree : {1, 2, 3}) {
        InterpolatedSurface made = interpolate(surface, triangulate(surface, 1), degree);
        found.push_back({name + ", interpolated by degree " + std::to_string(degree), std::move(made.surface),
                         std::move(made.triangulation)});
      }
    };
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

Entry make_entry(Draw& draw) {
  Entry e;
  e.surface = draw.below(subjects().size());
  const Subject& s = subjects()[e.surface];
  e.element = draw.below(s.triangulation.triangles.size());
  const std::size_t from = draw.below(3) == 0 ? e.element : draw.below(s.triangulation.triangles.size());
  const ParameterTriangle& t = s.triangulation.triangles[from];
  double b = dyadic(draw);
  double c = dyadic(draw);
  if (b + c > 1) {
    b = 1 - b;
    c = 1 - c;
  }
  e.point = {t.chart,
             t.vertices[0] + b * (t.vertices[1] - t.vertices[0]) + c * (t.vertices[2] - t.vertices[0])};
  e.demand = std::vector{1e-3, 1e-6, 1e-9, 1e-11}[draw.below(4)];
  return e;
}

std::string text(const Entry& e) {
  return subjects()[e.surface].name + ", element " + std::to_string(e.element) + ", point (" +
         shortest(e.point.at.s) + ", " + shortest(e.point.at.t) + ") of chart " +
         std::to_string(e.point.chart) + ", demand " + shortest(e.demand);
}

Judgement judge(const Entry& e) {
  const Subject& s = subjects()[e.surface];
  const ParameterTriangle& element = s.triangulation.triangles[e.element];
  if (in_one_plane(s.surface.charts[e.point.chart], s.surface.charts[element.chart]))
    return Judgement::refused();
  const OneAndCoordinate functions;
  const Triangulation alone{{element}};
  const std::vector<SurfacePoint<Rational>> points{
      {e.point.chart, {Rational::exactly(e.point.at.s), Rational::exactly(e.point.at.t)}}};
  const CertifiedKernelSums sums(s.surface, alone, functions, points, e.demand);
  std::array<double, 2> values{};
  std::array<double, 2> radius{};
  if (!sums.element(0, values, radius)) return Judgement::refused();
  Judge independent(s.surface, e.point, element);
  const Judge::Sum truth = independent.sum();
  if (!truth.complete) return Judgement::refused();
  for (std::size_t j = 0; j < 2; ++j) {
    const auto off = static_cast<double>(std::abs(static_cast<long double>(values[j]) - truth.value[j]));
    // The judge's points are rounded to double.
    if (!(off <= radius[j] + static_cast<double>(truth.error) + 1e-12))
      return Judgement::violated("function " + std::to_string(j) + ": " + shortest(values[j]) + " +- " +
                                 shortest(radius[j]) + ", truth " +
                                 shortest(static_cast<double>(truth.value[j])) + " +- " +
                                 shortest(static_cast<double>(truth.error)));
  }
  return Judgement::held();
}

TEST(CurvedEntryAttack, EnclosesTheIntegrals) {
  hold(Attack<Entry>{.name = "certified curved and interpolated entries",
                     .usual_instances = 20,
                     .make = make_entry,
                     .judge = judge,
                     .text = text,
                     .smaller = [](const Entry& e) {
                       std::vector<Entry> found;
                       for (const double demand : {1e-3, 1e-6})
                         if (demand > e.demand) {
                           found.push_back(e);
                           found.back().demand = demand;
                         }
                       return found;
                     }});
}

}  // namespace
}  // namespace radcert::attack
