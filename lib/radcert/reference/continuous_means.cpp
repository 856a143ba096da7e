// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/reference/continuous_means.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>

#include "radcert/certificate/certificate.h"
#include "radcert/core/contract.h"
#include "radcert/scalar/ball.h"

namespace radcert::reference {
namespace {

using Corners = std::vector<Vector<Rational>>;

/// Those of [0,a] x [0,b] x [0,c].
struct Box {
  Rational a, b, c;
  [[nodiscard]] Corners all() const {
    return {{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {a, b, 0}, {0, 0, c}, {a, 0, c}, {0, b, c}, {a, b, c}};
  }
  [[nodiscard]] Corners floor() const { return {{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {a, b, 0}}; }
  [[nodiscard]] Corners ceiling() const { return {{0, 0, c}, {a, 0, c}, {0, b, c}, {a, b, c}}; }
  [[nodiscard]] Corners west() const { return {{0, 0, 0}, {0, b, 0}, {0, 0, c}, {0, b, c}}; }
  [[nodiscard]] Corners south() const { return {{0, 0, 0}, {a, 0, 0}, {0, 0, c}, {a, 0, c}}; }
};

const Corners tetrahedron_corners{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

const Corners octahedron_corners{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
/// The face of the octahedron in the octant with these signs.
Corners octant(int x, int y, int z) { return {{x, 0, 0}, {0, y, 0}, {0, 0, z}}; }

/// Two unit squares at a right angle along [0,1] x {0} x {0}.
struct TwoSquares {
  static Corners standing() { return {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}}; }
  static Corners lying() { return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}; }
  static Corners all() { return {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 0}, {1, 1, 0}}; }
  static std::vector<Corners> open() {
    return {{{0, 0, 1}, {1, 0, 1}, {0, 1, 0}, {1, 1, 0}},
            {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
            {{1, 0, 0}, {1, 0, 1}, {1, 1, 0}}};
  }
};

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
  const Box cube{1, 1, 1};
  const Box box{1, 2, 3};
  const Rational half(1, 2);
  return {{.name = "cube_rho_1/2",
           .words = "the unit cube, rho = 1/2, the floor emits 1",
           .corners = cube.all(),
           .emitting = cube.floor(),
           .reflectivity = half,
           .certificates = files("cube_rho_1_over_2")},
          {.name = "cube_centres_rho_1/2",
           .words = "the unit cube, rho = 1/2, the floor emits 1",
           .corners = cube.all(),
           .emitting = cube.floor(),
           .reflectivity = half,
           .certificates = files("cube_centres_rho_1_over_2")},
          {.name = "cube_quartic_rho_2/5",
           .words = "the unit cube, rho = 2/5, E = (1 - z)^4",
           .corners = cube.all(),
           .emitting = {},
           .offset = 1,
           .slope = {0, 0, -1},
           .power = 4,
           .reflectivity = Rational(2, 5),
           .certificates = files("cube_quartic_rho_2_over_5")},
          {.name = "cube_rho_9/10",
           .words = "the unit cube, rho = 9/10, the floor emits 1",
           .corners = cube.all(),
           .emitting = cube.floor(),
           .reflectivity = Rational(9, 10),
           .certificates = files("cube_rho_9_over_10")},
          {.name = "box_1_2_3_rho_1/2",
           .words = "the box [0,1] x [0,2] x [0,3], rho = 1/2, the floor emits 1",
           .corners = box.all(),
           .emitting = box.floor(),
           .reflectivity = half,
           .certificates = files("box_1_2_3_rho_1_over_2")},
          {.name = "tetrahedron_rho_1/2",
           .words = "the regular tetrahedron with corners in four of those of [-1,1]^3, rho = 1/2, the face "
                    "opposite (1,1,1) emits 1",
           .corners = tetrahedron_corners,
           .emitting = {tetrahedron_corners[1], tetrahedron_corners[2], tetrahedron_corners[3]},
           .reflectivity = half,
           .certificates = files("tetrahedron_rho_1_over_2")},
          {.name = "octahedron_rho_1/2",
           .words = "the octahedron |x| + |y| + |z| <= 1, rho = 1/2, the face x, y, z >= 0 emits 1",
           .corners = octahedron_corners,
           .emitting = octant(1, 1, 1),
           .reflectivity = half,
           .certificates = files("octahedron_rho_1_over_2")},
          {.name = "two_squares_rho_1/2",
           .words = "two unit squares at a right angle along an edge, rho = 1/2, one of them emits 1",
           .corners = TwoSquares::all(),
           .emitting = TwoSquares::standing(),
           .black = TwoSquares::open(),
           .reflectivity = half,
           .certificates = files("two_squares_rho_1_over_2")},
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
                       Corners face) {
    const ContinuousScene* where = find_continuous_scene(scene);
    out.push_back(
        {.name = "continuous_mean_" + name,
         .summary = "mean over " + of + " of the solution of the continuous equation: " + where->words,
         .scene = scene,
         .face = std::move(face)});
  };
  const Box cube{1, 1, 1};
  for (const std::string rho : {"rho_1/2", "rho_9/10"}) {
    add("cube_" + rho, "cube_floor_" + rho, "the floor", cube.floor());
    add("cube_" + rho, "cube_ceiling_" + rho, "the ceiling", cube.ceiling());
    add("cube_" + rho, "cube_wall_" + rho, "a wall", cube.west());
  }
  const auto add_centre = [&](const std::string& name, const std::string& of, Corners face) {
    const std::string scene = "cube_centres_rho_1/2";
    out.push_back(
        {.name = "continuous_value_" + name,
         .summary = "value at the centre of " + of +
                    " of the solution of the continuous equation: " + find_continuous_scene(scene)->words,
         .scene = scene,
         .face = std::move(face),
         .at_centre = true});
  };
  add_centre("cube_floor_centre_rho_1/2", "the floor", cube.floor());
  add_centre("cube_ceiling_centre_rho_1/2", "the ceiling", cube.ceiling());
  add_centre("cube_wall_centre_rho_1/2", "a wall", cube.west());
  add("cube_quartic_rho_2/5", "cube_quartic_floor_rho_2/5", "the floor", cube.floor());
  add("cube_quartic_rho_2/5", "cube_quartic_ceiling_rho_2/5", "the ceiling", cube.ceiling());
  const Box box{1, 2, 3};
  const std::string of_box = "box_1_2_3_rho_1/2";
  add(of_box, "box_1_2_3_floor_rho_1/2", "the floor", box.floor());
  add(of_box, "box_1_2_3_ceiling_rho_1/2", "the ceiling", box.ceiling());
  add(of_box, "box_1_2_3_wall_2_3_rho_1/2", "a wall of the sides 2 and 3", box.west());
  add(of_box, "box_1_2_3_wall_1_3_rho_1/2", "a wall of the sides 1 and 3", box.south());
  const std::string of_tetrahedron = "tetrahedron_rho_1/2";
  const Corners& t = tetrahedron_corners;
  add(of_tetrahedron, "tetrahedron_emitting_face_rho_1/2", "the face that emits", {t[1], t[2], t[3]});
  add(of_tetrahedron, "tetrahedron_other_face_rho_1/2", "a face that does not emit", {t[0], t[1], t[2]});
  const std::string of_octahedron = "octahedron_rho_1/2";
  add(of_octahedron, "octahedron_emitting_face_rho_1/2", "the face that emits", octant(1, 1, 1));
  add(of_octahedron, "octahedron_edge_neighbour_rho_1/2", "a face that shares an edge with it",
      octant(1, 1, -1));
  add(of_octahedron, "octahedron_vertex_neighbour_rho_1/2", "a face that shares a vertex with it",
      octant(1, -1, -1));
  add(of_octahedron, "octahedron_opposite_face_rho_1/2", "the face opposite to it", octant(-1, -1, -1));
  const std::string of_squares = "two_squares_rho_1/2";
  add(of_squares, "two_squares_emitting_rho_1/2", "the square that emits", TwoSquares::standing());
  add(of_squares, "two_squares_other_rho_1/2", "the other square", TwoSquares::lying());
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

bool is_before(const Vector<Rational>& p, const Vector<Rational>& q) {
  if (!(p.x == q.x)) return p.x < q.x;
  if (!(p.y == q.y)) return p.y < q.y;
  return p.z < q.z;
}

/// In an order of their own, each once.
Corners as_set(Corners corners) {
  std::sort(corners.begin(), corners.end(), is_before);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// The faces with these corners.
std::vector<std::size_t> faces_with(const certificate::PolyhedronCertificate& c, const Corners& corners) {
  const Corners wanted = as_set(corners);
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < c.faces.size(); ++k)
    if (as_set(c.faces[k].corners) == wanted) out.push_back(k);
  return out;
}

/// The piece that is the face with these corners and no other.
Outcome<std::size_t> piece_of(const certificate::PolyhedronCertificate& c, const Corners& corners) {
  const std::vector<std::size_t> faces = faces_with(c, corners);
  if (faces.size() != 1) return because("no face has the corners of the one that is asked for");
  const std::size_t piece = c.faces[faces[0]].piece;
  const auto alike = std::count_if(c.faces.begin(), c.faces.end(),
                                   [piece](const certificate::Face& face) { return face.piece == piece; });
  if (alike != 1) return because("the piece of the face has other faces");
  return piece;
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

/// The point that is the centre of the face with these corners.
Outcome<std::size_t> point_of(const certificate::PolyhedronCertificate& c, const Corners& corners) {
  Vector<Rational> sum;
  for (const Vector<Rational>& corner : corners) sum = sum + corner;
  const Vector<Rational> centre = Rational(1, static_cast<long>(corners.size())) * sum;
  const auto found = std::find_if(c.points.begin(), c.points.end(),
                                  [&](const certificate::Point& point) { return point.at == centre; });
  if (found == c.points.end()) return because("it has no value at the centre of the face");
  return static_cast<std::size_t>(found - c.points.begin());
}

/// The place of a mean or value among those of a certificate.
Outcome<std::size_t> place_of(const certificate::PolyhedronCertificate& c, const ContinuousMean& mean) {
  if (c.of_values() != mean.at_centre)
    return because(std::string("the certificate is of ") + (mean.at_centre ? "means" : "values"));
  return mean.at_centre ? point_of(c, mean.face) : piece_of(c, mean.face);
}
Outcome<std::size_t> place_of(const certificate::EllipsoidCertificate& c, const ContinuousMean& mean) {
  if (c.of != (mean.point ? certificate::OnEllipsoid::values : certificate::OnEllipsoid::mean))
    return because(std::string("the certificate is not of ") + (mean.point ? "values" : "the mean"));
  if (!mean.point) return std::size_t{0};
  const auto found = std::find(c.points.begin(), c.points.end(), *mean.point);
  if (found == c.points.end()) return because("it has no value at the point");
  return static_cast<std::size_t>(found - c.points.begin());
}

Outcome<RouteValue> value_of(const Checked& from, const ContinuousMean& mean) {
  return std::visit(
      [&](const auto& c) -> Outcome<RouteValue> {
        const Outcome<std::size_t> place = place_of(c, mean);
        if (!place) return because(mean.name + ": " + place.reason());
        const certificate::Enclosure& found = c.enclosures[*place];
        return RouteValue{.how = from.how, .value = widened(Ball(found.midpoint), Ball(found.radius))};
      },
      from.certificate);
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

std::string fault_of(const ContinuousScene& scene, const certificate::PolyhedronCertificate& c) {
  if (scene.ellipsoid) return "is of a polyhedron, and " + scene.name + " is an ellipsoid";
  Corners corners;
  for (const certificate::Face& face : c.faces)
    corners.insert(corners.end(), face.corners.begin(), face.corners.end());
  if (as_set(std::move(corners)) != as_set(scene.corners)) return "has not the corners of " + scene.name;
  const std::vector<std::size_t> emitting = faces_with(c, scene.emitting);
  if (!scene.emitting.empty() && emitting.size() != 1) return "has not the face that emits in " + scene.name;
  for (std::size_t k = 0; k < c.faces.size(); ++k) {
    const certificate::Face& face = c.faces[k];
    const bool is_black = std::any_of(scene.black.begin(), scene.black.end(), [&](const Corners& black) {
      return as_set(black) == as_set(face.corners);
    });
    if (!face.varying_reflectivity.empty() ||
        !(face.reflectivity == (is_black ? Rational(0) : scene.reflectivity)))
      return "has another reflectivity than " + scene.name;
    const bool emits = scene.emitting.empty() || k == emitting[0];
    const Vector<Rational>& corner = face.corners[0];
    const auto rise = [&](std::size_t other) { return dot(scene.slope, face.corners[other] - corner); };
    const PowerOfLinear expected{.constant = scene.offset + dot(scene.slope, corner),
                                 .of_x = rise(1),
                                 .of_y = rise(2),
                                 .power = emits ? static_cast<std::size_t>(scene.power) : 0};
    const std::size_t rows = std::max(expected.power + 1, face.emission.size());
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < rows; ++j) {
        const bool is_there = i < face.emission.size() && j < face.emission[i].size();
        const Rational wanted = emits ? expected.coefficient(i, j) : Rational(0);
        if (!((is_there ? face.emission[i][j] : Rational(0)) == wanted))
          return "has another emission than " + scene.name;
      }
  }
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
    Outcome<RouteValue> first = value_of(*fine, mean);
    if (!first) return because(first.reason());
    Outcome<RouteValue> second = value_of(*coarse, mean);
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
