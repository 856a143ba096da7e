// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/observer_cells.h"

namespace radcert::test {

/// The same everywhere; cells of a smaller area are not looked into.
class EvenDemand final : public LargestDemand {
public:
  explicit EvenDemand(double allowed, double smallest_area = 0)
      : allowed_(allowed), smallest_area_(smallest_area) {}
  [[nodiscard]] double allowed(std::size_t /*element*/, const Sector& /*sector*/,
                               const SectorBox& /*box*/) const override {
    return allowed_;
  }
  [[nodiscard]] bool may_be_strip(const Sector& sector, const SectorBox& box) const override {
    return sector.jacobian * box.weight() < smallest_area_;
  }

private:
  double allowed_;
  double smallest_area_;
};

}  // namespace radcert::test
