// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command.h"
#include "commands/basis_search.h"

namespace radcert::app {

/// radcert basis table: for each degree from `first` to `last` the best symmetric nodes that are known, or
/// with `symmetric` off others, what is proved of them, and the orders that they show on three surfaces.
/// Maths     of the set that comes with radcert, of `folder`/nodes_R.json and, where `search` has starts, of
///           what a search finds: the one with the highest predicted order at the nodes, without a logarithm
///           before with one, then with the least upper bound of the norm. Measured: the fitted order of max
///           |u - u_n| over the nodes, rho = 1/2, u = exp(r (x/2 + y/4 - z/8)), r the degree, on all levels
///           of at most 4608 unknowns, on the unit sphere, the ellipsoid (1, 5/4, 3/2) and two_piece(2)
/// Result    nodes.csv, a row a degree, and nodes_R.json in the folder, or free.csv and free_R.json; the
///           same, shorter, for people. InputError for options that are none
ExitCode show_basis_table(const Common& common, const std::string& folder, int first, int last,
                          const BasisSearchOptions& search);

}  // namespace radcert::app
