// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "radcert/scalar/rational.h"
#include "verification/framework/verdict.h"

namespace radcert::verification {

/// How a claim is checked.
/// Maths     function: code of verification/claims/<key>; table: cells of a printed table; order: an
///           order; enclosure: a proved number in a stated interval; none: nothing is run
/// Result    `none` belongs to definitions and to statements not yet looked at
enum class CheckKind { function, table, order, enclosure, none };

/// The recorded verdict of one cell of a table.
struct CellRecord {
  std::string label;  ///< "table_1.alpha_1_6.n4.discretisation_error"
  PerBudget<Verdict> verdict;
  std::string note;           ///< what holds instead, where a cell disagrees
  bool second_route = false;  ///< whether an independent computation is held against ours
  int line = 0;               ///< in claims.toml
};

/// What a column of a printed table holds: "discretisation_error", "discretisation_ratio", "node_error" or
/// "node_ratio".
struct FigureColumn {
  std::string figure;
  std::string column;  ///< its header in the table's file
};

/// The rows of a printed table that belong to one problem.
struct TableSeries {
  std::string name;  ///< part of the cells' labels; empty where the table has one series
  std::vector<std::pair<std::string, std::string>>
      where;            ///< the rows whose column has this text; empty: all
  std::string problem;  ///< file, from the folder of claims.toml
  /// File of a problem that must not reproduce the printed errors; its levels are among the problem's
  std::string control;
  std::vector<FigureColumn> figures;
  PerBudget<int> verified =
      PerBudget<int>::same(0);  ///< levels of up to so many elements are solved with a proof
  int line = 0;
};

/// A printed table: which file, which problems, which cells.
struct TableClaim {
  std::string file;
  std::string rows = "n";  ///< the column that holds the number of elements
  std::vector<TableSeries> series;
  std::vector<CellRecord> cells;  ///< in the order of the file
};

/// "An error falls at least like h^order", or like h^order |log h|.
struct OrderClaim {
  std::string problem;   ///< file of a problem with three consecutive levels at least
  std::string control;   ///< file of a problem whose order must be rejected
  std::string quantity;  ///< "discretisation_error" or "node_error"
  double order = 0;
  bool logarithm = false;
};

/// A number that can be enclosed with a proof: a figure of a problem, or a reference value.
struct EnclosedQuantity {
  std::string problem;       ///< file of a problem for the solver `verified`; empty: a reference value
  std::string quantity;      ///< of a problem: one of enclosed_quantities()
  std::optional<int> level;  ///< of a problem; absent: its last
  std::string reference;     ///< a value or a family of values, by name
  /// Of a family's parameters; the rest has its defaults
  std::vector<std::pair<std::string, Rational>> values;
};

/// "discretisation_error", "node_error", "least_u_n" and "largest_u_n", the last two over the nodes.
[[nodiscard]] std::vector<std::string> enclosed_quantities();

/// A number that lies in a closed interval.
struct EnclosureClaim {
  Rational least;
  Rational largest;  ///< least <= largest
  EnclosedQuantity number;
  EnclosedQuantity control;  ///< a number that must be proved to lie outside
};

/// One numbered statement, as papers/<key>/claims.toml has it.
/// Source    verification/README.md
/// Requires  made by read_claims
/// Result    plain data; a table has cells instead of a verdict of its own
struct Claim {
  std::string label;
  std::vector<int> covers;  ///< numbered equations that it answers for
  std::optional<int> page;
  std::string says;
  std::string formula;  ///< the statement in TeX, as in a displayed formula; empty: words alone
  std::vector<std::string> needs;
  std::vector<std::string> met;    ///< how each hypothesis is met where it was checked; empty: not said
  std::optional<Scope> scope;      ///< of the verdict; absent where nothing is checked
  std::vector<std::string> tried;  ///< the instances, or the family; empty where the scope is all
  std::string unchecked;           ///< what the evidence does not reach; empty: nothing is left
  std::string erratum;             ///< the place of its line in errata.md
  std::optional<PerBudget<Verdict>> verdict;  ///< absent for a table
  CheckKind check = CheckKind::function;
  std::string note;
  std::string symbol;  ///< of a definition: the public symbol that stands for it
  std::optional<TableClaim> table;
  std::optional<OrderClaim> order;
  std::optional<EnclosureClaim> enclosure;
  int line = 0;
};

/// The claims of a paper.
/// Requires  `text` is the content of claims.toml; `source` names it in messages
/// Result    in the order of the file; InputError with source, line and place for text that is no TOML,
///           unknown or missing keys, wrong types, unknown verdicts, a recorded `failed`, labels that are not
///           snake_case
/// Limits    whether the cells are complete is seen when the table itself is read
[[nodiscard]] std::vector<Claim> read_claims(std::string_view text, const std::string& source);

}  // namespace radcert::verification
