// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/continuous/function_enclosure.h"
#include "radcert/continuous/goal_enclosure.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/hypotheses/convex_containment.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/guarantee/enclosed_problem.h"
#include "radcert/study/guarantee/means_certificate.h"
#include "radcert/study/problem.h"
#include "radcert/study/result.h"

namespace radcert {
namespace {

constexpr const char* what_is_enclosed =
    "a closed convex polyhedron (cube, box, tetrahedron, octahedron, or a mesh), a sphere or an ellipsoid";

[[noreturn]] void refuse_surface(const Problem& problem, const std::string& reason) {
  throw InputError({.pointer = problem.surface.mesh ? "/surface/file" : "/surface/name",
                    .value = problem.surface.name,
                    .problem = "has no enclosure of its solution: " + reason,
                    .allowed = what_is_enclosed});
}

std::vector<Panel> panels_of(const Problem& problem, const Surface& surface) {
  if (!surface.closed) refuse_surface(problem, "it is not closed");
  if (!surface.unoccluded) refuse_surface(problem, "parts of it hide each other");
  Outcome<std::vector<Panel>> panels = convex_panels(surface);
  if (!panels) refuse_surface(problem, panels.reason());
  // That of a mesh has been decided when it was read.
  if (!surface.mesh) {
    const ConvexContainment containment = convex_containment(surface);
    if (containment.verdict != Containment::certified)
      refuse_surface(problem,
                     "it is not proved to lie in the boundary of a convex body: " + containment.reason);
  }
  return std::move(panels).value();
}

/// An expression on the panels, where it is a polynomial of a degree that is allowed.
std::vector<PlanePolynomial<Rational>> polynomials(const PiecewiseExpression& function,
                                                   const std::string& pointer, const Surface& surface,
                                                   const std::vector<Panel>& panels, int largest_degree) {
  const std::vector<std::string> names = surface.piece_names();
  const std::string kind = largest_degree == 0
                               ? "constant"
                               : "a polynomial of degree " + std::to_string(largest_degree) + " or less";
  std::vector<PlanePolynomial<Rational>> out;
  for (const Panel& panel : panels) {
    const Expression& f = function.on(names[panel.piece]);
    const std::vector<Vector<Rational>>& c = panel.corners;
    std::optional<PlanePolynomial<Rational>> polynomial =
        polynomial_on_plane(f, c[0], c[1] - c[0], c[2] - c[0], largest_degree);
    if (!polynomial)
      throw InputError({.pointer = pointer,
                        .value = f.text(),
                        .problem = "is not known to be " + kind + " on piece " + names[panel.piece],
                        .allowed = "with a guarantee: " + kind +
                                   " on each piece, from whole numbers, decimals and fractions by + - * /"});
    out.push_back(std::move(*polynomial));
  }
  return out;
}

/// A bound of |f| on a panel.
/// Maths     sum |c_ij| S^i T^j, S and T the largest parameters of the corners in size
Rational largest_on(const Panel& panel, const PlanePolynomial<Rational>& f) {
  Rational s = 0;
  Rational t = 0;
  for (const Vector<Rational>& corner : panel.corners) {
    const ParameterPoint<Rational> at = plane_coordinates(panel, corner);
    s = std::max(s, abs(at.s));
    t = std::max(t, abs(at.t));
  }
  PlanePolynomial<Rational> sizes(f.degree());
  for (int i = 0; i <= f.degree(); ++i)
    for (int j = 0; i + j <= f.degree(); ++j) sizes(i, j) = abs(f(i, j));
  return sizes.value(s, t);
}

PolyhedronProblem polyhedron_problem(const Problem& problem, const Surface& surface,
                                     const Guarantee& guarantee) {
  PolyhedronProblem out{.panels = panels_of(problem, surface), .reflectivity = {}, .emission = {}};
  for (const PlanePolynomial<Rational>& rho :
       polynomials(problem.reflectivity, "/reflectivity", surface, out.panels, 0))
    out.reflectivity.push_back(rho(0, 0));
  constexpr int largest_degree = 8;
  out.emission = polynomials(*problem.emission, "/emission", surface, out.panels, largest_degree);
  Rational largest = 0;
  Rational sup = 0;
  for (std::size_t j = 0; j < out.panels.size(); ++j) {
    const Rational& rho = out.reflectivity[j];
    if (rho.sign() < 0 || rho >= Rational(1))
      throw InputError({.pointer = "/reflectivity",
                        .value = rho.to_text(),
                        .problem = "is not below 1, or is negative",
                        .allowed = "from 0 to below 1"});
    const Rational emission = largest_on(out.panels[j], out.emission[j]);
    require_normal(rho, "/reflectivity");
    require_normal(emission, "/emission");
    const std::vector<Vector<Rational>>& corners = out.panels[j].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector<Rational>& corner = corners[i];
      const Vector<Rational> edge = corners[(i + 1) % corners.size()] - corner;
      const std::string pointer = problem.surface.mesh ? "/surface/file" : "/surface";
      for (const Rational& number : {corner.x, corner.y, corner.z, abs(edge.x) + abs(edge.y) + abs(edge.z)})
        require_normal(number, pointer);
    }
    sup = std::max(sup, rho);
    largest = std::max(largest, emission);
  }
  require_width(guarantee, least_relative_width, largest / (Rational(1) - sup));
  return out;
}

/// Whether a point is nearer to the line of an edge than a thousandth of the edge's length.
/// Maths     |side x (p - corner)| < |side|^2 / 1000
bool is_near_an_edge(const Panel& panel, const Vector<Rational>& p) {
  const std::vector<Vector<Rational>>& corners = panel.corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<Rational> side = corners[(i + 1) % corners.size()] - corners[i];
    const Vector<Rational> turned = cross(side, p - corners[i]);
    const Rational length = dot(side, side);
    if (dot(turned, turned) * Rational(1000000) < length * length) return true;
  }
  return false;
}

