// SPDX-License-Identifier: GPL-3.0-or-later

// STL, ASCII and binary.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "radcert/geometry/mesh_file/parts.h"

namespace radcert {
namespace {

constexpr std::size_t header_bytes = 84;    // 80 of text, 4 of the number of triangles
constexpr std::size_t triangle_bytes = 50;  // 12 floats and 2 bytes
constexpr int float_mantissa_bits = 24;

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

double float_at(std::string_view bytes, std::size_t at) {
  const std::uint32_t bits = little_endian(bytes, at);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}

bool looks_like_text(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 512);
  return std::all_of(begin.begin(), begin.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 32 || c == '\n' || c == '\r' || c == '\t';
  });
}

MeshFile parse_binary(std::string_view bytes, std::size_t triangles) {
  MeshBuilder mesh;
  for (std::size_t k = 0; k < triangles; ++k) {
    const std::size_t begin = header_bytes + k * triangle_bytes;
    const std::string place = "byte " + std::to_string(begin);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = begin + 12 * (c + 1);  // the first three floats are a normal
      mesh.corner(mesh.vertex_count());
      mesh.vertex({mesh.coordinate(float_at(bytes, at), place),
                   mesh.coordinate(float_at(bytes, at + 4), place),
                   mesh.coordinate(float_at(bytes, at + 8), place)});
    }
    mesh.end_face(place);
  }
  mesh.join_vertices();
  return mesh.finish("STL, binary", float_mantissa_bits);
}

MeshFile parse_ascii(std::string_view bytes) {
  TextLines lines(bytes, '\0');
  MeshBuilder mesh;
  bool in_solid = false;
  std::size_t corners = 0;
  const std::string grammar =
      "solid, facet, outer loop, three lines vertex x y z, endloop, endfacet, endsolid";
  while (const auto words = lines.next()) {
    const std::string_view key = words->front();
    if (key == "solid") {
      std::string name;
      for (std::size_t i = 1; i < words->size(); ++i) name += (i > 1 ? " " : "") + std::string((*words)[i]);
      mesh.group(name);
      in_solid = true;
    } else if (key == "endsolid") {
      in_solid = false;
    } else if (key == "vertex" && in_solid && words->size() == 4) {
      mesh.corner(mesh.vertex_count());
      mesh.vertex({mesh.coordinate((*words)[1], lines.place()), mesh.coordinate((*words)[2], lines.place()),
                   mesh.coordinate((*words)[3], lines.place())});
      ++corners;
    } else if (key == "endfacet" && in_solid) {
      if (corners != 3)
        refuse_mesh(lines.place(), std::to_string(corners), "vertices make no facet of an STL file", grammar);
      corners = 0;
      mesh.end_face(lines.place());
    } else if (!in_solid || (key != "facet" && key != "outer" && key != "endloop")) {
      refuse_mesh(lines.place(), std::string(lines.line()), "is no line of an STL file", grammar);
    }
  }
  if (in_solid)
    refuse_mesh(lines.place(), std::nullopt, "is the last line: the file ends within a solid", grammar);
  mesh.join_vertices();
  return mesh.finish("STL, ASCII", std::nullopt);
}

}  // namespace

MeshFile parse_stl(std::string_view bytes) {
  // Binary files may begin with the word solid as well: what they say of their length decides.
  if (bytes.size() >= header_bytes) {
    const std::size_t triangles = little_endian(bytes, header_bytes - 4);
    if (bytes.size() == header_bytes + triangles * triangle_bytes) return parse_binary(bytes, triangles);
  }
  if (looks_like_text(bytes)) {
    const std::size_t begin = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
    if (bytes.substr(begin).starts_with("solid")) return parse_ascii(bytes);
    refuse_mesh("line 1", std::string(bytes.substr(0, std::min<std::size_t>(bytes.find('\n'), 40))),
                "begins a text that is no STL file", "solid NAME, or a binary file");
  }
  if (bytes.size() < header_bytes)
    refuse_mesh("byte " + std::to_string(bytes.size()), std::nullopt, "is the end, within the header",
                "a header of 84 bytes, then 50 bytes a triangle");
  const std::size_t announced = little_endian(bytes, header_bytes - 4);
  const std::size_t needed = header_bytes + announced * triangle_bytes;
  refuse_mesh("byte " + std::to_string(std::min(bytes.size(), needed)), std::nullopt,
              bytes.size() < needed ? "is the end of a file that is cut off: its header announces " +
                                          std::to_string(announced) + " triangles"
                                    : "is where the file should end: its header announces " +
                                          std::to_string(announced) + " triangles",
              std::to_string(needed) + " bytes, not " + std::to_string(bytes.size()));
}

}  // namespace radcert
