// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "python.h"

namespace radcert::python {

/// How far a computation has come, as its listeners tell it.
class Progress {
public:
  /// Called from any thread; only the last report is kept until Python has heard it.
  void say(double fraction, const std::string& words);
  /// The last report that was not taken yet.
  [[nodiscard]] std::optional<std::pair<double, std::string>> take();

private:
  std::mutex mutex_;
  std::optional<std::pair<double, std::string>> last_;
};

/// Runs an action without the interpreter's lock, in a thread of its own, while the calling thread serves
/// Python: it calls `progress(fraction, words)` unless that is None, and lets signals be handled.
/// Maths     an exception from a handler (KeyboardInterrupt) or from `progress` asks the library to stop, is
///           raised once it has, and takes the place of what the action gave or threw
/// Requires  the interpreter's lock; an action that touches no Python object
/// Result    what the action throws leaves. EnvironmentError in a process that was forked after its parent
///           had computed: its threads are not there
/// Limits    a request to stop is one of the whole process: what other threads compute at the time ends with
///           Interrupted
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
