// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/contacts/mesh_contacts.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/contacts/joined_sides.h"
#include "radcert/geometry/contacts/mesh_bodies.h"
#include "radcert/geometry/contacts/place.h"
#include "radcert/geometry/mesh_defects.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_classes.h"
#include "radcert/geometry/winding/ray_crossings.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

using Number = CGAL::Gmpq;
using Kernel = CGAL::Simple_cartesian<Number>;
using Point = Kernel::Point_2;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::Exact_intersections_tag>;

/// A plane of the mesh and its projection along an axis that it is not parallel to.
class Plane {
public:
  explicit Plane(const std::array<Vector<double>, 3>& corners) {
    const Vector<Rational> a = exactly(corners[0]);
    normal_ = cross(exactly(corners[1]) - a, exactly(corners[2]) - a);
    offset_ = dot(normal_, a);
    const std::array<Rational, 3> size{abs(normal_.x), abs(normal_.y), abs(normal_.z)};
    axis_ = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  }

  [[nodiscard]] Point flat(const Vector<double>& v) const {
    const Place x{v.x, v.y, v.z};
    return {Number(x[(axis_ + 1) % 3]), Number(x[(axis_ + 2) % 3])};
  }
  [[nodiscard]] Point flat(const Vector<Rational>& v) const {
    const std::array<const Rational*, 3> x{&v.x, &v.y, &v.z};
    return {number(*x[(axis_ + 1) % 3]), number(*x[(axis_ + 2) % 3])};
  }
  /// The point of the plane over a point of the projection.
  [[nodiscard]] Vector<Rational> over(const Point& at) const {
    const std::array<Rational, 3> n{normal_.x, normal_.y, normal_.z};
    std::array<Rational, 3> x;
    x[(axis_ + 1) % 3] = rational(at.x());
    x[(axis_ + 2) % 3] = rational(at.y());
    x[axis_] = (offset_ - n[(axis_ + 1) % 3] * x[(axis_ + 1) % 3] - n[(axis_ + 2) % 3] * x[(axis_ + 2) % 3]) /
               n[axis_];
    return {x[0], x[1], x[2]};
  }
  /// The point of the plane over a point of the projection, rounded, and whether that is the point itself.
  struct Rounded {
    Vector<double> at;
    bool is_exact;
  };
  [[nodiscard]] Rounded point(const Point& at) const {
    const Vector<Rational> exact = over(at);
    const Vector<double> rounded{exact.x.to_double(), exact.y.to_double(), exact.z.to_double()};
    return {rounded, exactly(rounded) == exact};
  }
  /// Where a segment with its ends on both sides passes through the plane.
  [[nodiscard]] Vector<Rational> between(const Vector<double>& from, const Vector<double>& to) const {
    const Vector<Rational> a = exactly(from);
    const Vector<Rational> way = exactly(to) - a;
    return a + ((offset_ - dot(normal_, a)) / dot(normal_, way)) * way;
  }
  /// On which side of the plane a point lies: 1 on that of the normal, 0 on it.
  [[nodiscard]] int side(const Vector<double>& v) const {
    return (dot(normal_, exactly(v)) - offset_).sign();
  }
  /// Whether a triangle that runs counterclockwise in the projection does so about the normal.
  [[nodiscard]] bool keeps_order() const {
    return (axis_ == 0 ? normal_.x : axis_ == 1 ? normal_.y : normal_.z).sign() > 0;
  }
  /// An area in the plane over its projection's.
  [[nodiscard]] double stretch() const {
    const Rational& largest = axis_ == 0 ? normal_.x : axis_ == 1 ? normal_.y : normal_.z;
    return norm(Vector<double>{(normal_.x / largest).to_double(), (normal_.y / largest).to_double(),
                               (normal_.z / largest).to_double()});
  }

private:
  static Rational rational(const Number& x) { return Rational::from_gmp(x.mpq()); }
  static Number number(const Rational& x) { return Number(static_cast<mpq_srcptr>(x.gmp())); }

  Vector<Rational> normal_;
  Rational offset_;
  std::size_t axis_ = 0;
};

/// The triangles of both sides of a plane that overlap others, or that sides of others lie in.
struct Overlap {
  std::set<std::size_t> one;  ///< of the class with the smaller number
  std::set<std::size_t> other;
  std::set<std::pair<std::size_t, std::size_t>> lines;  ///< the ends of such sides
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  bool is_contact = true;
};

