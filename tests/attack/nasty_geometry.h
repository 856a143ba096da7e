// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "tests/closed_form/polar_kernel_integral.h"
#include "tests/scalar/draw.h"

namespace radcert::attack {

using Point = Vector<double>;
using Corners = std::array<Point, 3>;

/// A point that looks at a triangle, all numbers exact.
struct Sight {
  Corners corners;
  Point p;
  Point normal;
};

inline Vector<Rational> exactly(const Point& a) {
  return {Rational::exactly(a.x), Rational::exactly(a.y), Rational::exactly(a.z)};
}
inline judge::Triple triple(const Point& a) {
  return {Rational::exactly(a.x), Rational::exactly(a.y), Rational::exactly(a.z)};
}
inline std::string text(const Point& a) {
  return "(" + shortest(a.x) + ", " + shortest(a.y) + ", " + shortest(a.z) + ")";
}
inline std::string text(const Corners& c) { return text(c[0]) + " " + text(c[1]) + " " + text(c[2]); }
inline std::string text(const Sight& s) {
  return "corners " + text(s.corners) + "\nP " + text(s.p) + "\nnormal " + text(s.normal);
}

inline bool is_degenerate(const Corners& c) {
  const judge::Triple n =
      judge::cross(judge::minus(triple(c[1]), triple(c[0])), judge::minus(triple(c[2]), triple(c[0])));
  return n[0].sign() == 0 && n[1].sign() == 0 && n[2].sign() == 0;
}
/// Whether p lies in the plane of the corners.
inline bool is_in_plane(const Corners& c, const Point& p) {
  const judge::Triple n =
      judge::cross(judge::minus(triple(c[1]), triple(c[0])), judge::minus(triple(c[2]), triple(c[0])));
  return judge::dot(n, judge::minus(triple(p), triple(c[0]))).sign() == 0;
}
inline judge::Polygon judged(const Corners& c) {
  return judge::triangle(triple(c[0]), triple(c[1]), triple(c[2]));
}

/// What makes geometry hard: nearly coplanar, nearly touching, edge-on, slivers, points over edges and
/// corners, large ratios and offsets, steps of one unit in the last place.
class NastyGeometry {
public:
  explicit NastyGeometry(Draw& draw) : draw_(draw) {}

  double sign() { return draw_.below(2) == 0 ? 1 : -1; }
  double signed_unit() { return 2 * draw_.unit() - 1; }
  /// 10^e, e uniform.
  double power_of_ten(double low, double high) { return std::pow(10.0, low + (high - low) * draw_.unit()); }
  double whole(int bits) { return std::floor(std::ldexp(signed_unit(), bits)); }
  Point whole_point(int bits) { return {whole(bits), whole(bits), whole(bits)}; }
  Point direction() {
    Point d{signed_unit(), signed_unit(), signed_unit()};
    return norm(d) > 0.01 ? d : Point{0, 0, 1};
  }
  double nudged(double x) {
    const auto steps = draw_.below(4);
    for (std::size_t i = 0; i < steps; ++i) x = std::nextafter(x, sign() * HUGE_VAL);
    return x;
  }
  Point nudged(const Point& a) { return {nudged(a.x), nudged(a.y), nudged(a.z)}; }

  Corners triangle() {
    for (;;) {
      Corners c = some_triangle();
      if (!is_degenerate(c)) return c;
    }
  }

  /// The plane's normal, rounded, of about unit length.
  static Point rounded_normal(const Corners& c) {
    const judge::Triple n =
        judge::cross(judge::minus(triple(c[1]), triple(c[0])), judge::minus(triple(c[2]), triple(c[0])));
    double largest = 0;
    Rational scale = 0;
    for (const Rational& part : n) scale = std::max(scale, abs(part));
    const Point m{(n[0] / scale).to_double(), (n[1] / scale).to_double(), (n[2] / scale).to_double()};
    largest = norm(m);
    return (1 / largest) * m;
  }
  static double size(const Corners& c) {
    return std::max({norm(c[1] - c[0]), norm(c[2] - c[1]), norm(c[0] - c[2])});
  }

