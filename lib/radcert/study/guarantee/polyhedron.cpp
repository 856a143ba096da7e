// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "radcert/collocation/certified/plane_chart.h"
#include "radcert/continuous/function_enclosure.h"
#include "radcert/continuous/goal_enclosure.h"
#include "radcert/core/errors.h"
#include "radcert/core/json_pointer.h"
#include "radcert/core/text.h"
#include "radcert/enclosure/near_polynomial.h"
#include "radcert/hypotheses/convex_containment.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/guarantee/enclosed_problem.h"
#include "radcert/study/guarantee/polyhedron_certificate.h"
#include "radcert/study/problem.h"
#include "radcert/study/result.h"

namespace radcert {
namespace {

/// Of faces that hide each other.
constexpr std::size_t most_cut_panels = 300;

constexpr const char* what_is_enclosed =
    "a convex polyhedron with exact planes (of the catalogue or a mesh), closed or without some of its "
    "faces, a closed mesh whose parts hide each other, a sphere or an ellipsoid";

[[noreturn]] void refuse_surface(const Problem& problem, const std::string& reason) {
  throw InputError({.pointer = problem.surface.mesh ? "/surface/file" : "/surface/name",
                    .value = problem.surface.name,
                    .problem = "has no enclosure of its solution: " + reason,
                    .allowed = what_is_enclosed});
}

/// Where parts hide each other: those of the surface, cut along their planes, and themselves as blockers.
void put_occluded_panels(PolyhedronProblem& out, const Problem& problem, const Surface& surface,
                         std::vector<Panel> panels) {
  if (!surface.closed) refuse_surface(problem, "parts of it hide each other, and it is not closed");
  Outcome<std::vector<Panel>> cut = cut_panels(panels, most_cut_panels);
  if (!cut) refuse_surface(problem, "parts of it hide each other, and " + cut.reason());
  out.panels = std::move(cut).value();
  out.blockers = std::move(panels);
}

/// The panels of the surface, then black ones that close it.
void put_panels(PolyhedronProblem& problem_on_panels, const Problem& problem, const Surface& surface) {
  Outcome<std::vector<Panel>> panels = convex_panels(surface);
  if (!panels) refuse_surface(problem, panels.reason());
  if (!surface.unoccluded) {
    put_occluded_panels(problem_on_panels, problem, surface, std::move(panels).value());
    return;
  }
  // That of a mesh has been decided when it was read.
  if (!surface.mesh) {
    const ConvexContainment containment = convex_containment(surface);
    if (containment.verdict != Containment::certified)
      refuse_surface(problem,
                     "it is not proved to lie in the boundary of a convex body: " + containment.reason);
  }
  std::vector<Panel>& out = problem_on_panels.panels;
  out = std::move(panels).value();
  if (surface.closed) return;
  Outcome<std::vector<Panel>> closing = closing_panels(out, surface.piece_names().size());
  if (!closing) refuse_surface(problem, "it is not closed, and " + closing.reason());
  out.insert(out.end(), closing->begin(), closing->end());
}

/// An expression on a panel, where it is a polynomial of a degree that is allowed.
std::optional<PlanePolynomial<Rational>> polynomial_on(const Panel& panel, const Expression& f,
                                                       int largest_degree) {
  const std::vector<Vector<Rational>>& c = panel.corners;
  return polynomial_on_plane(f, c[0], c[1] - c[0], c[2] - c[0], largest_degree);
}

/// A polynomial without leading coefficients that are all 0.
PlanePolynomial<Rational> trimmed(const PlanePolynomial<Rational>& f) {
  int degree = f.degree();
  const auto is_zero = [&](int n) {
    bool all = true;
    for (int j = 0; j <= n; ++j) all = all && f(n - j, j).sign() == 0;
    return all;
  };
  while (degree > 0 && is_zero(degree)) --degree;
  PlanePolynomial<Rational> out(degree);
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) out(i, j) = f(i, j);
  return out;
}

/// The reflectivity by panel, proved to lie in [0,1).
std::vector<PanelReflectivity> reflectivities(const Problem& problem, const Surface& surface,
                                              const std::vector<Panel>& panels) {
  const std::vector<std::string> names = surface.piece_names();
  std::vector<PanelReflectivity> out;
  for (const Panel& panel : panels) {
    if (panel.piece == names.size()) {
      out.emplace_back(0);
      continue;
    }
    const std::string& name = names[panel.piece];
    const Expression& f = problem.reflectivity.on(name);
    const std::optional<PlanePolynomial<Rational>> polynomial =
        polynomial_on(panel, f, most_polynomial_degree);
    if (!polynomial)
      throw InputError({.pointer = "/reflectivity",
                        .value = f.text(),
                        .problem = "is not known to be a polynomial of degree 8 or less on piece " + name,
                        .allowed = "with a guarantee: polynomials in x, y, z on each piece, from whole "
                                   "numbers, decimals and fractions by + - * /"});
    Outcome<PanelReflectivity> rho = reflectivity_of(panel, trimmed(*polynomial));
    if (!rho)
      throw InputError(
          {.pointer = "/reflectivity",
           .value = f.text(),
           .problem = "is not known to be from 0 to below 1 on piece " + name + ": " + rho.reason(),
           .allowed = "from 0 to below 1"});
    out.push_back(std::move(rho).value());
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

/// Two sides of a panel that meet, as axes of its plane, and the rectangle of their parameters about it.
struct PanelFrame {
  ParameterPoint<Rational> corner;  ///< in plane_coordinates, as the sides
  ParameterPoint<Rational> first;
  ParameterPoint<Rational> second;
  Rational determinant = 0;  ///< first x second
  ParameterRectangle about = {.s_low = 0, .s_high = 0, .t_low = 0, .t_high = 0};

  /// The parameters of a point.
  [[nodiscard]] ParameterPoint<Rational> of(const ParameterPoint<Rational>& p) const {
    const Rational s = p.s - corner.s;
    const Rational t = p.t - corner.t;
    return {(s * second.t - t * second.s) / determinant, (t * first.s - s * first.t) / determinant};
  }
  /// A polynomial of these parameters as one of plane_coordinates.
  [[nodiscard]] PlanePolynomial<Rational> in_plane(const PlanePolynomial<Rational>& p) const {
    const ParameterPoint<Rational> at_0 = of({0, 0});
    const ParameterPoint<Rational> at_s = of({1, 0});
    const ParameterPoint<Rational> at_t = of({0, 1});
    return composed(p, affine_polynomial<Rational>(at_0.s, at_s.s - at_0.s, at_t.s - at_0.s),
                    affine_polynomial<Rational>(at_0.t, at_s.t - at_0.t, at_t.t - at_0.t));
  }
};

/// That with the smallest rectangle: of a parallelogram the parallelogram itself.
PanelFrame smallest_frame(const Panel& panel) {
  std::vector<ParameterPoint<Rational>> corners;
  for (const Vector<Rational>& corner : panel.corners) corners.push_back(plane_coordinates(panel, corner));
  const std::size_t n = corners.size();
  std::optional<PanelFrame> best;
  Rational least = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const ParameterPoint<Rational>& next = corners[(k + 1) % n];
    const ParameterPoint<Rational>& last = corners[(k + n - 1) % n];
    PanelFrame frame{.corner = corners[k],
                     .first = {next.s - corners[k].s, next.t - corners[k].t},
                     .second = {last.s - corners[k].s, last.t - corners[k].t}};
    frame.determinant = frame.first.s * frame.second.t - frame.first.t * frame.second.s;
    if (frame.determinant.sign() == 0) continue;
    ParameterRectangle& about = frame.about;
    for (const ParameterPoint<Rational>& corner : corners) {
      const ParameterPoint<Rational> at = frame.of(corner);
      about.s_low = std::min(about.s_low, at.s);
      about.s_high = std::max(about.s_high, at.s);
      about.t_low = std::min(about.t_low, at.t);
      about.t_high = std::max(about.t_high, at.t);
    }
    const Rational area =
        abs(frame.determinant) * (about.s_high - about.s_low) * (about.t_high - about.t_low);
    if (best && !(area < least)) continue;
    best = frame;
    least = area;
  }
  expects(best.has_value(), "a panel with a corner", named("corners", n));
  return *best;
}

/// The emission on a panel.
struct PanelEmission {
  PlanePolynomial<Rational> polynomial;  ///< of plane_coordinates
  double distance = 0;                   ///< at least sup |E - the polynomial|
  Rational size = 0;                     ///< at least sup |the polynomial|
};

/// Where E is a polynomial of degree 8 or less that one, else one near it.
PanelEmission emission_on(const Panel& panel, const Expression& f, const std::string& piece,
                          const std::string& pointer) {
  constexpr int largest_degree = most_polynomial_degree;
  if (std::optional<PlanePolynomial<Rational>> exact = polynomial_on(panel, f, largest_degree)) {
    Rational size = largest_on(panel, *exact);
    return {.polynomial = std::move(*exact), .distance = 0, .size = std::move(size)};
  }
  const PanelFrame frame = smallest_frame(panel);
  const Vector<Rational>& origin = panel.corners[0];
  const auto place = [&](const ParameterPoint<Rational>& p) {
    return p.s * (panel.corners[1] - origin) + p.t * (panel.corners[2] - origin);
  };
  const Vector<Rational> corner = origin + place(frame.corner);
  const Vector<Rational> first = place(frame.first);
  const Vector<Rational> second = place(frame.second);
  const auto on_plane = [&]<class R>(const R& s, const R& t) {
    const auto coordinate = [&](const Rational& o, const Rational& u, const Rational& v) {
      return from_rational<R>(o) + from_rational<R>(u) * s + from_rational<R>(v) * t;
    };
    return f.evaluate(Variables<R>{.x = coordinate(corner.x, first.x, second.x),
                                   .y = coordinate(corner.y, first.y, second.y),
                                   .z = coordinate(corner.z, first.z, second.z)});
  };
  const Outcome<NearPolynomial> near = near_polynomial(plane_function(on_plane), frame.about, largest_degree);
  if (!near || !std::isfinite(near->size))
    throw InputError(
        {.pointer = pointer,
         .value = f.text(),
         .problem = "has no polynomial near it on piece " + piece + ": " +
                    (near ? std::string("its values are beyond double") : near.reason()),
         .allowed = "with a guarantee: polynomials, and functions that are analytic about the parallelogram "
                    "around each face"});
  return {.polynomial = frame.in_plane(near->polynomial),
          .distance = near->distance,
          .size = Rational::exactly(near->size)};
}

/// An emission by panel.
struct PanelEmissions {
  std::vector<PlanePolynomial<Rational>> polynomials;
  double distance = 0;  ///< at least sup |E - the polynomials|
  Rational size = 0;    ///< at least sup |the polynomials|
};

PanelEmissions emissions_on(const std::vector<Panel>& panels, const PiecewiseExpression& emission,
                            const std::vector<std::string>& names, const std::string& pointer) {
  PanelEmissions out;
  for (const Panel& panel : panels) {
    if (panel.piece == names.size()) {
      out.polynomials.emplace_back(0);
      continue;
    }
    const std::string& name = names[panel.piece];
    PanelEmission own = emission_on(panel, emission.on(name), name, pointer);
    require_normal(own.size, pointer);
    out.distance = std::max(out.distance, own.distance);
    out.size = std::max(out.size, own.size);
    out.polynomials.push_back(std::move(own.polynomial));
  }
  return out;
}

/// A problem whose emission is polynomials, and how far its solution may be from that of the problem asked.
struct NearProblem {
  PolyhedronProblem polyhedron;
  double distance = 0;  ///< at least sup |u - the solution of this problem|
};

/// Maths     u - u_p = (I - K)^-1 (E - E_p), and the norm of (I - K)^-1 in C(S) is at most 1/(1 - sup rho)
NearProblem polyhedron_problem(const Problem& problem, const Surface& surface, const Guarantee& guarantee) {
  PolyhedronProblem out;
  put_panels(out, problem, surface);
  if (guarantee.of != EnclosedQuantity::values) out.panels = with_edges_matched(std::move(out.panels));
  out.reflectivity = reflectivities(problem, surface, out.panels);
  const std::vector<std::string> names = surface.piece_names();
  PanelEmissions own = emissions_on(out.panels, *problem.emission, names, "/emission");
  double left_out = own.distance;
  Rational largest = own.size;
  out.emission = std::move(own.polynomials);
  for (const NamedEmission& further : guarantee.emissions) {
    PanelEmissions found = emissions_on(out.panels, further.emission, names,
                                        pointer_below("/guarantee/emissions", further.name));
    left_out = std::max(left_out, found.distance);
    largest = std::max(largest, found.size);
    out.further_emissions.push_back(std::move(found.polynomials));
  }
  Rational sup = 0;
  for (std::size_t j = 0; j < out.panels.size(); ++j) {
    const Rational& rho = out.reflectivity[j].largest;
    require_normal(rho, "/reflectivity");
    const std::vector<Vector<Rational>>& corners = out.panels[j].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector<Rational>& corner = corners[i];
      const Vector<Rational> edge = corners[(i + 1) % corners.size()] - corner;
      const std::string pointer = problem.surface.mesh ? "/surface/file" : "/surface";
      for (const Rational& number : {corner.x, corner.y, corner.z, abs(edge.x) + abs(edge.y) + abs(edge.z)})
        require_normal(number, pointer);
    }
    sup = std::max(sup, rho);
  }
  require_width(guarantee, least_relative_width, largest / (Rational(1) - sup));
  const double distance = (Ball(left_out) / Ball(Rational(1) - sup)).upper_double();
  const double widest = guarantee.width.to_double() / 4;
  if (!(distance <= widest))
    throw InputError({.pointer = "/emission",
                      .problem = "is not known to be a polynomial of degree 8 or less on each piece, and "
                                 "those that were found near it leave " +
                                 upper_text(distance) + " of the solution unknown",
                      .allowed = "widths of four times that or more, or a polynomial on each piece"});
  return {.polyhedron = std::move(out), .distance = distance};
}

/// Whether a point of a panel is nearer to the line of one of its sides than a thousandth of the side's
/// length, and no panel lies across.
/// Maths     |side x (p - corner)| < |side|^2 / 1000; the point's mirror image in the line is on no panel
bool is_near_an_edge(const std::vector<Panel>& panels, std::size_t own, const Vector<Rational>& p) {
  const std::vector<Vector<Rational>>& corners = panels[own].corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<Rational> side = corners[(i + 1) % corners.size()] - corners[i];
    const Vector<Rational> turned = cross(side, p - corners[i]);
    const Rational length = dot(side, side);
    if (!(dot(turned, turned) * Rational(1000000) < length * length)) continue;
    const Vector<Rational> foot = corners[i] + (dot(side, p - corners[i]) / length) * side;
    if (panel_about(panels, Rational(2) * foot - p) == panels.size()) return true;
  }
  return false;
}

