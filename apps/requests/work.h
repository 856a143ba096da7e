// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace radcert::app {

/// How far a computation has come, as its listeners tell it.
class Progress {
public:
  /// Called from any thread; only the last report is kept until its hearer takes it.
  void say(double fraction, const std::string& words);
  /// The last report that was not taken yet.
  [[nodiscard]] std::optional<std::pair<double, std::string>> take();
  /// What a user should know although the work goes on; all are kept until they are taken.
  void warn(const std::string& words);
  [[nodiscard]] std::vector<std::string> take_warnings();

private:
  std::mutex mutex_;
  std::vector<std::string> warnings_;
  std::optional<std::pair<double, std::string>> last_;
};

/// Counts a computation while it lives: end_work() waits until none does, and the last one takes a request to
/// stop back.
/// Result    EnvironmentError in a process that was forked after its parent had computed: its threads are not
///           there. Interrupted after end_work()
class AtWork {
public:
  AtWork();
  ~AtWork();
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;
};

/// While it lives the calling thread rounds to nearest and keeps subnormal numbers, as every proof of the
/// library takes for granted; then it computes as before.
/// Maths     the default floating-point environment, without flush to zero (FTZ, DAZ): a program may have set
///           another, and so does a shared object that was linked with -ffast-math
/// Limits    of this thread, and of what the library's loops run for it in others
class UsualArithmetic {
public:
  UsualArithmetic();
  ~UsualArithmetic();
  UsualArithmetic(const UsualArithmetic&) = delete;
  UsualArithmetic& operator=(const UsualArithmetic&) = delete;

private:
  std::fenv_t before_;
};

/// Runs an action in a thread of its own, while the calling thread serves its caller.
/// Maths     `serve` is called every 40 milliseconds or so, and once more when the action is done; what it
///           throws asks the library to stop, leaves once the action has ended, and takes the place of what
///           the action gave or threw
/// Requires  nothing of the action that only the calling thread may do
/// Result    what the action throws leaves, and what AtWork throws. The action runs in UsualArithmetic,
///           whatever the calling thread has
/// Limits    a request to stop is one of the whole process: what other threads compute at the time ends with
///           Interrupted
void run_apart(const std::function<void(Progress&)>& serve, const std::function<void(Progress&)>& action);

/// Ends what is at work, and begins nothing more: for the end of a host that the library must not outlive.
void end_work();

/// At most so many threads from now on in this process; nullopt: as many as there are processors.
/// Result    InputError at `threads` for a number outside 1 to 4096
void limit_threads(const std::optional<std::int64_t>& threads);

}  // namespace radcert::app