  /// Two triangles of whole numbers with a common edge, almost in one plane: a corner of the second lies off
  /// the plane of the first by a part 2^-bits of its size at most, or by as little as whole numbers can, a
  /// part 2^(-3 bits).
  std::pair<Corners, Corners> nearly_coplanar_pair(int bits) {
    for (;;) {
      const Point a = draw_.below(2) == 0 ? Point{0, 0, 0} : whole_point(bits);
      const Point b = whole_point(bits);
      const Point c = whole_point(bits);
      const Point d = draw_.below(2) == 0 ? rounded_neighbour(a, b, c) : closest_neighbour(a, b, c);
      const Corners first{a, b, c};
      const Corners second{c, b, d};
      if (is_degenerate(first) || is_degenerate(second) || is_in_plane(first, d)) continue;
      return {first, second};
    }
  }

  Sight sight() {
    for (;;) {
      Sight s = some_sight();
      const bool is_finite = std::isfinite(s.p.x + s.p.y + s.p.z);
      if (is_finite && !(s.normal == Point{0, 0, 0}) && !is_in_plane(s.corners, s.p)) return s;
    }
  }

private:
  Point rounded_neighbour(const Point& a, const Point& b, const Point& c) {
    const double s = 3 * signed_unit();
    const double t = draw_.below(4) == 0 ? power_of_ten(-6, 0) : draw_.unit();
    const Point away = b + s * (c - b) + t * (b - a + (draw_.below(2) == 0 ? c - a : Point{0, 0, 0}));
    return {std::round(away.x), std::round(away.y), std::round(away.z)};
  }

  /// x and y with a x + b y = gcd(a, b) > 0.
  __extension__ typedef __int128
      Whole;  // NOLINT(modernize-use-using): the extension is a prefix of a declaration
  struct Bezout {
    Whole x = 1;
    Whole y = 0;
    Whole divisor = 0;
  };
  static Bezout bezout(Whole a, Whole b) {
    if (b == 0) return {a < 0 ? -1 : 1, 0, a < 0 ? -a : a};
    const Bezout rest = bezout(b, a % b);
    return {rest.y, rest.x - a / b * rest.y, rest.divisor};
  }

