// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/occlusion/sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "radcert/certificate/gauss_rule.h"
#include "radcert/scalar/ball.h"

namespace radcert::certificate {

const WorkLimit most_seen_parts("certificate/sight: parts of faces that are seen in part", 20000, 0,
                                "parts that are not looked into count as seen in any share");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A number that is enclosed.
struct Between {
  double least = 0;
  double largest = 0;
};

/// More than the rounding of a quotient or a sum r; quotients may lose what is below the normal numbers.
double rounding(double r) { return std::abs(r) * 0x1p-52 + 1e-290; }

/// A sum that is exact where a term is 0.
double sum_below(double a, double b) {
  if (a == 0) return b;
  if (b == 0) return a;
  const double r = a + b;
  return r - rounding(r);
}
double sum_above(double a, double b) { return -sum_below(-a, -b); }

/// g/d from below, d >= 0, exactly 0 where g is; where d = 0 that of what is next to it.
double quotient_below(double g, double d) {
  if (d == 0) return g >= 0 ? infinity : -infinity;
  if (g == 0) return 0;
  const double r = g / d;
  if (std::isinf(r)) return r > 0 ? std::numeric_limits<double>::max() : r;
  return r - rounding(r);
}

/// A height at exact parameters; exactly 0 where its terms are.
Between height_at(const Scene::Heights& heights, double s, double t) {
  BoundedDouble sum = heights.of_a;
  if (s != 0 && t != 1 && !certainly_zero(heights.along))
    sum = sum + BoundedDouble::exactly(s) * (BoundedDouble(1) - BoundedDouble::exactly(t)) * heights.along;
  if (t != 0 && !certainly_zero(heights.inward)) sum = sum + BoundedDouble::exactly(t) * heights.inward;
  return {sum_below(sum.value(), -sum.error()), sum_above(sum.value(), sum.error())};
}

std::array<std::pair<double, double>, 4> corner_parameters(const Box& box) {
  return {std::pair(box.s0, box.t0), {box.s1, box.t0}, {box.s1, box.t1}, {box.s0, box.t1}};
}

/// The largest height of the corners of a box, and of no less than 0.
double highest(const Scene::Heights& heights, const Box& box) {
  double most = 0;
  for (const auto& [s, t] : corner_parameters(box)) most = std::max(most, height_at(heights, s, t).largest);
  return most;
}

}  // namespace

/// |d| and g_e at points of one face.
class Sight::Corners {
public:
  Corners(const Sight& sight, std::size_t screen, std::size_t face)
      : sight_(&sight), screen_(&sight.screens_[screen]), face_(face) {}

  void put(std::size_t triangle, double s, double t) {
    from_plane_.emplace_back();
    beyond_.resize(beyond_.size() + screen_->sides);
    put(from_plane_.size() - 1, triangle, s, t);
  }
  void put(std::size_t triangle, const Box& box) {
    const auto corners = corner_parameters(box);
    from_plane_.resize(corners.size());
    beyond_.resize(corners.size() * screen_->sides);
    for (std::size_t p = 0; p < corners.size(); ++p) put(p, triangle, corners[p].first, corners[p].second);
  }

