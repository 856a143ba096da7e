// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/readers.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/core/text.h"
#include "radcert/expression/parse.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/problem/experiment_file.h"
#include "radcert/formats/problem/node_file.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/result/certificate_json.h"
#include "radcert/formats/result/level_record.h"
#include "radcert/formats/table/factors_csv.h"
#include "radcert/geometry/mesh_file/mesh_file.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"
#include "verification/framework/cell.h"
#include "verification/framework/reading/claim.h"
#include "verification/framework/reading/printed_table.h"

namespace radcert::fuzz {

namespace {

// A file that such a text names is looked for where there is none.
const std::string nowhere = "/nowhere/at/all/";

Reader mesh(const std::string& ending) {
  return {ending, [name = "mesh." + ending](std::string_view bytes) { (void)parse_mesh_file(bytes, name); }};
}

void read_numbers(std::string_view text) {
  (void)Rational::parse(text);
  (void)Ball::parse(text);
  (void)parse_double(text);
  (void)verification::parse_printed(text);
}

const std::vector<Reader>& table() {
  static const std::vector<Reader> all = {
      {"json", [](std::string_view text) { (void)parse_json(text, nowhere + "a.json").pretty(); }},
      {"problem", [](std::string_view text) { (void)problem_text(parse_problem(text, nowhere + "p.json")); }},
      {"experiment", [](std::string_view text) { (void)parse_experiment(text, nowhere + "e.json"); }},
      {"nodes", [](std::string_view text) { (void)parse_nodes(text, nowhere + "n.json"); }},
      {"certificate", [](std::string_view text) { (void)read_certificate(text, nowhere + "c.json"); }},
      {"level_record", [](std::string_view text) { (void)read_level_record(text); }},
      {"claims", [](std::string_view text) { (void)verification::read_claims(text, "claims.toml"); }},
      {"printed_table",
       [](std::string_view text) { (void)verification::parse_printed_table(text, "t.csv"); }},
      {"factors",
       [](std::string_view text) {
         (void)parse_factors(text, "f.csv", std::vector<std::string>{"west", "east", "floor"});
       }},
      {"expression", [](std::string_view text) { (void)parse_expression(text); }},
      {"number", read_numbers},
      mesh("off"),
      mesh("obj"),
      mesh("ply"),
      mesh("stl"),
      mesh("msh"),
      mesh("vtk"),
      mesh("vtu"),
      mesh("gltf"),
      mesh("glb"),
      mesh("vs3")};
  return all;
}

std::filesystem::path folder() { return std::filesystem::path(RADCERT_SOURCE_DIR) / "tests" / "fuzz"; }

}  // namespace

std::span<const Reader> readers() { return table(); }

const Reader* find_reader(std::string_view name) {
  const auto found =
      std::find_if(table().begin(), table().end(), [&](const Reader& reader) { return reader.name == name; });
  return found == table().end() ? nullptr : &*found;
}

void read_any(const Reader& reader, std::string_view bytes) try {
  reader.read(bytes);
} catch (const InputError& error) {
  if (!is_utf8(error.what())) throw std::logic_error("a message that is no text");
  for (const char* c = error.what(); *c != '\0'; ++c)
    if (static_cast<unsigned char>(*c) < ' ') throw std::logic_error("a message with control characters");
} catch (const AccuracyNotReached&) {
  // A node file with a certificate that proves nothing to so many bits.
} catch (const std::exception& error) {
  throw std::logic_error(reader.name + ": " + error.what());
}

std::vector<std::string> seeds_of(const Reader& reader) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder() / "seeds" / reader.name))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> out;
  for (const std::filesystem::path& file : files) out.push_back(read_file(file));
  return out;
}

std::vector<std::string> words_of(const Reader& reader) {
  const std::filesystem::path file = folder() / "dictionaries" / (reader.name + ".dict");
  std::vector<std::string> out;
  std::string_view rest;
  const std::string text = read_file(file);
  for (rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    // libFuzzer's form: a word in quotes, with \\, \" and \xAB for bytes.
    if (line.size() < 2 || line.front() != '"' || line.back() != '"') continue;
    std::string word;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      if (line[i] != '\\') {
        word += line[i];
      } else if (line[i + 1] == 'x') {
        word += static_cast<char>(std::stoi(std::string(line.substr(i + 2, 2)), nullptr, 16));
        i += 3;
      } else {
        word += line[++i];
      }
    }
    out.push_back(word);
  }
  return out;
}

}  // namespace radcert::fuzz
