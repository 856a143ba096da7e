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

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace radcert {
namespace {

/// What happens before what in a loop, for a sanitizer that does not see into oneTBB: all that was done
/// before it before its chunks, and those before all that follows. One chunk and another are in no order.
class LoopOrder {
public:
#ifdef __SANITIZE_THREAD__
  void before_loop() { __tsan_release(&begun_); }
  void begin_chunk() { __tsan_acquire(&begun_); }
  void end_chunk() { __tsan_release(&ended_); }
  void after_loop() { __tsan_acquire(&ended_); }

private:
  char begun_ = 0;
  char ended_ = 0;
#else
  void before_loop() {}
  void begin_chunk() {}
  void end_chunk() {}
  void after_loop() {}
#endif
};

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
    LoopOrder order;
    order.before_loop();
    // Isolated: a thread that waits here takes no chunk of an enclosing loop onto its stack.
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, chunks, 1),
          [&](const tbb::blocked_range<std::size_t>& range) {
            order.begin_chunk();
            for (std::size_t chunk = range.begin(); chunk != range.end(); ++chunk) run_chunk(chunk);
            order.end_chunk();
          },
          tbb::simple_partitioner());
    });
    order.after_loop();
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
