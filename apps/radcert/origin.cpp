// SPDX-License-Identifier: GPL-3.0-or-later
#include "origin.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>
#include <variant>

#include "circumstances.h"
#include "citation.h"
#include "radcert/core/digest.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/core/memory_plan.h"
#include "radcert/core/parallel.h"
#include "radcert/study/collocation/graded_levels.h"
#include "run_ranks.h"
#include "verification/framework/reading/embedded.h"

namespace radcert::app {

namespace {

std::string_view bibliography() {
  for (const EmbeddedFile& file : verification::embedded_papers())
    if (file.path == "references.bib") return file.content;
  return {};
}

/// The entry of a key, from its @ to the brace that ends a line; empty where there is none.
std::string_view entry(std::string_view bibliography, const std::string& key) {
  const std::size_t name = bibliography.find("{" + key + ",");
  if (name == std::string_view::npos) return {};
  const std::size_t begin = bibliography.rfind('@', name);
  const std::size_t end = bibliography.find("\n}", name);
  if (begin == std::string_view::npos || end == std::string_view::npos) return {};
  return bibliography.substr(begin, end + 2 - begin);
}

std::string cite_bib(const std::vector<std::string>& references) {
  std::string out;
  for (const std::string& key : references)
    if (const std::string_view text = entry(bibliography(), key); !text.empty())
      out += std::string(text) + "\n\n";
  return out + std::string(own_citation());
}

std::string standard_input(std::uint64_t limit_bytes) {
  std::string text;
  std::array<char, 65536> part{};
  while (std::cin.read(part.data(), part.size()) || std::cin.gcount() > 0) {
    text.append(part.data(), static_cast<std::size_t>(std::cin.gcount()));
    if (text.size() > limit_bytes)
      throw InputError({.problem = "is longer than " + byte_text(limit_bytes), .allowed = "a shorter text"});
  }
  return text;
}

}  // namespace

InputFile read_input(const std::filesystem::path& file, std::uint64_t limit_bytes) {
  InputFile input{.source = file == "-" ? "standard input" : file.string(),
                  .text = {},
                  .digest = {.name = file.string(), .digest = {}}};
  const auto read = [&] {
    return with_source(input.source, [&] {
      return file == "-" ? standard_input(limit_bytes) : read_file(file, limit_bytes);
    });
  };
  std::error_code error;
  const bool is_seen = ranks().is_first() || (file != "-" && std::filesystem::exists(file, error));
  if (is_seen) input.text = read();
  const std::string first = ranks().from_first(input.text);
  if (!is_seen) input.text = first;
  require_same_on_all_ranks(input.source, input.text);
  input.digest.digest = digest_of(input.text);
  return input;
}

void require_same_named_files(std::span<const Problem> problems) {
  for (const InputDigest& named : inputs_named_in(problems))
    require_same_on_all_ranks(named.name, named.digest);
}

std::vector<InputDigest> inputs_named_in(std::span<const Problem> problems) {
  std::vector<InputDigest> out;
  const auto add = [&](const std::string& name, const std::string& digest) {
    const bool known =
        std::any_of(out.begin(), out.end(), [&](const InputDigest& one) { return one.name == name; });
    if (!known) out.push_back({.name = name, .digest = digest});
  };
  for (const Problem& problem : problems) {
    if (problem.surface.mesh) add(problem.surface.mesh->file, problem.surface.mesh->digest);
    const TriangleBasisChoice* basis = find_triangle_basis(problem.method);
    if (basis != nullptr && basis->family == NodeFamily::file) add(basis->file, basis->digest);
  }
  return out;
}

std::string notes_on_meshes(std::span<const Problem> problems) {
  std::vector<std::string> lines;
  const auto add = [&](std::string line) {
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
  };
  for (const Problem& problem : problems) {
    if (problem.triangulation.grading != Rational(1) && !problem.guarantee)
      for (const std::string& remark : grading_remarks(problem, surface_of(problem)))
        add("Remark: " + remark + "\n");
    const std::optional<MeshChoice>& mesh = problem.surface.mesh;
    if (!mesh) continue;
    if (const auto& events = problem.triangulation.events)
      add("Events: " + mesh->file + ": " + std::to_string(events->charts) + " faces are cut along " +
          std::to_string(events->segments) + " segments, " + std::to_string(events->kinks) +
          " of them kinks, into " + std::to_string(events->coarse->size()) + " elements in all\n");
    for (const std::string& done : mesh->mended) add("Mended: " + mesh->file + ": " + done + "\n");
    for (const std::string& remark : mesh->remarks) add("Remark: " + mesh->file + ": " + remark + "\n");
  }
  std::string out;
  for (const std::string& line : lines) out += line;
  return out;
}

std::vector<std::string> references_of(const Problem& problem) {
  std::vector<std::string> keys = {"ac98"};
  const TriangleBasisChoice* basis = find_triangle_basis(problem.method);
  if (basis != nullptr && basis->family == NodeFamily::inset) keys.emplace_back("m06");
  if (std::holds_alternative<Meshless>(problem.method)) keys.emplace_back("psg10");
  return keys;
}

std::optional<std::uint64_t> seed_of(std::span<const Problem> problems) {
  std::optional<std::uint64_t> common;
  for (const Problem& problem : problems) {
    const auto* meshless = std::get_if<Meshless>(&problem.method);
    if (meshless == nullptr) continue;
    const std::uint64_t seed = std::visit([](const auto& sites) { return sites.seed; }, meshless->sites);
    if (common && *common != seed) return std::nullopt;
    common = seed;
  }
  return common;
}

Files origin_files(const std::filesystem::path& folder, const Common& common,
                   const std::vector<std::string>& references, std::vector<InputDigest> inputs,
                   std::optional<std::uint64_t> seed) {
  const Provenance provenance{.command = common.command,
                              .inputs = std::move(inputs),
                              .libraries = library_versions(),
                              .compiler = compiler_version(),
                              .architecture = RADCERT_ARCHITECTURE,
                              .system = system_name(),
                              .cpu_features = cpu_features(),
                              .threads = thread_count(),
                              .seed = seed};
  return {{folder / "cite.bib", cite_bib(references)},
          {folder / "provenance.json", provenance_text(provenance)}};
}

}  // namespace radcert::app
