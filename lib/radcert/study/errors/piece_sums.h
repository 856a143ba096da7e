// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/core/parallel.h"
#include "radcert/study/computed_function.h"
#include "radcert/surface/chart_pieces.h"

namespace radcert {

/// The elements of u_n on all ranks.
[[nodiscard]] inline std::size_t all_elements(const ComputedFunction& u_n) {
  const auto add = [&](std::span<double> count) {
    count[0] += static_cast<double>(u_n.triangulation.triangles.size());
  };
  return static_cast<std::size_t>(u_n.ranks.carried({0}, add)[0]);
}

/// Sums over the elements of each piece, on all ranks.
/// Maths     sum of of_element(value, k) over the elements k of a piece, value a function (k, x) -> u_n
/// Requires  of_element gives an array of numbers, and may be called by several threads
/// Result    a row a piece of the surface, in its order; elements are added one by one in the order of all of
///           them, so that the bits are the same for any number of threads and ranks
template <std::size_t N>
[[nodiscard]] std::vector<std::array<double, N>> piece_sums(const ComputedFunction& u_n,
                                                            const auto& of_element) {
  const std::size_t count = u_n.triangulation.triangles.size();
  std::vector<std::array<double, N>> by_element(count);
  parallel_for(count, [&](std::size_t begin, std::size_t end) {
    const auto value = u_n.evaluator();
    for (std::size_t k = begin; k < end; ++k) by_element[k] = of_element(value, k);
  });
  const std::vector<std::size_t> piece_of_chart = chart_pieces(u_n.surface);
  const std::size_t pieces = u_n.surface.piece_names().size();
  const auto add_elements = [&](std::span<double> sums) {
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t piece = piece_of_chart[u_n.triangulation.triangles[k].chart];
      for (std::size_t i = 0; i < N; ++i) sums[piece * N + i] += by_element[k][i];
    }
  };
  const std::vector<double> sums = u_n.ranks.carried(std::vector<double>(pieces * N), add_elements);
  std::vector<std::array<double, N>> by_piece(pieces);
  for (std::size_t i = 0; i < sums.size(); ++i) by_piece[i / N][i % N] = sums[i];
  return by_piece;
}

}  // namespace radcert
