// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "radcert/quadrature/certified/element_functions.h"

namespace radcert::sample {

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

}  // namespace radcert::sample