  /// At most g_e/|d| at any of the points, and at least.
  [[nodiscard]] double least_slope(std::size_t side) const {
    double least = infinity;
    for (std::size_t p = 0; p < from_plane_.size(); ++p) {
      const double g = beyond_[p * screen_->sides + side].least;
      least = std::min(least, quotient_below(g, g >= 0 ? from_plane_[p].largest : from_plane_[p].least));
    }
    return least;
  }
  [[nodiscard]] double largest_slope(std::size_t side) const {
    double least = infinity;
    for (std::size_t p = 0; p < from_plane_.size(); ++p) {
      const double g = -beyond_[p * screen_->sides + side].largest;
      least = std::min(least, quotient_below(g, g >= 0 ? from_plane_[p].largest : from_plane_[p].least));
    }
    return -least;
  }
  /// Both for each side.
  [[nodiscard]] std::vector<Slopes> slopes() const {
    std::vector<Slopes> out;
    for (std::size_t e = 0; e < screen_->sides; ++e) out.push_back({least_slope(e), largest_slope(e)});
    return out;
  }

private:
  void put(std::size_t point, std::size_t triangle, double s, double t) {
    const Signs& over = sight_->over(face_, screen_->face);
    const std::size_t sides = screen_->sides;
    Between d = height_at(sight_->scene_.heights(triangle, screen_->face), s, t);
    if (over.least < 0) d = {-d.largest, -d.least};
    from_plane_[point] = {std::max(0.0, d.least), std::max(0.0, d.largest)};
    for (std::size_t e = 0; e < sides; ++e) {
      Between g = height_at(screen_->beyond[triangle * sides + e], s, t);
      const Signs& signs = screen_->signs[face_ * sides + e];
      if (signs.least >= 0) g.least = std::max(g.least, 0.0);
      if (signs.largest <= 0) g.largest = std::min(g.largest, 0.0);
      beyond_[point * sides + e] = g;
    }
  }

  const Sight* sight_;
  const Screen* screen_;
  std::size_t face_;
  std::vector<Between> from_plane_;
  std::vector<Between> beyond_;  ///< by point, side
};

Sight::Sight(const PolyhedronCertificate& certificate, const Scene& scene)
    : certificate_(certificate), scene_(scene), of_face_(scene.faces()) {
  for (std::size_t e = 0; e < certificate.elements.size(); ++e)
    of_face_[certificate.elements[e].face].push_back(e);
  const std::vector<Face>& faces = certificate.faces;
  for (const Face& plane : faces) {
    const Vector<Rational> normal = normal_of(plane);
    for (const Face& face : faces) {
      Signs signs;
      for (const Vector<Rational>& p : face.corners) {
        const auto sign = static_cast<signed char>(dot(normal, p - plane.corners[0]).sign());
        signs.least = std::min(signs.least, sign);
        signs.largest = std::max(signs.largest, sign);
      }
      over_.push_back(signs);
    }
  }
  put_screens();
  put_pairs();
}

void Sight::put_screens() {
  const std::vector<Face>& faces = certificate_.faces;
  for (std::size_t b = 0; b < faces.size(); ++b) {
    bool has_behind = false;
    for (std::size_t f = 0; f < faces.size(); ++f) has_behind = has_behind || over(f, b).least < 0;
    if (!has_behind) continue;
    const std::vector<Vector<Rational>>& corners = faces[b].corners;
    const Vector<Rational> normal = normal_of(faces[b]);
    Screen screen{.face = b, .sides = corners.size(), .beyond = {}, .signs = {}};
    std::vector<Vector<Rational>> outward;
    std::vector<Ball> sizes;
    for (std::size_t e = 0; e < corners.size(); ++e) {
      outward.push_back(cross(corners[(e + 1) % corners.size()] - corners[e], normal));
      sizes.push_back(sqrt(Ball(dot(outward[e], outward[e]))) * power(Ball(2), scene_.exponent()));
    }
    for (const Face& face : faces) {
      Vector<Rational> sum;
      for (const Vector<Rational>& p : face.corners) sum = sum + p;
      const Vector<Rational> centre = Rational(1, static_cast<long>(face.corners.size())) * sum;
      std::vector<Signs> signs(corners.size());
      for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const Vector<Rational>& a = face.corners[i];
        const Vector<Rational>& next = face.corners[(i + 1) % face.corners.size()];
        for (std::size_t e = 0; e < corners.size(); ++e) {
          const auto along = [&](const Vector<Rational>& v) {
            return bounded(Ball(dot(outward[e], v)) / sizes[e]);
          };
          screen.beyond.push_back({along(a - corners[e]), along(next - a), along(centre - a)});
          const auto sign = static_cast<signed char>(dot(outward[e], a - corners[e]).sign());
          signs[e].least = std::min(signs[e].least, sign);
          signs[e].largest = std::max(signs[e].largest, sign);
        }
      }
      screen.signs.insert(screen.signs.end(), signs.begin(), signs.end());
    }
    screens_.push_back(std::move(screen));
  }
}

