// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/core/errors.h"

namespace radcert::test {

/// What the InputError says that an action throws; empty where it throws none.
template <class Action>
std::string refusal_of(const Action& action) {
  try {
    static_cast<void>(action());
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace radcert::test
