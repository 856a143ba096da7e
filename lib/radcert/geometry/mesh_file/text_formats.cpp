// SPDX-License-Identifier: GPL-3.0-or-later

// OFF and OBJ.
#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>

#include "radcert/geometry/mesh_file/parts.h"

namespace radcert {
namespace {

using Words = std::vector<std::string_view>;

// The statements of an OBJ file that change neither vertices nor faces nor their groups.
constexpr std::array<std::string_view, 32> without_area = {
    "vt",     "vn",     "vp",     "p",        "l",        "s",    "mg",         "mtllib",
    "maplib", "usemap", "bevel",  "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj",
    "ctech",  "stech",  "cstype", "deg",      "bmat",     "step", "parm",       "trim",
    "hole",   "scrv",   "sp",     "end",      "con",      "call", "csh",        "newmtl"};

/// Three coordinates from the word `first` on, then one of these numbers of numbers that are read past.
void read_vertex(MeshBuilder& mesh, const Words& words, std::size_t first, const std::string& place,
                 std::initializer_list<std::size_t> more, const std::string& allowed) {
  if (words.size() < first + 3) refuse_mesh(place, std::nullopt, "has fewer than three coordinates", allowed);
  mesh.vertex({mesh.coordinate(words[first], place), mesh.coordinate(words[first + 1], place),
               mesh.coordinate(words[first + 2], place)});
  const std::size_t rest = words.size() - first - 3;
  if (std::find(more.begin(), more.end(), rest) == more.end())
    refuse_mesh(place, std::to_string(rest + 3), "is not how many numbers a vertex has here", allowed);
  for (std::size_t i = first + 3; i < words.size(); ++i) require_number(words[i], place);
}

/// The vertices of an OFF file, by the letters before OFF: a normal (N), a colour (C).
void read_off_vertex(MeshBuilder& mesh, const Words& words, const std::string& header,
                     const std::string& place) {
  if (header == "COFF")
    return read_vertex(mesh, words, 0, place, {3, 4}, "x y z and a colour of 3 or 4 numbers");
  if (header == "NOFF") return read_vertex(mesh, words, 0, place, {3}, "x y z and a normal of 3 numbers");
  if (header == "CNOFF")
    return read_vertex(mesh, words, 0, place, {6, 7}, "x y z, a normal of 3 numbers and a colour of 3 or 4");
  read_vertex(mesh, words, 0, place, {0}, "a vertex a line: x y z, and no more after the header OFF");
}

/// What follows the corners of a face of an OFF file.
void require_colour(const Words& words, std::size_t first, const std::string& place) {
  const std::size_t numbers = words.size() - first;
  if (numbers == 2 || numbers > 4)
    refuse_mesh(place, std::to_string(numbers), "is not how many numbers the colour of a face has",
                "the corners, then no number, 1, 3 or 4");
  for (std::size_t i = first; i < words.size(); ++i) require_number(words[i], place);
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
  // What follows are the numbers of a texture and of a normal: read past, the first may be left out.
  std::size_t strokes = 0;
  for (std::size_t at = word.find('/'); at != std::string_view::npos; ++strokes) {
    const std::size_t next = word.find('/', at + 1);
    const std::string_view part =
        word.substr(at + 1, next == std::string_view::npos ? std::string_view::npos : next - at - 1);
    const bool left_out = part.empty() && next != std::string_view::npos && strokes == 0;
    if (strokes == 2 || (!left_out && whole_number(part, place, allowed) == 0))
      refuse_mesh(place, std::string(word), "is no corner", "corners such as 7, 7/2, 7//3, 7/2/3");
    at = next;
  }
  if (number > 0) return static_cast<std::size_t>(number - 1);
  // Of -2^63, too, the size is a number without sign.
  const std::size_t from_the_end = 0 - static_cast<std::size_t>(number);
  if (number == 0 || from_the_end > vertices)
    refuse_mesh(place, std::to_string(number), "is no vertex number", allowed);
  return vertices - from_the_end;
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
    read_off_vertex(mesh, vertex, header, lines.place());
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
    require_colour(face, static_cast<std::size_t>(corners) + 1, lines.place());
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
      read_vertex(mesh, *words, 1, lines.place(), {0, 1, 3, 4},
                  "x y z, perhaps a weight of 1 or a colour of 3 or 4 numbers");
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
    } else if (std::find(without_area.begin(), without_area.end(), key) == without_area.end()) {
      refuse_mesh(lines.place(), std::string(key), "begins no statement of an OBJ file",
                  "v, f, o, g, usemtl and the other words of the format, in lower case");
    }
  }
  return mesh.finish("OBJ", std::nullopt);
}

}  // namespace radcert
