// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/problem/problem_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "radcert/core/errors.h"
#include "radcert/formats/json/json_document.h"
#include "tests/formats/sample.h"

namespace radcert {
namespace {

using test::sample_problem_text;

/// The sample with one key of the root replaced or added.
std::string with(const std::string& key, const std::string& value) {
  JsonValue out = JsonValue::object();
  const JsonValue sample = parse_json(sample_problem_text, "");
  for (const auto& [name, old] : *sample.members())
    if (name != key) out.set(name, old);
  out.set(key, parse_json(value, ""));
  return out.compact();
}

TEST(ParseProblem, ReadsTheExampleOfTheFormat) {
  const Problem problem = test::sample_problem();
  EXPECT_EQ(problem.surface.name, "two_piece");
  ASSERT_EQ(problem.surface.parameters.size(), 1U);
  EXPECT_EQ(problem.surface.parameters[0].value, Rational(2));
  EXPECT_EQ(problem.triangulation.levels, (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(problem.triangulation.pattern.empty());
  EXPECT_EQ(problem.triangulation.grading, Rational(1));
  EXPECT_EQ(triangle_basis_of(problem.method).degree, 1);
  EXPECT_EQ(triangle_basis_of(problem.method).alpha, Rational(1, 6));
  EXPECT_EQ(problem.solution->on("upper").text(), "1/sqrt(x^2 + y^2 + (z-1/2)^2)");
  EXPECT_FALSE(problem.emission);
}

TEST(ProblemOf, IsThatOfTheText) {
  const JsonValue document = parse_json(sample_problem_text, "");
  EXPECT_EQ(problem_text(problem_of(document, "sample")), problem_text(test::sample_problem()));
}

TEST(ProblemOf, TakesASurfaceThatStandsBesideTheDocument) {
  const Problem sample = test::sample_problem();
  const JsonValue whole = parse_json(sample_problem_text, "");
  JsonValue rest = JsonValue::object();
  for (const auto& [name, value] : *whole.members())
    if (name != "surface") rest.set(name, value);
  EXPECT_EQ(problem_text(problem_of(rest, "sample", sample.surface)), problem_text(sample));
  EXPECT_THROW(static_cast<void>(problem_of(rest, "sample")), InputError);
  EXPECT_THROW(static_cast<void>(problem_of(whole, "sample", sample.surface)), InputError);
}

TEST(ProblemOf, ResolvesTheGradingWithTheMethodBesideTheDocument) {
  const auto document = [](const std::string& basis) {
    return parse_json(R"({"schema": "radcert/problem/1", "surface": {"name": "cube"}, "reflectivity": "1/2",
        "triangulation": {"levels": [0], "grading": "edges"}, "emission": "1")" +
                          basis + "}",
                      "");
  };
  const JsonValue whole = document(R"(, "basis": {"family": "symmetric", "degree": 2})");
  const Problem stated = problem_of(whole, "sample");
  const JsonValue rest = document("");
  EXPECT_EQ(problem_text(problem_of(rest, "sample", std::nullopt, stated.method)), problem_text(stated));
  EXPECT_GT(stated.triangulation.grading, Rational(4));
  EXPECT_THROW(static_cast<void>(problem_of(rest, "sample")), InputError);
  EXPECT_THROW(static_cast<void>(problem_of(whole, "sample", std::nullopt, stated.method)), InputError);
}

/// The basis on triangles of a problem with this basis.
TriangleBasisChoice triangle_basis_choice(const std::string& text) {
  return triangle_basis_of(parse_problem(with("basis", text), "").method);
}

TEST(ParseProblem, KeepsDecimalsAndFractionsExact) {
  const auto alpha = [](const std::string& text) {
    return triangle_basis_choice(R"({"family": "inset", "degree": 1, "alpha": )" + text + "}").alpha;
  };
  EXPECT_EQ(alpha("\"0.1\""), Rational(1, 10));
  EXPECT_EQ(alpha("0.1"), Rational::exactly(0.1));
  EXPECT_EQ(alpha("\"superconvergent\""), Rational(1, 6));
  EXPECT_EQ(alpha("0"), Rational(0));
}

TEST(ParseProblem, FillsInWhatTheFormatSays) {
  const Problem problem = parse_problem(with("surface", R"({"name": "two_piece"})"), "");
  EXPECT_EQ(problem.surface.parameters[0].value, Rational(2));
  const std::string text = problem_text(problem);
  for (const char* part : {"\"geometry\": \"exact\"", "\"pattern\": \"published\"", "\"grading\": 1",
                           "\"solver\": {\"name\": \"auto\"}"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
}

TEST(ParseProblem, ReadsGalerkinsMethod) {
  const Problem problem = parse_problem(with("basis", R"({"method": "galerkin", "degree": 3})"), "");
  EXPECT_EQ(std::get<Galerkin>(problem.method).degree, 3);
  // Its own default, written out.
  EXPECT_EQ(problem.quadrature.tolerance, Rational(1) / power(Rational(10), 9));
  const Problem again = parse_problem(problem_text(problem), "");
  EXPECT_EQ(problem_text(again), problem_text(problem));
  for (const char* wrong :
       {R"({"method": "galerkin", "degree": 5})", R"({"method": "galerkin"})",
        R"({"method": "nystrom", "degree": 1})", R"({"method": "galerkin", "degree": 1, "alpha": "1/6"})"})
    EXPECT_THROW((void)parse_problem(with("basis", wrong), ""), InputError) << wrong;
}

TEST(ParseProblem, ReadsMeshlessBases) {
  const auto basis = [](const std::string& text) {
    return std::get<Meshless>(parse_problem(with("basis", text), "").method);
  };
  const Meshless own = basis(R"json({"family": "meshless", "mother": "exp(-r^2/2)", "support": "3/2",
      "distance": "euclidean", "radius": {"neighbour": 7, "too_few": "farthest"}, "normalise": "none",
      "sites": {"poisson_disk": "0.1", "seed": 18446744073709551615}, "weights": "mean_density",
      "coefficients": "interpolated"})json");
  EXPECT_EQ(own.basis.mother.to_text(), "exp(-r^2/2)");
  EXPECT_EQ(own.basis.mother.support, Rational(3, 2));
  EXPECT_EQ(own.basis.distance, SiteDistance::euclidean);
  EXPECT_EQ(own.basis.radius.neighbour, 7U);
  EXPECT_EQ(own.basis.radius.too_few, TooFewNeighbours::farthest);
  EXPECT_EQ(own.basis.normalise, Normalisation::none);
  EXPECT_EQ(std::get<PoissonDiskLevels>(own.sites).separation, Rational(1, 10));
  EXPECT_EQ(std::get<PoissonDiskLevels>(own.sites).seed, 18446744073709551615U);
  EXPECT_EQ(own.weights, WeightRule::mean_density);
  EXPECT_EQ(own.coefficients, CoefficientRule::interpolated);

  const Meshless plain = basis(R"({"family": "meshless", "mother": "spline", "radius": "absolute"})");
  EXPECT_EQ(plain.basis.mother.kind, MotherKind::spline);
  EXPECT_FALSE(plain.basis.radius.neighbour);
  EXPECT_EQ(plain.basis.distance, SiteDistance::normal_sensitive);
  EXPECT_EQ(plain.basis.normalise, Normalisation::partition_of_unity);
  EXPECT_EQ(std::get<UniformLevels>(plain.sites).count, 400U);
  EXPECT_EQ(plain.weights, WeightRule::integrated);
  EXPECT_EQ(plain.coefficients, CoefficientRule::as_values);
  EXPECT_EQ(basis(R"json({"family": "meshless", "mother": "exp(-r)"})json").basis.radius.neighbour, 10U);
  EXPECT_FALSE(basis(R"json({"family": "meshless", "mother": "exp(-r)"})json").basis.mother.support);
  EXPECT_FALSE(
      basis(R"({"family": "meshless", "mother": "gaussian", "support": "none"})").basis.mother.support);
  EXPECT_EQ(basis("\"lehtinen\"").basis.normalise, Normalisation::partition_of_unity);
  EXPECT_EQ(basis("\"gaussian\"").basis.mother.support, Rational(4));
  Meshless cut{.family = MeshlessFamily::meshless, .basis = shepard_basis()};
  cut.basis.mother = own_mother(
      "mine", [](double r) { return std::exp(-r); }, Rational(3, 2));
  Problem problem = test::sample_problem();
  problem.method = cut;
  EXPECT_EQ(*problem_json(problem).find("basis")->find("support")->string(), "3/2");
  EXPECT_EQ(basis(R"({"family": "gaussian", "radius": {"neighbour": 5}})").basis.radius.neighbour, 5U);
}

TEST(ProblemJson, WritesMeshlessBasesSoThatTheyAreReadBack) {
  for (const char* basis :
       {"\"shepard\"", "\"gaussian\"", R"({"family": "lehtinen", "sites": {"poisson_disk": "1/3"}})",
        R"json({"family": "meshless", "mother": "exp(-r)", "support": 2, "radius": "absolute"})json",
        R"({"family": "meshless", "mother": "1/r^3"})", R"({"family": "meshless", "mother": "spline"})",
        R"({"family": "meshless", "mother": "shepard"})",
        R"({"family": "meshless", "mother": "gaussian", "support": "none", "weights": "plane"})"}) {
    const std::string once = problem_text(parse_problem(with("basis", basis), ""));
    EXPECT_EQ(problem_text(parse_problem(once, "")), once) << basis;
    for (const char* key : {"\"sites\"", "\"seed\"", "\"weights\"", "\"coefficients\""})
      EXPECT_NE(once.find(key), std::string::npos) << key << " in " << once;
  }
}

TEST(ParseProblem, ReadsTheSolverAndItsTolerance) {
  const auto solver = [](const std::string& text) { return parse_problem(with("solver", text), "").solver; };
  EXPECT_EQ(test::sample_problem().solver.name, "auto");
  EXPECT_EQ(test::sample_problem().matrix.name, "auto");
  EXPECT_EQ(solver(R"({"name": "direct"})").name, "direct");
  EXPECT_EQ(test::sample_problem().quadrature.tolerance, Rational(1, 10000000000000));
  EXPECT_EQ(parse_problem(with("quadrature", R"({"tolerance": "1e-6"})"), "").quadrature.tolerance,
            Rational(1, 1000000));
  EXPECT_EQ(solver(R"({"name": "neumann"})").name, "neumann");
  EXPECT_EQ(solver(R"({"name": "gmres"})").name, "gmres");
  EXPECT_EQ(solver(R"({"name": "verified"})").name, "verified");
  EXPECT_EQ(solver(R"({"name": "gmres"})").tolerance, std::nullopt);
  EXPECT_EQ(solver(R"({"name": "gmres", "tolerance": "rounding"})").tolerance, std::nullopt);
  EXPECT_EQ(solver(R"({"name": "gmres", "tolerance": "1e-10"})").tolerance, Rational(1, 10000000000));
  EXPECT_EQ(solver(R"({"name": "gmres", "tolerance": 1e-10})").tolerance, Rational::exactly(1e-10));
}

TEST(ParseProblem, ReadsTheGuarantee) {
  EXPECT_FALSE(test::sample_problem().guarantee);
  for (const char* text : {R"({"width": "1e-6"})", R"({"width": "1/1000000", "of": "means"})"}) {
    const Problem problem = parse_problem(with("guarantee", text), "");
    ASSERT_TRUE(problem.guarantee);
    EXPECT_EQ(problem.guarantee->width, Rational(1, 1000000));
    EXPECT_EQ(parse_problem(problem_text(problem), "").guarantee->width, Rational(1, 1000000));
  }
  const std::string at = R"({"width": 1, "of": "values", "points": [["1/2", "0.25", 0], ["1", "2", "3"]]})";
  const Problem problem = parse_problem(with("guarantee", at), "");
  for (const Problem& read : {problem, parse_problem(problem_text(problem), "")}) {
    EXPECT_EQ(read.guarantee->of, EnclosedQuantity::values);
    const std::vector<Vector<Rational>> points{{Rational(1, 2), Rational(1, 4), 0}, {1, 2, 3}};
    EXPECT_EQ(read.guarantee->points, points);
  }
  const Problem away =
      parse_problem(with("guarantee", R"({"width": 1, "of": "function", "outside": "1/7"})"), "");
  for (const Problem& read : {away, parse_problem(problem_text(away), "")})
    EXPECT_EQ(read.guarantee->outside, Rational(1, 7));
  const Problem several = parse_problem(
      with("guarantee", R"({"width": 1, "emissions": {"lamp": {"upper": "1", "*": "x"}, "sun": "2"}})"), "");
  for (const Problem& read : {several, parse_problem(problem_text(several), "")}) {
    ASSERT_EQ(read.guarantee->emissions.size(), 2U);
    EXPECT_EQ(read.guarantee->emissions[0].name, "lamp");
    EXPECT_EQ(read.guarantee->emissions[0].emission.on("upper").text(), "1");
    EXPECT_EQ(read.guarantee->emissions[0].emission.on("lower").text(), "x");
    EXPECT_EQ(read.guarantee->emissions[1].emission.on("lower").text(), "2");
  }
  const Problem matrix = parse_problem(with("guarantee", R"({"width": 1, "emissions": "by piece"})"), "");
  ASSERT_EQ(matrix.guarantee->emissions.size(), 2U);
  EXPECT_EQ(matrix.guarantee->emissions[1].emission.on("upper").text(), "1");
  EXPECT_EQ(matrix.guarantee->emissions[1].emission.on("lower").text(), "0");
  for (const char* text :
       {R"({"width": 0})", R"({"width": "-1"})", R"({})", R"({"width": 1, "of": "sums"})",
        R"({"width": 1, "at": 2})", R"({"width": 1, "of": "function", "outside": "-1"})", R"("1e-6")",
        R"({"width": 1, "of": "values", "points": []})", R"({"width": 1, "points": [["1", "2"]]})",
        R"({"width": 1, "points": [["1", "2", "x"]]})", R"({"width": 1, "emissions": {}})",
        R"({"width": 1, "emissions": "by face"})",
        R"({"width": 1, "emissions": {"a": {"roof": "1", "*": "0"}}})"})
    EXPECT_THROW((void)parse_problem(with("guarantee", text), ""), InputError) << text;
  const auto of_points = [](int count) {
    std::string points = R"([0, 0, 0])";
    for (int i = 1; i < count; ++i) points += ", [0, 0, 0]";
    return with("guarantee", R"({"width": 1, "of": "values", "points": [)" + points + "]}");
  };
  EXPECT_EQ(parse_problem(of_points(1000), "").guarantee->points.size(), 1000U);
  try {
    (void)parse_problem(of_points(1001), "");
    ADD_FAILURE() << "1001 points are refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("/guarantee/points: has 1001 points"));
  }
}

TEST(ParseProblem, ReadsTheGeometry) {
  const auto geometry = [](const std::string& text) {
    return parse_problem(with("geometry", text), "").geometry;
  };
  EXPECT_FALSE(geometry("\"exact\"").has_value());
  EXPECT_EQ(geometry(R"({"interpolated": 2})")->degree, 2);
  EXPECT_EQ(geometry(R"({"interpolated": 2})")->data, DataPoints::surface);
  EXPECT_EQ(geometry(R"({"interpolated": 6, "data": "surface"})")->data, DataPoints::surface);
  EXPECT_EQ(geometry(R"({"interpolated": 6, "data": "interpolant"})")->degree, 6);
  EXPECT_EQ(geometry(R"({"interpolated": 6, "data": "interpolant"})")->data, DataPoints::interpolant);
}

TEST(ParseProblem, LeavesAlphaOutAtDegreeZeroOnly) {
  EXPECT_EQ(triangle_basis_choice(R"({"family": "inset", "degree": 0})").alpha, std::nullopt);
  EXPECT_EQ(triangle_basis_choice(R"({"family": "inset", "degree": 0, "alpha": "0.2"})").alpha,
            Rational(1, 5));
}

TEST(ParseProblem, FindsTheSuperconvergentAlpha) {
  const TriangleBasisChoice one =
      triangle_basis_choice(R"({"family": "inset", "degree": 1, "alpha": "superconvergent"})");
  EXPECT_EQ(one.alpha, Rational(1, 6));
  EXPECT_FALSE(one.alpha_is_near);
  const TriangleBasisChoice three =
      triangle_basis_choice(R"({"family": "inset", "degree": 3, "alpha": "superconvergent"})");
  EXPECT_TRUE(three.alpha_is_near);
  // (7 - sqrt 34)/15
  EXPECT_EQ(three.alpha->to_double(), 0.07793654034364664);
}

TEST(ParseProblem, TakesOneExpressionAPiece) {
  const Problem problem = parse_problem(with("reflectivity", R"({"lower": 0.5, "*": "x/4"})"), "");
  EXPECT_EQ(problem.reflectivity.on("lower").is_constant(), Rational(1, 2));
  EXPECT_EQ(problem.reflectivity.on("upper").text(), "x/4");
}

TEST(ProblemText, StatesTheSameProblemAgain) {
  const std::string problems[] = {
      sample_problem_text,
      with("surface", R"({"name": "two_piece", "p": "5/2"})"),
      with("surface", R"({"name": "two_piece", "p": 1.1})"),
      with("reflectivity", "0.1"),
      with("reflectivity", "1e-300"),
      with("reflectivity", R"({"lower": "-x", "upper": 3e-7})"),
      with("triangulation", R"({"levels": [7], "pattern": "anti", "grading": "1.5"})"),
      with("triangulation", R"({"levels": [0, 30], "pattern": {"upper": "main", "*": "anti"}})"),
      with("basis", R"({"family": "inset", "degree": 0})"),
      with("basis", R"({"family": "inset", "degree": 1, "alpha": "superconvergent"})"),
      with("basis", R"({"family": "inset", "degree": 3, "alpha": "superconvergent"})"),
      with("basis", R"({"family": "symmetric", "degree": 2})"),
      with("geometry", R"({"interpolated": 1})"),
      with("geometry", R"({"data": "interpolant", "interpolated": 4})"),
      with("quadrature", R"({"tolerance": "1e-6"})"),
      with("operator", R"({"name": "h2", "tolerance": "1e-9"})"),
      with("operator", R"({"name": "auto"})"),
      with("operator", R"({"name": "auto", "tolerance": "1e-9"})"),
      with("operator", R"({"name": "dense"})"),
      with("quadrature", R"({"tolerance": 1e-6})"),
      with("solver", R"({"name": "neumann"})"),
      with("solver", R"({"name": "verified"})"),
      with("solver", R"({"name": "gmres", "tolerance": "1e-10"})"),
      with("solver", R"({"name": "gmres", "tolerance": 1e-10})"),
  };
  for (const std::string& text : problems) {
    const std::string once = problem_text(parse_problem(text, "first"));
    EXPECT_EQ(problem_text(parse_problem(once, "second")), once) << text;
  }
}

TEST(ProblemText, KeepsTheExactValuesOfNumbers) {
  const auto reflectivity = [](const std::string& text) {
    const Problem once = parse_problem(with("reflectivity", text), "");
    const Problem again = parse_problem(problem_text(once), "");
    EXPECT_EQ(once.reflectivity.on("upper").is_constant(), again.reflectivity.on("upper").is_constant())
        << text;
    return again.reflectivity.on("upper").is_constant();
  };
  EXPECT_EQ(reflectivity("0.1"), Rational::exactly(0.1));
  EXPECT_EQ(reflectivity("\"0.1\""), Rational(1, 10));
  EXPECT_EQ(reflectivity("1e-300"), Rational::exactly(1e-300));
  EXPECT_EQ(reflectivity("\"1/3\""), Rational(1, 3));
  EXPECT_EQ(reflectivity("1"), Rational(1));
}

}  // namespace
}  // namespace radcert
