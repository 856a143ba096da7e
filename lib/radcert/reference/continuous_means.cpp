// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/continuous_means.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>

#include "radcert/certificate/certificate.h"
#include "radcert/certificate/densities.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/ball.h"

namespace radcert::reference {
namespace {

using Corners = std::vector<Vector<Rational>>;
using Polygons = std::vector<ScenePolygon>;

/// The sides of [0,a] x [0,b] x [0,c].
Polygons box_sides(long a, long b, long c) {
  const auto level = [=](long z) { return Corners{{0, 0, z}, {a, 0, z}, {a, b, z}, {0, b, z}}; };
  const auto across_x = [=](long x) { return Corners{{x, 0, 0}, {x, b, 0}, {x, b, c}, {x, 0, c}}; };
  const auto across_y = [=](long y) { return Corners{{0, y, 0}, {a, y, 0}, {a, y, c}, {0, y, c}}; };
  return {{"floor", level(0)},   {"ceiling", level(c)},  {"west", across_x(0)},
          {"east", across_x(a)}, {"south", across_y(0)}, {"north", across_y(b)}};
}

Polygons tetrahedron() {
  const Corners c{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  return {{"emitting", {c[1], c[2], c[3]}},
          {"other", {c[0], c[1], c[2]}},
          {"other_2", {c[0], c[1], c[3]}},
          {"other_3", {c[0], c[2], c[3]}}};
}

/// |x| + |y| + |z| <= 1, faces named by the signs in their octants.
Polygons octahedron() {
  Polygons out;
  for (const long x : {1, -1})
    for (const long y : {1, -1})
      for (const long z : {1, -1}) {
        const auto sign = [](long of) { return of > 0 ? '+' : '-'; };
        out.push_back({{sign(x), sign(y), sign(z)}, {{x, 0, 0}, {0, y, 0}, {0, 0, z}}});
      }
  return out;
}

/// Two unit squares at a right angle along [0,1] x {0} x {0}, and what closes them.
Polygons two_squares() {
  return {{"standing", {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}},
          {"lying", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
          {"opening", {{0, 0, 1}, {1, 0, 1}, {1, 1, 0}, {0, 1, 0}}},
          {"opening", {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}}},
          {"opening", {{1, 0, 0}, {1, 0, 1}, {1, 1, 0}}}};
}

/// A room around a corner: the unit cube between one of its neighbours in x and one in y.
Polygons l_room() {
  const auto wall = [](const std::string& name, long ax, long ay, long bx, long by) {
    return ScenePolygon{name, {{ax, ay, 0}, {bx, by, 0}, {bx, by, 1}, {ax, ay, 1}}};
  };
  Polygons out{wall("south", 0, 0, 2, 0),      wall("east", 2, 0, 2, 1),  wall("inner_south", 2, 1, 1, 1),
               wall("inner_east", 1, 1, 1, 2), wall("north", 1, 2, 0, 2), wall("west", 0, 2, 0, 0)};
  for (const auto& [name, z] : {std::pair("floor", 0L), std::pair("ceiling", 1L)}) {
    out.push_back({name, {{0, 0, z}, {2, 0, z}, {2, 1, z}, {0, 1, z}}});
    out.push_back({name, {{0, 1, z}, {1, 1, z}, {1, 2, z}, {0, 2, z}}});
  }
  return out;
}

/// [0,3]^3 about [1,2]^3: the space between them.
Polygons cube_in_a_cube() {
  Polygons out = box_sides(3, 3, 3);
  for (ScenePolygon side : box_sides(1, 1, 1)) {
    side.piece = "inner_" + side.piece;
    for (Vector<Rational>& corner : side.corners) corner = corner + Vector<Rational>{1, 1, 1};
    out.push_back(std::move(side));
  }
  return out;
}

/// rho = 1/2 + x/4 and E = z^2 on an ellipsoid with three different half axes.
EllipsoidScene ellipsoid_with_linear_rho() {
  return {.half_axes = {1, Rational(13, 10), Rational(17, 10)},
          .reflectivity = {{{0, 0, 0}, Rational(1, 2)}, {{1, 0, 0}, Rational(1, 4)}},
          .emission = {{{0, 0, 2}, 1}}};
}
const char* const ellipsoid_words = "the ellipsoid with the half axes 1, 1.3, 1.7, rho = 1/2 + x/4, E = z^2";

std::array<std::string, 2> files(const std::string& scene) {
  return {scene + "_fine.json", scene + "_coarse.json"};
}

std::vector<ContinuousScene> made_scenes() {
  const Rational half(1, 2);
  return {
      {.name = "cube_rho_1/2",
       .words = "the unit cube, rho = 1/2, the floor emits 1",
       .polygons = box_sides(1, 1, 1),
       .emitting = "floor",
       .reflectivity = half,
       .certificates = files("cube_rho_1_over_2")},
      {.name = "cube_centres_rho_1/2",
       .words = "the unit cube, rho = 1/2, the floor emits 1",
       .polygons = box_sides(1, 1, 1),
       .emitting = "floor",
       .reflectivity = half,
       .certificates = files("cube_centres_rho_1_over_2")},
      {.name = "cube_quartic_rho_2/5",
       .words = "the unit cube, rho = 2/5, E = (1 - z)^4",
       .polygons = box_sides(1, 1, 1),
       .offset = 1,
       .slope = {0, 0, -1},
       .power = 4,
       .reflectivity = Rational(2, 5),
       .certificates = files("cube_quartic_rho_2_over_5")},
      {.name = "cube_rho_9/10",
       .words = "the unit cube, rho = 9/10, the floor emits 1",
       .polygons = box_sides(1, 1, 1),
       .emitting = "floor",
       .reflectivity = Rational(9, 10),
       .certificates = files("cube_rho_9_over_10")},
      {.name = "box_1_2_3_rho_1/2",
       .words = "the box [0,1] x [0,2] x [0,3], rho = 1/2, the floor emits 1",
       .polygons = box_sides(1, 2, 3),
       .emitting = "floor",
       .reflectivity = half,
       .certificates = files("box_1_2_3_rho_1_over_2")},
      {.name = "tetrahedron_rho_1/2",
       .words = "the regular tetrahedron with corners in four of those of [-1,1]^3, rho = 1/2, the face "
                "opposite (1,1,1) emits 1",
       .polygons = tetrahedron(),
       .emitting = "emitting",
       .reflectivity = half,
       .certificates = files("tetrahedron_rho_1_over_2")},
      {.name = "octahedron_rho_1/2",
       .words = "the octahedron |x| + |y| + |z| <= 1, rho = 1/2, the face x, y, z >= 0 emits 1",
       .polygons = octahedron(),
       .emitting = "+++",
       .reflectivity = half,
       .certificates = files("octahedron_rho_1_over_2")},
      {.name = "two_squares_rho_1/2",
       .words = "two unit squares at a right angle along an edge, rho = 1/2, one of them emits 1",
       .polygons = two_squares(),
       .emitting = "standing",
       .black = "opening",
       .reflectivity = half,
       .certificates = files("two_squares_rho_1_over_2")},
      {.name = "l_room_rho_1/2",
       .words = "the room around a corner, three unit cubes side by side, rho = 1/2, the wall at the end of "
                "one arm emits 1",
       .polygons = l_room(),
       .emitting = "east",
       .reflectivity = half,
       .certificates = files("l_room_rho_1_over_2")},
      {.name = "cube_in_a_cube_rho_1/2",
       .words = "the cube [0,3]^3 about the cube [1,2]^3, rho = 1/2, the floor of the outer one emits 1",
       .polygons = cube_in_a_cube(),
       .emitting = "floor",
       .reflectivity = half,
       .certificates = files("cube_in_a_cube_rho_1_over_2")},
      {.name = "ellipsoid_linear_rho",
       .words = ellipsoid_words,
       .ellipsoid = ellipsoid_with_linear_rho(),
       .certificates = files("ellipsoid_mean")},
      {.name = "ellipsoid_linear_rho_values",
       .words = ellipsoid_words,
       .ellipsoid = ellipsoid_with_linear_rho(),
       .certificates = files("ellipsoid_values")}};
}

std::vector<ContinuousMean> made_means() {
  std::vector<ContinuousMean> out;
  const auto add = [&](const std::string& scene, const std::string& name, const std::string& of,
                       const std::string& piece) {
    const ContinuousScene* where = find_continuous_scene(scene);
    out.push_back(
        {.name = "continuous_mean_" + name,
         .summary = "mean over " + of + " of the solution of the continuous equation: " + where->words,
         .scene = scene,
         .piece = piece});
  };
  for (const std::string rho : {"rho_1/2", "rho_9/10"}) {
    add("cube_" + rho, "cube_floor_" + rho, "the floor", "floor");
    add("cube_" + rho, "cube_ceiling_" + rho, "the ceiling", "ceiling");
    add("cube_" + rho, "cube_wall_" + rho, "a wall", "west");
  }
  const auto add_centre = [&](const std::string& name, const std::string& of, const std::string& piece) {
    const std::string scene = "cube_centres_rho_1/2";
    out.push_back(
        {.name = "continuous_value_" + name,
         .summary = "value at the centre of " + of +
                    " of the solution of the continuous equation: " + find_continuous_scene(scene)->words,
         .scene = scene,
         .piece = piece,
         .at_centre = true});
  };
  add_centre("cube_floor_centre_rho_1/2", "the floor", "floor");
  add_centre("cube_ceiling_centre_rho_1/2", "the ceiling", "ceiling");
  add_centre("cube_wall_centre_rho_1/2", "a wall", "west");
  add("cube_quartic_rho_2/5", "cube_quartic_floor_rho_2/5", "the floor", "floor");
  add("cube_quartic_rho_2/5", "cube_quartic_ceiling_rho_2/5", "the ceiling", "ceiling");
  const std::string of_box = "box_1_2_3_rho_1/2";
  add(of_box, "box_1_2_3_floor_rho_1/2", "the floor", "floor");
  add(of_box, "box_1_2_3_ceiling_rho_1/2", "the ceiling", "ceiling");
  add(of_box, "box_1_2_3_wall_2_3_rho_1/2", "a wall of the sides 2 and 3", "west");
  add(of_box, "box_1_2_3_wall_1_3_rho_1/2", "a wall of the sides 1 and 3", "south");
  const std::string of_tetrahedron = "tetrahedron_rho_1/2";
  add(of_tetrahedron, "tetrahedron_emitting_face_rho_1/2", "the face that emits", "emitting");
  add(of_tetrahedron, "tetrahedron_other_face_rho_1/2", "a face that does not emit", "other");
  const std::string of_octahedron = "octahedron_rho_1/2";
  add(of_octahedron, "octahedron_emitting_face_rho_1/2", "the face that emits", "+++");
  add(of_octahedron, "octahedron_edge_neighbour_rho_1/2", "a face that shares an edge with it", "++-");
  add(of_octahedron, "octahedron_vertex_neighbour_rho_1/2", "a face that shares a vertex with it", "+--");
  add(of_octahedron, "octahedron_opposite_face_rho_1/2", "the face opposite to it", "---");
  const std::string of_squares = "two_squares_rho_1/2";
  add(of_squares, "two_squares_emitting_rho_1/2", "the square that emits", "standing");
  add(of_squares, "two_squares_other_rho_1/2", "the other square", "lying");
  const std::string of_room = "l_room_rho_1/2";
  add(of_room, "l_room_floor_rho_1/2", "the floor", "floor");
  add(of_room, "l_room_emitting_wall_rho_1/2", "the wall that emits", "east");
  add(of_room, "l_room_long_wall_beside_it_rho_1/2", "the long wall beside it", "south");
  add(of_room, "l_room_long_wall_opposite_rho_1/2", "the long wall opposite to it", "west");
  add(of_room, "l_room_wall_beside_it_rho_1/2", "the short wall beside it", "inner_south");
  add(of_room, "l_room_wall_behind_the_corner_rho_1/2", "the short wall behind the corner", "inner_east");
  add(of_room, "l_room_hidden_wall_rho_1/2", "the wall at the end of the other arm", "north");
  const std::string of_cubes = "cube_in_a_cube_rho_1/2";
  add(of_cubes, "cube_in_a_cube_floor_rho_1/2", "the floor", "floor");
  add(of_cubes, "cube_in_a_cube_ceiling_rho_1/2", "the ceiling", "ceiling");
  add(of_cubes, "cube_in_a_cube_wall_rho_1/2", "a wall", "west");
  add(of_cubes, "cube_in_a_cube_inner_floor_rho_1/2", "the inner cube's face towards the floor",
      "inner_floor");
  add(of_cubes, "cube_in_a_cube_inner_ceiling_rho_1/2", "the inner cube's face away from the floor",
      "inner_ceiling");
  add(of_cubes, "cube_in_a_cube_inner_wall_rho_1/2", "another face of the inner cube", "inner_west");
  add("ellipsoid_linear_rho", "ellipsoid_linear_rho", "the surface", {});
  const auto add_end = [&](const std::string& name, const std::string& of, const Vector<Rational>& point) {
    out.push_back({.name = "continuous_value_ellipsoid_linear_rho_" + name,
                   .summary = "value at the end of the " + of +
                              " of the solution of the continuous equation: " + ellipsoid_words,
                   .scene = "ellipsoid_linear_rho_values",
                   .point = point});
  };
  add_end("at_x", "half axis in x", {1, 0, 0});
  add_end("at_minus_x", "half axis in -x", {-1, 0, 0});
  add_end("at_y", "half axis in y", {0, Rational(13, 10), 0});
  add_end("at_z", "half axis in z", {0, 0, Rational(17, 10)});
  return out;
}

/// (constant + of_x x + of_y y)^power.
struct PowerOfLinear {
  Rational constant, of_x, of_y;
  std::size_t power = 1;

  /// Of x^i y^j: power!/(i! j! k!) of_x^i of_y^j constant^k, i + j + k = power.
  [[nodiscard]] Rational coefficient(std::size_t i, std::size_t j) const {
    if (i + j > power) return 0;
    Rational out = 1;
    const auto choose = [&out](const Rational& base, std::size_t count, std::size_t of) {
      for (std::size_t k = 0; k < count; ++k)
        out = out * base * Rational(static_cast<long>(of - k)) / Rational(static_cast<long>(k + 1));
    };
    choose(of_x, i, power);
    choose(of_y, j, power - i);
    choose(constant, power - i - j, power - i - j);
    return out;
  }
};

/// The cross products of the sides from the first corner on: twice the area of a plane polygon, along its
/// normal.
Vector<Rational> doubled_area(const Corners& corners) {
  Vector<Rational> sum;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum = sum + cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
  return sum;
}

/// Whether a point lies in a plane convex polygon, borders included.
bool contains(const Corners& polygon, const Vector<Rational>& point) {
  const Vector<Rational> normal = doubled_area(polygon);
  if (dot(normal, point - polygon[0]).sign() != 0) return false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vector<Rational> side = polygon[(k + 1) % polygon.size()] - polygon[k];
    if (dot(normal, cross(side, point - polygon[k])).sign() < 0) return false;
  }
  return true;
}

/// The polygon of the scene in which a convex face lies.
std::optional<std::size_t> polygon_of(const ContinuousScene& scene, const certificate::Face& face) {
  for (std::size_t k = 0; k < scene.polygons.size(); ++k) {
    const Corners& polygon = scene.polygons[k].corners;
    if (std::all_of(face.corners.begin(), face.corners.end(),
                    [&](const Vector<Rational>& corner) { return contains(polygon, corner); }))
      return k;
  }
  return std::nullopt;
}

/// The pieces of the certificate that a piece of the scene consists of.
Outcome<std::vector<std::size_t>> pieces_of(const ContinuousScene& scene,
                                            const certificate::PolyhedronCertificate& c,
                                            const std::string& piece) {
  std::vector<std::size_t> inside(c.pieces.size());
  std::vector<std::size_t> outside(c.pieces.size());
  for (const certificate::Face& face : c.faces) {
    const bool is_inside = scene.polygons[polygon_of(scene, face).value()].piece == piece;
    ++(is_inside ? inside : outside)[face.piece];
  }
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < c.pieces.size(); ++k) {
    if (inside[k] == 0) continue;
    if (outside[k] > 0) return because("the piece " + c.pieces[k] + " has faces in and out of " + piece);
    out.push_back(k);
  }
  if (out.empty()) return because("no face lies in " + piece);
  return out;
}

/// One certificate of a scene, checked.
struct Checked {
  certificate::Certificate certificate;
  std::string how;
};

std::string how_of(const certificate::PolyhedronCertificate& c, std::size_t looked_at) {
  return "functions of degree " + std::to_string(c.degree) + " on " + std::to_string(c.elements.size()) +
         " elements, " + std::to_string(looked_at) + " of which were checked now";
}
std::string how_of(const certificate::EllipsoidCertificate& c, std::size_t looked_at) {
  return "a polynomial of degree " + std::to_string(c.degree) + ", its residual checked now at " +
         std::to_string(looked_at) + " rows of points";
}

Outcome<Checked> checked(const ContinuousScene& scene, const std::string& file,
                         const CertificateReader& reader, std::size_t elements) {
  Checked out{.certificate = reader(certificate_content(file), file), .how = {}};
  const certificate::Certificate& c = out.certificate;
  if (const std::string fault = scene_fault(scene, c); !fault.empty()) return because(file + ": " + fault);
  const certificate::Report report = certificate::check(c, {.elements = elements, .seed = file});
  if (report.refusal) return because(file + ": " + report.refusal->pointer + ": " + report.refusal->says);
  out.how = "certificate " + file + ", " +
            std::visit([&](const auto& of) { return how_of(of, report.looked_at.size()); }, c);
  return out;
}

/// The point that is the centre of a piece of one polygon.
Outcome<std::size_t> point_of(const ContinuousScene& scene, const certificate::PolyhedronCertificate& c,
                              const std::string& piece) {
  const auto polygon = std::find_if(scene.polygons.begin(), scene.polygons.end(),
                                    [&](const ScenePolygon& each) { return each.piece == piece; });
  expects(polygon != scene.polygons.end(), "a piece of the scene", radcert::named("piece", piece));
  Vector<Rational> sum;
  for (const Vector<Rational>& corner : polygon->corners) sum = sum + corner;
  const Vector<Rational> centre = Rational(1, static_cast<long>(polygon->corners.size())) * sum;
  const auto found = std::find_if(c.points.begin(), c.points.end(),
                                  [&](const certificate::Point& point) { return point.at == centre; });
  if (found == c.points.end()) return because("it has no value at the centre of " + piece);
  return static_cast<std::size_t>(found - c.points.begin());
}

Ball ball_of(const certificate::Enclosure& found) {
  return widened(Ball(found.midpoint), Ball(found.radius));
}

/// The mean or value from a certificate of the scene.
Outcome<Ball> enclosed(const ContinuousScene& scene, const certificate::PolyhedronCertificate& c,
                       const ContinuousMean& mean) {
  if (c.of_values() != mean.at_centre)
    return because(std::string("the certificate is of ") + (mean.at_centre ? "means" : "values"));
  if (mean.at_centre) {
    const Outcome<std::size_t> point = point_of(scene, c, mean.piece);
    if (!point) return because(point.reason());
    return ball_of(c.enclosures[*point]);
  }
  const Outcome<std::vector<std::size_t>> pieces = pieces_of(scene, c, mean.piece);
  if (!pieces) return because(pieces.reason());
  if (pieces->size() == 1) return ball_of(c.enclosures[pieces->front()]);
  const std::vector<Ball> areas = certificate::piece_areas(c);
  Ball integral;
  Ball area;
  for (const std::size_t k : *pieces) {
    integral += areas[k] * ball_of(c.enclosures[k]);
    area += areas[k];
  }
  return integral / area;
}
Outcome<Ball> enclosed(const ContinuousScene&, const certificate::EllipsoidCertificate& c,
                       const ContinuousMean& mean) {
  if (c.of != (mean.point ? certificate::OnEllipsoid::values : certificate::OnEllipsoid::mean))
    return because(std::string("the certificate is not of ") + (mean.point ? "values" : "the mean"));
  if (!mean.point) return ball_of(c.enclosures[0]);
  const auto found = std::find(c.points.begin(), c.points.end(), *mean.point);
  if (found == c.points.end()) return because("it has no value at the point");
  return ball_of(c.enclosures[static_cast<std::size_t>(found - c.points.begin())]);
}

Outcome<RouteValue> value_of(const ContinuousScene& scene, const Checked& from, const ContinuousMean& mean) {
  const Outcome<Ball> value =
      std::visit([&](const auto& c) { return enclosed(scene, c, mean); }, from.certificate);
  if (!value) return because(mean.name + ": " + value.reason());
  return RouteValue{.how = from.how, .value = *value};
}

template <class List>
auto named(const List& list, std::string_view name) -> decltype(list.data()) {
  const auto found =
      std::find_if(list.begin(), list.end(), [name](const auto& entry) { return entry.name == name; });
  return found == list.end() ? nullptr : &*found;
}

}  // namespace

