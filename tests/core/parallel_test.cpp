// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/parallel.h"

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"

#include <atomic>
#include <bit>
#include <cstdint>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using radcert::parallel_for, radcert::parallel_reduce_ordered, radcert::ThreadLimit;

TEST(ParallelFor, VisitsEveryIndexOnce) {
  for (const std::size_t count : {0UL, 1UL, 2UL, 255UL, 256UL, 257UL, 10000UL}) {
    for (const std::size_t grain : {1UL, 7UL, 256UL, 100000UL}) {
      std::vector<int> visits(count, 0);
      parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << count << " in chunks of " << grain;
    }
  }
}

TEST(ParallelFor, ChunksDependOnCountAndGrainOnly) {
  for (const std::size_t threads : {1UL, 2UL, 5UL}) {
    const ThreadLimit limit(threads);
    std::vector<std::size_t> ends(10, 0);
    parallel_for(100, 11, [&](std::size_t begin, std::size_t end) { ends[begin / 11] = end; });
    EXPECT_EQ(ends, (std::vector<std::size_t>{11, 22, 33, 44, 55, 66, 77, 88, 99, 100})) << threads;
  }
}

TEST(ParallelFor, DefaultGrainMakesAtMost256Chunks) {
  for (const std::size_t count : {1UL, 256UL, 257UL, 512UL, 1000003UL}) {
    std::atomic<std::size_t> chunks{0};
    parallel_for(count, [&](std::size_t, std::size_t) { ++chunks; });
    EXPECT_LE(chunks, 256U) << count;
    EXPECT_GE(chunks, std::min<std::size_t>(count, 128)) << count;
  }
}

TEST(ParallelFor, RethrowsTheExceptionOfTheLowestChunk) {
  for (const std::size_t threads : {1UL, 4UL}) {
    const ThreadLimit limit(threads);
    for (int trial = 0; trial < 50; ++trial) {
      try {
        parallel_for(1000, 1, [](std::size_t begin, std::size_t) {
          if (begin == 17 || begin >= 500) throw std::runtime_error(std::to_string(begin));
        });
        FAIL() << "no exception";
      } catch (const std::runtime_error& error) {
        ASSERT_STREQ(error.what(), "17");
      }
    }
  }
}

TEST(ParallelFor, StopsBetweenChunksWhenInterrupted) {
  const ThreadLimit limit(1);
  std::atomic<std::size_t> done{0};
  EXPECT_THROW(parallel_for(1000, 1,
                            [&](std::size_t, std::size_t) {
                              if (++done == 10) radcert::request_interruption();
                            }),
               radcert::Interrupted);
  radcert::clear_interruption();
  EXPECT_EQ(done, 10U);
}

TEST(ParallelFor, RefusesGrainZero) {
  EXPECT_THROW(parallel_for(10, 0, [](std::size_t, std::size_t) {}), radcert::ContractViolation);
  EXPECT_THROW((void)parallel_reduce_ordered(
                   10, 0, 0, [](std::size_t, std::size_t) { return 1; }, [](int a, int b) { return a + b; }),
               radcert::ContractViolation);
}

TEST(ParallelFor, MayBeNested) {
  std::vector<std::atomic<int>> visits(400);
  parallel_for(20, 1, [&](std::size_t outer, std::size_t) {
    parallel_for(20, 3, [&](std::size_t begin, std::size_t end) {
      for (std::size_t inner = begin; inner < end; ++inner) ++visits[20 * outer + inner];
    });
  });
  for (const auto& visit : visits) EXPECT_EQ(visit, 1);
}

TEST(ParallelReduceOrdered, GivesTheSameBitsForEveryNumberOfThreads) {
  const auto sum = [](std::size_t begin, std::size_t end) {
    double partial = 0;
    for (std::size_t i = begin; i < end; ++i)
      partial += (i % 3 == 0 ? -1.0 : 1.0) / (1.0 + static_cast<double>(i));
    return partial;
  };
  const auto add = [](double a, double b) { return a + b; };
  double by_hand = 0.25;
  for (std::size_t begin = 0; begin < 100001; begin += 37)
    by_hand += sum(begin, std::min<std::size_t>(begin + 37, 100001));
  for (const std::size_t threads : {1UL, 2UL, 3UL, 8UL}) {
    const ThreadLimit limit(threads);
    const double total = parallel_reduce_ordered(100001, 37, 0.25, sum, add);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(total), std::bit_cast<std::uint64_t>(by_hand)) << threads;
  }
}

TEST(ParallelReduceOrdered, FoldsInOrder) {
  const auto text = [](std::size_t begin, std::size_t) { return std::to_string(begin); };
  const auto join = [](const std::string& a, const std::string& b) { return a + " " + b; };
  EXPECT_EQ(parallel_reduce_ordered(10, 3, std::string("start"), text, join), "start 0 3 6 9");
  EXPECT_EQ(parallel_reduce_ordered(0, 3, std::string("start"), text, join), "start");
}

TEST(ThreadLimit, HoldsWhileItLives) {
  const std::size_t before = radcert::thread_count();
  EXPECT_GE(before, 1U);
  {
    const ThreadLimit outer(1);
    EXPECT_EQ(radcert::thread_count(), 1U);
    const ThreadLimit inner(3);
    EXPECT_EQ(radcert::thread_count(), 1U);
  }
  EXPECT_EQ(radcert::thread_count(), before);
  EXPECT_THROW(ThreadLimit(0), radcert::ContractViolation);
}

}  // namespace
