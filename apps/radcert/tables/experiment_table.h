// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "radcert/study/experiment.h"

namespace radcert::app {

/// The results of an experiment for people: the combinations by their error at equal unknowns, and their
/// error at equal seconds beside it.
std::string experiment_table(const Experiment& experiment, std::span<const Result> results);

}  // namespace radcert::app