/// The points at which values are asked for, each with its panel.
std::vector<SolutionPoint> solution_points(const Guarantee& guarantee, const std::vector<Panel>& panels) {
  std::vector<SolutionPoint> out;
  if (guarantee.points.empty())
    for (std::size_t k = 0; k < panels.size(); ++k) out.push_back({k, panels[k].centre});
  for (std::size_t k = 0; k < guarantee.points.size(); ++k) {
    const std::size_t panel = panel_inside(panels, guarantee.points[k]);
    if (panel == panels.size())
      throw InputError({.pointer = "/guarantee/points/" + std::to_string(k),
                        .value = coordinates_text(guarantee.points[k]),
                        .problem = "does not lie inside a face of the surface",
                        .allowed = "a point of a face that is on none of its edges, nor on a line between "
                                   "parts that lie in one plane, exactly"});
    if (is_near_an_edge(panels[panel], guarantee.points[k]))
      throw InputError({.pointer = "/guarantee/points/" + std::to_string(k),
                        .value = coordinates_text(guarantee.points[k]),
                        .problem = "is too near to an edge of its face",
                        .allowed = "points further from each edge than a thousandth of its length"});
    out.push_back({panel, guarantee.points[k]});
  }
  return out;
}

/// How far from the vertices a bound is wanted.
double distance_from_vertices(const Guarantee& guarantee, const PolyhedronProblem& polyhedron) {
  if (guarantee.outside) {
    if (guarantee.outside->sign() < 0)
      throw InputError({.pointer = "/guarantee/outside",
                        .value = guarantee.outside->to_text(),
                        .problem = "is negative",
                        .allowed = "a distance from the vertices, 0 or more"});
    require_normal(*guarantee.outside, "/guarantee/outside");
    return guarantee.outside->to_double();
  }
  double shortest = std::numeric_limits<double>::infinity();
  for (const Panel& panel : polyhedron.panels)
    for (std::size_t i = 0; i < panel.corners.size(); ++i) {
      const Vector<Rational> side = panel.corners[(i + 1) % panel.corners.size()] - panel.corners[i];
      shortest = std::min(shortest, std::sqrt(dot(side, side).to_double()));
    }
  return 0.01 * shortest;
}

class EnclosedPolyhedron final : public EnclosedProblem {
public:
  EnclosedPolyhedron(const Problem& problem, const Guarantee& guarantee, Surface surface)
      : guarantee_(guarantee),
        surface_(std::move(surface)),
        polyhedron_(polyhedron_problem(problem, surface_, guarantee)) {
    if (guarantee.of == EnclosedQuantity::values) points_ = solution_points(guarantee, polyhedron_.panels);
    if (guarantee.of == EnclosedQuantity::function) outside_ = distance_from_vertices(guarantee, polyhedron_);
  }

  [[nodiscard]] std::pair<LevelResult, SolutionEnclosure> solve(
      const GuaranteeListener& progress) const override {
    return guarantee_.of == EnclosedQuantity::function ? function(wanted(), told(progress))
                                                       : numbers(wanted(), told(progress));
  }

