// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/certificate/means_certificate.h"
#include "radcert/continuous/goal_enclosure.h"
#include "radcert/continuous/polyhedron_problem.h"
#include "radcert/study/guarantee/means_certificate.h"
#include "tests/continuous/scenes.h"

namespace radcert::test {

inline std::vector<std::string> names_of(const std::string& surface) {
  return named_surface(surface).piece_names();
}

/// Each face with this reflectivity; E constant by face.
inline PolyhedronProblem constant_problem(const std::string& surface, const Rational& rho,
                                          const std::vector<Rational>& emission) {
  PolyhedronProblem out{.panels = panels_of(surface), .reflectivity = {}, .emission = {}};
  for (std::size_t k = 0; k < out.panels.size(); ++k) {
    out.reflectivity.push_back(rho);
    out.emission.push_back(constant_polynomial(emission[k % emission.size()]));
  }
  return out;
}

inline certificate::MeansCertificate certified_means(const PolyhedronProblem& problem,
                                                     const std::string& surface, double wanted) {
  const GoalEnclosure found = enclose_means(problem, wanted, {}, true);
  return means_certificate(problem, names_of(surface), found.proof.get());
}

/// Faces of a surface with elements of two layers and nothing else: no claims are made.
inline certificate::MeansCertificate bare_certificate(const std::string& surface, int layers, int degree,
                                                      std::uint64_t seed) {
  const PolyhedronProblem problem = constant_problem(surface, Rational(1, 2), {1, 0});
  certificate::MeansCertificate out = means_certificate(problem, names_of(surface), nullptr);
  out.elements.clear();
  out.claims.clear();
  out.degree = degree;
  const SectorScene scene(problem.panels);
  const std::vector<SectorElement> elements = graded_elements(scene, layers);
  for (const SectorElement& x : elements) {
    const std::size_t panel = scene.sectors()[x.sector].panel;
    out.elements.push_back({.face = panel,
                            .side = x.sector - scene.first_sector(panel),
                            .s0 = x.box.s0,
                            .s1 = x.box.s1,
                            .t0 = x.box.t0,
                            .t1 = x.box.t1});
  }
  Draw draw(seed);
  out.coefficients.clear();
  for (std::size_t k = 0; k < out.functions(); ++k)
    for (std::size_t e = 0; e < elements.size(); ++e)
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; j <= degree; ++j)
          out.coefficients.push_back((draw() - 0.25) /
                                     static_cast<double>(1U << static_cast<unsigned>(2 * (i + j))));
  return out;
}

}  // namespace radcert::test
