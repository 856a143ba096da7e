// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/part.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "radcert/core/digest.h"
#include "radcert/core/parallel.h"

namespace radcert::certificate {

std::vector<std::size_t> chosen_elements(std::size_t count, const Part& part) {
  std::vector<std::pair<std::string, std::size_t>> order;
  for (std::size_t e = 0; e < count; ++e) order.emplace_back(sha256(part.seed + "/" + std::to_string(e)), e);
  std::sort(order.begin(), order.end());
  order.resize(std::min(count, part.elements));
  std::vector<std::size_t> out;
  for (const auto& [digest, element] : order) out.push_back(element);
  std::sort(out.begin(), out.end());
  return out;
}

std::optional<Refusal> first_fault(const std::vector<std::size_t>& parts,
                                   const std::function<std::optional<Refusal>(std::size_t)>& fault,
                                   const CheckListener& progress) {
  // A chunk after a fault is not looked at, unless it comes before it.
  const std::size_t count = parts.size();
  std::vector<std::optional<Refusal>> faults(count);
  std::atomic<std::size_t> first = count;
  std::atomic<std::size_t> done = 0;
  parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (k > first) continue;
      faults[k] = fault(parts[k]);
      if (faults[k])
        for (std::size_t found = first; k < found;)
          if (first.compare_exchange_weak(found, k)) break;
      const std::size_t now = ++done;
      if (progress) progress(now);
    }
  });
  return first < count ? faults[first] : std::nullopt;
}

}  // namespace radcert::certificate
