// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "radcert/core/errors.h"
#include "radcert/study/experiment.h"

namespace radcert {

/// An experiment file.
/// Source    the file format radcert/experiment/1: base has the keys of a problem that all share, vary a list
///           for each other
/// Requires  a file of at most 64 MiB, nested at most 64 deep
/// Result    every combination as a problem file with these parts would be read, files relative to the
///           experiment's folder; otherwise InputError with file, JSON pointer into the experiment, value and
///           what is allowed. Two combinations that are the same problem are refused at the element that
///           repeats the other
/// Limits    see parse_problem: check() is left to the caller
[[nodiscard]] Experiment read_experiment(const std::filesystem::path& path);

/// The same from a text; `source` names it in messages.
[[nodiscard]] Experiment parse_experiment(std::string_view text, const std::string& source);

/// An error about the problem of a combination as one about the experiment.
/// Requires  an error whose pointer, if any, is one into the problem
/// Result    the pointer leads into base or to the list's element; the combination is named where several
///           parts are varied
[[nodiscard]] InputError in_experiment(const InputError& error, const Combination& combination);

/// Runs an action; an InputError about the combination's problem leaves it as one about the experiment in
/// `source`.
/// Result    an InputError without a source, or with this one, is changed; every other exception leaves as it
///           is
void with_combination(const Combination& combination, const std::string& source,
                      const std::function<void()>& action);

}  // namespace radcert
