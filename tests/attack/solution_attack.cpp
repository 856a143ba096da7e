// SPDX-License-Identifier: GPL-3.0-or-later
// Enclosures of the solution on skew polyhedra: constants in furnaces whose walls reflect unequally, by
// constants or by polynomials, which means and values have to contain; the balance of energy of any other
// emission; coarse enclosures beside finer ones; values of solutions that no formula knows, each lit by two
// faces, which make a furnace together; functions on open surfaces, lit from inside and through their
// openings, which make one too; and means in rooms whose parts hide each other, beside configuration factors.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "radcert/continuous/function_enclosure.h"
#include "radcert/continuous/goal_enclosure.h"
#include "radcert/core/text.h"
#include "radcert/factors/factor_matrix.h"
#include "radcert/polynomial/plane_polynomial_algebra.h"
#include "radcert/surface/catalogue.h"
#include "tests/attack/attack.h"
#include "tests/continuous/rooms.h"
#include "tests/continuous/skew_map.h"

namespace radcert::attack {
namespace {

/// An affine image of a polyhedron of the catalogue; numbers in hundredths.
struct Instance {
  std::string surface;
  SkewMap map;
  std::vector<long> reflectivity;  ///< by panel, its value where s = t = 0
  /// By panel, of s, t, s^2, s t, t^n, where that leaves it between 0 and 1; empty: constants.
  std::vector<std::array<long, 5>> bends = {};
  int power = 3;               ///< n
  std::vector<long> emission;  ///< by panel; empty: a furnace
  long constant = 100;         ///< u of a furnace
  double width = 0;
};

std::string text(const Instance& x) {
  std::string out = x.surface + ", " + x.map.text() + ", rho";
  for (const long rho : x.reflectivity) out += " " + std::to_string(rho);
  for (const std::array<long, 5>& bend : x.bends) {
    out += " (";
    for (const long c : bend) out += " " + std::to_string(c);
    out += " )";
  }
  if (!x.bends.empty()) out += " power " + std::to_string(x.power);
  out += x.emission.empty() ? ", furnace of " + std::to_string(x.constant) : ", E";
  for (const long e : x.emission) out += " " + std::to_string(e);
  return out + ", width " + shortest(x.width);
}

/// The reflectivity of panel k: with its bends, where that is a reflectivity.
PanelReflectivity reflectivity_on(const Instance& x, std::size_t k, const Panel& panel) {
  const Rational constant = hundredths(x.reflectivity[k]);
  if (x.bends.empty()) return constant;
  PlanePolynomial<Rational> rho(x.power);
  rho(0, 0) = constant;
  rho(1, 0) = hundredths(x.bends[k][0]);
  rho(0, 1) = hundredths(x.bends[k][1]);
  rho(2, 0) = hundredths(x.bends[k][2]);
  rho(1, 1) = hundredths(x.bends[k][3]);
  rho(0, x.power) += hundredths(x.bends[k][4]);
  return reflectivity_of(panel, rho).value_or(constant);
}

/// factor (1 - rho).
PlanePolynomial<Rational> absorbed(const PanelReflectivity& rho, const Rational& factor) {
  return sum(constant_polynomial(factor), -factor, rho.polynomial);
}

PolyhedronProblem problem_of(const Instance& x) {
  PolyhedronProblem out{.panels = convex_panels(default_surface(*find_surface(x.surface))).value(),
                        .reflectivity = {},
                        .emission = {}};
  for (std::size_t k = 0; k < out.panels.size(); ++k) {
    Panel& panel = out.panels[k];
    for (Vector<Rational>& corner : panel.corners) corner = x.map(corner);
    panel.centre = x.map(panel.centre);
    panel.normal = cross(panel.corners[1] - panel.corners[0], panel.corners[2] - panel.corners[0]);
    out.reflectivity.push_back(reflectivity_on(x, k, panel));
    out.emission.push_back(x.emission.empty() ? absorbed(out.reflectivity.back(), hundredths(x.constant))
                                              : constant_polynomial(hundredths(x.emission[k])));
  }
  return out;
}

/// The area of a panel, by its triangles.
long double area(const Panel& panel) {
  long double sum = 0;
  const auto& c = panel.corners;
  for (std::size_t i = 1; i + 1 < c.size(); ++i) {
    const Vector<Rational> n = cross(c[i] - c[0], c[i + 1] - c[0]);
    sum += std::sqrt(static_cast<long double>(dot(n, n).to_double())) / 2;
  }
  return sum;
}

/// Every other time on a tetrahedron, where they cost least: bends, of which some are refused.
void bend(Instance& x, Draw& draw) {
  if (x.surface != "tetrahedron" || draw.below(2) == 0) return;
  x.power = 2 + static_cast<int>(draw.below(7));
  for (std::size_t k = 0; k < x.reflectivity.size(); ++k) {
    std::array<long, 5> own{};
    if (x.reflectivity[k] > 0 && draw.below(4) != 0)
      for (long& c : own) c = static_cast<long>(draw.below(31)) - 15;
    x.bends.push_back(own);
  }
}

Instance drawn(Draw& draw) {
  Instance x;
  const std::array<std::string, 3> surfaces{"tetrahedron", "cube", "octahedron"};
  x.surface = surfaces[draw.below(draw.below(3) == 0 ? 3 : 2)];
  x.map = SkewMap::drawn(draw, 50, 150, 80);
  const std::size_t panels = convex_panels(default_surface(*find_surface(x.surface))).value().size();
  const bool is_furnace = draw.below(2) == 0;
  for (std::size_t k = 0; k < panels; ++k) {
    x.reflectivity.push_back(draw.below(5) == 0 ? (is_furnace ? 0 : 1)
                                                : static_cast<long>(draw.below(85)) + 1);
    if (!is_furnace) x.emission.push_back(draw.below(2) == 0 ? 0 : static_cast<long>(draw.below(300)) - 100);
  }
  x.constant = static_cast<long>(draw.below(400)) - 150;
  x.width = 0.1 * std::pow(10.0, draw.unit());
  bend(x, draw);
  return x;
}

std::vector<Instance> smaller(const Instance& x) {
  std::vector<Instance> out;
  x.map.each_simpler([&](const SkewMap& map) {
    out.push_back(x);
    out.back().map = map;
  });
  return out;
}

std::string off_text(const std::string& what, long double off, double radius) {
  return what + " is off by " + shortest(static_cast<double>(off)) + ", the radius is " + shortest(radius);
}

/// u is constant.
Judgement judge_furnace(const Instance& x) {
  const PolyhedronProblem problem = problem_of(x);
  const double truth = static_cast<double>(x.constant) / 100;
  std::size_t values = 0;
  const std::vector<SolutionPoint> points{
      {0, Rational(1, 5) * (Rational(4) * problem.panels[0].centre + problem.panels[0].corners[0])}};
  for (const GoalEnclosure& found :
       {enclose_means(problem, x.width), enclose_values(problem, points, 4 * x.width)})
    for (const Approximation& number : found.numbers) {
      if (!number.has_radius()) return Judgement::refused();
      const double off = std::abs(number.value - truth);
      if (!number.guaranteed || !(off <= number.radius + 1e-15))
        return Judgement::violated(off_text("u", off, number.radius));
      ++values;
    }
  return Judgement::held(values);
}

/// Int (1/rho - 1) u = Int E/rho for constants; and two enclosures of one number meet.
Judgement judge_balance(const Instance& x) {
  const PolyhedronProblem problem = problem_of(x);
  const GoalEnclosure coarse = enclose_means(problem, 8 * x.width);
  const GoalEnclosure fine = enclose_means(problem, x.width);
  long double left = 0;
  long double right = 0;
  long double radius = 0;
  for (std::size_t k = 0; k < problem.panels.size(); ++k) {
    const Approximation& a = coarse.numbers[problem.panels[k].piece];
    const Approximation& b = fine.numbers[problem.panels[k].piece];
    if (!b.has_radius()) return Judgement::refused();
    const double apart = std::abs(a.value - b.value);
    if (!(apart <= a.radius + b.radius))
      return Judgement::violated(off_text("the coarse mean from the fine one", apart, a.radius + b.radius));
    const long double rho = static_cast<long double>(x.reflectivity[k]) / 100;
    const long double share = area(problem.panels[k]) / rho;
    left += (1 - rho) * share * static_cast<long double>(b.value);
    radius += (1 - rho) * share * static_cast<long double>(b.radius);
    right += share * static_cast<long double>(x.emission[k]) / 100;
  }
  if (!x.bends.empty()) return Judgement::held(problem.panels.size());
  const long double off = std::abs(left - right);
  if (!(off <= radius + 1e-12L * std::abs(right)))
    return Judgement::violated(off_text("the energy", off, static_cast<double>(radius)));
  return Judgement::held(problem.panels.size() + 1);
}

/// A tetrahedron, and a point of a face as weights of its corners.
struct Lit {
  Instance scene;
  std::size_t face = 0;
  std::array<long, 3> weights{1, 1, 1};
};

std::string text_of_lit(const Lit& x) {
  std::string out = text(x.scene) + ", face " + std::to_string(x.face) + ", weights";
  for (const long weight : x.weights) out += " " + std::to_string(weight);
  return out;
}

/// A little skew, and two faces are black: their residuals do not count. The others reflect from `least`
/// hundredths on.
Lit drawn_with_two_faces(Draw& draw, long least, std::size_t range) {
  Lit x{.scene = drawn(draw)};
  x.scene.surface = "tetrahedron";
  x.scene.emission.clear();
  x.scene.bends.clear();
  x.scene.map = SkewMap::drawn(draw, 85, 31, 15);
  x.scene.reflectivity.assign(4, 0);
  x.face = draw.below(4);
  x.scene.reflectivity[x.face] = least + static_cast<long>(draw.below(range));
  x.scene.reflectivity[(x.face + 1 + draw.below(3)) % 4] = least + static_cast<long>(draw.below(range));
  return x;
}

Lit drawn_lit(Draw& draw) {
  Lit x = drawn_with_two_faces(draw, 20, 50);
  x.scene.width = 1;
  for (long& weight : x.weights) weight = 2 + static_cast<long>(draw.below(5));
  bend(x.scene, draw);
  return x;
}

/// With E = 1 - rho on every face u = 1, and u is linear in E: the values lit by two faces each sum to 1.
Judgement judge_lit(const Lit& x) {
  PolyhedronProblem problem = problem_of(x.scene);
  const std::vector<Vector<Rational>>& c = problem.panels[x.face].corners;
  const Rational all(x.weights[0] + x.weights[1] + x.weights[2]);
  const SolutionPoint point{
      x.face, (Rational(1) / all) * (Rational(x.weights[0]) * c[0] + Rational(x.weights[1]) * c[1] +
                                     Rational(x.weights[2]) * c[2])};
  long double sum = 0;
  long double radius = 0;
  for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
    for (std::size_t j = 0; j < problem.panels.size(); ++j)
      problem.emission[j] = absorbed(problem.reflectivity[j], j % 2 == half ? Rational(1) : Rational(0));
    const GoalEnclosure found = enclose_values(problem, {point}, x.scene.width);
    if (!found.numbers[0].has_radius()) return Judgement::refused();
    sum += static_cast<long double>(found.numbers[0].value);
    radius += static_cast<long double>(found.numbers[0].radius);
  }
  const long double off = std::abs(sum - 1);
  if (!(off <= radius + 1e-15L))
    return Judgement::violated(off_text("the sum of the values", off, static_cast<double>(radius)));
  return Judgement::held(2);
}

/// A room around a corner, skewed, of which one piece reflects.
struct Corner {
  SkewMap map;
  std::size_t piece = 0;
  long reflectivity = 0;       ///< of that piece, in hundredths
  std::vector<long> emission;  ///< by piece, in hundredths
  double width = 0;
};

std::string text_of_corner(const Corner& x) {
  std::string out = "a room around a corner, " + x.map.text() + ", piece " + std::to_string(x.piece) +
                    " with rho " + std::to_string(x.reflectivity) + ", E";
  for (const long e : x.emission) out += " " + std::to_string(e);
  return out + ", width " + shortest(x.width);
}

Corner drawn_corner(Draw& draw) {
  Corner x{.map = SkewMap::drawn(draw, 70, 60, 30), .emission = {}};
  x.piece = draw.below(8);
  x.reflectivity = 20 + static_cast<long>(draw.below(60));
  for (std::size_t k = 0; k < 8; ++k)
    x.emission.push_back(draw.below(2) == 0 ? 0 : static_cast<long>(draw.below(200)) - 50);
  x.width = 0.1 + 0.3 * draw.unit();
  return x;
}

std::vector<Panel> room_of(const Corner& x) {
  std::vector<Panel> room = test::l_room();
  for (Panel& panel : room) {
    std::vector<Vector<Rational>> corners;
    for (const Vector<Rational>& corner : panel.corners) corners.push_back(x.map(corner));
    panel = test::panel_with(panel.piece, std::move(corners));
  }
  return room;
}

/// Configuration factors between the pieces of a room, proved by way of the edges of what is seen.
FactorMatrix factors_between_pieces(const std::vector<Panel>& room) {
  TriangleMesh mesh;
  FactorUnits units;
  for (const Panel& panel : test::cut(room)) {
    const std::size_t first = mesh.vertices.size();
    for (const Vector<Rational>& c : panel.corners)
      mesh.vertices.push_back({c.x.to_double(), c.y.to_double(), c.z.to_double()});
    for (std::size_t i = 1; i + 1 < panel.corners.size(); ++i) {
      mesh.triangles.push_back({first, first + i, first + i + 1});
      units.of_triangle.push_back(panel.piece);
    }
  }
  for (std::size_t k = 0; k <= room.back().piece; ++k) units.names.push_back(std::to_string(k));
  return factor_matrix(FacetScene(mesh), units, {.certified = true, .accuracy = 1e-4}, {});
}

/// Where one plane piece reflects, its mean is E + rho sum F E, and that of any other is E.
Judgement judge_corner(const Corner& x) {
  const std::vector<Panel> room = room_of(x);
  std::vector<Rational> rho(8, Rational(0));
  rho[x.piece] = hundredths(x.reflectivity);
  std::vector<Rational> emission;
  for (const long e : x.emission) emission.push_back(hundredths(e));
  const GoalEnclosure found = enclose_means(test::occluded_problem(room, rho, emission), x.width);
  const FactorMatrix factors = factors_between_pieces(room);
  if (!factors.guaranteed) return Judgement::refused();
  for (std::size_t k = 0; k < 8; ++k) {
    long double truth = static_cast<long double>(x.emission[k]) / 100;
    long double radius = 1e-12L;
    for (const ConfigurationFactor& own : factors.entries) {
      if (own.from != k || k != x.piece) continue;
      const long double share = static_cast<long double>(x.reflectivity * x.emission[own.to]) / 10000;
      truth += share * static_cast<long double>(own.factor.value);
      radius += std::abs(share) * static_cast<long double>(own.factor.radius);
    }
    if (!found.numbers[k].has_radius()) return Judgement::refused();
    const long double off = std::abs(static_cast<long double>(found.numbers[k].value) - truth);
    const long double allowed = radius + static_cast<long double>(found.numbers[k].radius);
    if (!(off <= allowed))
      return Judgement::violated(
          off_text("the mean of piece " + std::to_string(k), off, static_cast<double>(allowed)));
  }
  return Judgement::held(8);
}

TEST(SolutionAttack, MeansAroundACornerFollowFromFactors) {
  hold(Attack<Corner>{.name = "means around a corner",
                      .usual_instances = 1,
                      .make = drawn_corner,
                      .judge = judge_corner,
                      .text = text_of_corner});
}

/// Some faces of a polyhedron are openings.
Lit drawn_open(Draw& draw) {
  Lit x = drawn_with_two_faces(draw, 10, 40);
  bend(x.scene, draw);
  return x;
}

/// Without its openings the surface is closed again by black faces. Where they emit 1, or the faces that are
/// there 1 - rho, the functions sum to 1 everywhere.
Judgement judge_open(const Lit& x) {
  const PolyhedronProblem whole = problem_of(x.scene);
  PolyhedronProblem open{};
  for (std::size_t k = 0; k < whole.panels.size(); ++k) {
    if (x.scene.reflectivity[k] == 0) continue;
    open.panels.push_back(whole.panels[k]);
    open.reflectivity.push_back(whole.reflectivity[k]);
    open.emission.push_back(absorbed(whole.reflectivity[k], Rational(1)));
  }
  const std::size_t there = open.panels.size();
  const Outcome<std::vector<Panel>> closing = closing_panels(open.panels, 4);
  if (!closing) return Judgement::violated("no openings: " + closing.reason());
  for (const Panel& panel : *closing) {
    open.panels.push_back(panel);
    open.reflectivity.emplace_back(0);
    open.emission.push_back(constant_polynomial(Rational(0)));
  }
  for (std::size_t k = 0; k < open.panels.size(); ++k) open.panels[k].piece = k;
  PolyhedronProblem through = open;
  for (std::size_t k = 0; k < open.panels.size(); ++k)
    through.emission[k] = constant_polynomial(Rational(k < there ? 0 : 1));
  // So wide that both have the first mesh.
  constexpr double width = 20;
  const FunctionEnclosure inside = enclose_function(open, width, 0.1);
  const FunctionEnclosure outside = enclose_function(through, width, 0.1);
  if (inside.parts.size() != outside.parts.size()) return Judgement::refused();
  for (std::size_t p = 0; p < inside.parts.size(); ++p) {
    const EnclosedPart& a = inside.parts[p];
    const EnclosedPart& b = outside.parts[p];
    for (std::size_t k = 0; k < a.values.size(); ++k) {
      const double off = std::abs(a.values[k] + b.values[k] - 1);
      if (!(off <= (a.bound + b.bound) * (1 + 1e-12)))
        return Judgement::violated(off_text("the sum of the functions", off, a.bound + b.bound));
    }
  }
  return Judgement::held(inside.parts.size());
}

TEST(SolutionAttack, FunctionsOnOpenSurfacesMakeAFurnace) {
  hold(Attack<Lit>{.name = "functions on open surfaces",
                   .usual_instances = 1,
                   .make = drawn_open,
                   .judge = judge_open,
                   .text = text_of_lit});
}

TEST(SolutionAttack, ValuesOnPolyhedraMakeAFurnace) {
  hold(Attack<Lit>{.name = "values on polyhedra",
                   .usual_instances = 1,
                   .make = drawn_lit,
                   .judge = judge_lit,
                   .text = text_of_lit});
}

TEST(SolutionAttack, EnclosuresOnPolyhedraHold) {
  hold(Attack<Instance>{
      .name = "solutions on polyhedra",
      .usual_instances = 2,
      .make = drawn,
      .judge = [](const Instance& x) { return x.emission.empty() ? judge_furnace(x) : judge_balance(x); },
      .text = text,
      .smaller = smaller});
}

}  // namespace
}  // namespace radcert::attack
