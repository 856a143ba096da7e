// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables/number_cells.h"

#include <cmath>

namespace radcert::app {

void push(std::vector<std::string>& row, const std::optional<Approximation>& number, DecimalForm form) {
  if (!number || !std::isfinite(number->value)) {
    row.insert(row.end(), {"-", "-"});
  } else if (!number->has_radius()) {
    row.insert(row.end(), {nearest_text(number->value, form), "-"});
  } else {
    const EnclosingText text = enclosing_text(number->value, number->radius, form);
    row.insert(row.end(), {text.value, text.radius});
  }
}

}  // namespace radcert::app