std::span<const ContinuousScene> continuous_scenes() {
  static const std::vector<ContinuousScene> all = made_scenes();
  return all;
}

std::span<const ContinuousMean> continuous_means() {
  static const std::vector<ContinuousMean> all = made_means();
  return all;
}

const ContinuousScene* find_continuous_scene(std::string_view name) {
  return named(continuous_scenes(), name);
}

const ContinuousMean* find_continuous_mean(std::string_view name) { return named(continuous_means(), name); }

std::string_view certificate_content(std::string_view file) {
  for (const EmbeddedFile& embedded : embedded_certificates())
    if (embedded.path == file) return embedded.content;
  expects(false, "a file of embedded_certificates", radcert::named("file", std::string(file)));
  return {};
}

namespace {

/// What the emission of the scene is on a face that emits, in the parameters of its first corners.
PowerOfLinear emission_on(const ContinuousScene& scene, const certificate::Face& face) {
  const Vector<Rational>& corner = face.corners[0];
  const auto rise = [&](std::size_t other) { return dot(scene.slope, face.corners[other] - corner); };
  return {.constant = scene.offset + dot(scene.slope, corner),
          .of_x = rise(1),
          .of_y = rise(2),
          .power = static_cast<std::size_t>(scene.power)};
}

bool has_emission(const certificate::Face& face, const std::optional<PowerOfLinear>& expected) {
  const std::size_t rows = std::max(expected ? expected->power + 1 : 0, face.emission.size());
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t columns = std::max(rows, i < face.emission.size() ? face.emission[i].size() : 0);
    for (std::size_t j = 0; j < columns; ++j) {
      const bool is_there = i < face.emission.size() && j < face.emission[i].size();
      const Rational wanted = expected ? expected->coefficient(i, j) : Rational(0);
      if (!((is_there ? face.emission[i][j] : Rational(0)) == wanted)) return false;
    }
  }
  return true;
}

