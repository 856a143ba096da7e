// SPDX-License-Identifier: GPL-3.0-or-later
#include "requests/work.h"

#include <pthread.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <memory>
#include <system_error>
#include <thread>

#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"

namespace radcert::app {

namespace {

/// The computations of this process. Never taken down: threads may outlive the host's end.
struct Computations {
  Computations();
  std::mutex mutex;
  std::condition_variable ended;
  std::size_t running = 0;
  bool over = false;  ///< the host is about to end
  std::atomic<bool> begun = false;
  std::atomic<bool> forked = false;
};

Computations& computations() {
  static auto* all = new Computations;
  return *all;
}

void after_fork_in_child() {
  if (computations().begun) computations().forked = true;
}

Computations::Computations() { pthread_atfork(nullptr, nullptr, after_fork_in_child); }

/// A thread that handles no signal: its host's own threads do.
std::thread quiet_thread(std::function<void()> action) {
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP}) sigdelset(&all, fault);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  try {
    std::thread made(std::move(action));
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return made;
  } catch (const std::system_error&) {
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    throw EnvironmentError("threads", "the system gives no more of them");
  }
}

/// Serves once; gives what was thrown, after it has asked the library to stop.
std::exception_ptr served(const std::function<void(Progress&)>& serve, Progress& told) try {
  serve(told);
  return nullptr;
} catch (...) {
  request_interruption();
  return std::current_exception();
}

}  // namespace

AtWork::AtWork() {
  Computations& all = computations();
  if (all.forked)
    throw EnvironmentError(
        "radcert",
        "this process was forked from one that had computed before, and has none of its threads; "
        "start processes that compute anew (in Python by multiprocessing's \"spawn\")");
  const std::scoped_lock lock(all.mutex);
  if (all.over) throw Interrupted();
  all.begun = true;
  ++all.running;
}

AtWork::~AtWork() {
  Computations& all = computations();
  const std::scoped_lock lock(all.mutex);
  if (--all.running == 0) {
    clear_interruption();
    all.ended.notify_all();
  }
}

UsualArithmetic::UsualArithmetic() {
  std::fegetenv(&before_);
  std::fesetenv(FE_DFL_ENV);
}

UsualArithmetic::~UsualArithmetic() { std::fesetenv(&before_); }

void Progress::say(double fraction, const std::string& words) {
  const std::scoped_lock lock(mutex_);
  last_.emplace(fraction, words);
}

std::optional<std::pair<double, std::string>> Progress::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(last_, std::nullopt);
}

void Progress::warn(const std::string& words) {
  const std::scoped_lock lock(mutex_);
  warnings_.push_back(words);
}

std::vector<std::string> Progress::take_warnings() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(warnings_, {});
}

void run_apart(const std::function<void(Progress&)>& serve, const std::function<void(Progress&)>& action) {
  constexpr auto between_looks = std::chrono::milliseconds(40);
  const AtWork at_work;
  std::mutex mutex;
  std::condition_variable changed;
  bool done = false;
  std::exception_ptr thrown;
  Progress told;
  std::thread worker = quiet_thread([&] {
    try {
      const UsualArithmetic usual;
      throw_if_interrupted();
      action(told);
    } catch (...) {
      thrown = std::current_exception();
    }
    const std::scoped_lock lock(mutex);
    done = true;
    changed.notify_all();
  });
  std::exception_ptr raised;
  while (true) {
    {
      std::unique_lock lock(mutex);
      changed.wait_for(lock, between_looks, [&] { return done; });
      if (done) break;
    }
    if (!raised) raised = served(serve, told);
  }
  worker.join();
  if (!raised && !thrown) raised = served(serve, told);
  if (raised) std::rethrow_exception(raised);
  if (thrown) std::rethrow_exception(thrown);
}

void end_work() {
  if (computations().forked) return;
  Computations& all = computations();
  std::unique_lock lock(all.mutex);
  all.over = true;
  if (all.running > 0) request_interruption();
  all.ended.wait(lock, [&] { return all.running == 0; });
}

void limit_threads(const std::optional<std::int64_t>& threads) {
  // The limit lives until another takes its place.
  static std::mutex mutex;
  static auto* limit = new std::unique_ptr<ThreadLimit>;
  constexpr std::int64_t most = 4096;
  if (threads && (*threads < 1 || *threads > most))
    throw InputError({.source = "threads",
                      .value = std::to_string(*threads),
                      .allowed = "None, or a whole number from 1 to 4096"});
  const std::scoped_lock lock(mutex);
  limit->reset();
  if (threads) *limit = std::make_unique<ThreadLimit>(static_cast<std::size_t>(*threads));
}

}  // namespace radcert::app
