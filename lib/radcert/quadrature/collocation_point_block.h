// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "radcert/quadrature/collocation_point.h"
#include "radcert/scalar/pack.h"

namespace radcert {

/// Collocation points side by side, one a lane.
/// Maths     P_i and n_{P_i} for first <= i < first + count, all on one chart, and a ball about them
/// Result    lanes from `count` on repeat the last collocation point
template <Real R>
struct CollocationPointBlock {
  using B = typename Block<R>::Type;

  std::size_t first = 0;
  std::size_t count = 0;
  std::size_t chart = 0;
  Vector<B> point;
  Vector<B> normal;
  Vector<R> centre;
  R radius{};
  R extent{};  ///< the largest coordinate
};

/// Consecutive collocation points in blocks that do not straddle charts.
template <Real R>
std::vector<CollocationPointBlock<R>> observer_blocks(std::span<const CollocationPoint<R>> observers) {
  using std::abs;
  constexpr std::size_t lanes = Block<R>::lanes;
  std::vector<CollocationPointBlock<R>> blocks;
  for (std::size_t first = 0; first < observers.size();) {
    CollocationPointBlock<R> block;
    block.first = first;
    block.chart = observers[first].at.chart;
    while (block.count < lanes && first + block.count < observers.size() &&
           observers[first + block.count].at.chart == block.chart)
      ++block.count;
    for (std::size_t i = 0; i < lanes; ++i) {
      const CollocationPoint<R>& p = observers[first + std::min(i, block.count - 1)];
      Block<R>::set_lane(block.point.x, i, p.point.x);
      Block<R>::set_lane(block.point.y, i, p.point.y);
      Block<R>::set_lane(block.point.z, i, p.point.z);
      Block<R>::set_lane(block.normal.x, i, p.normal.x);
      Block<R>::set_lane(block.normal.y, i, p.normal.y);
      Block<R>::set_lane(block.normal.z, i, p.normal.z);
      block.centre = block.centre + p.point;
      block.extent = std::max({block.extent, abs(p.point.x), abs(p.point.y), abs(p.point.z)});
    }
    block.centre = (R(1) / R(static_cast<int>(lanes))) * block.centre;
    for (std::size_t i = 0; i < block.count; ++i)
      block.radius = std::max(block.radius, norm(observers[first + i].point - block.centre));
    blocks.push_back(block);
    first += block.count;
  }
  return blocks;
}

}  // namespace radcert
