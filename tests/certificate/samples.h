// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "radcert/certificate/check.h"
#include "radcert/certificate/gauss_rule.h"
#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/continuous/goal_enclosure.h"
#include "radcert/continuous/polyhedron_problem.h"
#include "radcert/study/guarantee/polyhedron_certificate.h"
#include "tests/certificate/segments.h"
#include "tests/continuous/rooms.h"
#include "tests/continuous/scenes.h"

namespace radcert::test {

/// Of a room whose parts hide each other, as they are before they are cut; none of other surfaces.
inline std::vector<Panel> room_of(const std::string& surface) {
  if (surface == "l_room") return l_room();
  if (surface == "cube_in_a_cube") return cube_in_a_cube();
  return {};
}

inline std::vector<std::string> names_of(const std::string& surface) {
  std::vector<std::string> names;
  for (const Panel& panel : room_of(surface))
    if (panel.piece == names.size()) names.push_back("piece_" + std::to_string(panel.piece));
  return names.empty() ? named_surface(surface).piece_names() : names;
}

/// Each face with this reflectivity; E constant by face.
inline PolyhedronProblem constant_problem(const std::string& surface, const Rational& rho,
                                          const std::vector<Rational>& emission) {
  PolyhedronProblem out{.panels = {}, .reflectivity = {}, .emission = {}, .blockers = room_of(surface)};
  out.panels = out.blockers.empty() ? panels_of(surface) : cut(out.blockers);
  for (std::size_t k = 0; k < out.panels.size(); ++k) {
    out.reflectivity.push_back(rho);
    out.emission.push_back(constant_polynomial(emission[k % emission.size()]));
  }
  return out;
}

inline certificate::PolyhedronCertificate certified_solution(const PolyhedronProblem& problem,
                                                             const std::string& surface, double wanted) {
  const GoalEnclosure found = enclose_means(problem, wanted, {}, true);
  return polyhedron_certificate(problem, names_of(surface), found.proof.get());
}

/// Faces of a surface with elements of two layers and nothing else: no claims are made.
inline certificate::PolyhedronCertificate bare_certificate(const std::string& surface, int layers, int degree,
                                                           std::uint64_t seed) {
  const PolyhedronProblem problem = constant_problem(surface, Rational(1, 2), {1, 0});
  certificate::PolyhedronCertificate out = polyhedron_certificate(problem, names_of(surface), nullptr);
  out.elements.clear();
  out.claims.clear();
  out.degree = degree;
  const SectorScene scene(problem.panels, problem.blockers);
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
inline double element_area(const certificate::PolyhedronCertificate& c, const certificate::Element& x) {
  const std::vector<Vector<Rational>>& p = c.faces[x.face].corners;
  Vector<Rational> sum;
  for (const Vector<Rational>& corner : p) sum = sum + corner;
  const Vector<Rational> inward = Rational(1, static_cast<long>(p.size())) * sum - p[x.side];
  const Vector<Rational> turned = cross(p[(x.side + 1) % p.size()] - p[x.side], inward);
  const double jacobian = std::sqrt(dot(turned, turned).to_double());
  return jacobian * (x.s1 - x.s0) * (x.t1 - x.t0) * (1 - 0.5 * (x.t0 + x.t1));
}

/// Sums, numbers and the width that follow from claims.
inline void put_sums(certificate::PolyhedronCertificate& c) {
  certificate::Summed found = certificate::summed(c);
  c.sums = std::move(found.sums);
  c.enclosures = std::move(found.enclosures);
  c.width = 0;
  for (const certificate::Enclosure& mean : c.enclosures)
    c.width = std::max(c.width, Rational(2) * mean.radius);
}

/// A certificate of u = 1 in a furnace, whose functions and residuals are known exactly.
/// Maths     rho = E = 1/2, q_0 = 1 - d: w_0 = 1 - d/2 and t_0 = d/2 by T 1 = 1. q_k = b: w_k = (1 on piece
///           k, else 0, + b)/2, |t_k| <= (1 + b)/2. Claims on an element X: norms slack d/2 (|X|/2)^(1/2)
///           and (1 + b)/2 (|X|/2)^(1/2); Int w_k t_0 = w_k |X| d/2, within room |X|
inline certificate::PolyhedronCertificate furnace_certificate(const std::string& surface, double d, double b,
                                                              double slack, double room) {
  certificate::PolyhedronCertificate c = bare_certificate(surface, 2, 0, 1);
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
  put_sums(c);
  return c;
}

/// The inner normal of a face.
inline Vector<double> unit_normal(const certificate::PolyhedronCertificate& c, std::size_t face) {
  const std::vector<Vector<Rational>>& p = c.faces[face].corners;
  const Vector<Rational> n = cross(p[1] - p[0], p[2] - p[0]);
  const double size = std::sqrt(dot(n, n).to_double());
  return {n.x.to_double() / size, n.y.to_double() / size, n.z.to_double() / size};
}

/// G(P,Q)/pi, 0 behind either plane.
inline double kernel_between(const Vector<double>& p, const Vector<double>& normal, const Vector<double>& q,
                             const Vector<double>& other) {
  const Vector<double> way = q - p;
  const double before = dot(normal, way);
  const double behind = -dot(other, way);
  const double squared = dot(way, way);
  return before > 0 && behind > 0 ? before * behind / (squared * squared * 3.14159265358979323846) : 0;
}

/// The same for P of one face and Q of another, by their exact corners.
inline double point_kernel(const certificate::PolyhedronCertificate& c, const certificate::Point& point,
                           std::size_t face, const Vector<double>& q) {
  return kernel_between(rounded(point.at), unit_normal(c, point.face), q, unit_normal(c, face));
}

/// G(P,Q)/pi at Q = m + z e.
inline std::complex<double> point_kernel(const certificate::PolyhedronCertificate& c,
                                         const certificate::Point& point, std::size_t face,
                                         const Vector<double>& m, const Vector<double>& e,
                                         const std::complex<double>& z) {
  const Vector<double> p = rounded(point.at);
  const auto along = [&](const Vector<double>& v) { return dot(v, m - p) + z * dot(v, e); };
  const std::complex<double> squared = dot(m - p, m - p) + 2.0 * z * dot(m - p, e) + z * z * dot(e, e);
  return -along(unit_normal(c, point.face)) * along(unit_normal(c, face)) /
         (squared * squared * 3.14159265358979323846);
}

/// Q of an element at parameters.
inline Vector<double> element_point(const certificate::PolyhedronCertificate& c,
                                    const certificate::Element& x, double s, double t) {
  const std::vector<Vector<Rational>>& p = c.faces[x.face].corners;
  Vector<Rational> sum;
  for (const Vector<Rational>& corner : p) sum = sum + corner;
  const Vector<double> a = rounded(p[x.side]);
  const Vector<double> b = rounded(p[(x.side + 1) % p.size()]);
  const Vector<double> centre = rounded(Rational(1, static_cast<long>(p.size())) * sum);
  return (1 - t) * ((1 - s) * a + s * b) + t * centre;
}

/// (Int_X (j - less)^2)^(1/2), j = V G(P,.)/pi, by 16 x 16 nodes.
inline double kernel_norm(const certificate::PolyhedronCertificate& c, const certificate::Point& point,
                          const certificate::Element& x, double less = 0) {
  const certificate::GaussRule& rule = certificate::gauss_rule(16);
  const Segments segments(c);
  const Vector<double> p = rounded(point.at);
  const Vector<double> normal = unit_normal(c, point.face);
  const Vector<double> other = unit_normal(c, x.face);
  const Vector<double> a = element_point(c, x, 0, 0);
  const Vector<double> b = element_point(c, x, 1, 0);
  const Vector<double> centre = element_point(c, x, 0, 1);
  double sum = 0;
  double whole = 0;
  for (std::size_t m = 0; m < 16; ++m)
    for (std::size_t l = 0; l < 16; ++l) {
      const double t = 0.5 * (x.t0 + x.t1) + 0.5 * (x.t1 - x.t0) * rule.near_nodes[l];
      const double s = 0.5 * (x.s0 + x.s1) + 0.5 * (x.s1 - x.s0) * rule.near_nodes[m];
      const double weight = rule.near_weights[m] * rule.near_weights[l] * (1 - t);
      const Vector<double> q = (1 - t) * ((1 - s) * a + s * b) + t * centre;
      const double j = segments.hidden(p, q) > 0 ? 0 : kernel_between(p, normal, q, other);
      sum += weight * (j - less) * (j - less);
      whole += weight;
    }
  return std::sqrt(sum / whole * element_area(c, x));
}

/// A certificate of the value of u = 1 in a furnace, whose residuals are known.
/// Maths     rho = E = 1/2, q_0 = 1 - d: w_0 = 1 - d/2, t_0 = d/2. q_1 = 0: w_1 = 0 and t_1 = j. Claims on an
///           element X: norms slack d/2 (|X|/2)^(1/2) and slack (Int_X j^2/2)^(1/2), 0.01 where j is 0; Int
///           w_1 t_0 = 0, within room |X|
inline certificate::PolyhedronCertificate furnace_value_certificate(const std::string& surface, double d,
                                                                    double slack, double room) {
  certificate::PolyhedronCertificate c = bare_certificate(surface, 2, 0, 1);
  const std::vector<Vector<Rational>>& corners = c.faces[1].corners;
  c.points = {
      {.face = 1,
       .at = Rational(1, 2) * corners[0] + Rational(1, 5) * corners[1] + Rational(3, 10) * corners[2]}};
  for (certificate::Face& face : c.faces) face.emission = {{Rational(1, 2)}};
  c.coefficients.assign(2 * c.elements.size(), 0);
  std::fill_n(c.coefficients.begin(), c.elements.size(), 1 - d);
  for (const certificate::Element& x : c.elements) {
    const double area = element_area(c, x);
    const double norm = x.face == c.points[0].face ? 0 : kernel_norm(c, c.points[0], x);
    const double of_kernel = norm > 0 ? slack * norm * std::sqrt(0.5) : 0.01;
    c.claims.push_back({.norms = {slack * 0.5 * d * std::sqrt(area / 2), of_kernel},
                        .products = {0},
                        .radii = {room * area}});
  }
  put_sums(c);
  return c;
}

}  // namespace radcert::test
