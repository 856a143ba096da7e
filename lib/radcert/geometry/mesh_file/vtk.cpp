// SPDX-License-Identifier: GPL-3.0-or-later

// VTK's legacy files, as text.
#include <string>
#include <vector>

#include "radcert/geometry/mesh_file/parts.h"

namespace radcert {
namespace {

using Words = std::vector<std::string_view>;

class VtkReader {
public:
  explicit VtkReader(std::string_view bytes) : lines_(bytes, '\0') {}

  MeshFile read() {
    const Words head = line("# vtk DataFile Version 3.0");
    if (head.size() < 5 || head[0] != "#" || head[1] != "vtk")
      refuse_mesh(lines_.place(), std::string(lines_.line().substr(0, 40)), "begins no VTK file",
                  "# vtk DataFile Version 3.0");
    line("a title");
    const Words form = line("ASCII");
    if (form.front() != "ASCII")
      refuse_mesh(lines_.place(), std::string(form.front()), "is a form that is not read", "ASCII");
    const Words kind = line("DATASET POLYDATA or UNSTRUCTURED_GRID");
    grid_ = kind.size() == 2 && kind[1] == "UNSTRUCTURED_GRID";
    if (kind.size() != 2 || kind[0] != "DATASET" || (!grid_ && kind[1] != "POLYDATA"))
      refuse_mesh(lines_.place(), std::string(lines_.line().substr(0, 40)), "is no surface",
                  "DATASET POLYDATA or UNSTRUCTURED_GRID");
    while (const auto next = lines_.next()) {
      at_ = 0;
      words_ = *next;
      const std::string key(words_[0]);
      if (key == "POINTS") {
        read_points();
      } else if (key == (grid_ ? "CELLS" : "POLYGONS")) {
        read_cells();
      } else if (key == "CELL_TYPES" && grid_) {
        read_types();
      } else if (key == "METADATA" || key == "INFORMATION" || key == "NAME" || key == "DATA") {
        // What ParaView says of its arrays.
        continue;
      } else if (key == "POINT_DATA" || key == "CELL_DATA") {
        break;
      } else if (key == "VERTICES" || key == "LINES" || key == "TRIANGLE_STRIPS" || key == "FIELD") {
        refuse_mesh(lines_.place(), key, "is a part that is not read", "POINTS, POLYGONS, CELLS, CELL_TYPES");
      } else {
        refuse_mesh(lines_.place(), key, "begins no part that is read",
                    "POINTS, POLYGONS, CELLS, CELL_TYPES");
      }
    }
    if (grid_ && types_.size() != cells_.size())
      refuse_mesh(lines_.place(), std::to_string(types_.size()), "is not the number of types of the cells",
                  std::to_string(cells_.size()));
    for (std::size_t k = 0; k < cells_.size(); ++k) face(k);
    return mesh_.finish("VTK, ASCII", std::nullopt);
  }

private:
  Words line(const std::string& allowed) {
    if (auto words = lines_.next()) return *words;
    refuse_mesh(lines_.place(), std::nullopt, "is the last line: the file ends too early", allowed);
  }
  /// The next word, on this line or a later one.
  std::string_view word(const std::string& allowed) {
    while (at_ >= words_.size()) {
      words_ = line(allowed);
      at_ = 0;
    }
    return words_[at_++];
  }
  long long number(const std::string& allowed) {
    return whole_number(word(allowed), lines_.place(), allowed);
  }
  std::size_t count(const std::string& allowed) {
    const long long found = number(allowed);
    if (found < 0) refuse_mesh(lines_.place(), std::to_string(found), "is negative", allowed);
    return static_cast<std::size_t>(found);
  }

  void read_points() {
    at_ = 1;
    const std::size_t points = count("POINTS number double");
    const std::string_view type = word("float or double");
    if (type != "float" && type != "double")
      refuse_mesh(lines_.place(), std::string(type), "is no type of a coordinate", "float or double");
    for (std::size_t k = 0; k < points; ++k) {
      const double x = mesh_.coordinate(word("x y z"), lines_.place());
      const double y = mesh_.coordinate(word("x y z"), lines_.place());
      const double z = mesh_.coordinate(word("x y z"), lines_.place());
      mesh_.vertex({x, y, z});
    }
  }
  void read_cells() {
    at_ = 1;
    const std::string allowed = "the number of cells and of all numbers below";
    const std::size_t cells = count(allowed);
    const std::size_t numbers = count(allowed);
    const std::string_view first = word(allowed);
    if (first == "OFFSETS") return read_offsets(cells, numbers);
    --at_;
    for (std::size_t k = 0; k < cells; ++k) {
      Cell cell;
      for (std::size_t left = count("the number of corners, and these"); left > 0; --left)
        cell.corners.push_back(count("numbers of points, from 0"));
      cell.place = lines_.place();
      cells_.push_back(std::move(cell));
    }
  }
  /// Since version 5: where each cell begins, and where the last one ends; then all corners.
  void read_offsets(std::size_t offsets, std::size_t numbers) {
    word("a type");
    std::vector<std::size_t> begin;
    for (std::size_t k = 0; k < offsets; ++k) begin.push_back(count("offsets"));
    if (word("CONNECTIVITY") != "CONNECTIVITY")
      refuse_mesh(lines_.place(), std::string(lines_.line().substr(0, 40)), "stands where corners begin",
                  "CONNECTIVITY");
    word("a type");
    std::vector<std::size_t> corners;
    for (std::size_t k = 0; k < numbers; ++k) corners.push_back(count("numbers of points, from 0"));
    for (std::size_t k = 0; k + 1 < begin.size(); ++k) {
      if (begin[k] > begin[k + 1] || begin[k + 1] > corners.size())
        refuse_mesh(lines_.place(), std::to_string(begin[k + 1]), "is an offset beyond the next or the last",
                    "ascending offsets");
      const auto from = corners.begin() + static_cast<std::ptrdiff_t>(begin[k]);
      cells_.push_back({{from, corners.begin() + static_cast<std::ptrdiff_t>(begin[k + 1])}, lines_.place()});
    }
  }
  void read_types() {
    at_ = 1;
    for (std::size_t left = count("the number of types, and these"); left > 0; --left)
      types_.push_back(number("types of cells"));
  }
  void face(std::size_t k) {
    const Cell& cell = cells_[k];
    if (grid_) {
      constexpr long long vertex = 1;
      constexpr long long poly_line = 4;
      constexpr long long triangle = 5;
      constexpr long long polygon = 7;
      constexpr long long quadrangle = 9;
      const long long type = types_[k];
      if (type >= vertex && type <= poly_line) return;
      if (type != triangle && type != polygon && type != quadrangle)
        refuse_mesh(cell.place, std::to_string(type), "is the type of a cell that is not read",
                    "triangles (5), polygons (7) and quadrangles (9); points and lines are passed over");
    }
    for (const std::size_t corner : cell.corners) {
      if (corner >= mesh_.vertex_count())
        refuse_mesh(cell.place, std::to_string(corner), "is the number of a point that is not there",
                    "numbers below " + std::to_string(mesh_.vertex_count()));
      mesh_.corner(corner);
    }
    mesh_.end_face(cell.place);
  }

  struct Cell {
    std::vector<std::size_t> corners;
    std::string place;
  };
  TextLines lines_;
  Words words_;
  std::size_t at_ = 0;
  MeshBuilder mesh_;
  bool grid_ = false;
  std::vector<Cell> cells_;
  std::vector<long long> types_;
};

}  // namespace

MeshFile parse_vtk(std::string_view bytes) { return VtkReader(bytes).read(); }

}  // namespace radcert
