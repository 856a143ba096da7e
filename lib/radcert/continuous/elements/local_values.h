// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/continuous/elements/graded_elements.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"

namespace radcert {

/// The functions on one element, at points of it; for the use of one thread.
/// Requires  element and functions outlive it
class LocalValues {
public:
  LocalValues(const SectorElement& element, const SectorFunctions& functions, std::size_t number)
      : box_(element.box),
        functions_(functions),
        number_(number),
        p_s_(static_cast<std::size_t>(functions.degree() + 1)),
        p_t_(p_s_.size()) {}

  /// The node at the place (x, y) in [-1,1]^2 of a part of the element.
  void at(const SectorBox& part, double x, double y, std::span<double> values) {
    legendre_values<double>(part_in_s(part, box_).place(x), p_s_);
    legendre_values<double>(part_in_t(part, box_).place(y), p_t_);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::span<const double> c = functions_.of(number_, k);
      double sum = 0;
      for (std::size_t i = 0; i < p_s_.size(); ++i) {
        double inner = 0;
        for (std::size_t j = 0; j < p_t_.size(); ++j) inner += c[i * p_t_.size() + j] * p_t_[j];
        sum += inner * p_s_[i];
      }
      values[k] = sum;
    }
  }

private:
  const SectorBox& box_;
  const SectorFunctions& functions_;
  std::size_t number_;
  std::vector<double> p_s_, p_t_;
};

}  // namespace radcert
