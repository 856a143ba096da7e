// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/factor_mesh.h"

#include <array>
#include <map>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/surface/chart_pieces.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

namespace {

/// Vertices with equal coordinates are one.
class VertexList {
public:
  explicit VertexList(std::vector<Vector<double>>& vertices) : vertices_(vertices) {}
  std::size_t number(const Vector<double>& p) {
    // A sum with 0 makes -0 equal to 0 in the bits as well.
    const Vector<double> at{p.x + 0.0, p.y + 0.0, p.z + 0.0};
    const auto [place, fresh] = numbers_.emplace(std::array<double, 3>{at.x, at.y, at.z}, vertices_.size());
    if (fresh) vertices_.push_back(at);
    return place->second;
  }

private:
  std::vector<Vector<double>>& vertices_;
  std::map<std::array<double, 3>, std::size_t> numbers_;
};

}  // namespace

FactorMesh factor_mesh(const Surface& surface, int level) {
  FactorMesh out;
  out.piece_names = surface.piece_names();
  out.mesh.group_names = {""};
  VertexList vertices(out.mesh.vertices);
  const std::vector<std::size_t> pieces = chart_pieces(surface);
  for (const ParameterTriangle& triangle : triangulate(surface, level).triangles) {
    const Chart& chart = surface.charts[triangle.chart];
    expects(chart.facts().plane.has_value(), "plane charts", named("chart", chart.facts().name));
    VertexTriple corners{};
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = vertices.number(chart.in<double>().frame(triangle.vertices[k]).point);
    if (chart.facts().orientation == Orientation::against_the_cross_product)
      std::swap(corners[1], corners[2]);
    out.mesh.triangles.push_back(corners);
    out.mesh.group.push_back(0);
    out.mesh.face.push_back(triangle.chart);
    out.piece.push_back(pieces[triangle.chart]);
  }
  return out;
}

FactorMesh factor_mesh(const MeshSurvey& survey) {
  expects(survey.components.has_value() && survey.planes.has_value(), "a mesh without degenerate triangles");
  FactorMesh out{.mesh = survey.mesh,
                 .piece = survey.components->of_piece,
                 .piece_names = survey.pieces,
                 .pieces_bend = false};
  if (survey.front.orientation == Orientation::against_the_cross_product)
    for (VertexTriple& triangle : out.mesh.triangles) std::swap(triangle[1], triangle[2]);
  std::vector<std::optional<std::size_t>> plane(survey.pieces.size());
  for (std::size_t t = 0; t < out.piece.size(); ++t) {
    std::optional<std::size_t>& first = plane[out.piece[t]];
    const std::size_t mine = survey.planes->of_triangle[t];
    if (!first) first = mine;
    out.pieces_bend = out.pieces_bend || *first != mine;
  }
  return out;
}

FactorUnits factor_units(const FactorMesh& mesh, FactorUnit unit) {
  FactorUnits out;
  if (unit == FactorUnit::piece) {
    out = {mesh.piece, mesh.piece_names};
  } else if (unit == FactorUnit::group) {
    // Only groups that have triangles, in the order in which triangles show them.
    std::map<std::size_t, std::size_t> numbers;
    for (const std::size_t group : mesh.mesh.group) {
      const auto [at, fresh] = numbers.emplace(group, out.names.size());
      const std::string& name = mesh.mesh.group_names[group];
      if (fresh) out.names.push_back(name.empty() ? "ungrouped" : name);
      out.of_triangle.push_back(at->second);
    }
  } else {
    std::vector<std::size_t> count(mesh.piece_names.size(), 0);
    for (std::size_t t = 0; t < mesh.piece.size(); ++t) {
      out.of_triangle.push_back(t);
      out.names.push_back(mesh.piece_names[mesh.piece[t]] + "/" + std::to_string(++count[mesh.piece[t]]));
    }
  }
  return out;
}

}  // namespace radcert
