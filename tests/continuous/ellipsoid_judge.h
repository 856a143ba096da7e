// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace radcert::judge {

/// Integrals over ellipsoids by brute force, in long double: the surface, its normals and the kernel as they
/// are in space. Nothing of the library is used.
using Triple = std::array<long double, 3>;
inline constexpr long double pi_long = std::numbers::pi_v<long double>;

/// The Gauss-Legendre rule of ten points on [-1,1], by Newton's method.
struct TenPoints {
  std::array<long double, 10> nodes{};
  std::array<long double, 10> weights{};
  TenPoints() {
    for (std::size_t i = 0; i < 10; ++i) {
      long double x = std::cos(pi_long * (static_cast<long double>(i) + 0.75L) / 10.5L);
      long double slope = 1;
      for (int step = 0; step < 20; ++step) {
        long double before = 1;
        long double now = x;
        for (int n = 1; n < 10; ++n) {
          const long double next = ((2 * n + 1) * x * now - n * before) / (n + 1);
          before = now;
          now = next;
        }
        slope = 10 * (x * now - before) / (x * x - 1);
        x -= now / slope;
      }
      nodes[i] = x;
      weights[i] = 2 / ((1 - x * x) * slope * slope);
    }
  }
};

/// Calls f(q, weight) for the nodes of a rule over the unit sphere about a pole: ten points on each panel of
/// the angle from it, the midpoint rule around it. The weights have the sum 4 pi.
template <class F>
void over_the_sphere(const Triple& pole, int panels, int around, const F& f) {
  static const TenPoints rule;
  const long double planar = std::hypot(pole[0], pole[1]);
  const long double other = std::hypot(pole[0], pole[2]);
  const Triple first = planar > 0.1L ? Triple{-pole[1] / planar, pole[0] / planar, 0}
                                     : Triple{pole[2] / other, 0, -pole[0] / other};
  const Triple second{pole[1] * first[2] - pole[2] * first[1], pole[2] * first[0] - pole[0] * first[2],
                      pole[0] * first[1] - pole[1] * first[0]};
  for (int panel = 0; panel < panels; ++panel)
    for (std::size_t i = 0; i < 10; ++i) {
      const long double psi = pi_long * (panel + 0.5L * (1 + rule.nodes[i])) / panels;
      const long double weight =
          pi_long / (2 * panels) * rule.weights[i] * std::sin(psi) * 2 * pi_long / around;
      for (int j = 0; j < around; ++j) {
        const long double phi = 2 * pi_long * (j + 0.5L) / around;
        Triple q{};
        for (std::size_t k = 0; k < 3; ++k)
          q[k] = std::cos(psi) * pole[k] +
                 std::sin(psi) * (std::cos(phi) * first[k] + std::sin(phi) * second[k]);
        f(q, weight);
      }
    }
}

inline Triple direction(double x, double y, double z) {
  const Triple p{x, y, z};
  const long double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  return {p[0] / length, p[1] / length, p[2] / length};
}

/// |A^-1 p|.
inline long double stretch(const Triple& a, const Triple& p) {
  long double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += p[k] * p[k] / (a[k] * a[k]);
  return std::sqrt(sum);
}

/// (1/pi) Int G w dS at A p, A the diagonal matrix of the half axes a; w is called with points of the
/// surface.
template <class F>
long double transported(const Triple& a, const Triple& p, const F& w, int panels = 12, int around = 120) {
  const long double stretch_p = stretch(a, p);
  long double sum = 0;
  over_the_sphere(p, panels, around, [&](const Triple& q, long double weight) {
    const long double stretch_q = stretch(a, q);
    long double squared = 0;
    long double height_p = 0;  // (Q - P).n_P, n = -A^-1 p / |A^-1 p|
    long double height_q = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const long double chord = a[k] * (q[k] - p[k]);
      squared += chord * chord;
      height_p -= chord * p[k] / (a[k] * stretch_p);
      height_q += chord * q[k] / (a[k] * stretch_q);
    }
    const long double area = weight * a[0] * a[1] * a[2] * stretch_q;
    sum +=
        area * height_p * height_q / (squared * squared) * w(Triple{a[0] * q[0], a[1] * q[1], a[2] * q[2]});
  });
  return sum / pi_long;
}

/// Int w dS / Int dS.
template <class F>
long double mean_over(const Triple& a, const F& w, int panels = 12, int around = 120) {
  long double sum = 0;
  long double area = 0;
  over_the_sphere({0, 0, 1}, panels, around, [&](const Triple& q, long double weight) {
    const long double part = weight * stretch(a, q);
    area += part;
    sum += part * w(Triple{a[0] * q[0], a[1] * q[1], a[2] * q[2]});
  });
  return sum / area;
}

}  // namespace radcert::judge
