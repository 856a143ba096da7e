// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/surface_function.h"

#include "radcert/core/contract.h"

namespace radcert {

const Expression& PiecewiseExpression::on(std::string_view piece) const {
  const Case* rest = nullptr;
  for (const Case& part : cases) {
    if (part.piece == piece) return part.expression;
    if (part.piece == "*") rest = &part;
  }
  expects(rest != nullptr, "an expression for every piece", named("piece", piece));
  return rest->expression;
}

}  // namespace radcert
