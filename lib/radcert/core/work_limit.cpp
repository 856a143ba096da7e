// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/work_limit.h"

#include "radcert/core/contract.h"

#include <algorithm>
#include <utility>

namespace radcert {

namespace {

/// The limits made so far, the last one first. A pointer alone: it is there before any of them.
constinit const WorkLimit* newest = nullptr;

}  // namespace

WorkLimit::WorkLimit(std::string_view name, long usual, long smallest, std::string_view at_the_limit) noexcept
    : name_(name),
      usual_(usual),
      smallest_(smallest),
      at_the_limit_(at_the_limit),
      next_(std::exchange(newest, this)),
      value_(usual) {}

std::vector<const WorkLimit*> work_limits() {
  std::vector<const WorkLimit*> all;
  for (const WorkLimit* limit = newest; limit != nullptr; limit = limit->next_) all.push_back(limit);
  std::sort(all.begin(), all.end(),
            [](const WorkLimit* a, const WorkLimit* b) { return a->name() < b->name(); });
  return all;
}

LoweredWorkLimit::LoweredWorkLimit(const WorkLimit& limit, long value)
    : limit_(limit), before_(limit.value()) {
  expects(limit.smallest() <= value && value <= limit.usual(), "a value from the smallest to the usual one",
          named("value", value), named("smallest", limit.smallest()), named("usual", limit.usual()));
  limit_.value_.store(value, std::memory_order_relaxed);
}

LoweredWorkLimit::~LoweredWorkLimit() { limit_.value_.store(before_, std::memory_order_relaxed); }

}  // namespace radcert
