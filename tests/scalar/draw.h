// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace radcert {

/// Doubles at which arithmetic goes wrong, and ordinary ones; intervals of them: points, narrow, wide, around
/// zero.
class Draw {
public:
  explicit Draw(std::uint64_t seed) : random_(seed) {}

  std::uint64_t bits() { return random_(); }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  double unit() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }

  double number() {
    static constexpr std::array corners{0.0,
                                        1.0,
                                        2.0,
                                        3.0,
                                        0.5,
                                        0.75,
                                        10.0,
                                        100.0,
                                        1e-5,
                                        1e-300,
                                        5e-324,
                                        1e300,
                                        1e15,
                                        1e16,
                                        0x1p53,
                                        0x1.fffffffffffffp-1,
                                        0.1,
                                        1.5,
                                        0x1p-53,
                                        0x1p64,
                                        1e-20,
                                        1e-40,
                                        0.25,
                                        0x1.0000000000001p0,
                                        0x1.921fb54442d18p0 /* the double next to pi/2 */,
                                        0x1.921fb54442d18p1,
                                        0x1.5bf0a8b145769p1 /* to e */};
    const double sign = below(2) == 0 ? 1 : -1;
    switch (below(4)) {
      case 0: return sign * corners[below(corners.size())];
      case 1: return sign * std::ldexp(1 + unit(), static_cast<int>(below(2000)) - 1000);
      case 2: return sign * std::ldexp(1 + unit(), static_cast<int>(below(40)) - 20);
      default: return sign * 10 * unit();
    }
  }

  struct Interval {
    double low;
    double high;
  };

  Interval interval() {
    const double a = number();
    double b = a;
    switch (below(4)) {
      case 0: break;
      case 1: b = std::nextafter(a, below(2) == 0 ? HUGE_VAL : -HUGE_VAL); break;
      case 2: b = a * (1 + std::ldexp(unit(), -static_cast<int>(below(60)))); break;
      default: b = number();
    }
    if (!std::isfinite(b)) b = a;
    return {std::min(a, b), std::max(a, b)};
  }

  /// The ends, and points between.
  std::vector<double> points(const Interval& x) {
    if (x.low == x.high) return {x.low};
    std::vector<double> points{x.low, x.high};
    for (int i = 0; i < 3; ++i) {
      const double t = unit();
      points.push_back(std::clamp((1 - t) * x.low + t * x.high, x.low, x.high));
    }
    if (x.low < 0 && x.high > 0) points.push_back(0);
    return points;
  }

private:
  std::mt19937_64 random_;
};

}  // namespace radcert
