// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "radcert/certificate/check.h"
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

/// The area of an element.
inline double element_area(const certificate::MeansCertificate& c, const certificate::Element& x) {
  const std::vector<Vector<Rational>>& p = c.faces[x.face].corners;
  Vector<Rational> sum;
  for (const Vector<Rational>& corner : p) sum = sum + corner;
  const Vector<Rational> inward = Rational(1, static_cast<long>(p.size())) * sum - p[x.side];
  const Vector<Rational> turned = cross(p[(x.side + 1) % p.size()] - p[x.side], inward);
  const double jacobian = std::sqrt(dot(turned, turned).to_double());
  return jacobian * (x.s1 - x.s0) * (x.t1 - x.t0) * (1 - 0.5 * (x.t0 + x.t1));
}

/// A certificate of u = 1 in a furnace, whose functions and residuals are known exactly.
/// Maths     rho = E = 1/2, q_0 = 1 - d: w_0 = 1 - d/2 and t_0 = d/2 by T 1 = 1. q_k = b: w_k = (1 on piece
///           k, else 0, + b)/2, |t_k| <= (1 + b)/2. Claims on an element X: norms slack d/2 (|X|/2)^(1/2)
///           and (1 + b)/2 (|X|/2)^(1/2); Int w_k t_0 = w_k |X| d/2, within room |X|
inline certificate::MeansCertificate furnace_certificate(const std::string& surface, double d, double b,
                                                         double slack, double room) {
  certificate::MeansCertificate c = bare_certificate(surface, 2, 0, 1);
  for (certificate::Face& face : c.faces) face.emission = {{Rational(1, 2)}};
  for (std::size_t i = 0; i < c.coefficients.size(); ++i)
    c.coefficients[i] = i < c.elements.size() ? 1 - d : b;
  for (const certificate::Element& x : c.elements) {
    const double area = element_area(c, x);
    certificate::Claim claim{.norms = std::vector<double>(c.functions(), 0.5 * (1 + b) * std::sqrt(area / 2)),
                             .products = {},
                             .radii = std::vector<double>(c.pieces.size(), room * area)};
    claim.norms[0] = slack * 0.5 * d * std::sqrt(area / 2);
    for (std::size_t k = 0; k < c.pieces.size(); ++k)
      claim.products.push_back(0.5 * ((c.faces[x.face].piece == k ? 1 : 0) + b) * area * 0.5 * d);
    c.claims.push_back(std::move(claim));
  }
  certificate::Summed found = certificate::summed(c);
  c.sums = std::move(found.sums);
  c.means = std::move(found.means);
  for (const certificate::Enclosure& mean : c.means) c.width = std::max(c.width, Rational(2) * mean.radius);
  return c;
}

}  // namespace radcert::test
