// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/attack/problem_instance.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/expression/parse.h"
#include "radcert/formats/problem/node_file.h"
#include "radcert/geometry/mesh_file/mesh_file.h"
#include "radcert/hypotheses/mesh_survey.h"
#include "radcert/polynomial/inset_basis.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/solve/linear_solver.h"

namespace radcert::attack {
namespace {

PiecewiseExpression expression_of(const ByPiece& cases) {
  PiecewiseExpression function;
  for (const auto& [piece, expression] : cases)
    function.cases.push_back({piece, parse_expression(expression).value()});
  return function;
}

SurfaceChoice surface_choice(const ProblemInstance& x) {
  if (x.mesh) {
    const MeshFile file = parse_mesh_file(sample::off_text(*x.mesh), "random.off");
    const MeshSurvey survey = survey_mesh(file, default_sharp_degrees, {});
    if (const auto obstacle = survey.obstacle())
      throw InputError({.pointer = "/surface/file",
                        .value = "random.off",
                        .problem = *obstacle,
                        .allowed = "a mesh of triangles that do not cross"});
    return {.name = "random.off",
            .parameters = {},
            .mesh = MeshChoice{.file = "random.off",
                               .digest = survey.digest,
                               .angle = Rational::exactly(default_sharp_degrees),
                               .repair = {},
                               .mended = {},
                               .surface = std::make_shared<const Surface>(survey.surface("random.off"))}};
  }
  SurfaceChoice choice{.name = x.surface.description->name, .parameters = {}};
  for (std::size_t i = 0; i < x.surface.values.size(); ++i)
    choice.parameters.push_back({x.surface.description->parameters[i].name, x.surface.values[i]});
  return choice;
}

TriangleBasisChoice basis_choice(const ProblemInstance& x) {
  if (!x.nodes.empty()) {
    NodeFile file = parse_nodes(x.nodes, "random.json");
    const int degree = file.functions.degree();
    return {.degree = degree,
            .alpha = std::nullopt,
            .family = NodeFamily::file,
            .file = "random.json",
            .functions = std::make_shared<const LagrangeFunctions>(std::move(file.functions))};
  }
  if (x.symmetric)
    return {.degree = x.degree,
            .alpha = std::nullopt,
            .family = NodeFamily::symmetric,
            .functions = std::make_shared<const LagrangeFunctions>(
                lagrange_functions(symmetric_nodes(x.degree).nodes()).value())};
  return {.degree = x.degree, .alpha = x.alpha};
}

std::string text(const ByPiece& cases) {
  std::string out;
  for (const auto& [piece, expression] : cases) {
    out += out.empty() ? "" : "; ";
    out += piece == "*" ? expression : piece + ": " + expression;
  }
  return out;
}

/// Nodes at random places of a lattice inside the triangle, not always unisolvent, some of them close to each
/// other.
std::string random_nodes(Draw& draw) {
  const std::vector<std::string> spaces{
      R"("degree": 0)",
      R"("degree": 1)",
      R"("degree": 2)",
      R"("space": ["1", "x1"])",
      R"("space": ["1", "x1", "x2", "x1*x2*x3"])",
      R"("space": ["1", "x1*x2", "x2*x3^2"])",
      R"("space": ["1", "x1", "x2", "x1^3", "x2^3"])",
  };
  const std::vector<std::size_t> counts{1, 3, 6, 2, 4, 3, 5};
  const std::size_t k = draw.below(spaces.size());
  const std::vector<std::size_t> lattices{5, 7, 12, 100, 65536};
  const std::size_t n = lattices[draw.below(lattices.size())];
  std::string nodes;
  for (std::size_t i = 0; i < counts[k]; ++i) {
    const std::size_t a = 1 + draw.below(n - 3);
    const std::size_t b = 1 + draw.below(n - a - 1);
    const auto part = [n](std::size_t m) { return '"' + std::to_string(m) + "/" + std::to_string(n) + '"'; };
    nodes += (i > 0 ? ", [" : "[") + part(a) + ", " + part(b) + ", " + part(n - a - b) + "]";
  }
  return R"({"schema": "radcert/nodes/1", )" + spaces[k] + R"(, "nodes": [)" + nodes + "]}";
}

}  // namespace

Problem problem_of(const ProblemInstance& x) {
  // One by one: GCC 12 destroys the members of a nested aggregate twice where a later initializer throws.
  Problem problem;
  problem.surface = surface_choice(x);
  problem.triangulation = {.levels = {x.level}, .pattern = {}, .grading = x.grading};
  problem.method = Collocation{basis_choice(x)};
  problem.reflectivity = expression_of(x.reflectivity);
  problem.solver = {.name = x.solver, .tolerance = std::nullopt};
  if (find_linear_solver(x.solver)->iterates()) problem.solver.tolerance = x.solver_tolerance;
  if (x.solution.empty())
    problem.emission = expression_of(x.emission);
  else
    problem.solution = expression_of(x.solution);
  problem.quadrature.tolerance = x.tolerance;
  if (x.interpolated > 0)
    problem.geometry = InterpolatedGeometry{
        .degree = x.interpolated, .data = x.on_interpolant ? DataPoints::interpolant : DataPoints::surface};
  return problem;
}

std::string text(const ProblemInstance& x) {
  std::string out = x.mesh ? sample::off_text(*x.mesh) : x.surface.text();
  out += ", level " + std::to_string(x.level);
  if (x.grading != Rational(1)) out += ", grading " + x.grading.to_text();
  if (!x.nodes.empty())
    out += ", nodes " + x.nodes;
  else
    out += ", degree " + std::to_string(x.degree) +
           (x.symmetric ? ", symmetric" : ", alpha " + x.alpha.to_text());
  out += ", rho = " + text(x.reflectivity);
  out += x.solution.empty() ? ", E = " + text(x.emission) : ", u = " + text(x.solution);
  out += ", " + x.solver;
  if (x.solver_tolerance) out += " to " + x.solver_tolerance->to_text();
  out += ", tolerance " + x.tolerance.to_text();
  if (x.interpolated > 0)
    out += ", interpolated by degree " + std::to_string(x.interpolated) +
           (x.on_interpolant ? ", data of the interpolant" : "");
  return out;
}

std::optional<LevelOutcome> solved(const Problem& problem) {
  try {
    check(problem, std::uint64_t{1} << 32U);
    return solve_level(problem, problem.triangulation.levels.front(), reference::applied_operator);
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const AccuracyNotReached&) {
    return std::nullopt;
  }
}

std::vector<ProblemInstance> smaller(const ProblemInstance& x) {
  std::vector<ProblemInstance> found;
  const auto with = [&](const auto& change) {
    found.push_back(x);
    change(found.back());
  };
  if (x.level > 0) with([](ProblemInstance& y) { y.level = 0; });
  if (x.grading != Rational(1)) with([](ProblemInstance& y) { y.grading = 1; });
  if (!x.nodes.empty() || x.symmetric)
    with([](ProblemInstance& y) {
      y.nodes = {};
      y.symmetric = false;
    });
  else if (x.degree > 0)
    with([](ProblemInstance& y) {
      y.degree = 0;
      y.alpha = 0;
    });
  if (x.nodes.empty() && x.degree > 1) with([](ProblemInstance& y) { y.degree = 1; });
  if (x.interpolated > 0) with([](ProblemInstance& y) { y.interpolated = 0; });
  if (x.solver != "direct") with([](ProblemInstance& y) { y.solver = "direct"; });
  if (!x.solution.empty() && text(x.reflectivity) != "1/2")
    with([](ProblemInstance& y) { y.reflectivity = everywhere("1/2"); });
  if (!x.mesh)
    for (std::size_t i = 0; i < x.surface.values.size(); ++i)
      if (x.surface.values[i] != Rational(1) && x.surface.description->parameters[i].admits(Rational(1)))
        with([i](ProblemInstance& y) { y.surface.values[i] = 1; });
  return found;
}

LagrangeFunctions functions_of(const Problem& problem) {
  if (triangle_basis_of(problem.method).functions) return *triangle_basis_of(problem.method).functions;
  return lagrange_functions(inset_nodes(triangle_basis_of(problem.method).degree,
                                        triangle_basis_of(problem.method).alpha.value_or(Rational(0))))
      .value();
}

Triangulation triangulation_of(const Problem& problem, const Surface& surface) {
  TriangulationOptions options;
  options.grading = problem.triangulation.grading.to_double();
  return triangulate(surface, problem.triangulation.levels.front(), options);
}

std::string off_text(const std::string& what, double off, double radius) {
  return what + " is off by " + shortest(off) + ", radius " + shortest(radius);
}

void draw_method(Draw& draw, ProblemInstance& x) {
  const std::vector<int> degrees{0, 0, 1, 1, 1, 2, 2, 3};
  x.degree = degrees[draw.below(degrees.size())];
  const std::vector<Rational> alphas{Rational(1, 6),   Rational(1, 10),     Rational(3, 10),
                                     Rational(1, 100), Rational(1, 100000), Rational(333, 1000),
                                     Rational(0)};
  x.alpha = x.degree == 0 ? Rational(0) : alphas[draw.below(alphas.size())];
  switch (draw.below(6)) {
    case 0:
      x.symmetric = true;
      x.degree = static_cast<int>(1 + draw.below(3));
      break;
    case 1: x.nodes = random_nodes(draw); break;
    default: break;
  }
  if (x.degree < 2 && x.nodes.empty() && draw.below(10) == 0) x.level = 1;
  const std::vector<std::string> solvers =
      solver_names([](const LinearSolver& each) { return each.iterates() || each.eliminate; });
  x.solver = solvers[draw.below(solvers.size())];
  if (draw.below(4) == 0)
    x.solver_tolerance =
        std::vector{Rational(1, 1000), Rational(1, 100000000), Rational(9, 10)}[draw.below(3)];
  x.tolerance = std::vector{Rational(1, 1000), Rational(1, 1000000), Rational(1, 10000000000000),
                            Rational(1, 10000000000)}[draw.below(4)];
}

ByPiece random_reflectivity(Draw& draw, const std::vector<std::string>& pieces) {
  const auto one = [&draw]() -> std::string {
    switch (draw.below(10)) {
      case 0: return "0";
      case 1: return "0.999";
      case 2: return "1/1000";
      case 3: return "1/2 + sin(x + 2*y)/5";
      case 4: return "9/10/(1 + x^2 + z^4)";
      case 5: return "abs(x - 1/3)/(1 + abs(x - 1/3))";
      case 6: return "0.99*exp(-abs(z))";
      case 7: return "max(0, min(0.9, x*y + z))";
      case 8: return "9/10";
      default: return "1/2";
    }
  };
  ByPiece cases = everywhere(one());
  if (draw.below(2) == 0)
    for (std::size_t k = 1 + draw.below(3); k > 0; --k) {
      const std::string& piece = pieces[draw.below(pieces.size())];
      if (std::none_of(cases.begin(), cases.end(), [&](const auto& c) { return c.first == piece; }))
        cases.insert(draw.below(2) == 0 ? cases.begin() : cases.end(), {piece, one()});
    }
  return cases;
}

namespace {

/// A polygon around the middle, star-shaped, on a lattice of sixteenths.
sample::Polyhedron random_column(Draw& draw, bool convex) {
  const std::size_t sides = 3 + draw.below(4);
  std::vector<std::pair<double, double>> base;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 6.28 * static_cast<double>(i) / static_cast<double>(sides);
    const double radius = convex ? 1 : 0.3 + draw.unit();
    base.emplace_back(std::round(64 * radius * std::cos(angle)) / 16,
                      std::round(64 * radius * std::sin(angle)) / 16);
  }
  return sample::column(base, std::ldexp(1 + draw.unit(), static_cast<int>(draw.below(6)) - 3));
}

double stretch(Draw& draw) {
  return draw.below(2) == 0 ? 1.0 : std::ldexp(1 + draw.unit(), static_cast<int>(draw.below(16)) - 8);
}

}  // namespace

