// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/gauss_legendre.h"

#include <arb.h>
#include <arb_hypgeom.h>
#include <map>
#include <mutex>
#include <utility>

#include "radcert/core/contract.h"

namespace radcert {

namespace {

std::shared_ptr<const EnclosedGaussRule> made(int n) {
  auto rule = std::make_shared<EnclosedGaussRule>();
  arb_t node;
  arb_t weight;
  arb_init(node);
  arb_init(weight);
  // Arb's zeros descend.
  for (int k = n - 1; k >= 0; --k) {
    arb_hypgeom_legendre_p_ui_root(node, weight, static_cast<ulong>(n), static_cast<ulong>(k),
                                   BallPrecision::current());
    rule->nodes.push_back(Ball::from_arb(node, "a Gauss node without a bound"));
    rule->weights.push_back(Ball::from_arb(weight, "a Gauss weight without a bound"));
  }
  arb_clear(node);
  arb_clear(weight);
  return rule;
}

}  // namespace

std::shared_ptr<const EnclosedGaussRule> enclosed_gauss_rule(int n) {
  expects(n >= 1, "n >= 1", named("n", n));
  static std::mutex mutex;
  static std::map<std::pair<int, long>, std::shared_ptr<const EnclosedGaussRule>> rules;
  const std::pair key(n, BallPrecision::current());
  {
    const std::lock_guard lock(mutex);
    if (const auto found = rules.find(key); found != rules.end()) return found->second;
  }
  auto rule = made(n);
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
