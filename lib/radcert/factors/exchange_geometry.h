// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "radcert/factors/facet_scene.h"

namespace radcert {

/// An occluder as far as it can stand between a receiver and a source.
struct Screen {
  FacetCorners corners;  ///< convex, counterclockwise as seen from its front
  Vector<double> normal;
  std::size_t solid = 0;    ///< as ConvexOccluder has it
  bool is_of_body = false;  ///< only its front hides anything
  /// The screen beyond the side from each corner to the next: of the same body or plane, with the same ends.
  std::vector<std::optional<std::size_t>> beyond_side;
};

/// A receiver, a source, and what may stand between them.
/// Maths     screens: occluders cut off at the planes of receiver and source. A point Q of the source is
///           hidden from P of the receiver where the segment from P to Q crosses a screen: what lies behind
///           either plane meets no such segment
/// Requires  receiver and source wholly in front of each other's planes, rounding apart; unit normals
/// Result    (p - origin) / unit for each corner p, origin a corner of the receiver and unit a power of two
///           near the largest distance: within 2^-53 of its length, but for corners that a plane cuts off.
///           Heights above either plane within some roundings of the largest distance count as none
struct ExchangeGeometry {
  FacetCorners receiver;
  FacetCorners source;
  Vector<double> receiver_normal;
  Vector<double> origin;
  double unit = 1;
  std::vector<Screen> screens;
};

/// A polygon with its unit normal, which a sliver's own corners do not give in doubles.
struct OrientedPolygon {
  FacetCorners corners;
  Vector<double> unit_normal;
};

/// The geometry of two polygons of a scene and of those of its facets that may stand between them.
/// Requires  as ExchangeGeometry; `occluders` are places in scene.occluders()
[[nodiscard]] ExchangeGeometry exchange_geometry(const FacetScene& scene, const OrientedPolygon& receiver,
                                                 const OrientedPolygon& source,
                                                 const std::vector<std::size_t>& occluders);

/// Lambert's flux of a polygon as seen from `at`.
/// Maths     Int cos dw = -1/2 sum of gamma m . n over the sides, gamma the angle of a side and m the unit
///           normal of its plane through the point, out of the pyramid
/// Source    Lambert, Photometria
/// Requires  a polygon in front of the point's plane, counterclockwise as seen from the point; a unit normal
/// Result    right to some roundings of 1
[[nodiscard]] double polygon_flux(const FacetCorners& polygon, const Vector<double>& at,
                                  const Vector<double>& unit_normal);

/// The parts of a source that points see past screens; its memory is used again from point to point.
/// Maths     f(P): polygon_flux of what is left of the source when for each screen the part in the pyramid
///           from P over it is taken away, convex piece by convex piece
/// Source    polygon_flux
/// Requires  the geometry outlives it
/// Result    right to some 1e-15, however the pieces fall
/// Limits    belongs to one thread
class SourceViewer {
public:
  explicit SourceViewer(const ExchangeGeometry& geometry) : geometry_(geometry) {}
  [[nodiscard]] double flux(const Vector<double>& at, const std::vector<std::size_t>& screens);

private:
  /// A convex polygon whose corners are kept as differences from the point of view.
  using Piece = std::vector<Vector<double>>;

  Piece& next_place();
  void subtract(const Screen& screen, const Vector<double>& at);
  [[nodiscard]] bool lies_beside(const Piece& piece) const;
  void cut_off(const Vector<double>& normal);

  const ExchangeGeometry& geometry_;
  std::vector<Piece> pieces_;
  std::vector<Piece> before_;
  std::size_t count_ = 0;
  std::vector<Vector<double>> rays_;
  std::vector<Vector<double>> normals_;  ///< of the planes through P and the screen's sides, inwards
  std::vector<double> heights_;
  Piece rest_;
  Piece inside_;
  Piece outside_;
};

}  // namespace radcert
