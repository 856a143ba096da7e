// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/core/option_name.h"

#include <algorithm>

namespace radcert {

std::string option_name(OptionStyle style, std::string_view name) {
  std::string out(name);
  if (style == OptionStyle::command_line) return "--" + out;
  std::replace(out.begin(), out.end(), '-', '_');
  return out;
}

}  // namespace radcert
