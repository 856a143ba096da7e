// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/interrupt.h"

#include "radcert/core/errors.h"

#include <atomic>
#include <csignal>

namespace radcert {

namespace {

std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch lock-free atomics only");

extern "C" void radcert_on_signal(int) { request_interruption(); }

}  // namespace

void install_interrupt_handler() {
  struct sigaction action {};
  action.sa_handler = radcert_on_signal;
  sigemptyset(&action.sa_mask);
  // SA_RESETHAND: the second signal finds the default action and ends a program that does not look at the
  // flag.
  action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interruption_requested() noexcept { return requested.load(std::memory_order_relaxed); }

void request_interruption() noexcept { requested.store(true, std::memory_order_relaxed); }

void clear_interruption() noexcept { requested.store(false, std::memory_order_relaxed); }

void throw_if_interrupted() {
  if (interruption_requested()) throw Interrupted();
}

}  // namespace radcert