class Uncovering {
public:
  Uncovering(const TriangleMesh& mesh, bool right_hand) : given_(mesh), mesh_(mesh), right_hand_(right_hand) {
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) vertex_.emplace(place_of(mesh.vertices[v]), v);
    for (VertexTriple& triangle : mesh_.triangles)
      for (std::size_t& v : triangle) v = number(v);
    out_.mesh = mesh;
  }

  Outcome<UncoveredMesh> result() {
    constexpr std::size_t most_pairs = 1'000'000;
    const auto pairs = crossing_triangles(mesh_, most_pairs);
    if (pairs.empty() || pairs.size() == most_pairs) return std::move(out_);
    find_bodies();
    meeting_.resize(mesh_.triangles.size());
    for (const auto& [s, t] : pairs) {
      meeting_[s].push_back(t);
      meeting_[t].push_back(s);
    }
    std::vector<bool> replaced(mesh_.triangles.size(), false);
    bool any = false;
    std::map<Classes, Overlap> all = overlaps(pairs);
    if (const std::string reason = opening(all); !reason.empty()) return because(reason);
    add_lines(all, pairs);
    for (const auto& [classes, overlap] : all) {
      if (!overlap.is_contact) continue;
      const std::size_t before = out_.mesh.triangles.size();
      if (const std::string reason = uncover(overlap); !reason.empty()) {
        if (!overlap.pairs.empty()) return because(reason);
        // Of triangles that lose nothing: they stay, and the mesh is refused for what touches them.
        out_.mesh.triangles.resize(before);
        out_.mesh.group.resize(before);
        out_.mesh.face.resize(before);
        continue;
      }
      if (overlap.pairs.empty()) out_.cut += overlap.one.size();
      for (const auto* side : {&overlap.one, &overlap.other})
        for (const std::size_t t : *side) replaced[t] = true;
      any = true;
    }
    if (any) {
      leave_out(replaced);
      out_.mesh = joined_sides(std::move(out_.mesh)).mesh;
    }
    return std::move(out_);
  }

