// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/check.h"
#include "radcert/certificate/element_check.h"
#include "radcert/certificate/occlusion/solid_facts.h"
#include "tests/certificate/bench.h"
#include "tests/certificate/ellipsoid_samples.h"
#include "tests/certificate/samples.h"
#include "tests/limits/limits.h"

namespace radcert::limits {
namespace {

/// The certificate of u = 1 in a furnace, q = 1 - 2^-7: a residual of 2^-7 rho - 2^-7, claimed generously.
Answer furnace(bool varies = false) {
  certificate::PolyhedronCertificate c = test::bare_certificate("tetrahedron", 2, 0, 1);
  const Rational half(1, 2);
  for (certificate::Face& face : c.faces) face.emission = {{half}};
  for (std::size_t i = 0; i < c.coefficients.size(); ++i)
    c.coefficients[i] = i < c.elements.size() ? 1 - 0x1p-7 : 0.25;
  // 7/16 + x (1 - x)/6, which its Bernstein coefficients bound by 1/2 after some cuts.
  if (varies)
    for (certificate::Face& face : c.faces) {
      const Rational bent(1, 6);
      face.varying_reflectivity = {{Rational(7, 16), 0, 0}, {bent, 0}, {-bent}};
      face.emission = {{Rational(9, 16), 0, 0}, {-bent, 0}, {bent}};
    }
  c.claims.assign(c.elements.size(), {.norms = std::vector<double>(c.functions(), 1),
                                      .products = std::vector<double>(c.pieces.size()),
                                      .radii = std::vector<double>(c.pieces.size(), 0.05)});
  certificate::Summed sums = certificate::summed(c);
  c.sums = sums.sums;
  c.enclosures = sums.enclosures;
  c.width = Rational(1000);
  const certificate::Report report = certificate::check(c, {.elements = 3, .seed = "furnace"});
  if (report.refusal) return refusal(report.refusal->pointer);
  std::vector<Ball> means;
  for (const certificate::Enclosure& mean : c.enclosures)
    means.push_back(widened(Ball(mean.midpoint), Ball(mean.radius)));
  return numbers(std::move(means));
}

/// The certificate of a furnace on an ellipsoid, q = 1 - d - d Re zeta^6: a residual of 2 d at most.
Answer furnace_on_ellipsoid() {
  constexpr double d = 0x1p-7;
  const certificate::EllipsoidCertificate c = test::furnace_ellipsoid(
      {1, Rational(6, 5), Rational(3, 2)}, Rational(1, 2), d, d, 6, 6 * d, certificate::OnEllipsoid::values);
  const certificate::Report report = certificate::check(c, {.elements = 3, .seed = "furnace"});
  if (report.refusal) return refusal(report.refusal->pointer);
  std::vector<Ball> values;
  for (const certificate::Enclosure& value : c.enclosures)
    values.push_back(widened(Ball(value.midpoint), Ball(value.radius)));
  return numbers(std::move(values));
}

/// A box of which the first ray from the middle of its floor leaves through an edge of the ceiling.
Answer thin_box() {
  certificate::PolyhedronCertificate c = test::bare_certificate("cube", 2, 0, 1);
  for (certificate::Face& face : c.faces)
    for (Vector<Rational>& p : face.corners)
      p = {Rational(1, 101) * (Rational(2) * p.x - Rational(1)), Rational(2) * p.y - Rational(1),
           Rational(2002, 2003) * p.z};
  const std::optional<certificate::Refusal> fault = certificate::solid_fault(c);
  return fault ? refusal(fault->says) : verdict("the boundary of a body");
}

/// What is proved of the residuals of a furnace around a corner, on an element that sees parts in part.
Answer residuals_around_a_corner() {
  const certificate::test::Bench bench(test::furnace_certificate("l_room", 0x1p-7, 0.25, 2, 0.05));
  const certificate::PointKernels kernels(bench.c, bench.scene, bench.densities, bench.sight);
  const certificate::ElementCheck elements(bench.c, bench.scene, bench.densities, bench.lines,
                                           bench.transport, kernels, bench.sight, bench.shades);
  std::vector<Ball> found;
  for (const std::size_t element : {std::size_t{0}, bench.c.elements.size() / 2}) {
    const certificate::ResidualBounds bounds = elements.bounds(element, {.norm = 0.5, .product = 0.5});
    // Of norms that are at most so large.
    for (const double norm : bounds.norms) found.push_back(number(norm / 2, norm / 2));
    for (std::size_t k = 0; k < bounds.products.size(); ++k)
      found.push_back(number(bounds.products[k], bounds.radii[k]));
  }
  return numbers(std::move(found));
}

std::vector<Ball> ones() { return std::vector<Ball>(4, Ball(1)); }

}  // namespace

std::vector<Case> certificate_cases() {
  return {{.limit = "certificate/ball_transport: parts of elements for a group of points",
           .answer = [] { return furnace(); },
           .truth = ones},
          {.limit = "certificate/face_polynomial: parts of a face",
           .answer = [] { return furnace(true); },
           .truth = ones},
          {.limit = "certificate/ellipsoid_check: degree on great circles",
           .answer = furnace_on_ellipsoid,
           .truth = [] { return std::vector<Ball>(2, Ball(1)); }},
          {.limit = "certificate/ray_rule: nodes of a rule",
           .answer = furnace_on_ellipsoid,
           .truth = [] { return std::vector<Ball>(2, Ball(1)); }},
          {.limit = "certificate/solid_facts: rays from a face", .answer = thin_box},
          {.limit = "certificate/sight: parts of faces that are seen in part",
           .answer = residuals_around_a_corner},
          {.limit = "certificate/element_check: cells of an element",
           .answer = [] { return furnace(); },
           .truth = ones}};
}

}  // namespace radcert::limits
