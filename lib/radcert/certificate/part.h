// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "radcert/certificate/enclosure.h"

namespace radcert::certificate {

/// Which parts of a certificate are looked at: elements, or rows of points.
struct Part {
  std::size_t elements = 0;  ///< so many, or all where there are no more
  std::string seed;          ///< what the choice follows from
};

/// What a look at a part of a certificate has found.
struct Report {
  std::vector<std::size_t> looked_at;  ///< parts, ascending
  std::optional<Refusal> refusal;      ///< the first number that does not hold
};

/// The number of parts whose claims have been held against proofs.
using CheckListener = std::function<void(std::size_t)>;

/// The parts that are chosen of so many.
/// Maths     those with the least SHA-256 of seed and number
/// Result    ascending, the same for the same seed
[[nodiscard]] std::vector<std::size_t> chosen_elements(std::size_t count, const Part& part);

/// The fault of the first part that has one.
/// Requires  fault is called from several threads, for the numbers of parts
/// Result    the same for any number of threads; parts after it may not have been looked at
[[nodiscard]] std::optional<Refusal> first_fault(
    const std::vector<std::size_t>& parts, const std::function<std::optional<Refusal>(std::size_t)>& fault,
    const CheckListener& progress);

}  // namespace radcert::certificate
