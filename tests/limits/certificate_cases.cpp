// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/check.h"
#include "tests/certificate/samples.h"
#include "tests/limits/limits.h"

namespace radcert::limits {
namespace {

/// The certificate of u = 1 in a furnace, q = 1 - 2^-7: a residual of 2^-7 rho - 2^-7, claimed generously.
Answer furnace() {
  certificate::PolyhedronCertificate c = test::bare_certificate("tetrahedron", 2, 0, 1);
  const Rational half(1, 2);
  for (certificate::Face& face : c.faces) face.emission = {{half}};
  for (std::size_t i = 0; i < c.coefficients.size(); ++i)
    c.coefficients[i] = i < c.elements.size() ? 1 - 0x1p-7 : 0.25;
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

std::vector<Ball> ones() { return std::vector<Ball>(4, Ball(1)); }

}  // namespace

std::vector<Case> certificate_cases() {
  return {{.limit = "certificate/ball_transport: parts of elements for a group of points",
           .answer = furnace,
           .truth = ones},
          {.limit = "certificate/element_check: cells of an element", .answer = furnace, .truth = ones}};
}

}  // namespace radcert::limits
