// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "radcert/factors/exchange_geometry.h"

namespace radcert {

/// A triangle of a receiver.
using ReceiverCell = std::array<Vector<double>, 3>;

/// A line of the receiver at which what is seen of the source changes its kind.
struct EventLine {
  Vector<double> normal;  ///< the line is where normal . (P - at) = 0
  Vector<double> at;
  double change = 0;  ///< see CellSight
};

/// Facts that hold at all points of a cell.
struct CellSight {
  std::vector<std::size_t> screens;  ///< all that may hide something
  bool hidden = false;               ///< nothing is seen: one screen or body hides the source from each point
  std::vector<EventLine> lines;
  /// Bounds by how much the flux may differ from the analytic function that it is at one point of the cell.
  double change = 0;
  double unoccluded = 0;  ///< the largest flux at the corners and the centre without screens
};

/// Where on a receiver the view of a source past screens may change its kind.
/// Maths     From P the border of what is seen consists of parts of sides of the source and of screens, its
///           corners are corners of either or crossings of two sides. So f(P) is analytic but where three
///           sides meet in one direction: where a corner passes over a side, det(V - P, A - P, B - P) = 0,
///           which is linear in P; where three sides of different solids cross, det(m_1, m_2, m_3) = 0 with
///           m_i = (A_i - P) x (B_i - P), a cubic; and where P passes through the plane of a screen that cuts
///           the source. Past such an event f goes on as another analytic function: the difference is the
///           flux of the small triangle that the three planes through P form, `change` its largest value at
///           the cell's corners and centre
/// Source    the events of visibility: Plantinga & Dyer, Visibility, occlusion, and the aspect graph, 1990;
///           Durand's visibility skeleton, 1997
/// Requires  the geometry outlives it; cells on the receiver
/// Result    of(cell, screens): no event of those screens is left out that lies inside the cell, up to
///           rounding. A linear form keeps its sign on the cell if it does at the corners; a cubic does if
///           its Bernstein coefficients have one sign. Left out are sides that are not over the source from
///           any point of the cell, sides between two faces that both look at it or neither, pairs of sides
///           that do not cross, and events in the inside of the picture that a solid has from all points:
///           there nothing is seen, whatever stands before or behind. screens: those whose picture no side of
///           it or of the source parts from that of the source, for all P at once
/// Limits    other events that cannot be seen count as well. Where lines alone come to the whole flux, the
///           rest is not looked for
class SightEvents {
public:
  explicit SightEvents(const ExchangeGeometry& geometry) : geometry_(geometry) {}
  [[nodiscard]] CellSight of(const ReceiverCell& cell, const std::vector<std::size_t>& screens);

private:
  static constexpr std::size_t of_source = static_cast<std::size_t>(-1);
  /// Signs at the corners of the cell: none, one, or both.
  enum Sign : unsigned { none = 0, positive = 1, negative = 2, both = 3 };
  struct Corner {
    Vector<double> at{};
    std::array<Vector<double>, 4> ray;
    std::array<double, 4> distance{};
    std::size_t solid = of_source;
    bool apart = false;  ///< not over the source, or hidden
    std::vector<std::size_t> sides{};
  };
  struct Side {
    std::size_t from = 0;  ///< corners
    std::size_t to = 0;
    std::size_t solid = of_source;
    bool hidden = false;
    std::array<Vector<double>, 4> normal{};
  };

  void add_corners_of_source();
  std::size_t corner_at(const Vector<double>& at, std::size_t solid);
  void add_side(std::size_t from, std::size_t to, std::size_t solid);
  [[nodiscard]] Sign sign(const Side& side, const Corner& corner) const;
  [[nodiscard]] Sign sign(std::size_t side, std::size_t corner);
  [[nodiscard]] bool keeps_facing(std::size_t solid) const;
  [[nodiscard]] bool list_screens(const std::vector<std::size_t>& screens, CellSight& out);
  void find_sides(const CellSight& listed);
  [[nodiscard]] bool body_hides() const;
  void drop_sides_apart();
  void mark_hidden();
  void find_lines(CellSight& out);
  void find_curves(CellSight& out);
  [[nodiscard]] bool passes_within(const Corner& corner, const Side& side) const;
  [[nodiscard]] bool may_cross(std::size_t one, std::size_t other);
  [[nodiscard]] bool may_meet(const Side& one, const Side& two, const Side& three) const;
  [[nodiscard]] double change(const Side& one, const Side& two, const Side& three, double most) const;

  const ExchangeGeometry& geometry_;
  std::array<Vector<double>, 4> cell_;  ///< its corners, which decide signs, and its centre
  std::vector<Corner> corners_;         ///< first those of the source
  std::vector<Side> sides_;
  std::vector<Sign> facing_;          ///< of the listed screens towards the cell's corners
  std::vector<std::size_t> turning_;  ///< solids of which a face's plane passes through the cell
  std::vector<unsigned char> signs_;  ///< of sides and corners, once asked for
};

}  // namespace radcert