std::string fault_of(const ContinuousScene& scene, const certificate::PolyhedronCertificate& c) {
  if (scene.ellipsoid) return "is of a polyhedron, and " + scene.name + " is an ellipsoid";
  // Of each polygon, in the unit of its own: twice the area that is left to be covered, times that of all.
  std::vector<Rational> bare;
  for (const ScenePolygon& polygon : scene.polygons)
    bare.push_back(dot(doubled_area(polygon.corners), doubled_area(polygon.corners)));
  for (const certificate::Face& face : c.faces) {
    const std::optional<std::size_t> place = polygon_of(scene, face);
    if (!place) return "has a face that is no part of " + scene.name;
    const ScenePolygon& polygon = scene.polygons[*place];
    const Rational area = dot(doubled_area(polygon.corners), doubled_area(face.corners));
    bare[*place] = bare[*place] - (area.sign() < 0 ? -area : area);
    const bool is_black = !scene.black.empty() && polygon.piece == scene.black;
    if (!face.varying_reflectivity.empty() ||
        !(face.reflectivity == (is_black ? Rational(0) : scene.reflectivity)))
      return "has another reflectivity than " + scene.name;
    const bool emits = scene.emitting.empty() || polygon.piece == scene.emitting;
    if (!has_emission(face, emits ? std::optional(emission_on(scene, face)) : std::nullopt))
      return "has another emission than " + scene.name;
  }
  for (std::size_t k = 0; k < bare.size(); ++k)
    if (bare[k].sign() != 0) return "has not all of " + scene.polygons[k].piece + " of " + scene.name;
  return {};
}

