// SPDX-License-Identifier: GPL-3.0-or-later

// Run by the build: embed_files FOLDER LIST OUTPUT FUNCTION
// Writes a C++ source that defines FUNCTION() of embedded.h with the files named in LIST, one absolute path a
// line, by their paths from FOLDER.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

std::string read(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

// A string literal a line of text. Three octal digits end an escape, whatever follows.
void write_literal(std::ostream& out, const std::string& text) {
  out << '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n') {
      out << "\\n\"\n    \"";
    } else if (byte < 0x20 || byte >= 0x7f || c == '"' || c == '\\' || c == '?') {
      char escape[5];
      std::snprintf(escape, sizeof escape, "\\%03o", static_cast<unsigned>(byte));
      out << escape;
    } else {
      out << c;
    }
  }
  out << '"';
}

void embed(const std::filesystem::path& folder, const std::filesystem::path& list,
           const std::filesystem::path& output, const std::string& function) {
  std::vector<std::pair<std::string, std::string>> files;
  std::ifstream lines(list);
  for (std::string line; std::getline(lines, line);)
    if (!line.empty())
      files.emplace_back(std::filesystem::path(line).lexically_relative(folder).generic_string(), read(line));
  std::sort(files.begin(), files.end());

  std::ofstream out(output, std::ios::binary);
  out << "#include \"verification/framework/embedded.h\"\n\n#include <array>\n\n"
      << "namespace radcert::verification {\n\nnamespace {\n\n"
      << "constexpr std::array<EmbeddedFile, " << files.size() << "> files{";
  for (const auto& [path, content] : files) {
    out << "\n  EmbeddedFile{";
    write_literal(out, path);
    // The length is written out: a file may hold a zero byte.
    out << ", std::string_view(\n    ";
    write_literal(out, content);
    out << ", " << content.size() << ")},";
  }
  out << "\n};\n\n}  // namespace\n\nstd::span<const EmbeddedFile> " << function << "() { return files; }\n\n"
      << "}  // namespace radcert::verification\n";
  if (!out.flush()) throw std::runtime_error("cannot write " + output.string());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 5) {
    std::cerr << "usage: embed_files FOLDER LIST OUTPUT FUNCTION\n";
    return 2;
  }
  embed(argv[1], argv[2], argv[3], argv[4]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "embed_files: " << error.what() << '\n';
  return 3;
}
