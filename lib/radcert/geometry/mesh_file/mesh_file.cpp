// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/mesh_file/mesh_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <utility>

#include "radcert/core/digest.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/geometry/mesh_file/parts.h"

namespace radcert {
namespace {

using Parse = MeshFile (*)(std::string_view);
constexpr std::array<std::pair<std::string_view, Parse>, 10> formats{{{".off", parse_off},
                                                                      {".obj", parse_obj},
                                                                      {".ply", parse_ply},
                                                                      {".stl", parse_stl},
                                                                      {".msh", parse_msh},
                                                                      {".vtk", parse_vtk},
                                                                      {".vtu", parse_vtu},
                                                                      {".vs3", parse_vs3},
                                                                      {".gltf", parse_gltf},
                                                                      {".glb", parse_gltf}}};
constexpr std::uint64_t largest_file = std::uint64_t{4} << 30;

Parse parser_of(const std::string& name) {
  std::string lower = name;
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const auto& [ending, parse] : formats)
    if (lower.ends_with(ending)) return parse;
  return nullptr;
}

}  // namespace

std::string MeshFile::face_text(std::size_t face) const {
  return "face " + std::to_string(face + 1) + " (" + unit_of_place + " " +
         std::to_string(face_place.at(face)) + ")";
}

bool is_mesh_file_name(const std::string& name) { return parser_of(name) != nullptr; }

std::string mesh_file_endings() {
  std::string out;
  for (const auto& [ending, parse] : formats) out += (out.empty() ? "" : ", ") + std::string(ending);
  return out;
}

MeshFile parse_mesh_file(std::string_view bytes, const std::string& name) {
  return with_source(name, [&] {
    const Parse parse = parser_of(name);
    if (parse == nullptr)
      throw InputError(
          {.problem = "has no name of a mesh file", .allowed = "names in " + mesh_file_endings()});
    if (bytes.empty()) throw InputError({.problem = "is empty", .allowed = "a mesh with faces"});
    MeshFile mesh = parse(bytes);
    mesh.digest = digest_of(bytes);
    return mesh;
  });
}

MeshFile read_mesh_file(const std::filesystem::path& path) {
  if (!is_mesh_file_name(path.string())) return parse_mesh_file("", path.string());
  return parse_mesh_file(read_file(path, largest_file), path.string());
}

}  // namespace radcert
