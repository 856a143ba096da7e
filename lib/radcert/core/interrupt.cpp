// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/interrupt.h"

#include "radcert/core/errors.h"
#include "radcert/core/files/temporary_files.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <unistd.h>

namespace radcert {

namespace {

std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch lock-free atomics only");

/// Two texts, of which the handler reads one while the other is written.
struct LastWords {
  static constexpr std::size_t longest = 500;
  std::array<std::array<char, longest>, 2> text{};
  std::array<std::size_t, 2> length{};
  std::atomic<unsigned> shown{0};
};

LastWords& last_words() {
  static LastWords words;
  return words;
}

timer_t deadline{};
bool has_deadline = false;
constexpr long until_deadline = 700'000'000;  // nanoseconds: within a second of the signal all is over
constexpr long until_next_look = 20'000'000;  // where files are just being renamed

void set_deadline(long nanoseconds) {
  itimerspec time{};
  time.it_value.tv_nsec = nanoseconds;
  if (!has_deadline || timer_settime(deadline, 0, &time, nullptr) != 0) alarm(1);
}

// Async-signal-safe throughout: POSIX signal-safety(7) has write, unlink, timer_settime, alarm, raise, _exit.
extern "C" {

static void on_deadline(int) {
  if (renaming_files()) {
    set_deadline(until_next_look);
    return;
  }
  if (!interruption_requested()) return;
  remove_temporary_files();
  const LastWords& words = last_words();
  const unsigned shown = words.shown.load(std::memory_order_acquire);
  [[maybe_unused]] const ssize_t said = write(STDERR_FILENO, words.text[shown].data(), words.length[shown]);
  _exit(static_cast<int>(ExitCode::interrupted));
}

static void on_signal(int signal) {
  const int error = errno;
  if (!interruption_requested()) {
    request_interruption();
    set_deadline(until_deadline);
  } else if (renaming_files()) {
    set_deadline(until_next_look);
  } else {
    remove_temporary_files();
    std::signal(signal, SIG_DFL);
    raise(signal);
  }
  errno = error;
}

}  // extern "C"

}  // namespace

void install_interrupt_handler() {
  (void)last_words();
  set_last_words("radcert: interrupted; what was finished is kept\n");
  if (!has_deadline) {
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    has_deadline = timer_create(CLOCK_MONOTONIC, &event, &deadline) == 0;
  }
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  action.sa_handler = on_deadline;
  sigaction(SIGALRM, &action, nullptr);
  action.sa_handler = on_signal;
  sigaddset(&action.sa_mask, SIGALRM);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void set_last_words(std::string_view words) {
  LastWords& all = last_words();
  const unsigned next = 1 - all.shown.load(std::memory_order_relaxed);
  all.length[next] = words.copy(all.text[next].data(), LastWords::longest);
  all.shown.store(next, std::memory_order_release);
}

bool interruption_requested() noexcept { return requested.load(std::memory_order_relaxed); }

void request_interruption() noexcept { requested.store(true, std::memory_order_relaxed); }

void clear_interruption() noexcept { requested.store(false, std::memory_order_relaxed); }

void throw_if_interrupted() {
  if (interruption_requested()) throw Interrupted();
}

}  // namespace radcert
