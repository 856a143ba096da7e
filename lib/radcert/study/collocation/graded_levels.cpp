// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/collocation/graded_levels.h"

#include "radcert/core/errors.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/triangulation/grading_in_double.h"

namespace radcert {
namespace {

GradingInDouble in_double(const Problem& problem, const Surface& surface, int level) {
  return grading_in_double(surface, problem.triangulation.grading, level);
}

/// "makes elements of the width 1.5e-16 at level 2, which double does not know to 2^-20 of it".
std::string unknown_layers(const Rational& grading, int level) {
  return "makes elements of the width " +
         nearest_text(narrowest_layer(grading, level), DecimalForm::general(2)) + " at level " +
         std::to_string(level) + ", which double does not know to 2^-20 of it";
}

}  // namespace

std::vector<int> rounded_levels(const Problem& problem, const Surface& surface) {
  std::vector<int> out;
  for (const int level : problem.triangulation.levels)
    if (in_double(problem, surface, level) != GradingInDouble::exact) out.push_back(level);
  return out;
}

void require_known_layers(const Problem& problem, const Surface& surface, int level) {
  if (in_double(problem, surface, level) != GradingInDouble::blurred) return;
  const Rational& grading = problem.triangulation.grading;
  const auto most = [&](long places) { return Rational(places, level - 1).to_text(); };
  throw InputError({.pointer = "/triangulation/grading",
                    .value = grading.to_text(),
                    .problem = unknown_layers(grading, level) + ": nothing would be proved of this grading",
                    .allowed = "at level " + std::to_string(level) + " a grading up to " + most(32) +
                               " or a whole number up to " + most(52) + "; or a solver that estimates"});
}

std::vector<std::string> grading_remarks(const Problem& problem, const Surface& surface) {
  std::vector<std::string> out;
  const Rational& grading = problem.triangulation.grading;
  for (const int level : problem.triangulation.levels)
    if (in_double(problem, surface, level) == GradingInDouble::blurred)
      out.push_back("the grading " + grading.to_text() + " " + unknown_layers(grading, level) +
                    ": u_n is that of the rounded triangulation");
  return out;
}

}  // namespace radcert
