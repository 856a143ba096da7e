// SPDX-License-Identifier: GPL-3.0-or-later
// Two independent routes to Int G l_j dS over an element: the rules of `quadrature` and adaptive Gauss rules.
#include <gtest/gtest.h>

#include <cmath>

#include "radcert/quadrature/element_integrator.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "radcert/surface/catalogue/two_squares.h"
#include "tests/quadrature/random_entries.h"

namespace radcert {
namespace {

/// l_j as a density: from the parameters, whatever the point.
reference::Density basis_function(const ParameterTriangle& element, const InsetBasis<double>& basis,
                                  std::size_t j) {
  return [=](const SurfacePoint<double>& q, const Vector<double>&) {
    const auto& v = element.vertices;
    Barycentric<double> x;
    for (std::size_t i = 0; i < 3; ++i)
      x.x[i] = cross(v[(i + 1) % 3] - q.at, v[(i + 2) % 3] - q.at) / cross(v[1] - v[0], v[2] - v[0]);
    std::array<double, 45> values;
    basis.values(x, values);
    return values[j];
  };
}

void expect_agreement(Place place, std::uint64_t seed) {
  Stream stream(seed);
  for (const Surface& surface : {cube(), box(1, 2, 5), sphere(), ellipsoid(1, 2, 5), two_piece(2),
                                 two_piece(Rational(3, 2)), two_squares()})
    for (int level = 0; level < 3; ++level) {
      const TouchingElements elements(surface, level);
      for (int attempt = 0; attempt < 4; ++attempt) {
        const auto c = elements.draw(place, 2, stream.pick<double>({1e-2, 0.1, 1.0 / 6}), stream);
        if (!c) continue;
        const InsetBasis<double> basis(c->degree, c->inset);
        const ElementIntegral<double> integral =
            ElementIntegrator<double>(surface, c->element, basis)
                .integrate(collocation_point<double>(surface, c->observer));
        const std::size_t j = stream.index(basis.size());
        const Approximation other =
            reference::operator_integral(surface, c->observer, c->element.chart, c->element.vertices,
                                         basis_function(c->element, basis, j));
        EXPECT_LE(std::abs(integral.value[j] - other.value), integral.radius[j] + other.radius)
            << c->text() << ", function " << j;
        EXPECT_LE(integral.radius[j] + other.radius, 1e-10) << c->text() << ", function " << j;
      }
    }
}

TEST(ElementIntegral, AgreesWithAdaptiveCubatureOnTheObserversOwnElement) {
  expect_agreement(Place::own, 31);
}
TEST(ElementIntegral, AgreesWithAdaptiveCubatureBesideAnEdge) { expect_agreement(Place::edge, 32); }
TEST(ElementIntegral, AgreesWithAdaptiveCubatureAcrossAnEdge) { expect_agreement(Place::edge_at_angle, 33); }
TEST(ElementIntegral, AgreesWithAdaptiveCubatureBesideAVertex) { expect_agreement(Place::vertex, 34); }
TEST(ElementIntegral, AgreesWithAdaptiveCubatureApart) { expect_agreement(Place::apart, 35); }

}  // namespace
}  // namespace radcert