[[noreturn]] void refuse_point(std::size_t k, const Vector<Rational>& point, const std::string& problem,
                               const std::string& allowed) {
  throw InputError({.pointer = "/guarantee/points/" + std::to_string(k),
                    .value = coordinates_text(point),
                    .problem = problem,
                    .allowed = allowed});
}

/// The points at which values are asked for, each with its panel; where no panel hides another.
std::vector<SolutionPoint> solution_points(const Guarantee& guarantee, const std::vector<Panel>& panels) {
  std::vector<SolutionPoint> out;
  if (guarantee.points.empty())
    for (std::size_t k = 0; k < panels.size(); ++k) out.push_back({k, panels[k].centre});
  for (std::size_t k = 0; k < guarantee.points.size(); ++k) {
    const Vector<Rational>& point = guarantee.points[k];
    const std::size_t panel = panel_inside(panels, point);
    if (panel == panels.size())
      refuse_point(
          k, point, "does not lie inside a face of the surface",
          "a point of a face that is on none of its edges, nor on a line between parts that lie in one "
          "plane, exactly");
    if (is_near_an_edge(panels, panel, point))
      refuse_point(k, point, "is too near to an edge of its face",
                   "points further from each edge than a thousandth of its length");
    out.push_back({panel, point});
  }
  return out;
}

