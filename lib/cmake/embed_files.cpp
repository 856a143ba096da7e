// SPDX-License-Identifier: GPL-3.0-or-later

// Run by the build: embed_files FOLDER LIST OUTPUT HEADER FUNCTION
// Writes a C++ source that defines FUNCTION(), declared in HEADER, with the files named in LIST, one absolute
// path a line, by their paths from FOLDER.

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

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
           const std::filesystem::path& output, const std::string& header, const std::string& function) {
  std::ofstream out(output, std::ios::binary);
  out << "#include \"" << header << "\"\n\nnamespace {\n\nconstexpr radcert::EmbeddedFile files[] = {";
  std::ifstream lines(list);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    const std::string content = read(line);
    out << "\n  radcert::EmbeddedFile{";
    write_literal(out, std::filesystem::path(line).lexically_relative(folder).generic_string());
    // The length is written out: a file may hold a zero byte.
    out << ", std::string_view(\n    ";
    write_literal(out, content);
    out << ", " << content.size() << ")},";
  }
  out << "\n};\n\n}  // namespace\n\nstd::span<const radcert::EmbeddedFile> " << function
      << "() { return files; }\n";
  if (!out.flush()) throw std::runtime_error("cannot write " + output.string());
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 6) {
    std::cerr << "usage: embed_files FOLDER LIST OUTPUT HEADER FUNCTION\n";
    return 2;
  }
  embed(argv[1], argv[2], argv[3], argv[4], argv[5]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "embed_files: " << error.what() << '\n';
  return 3;
}
