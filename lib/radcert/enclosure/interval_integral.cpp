// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/interval_integral.h"

#include <acb.h>
#include <acb_calc.h>
#include <exception>
#include <string>

#include "radcert/core/c_value.h"
#include "radcert/core/contract.h"

namespace radcert {

namespace {

/// What the C function below is given.
struct Call {
  const LineFunction& f;
  Ball interval;
  long evaluations = 0;
  std::string failure{};
  std::exception_ptr thrown = nullptr;

  Ball within(const Ball& x) const {
    if (interval.contains(x)) return x;
    return hull(max(x.lower(), interval.lower()), min(x.upper(), interval.upper()));
  }
};

/// A value for acb_calc_integrate, which wants no value where f is not analytic on the argument if order = 1.
int evaluate(acb_ptr out, const acb_t in, void* data, slong order, slong bits) {
  Call& call = *static_cast<Call*>(data);
  ++call.evaluations;
  acb_zero(out);
  if (call.thrown)
    return 0;  // no exception passes through Arb, and a function that is zero is done with soon
  acb_indeterminate(out);
  try {
    const BallPrecision inside(bits);
    const ComplexBall x = ComplexBall::from_acb(in, "an argument without a bound");
    // A real interval that rounding has made longer than the whole is brought back: at the ends roots begin.
    const ComplexBall value = order == 0 && x.is_real() ? ComplexBall(call.f.in_balls(call.within(x.real())))
                                                        : call.f.in_complex_balls(x);
    if (value.is_finite()) {
      acb_set(out, static_cast<acb_srcptr>(value.acb()));
    } else {
      call.failure = value.failure();
    }
  } catch (...) {
    call.thrown = std::current_exception();
  }
  return 0;
}

}  // namespace

Enclosure integral_on_interval(const LineFunction& f, const Ball& a, const Ball& b, const Demand& demand) {
  expects(demand.radius > 0 && demand.work_limit >= 1, "radius > 0, work_limit >= 1",
          named("radius", demand.radius), named("work_limit", demand.work_limit));
  expects(a.is_finite() && b.is_finite(), "finite ends", named("a", a), named("b", b));
  Call call{.f = f, .interval = hull(a, b)};
  const slong bits = BallPrecision::current();
  const ComplexBall from(a);
  const ComplexBall to(b);
  acb_calc_integrate_opt_t options;
  acb_calc_integrate_opt_init(options);
  options->eval_limit = demand.work_limit;
  CValue<mag_struct, mag_init, mag_clear> tolerance;
  // The demand is for the whole, Arb's tolerance for each interval: the rest is for the sum of these, and for
  // rounding.
  mag_set_d_lower(tolerance, demand.radius / 1024);
  CValue<acb_struct, acb_init, acb_clear> integral;
  // Relative accuracy is not wanted: more bits than any double's radius can ask for.
  const slong no_relative_goal = 4 * bits + 4096;
  acb_calc_integrate(integral, evaluate, &call, static_cast<acb_srcptr>(from.acb()),
                     static_cast<acb_srcptr>(to.acb()), no_relative_goal, tolerance, options, bits);
  const Ball value = Ball::from_arb(acb_realref(integral), "an integral without a bound");
  if (call.thrown) std::rethrow_exception(call.thrown);
  if (value.is_finite() && value.radius() <= demand.radius) {
    return Enclosed{.value = value, .evaluations = call.evaluations};
  }
  std::string why =
      call.evaluations >= demand.work_limit
          ? "the work limit of " + std::to_string(demand.work_limit) + " evaluations was reached"
          : "the intervals cannot be bisected further at " + std::to_string(bits) + " bits";
  if (!call.failure.empty()) why += " (" + call.failure + ")";
  return because(Undecided{.why = std::move(why), .reached = value, .evaluations = call.evaluations});
}

}  // namespace radcert
