// SPDX-License-Identifier: GPL-3.0-or-later
#include "named_surface.h"

#include <algorithm>
#include <vector>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/formats/json/json_reader.h"
#include "radcert/geometry/mesh_file/mesh_file.h"

namespace radcert::app {

const SurfaceDescription& surface_named(const std::string& name) {
  if (const SurfaceDescription* found = find_surface(name)) return *found;
  std::vector<std::string> names;
  for (const SurfaceDescription& known : surface_catalogue()) names.push_back(known.name);
  throw InputError({.source = "surface",
                    .value = name,
                    .problem = with_nearest_word("is no surface", name, names),
                    .allowed = listed(names) + ", or a file in " + mesh_file_endings()});
}

MeshRepair repair_of(const std::vector<std::string>& words) {
  const std::vector<std::string> known(repair_words.begin(), repair_words.end());
  for (const std::string& word : words)
    if (std::find(known.begin(), known.end(), word) == known.end())
      throw InputError({.source = "--repair", .value = word, .allowed = listed(known)});
  return repair_named(words);
}

FrontRule front_of(const std::string& word) {
  const std::vector<std::string> known(front_words.begin(), front_words.end());
  const auto at = std::find(known.begin(), known.end(), word);
  if (at == known.end()) throw InputError({.source = "--front", .value = word, .allowed = listed(known)});
  return static_cast<FrontRule>(at - known.begin());
}

}  // namespace radcert::app
