// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "radcert/core/files/result_store.h"
#include "radcert/scalar/approximation.h"

namespace radcert::verification {

/// A number of a check that takes long, computed once and kept.
/// Requires  `key` says everything that the number depends on, but for radcert's own sources, which are added
/// Result    the stored number to the bit, or that of compute(), stored
[[nodiscard]] Approximation stored(ResultStore& store, const std::string& key,
                                   const std::function<Approximation()>& compute);

}  // namespace radcert::verification
