// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <random>

#include "radcert/geometry/vector.h"

namespace radcert::test {

/// Numbers from the raw stream, the same on every machine.
class Draws {
public:
  explicit Draws(std::uint64_t seed) : stream_(seed) {}
  /// In [0,1).
  double part() { return static_cast<double>(stream_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * part(); }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(stream_() % count); }
  Vector<double> point(double low, double high) {
    const double x = between(low, high);
    const double y = between(low, high);
    return {x, y, between(low, high)};
  }

private:
  std::mt19937_64 stream_;
};

}  // namespace radcert::test
