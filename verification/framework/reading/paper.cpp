// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/framework/reading/paper.h"

#include <algorithm>
#include <map>

#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/formats/json/json_reader.h"
#include "verification/framework/reading/embedded.h"

namespace radcert::verification {
namespace {

bool begins_label(std::string_view label, std::string_view part) {
  return label.starts_with(part) && (label.size() == part.size() || label[part.size()] == '.');
}

std::vector<std::string> labels(const Paper& paper) {
  std::vector<std::string> out;
  for (const Claim& claim : paper.claims) out.push_back(claim.label);
  for (const Claim& claim : paper.claims)
    if (claim.table)
      for (const CellRecord& cell : claim.table->cells) out.push_back(cell.label);
  return out;
}

std::string label_list(const Paper& paper) {
  std::string out;
  for (const Claim& claim : paper.claims) out += (out.empty() ? "" : ", ") + claim.label;
  return out;
}

// Whether a label names a claim, a cell of a table, or the beginning of cells.
bool exists(const Paper& paper, std::string_view label) {
  for (const Claim& claim : paper.claims) {
    if (claim.label == label) return true;
    if (claim.table && std::any_of(claim.table->cells.begin(), claim.table->cells.end(),
                                   [&](const CellRecord& cell) { return begins_label(cell.label, label); }))
      return true;
  }
  return false;
}

}  // namespace

std::vector<Paper> embedded_paper_list() {
  std::vector<Paper> papers;
  for (const EmbeddedFile& each : embedded_papers()) {
    constexpr std::string_view ending = "/claims.toml";
    if (!each.path.ends_with(ending)) continue;
    const std::string key(each.path.substr(0, each.path.size() - ending.size()));
    if (key.find('/') != std::string::npos) continue;
    Paper paper;
    paper.key = key;
    paper.source = [key](const std::string& path) { return "papers/" + key + "/" + path; };
    paper.file = [key, source = paper.source](const std::string& path) {
      const std::string wanted = key + "/" + path;
      for (const EmbeddedFile& file : embedded_papers())
        if (file.path == wanted) return std::string(file.content);
      throw InputError({.source = source(path), .problem = "there is no such file in the program"});
    };
    paper.claims = read_claims(each.content, paper.source("claims.toml"));
    papers.push_back(std::move(paper));
  }
  return papers;
}

std::string file_if_there(const Paper& paper, const std::string& path) {
  try {
    return paper.file(path);
  } catch (const InputError&) {
    return {};
  }
}

void check_erratum(const Paper& paper, const Claim& claim) {
  if (claim.erratum.empty()) return;
  const std::string errata = "\n" + file_if_there(paper, "errata.md");
  if (errata.find("\n| " + claim.erratum + " |") != std::string::npos) return;
  const std::string file = paper.source("errata.md");
  throw InputError({.source = paper.source("claims.toml") + ", line " + std::to_string(claim.line),
                    .pointer = "/" + claim.label + "/erratum",
                    .value = claim.erratum,
                    .problem = errata.size() == 1
                                   ? "is looked for in " + file + ", which is not there or is empty"
                                   : "is in no row of " + file,
                    .allowed = "the first cell of a row there: \"| " + claim.erratum + " | ... |\""});
}

Paper read_paper(const std::filesystem::path& folder) {
  Paper paper;
  std::filesystem::path name = folder.lexically_normal();
  if (!name.has_filename()) name = name.parent_path();
  if (name == "." || name == "..") name = std::filesystem::weakly_canonical(folder);
  paper.key = name.filename().string();
  paper.folder = folder.string();
  paper.source = [folder](const std::string& path) { return (folder / path).string(); };
  paper.file = [folder](const std::string& path) { return read_file(folder / path); };
  paper.claims = read_claims(paper.file("claims.toml"), paper.source("claims.toml"));
  return paper;
}

bool Selected::wants(std::string_view label) const {
  return labels.empty() || std::any_of(labels.begin(), labels.end(),
                                       [&](const std::string& part) { return begins_label(label, part); });
}

bool Selected::wants_part_of(std::string_view label) const {
  return wants(label) || std::any_of(labels.begin(), labels.end(),
                                     [&](const std::string& part) { return begins_label(part, label); });
}

namespace {

/// Asks for a statement of a paper, which a word of the command line names.
void add_label(Selected& selected, const std::string& word, const std::string& label) {
  if (!exists(selected.paper, label))
    throw InputError({.source = "verify",
                      .value = word,
                      .problem = with_nearest_word(
                          "is not a statement of " +
                              (selected.paper.folder.empty() ? "this paper" : selected.paper.folder),
                          label, labels(selected.paper)),
                      .allowed = selected.paper.folder.empty()
                                     ? "the statements of radcert list claims, or cells of their tables"
                                     : label_list(selected.paper) + ", or a cell of a table"});
  selected.labels.push_back(label);
}

}  // namespace

std::vector<Selected> select(std::span<const std::string> words) {
  std::vector<Paper> embedded = embedded_paper_list();
  std::vector<Selected> selected;
  if (words.empty()) {
    for (Paper& paper : embedded) selected.push_back({std::move(paper), {}});
    return selected;
  }
  std::map<std::string, std::size_t> place;  // of what was named, in `selected`
  std::map<std::string, bool> whole;         // whether all of it was asked for
  const auto entry = [&](const std::string& id, auto&& make) -> std::size_t {
    const auto [found, is_new] = place.try_emplace(id, selected.size());
    if (is_new) selected.push_back({make(), {}});
    return found->second;
  };
  for (const std::string& word : words) {
    const std::size_t slash = word.find('/');
    const std::string key = word.substr(0, slash);
    const auto paper =
        std::find_if(embedded.begin(), embedded.end(), [&](const Paper& each) { return each.key == key; });
    if (paper != embedded.end()) {
      const std::size_t here = entry(key, [&] { return *paper; });
      const std::string label = slash == std::string::npos ? "" : word.substr(slash + 1);
      if (label.empty()) {
        whole[key] = true;
      } else {
        add_label(selected[here], word, label);
      }
      continue;
    }
    std::error_code ignored;
    const std::size_t last = word.rfind('/');
    const bool is_whole = std::filesystem::is_directory(word, ignored);
    const std::string folder = is_whole || last == std::string::npos ? word : word.substr(0, last);
    const bool has_claims =
        last != std::string::npos &&
        std::filesystem::is_regular_file(std::filesystem::path(folder) / "claims.toml", ignored);
    if (is_whole || has_claims) {
      const std::string id = "./" + std::filesystem::weakly_canonical(folder, ignored).string();
      const std::size_t here = entry(id, [&] { return read_paper(folder); });
      if (is_whole)
        whole[id] = true;
      else
        add_label(selected[here], word, word.substr(last + 1));
      continue;
    }
    std::string keys;
    for (const Paper& each : embedded) keys += (keys.empty() ? "" : ", ") + each.key;
    throw InputError({.source = "verify",
                      .value = word,
                      .problem = "is neither a paper nor a folder",
                      .allowed = keys + ", a folder that holds claims.toml, or one of these with /CLAIM"});
  }
  for (const auto& [id, all] : whole)
    if (all) selected[place.at(id)].labels.clear();
  return selected;
}

}  // namespace radcert::verification
