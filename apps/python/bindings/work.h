// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "python.h"
#include "requests/work.h"

namespace radcert::python {

using app::Progress;

/// Runs an action without the interpreter's lock, in a thread of its own, while the calling thread serves
/// Python: it calls `progress(fraction, words)` unless that is None, and lets signals be handled.
/// Maths     app::run_apart; an exception from a handler (KeyboardInterrupt) or from `progress` stops the
///           library
/// Requires  the interpreter's lock; an action that touches no Python object
/// Result    the action runs in app::UsualArithmetic, whatever Python's threads have
void run_apart(const py::object& progress, const std::function<void(Progress&)>& action);

/// The same for an action with a value.
template <class Action>
auto compute(const py::object& progress, Action&& action) {
  using Value = decltype(action(std::declval<Progress&>()));
  std::optional<Value> value;
  run_apart(progress, [&](Progress& told) { value.emplace(action(told)); });
  return std::move(*value);
}

}  // namespace radcert::python