void Sight::put_pairs() {
  if (is_open()) return;
  const std::size_t faces = scene_.faces();
  pairs_.resize(faces * faces);
  for (std::size_t i = 0; i < faces; ++i)
    for (std::size_t j = 0; j < faces; ++j) {
      if (!face_each_other(i, j)) continue;
      Pair& pair = pairs_[i * faces + j];
      for (std::size_t s = 0; s < screens_.size() && !pair.is_hidden; ++s) {
        const Signs& of_i = over(i, screens_[s].face);
        const Signs& of_j = over(j, screens_[s].face);
        const bool is_before = of_i.largest > 0 && of_j.least < 0;
        if (!is_before && !(of_i.least < 0 && of_j.largest > 0)) continue;
        const Hides found = hides(corners_of_face(s, i).slopes(), corners_of_face(s, j));
        if (found == Hides::all) pair.is_hidden = true;
        if (found == Hides::something) (is_before ? pair.before : pair.behind).push_back(s);
      }
    }
}

Sight::Corners Sight::corners_of_face(std::size_t screen, std::size_t face) const {
  Corners out(*this, screen, face);
  const std::size_t first = scene_.triangle(face, 0);
  for (std::size_t k = 0; k < scene_.triangles_of(face); ++k) out.put(first + k, 0, 0);
  return out;
}

Sight::Hides Sight::hides(const std::vector<Slopes>& from, const Corners& to) {
  bool hides_all = true;
  for (std::size_t e = 0; e < from.size(); ++e) {
    if (-from[e].least <= to.least_slope(e)) return Hides::nothing;
    hides_all = hides_all && to.largest_slope(e) <= -from[e].largest;
  }
  return hides_all ? Hides::all : Hides::something;
}

/// From one box to one other face.
class Sight::Look {
public:
  Look(const Sight& sight, std::size_t triangle, const Box& box, std::size_t other)
      : sight_(sight), pair_(sight.pair(sight.scene_.triangles()[triangle].face, other)) {
    const std::size_t own = sight.scene_.triangles()[triangle].face;
    for (const std::vector<std::size_t>* screens : {&pair_.before, &pair_.behind})
      for (const std::size_t s : *screens) {
        Corners corners(sight, s, own);
        corners.put(triangle, box);
        from_.push_back(corners.slopes());
        to_.emplace_back(sight, s, other);
      }
  }

  /// What is hidden of a part from all points of the box.
  [[nodiscard]] Hides at(std::size_t triangle, const Box& part) {
    return hidden([&](std::size_t k, std::size_t) { to_[k].put(triangle, part); });
  }
  [[nodiscard]] Hides at_face(std::size_t face) {
    return hidden([&](std::size_t k, std::size_t screen) { to_[k] = sight_.corners_of_face(screen, face); });
  }

private:
  /// Puts what is looked at for a screen where that is asked for.
  template <class Put>
  [[nodiscard]] Hides hidden(const Put& put) {
    Hides out = Hides::nothing;
    for (std::size_t k = 0; k < to_.size(); ++k) {
      const bool is_before = k < pair_.before.size();
      // Those behind alone matter where they hide all.
      if (k == pair_.before.size() && out == Hides::nothing) return out;
      const std::size_t screen = is_before ? pair_.before[k] : pair_.behind[k - pair_.before.size()];
      put(k, screen);
      const Hides own = hides(from_[k], to_[k]);
      if (own == Hides::all) return own;
      if (is_before && own == Hides::something) out = own;
    }
    return out;
  }

  const Sight& sight_;
  const Pair& pair_;
  std::vector<std::vector<Slopes>> from_;  ///< by screen before, then behind
  std::vector<Corners> to_;
};

