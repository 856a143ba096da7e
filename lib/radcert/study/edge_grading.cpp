// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/edge_grading.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "radcert/closed_form/edge/corner_exponent.h"
#include "radcert/closed_form/edge/edge_exponents.h"
#include "radcert/core/errors.h"
#include "radcert/surface/exact_chart.h"

namespace radcert {
namespace {

using Point = Vector<Rational>;

[[noreturn]] void refuse(const std::string& problem, const std::string& allowed) {
  refuse_input("/triangulation/grading", "edges", problem, allowed);
}

/// A polynomial in s and t at a corner of the unit square.
std::optional<Rational> at_corner(const ExactFunction& f, bool s, bool t) {
  const std::optional<PowerQuotient> quotient = f.quotient();
  if (!quotient) return std::nullopt;
  const auto value = [&](const PowerSum& sum) {
    Rational total = 0;
    for (const auto& [exponents, coefficient] : sum)
      if ((s || exponents[0].sign() == 0) && (t || exponents[1].sign() == 0)) total += coefficient;
    return total;
  };
  const Rational denominator = value(quotient->denominator);
  if (denominator.sign() == 0) return std::nullopt;
  return value(quotient->numerator) / denominator;
}

/// A plane unit square of a surface, exactly.
struct Face {
  std::string piece;
  std::array<Point, 4> corners;  ///< in the order around it
  Point inwards;                 ///< its normal on the side of the light
};

Face face_of(const Chart& chart) {
  const ChartFacts& facts = chart.facts();
  const std::string allowed =
      "a surface of plane unit squares, as cube, box and two_squares, or a number >= 1";
  if (facts.domain != ChartDomain::unit_square || !facts.plane)
    refuse("is not for the chart " + facts.name + ", which is no plane unit square", allowed);
  const ExactImage* exact = chart.is_known_in_balls() ? exact_image(chart.in<Ball>()) : nullptr;
  Face face{.piece = facts.piece, .corners = {}, .inwards = {}};
  constexpr std::array<std::pair<bool, bool>, 4> around{
      {{false, false}, {true, false}, {true, true}, {false, true}}};
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (exact == nullptr)
      refuse("is not for the chart " + facts.name + ", whose corners are not exact", allowed);
    const Vector<ExactFunction> image = exact->image();
    const auto [s, t] = around.at(i);
    const auto x = at_corner(image.x, s, t);
    const auto y = at_corner(image.y, s, t);
    const auto z = at_corner(image.z, s, t);
    if (!x || !y || !z)
      refuse("is not for the chart " + facts.name + ", whose corners are not exact", allowed);
    face.corners.at(i) = {*x, *y, *z};
  }
  face.inwards = cross(face.corners[1] - face.corners[0], face.corners[3] - face.corners[0]);
  if (facts.orientation == Orientation::against_the_cross_product) face.inwards = Point{} - face.inwards;
  return face;
}

bool equal(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// The common side of two faces, if there is one.
std::optional<std::array<Point, 2>> common_side(const Face& a, const Face& b) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const Point& p = a.corners.at(i);
      const Point& q = a.corners.at((i + 1) % 4);
      const Point& v = b.corners.at(j);
      const Point& w = b.corners.at((j + 1) % 4);
      if ((equal(p, v) && equal(q, w)) || (equal(p, w) && equal(q, v))) return std::array{p, q};
    }
  return std::nullopt;
}

/// Whether a point of b is on the inner side of a, and none behind: both lie beside one edge.
bool faces_the_light_of(const Face& a, const Face& b) {
  return std::any_of(b.corners.begin(), b.corners.end(),
                     [&](const Point& corner) { return dot(a.inwards, corner - a.corners[0]).sign() > 0; });
}

Vector<double> rounded(const Point& p) { return {p.x.to_double(), p.y.to_double(), p.z.to_double()}; }

/// The largest reflectivity of a piece on a segment: of a constant, or of points of it.
Rational largest_reflectivity(const Problem& problem, const std::string& piece, const Point& from,
                              const Point& to) {
  const Expression& formula = problem.reflectivity.on(piece);
  const std::string allowed = "reflectivities in [0, 1) on the edges";
  std::optional<Rational> largest = formula.is_constant();
  if (!largest) {
    constexpr int parts = 64;
    double most = 0;
    for (int i = 0; i <= parts; ++i) {
      const Rational share(i, parts);
      const Vector<double> at = rounded(from + share * (to - from));
      const double value = formula.evaluate<double>({at.x, at.y, at.z});
      if (!(value >= 0 && value < 1))
        refuse("finds a reflectivity outside [0, 1) on an edge of " + piece, allowed);
      most = std::max(most, value);
    }
    largest = Rational::exactly(most);
  }
  if (largest->sign() < 0 || *largest >= Rational(1))
    refuse("finds the reflectivity " + largest->to_text() + " on " + piece, allowed);
  return *largest;
}

