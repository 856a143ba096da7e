// SPDX-License-Identifier: GPL-3.0-or-later
#include "circumstances.h"

#include <arb.h>
#include <flint/flint.h>
#include <fmt/format.h>
#include <gmp.h>
#include <mpfr.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <tbb/version.h>
#include <unistd.h>

#include <Eigen/src/Core/util/Macros.h>
#include <algorithm>
#include <boost/version.hpp>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <system_error>
#include <thread>

#include "output.h"
#include "radcert/core/checked.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/temporary_files.h"

namespace radcert::app {

std::vector<LibraryVersion> library_versions() {
  return {{"arb", arb_version},
          {"flint", FLINT_VERSION},
          {"mpfr", mpfr_get_version()},
          {"gmp", gmp_version},
          {"tbb", TBB_runtime_version()},
          {"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"cgal", RADCERT_CGAL_VERSION},
          {"boost",
           fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)}};
}

std::string compiler_version() {
#if defined(__clang__)
  return __VERSION__;
#else
  return "GCC " __VERSION__;
#endif
}

std::string system_name() {
  utsname name{};
  if (uname(&name) != 0) return "unknown";
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

namespace {

[[noreturn]] void leave(std::string_view words) {
  remove_temporary_files();
  say(words);
  std::_Exit(static_cast<int>(ExitCode::environment));
}

[[noreturn]] void leave_without_memory() { leave("radcert: memory: there is not enough\n"); }

// FLINT has said on stderr what it was.
[[noreturn]] void leave_with_flint() {
  leave("radcert: FLINT cannot go on, most likely for want of memory\n");
}

void* allocated(std::size_t bytes) {
  void* memory = std::malloc(bytes);
  if (memory == nullptr) leave_without_memory();
  return memory;
}

void* reallocated(void* old, std::size_t /*old_bytes*/, std::size_t bytes) {
  void* memory = std::realloc(old, bytes);
  if (memory == nullptr) leave_without_memory();
  return memory;
}

void freed(void* memory, std::size_t /*bytes*/) { std::free(memory); }

}  // namespace

void leave_when_memory_ends() {
  mp_set_memory_functions(allocated, reallocated, freed);
  flint_set_abort(leave_with_flint);
}

void hold_memory(std::uint64_t bytes) {
  constexpr std::uint64_t not_planned = std::uint64_t{256} << 20;
  constexpr std::uint64_t stack = std::uint64_t{16} << 20;
  std::ifstream sizes("/proc/self/statm");
  std::uint64_t pages = 0;  // the sixth number: data and stack
  for (int k = 0; k < 6; ++k) sizes >> pages;
  rlimit limit{};
  if (!sizes || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  const std::uint64_t beside = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + not_planned +
                               stack * std::max(1U, std::thread::hardware_concurrency());
  const std::uint64_t most = checked_add(bytes, beside).value_or(RLIM_INFINITY);
  limit.rlim_cur = std::min<std::uint64_t>(limit.rlim_cur, most);
  setrlimit(RLIMIT_DATA, &limit);
}

std::size_t threads_to_be_had(std::size_t most) {
  std::mutex held;
  std::vector<std::thread> threads;
  {
    // They wait for one another, so that all are there at the same time.
    const std::scoped_lock lock(held);
    try {
      while (threads.size() < most) threads.emplace_back([&held] { const std::scoped_lock turn(held); });
    } catch (const std::system_error&) {
      // There are no more.
    }
  }
  for (std::thread& thread : threads) thread.join();
  return threads.size();
}

std::vector<std::string> cpu_features() {
  std::vector<std::string> out;
#if defined(__x86_64__)
  __builtin_cpu_init();
  // The name must be a literal.
  if (__builtin_cpu_supports("sse4.2")) out.emplace_back("sse4.2");
  if (__builtin_cpu_supports("avx")) out.emplace_back("avx");
  if (__builtin_cpu_supports("avx2")) out.emplace_back("avx2");
  if (__builtin_cpu_supports("bmi2")) out.emplace_back("bmi2");
  if (__builtin_cpu_supports("fma")) out.emplace_back("fma");
  if (__builtin_cpu_supports("avx512f")) out.emplace_back("avx512f");
  if (__builtin_cpu_supports("avx512dq")) out.emplace_back("avx512dq");
  if (__builtin_cpu_supports("avx512vl")) out.emplace_back("avx512vl");
#endif
  return out;
}

}  // namespace radcert::app