Seen Sight::seen(std::size_t triangle, const Box& box, const SourcePart& part) const {
  const Element& x = certificate_.elements[part.element];
  const std::size_t own = scene_.triangles()[triangle].face;
  if (!face_each_other(own, x.face)) return Seen::none;
  if (is_open()) return Seen::whole;
  if (pair(own, x.face).is_hidden) return Seen::none;
  if (pair(own, x.face).before.empty()) return Seen::whole;
  switch (Look(*this, triangle, box, x.face).at(scene_.triangle(x.face, x.side), part.box)) {
    case Hides::nothing: return Seen::whole;
    case Hides::all: return Seen::none;
    case Hides::something: break;
  }
  return Seen::partly;
}

View Sight::view(std::size_t triangle, const Box& box, double least_mass) const {
  View out;
  const std::size_t own = scene_.triangles()[triangle].face;
  const SideTriangle& frame = scene_.triangles()[triangle];
  std::array<Vector<double>, 4> corners;
  Vector<double> centre;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [s, t] = corner_parameters(box)[k];
    corners[k] = frame.point(s, t);
    centre = centre + 0.25 * corners[k];
  }
  double radius = 0;
  for (const Vector<double>& p : corners) radius = std::max(radius, norm(p - centre));
  radius = radius * upward + slack;
  const std::size_t most = most_seen_parts.count();
  std::size_t count = 0;
  for (std::size_t j = 0; j < scene_.faces(); ++j) {
    if (!face_each_other(own, j)) continue;
    if (is_open() || (!pair(own, j).is_hidden && pair(own, j).before.empty())) {
      out.faces.push_back({.face = j});
      continue;
    }
    if (pair(own, j).is_hidden) continue;
    Look look(*this, triangle, box, j);
    const Hides of_face = look.at_face(j);
    if (of_face == Hides::all) continue;
    if (of_face == Hides::nothing) {
      out.faces.push_back({.face = j});
      continue;
    }
    View::OfFace seen{.face = j, .is_whole = false};
    std::vector<SourcePart> parts;
    for (const std::size_t e : of_face_[j]) {
      const Element& x = certificate_.elements[e];
      parts.push_back({e, {.s0 = x.s0, .s1 = x.s1, .t0 = x.t0, .t1 = x.t1}});
    }
    const double height = highest(scene_.heights(triangle, j), box);
    while (!parts.empty()) {
      const SourcePart part = parts.back();
      parts.pop_back();
      const std::size_t place = scene_.triangle(j, certificate_.elements[part.element].side);
      const Hides found = look.at(place, part.box);
      if (found == Hides::all) continue;
      if (found == Hides::nothing) {
        seen.parts.push_back(part);
        continue;
      }
      const SideTriangle& side = scene_.triangles()[place];
      const Box& b = part.box;
      const double distance = Quadrilateral(side, scene_.normal(j), b).distance(centre) - radius;
      const double area = side.jacobian * (b.s1 - b.s0) * (b.t1 - b.t0) * (1 - b.middle_t()) * upward;
      double mass = 1;
      if (distance > 0) {
        const double cosines = std::min(1.0, height / distance) *
                               std::min(1.0, highest(scene_.heights(place, own), b) / distance);
        mass = std::min(1.0, std::numbers::inv_pi * area * cosines / (distance * distance) * upward);
      }
      const double half_s = 0.5 * (b.s1 - b.s0) * (1 - b.t0) * side.length;
      const double half_t =
          0.5 * (b.t1 - b.t0) *
          std::max(norm(side.inward - b.s0 * side.along), norm(side.inward - b.s1 * side.along));
      if (mass <= least_mass || std::max(half_s, half_t) <= 0.5 * radius || ++count > most) {
        out.shaded.push_back({part, mass});
        continue;
      }
      SourcePart lower = part;
      SourcePart upper = part;
      if (half_s >= half_t)
        lower.box.s1 = upper.box.s0 = b.middle_s();
      else
        lower.box.t1 = upper.box.t0 = b.middle_t();
      parts.push_back(lower);
      parts.push_back(upper);
    }
    if (!seen.parts.empty()) out.faces.push_back(std::move(seen));
  }
  return out;
}

}  // namespace radcert::certificate
