// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radcert/polynomial/lagrange_functions.h"
#include "radcert/study/study.h"
#include "radcert/triangulation/triangulation.h"
#include "tests/attack/attack.h"
#include "tests/attack/random_problem.h"
#include "tests/geometry/sample_meshes.h"

namespace radcert::attack {

/// A piece, "*" for the rest, and the text of its expression.
using ByPiece = std::vector<std::pair<std::string, std::string>>;

inline ByPiece everywhere(const std::string& text) { return {{"*", text}}; }

/// A random problem with one level.
struct ProblemInstance {
  RandomSurface surface;
  std::optional<sample::Polyhedron> mesh;  ///< takes the place of `surface`
  ByPiece reflectivity;
  ByPiece solution;
  ByPiece emission;  ///< exactly where `solution` is empty
  int level = 0;
  int degree = 1;
  Rational alpha = Rational(1, 6);
  bool symmetric = false;
  std::string nodes{};   ///< a node file's text, which takes the place of degree and alpha
  int interpolated = 0;  ///< the degree, or 0: exact
  bool on_interpolant = false;
  std::string solver = "direct";
  std::optional<Rational> solver_tolerance = std::nullopt;
  Rational tolerance = Rational(1, 10000000);
  Rational grading = Rational(1);
};

/// The problem; InputError where a node file or a mesh is refused.
Problem problem_of(const ProblemInstance& x);

/// All that a reader needs to state the problem.
std::string text(const ProblemInstance& x);

/// The problem's level, or nothing where it is refused with a name. The second route is the program's.
std::optional<LevelOutcome> solved(const Problem& problem);

/// Problems that are smaller, for reports.
std::vector<ProblemInstance> smaller(const ProblemInstance& x);

/// The Lagrange functions of a problem's basis and the triangulation of its level.
LagrangeFunctions functions_of(const Problem& problem);
Triangulation triangulation_of(const Problem& problem, const Surface& surface);

std::string off_text(const std::string& what, double off, double radius);

/// Draws basis, solver, tolerances.
void draw_method(Draw& draw, ProblemInstance& x);

/// A reflectivity that lies in [0, 1) everywhere, on some pieces another than on the rest.
ByPiece random_reflectivity(Draw& draw, const std::vector<std::string>& pieces);

/// A mesh of few triangles: convex, or with parts that hide others; `closed`, or without some of its faces.
sample::Polyhedron random_mesh(Draw& draw, bool occluded, bool closed);

}  // namespace radcert::attack
