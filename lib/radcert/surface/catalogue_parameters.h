// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/surface/catalogue.h"

namespace radcert {

/// A length, within what double holds of fourth powers of distances: they must neither overflow nor lose
/// digits to underflow.
[[nodiscard]] ParameterDescription positive_length(std::string name, std::string default_text,
                                                   std::string meaning = {});

/// A part of a whole, in [1/1000, 999/1000]: nearer to its ends a chart has its next singularity within a
/// thousandth of its domain.
[[nodiscard]] ParameterDescription inner_part(std::string name, std::string default_text,
                                              std::string meaning);

}  // namespace radcert
