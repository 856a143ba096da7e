// SPDX-License-Identifier: GPL-3.0-or-later

// VTK's XML files of unstructured grids: their cells that are faces.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/geometry/mesh_file/parts.h"
#include "radcert/geometry/mesh_file/vtk_xml_arrays.h"

namespace radcert {
namespace {

constexpr std::string_view parts_read = "<Points>, and <Cells> with connectivity, offsets and types";

/// The array of a piece that has this name; a piece without it is refused.
const VtkArray& array_of(const VtkPiece& piece, const std::string& section, const std::string& name) {
  for (const VtkArray& array : piece.arrays)
    if (array.section == section && (name.empty() || array.attribute("Name") == name)) return array;
  refuse_mesh(piece.place, std::nullopt, "has no array " + (name.empty() ? "of " + section : name),
              std::string(parts_read));
}

class VtuReader {
public:
  explicit VtuReader(std::string_view bytes) : file_(bytes) {}

  MeshFile read() {
    for (const VtkPiece& piece : file_.pieces()) read_piece(piece);
    // Pieces, and cells of fields that jump, repeat their points.
    mesh_.join_vertices();
    return mesh_.finish(has_text_ ? "VTU, ASCII" : "VTU, binary",
                        has_text_ ? std::nullopt : std::optional<int>(narrowest_ == 4 ? 24 : 53));
  }

private:
  void read_piece(const VtkPiece& piece) {
    const std::size_t first = mesh_.vertex_count();
    read_points(piece);
    const std::vector<std::int64_t> corners = file_.whole_numbers(array_of(piece, "Cells", "connectivity"));
    const std::vector<std::int64_t> ends = file_.whole_numbers(array_of(piece, "Cells", "offsets"));
    const std::vector<std::int64_t> types = file_.whole_numbers(array_of(piece, "Cells", "types"));
    if (ends.size() != types.size() || ends.size() != piece.cells)
      refuse_mesh(piece.place,
                  std::to_string(ends.size()) + " offsets and " + std::to_string(types.size()) + " types",
                  "are not as many as the piece has cells", std::to_string(piece.cells));
    const VtkArray* groups = groups_of(piece);
    const std::vector<std::int64_t> numbers =
        groups == nullptr ? std::vector<std::int64_t>() : file_.whole_numbers(*groups);
    if (groups != nullptr && numbers.size() != ends.size())
      refuse_mesh(groups->place, std::to_string(numbers.size()), "is not the number of cells",
                  std::to_string(ends.size()));
    std::int64_t begin = 0;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const std::string place = "cell " + std::to_string(cells_before_ + k);
      if (ends[k] < begin || static_cast<std::uint64_t>(ends[k]) > corners.size())
        refuse_mesh(place, std::to_string(ends[k]), "is an offset beyond the next or the last",
                    "ascending offsets");
      if (groups != nullptr) mesh_.group(group_name(*groups, numbers[k]));
      if (is_face(types[k], place)) {
        for (std::int64_t c = begin; c < ends[k]; ++c)
          corner(corners[static_cast<std::size_t>(c)], first, place);
        mesh_.end_face(place);
      }
      begin = ends[k];
    }
    cells_before_ += ends.size();
  }

  void read_points(const VtkPiece& piece) {
    const VtkArray& points = array_of(piece, "Points", "");
    if (points.attribute("NumberOfComponents") != "3")
      refuse_mesh(points.place, points.attribute("NumberOfComponents"), "is not the number of coordinates",
                  "3");
    std::size_t found = 0;
    Vector<double> at{};
    const auto add = [&](double value) {
      (found % 3 == 0 ? at.x : found % 3 == 1 ? at.y : at.z) = value;
      if (++found % 3 == 0) mesh_.vertex(at);
    };
    if (points.is_text()) {
      has_text_ = true;
      for (const std::string_view word : words_of(points.text)) add(mesh_.coordinate(word, points.place));
    } else {
      narrowest_ = std::min(narrowest_, file_.bytes_of_number(points));
      for (const double value : file_.coordinates(points)) add(mesh_.coordinate(value, points.place));
    }
    if (found != 3 * piece.points)
      refuse_mesh(points.place, std::to_string(found), "is not three times the number of points",
                  std::to_string(3 * piece.points) + " coordinates");
  }

  void corner(std::int64_t point, std::size_t first, const std::string& place) {
    const std::size_t points = mesh_.vertex_count() - first;
    if (point < 0 || static_cast<std::uint64_t>(point) >= points)
      refuse_mesh(place, std::to_string(point), "is the number of a point that is not there",
                  "numbers below " + std::to_string(points));
    mesh_.corner(first + static_cast<std::size_t>(point));
  }

  /// Points and lines are passed over.
  static bool is_face(std::int64_t type, const std::string& place) {
    constexpr std::int64_t vertex = 1;
    constexpr std::int64_t poly_line = 4;
    if (type >= vertex && type <= poly_line) return false;
    const bool face = type == 5 || type == 7 || type == 9;
    if (!face)
      refuse_mesh(place, std::to_string(type), "is the type of a cell that is not read",
                  "triangles (5), polygons (7) and quadrangles (9); points and lines are passed over");
    return face;
  }

  /// Which cells belong together, as radcert, Gmsh by way of meshio, and ParaView's readers say it.
  static const VtkArray* groups_of(const VtkPiece& piece) {
    for (const char* name : {"piece", "group", "gmsh:physical", "CellEntityIds"})
      for (const VtkArray& array : piece.arrays)
        if (array.section == "CellData" && array.attribute("Name") == name) return &array;
    return nullptr;
  }

  /// The name that a legend gives a number, "piece 3: floor"; else "piece 3".
  std::string group_name(const VtkArray& groups, std::int64_t number) const {
    const std::string plain = groups.attribute("Name") + " " + std::to_string(number);
    for (const VtkArray& array : file_.fields())
      if (array.attribute("Name").starts_with(plain + ": "))
        return array.attribute("Name").substr(plain.size() + 2);
    return plain;
  }

  VtkXmlFile file_;
  MeshBuilder mesh_;
  bool has_text_ = false;
  std::size_t narrowest_ = 8;
  std::size_t cells_before_ = 0;
};

}  // namespace

MeshFile parse_vtu(std::string_view bytes) { return VtuReader(bytes).read(); }

}  // namespace radcert
