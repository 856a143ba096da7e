// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/guarantee.h"

#include <string>
#include <utility>
#include <vector>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/expression/parse.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/certified_solution.h"
#include "radcert/study/guarantee/enclosed_problem.h"
#include "radcert/study/problem.h"
#include "radcert/study/result.h"
#include "radcert/surface/own_surface.h"

namespace radcert {
namespace {

std::unique_ptr<EnclosedProblem> enclosed_problem(const Problem& problem, const Guarantee& guarantee) {
  if (problem.geometry)
    throw InputError({.pointer = "/geometry",
                      .problem = "is an interpolant, whose solution is not that of the surface",
                      .allowed = "nothing here beside a guarantee"});
  if (!problem.emission)
    throw InputError({.pointer = "/solution",
                      .problem = "is given, and then u is known: there is nothing to enclose",
                      .allowed = "emission"});
  if (guarantee.of != EnclosedQuantity::values && !guarantee.points.empty())
    throw InputError({.pointer = "/guarantee/points",
                      .problem = "are for values, which are not asked for",
                      .allowed = "\"of\": \"values\" beside points"});
  require_normal(guarantee.width, "/guarantee/width");
  Surface surface = surface_of(problem);
  if (!is_known_in_balls(surface))
    throw InputError(
        {.pointer = "/surface",
         .value = surface.name,
         .problem = "has charts that are known by their values alone, of which nothing is proved",
         .allowed = "a surface of the catalogue or of a mesh"});
  const bool is_ellipsoid = surface.name == "sphere" || surface.name == "ellipsoid";
  if (guarantee.outside && (guarantee.of != EnclosedQuantity::function || is_ellipsoid))
    throw InputError({.pointer = "/guarantee/outside",
                      .value = guarantee.outside->to_text(),
                      .problem = is_ellipsoid ? "is a distance from vertices, of which there are none"
                                              : "is for a function, which is not asked for",
                      .allowed = "\"of\": \"function\" on a polyhedron beside outside"});
  if (!guarantee.emissions.empty() && (is_ellipsoid || guarantee.of == EnclosedQuantity::function))
    throw InputError({.pointer = "/guarantee/emissions",
                      .problem = is_ellipsoid ? "are for polyhedra" : "are not for a function",
                      .allowed = "means or values on a polyhedron beside further emissions"});
  if (is_ellipsoid && !surface.mesh) return enclosed_ellipsoid(problem, guarantee, std::move(surface));
  return enclosed_polyhedron(problem, guarantee, std::move(surface));
}

std::unique_ptr<EnclosedProblem> certified_problem(const Problem& problem, const Guarantee& guarantee) {
  std::unique_ptr<EnclosedProblem> enclosed = enclosed_problem(problem, guarantee);
  std::vector<std::string> hindrances = enclosed->certificate_hindrances();
  if (!guarantee.emissions.empty())
    hindrances.insert(hindrances.begin(), "the guarantee has further emissions");
  if (hindrances.empty()) return enclosed;
  std::string all;
  for (const std::string& hindrance : hindrances) all += (all.empty() ? "" : "; ") + hindrance;
  throw InputError(
      {.source = "--certificate",
       .problem = "is not made here: " + all,
       .allowed = "one emission, on a polyhedron a polynomial of degree 8 or less on each piece"});
}

}  // namespace

void say_width_of_certificate(const Rational& width, const Guarantee& guarantee,
                              SolutionEnclosure& enclosure) {
  if (width <= guarantee.width)
    enclosure.hindrance.clear();
  else if (enclosure.hindrance.empty())
    enclosure.hindrance = "the certificate has the width " + upper_text(width);
}

std::string coordinates_text(const Vector<Rational>& p) {
  return "(" + p.x.to_text() + ", " + p.y.to_text() + ", " + p.z.to_text() + ")";
}

void require_width(const Guarantee& guarantee, double relative, const Rational& size) {
  const Rational least = Rational::exactly(relative) * size;
  if (guarantee.width >= least && guarantee.width.sign() > 0) return;
  throw InputError({.pointer = "/guarantee/width",
                    .value = guarantee.width.to_text(),
                    .problem = "is less than double can carry here",
                    .allowed = upper_text(least) + " or more"});
}

void require_normal(const Rational& value, const std::string& pointer) {
  if (value.sign() == 0) return;
  const Rational most = power(Rational(10), 60);
  if (abs(value) <= most && abs(value) * most >= Rational(1)) return;
  throw InputError({.pointer = pointer,
                    .value = nearest_text(value, DecimalForm::general(6)),
                    .problem = "is too large or too small for a guarantee",
                    .allowed = "sizes from 1e-60 to 1e60"});
}

std::vector<NamedEmission> emissions_by_piece(const std::vector<std::string>& pieces) {
  std::vector<NamedEmission> out;
  for (const std::string& own : pieces) {
    NamedEmission emission{.name = own, .emission = {}};
    emission.emission.cases.push_back({own, parse_expression("1").value()});
    if (pieces.size() > 1) emission.emission.cases.push_back({"*", parse_expression("0").value()});
    out.push_back(std::move(emission));
  }
  return out;
}

void check_guarantee(const Problem& problem, const Guarantee& guarantee) {
  if (problem.iterated)
    throw InputError({.pointer = "/iterated",
                      .value = "true",
                      .problem = "is of u_n, and a guarantee is of u itself",
                      .allowed = "one of the two"});
  static_cast<void>(enclosed_problem(problem, guarantee));
}

std::pair<LevelResult, SolutionEnclosure> solve_within(const Problem& problem, const Guarantee& guarantee,
                                                       const GuaranteeListener& progress) {
  return solve_within(problem, guarantee, GuaranteeContext{.progress = progress});
}

std::pair<LevelResult, SolutionEnclosure> solve_within(const Problem& problem, const Guarantee& guarantee,
                                                       const GuaranteeContext& context) {
  return enclosed_problem(problem, guarantee)->solve(context);
}

CertifiedSolution certified_solution(const Problem& problem, const Guarantee& guarantee,
                                     const GuaranteeContext& context) {
  return certified_problem(problem, guarantee)->certified(context);
}

void check_certified(const Problem& problem, const Guarantee& guarantee) {
  static_cast<void>(certified_problem(problem, guarantee));
}

}  // namespace radcert
