// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/field/vtu.h"

#include <algorithm>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/formats/field/unstructured_grid.h"

namespace radcert {

std::string vtu_text(std::span<const ElementValue> elements, const std::optional<CornerErrors>& errors,
                     const std::optional<CornerErrors>& iterated_errors) {
  expects(!errors || errors->size() == elements.size(), "errors for every element",
          named("elements", elements.size()));
  UnstructuredGrid grid;
  grid.piece_names = pieces_of(elements);
  std::vector<double> radiosity;
  std::vector<double> iterated;
  for (const ElementValue& element : elements) {
    const auto piece = std::find(grid.piece_names.begin(), grid.piece_names.end(), element.piece);
    grid.pieces.push_back(static_cast<std::size_t>(piece - grid.piece_names.begin()));
    grid.points.insert(grid.points.end(), element.corners.begin(), element.corners.end());
    radiosity.insert(radiosity.end(), element.corner_values.begin(), element.corner_values.end());
    if (element.iterated) iterated.insert(iterated.end(), element.iterated->begin(), element.iterated->end());
  }
  grid.at_points.emplace_back("radiosity", std::move(radiosity));
  const auto add_errors = [&](const std::string& name, const std::optional<CornerErrors>& of_corners) {
    if (!of_corners) return;
    std::vector<double> error;
    for (const std::array<double, 3>& corners : *of_corners)
      error.insert(error.end(), corners.begin(), corners.end());
    grid.at_points.emplace_back(name, std::move(error));
  };
  add_errors("error", errors);
  if (!iterated.empty()) grid.at_points.emplace_back("iterated", std::move(iterated));
  add_errors("iterated_error", iterated_errors);
  return vtu_text(grid);
}

std::string vtu_text(const SolutionEnclosure& enclosure) {
  UnstructuredGrid grid;
  std::vector<double> radiosity;
  std::vector<double> bound;
  const auto add_cell = [&](const std::string& piece) {
    const auto at = std::find(grid.piece_names.begin(), grid.piece_names.end(), piece);
    grid.pieces.push_back(static_cast<std::size_t>(at - grid.piece_names.begin()));
    if (at == grid.piece_names.end()) grid.piece_names.push_back(piece);
  };
  if (enclosure.function) {
    grid.cell = UnstructuredGrid::Cell::quadrilateral;
    for (const EnclosedPatch& patch : enclosure.patches) {
      add_cell(patch.piece);
      grid.points.insert(grid.points.end(), patch.corners.begin(), patch.corners.end());
      radiosity.insert(radiosity.end(), patch.values.begin(), patch.values.end());
      bound.push_back(patch.bound);
    }
    grid.on_cells.emplace_back("bound", std::move(bound));
  } else {
    grid.cell = UnstructuredGrid::Cell::vertex;
    for (const EnclosedValue& point : enclosure.points) {
      add_cell(point.piece);
      grid.points.push_back({point.at.x.to_double(), point.at.y.to_double(), point.at.z.to_double()});
      radiosity.push_back(point.value.value);
      bound.push_back(point.value.radius);
    }
  }
  grid.at_points.emplace_back("radiosity", std::move(radiosity));
  if (!enclosure.function) grid.at_points.emplace_back("radius", std::move(bound));
  for (const SolutionEnclosure::OfEmission& further : enclosure.emissions) {
    std::vector<double> values;
    std::vector<double> radii;
    for (const EnclosedValue& point : further.points) {
      values.push_back(point.value.value);
      radii.push_back(point.value.radius);
    }
    grid.at_points.emplace_back("radiosity, " + further.emission, std::move(values));
    grid.at_points.emplace_back("radius, " + further.emission, std::move(radii));
  }
  return vtu_text(grid);
}

}  // namespace radcert
