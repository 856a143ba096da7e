// SPDX-License-Identifier: GPL-3.0-or-later
#include "enclosure_table.h"

#include <vector>

#include "output.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::app {

std::string enclosure_table(const SolutionEnclosure& enclosure) {
  std::vector<std::vector<std::string>> rows = {{"piece", "mean of u", "+-"}};
  for (const auto& [piece, mean] : enclosure.pieces) {
    const EnclosingText text = enclosing_text(mean.value, mean.radius, DecimalForm::general(12));
    rows.push_back({piece, text.value, text.radius});
  }
  return aligned(rows) +
         "\nProved: the means of the solution u of the equation itself lie within these radii. Width " +
         upper_text(enclosure.width) + ", asked for " +
         enclosing_text(enclosure.wanted.width, 0, DecimalForm::general(17)).value + ".\n";
}

}  // namespace radcert::app