/// As exponents and coefficients that are not 0.
std::map<std::array<int, 3>, Rational> as_map(const std::vector<certificate::Monomial>& f) {
  std::map<std::array<int, 3>, Rational> out;
  for (const certificate::Monomial& monomial : f) out[monomial.powers] += monomial.coefficient;
  std::erase_if(out, [](const auto& term) { return term.second.sign() == 0; });
  return out;
}

std::string fault_of(const ContinuousScene& scene, const certificate::EllipsoidCertificate& c) {
  if (!scene.ellipsoid) return "is of an ellipsoid, and " + scene.name + " is none";
  if (!(c.half_axes == scene.ellipsoid->half_axes)) return "has not the half axes of " + scene.name;
  if (as_map(c.reflectivity) != as_map(scene.ellipsoid->reflectivity))
    return "has another reflectivity than " + scene.name;
  if (as_map(c.emission) != as_map(scene.ellipsoid->emission))
    return "has another emission than " + scene.name;
  return {};
}

}  // namespace

std::string scene_fault(const ContinuousScene& scene, const certificate::Certificate& c) {
  return std::visit([&](const auto& of_its_kind) { return fault_of(scene, of_its_kind); }, c);
}

Outcome<std::vector<EnclosedMean>> enclose(const ContinuousScene& scene, const CertificateReader& reader,
                                           std::size_t elements) {
  const Outcome<Checked> fine = checked(scene, scene.certificates[0], reader, elements);
  if (!fine) return because(fine.reason());
  const Outcome<Checked> coarse = checked(scene, scene.certificates[1], reader, elements);
  if (!coarse) return because(coarse.reason());
  std::vector<EnclosedMean> out;
  for (const ContinuousMean& mean : continuous_means()) {
    if (mean.scene != scene.name) continue;
    Outcome<RouteValue> first = value_of(scene, *fine, mean);
    if (!first) return because(first.reason());
    Outcome<RouteValue> second = value_of(scene, *coarse, mean);
    if (!second) return because(second.reason());
    if (!overlaps(first->value, second->value))
      throw std::logic_error(mean.name + ": two proofs contradict each other: " + first->value.to_text(20) +
                             " (" + first->how + "), " + second->value.to_text(20) + " (" + second->how +
                             ")");
    out.push_back({.mean = &mean, .first = *std::move(first), .second = *std::move(second)});
  }
  return out;
}

}  // namespace radcert::reference
