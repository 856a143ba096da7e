// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/contract.h"

namespace radcert::detail {

void violated(std::string_view requirement, std::initializer_list<ShownValue> values) {
  std::string message = "required: " + std::string(requirement);
  std::string_view separator = "; ";
  for (const ShownValue& value : values) {
    message.append(separator).append(value.name).append(" = ").append(value.text);
    separator = ", ";
  }
  throw ContractViolation(message);
}

}  // namespace radcert::detail
