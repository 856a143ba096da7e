// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radcert/core/errors.h"
#include "radcert/formats/json/json_document.h"
#include "tests/formats/sample.h"

namespace radcert {
namespace {

/// A key of the root of the sample problem, what stands there instead ("": the key is left out), and what is
/// said.
struct Refusal {
  std::string key;
  std::string value;
  std::string pointer;
  std::string said;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.key << ": " << refusal.value; }

const Refusal refusals[] = {
    {"schema", "", "/schema", "is missing"},
    {"surface", "", "/surface", "is missing"},
    {"triangulation", "", "/triangulation", "is missing"},
    {"basis", "", "/basis", "is missing"},
    {"reflectivity", "", "/reflectivity", "is missing"},
    {"solution", "", "/solution", "so is emission"},
    {"emission", "\"1\"", "/emission", "exactly one of solution and emission"},
    {"schema", "\"radcert/problem/2\"", "/schema", "radcert/problem/1"},
    {"schema", "1", "/schema", "is a number"},
    {"geometri", "\"exact\"", "/geometri", "did you mean geometry?"},
    {"surface", "\"cube\"", "/surface", "is a string"},
    {"surface", "{}", "/surface/name", "is missing"},
    {"surface", R"({"name": "two_peice"})", "/surface/name", "did you mean two_piece?"},
    {"surface", R"({"name": "torus"})", "/surface/name",
     "visibility of curved parts is not available in this version"},
    {"surface", R"({"name": "cylinder", "radius": 0})", "/surface/radius", "a number in [1e-60, 1e60]"},
    {"surface", R"({"name": "spherical_cap", "fraction": 1})", "/surface/fraction", "[1/1000, 999/1000]"},
    {"surface", R"({"name": ["cube"]})", "/surface/name", "is an array"},
    {"surface", R"({"file": "x.off"})", "/surface/file", "is not there"},
    {"surface", R"({"file": "x.step"})", "/surface/file", ".off, .obj, .ply, .stl"},
    {"surface", R"({"file": 3})", "/surface/file", "is a number"},
    {"surface", R"({"file": "x.off", "p": 2})", "/surface/p", "unknown key"},
    {"surface", R"({"file": "x.off", "angle": 181})", "/surface/angle", "from 0 to 180"},
    {"surface", R"({"file": "x.off", "repair": true})", "/surface/repair", "is true or false"},
    {"surface", R"({"name": "cube", "p": 2})", "/surface/p", "unknown key"},
    {"surface", R"({"name": "two_piece", "p": 0.99})", "/surface/p", "a number in [1, 1000]"},
    {"surface", R"({"name": "two_piece", "p": "1/0"})", "/surface/p", "is not a number"},
    {"surface", R"({"name": "two_piece", "p": "two"})", "/surface/p", "is not a number"},
    {"surface", R"({"name": "two_piece", "p": null})", "/surface/p", "is null"},
    {"surface", R"({"name": "box", "a": 0})", "/surface/a", "a number in [1e-60, 1e60]"},
    {"triangulation", "{}", "/triangulation/levels", "is missing"},
    {"triangulation", R"({"levels": []})", "/triangulation/levels", "is empty"},
    {"triangulation", R"({"levels": 3})", "/triangulation/levels", "is a number"},
    {"triangulation", R"({"levels": [0, 1, -2]})", "/triangulation/levels/2", "outside the range"},
    {"triangulation", R"({"levels": [0, 1.5]})", "/triangulation/levels/1", "not a whole number"},
    {"triangulation", R"({"levels": ["0"]})", "/triangulation/levels/0", "is a string"},
    {"triangulation", R"({"levels": [31]})", "/triangulation/levels/0", "from 0 to 30"},
    {"triangulation", R"({"levels": [1e300]})", "/triangulation/levels/0", "outside the range"},
    {"triangulation", R"({"levels": [99999999999999999999]})", "/triangulation/levels/0",
     "outside the range"},
    {"triangulation", R"({"levels": [1, 1]})", "/triangulation/levels/1", "does not ascend"},
    {"triangulation", R"({"levels": [2, 1]})", "/triangulation/levels/1", "does not ascend"},
    {"triangulation", R"({"levels": [0], "pattern": "mian"})", "/triangulation/pattern",
     "did you mean main?"},
    {"triangulation", R"({"levels": [0], "pattern": 1})", "/triangulation/pattern", "is a number"},
    {"triangulation", R"({"levels": [0], "pattern": {"roof": "main", "*": "anti"}})",
     "/triangulation/pattern/roof", "unknown key"},
    {"triangulation", R"({"levels": [0], "pattern": {"upper": "main"}})", "/triangulation/pattern",
     "leaves out"},
    {"triangulation", R"({"levels": [0], "pattern": {"*": "published"}})", "/triangulation/pattern/*",
     "is unknown"},
    {"triangulation", R"({"levels": [0], "grading": "1/2"})", "/triangulation/grading", "a number >= 1"},
    {"triangulation", R"({"levels": [0], "grading": true})", "/triangulation/grading", "is true or false"},
    {"triangulation", R"({"levels": [0], "leves": 1})", "/triangulation/leves", "did you mean levels?"},
    {"geometry", R"({"interpolated": 0})", "/geometry/interpolated", "1 to 6"},
    {"geometry", R"({"interpolated": 7})", "/geometry/interpolated", "1 to 6"},
    {"geometry", R"({"interpolated": 2.5})", "/geometry/interpolated", "a whole number"},
    {"geometry", R"({"interpolated": "2"})", "/geometry/interpolated", "is a string"},
    {"geometry", R"({"interpolated": 2, "data": "surfaces"})", "/geometry/data", "did you mean surface?"},
    {"geometry", R"({"interpolated": 2, "nodes": "surface"})", "/geometry/nodes", "unknown key"},
    {"geometry", R"({"data": "surface"})", "/geometry/interpolated", "is missing"},
    {"geometry", "2", "/geometry", "is a number"},
    {"geometry", "\"flat\"", "/geometry", "is unknown"},
    {"basis", R"("lehtine")", "/basis", "did you mean lehtinen?"},
    {"basis", R"("meshless")", "/basis", "is unknown"},
    {"basis", R"({"family": "shepard", "radius": {"neighbour": 5}})", "/basis/radius", "unknown key"},
    {"basis", R"json({"family": "gaussian", "mother": "exp(-r)"})json", "/basis/mother", "unknown key"},
    {"basis", R"({"family": "gaussian", "radius": "absolute"})", "/basis/radius", "is a string"},
    {"basis", R"({"family": "lehtinen", "radius": {"neighbour": 0}})", "/basis/radius/neighbour",
     "from 1 to 1000000"},
    {"basis", R"({"family": "lehtinen", "radius": {"too_few": "refuse"}})", "/basis/radius/neighbour",
     "is missing"},
    {"basis", R"({"family": "lehtinen", "radius": {"neighbour": 5, "too_few": "nearest"}})",
     "/basis/radius/too_few", "allowed: refuse, farthest"},
    {"basis", R"({"family": "meshless"})", "/basis/mother", "is missing"},
    {"basis", R"json({"family": "meshless", "mother": "exp(-x^2)"})json", "/basis/mother",
     "is no expression in r"},
    {"basis", R"({"family": "meshless", "mother": "spline", "support": 2})", "/basis/support",
     "is not for the mother function spline"},
    {"basis", R"json({"family": "meshless", "mother": "exp(-r)", "support": 0})json", "/basis/support",
     "a number > 0"},
    {"basis", R"json({"family": "meshless", "mother": "exp(-r)", "distance": "euclid"})json",
     "/basis/distance", "allowed: normal_sensitive, euclidean_with_normal_factor, euclidean"},
    {"basis", R"json({"family": "meshless", "mother": "exp(-r)", "radius": 3})json", "/basis/radius",
     "is a number"},
    {"basis", R"json({"family": "meshless", "mother": "exp(-r)", "normalise": true})json", "/basis/normalise",
     "is true or false"},
    {"basis", R"({"family": "shepard", "sites": 400})", "/basis/sites", "is a number"},
    {"basis", R"({"family": "shepard", "sites": {"seed": 1}})", "/basis/sites", "states no sites"},
    {"basis", R"({"family": "shepard", "sites": {"uniform": 9, "poisson_disk": 1}})", "/basis/sites", "both"},
    {"basis", R"({"family": "shepard", "sites": {"uniform": 0}})", "/basis/sites/uniform",
     "outside the range"},
    {"basis", R"({"family": "shepard", "sites": {"uniform": 2.5}})", "/basis/sites/uniform", "whole number"},
    {"basis", R"({"family": "shepard", "sites": {"poisson_disk": "0"}})", "/basis/sites/poisson_disk", "> 0"},
    {"basis", R"({"family": "shepard", "sites": {"poisson_disk": 1, "seed": -1}})", "/basis/sites/seed",
     "whole number >= 0"},
    {"basis", R"({"family": "shepard", "weights": "exact"})", "/basis/weights",
     "allowed: integrated, plane, neighbours, mean_density"},
    {"basis", R"({"family": "shepard", "coefficients": "values"})", "/basis/coefficients",
     "allowed: as_values, interpolated"},
    {"basis", R"({"family": "insert", "degree": 0})", "/basis/family", "did you mean inset?"},
    {"basis", R"({"file": "nodes.json"})", "/basis/file", "is not there"},
    {"basis", R"({"file": 1})", "/basis/file", "is a number"},
    {"basis", R"({"file": "nodes.json", "degree": 1})", "/basis/degree", "unknown key"},
    {"basis", R"({"family": "symmetric", "degree": 7})", "/basis/degree", "from 1 to 6"},
    {"basis", R"({"family": "symmetric"})", "/basis/degree", "is missing"},
    {"basis", R"({"family": "symmetric", "degree": 2, "alpha": 0.1})", "/basis/alpha", "unknown key"},
    {"basis", R"({"family": "inset"})", "/basis/degree", "is missing"},
    {"basis", R"({"family": "inset", "degree": 1})", "/basis/alpha", "is missing"},
    {"basis", R"({"family": "inset", "degree": 11, "alpha": 0.1})", "/basis/degree", "from 0 to 10"},
    {"basis", R"({"family": "inset", "degree": -1, "alpha": 0.1})", "/basis/degree", "from 0 to 10"},
    {"basis", R"({"family": "inset", "degree": 1.5, "alpha": 0.1})", "/basis/degree", "not a whole number"},
    {"basis", R"({"family": "inset", "degree": 1, "alpha": "1/3"})", "/basis/alpha", "[0, 1/3)"},
    {"basis", R"({"family": "inset", "degree": 1, "alpha": 0.5})", "/basis/alpha", "[0, 1/3)"},
    {"basis", R"({"family": "inset", "degree": 1, "alpha": "-0.1"})", "/basis/alpha", "[0, 1/3)"},
    {"basis", R"({"family": "inset", "degree": 1, "alpha": "1/0"})", "/basis/alpha", "is not a number"},
    {"basis", R"({"family": "inset", "degree": 1, "alpha": "0,1"})", "/basis/alpha", "is not a number"},
    {"basis", R"({"family": "inset", "degree": 1, "alpha": ""})", "/basis/alpha", "is not a number"},
    {"basis", R"({"family": "inset", "degree": 1, "alpha": "1e999"})", "/basis/alpha", "is not a number"},
    {"basis", R"({"family": "inset", "degree": 0, "alpha": "1/2"})", "/basis/alpha", "[0, 1/3)"},
    {"basis", R"({"family": "inset", "degree": 0, "alpha": "superconvergent"})", "/basis/alpha",
     "names no number at degree 0"},
    {"basis", R"({"family": "inset", "degree": 2, "alpha": "superconvergent"})", "/basis/alpha",
     "every alpha has degree of precision 3 there and order 4 at the nodes"},
    {"basis", R"({"family": "inset", "degree": 5, "alpha": "superconvergent"})", "/basis/alpha",
     "does not exist: it is proven that no alpha in (0, 1/3) gains a degree of precision"},
    {"basis", R"({"family": "inset", "degree": 1, "alpha": 0.1, "beta": 1})", "/basis/beta", "unknown key"},
    {"reflectivity", "\"1 + \"", "/reflectivity", "column "},
    {"reflectivity", "\"2 x\"", "/reflectivity", "column 3"},
    {"reflectivity", "\"r\"", "/reflectivity", "column 1"},
    {"reflectivity", "\"\"", "/reflectivity", "column 1"},
    {"reflectivity", "null", "/reflectivity", "is null"},
    {"reflectivity", "[\"1\"]", "/reflectivity", "is an array"},
    {"reflectivity", "{}", "/reflectivity", "leaves out the piece lower"},
    {"reflectivity", R"({"lower": "1"})", "/reflectivity", "leaves out the piece upper"},
    {"reflectivity", R"({"lower": "1", "uper": "1"})", "/reflectivity/uper", "did you mean upper?"},
    {"reflectivity", R"({"lower": "1", "*": "sin x"})", "/reflectivity/*", "column 5"},
    {"solution", "\"1/sqrt(x^2 + y^2\"", "/solution", "column 17"},
    {"quadrature", R"({"tolerance": "1e-14"})", "/quadrature/tolerance", "what double can hold"},
    {"quadrature", R"({"tolerance": 0.1})", "/quadrature/tolerance", "is outside the range"},
    {"quadrature", R"({"tolerance": 0})", "/quadrature/tolerance", "is outside the range"},
    {"quadrature", R"({"tolerance": "fine"})", "/quadrature/tolerance", "is not a number"},
    {"quadrature", R"({"order": 7})", "/quadrature/order", "unknown key"},
    {"operator", R"({"name": "h3"})", "/operator/name", "is unknown"},
    {"operator", R"({"tolerance": "1e-9"})", "/operator/name", "is missing"},
    {"operator", R"({"name": "dense", "tolerance": "1e-9"})", "/operator/tolerance", "is not for dense"},
    {"operator", R"({"name": "h2", "tolerance": "1e-14"})", "/operator/tolerance", "what double can hold"},
    {"operator", R"({"name": "h2", "tolerance": 0.5})", "/operator/tolerance", "is outside the range"},
    {"operator", R"({"name": "auto", "rank": 3})", "/operator/rank", "unknown key"},
    {"operator", "\"h2\"", "/operator", "is a string"},
    {"solver", R"({"name": "gmers"})", "/solver/name", "did you mean gmres?"},
    {"solver", R"({"name": "gmres", "tolerance": 0})", "/solver/tolerance", "is outside the range"},
    {"solver", R"({"name": "gmres", "tolerance": "-1e-3"})", "/solver/tolerance", "4.440892098500626e-16"},
    {"solver", R"({"name": "neumann", "tolerance": "4.4e-16"})", "/solver/tolerance", "is outside the range"},
    {"solver", R"({"name": "neumann", "tolerance": 1})", "/solver/tolerance", "to below 1"},
    {"solver", R"({"name": "neumann", "tolerance": "roundoff"})", "/solver/tolerance", "is not a number"},
    {"solver", R"({"name": "neumann", "tolerance": null})", "/solver/tolerance", "is null"},
    {"solver", R"({"name": "gmres", "iterations": 3})", "/solver/iterations", "unknown key"},
    {"solver", R"({"name": "lu"})", "/solver/name", "is unknown"},
    {"solver", "\"direct\"", "/solver", "is a string"},
    {"solver", R"({"name": "direct", "tolerance": 1})", "/solver/tolerance", "is not for"},
    {"solver", R"({"name": "auto", "tolerance": "1e-9"})", "/solver/tolerance", "is not for"},
    {"solver", R"({"name": "verified", "tolerance": "1e-9"})", "/solver/tolerance", "is not for"},
};

class ProblemRefusal : public testing::TestWithParam<Refusal> {};

TEST_P(ProblemRefusal, NamesFilePointerAndWhatIsAllowed) {
  const Refusal& refusal = GetParam();
  JsonValue problem = JsonValue::object();
  const JsonValue sample = parse_json(test::sample_problem_text, "");
  for (const auto& [key, value] : *sample.members())
    if (key != refusal.key) problem.set(key, value);
  if (!refusal.value.empty()) problem.set(refusal.key, parse_json(refusal.value, ""));
  try {
    (void)parse_problem(problem.compact(), "f.json");
    FAIL() << "no exception";
  } catch (const InputError& error) {
    EXPECT_EQ(error.fault().source, "f.json");
    EXPECT_EQ(error.fault().pointer, refusal.pointer);
    EXPECT_THAT(error.what(), testing::HasSubstr(refusal.said));
    EXPECT_FALSE(error.fault().allowed.empty()) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(All, ProblemRefusal, testing::ValuesIn(refusals));

TEST(ParseProblem, RefusesADocumentThatIsNoObject) {
  for (const char* text : {"[]", "1", "\"problem\"", "null"})
    EXPECT_THROW((void)parse_problem(text, "f.json"), InputError) << text;
}

}  // namespace
}  // namespace radcert
