// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "tests/scalar/draw.h"

namespace radcert::attack {

/// n/100.
inline Rational hundredths(long n) { return {n, 100}; }

/// A linear map of space with entries in hundredths.
struct SkewMap {
  std::array<std::array<long, 3>, 3> row{};

  /// Upper triangular, so that the determinant is positive and normals stay on their side: a diagonal from
  /// `least` on, below least + range, and sizes of at most `aside` above it.
  static SkewMap drawn(Draw& draw, long least, long range, long aside) {
    SkewMap map;
    for (std::size_t k = 0; k < 3; ++k) {
      map.row[k][k] = least + static_cast<long>(draw.below(static_cast<std::size_t>(range)));
      for (std::size_t l = k + 1; l < 3; ++l)
        map.row[k][l] = static_cast<long>(draw.below(static_cast<std::size_t>(2 * aside))) - aside;
    }
    return map;
  }

  Vector<Rational> operator()(const Vector<Rational>& p) const {
    const auto at = [&](std::size_t k) {
      return hundredths(row[k][0]) * p.x + hundredths(row[k][1]) * p.y + hundredths(row[k][2]) * p.z;
    };
    return {at(0), at(1), at(2)};
  }

  [[nodiscard]] std::string text() const {
    std::string out = "map";
    for (const auto& entries : row)
      for (const long entry : entries) out += " " + std::to_string(entry);
    return out;
  }

  /// Calls the visitor with each map that has one entry more of the identity.
  template <class Visitor>
  void each_simpler(const Visitor& visit) const {
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t l = 0; l < 3; ++l) {
        SkewMap simpler = *this;
        simpler.row[k][l] = k == l ? 100 : 0;
        if (simpler.row != row) visit(simpler);
      }
  }
};

}  // namespace radcert::attack