  /// A whole point d for which the determinant of b - a, c - a and d - a, over the common divisor of their
  /// normal, is a small number; |coordinates| at most 2^27.
  Point closest_neighbour(const Point& a, const Point& b, const Point& c) {
    using Vector3 = std::array<Whole, 3>;
    const auto whole_vector = [](const Point& v) {
      return Vector3{static_cast<Whole>(v.x), static_cast<Whole>(v.y), static_cast<Whole>(v.z)};
    };
    const Vector3 e = whole_vector(b - a);
    const Vector3 f = whole_vector(c - a);
    const Vector3 n{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
    const Bezout two = bezout(n[0], n[1]);
    const Bezout three = bezout(two.divisor, n[2]);
    if (three.divisor == 0) return a;
    const Whole level = static_cast<Whole>(1 + draw_.below(6)) * (draw_.below(2) == 0 ? 1 : -1);
    // Any multiple of n[2] / divisor may be taken off the factor of the first two.
    const Whole period = n[2] == 0 ? 1 : n[2] / three.divisor;
    const Whole factor = n[2] == 0 ? three.x : three.x % period;
    const Whole last = n[2] == 0 ? 0 : (three.divisor - factor * two.divisor) / n[2];
    Vector3 v{level * two.x * factor, level * two.y * factor, level * last};
    // Back to the neighbourhood of the triangle, by whole multiples of its sides.
    for (int step = 0; step < 8; ++step) {
      std::array<double, 3> g{};
      std::array<double, 3> ed{};
      std::array<double, 3> fd{};
      for (std::size_t i = 0; i < 3; ++i) {
        g[i] = static_cast<double>(v[i]);
        ed[i] = static_cast<double>(e[i]);
        fd[i] = static_cast<double>(f[i]);
      }
      const auto product = [](const auto& p, const auto& q) {
        return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
      };
      const double ee = product(ed, ed);
      const double ef = product(ed, fd);
      const double ff = product(fd, fd);
      const double determinant = ee * ff - ef * ef;
      if (!(determinant > 0)) return a;
      const double s = std::round((product(g, ed) * ff - product(g, fd) * ef) / determinant);
      const double t = std::round((product(g, fd) * ee - product(g, ed) * ef) / determinant);
      if ((s == 0 && t == 0) || !(std::abs(s) + std::abs(t) < 0x1p90)) break;
      for (std::size_t i = 0; i < 3; ++i) v[i] -= static_cast<Whole>(s) * e[i] + static_cast<Whole>(t) * f[i];
    }
    // Beyond the edge from b to c.
    Point d = a;
    for (std::size_t i = 0; i < 3; ++i) {
      const double moved = static_cast<double>(v[i] + e[i] + f[i]);
      (i == 0 ? d.x : i == 1 ? d.y : d.z) += moved;
    }
    return d;
  }

  Corners some_triangle() {
    switch (draw_.below(8)) {
      case 0: return {Point{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
      case 1: return {whole_point(3), whole_point(3), whole_point(3)};
      case 2: return {whole_point(27), whole_point(27), whole_point(27)};
      case 3: {  // a sliver
        const Point a = whole_point(20);
        const Point b = whole_point(20);
        return {a, b, a + draw_.unit() * (b - a) + norm(b - a) * power_of_ten(-15, -1) * direction()};
      }
      case 4: {  // far from the origin
        const double far = power_of_ten(0, 12);
        const Point at = far * direction();
        return {at + direction(), at + direction(), at + direction()};
      }
      case 5: {  // a short edge
        const Point a = direction();
        return {a, a + power_of_ten(-14, -1) * direction(), direction()};
      }
      case 6: {  // other units
        const double scale = power_of_ten(-20, 20);
        return {scale * direction(), scale * direction(), scale * direction()};
      }
      default: return {direction(), direction(), direction()};
    }
  }

  Point inside(const Corners& c) {
    const double s = draw_.unit();
    const double t = (1 - s) * draw_.unit();
    return c[0] + s * (c[1] - c[0]) + t * (c[2] - c[0]);
  }

  Sight some_sight() {
    Sight s;
    if (draw_.below(5) == 0) {
      auto [first, second] = nearly_coplanar_pair(draw_.below(3) == 0 ? 12 : 27);
      s.corners = first;
      // A node of the other triangle, in sixths or sevenths, all coordinates whole.
      const double parts = draw_.below(2) == 0 ? 6 : 7;
      for (Point& c : s.corners) c = parts * c;
      const double i = static_cast<double>(draw_.below(5));
      const double j = static_cast<double>(draw_.below(static_cast<std::size_t>(6 - i)));
      s.p = (parts - i - j) * second[0] + i * second[1] + j * second[2];
      const judge::Triple n = judge::cross(judge::minus(triple(second[1]), triple(second[0])),
                                           judge::minus(triple(second[2]), triple(second[0])));
      s.normal = {n[0].to_double(), n[1].to_double(), n[2].to_double()};
      if (draw_.below(2) == 0) s.normal = -s.normal;
      return s;
    }
    s.corners = triangle();
    const Corners& c = s.corners;
    const double scale = size(c);
    const Point up = rounded_normal(c);
    const double height = sign() * scale * power_of_ten(-18, 1);
    switch (draw_.below(8)) {
      case 0: s.p = inside(c) + height * up; break;
      case 1: s.p = c[0] + height * up; break;
      case 2: {  // over an edge, or its line, or next to it
        const double x = draw_.below(2) == 0 ? draw_.unit() : 4 * signed_unit();
        s.p = c[0] + x * (c[1] - c[0]) + height * up;
        if (draw_.below(2) == 0) s.p = s.p + power_of_ten(-18, -1) * sign() * cross(up, c[1] - c[0]);
        break;
      }
      case 3: {  // over the line through a corner parallel to the opposite edge
        s.p = c[2] + 3 * signed_unit() * (c[1] - c[0]) + height * up;
        break;
      }
      case 4: s.p = inside(c) + scale * power_of_ten(-9, 7) * direction(); break;
      case 5: s.p = inside(c) + scale * power_of_ten(-1, 1) * direction(); break;
      case 6: s.p = c[1] + power_of_ten(-1, 1) * (c[1] - c[0]) + height * up; break;  // in front of a corner
      default: s.p = inside(c) + scale * signed_unit() * direction() + height * up; break;
    }
    if (draw_.below(4) == 0) s.p = nudged(s.p);
    const Point towards = inside(c) - s.p;
    switch (draw_.below(8)) {
      case 0: s.normal = direction(); break;
      case 1: s.normal = towards; break;
      case 2: s.normal = draw_.below(2) == 0 ? up : -up; break;
      case 3: {  // the tangent plane through two corners, up to rounding, or a corner
        const std::size_t k = draw_.below(3);
        s.normal = cross(c[k] - s.p, draw_.below(2) == 0 ? c[(k + 1) % 3] - s.p : direction());
        break;
      }
      case 4: {  // through the triangle
        s.normal = cross(towards, direction());
        break;
      }
      case 5: {  // nearly the triangle's own plane
        s.normal = up + power_of_ten(-17, -1) * direction();
        break;
      }
      case 6: {  // through two corners exactly, where numbers are small
        const std::size_t k = draw_.below(3);
        const judge::Triple n = judge::cross(judge::minus(triple(c[k]), triple(s.p)),
                                             judge::minus(triple(c[(k + 1) % 3]), triple(s.p)));
        s.normal = {n[0].to_double(), n[1].to_double(), n[2].to_double()};
        break;
      }
      default: {
        s.normal = towards + norm(towards) * direction();
        break;
      }
    }
    if (draw_.below(2) == 0) s.normal = -s.normal;
    if (draw_.below(4) == 0) s.normal = nudged(s.normal);
    if (draw_.below(16) == 0) s.normal = power_of_ten(-70, 70) * s.normal;
    if (!std::isfinite(s.normal.x + s.normal.y + s.normal.z)) s.normal = {0, 0, 0};
    return s;
  }

  Draw& draw_;
};

/// Sights with simpler numbers.
inline std::vector<Sight> simpler(const Sight& s) {
  std::vector<Sight> all;
  const auto offer = [&](const Sight& t) {
    if (is_degenerate(t.corners) || is_in_plane(t.corners, t.p) || t.normal == Point{0, 0, 0}) return;
    all.push_back(t);
  };
  Sight moved = s;
  for (Point& c : moved.corners) c = c - s.corners[0];
  moved.p = s.p - s.corners[0];
  if (!(s.corners[0] == Point{0, 0, 0})) offer(moved);
  const auto shorter = [](double x, int bits) {
    if (x == 0) return x;
    const double unit = std::ldexp(1.0, std::ilogb(x) - bits);
    return unit > 0 ? std::round(x / unit) * unit : x;
  };
  const auto numbers = [](Sight& t) {
    std::vector<double*> places;
    for (Point* a : {&t.p, &t.normal, &t.corners[0], &t.corners[1], &t.corners[2]})
      for (double* x : {&a->x, &a->y, &a->z}) places.push_back(x);
    return places;
  };
  Sight t = s;
  for (double* place : numbers(t)) {
    const double x = *place;
    if (x == 0) continue;
    for (const double candidate : {0.0, shorter(x, 1), shorter(x, 4), shorter(x, 12)}) {
      *place = candidate;
      if (candidate != x) offer(t);
    }
    *place = x;
  }
  return all;
}

}  // namespace radcert::attack
