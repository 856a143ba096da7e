// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/memory_plan.h"

#include "radcert/core/checked.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "tests/core/refusal.h"
#include "tests/core/temporary_folder.h"

#include <gtest/gtest.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace {

using radcert::available_memory, radcert::byte_text, radcert::checked_add, radcert::checked_multiply,
    radcert::MemoryPlan;

static_assert(checked_add(UINT64_MAX - 1, 1) == UINT64_MAX);
static_assert(!checked_add(UINT64_MAX, 1));
static_assert(checked_multiply(0, UINT64_MAX) == 0U && checked_multiply(UINT64_MAX, 0) == 0U);
static_assert(checked_multiply(1ULL << 32U, (1ULL << 32U) - 1) == 0xffffffff00000000ULL);
static_assert(!checked_multiply(1ULL << 32U, 1ULL << 32U));

std::string refusal(const MemoryPlan& plan, std::uint64_t limit) {
  return radcert::test::refusal_of([&] { plan.require(limit); });
}

TEST(MemoryPlan, AddsUpAndNamesTheLargest) {
  MemoryPlan plan;
  EXPECT_EQ(plan.total(), 0U);
  EXPECT_EQ(refusal(plan, 0), "");
  plan.add("nodes", 10, 24).add("matrix", 1000, 8).add("right side", 100, 8);
  EXPECT_EQ(plan.total(), 9040U);
  EXPECT_EQ(refusal(plan, 9040), "");
  EXPECT_EQ(refusal(plan, 9039),
            "needs 8.9 KiB (9040 bytes) of memory, most of it for matrix: 7.9 KiB (8000 bytes); allowed: at "
            "most 8.9 KiB (9039 bytes)");
}

TEST(MemoryPlan, NeverWrapsRound) {
  MemoryPlan plan;
  plan.add("matrix", 1ULL << 40U, 1ULL << 40U).add("vector", 8, 8);
  EXPECT_EQ(plan.total(), UINT64_MAX);
  EXPECT_NE(refusal(plan, UINT64_MAX).find("2^64"), std::string::npos);
}

TEST(ByteText, RoundsUp) {
  EXPECT_EQ(byte_text(0), "0 bytes");
  EXPECT_EQ(byte_text(1023), "1023 bytes");
  EXPECT_EQ(byte_text(1024), "1 KiB");
  EXPECT_EQ(byte_text(1025), "1.1 KiB");
  EXPECT_EQ(byte_text(3ULL << 29U), "1.5 GiB");
  EXPECT_EQ(byte_text(UINT64_MAX), "16 EiB");
}

/// A system of a test's own: /proc and /sys as files.
class FakeSystem {
public:
  FakeSystem& file(const std::string& name, const std::string& content) {
    std::filesystem::create_directories((folder_ / name).parent_path());
    radcert::write_atomically(folder_ / name, content);
    return *this;
  }
  [[nodiscard]] std::uint64_t available() const { return available_memory(folder_.path().string()); }

private:
  radcert::test::TemporaryFolder folder_;
};

TEST(AvailableMemory, IsUnboundedWhereTheSystemSaysNothing) {
  EXPECT_EQ(FakeSystem().available(), UINT64_MAX);
}

TEST(AvailableMemory, ReadsMemAvailable) {
  FakeSystem system;
  system.file("proc/meminfo", "MemTotal:       16000000 kB\nMemFree:  5 kB\nMemAvailable:    1000 kB\n");
  EXPECT_EQ(system.available(), 1024000U);
}

TEST(AvailableMemory, TakesTheLeastOfTheGroupsOfVersionTwo) {
  FakeSystem system;
  system.file("proc/meminfo", "MemAvailable:    1000000 kB\n").file("proc/self/cgroup", "0::/outer/inner\n");
  system.file("sys/fs/cgroup/outer/inner/memory.max", "max\n");
  EXPECT_EQ(system.available(), 1024000000U);
  system.file("sys/fs/cgroup/outer/memory.max", "5000\n")
      .file("sys/fs/cgroup/outer/memory.current", "3000\n");
  EXPECT_EQ(system.available(), 2000U);
  system.file("sys/fs/cgroup/outer/memory.stat", "anon 7\ninactive_file 1500\n");
  EXPECT_EQ(system.available(), 3500U);
  system.file("sys/fs/cgroup/outer/memory.current", "9000\n");
  EXPECT_EQ(system.available(), 0U);
}

TEST(AvailableMemory, FindsTheGroupAtTheMountOfAContainer) {
  FakeSystem system;
  system.file("proc/self/cgroup", "0::/not/visible/here\n").file("sys/fs/cgroup/memory.max", "4096\n");
  EXPECT_EQ(system.available(), 4096U);
}

TEST(AvailableMemory, ReadsVersionOne) {
  FakeSystem system;
  system.file("proc/self/cgroup", "11:cpu,cpuacct:/job\n5:memory:/job\n");
  system.file("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "8000\n")
      .file("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "1000\n");
  EXPECT_EQ(system.available(), 7000U);
}

TEST(AvailableMemoryDeathTest, IsWithinTheLimitOfAddresses) {
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer itself takes more addresses than the limit";
#endif
  // In a process of its own: a limit once set is not raised again.
  EXPECT_EXIT(
      {
        rlimit limit{};
        limit.rlim_cur = limit.rlim_max = std::uint64_t{8} << 30;
        setrlimit(RLIMIT_AS, &limit);
        const std::uint64_t left = available_memory();
        _exit(left < limit.rlim_cur && left > 0 ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

TEST(AvailableMemory, IsPositiveOnThisMachine) { EXPECT_GT(available_memory(), 0U); }

}  // namespace