sample::Polyhedron random_mesh(Draw& draw, bool occluded, bool closed) {
  sample::Polyhedron p;
  bool of_triangles = false;
  if (!occluded) {
    const std::size_t shape = draw.below(4);
    p = shape == 0   ? sample::tetrahedron()
        : shape == 1 ? sample::octahedron(0.25 + draw.unit())
        : shape == 2 ? sample::cube()
                     : random_column(draw, true);
    of_triangles = shape < 2;
  } else {
    const std::size_t shape = draw.below(5);
    const double side = 0.125 + 0.5 * draw.unit();
    const auto place = [&] {
      const double rest = 1 - side;
      return draw.below(3) > 0 ? rest * (0.05 + 0.9 * draw.unit())
                               : rest * std::ldexp(1.0, -static_cast<int>(draw.below(20)) - 1);
    };
    switch (shape) {
      case 0: p = sample::l_shaped_room(); break;
      case 1:
        p = sample::octahedron(-0.9 * draw.unit());
        of_triangles = true;
        break;
      case 2: {
        const double a = place();
        const double b = place();
        p = sample::cube_in_cube(side, {a, b, place()});
        break;
      }
      case 3: {  // a tetrahedron in a tetrahedron, turned
        sample::Polyhedron inner = sample::tetrahedron();
        for (auto& v : inner.vertices)
          v = {0.1 + 0.2 * v.x + 0.05 * v.y, 0.1 + 0.2 * v.y - 0.05 * v.z, 0.1 + 0.2 * v.z + 0.05 * v.x};
        p = sample::together(sample::tetrahedron(), inner, true);
        of_triangles = true;
        break;
      }
      default: p = random_column(draw, false);
    }
  }
  const Vector<double> by{stretch(draw), stretch(draw), stretch(draw)};
  for (auto& v : p.vertices) v = {v.x * by.x, v.y * by.y, v.z * by.z};
  if (of_triangles && draw.below(2) == 0) {  // sheared and moved; other faces would not stay plane
    const double shear = draw.unit();
    const double off = draw.below(2) == 0 ? 0.0 : std::ldexp(draw.unit(), static_cast<int>(draw.below(20)));
    for (auto& v : p.vertices) v = {v.x + shear * v.y + off, v.y - shear * v.z, v.z - off};
  }
  if (!closed)
    for (std::size_t k = 1 + draw.below(p.faces.size() / 2); k > 0; --k)
      p.faces.erase(p.faces.begin() + static_cast<std::ptrdiff_t>(draw.below(p.faces.size())));
  return p;
}

}  // namespace radcert::attack
