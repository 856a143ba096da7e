// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/sphere_solution.h"

#include <algorithm>
#include <utility>

#include "radcert/enclosure/kernel_integral.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "verification/claims/proved_number.h"

namespace radcert::verification::ac98 {

Rational mean_over_the_sphere(const RationalPolynomial& in_z_squared) {
  Rational sum = 0;
  for (int k = 0; k <= in_z_squared.degree(); ++k)
    sum += in_z_squared.coefficient(static_cast<std::size_t>(k)) / Rational(2 * k + 1);
  return sum;
}

SphereSolution sphere_solution(std::string name, const RationalPolynomial& emission,
                               const RationalPolynomial& reflectivity) {
  const Rational mean = mean_over_the_sphere(emission) / (1 - mean_over_the_sphere(reflectivity));
  return {.name = std::move(name),
          .emission = emission,
          .reflectivity = reflectivity,
          .solution = emission + mean * reflectivity};
}

Rational largest_of_linear(const RationalPolynomial& f) {
  expects(f.degree() <= 1, "a linear polynomial", named("degree", f.degree()));
  return std::max(abs(f(Rational(0))), abs(f(Rational(1))));
}

std::vector<SphereSolution> linear_sphere_solutions() {
  const RationalPolynomial w = RationalPolynomial::variable();
  const RationalPolynomial one = 1;
  std::vector<SphereSolution> solutions;
  const RationalPolynomial varying = Rational(1, 4) * (one + w);
  for (const Rational& rho : {Rational(1, 10), Rational(1, 2), Rational(9, 10)}) {
    const std::string with = ", rho = " + rho.to_text();
    solutions.push_back(sphere_solution("E = 1" + with, one, rho));
    solutions.push_back(sphere_solution("E = z^2" + with, w, rho));
    solutions.push_back(sphere_solution("E = 1 - 2 z^2" + with, one - 2 * w, rho));
  }
  solutions.push_back(sphere_solution("E = 1, rho = (1 + z^2)/4", one, varying));
  solutions.push_back(sphere_solution("E = z^2, rho = (1 + z^2)/4", w, varying));
  return solutions;
}

SphereParts sphere_parts(const SphereSolution& problem, double radius) {
  std::vector<Rational> u;
  for (int k = 0; k <= problem.solution.degree(); ++k)
    u.push_back(problem.solution.coefficient(static_cast<std::size_t>(k)));
  const DensityFormula q = density([u]<class R>(const DensityPoint<R>& at) {
    R sum(0);
    for (std::size_t k = u.size(); k > 0; --k)
      sum = sum * at.point.z * at.point.z + from_rational<R>(u[k - 1]);
    return sum;
  });
  const Rational s(1, 5);
  const Rational t(1, 3);
  const Rational rest = 1 - s - t;
  const Rational w = t * t / (rest * rest + s * s + t * t);
  const Ball integral = known(kernel_integral(ExactObserver::on_surface({{.chart = 0, .at = {s, t}}}),
                                              sphere(), q, {.radius = radius}));
  return {.beyond_emission = Ball(problem.solution(w) - problem.emission(w)),
          .reflected = Ball(problem.reflectivity(w)) / Ball::pi() * integral};
}

}  // namespace radcert::verification::ac98
