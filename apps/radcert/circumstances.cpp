// SPDX-License-Identifier: GPL-3.0-or-later
#include "circumstances.h"

#include <arb.h>
#include <flint/flint.h>
#include <fmt/format.h>
#include <gmp.h>
#include <mpfr.h>
#include <sys/utsname.h>
#include <tbb/version.h>

#include <Eigen/src/Core/util/Macros.h>
#include <boost/version.hpp>

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
