// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/pending_findings.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/files/result_store.h"
#include "radcert/core/parallel.h"
#include "verification/framework/stored_finding.h"

namespace radcert::verification {
namespace {

// One level at a time: it is computed on all threads, and another check may need the same.
class LevelsInTurn final : public LevelSource {
public:
  explicit LevelsInTurn(LevelSource& source) : source_(&source) {}
  LevelOutcome level(const Problem& problem, int level) override {
    const std::scoped_lock lock(mutex_);
    return source_->level(problem, level);
  }

private:
  std::mutex mutex_;
  LevelSource* source_;
};

}  // namespace

void find_pending(std::span<const PendingFinding> pending, const Bench& bench,
                  const std::function<void(const PendingFinding&)>& starting) {
  LevelsInTurn levels(bench.levels);
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;

  const auto find = [&](const PendingFinding& one) {
    {
      const std::scoped_lock lock(mutex);
      starting(one);
    }
    RecordedLevels recorded(levels);
    const Bench own{.budget = bench.budget, .route = bench.route, .levels = recorded, .store = bench.store};
    static_cast<void>(stored_finding(*one.check, one.statement, own, recorded));
  };
  const auto leave_with = [&] {
    const std::scoped_lock lock(mutex);
    if (!failure) failure = std::current_exception();
    next = pending.size();
  };
  const auto work = [&] {
    for (std::size_t i = next++; i < pending.size() && bench.store.status(); i = next++) {
      try {
        find(pending[i]);
      } catch (const InputError&) {
        leave_with();
      } catch (const EnvironmentError&) {
        leave_with();
      } catch (const Interrupted&) {
        leave_with();
      } catch (const std::exception&) {
        // It is run again where its words are wanted.
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(thread_count(), pending.size()); ++i) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace radcert::verification
