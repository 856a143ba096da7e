// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/provenance.h"

#include <utility>

#include "radcert/core/version.h"

namespace radcert {

std::string provenance_text(const Provenance& provenance) {
  JsonValue machine = JsonValue::object();
  machine.set("system", provenance.system);
  machine.set("threads", provenance.threads);
  machine.set("cpu_features", json_array(provenance.cpu_features));
  JsonValue out = JsonValue::object();
  out.set("schema", "radcert/provenance/1");
  out.set("radcert", version());
  out.set("sources", source_digest());
  out.set("command", provenance.command);
  out.set("inputs", json_array(provenance.inputs, [](const InputDigest& input) {
            return JsonValue::object({{"name", input.name}, {"digest", input.digest}});
          }));
  out.set("compiler", provenance.compiler);
  out.set("architecture", provenance.architecture);
  out.set("libraries", json_array(provenance.libraries, [](const LibraryVersion& library) {
            return JsonValue::object({{"name", library.name}, {"version", library.version}});
          }));
  out.set("machine", std::move(machine));
  out.set("seed", provenance.seed);
  return out.pretty() + "\n";
}

}  // namespace radcert
