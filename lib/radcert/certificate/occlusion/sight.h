// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/certificate/scene.h"
#include "radcert/core/work_limit.h"

namespace radcert::certificate {

extern const WorkLimit most_seen_parts;

/// A part of an element.
struct SourcePart {
  std::size_t element = 0;
  Box box;
};

/// A part of which points see any share, from nothing to all.
struct ShadedPart {
  SourcePart part;
  double mass = 0;  ///< at least T 1 of it, from any of the points
};

/// What all points of a box see of the faces before it: of what is not named they see nothing.
struct View {
  struct OfFace {
    std::size_t face = 0;
    bool is_whole = true;
    std::vector<SourcePart> parts = {};  ///< that are seen by all; of a whole face none are named
  };
  std::vector<OfFace> faces;
  std::vector<ShadedPart> shaded;
};

/// How much points see of a part: nothing, any share, all of it, but for null sets.
enum class Seen { none, partly, whole };

/// What points of faces see of other ones, where faces are the boundary of a body (solid_fault).
/// Maths     a screen is a face B with the unit normal n at a; d(x) = n.(x-a), and g_e(x) <= 0 on the inner
///           side of its side e. X and Y lie on different sides of its plane: the segment from p in X to q in
///           Y meets it where g_e is f_e(p,q)/(|d(p)|+|d(q)|), f_e(p,q) = |d(q)| g_e(p) + |d(p)| g_e(q). f_e
///           is affine in p and in q, so that its extremes over convex hulls are those at pairs of corners.
///             B hides nothing   where f_e >= 0 at all pairs, for some e
///             B hides all       where f_e <= 0 at all pairs, for all e
///           f_e/(|d(p)| |d(q)|) = g_e(p)/|d(p)| + g_e(q)/|d(q)|: with the least and the largest slope
///           g_e/|d| of either hull, f_e >= 0 where the least ones sum to 0 or more, f_e <= 0 where the
///           largest ones sum to 0 or less. Where d(p) = 0 the slope is infinite, of the sign of g_e(p), and
///           f_e is |d(q)| g_e(p). An infinite one outweighs any other where it is that of all corners of a
///           hull, which lies in the plane then
///           Y is seen by all of X where no screen with X before it and Y behind it hides anything: by
///           solid_fault the first face that a segment from X meets is met from its front. It is seen by none
///           where one screen hides all of it. Borders are null sets. What is neither is halved until its
///           mass is at most least_mass or it is half as large as the box; mass >= |Y| h_P h_Q/(pi r^4), h
///           the largest heights over each other's planes, r the least distance
/// Source    ours; PanelSight of the layer continuous bounds such slopes too, in doubles with one slack for
///           all, and no line of it is used here
/// Requires  surface_fault found nothing; all of it outlives this
/// Result    bounds are rounded outwards, exact signs taken where whole faces have them; what cannot be
///           decided is shaded
class Sight {
public:
  Sight(const PolyhedronCertificate& certificate, const Scene& scene);

  /// Whether every face sees all others: the surface is convex.
  [[nodiscard]] bool is_open() const { return screens_.empty(); }
  /// Whether each lies before the other, of two faces, in part at least.
  [[nodiscard]] bool face_each_other(std::size_t face, std::size_t other) const {
    return over(face, other).largest > 0 && over(other, face).largest > 0;
  }

  [[nodiscard]] View view(std::size_t triangle, const Box& box, double least_mass) const;
  /// How much all points of a box see of one part.
  [[nodiscard]] Seen seen(std::size_t triangle, const Box& box, const SourcePart& part) const;

private:
  /// The least and the largest sign at the corners of a face.
  struct Signs {
    signed char least = 1;
    signed char largest = -1;
  };
  struct Screen {
    std::size_t face = 0;
    std::size_t sides = 0;
    std::vector<Scene::Heights> beyond;  ///< g_e, by triangle, side
    std::vector<Signs> signs;            ///< of g_e, by face, side
  };
  /// Two faces: the screens that may hide something between them.
  struct Pair {
    bool is_hidden = false;
    std::vector<std::size_t> before;  ///< the first face lies before them
    std::vector<std::size_t> behind;
  };
  enum class Hides { nothing, something, all };
  /// Bounds of g_e/|d| over points.
  struct Slopes {
    double least = 0;
    double largest = 0;
  };
  class Corners;
  class Look;

  [[nodiscard]] const Signs& over(std::size_t face, std::size_t plane) const {
    return over_[plane * scene_.faces() + face];
  }
  [[nodiscard]] const Pair& pair(std::size_t face, std::size_t other) const {
    return pairs_[face * scene_.faces() + other];
  }
  void put_screens();
  void put_pairs();
  [[nodiscard]] Corners corners_of_face(std::size_t screen, std::size_t face) const;
  [[nodiscard]] static Hides hides(const std::vector<Slopes>& from, const Corners& to);

  const PolyhedronCertificate& certificate_;
  const Scene& scene_;
  std::vector<std::vector<std::size_t>> of_face_;  ///< elements
  std::vector<Signs> over_;                        ///< by plane, face
  std::vector<Screen> screens_;
  std::vector<Pair> pairs_;  ///< by face, face
};

}  // namespace radcert::certificate
