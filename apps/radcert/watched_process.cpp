// SPDX-License-Identifier: GPL-3.0-or-later
#include "watched_process.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "output.h"
#include "radcert/core/errors.h"

namespace radcert::app {
namespace {

std::atomic<pid_t> watched{0};
static_assert(std::atomic<pid_t>::is_always_lock_free, "a signal handler may touch lock-free atomics only");

extern "C" {
static void pass_on(int signal) {
  const int error = errno;
  kill(watched.load(), signal);
  errno = error;
}
}  // extern "C"

[[noreturn]] void watch(const std::string& name) {
  int status = 0;
  while (waitpid(watched.load(), &status, 0) < 0)
    if (errno != EINTR) _exit(static_cast<int>(ExitCode::environment));
  if (WIFEXITED(status)) _exit(WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  complain(name + " was ended by signal " + std::to_string(signal) + " (" + strsignal(signal) +
           "); what was finished is kept, and the same command goes on from there");
  _exit(static_cast<int>(ExitCode::environment));
}

}  // namespace

void go_on_watched(const std::string& name) {
  const pid_t here = getpid();
  // A signal that comes before there is a child waits for it.
  sigset_t asking;
  sigset_t before;
  sigemptyset(&asking);
  sigaddset(&asking, SIGINT);
  sigaddset(&asking, SIGTERM);
  sigprocmask(SIG_BLOCK, &asking, &before);
  const pid_t child = fork();
  if (child > 0) {
    watched = child;
    struct sigaction action {};
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    action.sa_handler = pass_on;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    sigprocmask(SIG_SETMASK, &before, nullptr);
    watch(name);
  }
  if (child == 0) {
    // A group of its own: what is sent to the group of the watching process comes once.
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != here) _exit(static_cast<int>(ExitCode::environment));
  }
  sigprocmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace radcert::app
