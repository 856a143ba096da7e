// SPDX-License-Identifier: GPL-3.0-or-later

// OFF and OBJ.
#include <array>
#include <string>

#include "radcert/geometry/mesh_parts.h"

namespace radcert {
namespace {

using Words = std::vector<std::string_view>;

/// Three coordinates from the word `first` on.
void read_vertex(MeshBuilder& mesh, const Words& words, std::size_t first, const std::string& place) {
  if (words.size() < first + 3)
    refuse_mesh(place, std::nullopt, "has fewer than three coordinates", "a vertex a line: x y z");
  mesh.vertex({mesh.coordinate(words[first], place), mesh.coordinate(words[first + 1], place),
               mesh.coordinate(words[first + 2], place)});
}

Words next_or_refuse(TextLines& lines, const std::string& what) {
  if (std::optional<Words> words = lines.next()) return *words;
  refuse_mesh(lines.place(), std::nullopt, "is the last line: the file ends too early", what);
}

/// A name of the groups of an OBJ file: "object/group/material", without what is not given.
std::string joined(const std::array<std::string, 3>& names) {
  std::string out;
  for (const std::string& name : names)
    if (!name.empty()) out += (out.empty() ? "" : "/") + name;
  return out;
}

std::string rest_of(const Words& words) {
  std::string out;
  for (std::size_t i = 1; i < words.size(); ++i) out += (i > 1 ? " " : "") + std::string(words[i]);
  return out;
}

/// The vertex of a corner "7", "7/2", "7//3", "-1": counted from 1, or from the end.
std::size_t corner_of(std::string_view word, std::size_t vertices, const std::string& place) {
  const std::string allowed = "a vertex number from 1 on, or from -1 down to count from the last";
  const long long number = whole_number(word.substr(0, word.find('/')), place, allowed);
  if (number > 0) return static_cast<std::size_t>(number - 1);
  if (number == 0 || static_cast<std::size_t>(-number) > vertices)
    refuse_mesh(place, std::to_string(number), "is no vertex number", allowed);
  return vertices - static_cast<std::size_t>(-number);
}

}  // namespace

MeshFile parse_off(std::string_view bytes) {
  TextLines lines(bytes, '#');
  MeshBuilder mesh;
  Words words = next_or_refuse(lines, "OFF, and the numbers of vertices, faces and edges");
  const std::string header(words.front());
  if (header != "OFF" && header != "COFF" && header != "NOFF" && header != "CNOFF")
    refuse_mesh(lines.place(), header, "is no header of an OFF file in three dimensions",
                "OFF, COFF, NOFF or CNOFF");
  words.erase(words.begin());
  if (words.empty()) words = next_or_refuse(lines, "the numbers of vertices, faces and edges");
  if (words.front() == "BINARY") refuse_mesh(lines.place(), "BINARY", "is not served", "OFF files in ASCII");
  const std::string counts = "the numbers of vertices and faces";
  if (words.size() < 2) refuse_mesh(lines.place(), std::nullopt, "has one number", counts);
  const long long vertices = whole_number(words[0], lines.place(), counts);
  const long long faces = whole_number(words[1], lines.place(), counts);
  if (vertices < 0 || faces < 0)
    refuse_mesh(lines.place(), std::to_string(vertices < 0 ? vertices : faces), "is negative", counts);
  for (long long i = 0; i < vertices; ++i) {
    const Words vertex = next_or_refuse(lines, std::to_string(vertices) + " vertices, a line each");
    read_vertex(mesh, vertex, 0, lines.place());
  }
  for (long long k = 0; k < faces; ++k) {
    const Words face = next_or_refuse(lines, std::to_string(faces) + " faces, a line each");
    const std::string allowed = "the number of corners, then so many vertices counted from 0";
    const long long corners = whole_number(face[0], lines.place(), allowed);
    if (corners < 0 || static_cast<std::size_t>(corners) >= face.size())
      refuse_mesh(lines.place(), std::string(face[0]), "is not the number of corners that follow", allowed);
    for (std::size_t c = 1; c <= static_cast<std::size_t>(corners); ++c) {
      const long long vertex = whole_number(face[c], lines.place(), allowed);
      if (vertex < 0 || vertex >= vertices)
        refuse_mesh(lines.place(), std::string(face[c]), "is the index of a vertex that is not there",
                    "indices from 0 to " + std::to_string(vertices - 1));
      mesh.corner(static_cast<std::size_t>(vertex));
    }
    mesh.end_face(lines.place());
  }
  if (lines.next())
    refuse_mesh(lines.place(), std::nullopt, "follows the last face",
                "no more than " + std::to_string(faces) + " faces");
  return mesh.finish("OFF", std::nullopt);
}

MeshFile parse_obj(std::string_view bytes) {
  TextLines lines(bytes, '#');
  MeshBuilder mesh;
  std::array<std::string, 3> names;
  while (const std::optional<Words> words = lines.next()) {
    const std::string_view key = words->front();
    if (words->back() == "\\")
      refuse_mesh(lines.place(), "\\", "continues a line, which is not served", "a vertex or a face a line");
    if (key == "v") {
      if (words->size() == 5 && mesh.coordinate((*words)[4], lines.place()) != 1)
        refuse_mesh(lines.place(), std::string((*words)[4]), "is a weight other than 1", "x y z");
      read_vertex(mesh, *words, 1, lines.place());
    } else if (key == "f") {
      for (std::size_t c = 1; c < words->size(); ++c)
        mesh.corner(corner_of((*words)[c], mesh.vertex_count(), lines.place()));
      mesh.end_face(lines.place());
    } else if (key == "o" || key == "g" || key == "usemtl") {
      names[key == "o" ? 0 : key == "g" ? 1 : 2] = rest_of(*words);
      mesh.group(joined(names));
    } else if (key == "curv" || key == "curv2" || key == "surf") {
      refuse_mesh(lines.place(), std::string(key), "is a free-form curve or surface, which is not served",
                  "faces with vertices");
    }
  }
  return mesh.finish("OBJ", std::nullopt);
}

}  // namespace radcert
