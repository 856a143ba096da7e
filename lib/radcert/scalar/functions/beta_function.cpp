// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/functions/beta_function.h"

#include <arb.h>

#include "radcert/core/c_value.h"

namespace radcert {
namespace {

Ball with(void (*function)(arb_t, const arb_t, slong), const Ball& x, const char* reason) {
  if (!x.is_finite()) return x;
  CValue<arb_struct, arb_init, arb_clear> result;
  function(result, static_cast<arb_srcptr>(x.arb()), BallPrecision::current());
  return Ball::from_arb(result, reason);
}

}  // namespace

Ball beta_function(const Ball& x, const Ball& y) {
  const char* reason = "gamma of a ball that may contain a pole";
  return with(arb_gamma, x, reason) * with(arb_gamma, y, reason) * with(arb_rgamma, x + y, reason);
}

}  // namespace radcert