  [[nodiscard]] bool has_certificate() const override { return true; }
  [[nodiscard]] CertifiedMeans certified(const GuaranteeListener& progress) const override {
    const GoalEnclosure found = enclose_means(polyhedron_, certified_share * wanted(), told(progress), true);
    auto [level, enclosure] = result_of(found, false);
    CertifiedMeans out{
        .level = std::move(level),
        .enclosure = std::move(enclosure),
        .certificate = means_certificate(polyhedron_, surface_.piece_names(), found.proof.get())};
    if (out.certificate.width <= guarantee_.width)
      out.enclosure.hindrance.clear();
    else if (out.enclosure.hindrance.empty())
      out.enclosure.hindrance = "the certificate has the width " + upper_text(out.certificate.width);
    return out;
  }

private:
  [[nodiscard]] static EnclosureListener told(const GuaranteeListener& progress) {
    return [&progress](const EnclosureProgress& now) {
      if (progress)
        progress({.layers = now.layers,
                  .degree = now.degree,
                  .unknowns = now.unknowns,
                  .samples = now.samples,
                  .width = now.width});
    };
  }
  /// A double from below: what is reached is then within what was asked for.
  [[nodiscard]] double wanted() const { return guarantee_.width.to_double() * (1 - unit_roundoff<double>()); }
  [[nodiscard]] LevelResult level_of(const EnclosureProgress& last) const {
    LevelResult level;
    level.level = last.layers;
    level.elements = last.elements;
    level.unknowns = last.unknowns;
    level.mesh_size = last.mesh_size;
    // On a closed surface sup rho; enclosing rounds it as norm_of_K does.
    level.norm_K =
        enclosing(Ball(*std::max_element(polyhedron_.reflectivity.begin(), polyhedron_.reflectivity.end())));
    return level;
  }

  [[nodiscard]] std::pair<LevelResult, SolutionEnclosure> numbers(double wanted,
                                                                  const EnclosureListener& tell) const {
    const bool of_values = guarantee_.of == EnclosedQuantity::values;
    const GoalEnclosure found = of_values ? enclose_values(polyhedron_, points_, wanted, tell)
                                          : enclose_means(polyhedron_, wanted, tell);
    return result_of(found, of_values);
  }

  [[nodiscard]] std::pair<LevelResult, SolutionEnclosure> result_of(const GoalEnclosure& found,
                                                                    bool of_values) const {
    const std::vector<std::string> names = surface_.piece_names();
    if (!std::isfinite(found.width))
      throw AccuracyNotReached(of_values ? "the values of u" : "the means of u", found.hindrance);
    SolutionEnclosure enclosure{.wanted = guarantee_, .width = found.width, .hindrance = found.hindrance};
    LevelResult level = level_of(found.last);
    for (std::size_t k = 0; k < found.numbers.size(); ++k) {
      if (of_values) {
        const SolutionPoint& point = points_[k];
        enclosure.points.push_back(
            {names[polyhedron_.panels[point.panel].piece], point.at, found.numbers[k]});
      } else {
        enclosure.pieces.emplace_back(names[k], found.numbers[k]);
        level.piece_means.emplace_back(names[k], found.numbers[k]);
      }
    }
    return {std::move(level), std::move(enclosure)};
  }

  [[nodiscard]] std::pair<LevelResult, SolutionEnclosure> function(double wanted,
                                                                   const EnclosureListener& tell) const {
    const std::vector<std::string> names = surface_.piece_names();
    FunctionEnclosure found = enclose_function(polyhedron_, wanted, outside_, tell);
    if (!std::isfinite(found.sup)) throw AccuracyNotReached("the solution u", found.hindrance);
    SolutionEnclosure enclosure{
        .wanted = guarantee_, .width = 2 * found.sup, .hindrance = std::move(found.hindrance)};
    FunctionBound bound{.sup = found.sup, .outside = found.outside};
    for (const FunctionEnclosure::AtDistance& at : found.by_distance)
      bound.by_distance.push_back({at.outside, at.sup});
    for (std::size_t k = 0; k < names.size(); ++k)
      bound.pieces.push_back({names[k], found.pieces[k].outside, found.pieces[k].everywhere});
    for (const EnclosedPart& part : found.parts)
      enclosure.patches.push_back({names[part.piece], part.corners, part.values, part.bound});
    enclosure.function = std::move(bound);
    return {level_of(found.last), std::move(enclosure)};
  }

  const Guarantee& guarantee_;
  Surface surface_;
  PolyhedronProblem polyhedron_;
  std::vector<SolutionPoint> points_;
  double outside_ = 0;
};

}  // namespace

std::unique_ptr<EnclosedProblem> enclosed_polyhedron(const Problem& problem, const Guarantee& guarantee,
                                                     Surface surface) {
  return std::make_unique<EnclosedPolyhedron>(problem, guarantee, std::move(surface));
}

}  // namespace radcert
