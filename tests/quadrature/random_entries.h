// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/surface/surface.h"
#include "radcert/surface/surface_point.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// A stream of random numbers that is the same with every standard library.
class Stream {
public:
  explicit Stream(std::uint64_t seed) : bits_(seed) {}
  double uniform() { return static_cast<double>(bits_() >> 11U) * 0x1p-53; }
  std::size_t index(std::size_t count) { return bits_() % count; }
  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[index(from.size())];
  }

private:
  std::mt19937_64 bits_;
};

/// How the observer's element lies to the element that is integrated over.
enum class Place {
  own,            ///< the same element, on a curved chart
  edge,           ///< they share an edge, on the same or another chart
  edge_at_angle,  ///< they share an edge between two pieces
  vertex,         ///< they share one vertex
  apart,          ///< they share nothing
};

/// One row and one element of a collocation matrix.
struct Case {
  const Surface* surface;
  int level;
  int degree;
  double inset;
  std::size_t node;
  std::size_t observer_element;
  SurfacePoint<double> observer;
  std::size_t element_index;
  ParameterTriangle element;
  ParameterTriangle observers_triangle;

  /// Node i of the observer's element.
  SurfacePoint<double> node_of_observers_element(const InsetBasis<double>& basis, std::size_t i) const {
    return {observers_triangle.chart, observers_triangle.at(basis.nodes()[i].x)};
  }

  std::string text() const {
    std::string parameters;
    for (const SurfaceParameter& parameter : surface->parameters)
      parameters += " " + parameter.name + "=" + parameter.value.to_text();
    return surface->name + parameters + ", level " + std::to_string(level) + ", degree " +
           std::to_string(degree) + ", inset " + description(inset) + ", node " + std::to_string(node) +
           " of element " + std::to_string(observer_element) + " seen from element " +
           std::to_string(element_index);
  }
};

/// A triangulation that knows which elements touch.
class TouchingElements {
public:
  TouchingElements(const Surface& surface, int level)
      : surface_(&surface), level_(level), triangles_(triangulate(surface, level).triangles) {
    using Key = std::array<long, 3>;
    std::map<Key, std::vector<std::size_t>> at_vertex;
    for (std::size_t k = 0; k < triangles_.size(); ++k)
      for (const ParameterPoint<double>& v : triangles_[k].vertices) {
        const Vector<double> p = surface.charts[triangles_[k].chart].in<double>().frame(v).point;
        at_vertex[{std::lround(1e9 * p.x), std::lround(1e9 * p.y), std::lround(1e9 * p.z)}].push_back(k);
      }
    shared_.resize(triangles_.size());
    for (const auto& [point, elements] : at_vertex)
      for (const std::size_t a : elements)
        for (const std::size_t b : elements) ++shared_[a][b];
  }

  /// A random case of that kind, or nothing if this draw met none.
  std::optional<Case> draw(Place place, int degree, double inset, Stream& stream) const {
    const std::size_t k = stream.index(triangles_.size());
    std::vector<std::size_t> candidates;
    const auto consider = [&](std::size_t other) {
      if (!in_one_plane(chart(k), chart(other))) candidates.push_back(other);
    };
    if (place == Place::own) consider(k);
    for (const auto& [other, vertices] : shared_[k]) {
      const bool same_piece = chart(k).facts().piece == chart(other).facts().piece;
      if (place == Place::edge && vertices == 2) consider(other);
      if (place == Place::edge_at_angle && vertices == 2 && !same_piece) consider(other);
      if (place == Place::vertex && vertices == 1) consider(other);
    }
    if (place == Place::apart) {
      const std::size_t other = stream.index(triangles_.size());
      if (!shared_[k].contains(other)) consider(other);
    }
    if (candidates.empty()) return std::nullopt;
    const std::size_t other = stream.pick(candidates);
    const std::size_t nodes = InsetBasis<double>(degree, inset).size();
    return at(degree, inset, stream.index(nodes), k, other);
  }

  Case at(int degree, double inset, std::size_t node, std::size_t observer_element,
          std::size_t element) const {
    const ParameterTriangle& from = triangles_[observer_element];
    const InsetBasis<double> basis(degree, inset);
    return Case{surface_,
                level_,
                degree,
                inset,
                node,
                observer_element,
                {from.chart, from.at(basis.nodes()[node].x)},
                element,
                triangles_[element],
                from};
  }

private:
  const Chart& chart(std::size_t element) const { return surface_->charts[triangles_[element].chart]; }

  const Surface* surface_;
  int level_;
  std::vector<ParameterTriangle> triangles_;
  std::vector<std::map<std::size_t, int>> shared_;  ///< [a][b]: how many vertices a and b have in common
};

}  // namespace radcert
