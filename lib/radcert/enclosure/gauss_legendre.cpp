// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/gauss_legendre.h"

#include <map>
#include <mutex>
#include <utility>

#include "radcert/core/contract.h"

namespace radcert {

std::shared_ptr<const IntervalRule<Ball>> enclosed_gauss_rule(int n) {
  expects(n >= 1, "n >= 1", named("n", n));
  static std::mutex mutex;
  static std::map<std::pair<int, long>, std::shared_ptr<const IntervalRule<Ball>>> rules;
  const std::pair key(n, BallPrecision::current());
  {
    const std::lock_guard lock(mutex);
    if (const auto found = rules.find(key); found != rules.end()) return found->second;
  }
  auto rule = std::make_shared<const IntervalRule<Ball>>(legendre_rule(n));
  const std::lock_guard lock(mutex);
  return rules.emplace(key, std::move(rule)).first->second;
}

Ball gauss_error_factor(int n, double rho) {
  expects(n >= 1 && rho > 1, "n >= 1, rho > 1", named("n", n), named("rho", rho));
  const Ball r(rho);
  const Ball count(n);
  const Ball constant = 4 + 4 / (4 * power(count, 2) - 1);
  return (constant * power(r, -2L * n) / (1 - power(r, -2))).upper();
}

}  // namespace radcert
