// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/parallel.h"

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/interrupt.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#include <thread>
#include <vector>

namespace radcert {
namespace {

/// Runs run(chunk) for all chunks, from several threads at once.
template <class Run>
void run_all(std::size_t chunks, const Run& run) {
#ifdef __SANITIZE_THREAD__
  // In place of oneTBB, into which the sanitizer does not see. One chunk and another are in no order.
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t chunk = next.fetch_add(1, std::memory_order_relaxed); chunk < chunks;
         chunk = next.fetch_add(1, std::memory_order_relaxed))
      run(chunk);
  };
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < std::min(thread_count(), chunks); ++k) others.emplace_back(work);
  work();
#else
  // Isolated: a thread that waits here takes no chunk of an enclosing loop onto its stack.
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, chunks, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t chunk = range.begin(); chunk != range.end(); ++chunk) run(chunk);
        },
        tbb::simple_partitioner());
  });
#endif
}

}  // namespace

void parallel_for(std::size_t count, std::size_t grain, RangeBody body) {
  expects(grain >= 1, "grain >= 1", named("grain", grain));
  if (count == 0) return;
  const std::size_t chunks = (count - 1) / grain + 1;
  constexpr std::size_t no_chunk = std::numeric_limits<std::size_t>::max();

  std::atomic<std::size_t> lowest_failed{no_chunk};
  std::atomic<bool> left_out{false};
  std::mutex mutex;
  std::exception_ptr failure;

  const auto run_chunk = [&](std::size_t chunk) {
    // Chunks below a failed one still run: the lowest exception is then the same for every order of
    // execution.
    if (chunk > lowest_failed.load(std::memory_order_relaxed)) return;
    if (interruption_requested()) {
      left_out.store(true, std::memory_order_relaxed);
      return;
    }
    const std::size_t begin = chunk * grain;
    try {
      body(begin, begin + std::min(grain, count - begin));
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (chunk < lowest_failed.load(std::memory_order_relaxed)) {
        lowest_failed.store(chunk, std::memory_order_relaxed);
        failure = std::current_exception();
      }
    }
  };

  if (chunks == 1) {
    run_chunk(0);
  } else {
    run_all(chunks, run_chunk);
  }
  if (left_out.load(std::memory_order_relaxed)) throw Interrupted();
  if (failure) std::rethrow_exception(failure);
}

std::size_t thread_count() {
  const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  const int here = tbb::this_task_arena::max_concurrency();
  return std::max<std::size_t>(1, std::min(allowed, static_cast<std::size_t>(std::max(here, 1))));
}

struct ThreadLimit::Control {
  explicit Control(std::size_t threads) : control(tbb::global_control::max_allowed_parallelism, threads) {}
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(std::size_t threads) {
  expects(threads >= 1, "at least one thread", named("threads", threads));
  control_ = std::make_unique<Control>(threads);
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace radcert
