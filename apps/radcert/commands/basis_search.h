// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "command.h"
#include "output.h"
#include "radcert/formats/json/json_value.h"
#include "radcert/formats/result/basis_json.h"

namespace radcert::app {

/// The options of `radcert basis search`, as written; empty: not given.
struct BasisSearchOptions {
  std::string goal;
  std::string precision;
  std::string starts;
  std::string seed;
  std::string seconds;
  std::string symmetric;
  bool positive = false;

  /// The first option that was given, with its value; for what takes none of them.
  [[nodiscard]] std::optional<std::pair<std::string, std::string>> any() const;
};

/// Whether symmetric nodes are asked for; InputError for another word than on and off.
[[nodiscard]] bool symmetry_asked(const BasisSearchOptions& options);

/// The nodes that a search found, and what is proved of them.
struct SearchedBasis {
  BasisRecord record;
  JsonValue nodes;    ///< as a file of nodes
  JsonValue search;   ///< what was looked for, and how far the search came
  std::string words;  ///< the same for people
};

/// Nodes as the text of a file, with the version and the command.
[[nodiscard]] std::string node_file(const Common& common, const JsonValue& nodes);

/// Looks for symmetric nodes of a degree, or with `symmetric` off for others, and proves what is said of
/// them.
/// Result    nothing where none were found within the starts or the seconds, which stderr says. InputError
///           for options that are no goal. Where the user stopped it, the nodes so far are written to
///           `nodes_file`, if it is not empty, without more being said of them, and Interrupted is thrown
[[nodiscard]] std::optional<SearchedBasis> searched_basis(const Common& common,
                                                          const BasisSearchOptions& options, int degree,
                                                          const Outputs& outputs,
                                                          const std::string& nodes_file);

inline constexpr int largest_searched_degree = 10;

}  // namespace radcert::app
