// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "radcert/core/files/result_store.h"
#include "requests/work.h"

namespace radcert::app {

/// The store of a folder; of "" one that keeps nothing, of "default" that of the program.
[[nodiscard]] inline ResultStore store_named(const std::string& folder) {
  if (folder.empty()) return ResultStore::none("none was asked for");
  if (folder == "default") return ResultStore();
  return ResultStore(folder);
}

/// Warns where a store that was asked for keeps nothing, or no more.
inline void warn_where_nothing_is_kept(const ResultStore& store, const std::string& folder, Progress& told) {
  if (folder.empty()) return;
  if (const auto status = store.status(); !status) told.warn("finished work is not kept: " + status.reason());
}

}  // namespace radcert::app