Ball angle_of(const Point& n, const Point& m) {
  const Ball cosine = -Ball(dot(n, m)) / sqrt(Ball(dot(n, n) * dot(m, m)));
  return Ball::pi() / Ball(2) - atan(cosine / sqrt(Ball(1) - cosine * cosine));
}

std::optional<double> exponent_of(const Edge& edge) {
  if (edge.reflectivity.sign() == 0 && edge.other_reflectivity.sign() == 0) return std::nullopt;
  if (edge.reflectivity.sign() == 0 || edge.other_reflectivity.sign() == 0) return 1;
  const Outcome<Ball> found = smallest_edge_exponent(edge, Rational(1) / power(Rational(10), 12));
  if (!found) refuse("finds no exponent: " + found.reason(), "a number >= 1");
  return found->lower_double();
}

/// The grading for the order degree + 1 beside an exponent, rounded up to a multiple of 1/64.
Rational grading_for(int degree, double exponent) {
  constexpr int parts = 64;
  return std::max(Rational(1),
                  Rational(static_cast<long>(std::ceil((degree + 1) / exponent * parts)), parts));
}

}  // namespace

EdgeGrading edge_grading(const Problem& problem, const Surface& surface) {
  const std::optional<int> degree = find_degree(problem.method);
  if (!degree) refuse("is not for a basis without a degree", "a basis on triangles, or a number >= 1");
  std::vector<Face> faces;
  for (const Chart& chart : surface.charts) faces.push_back(face_of(chart));
  EdgeGrading out;
  std::vector<Point> vertices;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      const Face& a = faces[i];
      const Face& b = faces[j];
      const auto side = common_side(a, b);
      if (!side || !faces_the_light_of(a, b) || !faces_the_light_of(b, a)) continue;
      const Edge edge{.angle = [n = a.inwards, m = b.inwards] { return angle_of(n, m); },
                      .is_right_angled = dot(a.inwards, b.inwards).sign() == 0,
                      .reflectivity = largest_reflectivity(problem, a.piece, (*side)[0], (*side)[1]),
                      .other_reflectivity = largest_reflectivity(problem, b.piece, (*side)[0], (*side)[1])};
      for (const Point& end : *side)
        if (std::none_of(vertices.begin(), vertices.end(), [&](const Point& v) { return equal(v, end); }))
          vertices.push_back(end);
      const std::optional<double> exponent = exponent_of(edge);
      if (!exponent) continue;
      out.edges.push_back({.pieces = {a.piece, b.piece},
                           .degrees = edge.angle().to_double() * 180 / Ball::pi().to_double(),
                           .reflectivities = {edge.reflectivity, edge.other_reflectivity},
                           .exponent = *exponent,
                           .grading = grading_for(*degree, *exponent)});
      out.grading = std::max(out.grading, out.edges.back().grading);
    }
  std::map<std::array<double, 3>, Approximation> by_reflectivities;
  for (const Point& vertex : vertices) {
    std::vector<const Face*> there;
    for (const Face& face : faces)
      if (std::any_of(face.corners.begin(), face.corners.end(),
                      [&](const Point& p) { return equal(p, vertex); }))
        there.push_back(&face);
    if (there.size() == 2) continue;
    bool is_octant = there.size() == 3;
    for (std::size_t k = 0; is_octant && k < 3; ++k)
      is_octant = dot(there[k]->inwards, there[(k + 1) % 3]->inwards).sign() == 0;
    if (!is_octant)
      refuse("knows no exponent for a corner of " + std::to_string(there.size()) +
                 " faces that are not all at "
                 "right angles",
             "a surface whose faces meet at right angles, or a number >= 1");
    std::array<double, 3> reflectivities{};
    GradedCorner corner;
    for (std::size_t k = 0; k < 3; ++k) {
      corner.pieces.at(k) = there[k]->piece;
      reflectivities.at(k) = largest_reflectivity(problem, there[k]->piece, vertex, vertex).to_double();
    }
    std::sort(reflectivities.begin(), reflectivities.end());
    const auto [known, is_new] = by_reflectivities.try_emplace(reflectivities);
    if (is_new) known->second = octant_exponent(reflectivities);
    corner.exponent = known->second;
    corner.grading = grading_for(*degree, corner.exponent.value - corner.exponent.radius);
    out.grading = std::max(out.grading, corner.grading);
    out.corners.push_back(std::move(corner));
  }
  return out;
}

std::optional<EdgeGrading> known_edge_grading(const Problem& problem, const Surface& surface) {
  try {
    return edge_grading(problem, surface);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace radcert
