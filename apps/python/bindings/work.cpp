// SPDX-License-Identifier: GPL-3.0-or-later
#include "work.h"

#include <pthread.h>
#include <pybind11/stl.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <system_error>
#include <thread>

#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/parallel.h"

namespace radcert::python {

namespace {

/// The computations of this process. Never taken down: threads may outlive the interpreter's end.
struct Computations {
  std::mutex mutex;
  std::condition_variable ended;
  std::size_t running = 0;
  bool over = false;  ///< Python is about to end
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

/// Counts a computation while it lives; the last one takes a request to stop back.
class Running {
public:
  Running() {
    Computations& all = computations();
    if (all.forked)
      throw EnvironmentError(
          "radcert",
          "this process was forked from one that had computed before, and has none of its threads; "
          "start processes with multiprocessing's \"spawn\"");
    const std::scoped_lock lock(all.mutex);
    if (all.over) throw Interrupted();
    all.begun = true;
    ++all.running;
  }
  ~Running() {
    Computations& all = computations();
    const std::scoped_lock lock(all.mutex);
    if (--all.running == 0) {
      clear_interruption();
      all.ended.notify_all();
    }
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
};

/// A thread that handles no signal: Python's own threads do.
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

/// What Python raised while it was served, kept until the computation has stopped.
class Raised {
public:
  [[nodiscard]] bool has() const { return error_ != nullptr; }
  void keep(std::exception_ptr error) {
    error_ = std::move(error);
    request_interruption();
  }
  void leave() const {
    if (error_) std::rethrow_exception(error_);
  }

private:
  std::exception_ptr error_;
};

void serve(const py::object& progress, Progress& told, Raised& raised) try {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (progress.is_none()) return;
  if (const auto report = told.take()) progress(report->first, report->second);
} catch (const py::error_already_set&) {
  raised.keep(std::current_exception());
}

/// Ends what is at work before the interpreter goes, and begins nothing more.
void stop_all() {
  if (computations().forked) return;
  const py::gil_scoped_release released;
  Computations& all = computations();
  std::unique_lock lock(all.mutex);
  all.over = true;
  if (all.running > 0) request_interruption();
  all.ended.wait(lock, [&] { return all.running == 0; });
}

}  // namespace

void Progress::say(double fraction, const std::string& words) {
  const std::scoped_lock lock(mutex_);
  last_.emplace(fraction, words);
}

std::optional<std::pair<double, std::string>> Progress::take() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(last_, std::nullopt);
}

void run_apart(const py::object& progress, const std::function<void(Progress&)>& action) {
  constexpr auto between_looks = std::chrono::milliseconds(40);
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw InputError({.source = "progress",
                      .value = std::string(py::str(progress.get_type())),
                      .problem = "cannot be called",
                      .allowed = "None, or a function of a fraction and of words"});
  const Running running;
  std::mutex mutex;
  std::condition_variable changed;
  bool done = false;
  std::exception_ptr thrown;
  Progress told;
  std::thread worker = quiet_thread([&] {
    try {
      throw_if_interrupted();
      action(told);
    } catch (...) {
      thrown = std::current_exception();
    }
    const std::scoped_lock lock(mutex);
    done = true;
    changed.notify_all();
  });
  Raised raised;
  while (true) {
    {
      const py::gil_scoped_release released;
      std::unique_lock lock(mutex);
      changed.wait_for(lock, between_looks, [&] { return done; });
      if (done) break;
    }
    if (!raised.has()) serve(progress, told, raised);
  }
  {
    const py::gil_scoped_release released;
    worker.join();
  }
  if (!raised.has() && !thrown) serve(progress, told, raised);
  raised.leave();
  if (thrown) std::rethrow_exception(thrown);
}

void add_work(py::module_& module) {
  pthread_atfork(nullptr, nullptr, after_fork_in_child);
  module.def("stop_all", stop_all);
  module.def("thread_count", thread_count);
  module.def("available_memory", [] { return available_memory(); });
  // The limit lives until another takes its place.
  module.def("limit_threads", [](const std::optional<std::int64_t>& threads) {
    static auto* limit = new std::unique_ptr<ThreadLimit>;
    constexpr std::int64_t most = 4096;
    if (threads && (*threads < 1 || *threads > most))
      throw InputError({.source = "threads",
                        .value = std::to_string(*threads),
                        .allowed = "None, or a whole number from 1 to 4096"});
    limit->reset();
    if (threads) *limit = std::make_unique<ThreadLimit>(static_cast<std::size_t>(*threads));
  });
  py::module_::import("atexit").attr("register")(module.attr("stop_all"));
}

}  // namespace radcert::python
