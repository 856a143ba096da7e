// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/contracting_system.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {
namespace {

/// More than the roundings of the few operations of a bound.
constexpr double up = 1 + 0x1p-48;

}  // namespace

Outcome<ContractingSolution> contracting_solution(std::span<const double> x, std::span<const double> residual,
                                                  std::span<const double> weights,
                                                  std::span<const double> sizes) {
  const std::size_t n = x.size();
  expects(residual.size() == n && weights.size() == n && sizes.size() == n, "vectors of one size",
          named("size", n));
  double theta = 0;
  double norm = 0;
  for (std::size_t i = 0; i < n; ++i) {
    expects(weights[i] > 0, "positive weights", named("weight", weights[i]));
    if (!std::isfinite(x[i]) || !std::isfinite(residual[i]) || !std::isfinite(sizes[i]))
      return because("numbers run over the range of double");
    expects(residual[i] >= 0 && sizes[i] >= 0, "sizes that are not negative", named("residual", residual[i]),
            named("size", sizes[i]));
    theta = std::max(theta, sizes[i] / weights[i] * up);
    norm = std::max(norm, residual[i] / weights[i] * up);
  }
  if (!(theta < 1))
    return because("the matrix is shown to contract by " + upper_text(theta, DecimalForm::general(6)) +
                   " at best, which is not below 1");
  const double bound = norm / (1 - theta) * up;
  ContractingSolution found{.solution = {.values = {x.begin(), x.end()}, .radius = {}}, .theta = theta};
  for (std::size_t i = 0; i < n; ++i)
    found.solution.radius.push_back(std::min(bound * weights[i], (residual[i] + bound * sizes[i])) * up);
  return found;
}

}  // namespace radcert
