// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/ball_precision.h"

#include <flint/flint.h>

#include "radcert/core/contract.h"

namespace radcert {

namespace {

/// FLINT, Arb and MPFR keep constants and spare memory for each thread: given back when the thread ends.
struct ThreadContext {
  constexpr ThreadContext() = default;
  ~ThreadContext() { flint_cleanup(); }
  ThreadContext(const ThreadContext&) = delete;
  ThreadContext& operator=(const ThreadContext&) = delete;

  long bits = BallPrecision::default_bits;
};

constinit thread_local ThreadContext context;

}  // namespace

BallPrecision::BallPrecision(long bits) : outer_(context.bits) {
  expects(smallest_bits <= bits && bits <= largest_bits, "2 <= bits <= 1000000", named("bits", bits));
  context.bits = bits;
}

BallPrecision::~BallPrecision() { context.bits = outer_; }

long BallPrecision::current() noexcept { return context.bits; }

}  // namespace radcert
