// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/table/order_text.h"

#include <cmath>

#include "radcert/scalar/enclosing_text.h"

namespace radcert {

std::optional<std::string> fitted_order_text(const OrderFit& fit, std::string_view plus_minus) {
  const DecimalForm form = DecimalForm::fixed(2);
  constexpr std::size_t least_levels = 3;
  if (!fit.order || !std::isfinite(*fit.order)) return std::nullopt;
  if (fit.levels.size() < least_levels || !fit.halfwidth || !(*fit.halfwidth >= 0) ||
      !std::isfinite(*fit.halfwidth))
    return nearest_text(*fit.order, form);
  const EnclosingText text = enclosing_text(*fit.order, *fit.halfwidth, form);
  return text.value + std::string(plus_minus) + text.radius;
}

}  // namespace radcert
