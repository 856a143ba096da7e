// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/collocation/certified/exchanged_corners.h"

#include <algorithm>
#include <array>

#include "radcert/polynomial/nodes/lattice.h"

namespace radcert {
namespace {

Matrix<double> in_order(const Matrix<double>& from, std::span<const std::size_t> place) {
  Matrix<double> to = Matrix<double>::uninitialised(from.rows(), from.columns());
  for (std::size_t j = 0; j < place.size(); ++j)
    for (std::size_t i = 0; i < place.size(); ++i) to(i, j) = from(place[i], place[j]);
  return to;
}

/// Whether f(x1,x3,x2) = g(x1,x2,x3), by their Bernstein coefficients.
bool are_exchanged(std::span<const Rational> f, std::span<const Rational> g, int degree) {
  const auto lattice = lattice_indices(degree);
  return std::all_of(lattice.begin(), lattice.end(), [&](const std::array<int, 3>& k) {
    return f[lattice_place({k[0], k[2], k[1]})] == g[lattice_place(k)];
  });
}

}  // namespace

std::optional<std::vector<std::size_t>> places_when_exchanged(const LagrangeFunctions& functions) {
  const std::vector<Barycentric<Rational>>& nodes = functions.nodes();
  std::vector<std::size_t> places;
  for (const Barycentric<Rational>& node : nodes) {
    const auto found = std::find_if(nodes.begin(), nodes.end(), [&](const Barycentric<Rational>& other) {
      return other.x[0] == node.x[0] && other.x[1] == node.x[2] && other.x[2] == node.x[1];
    });
    if (found == nodes.end()) return std::nullopt;
    places.push_back(static_cast<std::size_t>(found - nodes.begin()));
  }
  for (std::size_t j = 0; j < places.size(); ++j)
    if (!are_exchanged(functions.bernstein_coefficients(j), functions.bernstein_coefficients(places[j]),
                       functions.degree()))
      return std::nullopt;
  return places;
}

CertifiedEntries reordered(const CertifiedEntries& matrix, const std::vector<bool>& is_exchanged,
                           std::span<const std::size_t> exchanged) {
  const std::size_t p = exchanged.size();
  std::vector<std::size_t> place(is_exchanged.size() * p);
  for (std::size_t k = 0; k < is_exchanged.size(); ++k)
    for (std::size_t j = 0; j < p; ++j) place[k * p + j] = k * p + (is_exchanged[k] ? exchanged[j] : j);
  return {.entries = in_order(matrix.entries, place), .radius = in_order(matrix.radius, place)};
}

}  // namespace radcert