/// The same on parts of faces, where they hide each other.
std::vector<SolutionPoint> points_on_parts(const Guarantee& guarantee, const std::vector<Panel>& parts) {
  if (guarantee.points.empty())
    throw InputError({.pointer = "/guarantee/points",
                      .problem = "are not given, and parts of the surface hide each other",
                      .allowed = "a list of points, or --at X,Y,Z"});
  std::vector<SolutionPoint> out;
  for (std::size_t k = 0; k < guarantee.points.size(); ++k) {
    const Vector<Rational>& point = guarantee.points[k];
    const std::size_t part = panel_about(parts, point);
    if (part == parts.size())
      refuse_point(k, point, "does not lie inside a face of the surface",
                   "a point of a face that is on none of its edges, nor on another face, exactly");
    if (is_near_an_edge(parts, part, point))
      refuse_point(k, point, "is too near to an edge of its face",
                   "points further from each edge than a thousandth of its length");
    out.push_back({part, point});
  }
  return out;
}

/// The square of the largest distance of two corners of one face: each point of it is nearer to all of them.
Rational squared_extent(const PolyhedronProblem& polyhedron) {
  Rational largest = 0;
  for (const Panel& panel : polyhedron.panels)
    for (const Vector<Rational>& a : panel.corners)
      for (const Vector<Rational>& b : panel.corners) largest = std::max(largest, dot(a - b, a - b));
  return largest;
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
    const Rational extent = squared_extent(polyhedron);
    if (*guarantee.outside * *guarantee.outside >= extent)
      throw InputError({.pointer = "/guarantee/outside",
                        .value = guarantee.outside->to_text(),
                        .problem = "is farther than any point of a face is from its corners",
                        .allowed = "less than " +
                                   nearest_text(std::sqrt(extent.to_double()), DecimalForm::general(6)) +
                                   ", the largest distance of two corners of a face"});
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

/// The number that a distance by distance_from_vertices is meant to be.
Rational short_decimal(double distance) {
  constexpr int digits = 6;
  return Rational::parse(nearest_text(distance, DecimalForm::general(digits))).value();
}

Ball between(const Rational& least, const Rational& most) {
  if (least == most) return Ball(most);
  const Ball half = Ball(most - least) / 2;
  return widened(Ball(least) + half, half);
}

class EnclosedPolyhedron final : public EnclosedProblem {
public:
  EnclosedPolyhedron(const Problem& problem, const Guarantee& guarantee, Surface surface)
      : guarantee_(guarantee),
        surface_(std::move(surface)),
        near_(polyhedron_problem(problem, surface_, guarantee)) {
    if (guarantee.of == EnclosedQuantity::values) {
      std::vector<Panel> own = near_.polyhedron.panels;
      std::erase_if(own, [&](const Panel& panel) { return is_opening(panel.piece); });
      points_ = near_.polyhedron.blockers.empty() ? solution_points(guarantee, own)
                                                  : points_on_parts(guarantee, own);
    }
    if (guarantee.of == EnclosedQuantity::function)
      outside_ = distance_from_vertices(guarantee, near_.polyhedron);
  }

  [[nodiscard]] std::pair<LevelResult, SolutionEnclosure> solve(
      const GuaranteeContext& context) const override {
    if (guarantee_.of == EnclosedQuantity::function)
      return function_result(enclose_function(near_.polyhedron, wanted(), outside_, told(context)));
    return numbers(wanted(), told(context));
  }

  /// A certificate is of an emission by polynomials.
  [[nodiscard]] std::vector<std::string> certificate_hindrances() const override {
    std::vector<std::string> out;
    if (near_.distance != 0) out.emplace_back("an emission is no polynomial of degree 8 or less");
    return out;
  }
  /// A certificate may be wider than what it is of: then there is another search, which aims at less.
  [[nodiscard]] CertifiedSolution certified(const GuaranteeContext& context) const override {
    constexpr int most_searches = 3;
    double aim = certified_share * wanted();
    for (int n = 1;; ++n) {
      CertifiedSolution out = guarantee_.of == EnclosedQuantity::function
                                  ? certified_function(aim, told(context))
                                  : certified_numbers(aim, told(context));
      const Rational& width = std::get<certificate::PolyhedronCertificate>(out.certificate).width;
      if (width <= guarantee_.width || !out.enclosure.hindrance.empty() || n == most_searches) {
        say_width_of_certificate(width, guarantee_, out.enclosure);
        return out;
      }
      aim *= 0.9 * (guarantee_.width / width).to_double();
    }
  }

private:
  /// What closes an open surface.
  [[nodiscard]] bool is_opening(std::size_t piece) const { return piece == surface_.piece_names().size(); }
  /// The names of the pieces, and of what closes them.
  [[nodiscard]] std::vector<std::string> certified_names() const {
    std::vector<std::string> names = surface_.piece_names();
    if (!surface_.closed) {
      std::string name = "opening";
      while (std::find(names.begin(), names.end(), name) != names.end()) name += "_";
      names.push_back(std::move(name));
    }
    return names;
  }

  [[nodiscard]] static SearchContext told(const GuaranteeContext& context) {
    const auto progress = [&context](const EnclosureProgress& now) {
      if (now.finished && context.progress)
        context.progress({.layers = now.layers,
                          .degree = now.degree,
                          .unknowns = now.unknowns,
                          .samples = now.samples,
                          .width = now.width});
      if (!now.finished && context.meshes)
        context.meshes({.layers = now.layers,
                        .degree = now.degree,
                        .elements = now.elements,
                        .planned = now.planned,
                        .cells = now.cells,
                        .cells_done = now.cells_done,
                        .width = now.width});
    };
    return {.progress = progress, .kept = context.kept};
  }
  /// Of the polynomial emission. A double from below: what is reached is then within what was asked for.
  [[nodiscard]] double wanted() const {
    const double asked = guarantee_.width.to_double() * (1 - unit_roundoff<double>());
    return near_.distance > 0 ? (asked - 2 * near_.distance) * (1 - 16 * unit_roundoff<double>()) : asked;
  }
  [[nodiscard]] LevelResult level_of(const EnclosureProgress& last) const {
    LevelResult level;
    level.level = last.layers;
    level.elements = last.elements;
    level.unknowns = last.unknowns;
    level.mesh_size = last.mesh_size;
    // On a closed surface sup rho, on an open one at most; enclosing rounds it as norm_of_K does.
    Rational largest = 0;
    Rational seen = 0;
    for (const PanelReflectivity& rho : near_.polyhedron.reflectivity) {
      largest = std::max(largest, rho.largest);
      seen = std::max(seen, rho.seen);
    }
    level.norm_K = enclosing(surface_.closed ? between(seen, largest) : between(0, largest));
    return level;
  }

  [[nodiscard]] std::pair<LevelResult, SolutionEnclosure> numbers(double wanted,
                                                                  const SearchContext& context) const {
    const bool of_values = guarantee_.of == EnclosedQuantity::values;
    const GoalEnclosure found = of_values ? enclose_values(near_.polyhedron, points_, wanted, context)
                                          : enclose_means(near_.polyhedron, wanted, context);
    return result_of(found, of_values);
  }

  [[nodiscard]] std::pair<LevelResult, SolutionEnclosure> result_of(const GoalEnclosure& found,
                                                                    bool of_values) const {
    const std::vector<std::string> names = surface_.piece_names();
    if (!std::isfinite(found.width))
      throw AccuracyNotReached(of_values ? "the values of u" : "the means of u", found.hindrance);
    SolutionEnclosure enclosure{
        .wanted = guarantee_, .width = 2 * widened(0.5 * found.width), .hindrance = found.hindrance};
    LevelResult level = level_of(found.last);
    const std::size_t emissions = 1 + guarantee_.emissions.size();
    const std::size_t count = found.numbers.size() / emissions;
    for (std::size_t i = 0; i < emissions; ++i) {
      SolutionEnclosure::OfEmission of;
      for (std::size_t k = 0; k < count; ++k) {
        if (!of_values && is_opening(k)) continue;
        const Approximation number = widened(found.numbers[i * count + k]);
        if (of_values)
          of.points.push_back(
              {names[near_.polyhedron.panels[points_[k].panel].piece], points_[k].at, number});
        else
          of.pieces.emplace_back(names[k], number);
      }
      if (i > 0) {
        of.emission = guarantee_.emissions[i - 1].name;
        enclosure.emissions.push_back(std::move(of));
        continue;
      }
      level.piece_means = of.pieces;
      enclosure.pieces = std::move(of.pieces);
      enclosure.points = std::move(of.points);
    }
    return {std::move(level), std::move(enclosure)};
  }

  [[nodiscard]] CertifiedSolution certified_numbers(double wanted, const SearchContext& context) const {
    const bool of_values = guarantee_.of == EnclosedQuantity::values;
    const GoalEnclosure found = of_values ? enclose_values(near_.polyhedron, points_, wanted, context, true)
                                          : enclose_means(near_.polyhedron, wanted, context, true);
    auto [level, enclosure] = result_of(found, of_values);
    return {.level = std::move(level),
            .enclosure = std::move(enclosure),
            .certificate =
                polyhedron_certificate(near_.polyhedron, certified_names(), found.proof.get(), points_)};
  }

  [[nodiscard]] CertifiedSolution certified_function(double wanted, const SearchContext& context) const {
    const FunctionEnclosure found = enclose_function(near_.polyhedron, wanted, outside_, context, true);
    auto [level, enclosure] = function_result(found);
    return {.level = std::move(level),
            .enclosure = std::move(enclosure),
            .certificate =
                polyhedron_certificate(near_.polyhedron, certified_names(), *found.proof, guarantee_.width,
                                       guarantee_.outside.value_or(short_decimal(outside_)))};
  }

  [[nodiscard]] std::pair<LevelResult, SolutionEnclosure> function_result(
      const FunctionEnclosure& found) const {
    const std::vector<std::string> names = surface_.piece_names();
    if (!std::isfinite(found.sup)) throw AccuracyNotReached("the solution u", found.hindrance);
    SolutionEnclosure enclosure{
        .wanted = guarantee_, .width = 2 * widened(found.sup), .hindrance = found.hindrance};
    FunctionBound bound{.sup = widened(found.sup),
                        .outside = found.outside,
                        .faces_are_cut = !near_.polyhedron.blockers.empty()};
    for (const FunctionEnclosure::AtDistance& at : found.by_distance)
      bound.by_distance.push_back({at.outside, widened(at.sup)});
    for (std::size_t k = 0; k < names.size(); ++k)
      bound.pieces.push_back(
          {names[k], widened(found.pieces[k].outside), widened(found.pieces[k].everywhere)});
    for (const EnclosedPart& part : found.parts)
      if (!is_opening(part.piece))
        enclosure.patches.push_back({names[part.piece], part.corners, part.values, widened(part.bound)});
    enclosure.function = std::move(bound);
    return {level_of(found.last), std::move(enclosure)};
  }

  /// What is found for the polynomial emission, for the emission itself.
  [[nodiscard]] double widened(double radius) const {
    return near_.distance > 0 ? (radius + near_.distance) * (1 + 2 * unit_roundoff<double>()) : radius;
  }
  [[nodiscard]] Approximation widened(const Approximation& number) const {
    return {.value = number.value, .radius = widened(number.radius), .guaranteed = number.guaranteed};
  }

  const Guarantee& guarantee_;
  Surface surface_;
  NearProblem near_;
  std::vector<SolutionPoint> points_;
  double outside_ = 0;
};

}  // namespace

std::unique_ptr<EnclosedProblem> enclosed_polyhedron(const Problem& problem, const Guarantee& guarantee,
                                                     Surface surface) {
  return std::make_unique<EnclosedPolyhedron>(problem, guarantee, std::move(surface));
}

}  // namespace radcert