private:
  /// Bodies that stand side by side have vertices in common, and the faces of one may have vertices of their
  /// own: they are told apart by the vertices of the file, by places, and by places group by group.
  void find_bodies() {
    TriangleMesh by_group = mesh_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;
    by_group.vertices.clear();
    for (std::size_t t = 0; t < by_group.triangles.size(); ++t)
      for (std::size_t& v : by_group.triangles[t]) {
        const auto [found, is_new] = numbers.emplace(std::pair(mesh_.group[t], v), by_group.vertices.size());
        if (is_new) by_group.vertices.push_back(mesh_.vertices[v]);
        v = found->second;
      }
    bodies_ = {mesh_bodies(given_, right_hand_), mesh_bodies(mesh_, right_hand_),
               mesh_bodies(by_group, right_hand_)};
  }

  /// Whether one of two triangles belongs to a body and the other does not: by some way of telling bodies
  /// apart.
  bool is_contact(std::size_t s, std::size_t t) const {
    return std::any_of(bodies_.begin(), bodies_.end(), [&](const MeshBodies& by) {
      return by.component[s] != by.component[t] &&
             (by.is_body[by.component[s]] || by.is_body[by.component[t]]);
    });
  }

  bool are_of_bodies(std::size_t s, std::size_t t) const {
    return std::any_of(bodies_.begin(), bodies_.end(), [&](const MeshBodies& by) {
      return by.component[s] != by.component[t] && by.is_body[by.component[s]] && by.is_body[by.component[t]];
    });
  }

  /// Whether one of two triangles belongs to a body and the other to a room that holds all else.
  bool are_of_body_and_room(std::size_t s, std::size_t t) {
    for (std::size_t by = 0; by < bodies_.size(); ++by) {
      const std::size_t one = bodies_[by].component[s];
      const std::size_t other = bodies_[by].component[t];
      const std::vector<bool>& is_body = bodies_[by].is_body;
      if ((is_body[one] && is_room_of_all(by, other)) || (is_body[other] && is_room_of_all(by, one)))
        return true;
    }
    return false;
  }

  /// Whether a component is a room with all others inside, but for what lies on its walls.
  bool is_room_of_all(std::size_t by, std::size_t component) {
    const MeshBodies& bodies = bodies_[by];
    if (!bodies.is_room[component]) return false;
    const auto [known, is_new] = rooms_.emplace(std::pair(by, component), false);
    if (!is_new) return known->second;
    const RayCrossings walls(mesh_, triangles_of(bodies, component));
    std::set<std::size_t> inside;
    std::set<std::size_t> others;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (bodies.component[t] == component) continue;
      const Sides sides = sides_of(t, bodies, component, walls);
      if (sides.outside) return false;
      others.insert(bodies.component[t]);
      if (sides.inside) inside.insert(bodies.component[t]);
    }
    known->second = inside.size() == others.size();
    return known->second;
  }

  static std::vector<std::size_t> triangles_of(const MeshBodies& bodies, std::size_t component) {
    std::vector<std::size_t> own;
    for (std::size_t t = 0; t < bodies.component.size(); ++t)
      if (bodies.component[t] == component) own.push_back(t);
    return own;
  }

  /// Where a triangle has points off a closed component.
  struct Sides {
    bool inside = false;
    bool outside = false;
  };

  /// On which sides of a closed component a triangle of another has points.
  /// Maths     the segments in which the component's triangles meet this one cut it into parts; each lies on
  ///           the component, or does not meet it inside, so that one point tells
  Sides sides_of(std::size_t t, const MeshBodies& bodies, std::size_t component,
                 const RayCrossings& rays) const {
    Sides sides;
    const auto look = [&](const Vector<Rational>& point) {
      if (const auto crossings = rays.from(point))
        (winding_number(*crossings) != 0 ? sides.inside : sides.outside) = true;
    };
    const std::array<Vector<double>, 3> own = mesh_.corners(t);
    std::vector<std::size_t> cutting;
    for (const std::size_t s : meeting_[t])
      if (bodies.component[s] == component) cutting.push_back(s);
    if (cutting.empty()) {
      look(point_inside(own));
      return sides;
    }
    const Plane plane(own);
    Delaunay delaunay;
    const auto cut = [&](const Point& from, const Point& to) {
      if (from != to) delaunay.insert_constraint(from, to);
    };
    const std::array<Point, 3> corners{plane.flat(own[0]), plane.flat(own[1]), plane.flat(own[2])};
    for (std::size_t k = 0; k < 3; ++k) cut(corners[k], corners[(k + 1) % 3]);
    for (const std::size_t s : cutting) {
      const std::vector<Point> section = section_of(s, plane);
      for (std::size_t k = 1; k < section.size(); ++k) cut(section[k - 1], section[k]);
    }
    const auto turn = CGAL::orientation(corners[0], corners[1], corners[2]);
    for (const auto& face : delaunay.finite_face_handles()) {
      const Point middle =
          CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
      bool is_in_it = true;
      for (std::size_t k = 0; k < 3 && is_in_it; ++k)
        is_in_it = CGAL::orientation(corners[k], corners[(k + 1) % 3], middle) == turn;
      if (is_in_it) look(plane.over(middle));
    }
    return sides;
  }

  /// Where a triangle meets a plane: the ends of a segment, or its outline where it lies in the plane.
  std::vector<Point> section_of(std::size_t s, const Plane& plane) const {
    const std::array<Vector<double>, 3> c = mesh_.corners(s);
    const std::array<int, 3> side{plane.side(c[0]), plane.side(c[1]), plane.side(c[2])};
    std::vector<Point> out;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (side[k] == 0) out.push_back(plane.flat(c[k]));
      if (side[k] * side[next] < 0) out.push_back(plane.flat(plane.between(c[k], c[next])));
    }
    if (out.size() == 3) out.push_back(out.front());
    return out;
  }

  /// Whether anything lies beyond a triangle's plane, on the side that its front looks at.
  bool is_anything_before(std::size_t t) const {
    const auto c = mesh_.corners(t);
    const Vector<Rational> a = exactly(c[0]);
    const Vector<Rational> n = cross(exactly(c[1]) - a, exactly(c[2]) - a);
    const int front = right_hand_ ? 1 : -1;
    return std::any_of(mesh_.triangles.begin(), mesh_.triangles.end(), [&](const VertexTriple& triangle) {
      return std::any_of(triangle.begin(), triangle.end(), [&](std::size_t v) {
        return dot(n, exactly(mesh_.vertices[v]) - a).sign() == front;
      });
    });
  }

  /// A triangle that is not of a body and has points inside, if there is one.
  std::optional<std::size_t> content_of(const MeshBodies& bodies, std::size_t component,
                                        const BoxTree& boxes) const {
    const RayCrossings body(mesh_, triangles_of(bodies, component));
    std::optional<std::size_t> found;
    boxes.visit([&](const BoundingBox& box) { return !apart(box, body.box()); },
                [&](std::size_t t) {
                  if (bodies.component[t] != component && sides_of(t, bodies, component, body).inside)
                    found = t;
                  return !found;
                });
    return found;
  }

  struct FilledBody {
    std::size_t triangle;
    std::size_t content;  ///< a triangle inside
    bool crosses;         ///< the content meets the body's faces
  };

  /// A body that belongs to one of these sets and has something inside, if there is one.
  template <class IsIn>
  std::optional<FilledBody> filled_body(const IsIn& is_in) const {
    const BoxTree boxes(triangle_boxes(mesh_));
    std::set<std::vector<std::size_t>> known;
    for (const MeshBodies& bodies : bodies_) {
      std::set<std::size_t> components;
      for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
        const std::size_t component = bodies.component[t];
        if (!bodies.is_body[component] || !is_in(t) || !components.insert(component).second) continue;
        if (!known.insert(triangles_of(bodies, component)).second) continue;
        if (const auto content = content_of(bodies, component, boxes))
          return FilledBody{t, *content,
                            std::any_of(meeting_[*content].begin(), meeting_[*content].end(),
                                        [&](std::size_t s) { return bodies.component[s] == component; })};
      }
    }
    return std::nullopt;
  }

  using Classes = std::pair<std::size_t, std::size_t>;

  /// Why light would pass through bodies from which two faces were taken out; empty where it would not.
  /// Maths     what is covered within solids is out of reach. A face of a body that covers a part of an open
  ///           face opens the body, and all bodies whose covered faces it shares, to what lies on the other
  ///           side of that: beyond its own plane, before its front. A ray that comes through leaves again
  ///           through another such plane, since a line meets each once
  std::string opening(const std::map<Classes, Overlap>& all) {
    std::vector<std::size_t> parent(mesh_.triangles.size());
    for (std::size_t t = 0; t < parent.size(); ++t) parent[t] = t;
    const auto root = [&](std::size_t t) {
      while (parent[t] != t) t = parent[t] = parent[parent[t]];
      return t;
    };
    for (const MeshBodies& bodies : bodies_) {
      std::vector<std::optional<std::size_t>> first(bodies.is_body.size());
      for (std::size_t t = 0; t < parent.size(); ++t) {
        const std::size_t component = bodies.component[t];
        if (!bodies.is_body[component]) continue;
        if (first[component]) parent[root(t)] = root(*first[component]);
        first[component] = t;
      }
    }
    const auto is_of_a_body = [&](std::size_t t) {
      return std::any_of(bodies_.begin(), bodies_.end(),
                         [t](const MeshBodies& bodies) { return bodies.is_body[bodies.component[t]]; });
    };
    std::vector<std::pair<std::size_t, Classes>> opened;    // a triangle of a body, and the plane
    std::vector<std::pair<std::size_t, Classes>> on_walls;  // the same, of rooms that hold all else
    std::vector<std::size_t> touching;                      // triangles of bodies
    for (const auto& [classes, overlap] : all) {
      if (!overlap.is_contact) continue;
      std::array<std::optional<bool>, 2> is_before{};  // one face of each side looks out for all
      for (const auto& [s, t] : overlap.pairs) {
        for (const std::size_t own : {s, t})
          if (is_of_a_body(own)) touching.push_back(own);
        if (are_of_bodies(s, t)) {
          parent[root(s)] = root(t);
          continue;
        }
        for (const std::size_t own : {s, t}) {
          if (!is_of_a_body(own)) continue;
          std::optional<bool>& before = is_before.at(overlap.one.contains(own) ? 0 : 1);
          if (!before) before = is_anything_before(own);
          if (*before) (are_of_body_and_room(s, t) ? on_walls : opened).emplace_back(own, classes);
        }
      }
    }
    const auto name_of = [&](std::size_t triangle) {
      const std::string& name = mesh_.group_names[mesh_.group[triangle]];
      return "has a body" + (name.empty() ? std::string() : ", " + name + ",");
    };
    std::map<std::size_t, Classes> plane_of;
    for (const auto& [triangle, classes] : opened) plane_of.emplace(root(triangle), classes);
    for (const auto* faces : {&opened, &on_walls})
      for (const auto& [triangle, classes] : *faces)
        if (const auto known = plane_of.find(root(triangle));
            known != plane_of.end() && known->second != classes)
          return name_of(triangle) +
                 " that touches open faces in two planes: with what they cover taken out, light "
                 "would pass through it from one to the other; close these faces, or move them off";
    std::set<std::size_t> roots;
    for (const std::size_t t : touching) roots.insert(root(t));
    if (const auto found = filled_body([&](std::size_t t) { return roots.contains(root(t)); })) {
      const std::string& content = mesh_.group_names[mesh_.group[found->content]];
      return name_of(found->triangle) + " that touches others, or open faces, and has " +
             (found->crosses ? "a part of " : "") + (content.empty() ? "something" : content) +
             " inside, which would be seen through what they cover; move it off, or leave out what is "
             "inside" +
             (found->crosses
                  ? "; where rounding has made them cross, have repair align turn the room to the axes"
                  : "");
    }
    return {};
  }

  std::map<Classes, Overlap> overlaps(const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const {
    const PlaneClasses classes = plane_classes(mesh_);
    std::map<Classes, Overlap> out;
    for (const auto& [s, t] : pairs) {
      const std::size_t a = classes.of_triangle[s];
      const std::size_t b = classes.of_triangle[t];
      if (a == b || !is_opposite(s, t)) continue;
      Overlap& overlap = out[std::minmax(a, b)];
      (a < b ? overlap.one : overlap.other).insert(s);
      (a < b ? overlap.other : overlap.one).insert(t);
      overlap.pairs.emplace_back(s, t);
      overlap.is_contact = overlap.is_contact && is_contact(s, t);
    }
    return out;
  }

  /// Adds to each plane the sides of triangles that stand on it, a wall on a floor, with the triangles that
  /// they lie in.
  void add_lines(std::map<Classes, Overlap>& all,
                 const std::vector<std::pair<std::size_t, std::size_t>>& pairs) const {
    const PlaneClasses classes = plane_classes(mesh_);
    const auto add = [&](std::size_t in, std::size_t of) {
      const auto c = mesh_.corners(in);
      std::vector<std::size_t> on;
      for (const std::size_t v : mesh_.triangles[of])
        if (orientation(c[0], c[1], c[2], mesh_.vertices[v]) == 0) on.push_back(v);
      if (on.size() != 2 || !meets_inside(in, on[0], on[1])) return;
      const std::size_t own = classes.of_triangle[in];
      const auto known = std::find_if(all.begin(), all.end(), [&](const auto& one) {
        return one.second.is_contact && (one.first.first == own || one.first.second == own);
      });
      Overlap& overlap = known != all.end() ? known->second : all[{own, own}];
      const bool is_other = known != all.end() && known->first.first != own;
      (is_other ? overlap.other : overlap.one).insert(in);
      overlap.lines.insert(std::minmax(on[0], on[1]));
    };
    for (const auto& [s, t] : pairs) {
      add(s, t);
      add(t, s);
    }
  }

  /// Whether a segment of a triangle's plane meets its inside.
  /// Maths     two convex sets of a plane are apart, up to their borders, where a line along a side of one
  ///           parts them
  bool meets_inside(std::size_t triangle, std::size_t from, std::size_t to) const {
    const auto c = mesh_.corners(triangle);
    const Plane plane(c);
    const std::array<Point, 3> p{plane.flat(c[0]), plane.flat(c[1]), plane.flat(c[2])};
    const std::array<Point, 2> ends{plane.flat(mesh_.vertices[from]), plane.flat(mesh_.vertices[to])};
    const auto turn = CGAL::orientation(p[0], p[1], p[2]);
    for (std::size_t k = 0; k < 3; ++k)
      if (std::none_of(ends.begin(), ends.end(), [&](const Point& end) {
            return CGAL::orientation(p[k], p[(k + 1) % 3], end) == turn;
          }))
        return false;
    const auto has = [&](CGAL::Orientation side) {
      return std::any_of(p.begin(), p.end(), [&](const Point& corner) {
        return CGAL::orientation(ends[0], ends[1], corner) == side;
      });
    };
    return has(CGAL::LEFT_TURN) && has(CGAL::RIGHT_TURN);
  }

  /// Whether two triangles lie in one plane and look opposite ways.
  bool is_opposite(std::size_t s, std::size_t t) const {
    const auto of = [&](std::size_t k) {
      const auto c = mesh_.corners(k);
      return cross(exactly(c[1]) - exactly(c[0]), exactly(c[2]) - exactly(c[0]));
    };
    const Vector<Rational> n = of(s);
    if (dot(n, of(t)).sign() >= 0) return false;
    const Vector<Rational> a = exactly(mesh_.corners(s)[0]);
    for (const Vector<double>& corner : mesh_.corners(t))
      if (dot(n, exactly(corner) - a).sign() != 0) return false;
    return true;
  }

  /// The sides of triangles that are not sides of their neighbours in the same group.
  std::vector<std::pair<std::size_t, std::size_t>> outline(const std::set<std::size_t>& triangles) const {
    std::set<std::array<std::size_t, 3>> sides;  // group, from, to
    for (const std::size_t t : triangles)
      for (std::size_t k = 0; k < 3; ++k)
        sides.insert(
            {mesh_.group[t], number(mesh_.triangles[t][k]), number(mesh_.triangles[t][(k + 1) % 3])});
    std::vector<std::pair<std::size_t, std::size_t>> out;
    for (const auto& [group, from, to] : sides)
      if (!sides.contains({group, to, from})) out.emplace_back(from, to);
    return out;
  }

  /// The sum of the areas of triangles in the projection.
  Number flat_area(const std::set<std::size_t>& triangles, const Plane& plane) const {
    Number sum = 0;
    for (const std::size_t t : triangles) {
      const auto c = mesh_.corners(t);
      sum += CGAL::abs(CGAL::area(plane.flat(c[0]), plane.flat(c[1]), plane.flat(c[2])));
    }
    return sum;
  }

  std::size_t number(std::size_t vertex) const { return vertex_.at(place_of(mesh_.vertices[vertex])); }

  /// The triangle of a set that holds a point of the projection, if one does.
  std::optional<std::size_t> holder(const std::set<std::size_t>& triangles, const Plane& plane,
                                    const Point& at) const {
    for (const std::size_t t : triangles) {
      const auto c = mesh_.corners(t);
      const std::array<Point, 3> p{plane.flat(c[0]), plane.flat(c[1]), plane.flat(c[2])};
      const auto turn = CGAL::orientation(p[0], p[1], p[2]);
      bool inside = true;
      for (std::size_t k = 0; k < 3 && inside; ++k)
        inside = CGAL::orientation(p[k], p[(k + 1) % 3], at) != CGAL::opposite(turn);
      if (inside) return t;
    }
    return std::nullopt;
  }

  /// Adds what is left of both sides; says what stands in the way.
  std::string uncover(const Overlap& overlap) {
    const Plane plane(mesh_.corners(*overlap.one.begin()));
    Delaunay delaunay;
    for (const auto& [from, to] : overlap.lines)
      delaunay.insert_constraint(plane.flat(mesh_.vertices[from]), plane.flat(mesh_.vertices[to]));
    for (const auto* side : {&overlap.one, &overlap.other})
      for (const auto& [from, to] : outline(*side))
        delaunay.insert_constraint(plane.flat(mesh_.vertices[from]), plane.flat(mesh_.vertices[to]));
    std::map<std::pair<std::size_t, std::size_t>, double> covered;
    Number missing = flat_area(overlap.one, plane) + flat_area(overlap.other, plane);
    for (const auto& face : delaunay.finite_face_handles()) {
      const std::array<Point, 3> p{face->vertex(0)->point(), face->vertex(1)->point(),
                                   face->vertex(2)->point()};
      const std::optional<std::size_t> one = holder(overlap.one, plane, CGAL::centroid(p[0], p[1], p[2]));
      const std::optional<std::size_t> other = holder(overlap.other, plane, CGAL::centroid(p[0], p[1], p[2]));
      missing -= (one ? 1 : 0) * CGAL::abs(CGAL::area(p[0], p[1], p[2]));
      missing -= (other ? 1 : 0) * CGAL::abs(CGAL::area(p[0], p[1], p[2]));
      if (one && other) {
        covered[{mesh_.group[*one], mesh_.group[*other]}] +=
            plane.stretch() * std::abs(CGAL::to_double(CGAL::area(p[0], p[1], p[2])));
      } else if (one || other) {
        VertexTriple corners{};
        for (std::size_t k = 0; k < 3; ++k) {
          const Plane::Rounded corner = plane.point(p[k]);
          if (!corner.is_exact)
            return "has faces that touch" + names(overlap) +
                   ", and what they cover of each other has a corner near " + text(corner.at) +
                   " that no doubles hold exactly: cut the faces along each other's sides, or have "
                   "repair align turn the room to the axes";
          corners[k] = vertex(corner.at);
        }
        if (plane.keeps_order() != one.has_value()) std::swap(corners[1], corners[2]);
        add(corners, one ? *one : *other);
      }
    }
    // Of two triangles that look the same way only one would be left.
    if (missing != 0)
      return "has faces that overlap and look the same way" + names(overlap) + ", near " +
             text(mesh_.corners(*overlap.one.begin())[0]) + ", where others touch them: leave one out";
    for (const auto& [groups, area] : covered)
      out_.contacts.push_back({mesh_.group_names[groups.first], mesh_.group_names[groups.second], area});
    return {};
  }

  static std::string text(const Vector<double>& at) {
    const DecimalForm six = DecimalForm::general(6);
    return "(" + nearest_text(at.x, six) + ", " + nearest_text(at.y, six) + ", " + nearest_text(at.z, six) +
           ")";
  }

  /// The groups of an overlap, in brackets; nothing where none has a name.
  std::string names(const Overlap& overlap) const {
    std::set<std::string> groups;
    for (const auto* side : {&overlap.one, &overlap.other})
      for (const std::size_t t : *side) groups.insert(mesh_.group_names[mesh_.group[t]]);
    groups.erase("");
    std::string out;
    for (const std::string& group : groups) out += (out.empty() ? " (" : ", ") + group;
    return out.empty() ? out : out + ")";
  }

  std::size_t vertex(const Vector<double>& at) {
    const auto [found, is_new] = vertex_.emplace(place_of(at), out_.mesh.vertices.size());
    if (is_new) out_.mesh.vertices.push_back(at);
    return found->second;
  }

  void add(const VertexTriple& corners, std::size_t like) {
    out_.mesh.triangles.push_back(corners);
    out_.mesh.group.push_back(mesh_.group[like]);
    out_.mesh.face.push_back(mesh_.face[like]);
  }

  void leave_out(const std::vector<bool>& replaced) {
    TriangleMesh kept{.vertices = std::move(out_.mesh.vertices),
                      .triangles = {},
                      .group = {},
                      .group_names = out_.mesh.group_names,
                      .face = {}};
    for (std::size_t t = 0; t < out_.mesh.triangles.size(); ++t) {
      if (t < replaced.size() && replaced[t]) continue;
      kept.triangles.push_back(out_.mesh.triangles[t]);
      kept.group.push_back(out_.mesh.group[t]);
      kept.face.push_back(out_.mesh.face[t]);
    }
    // Vertices with equal coordinates are one; corners within what is covered belong to nothing any more.
    std::vector<std::size_t> renumbered(kept.vertices.size(), kept.vertices.size());
    std::vector<Vector<double>> used;
    for (VertexTriple& triangle : kept.triangles)
      for (std::size_t& v : triangle) {
        v = vertex_.at(place_of(kept.vertices[v]));
        if (renumbered[v] == kept.vertices.size()) {
          renumbered[v] = used.size();
          used.push_back(kept.vertices[v]);
        }
        v = renumbered[v];
      }
    kept.vertices = std::move(used);
    out_.mesh = std::move(kept);
  }

  const TriangleMesh& given_;
  TriangleMesh mesh_;  ///< with one number for vertices of equal coordinates
  bool right_hand_;
  std::vector<MeshBodies> bodies_;
  std::vector<std::vector<std::size_t>> meeting_;  ///< what each triangle meets in more than a side or vertex
  std::map<std::pair<std::size_t, std::size_t>, bool> rooms_;  ///< is_room_of_all
  std::map<Place, std::size_t> vertex_;                        ///< the first with these coordinates
  UncoveredMesh out_;
};

}  // namespace

Outcome<UncoveredMesh> without_contacts(const TriangleMesh& mesh, bool right_hand) {
  return Uncovering(mesh, right_hand).result();
}

}  // namespace radcert
