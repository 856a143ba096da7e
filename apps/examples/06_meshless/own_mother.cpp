// SPDX-License-Identifier: GPL-3.0-or-later

// A mother function as a type of one's own: the problem of problem.json, solved with it, and with the
// expression that says the same. One template serves doubles, and balls where something is to be proved.
#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <span>

#include "radcert/formats/problem/problem_json.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/study.h"

namespace {

using namespace radcert;

/// Wendland's function, twice continuously differentiable and 0 from r = 1 on: (1 - r)^4 (4r + 1).
struct Wendland {
  template <Field R>
  R operator()(const R& r) const {
    return select_less(r, R(1), R(power(R(1) - r, 4) * (R(4) * r + R(1))), R(0));
  }
};

}  // namespace

int main() try {
  const Problem by_expression = read_problem(MESHLESS_PROBLEM);
  Problem by_type = by_expression;
  std::get<Meshless>(by_type.method).basis.mother = own_mother("wendland", Wendland{}, Rational(1));
  double largest = 0;
  for (const int level : {0, 1}) {
    const LevelResult expected = solve_level(by_expression, level, reference::applied_operator).result;
    const LevelResult found = solve_level(by_type, level, reference::applied_operator).result;
    std::cout << found.unknowns << " sites: error " << found.uniform_error->value << " on the sample\n";
    largest = std::max(largest, std::abs(found.uniform_error->value - expected.uniform_error->value));
  }
  std::cout << (largest < 1e-9 ? "the type and the expression agree" : "the type and the expression differ")
            << '\n';
  return largest < 1e-9 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
