// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/transport/transport_bounds.h"

namespace radcert {

/// Bounds of functions on elements whose points slide, by the part of the way to the sides that they go.
/// Maths     see slid_growth
/// Result    rounded up
class SlidSizes {
public:
  /// Those of functions on one element too.
  void include(const SectorFunctions& functions, std::size_t element) {
    for (std::size_t m = 0; m < parts.size(); ++m) {
      const double growth = slid_growth(parts[m]);
      sizes_[m] = std::max(sizes_[m], size_around(functions, element, growth, growth));
    }
  }
  void include(const SlidSizes& other) {
    for (std::size_t m = 0; m < parts.size(); ++m) sizes_[m] = std::max(sizes_[m], other.sizes_[m]);
  }
  /// Where points slide by a part below 1.
  [[nodiscard]] double at(double part) const {
    const auto m =
        static_cast<std::size_t>(std::lower_bound(parts.begin(), parts.end(), part) - parts.begin());
    return sizes_[std::min(m, parts.size() - 1)];
  }

private:
  static constexpr std::array<double, 4> parts{0.125, 0.25, 0.5, 1};
  std::array<double, parts.size()> sizes_{};
};

}  // namespace radcert
