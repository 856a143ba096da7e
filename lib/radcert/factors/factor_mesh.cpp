// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/factor_mesh.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/scalar/ball.h"
#include "radcert/surface/affine_image.h"
#include "radcert/surface/chart_pieces.h"
#include "radcert/surface/exact_chart.h"
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

/// Of all charts, or nothing where the exact formula of one is not known.
std::optional<std::vector<AffineImage>> affine_images(const Surface& surface) {
  std::vector<AffineImage> out;
  for (const Chart& chart : surface.charts) {
    expects(chart.facts().plane.has_value(), "plane charts", named("chart", chart.facts().name));
    const ExactImage* formula = chart.is_known_in_balls() ? exact_image(chart.in<Ball>()) : nullptr;
    const std::optional<AffineImage> image =
        formula == nullptr ? std::nullopt : affine_image(formula->image());
    if (!image) return std::nullopt;
    out.push_back(*image);
  }
  return out;
}

/// See factor_mesh.
Rational unit_of(const std::vector<AffineImage>& images) {
  Rational multiple = 1;
  for (const AffineImage& image : images)
    for (const Vector<Rational>& v : {image.origin, image.first, image.second})
      for (const Rational& x : {v.x, v.y, v.z}) {
        Rational odd = (multiple * x).denominator();
        while ((odd / 2).denominator() == Rational(1)) odd = odd / 2;
        multiple = multiple * odd;
      }
  Rational unit = 1 / multiple;
  while (unit * 2 <= Rational(1)) unit = unit * 2;
  return unit;
}

/// The vertices of a mesh at the corners of a surface's triangles.
class CornerList {
public:
  CornerList(const Surface& surface, const std::vector<AffineImage>* images, const Rational& unit,
             std::vector<Vector<double>>& vertices)
      : surface_(surface), images_(images), scale_(1 / unit), vertices_(vertices) {}

  std::size_t number(std::size_t chart, const ParameterPoint<double>& at) {
    // Most corners are those of several triangles.
    if (chart != chart_) numbers_.clear();
    chart_ = chart;
    const auto [place, fresh] = numbers_.emplace(std::pair(at.s, at.t), 0);
    if (fresh) place->second = vertices_.number(point(at));
    return place->second;
  }
  /// Whether no corner was rounded.
  [[nodiscard]] bool exact() const { return exact_; }

private:
  Vector<double> point(const ParameterPoint<double>& at) {
    if (images_ == nullptr) {
      exact_ = false;
      return surface_.charts[chart_].in<double>().frame(at).point;
    }
    const AffineImage& image = (*images_)[chart_];
    const Vector<Rational> p = scale_ * (image.origin + Rational::exactly(at.s) * image.first +
                                         Rational::exactly(at.t) * image.second);
    return {nearest(p.x), nearest(p.y), nearest(p.z)};
  }
  double nearest(const Rational& x) {
    const double rounded = x.to_double();
    exact_ = exact_ && std::isfinite(rounded) && Rational::exactly(rounded) == x;
    return rounded;
  }

  const Surface& surface_;
  const std::vector<AffineImage>* images_;
  Rational scale_;
  VertexList vertices_;
  std::size_t chart_ = 0;
  std::map<std::pair<double, double>, std::size_t> numbers_;  ///< of the vertices of one chart
  bool exact_ = true;
};

FactorMesh mesh_in(const Rational& unit, const Surface& surface, const Triangulation& triangulation,
                   const std::vector<AffineImage>* images) {
  FactorMesh out;
  out.unit = unit;
  out.piece_names = surface.piece_names();
  out.mesh.group_names = {""};
  CornerList list(surface, images, unit, out.mesh.vertices);
  const std::vector<std::size_t> pieces = chart_pieces(surface);
  for (const ParameterTriangle& triangle : triangulation.triangles) {
    const Chart& chart = surface.charts[triangle.chart];
    VertexTriple corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = list.number(triangle.chart, triangle.vertices[k]);
    if (chart.facts().orientation == Orientation::against_the_cross_product)
      std::swap(corners[1], corners[2]);
    out.mesh.triangles.push_back(corners);
    out.mesh.group.push_back(0);
    out.mesh.face.push_back(triangle.chart);
    out.piece.push_back(pieces[triangle.chart]);
  }
  out.exact = list.exact();
  return out;
}

}  // namespace

FactorMesh factor_mesh(const Surface& surface, int level) {
  const Triangulation triangulation = triangulate(surface, level);
  const std::optional<std::vector<AffineImage>> images = affine_images(surface);
  if (!images) return mesh_in(1, surface, triangulation, nullptr);
  const Rational unit = unit_of(*images);
  FactorMesh out = mesh_in(unit, surface, triangulation, &*images);
  return out.exact || unit == Rational(1) ? out : mesh_in(1, surface, triangulation, &*images);
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
