// SPDX-License-Identifier: GPL-3.0-or-later

// The input of View3D, .vs3.
#include <map>
#include <string>

#include "radcert/geometry/mesh_file/parts.h"

namespace radcert {

MeshFile parse_vs3(std::string_view bytes) {
  using Words = std::vector<std::string_view>;
  const std::string grammar =
      "T title, C controls, F 3, V number x y z, S number v1 v2 v3 v4 base cmb emit name, E";
  TextLines lines(bytes, '!');
  MeshBuilder mesh;
  std::map<long long, std::size_t> vertices;
  std::map<long long, std::string> names;  // of surfaces, for those that are put together with them
  const auto number = [&](const Words& words, std::size_t at) {
    if (at >= words.size()) refuse_mesh(lines.place(), std::nullopt, "has too few numbers", grammar);
    return whole_number(words[at], lines.place(), grammar);
  };
  bool ended = false;
  while (const auto next = lines.next()) {
    const Words& words = *next;
    if (ended) break;
    const char key = words.front().front();
    switch (key) {
      case 'T':
      case 't':
      case 'C':
      case 'c':
      case '*': break;
      case 'F':
      case 'f':
        if (words.size() < 2 || words[1].front() != '3')
          refuse_mesh(lines.place(), std::string(lines.line()), "is no scene in three dimensions", "F 3");
        break;
      case 'V':
      case 'v': {
        if (words.size() < 5)
          refuse_mesh(lines.place(), std::nullopt, "has fewer than three coordinates", grammar);
        const long long tag = number(words, 1);
        if (!vertices.emplace(tag, mesh.vertex_count()).second)
          refuse_mesh(lines.place(), std::to_string(tag), "is the number of two vertices", grammar);
        mesh.vertex({mesh.coordinate(words[2], lines.place()), mesh.coordinate(words[3], lines.place()),
                     mesh.coordinate(words[4], lines.place())});
        break;
      }
      case 'S':
      case 's': {
        const long long tag = number(words, 1);
        if (number(words, 6) != 0)
          refuse_mesh(lines.place(), std::to_string(number(words, 6)),
                      "is the base of a surface that lies within it, which is not served",
                      "0, the base cut so that nothing overlaps");
        const long long with = number(words, 7);
        std::string name = words.size() > 9 ? std::string(words[9]) : "surface_" + std::to_string(tag);
        if (with != 0) {
          const auto other = names.find(with);
          if (other == names.end())
            refuse_mesh(lines.place(), std::to_string(with), "is no earlier surface to be put together with",
                        "0, or the number of an earlier surface");
          name = other->second;
        }
        if (!names.emplace(tag, name).second)
          refuse_mesh(lines.place(), std::to_string(tag), "is the number of two surfaces", grammar);
        mesh.group(name);
        for (std::size_t k = 2; k < 6; ++k) {
          const long long vertex = number(words, k);
          if (vertex == 0 && k == 5) break;
          const auto found = vertices.find(vertex);
          if (found == vertices.end())
            refuse_mesh(lines.place(), std::to_string(vertex), "is the number of a vertex that is not there",
                        "numbers of lines V before");
          mesh.corner(found->second);
        }
        mesh.end_face(lines.place());
        break;
      }
      case 'E':
      case 'e': ended = true; break;
      default:
        refuse_mesh(lines.place(), std::string(lines.line().substr(0, 40)),
                    "is no line that is served: obstruction, mask and null surfaces are not", grammar);
    }
  }
  return mesh.finish("View3D", std::nullopt);
}

}  // namespace radcert
