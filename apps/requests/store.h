// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/core/files/result_store.h"

namespace radcert::app {

/// The store of a folder; of "" one that keeps nothing, of "default" that of the program.
[[nodiscard]] inline ResultStore store_named(const std::string& folder) {
  if (folder.empty()) return ResultStore::none("none was asked for");
  if (folder == "default") return ResultStore();
  return ResultStore(folder);
}

}  // namespace radcert::app
