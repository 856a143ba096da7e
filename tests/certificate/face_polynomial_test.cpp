// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/face_polynomial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "radcert/certificate/check.h"
#include "radcert/certificate/densities.h"
#include "radcert/certificate/gauss_rule.h"
#include "radcert/certificate/scene.h"
#include "tests/certificate/samples.h"

namespace radcert::certificate {
namespace {

using test::Draw;
using Polynomial = std::vector<std::vector<Rational>>;

Face face_of(std::vector<Vector<Rational>> corners) {
  return {.piece = 0, .corners = std::move(corners), .reflectivity = 0, .emission = {{Rational(0)}}};
}
const Face square = face_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
/// Corners in x and y, which are the parameters of the polynomials.
const Face pentagon =
    face_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {Rational(-1, 2), 1, 0}, {-1, Rational(1, 2), 0}});

const Rational little(1, 1000000);

TEST(LiesWithin, KnowsTheLargestValue) {
  // 4 h x (1 - x) has the value h inside the face, and touches 0 on one of its sides.
  const Rational h(3, 4);
  const Polynomial arch{{0, 0, 0}, {Rational(4) * h, 0}, {Rational(-4) * h}};
  const Polynomial product{{Rational(1, 2), 0, 0}, {0, Rational(1, 4)}, {0}};
  Face frame = square;
  frame.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(lies_within(frame, arch, h + Rational(1, 1000)));
  EXPECT_FALSE(lies_within(frame, arch, h - Rational(1, 1000)));
  // x y / 4 + 1/2 on the triangle: at most 1/16 + 1/2, on the side where x + y = 1.
  EXPECT_TRUE(lies_within(frame, product, Rational(9, 16) + Rational(1, 1000)));
  EXPECT_FALSE(lies_within(frame, product, Rational(9, 16) - Rational(1, 1000)));
  const Polynomial rises{{Rational(1, 8), Rational(1, 4)}, {Rational(1, 2)}};
  EXPECT_TRUE(lies_within(frame, rises, Rational(5, 8)));
  EXPECT_FALSE(lies_within(frame, rises, Rational(5, 8) - little));
}

TEST(LiesWithin, KnowsNegativeValues) {
  const Polynomial falls{{Rational(1, 2), 0}, {Rational(-1, 2)}};
  EXPECT_TRUE(lies_within(pentagon, falls, 1));
  EXPECT_FALSE(lies_within(pentagon, {{Rational(1, 2) - little, 0}, {Rational(-1, 2)}}, 1));
  // (x - 1/3)^2 + (y - 1/4)^2 + c
  const auto bowl = [](const Rational& c) {
    return Polynomial{{Rational(1, 9) + Rational(1, 16) + c, Rational(-1, 2), 1}, {Rational(-2, 3), 0}, {1}};
  };
  EXPECT_TRUE(lies_within(pentagon, bowl(Rational(1, 1000)), 3));
  EXPECT_FALSE(lies_within(pentagon, bowl(-little), 3));
}

/// Against values at many points of the face.
TEST(LiesWithin, AgreesWithValues) {
  Draw draw(1);
  int decided = 0;
  for (int n = 0; n < 60; ++n) {
    const int degree = 1 + n % 6;
    Polynomial f;
    for (int i = 0; i <= degree; ++i) {
      f.emplace_back();
      for (int j = 0; i + j <= degree; ++j)
        f.back().push_back(Rational::exactly(std::ldexp(std::round(64 * (draw() - 0.5)), -6)));
    }
    f[0][0] += 2;
    double least = 1e300;
    double largest = -1e300;
    const std::vector<Vector<Rational>>& c = pentagon.corners;
    for (int k = 0; k < 20000; ++k) {
      double sum = 0;
      double x = 0;
      double y = 0;
      for (const Vector<Rational>& p : c) {
        const double weight = std::pow(draw(), 6);
        sum += weight;
        x += weight * p.x.to_double();
        y += weight * p.y.to_double();
      }
      double value = 0;
      for (std::size_t i = 0; i < f.size(); ++i)
        for (std::size_t j = 0; j < f[i].size(); ++j)
          value += f[i][j].to_double() * std::pow(x / sum, static_cast<double>(i)) *
                   std::pow(y / sum, static_cast<double>(j));
      least = std::min(least, value);
      largest = std::max(largest, value);
    }
    const auto within = [&](double bound) { return lies_within(pentagon, f, Rational::exactly(bound)); };
    EXPECT_FALSE(within(largest - 1e-9));
    if (least > 0.05) {
      ++decided;
      EXPECT_TRUE(within(largest + 0.05)) << n;
    }
    if (least < 0) {
      EXPECT_FALSE(within(100)) << n;
    }
  }
  EXPECT_GT(decided, 10);
}

/// A certificate whose reflectivity is another polynomial on each face.
PolyhedronCertificate bent(const std::string& surface, int degree, int of_rho) {
  PolyhedronCertificate c = test::bare_certificate(surface, 2, degree, 3);
  Draw draw(7);
  for (Face& face : c.faces) {
    face.varying_reflectivity.clear();
    for (int i = 0; i <= of_rho; ++i) {
      face.varying_reflectivity.emplace_back();
      for (int j = 0; i + j <= of_rho; ++j)
        face.varying_reflectivity.back().push_back(
            Rational::exactly(std::ldexp(std::round(16 * draw()), -8)));
    }
    face.varying_reflectivity[0][0] = Rational(1, 4);
    face.reflectivity = Rational(7, 8);
    face.emission = {{Rational(1, 3), Rational(1, 5)}, {Rational(-1, 7)}};
  }
  return c;
}

double value_at(const Polynomial& f, const Face& face, const Vector<double>& at) {
  // By the normal equations of the frame.
  const auto rounded = [](const Vector<Rational>& v) {
    return Vector<double>{v.x.to_double(), v.y.to_double(), v.z.to_double()};
  };
  const Vector<double> a = rounded(face.corners[1] - face.corners[0]);
  const Vector<double> b = rounded(face.corners[2] - face.corners[0]);
  const Vector<double> p = at - rounded(face.corners[0]);
  const double determinant = dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b);
  const double x = (dot(p, a) * dot(b, b) - dot(p, b) * dot(a, b)) / determinant;
  const double y = (dot(p, b) * dot(a, a) - dot(p, a) * dot(a, b)) / determinant;
  double sum = 0;
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < f[i].size(); ++j)
      sum += f[i][j].to_double() * std::pow(x, static_cast<double>(i)) * std::pow(y, static_cast<double>(j));
  return sum;
}

/// w_0 = E + rho q_0 and w_k = rho (j + q_k), by their values.
TEST(Densities, AreProductsWithReflectivitiesThatVary) {
  Draw draw(11);
  for (const auto& [surface, degree, of_rho] :
       {std::tuple("tetrahedron", 2, 3), std::tuple("cube", 1, 8), std::tuple("octahedron", 3, 1)}) {
    const PolyhedronCertificate c = bent(surface, degree, of_rho);
    const Densities densities(c);
    EXPECT_EQ(densities.degree(), degree + of_rho);
    for (int n = 0; n < 100; ++n) {
      const std::size_t e = static_cast<std::size_t>(draw() * static_cast<double>(c.elements.size()));
      const Element& x = c.elements[e];
      const double in_s = 2 * draw() - 1;
      const double in_t = 2 * draw() - 1;
      const double s = 0.5 * (x.s0 + x.s1) + 0.5 * (x.s1 - x.s0) * in_s;
      const double t = 0.5 * (x.t0 + x.t1) + 0.5 * (x.t1 - x.t0) * in_t;
      const Vector<double> at = test::element_point(c, x, s, t);
      const Face& face = c.faces[x.face];
      const double rho = value_at(face.varying_reflectivity, face, at);
      EXPECT_LE(rho, densities.reflectivity(e));
      const std::vector<double> p = legendre(densities.degree(), in_s);
      const std::vector<double> q = legendre(densities.degree(), in_t);
      for (std::size_t k = 0; k < c.functions(); ++k) {
        double of_w = 0;
        for (std::size_t i = 0; i < densities.powers(); ++i)
          for (std::size_t j = 0; j < densities.powers(); ++j)
            of_w += densities.w(e)[(i * densities.powers() + j) * densities.stride() + k] * p[i] * q[j];
        double of_q = k > 0 && face.piece == k - 1 ? 1 : 0;
        for (std::size_t i = 0; i < c.powers(); ++i)
          for (std::size_t j = 0; j < c.powers(); ++j) of_q += c.coefficient(k, e, i, j) * p[i] * q[j];
        const double expected = (k == 0 ? value_at(face.emission, face, at) : 0) + rho * of_q;
        EXPECT_NEAR(std::ldexp(of_w, densities.exponent(k)), expected, 1e-12);
      }
    }
  }
}

/// E = 1 - rho, where u = 1.
PolyhedronProblem furnace_of_polynomials(const std::string& name) {
  PolyhedronProblem out = test::constant_problem(name, 0, {0});
  for (std::size_t k = 0; k < out.panels.size(); ++k) {
    PlanePolynomial<Rational> rho(2);
    rho(0, 0) = Rational(1, 4);
    rho(1, 0) = Rational(1, 8);
    rho(1, 1) = Rational(static_cast<long>(k), 20);
    out.reflectivity[k] = reflectivity_of(out.panels[k], rho).value();
    PlanePolynomial<Rational> emission(2);
    emission(0, 0) = Rational(3, 4);
    emission(1, 0) = Rational(-1, 8);
    emission(1, 1) = Rational(-static_cast<long>(k), 20);
    out.emission[k] = emission;
  }
  return out;
}

/// rho and E of a face as of `furnace_of_polynomials`.
void bend(Face& face, std::size_t k) {
  const Rational more(static_cast<long>(k), 20);
  face.varying_reflectivity = {{Rational(1, 4), 0, 0}, {Rational(1, 8), more}, {0}};
  face.emission = {{Rational(3, 4), 0, 0}, {Rational(-1, 8), -more}, {0}};
}

/// q_0 = 1 - d: w_0 = 1 - rho d, t_0 = d (1 - T rho), and q_1 = 0, so that t_1 = j: claimed generously.
PolyhedronCertificate value_in_a_furnace() {
  PolyhedronCertificate c = test::furnace_value_certificate("tetrahedron", 0.01, 2, 1e-3);
  for (std::size_t k = 0; k < c.faces.size(); ++k) bend(c.faces[k], k);
  test::put_sums(c);
  return c;
}

TEST(Check, VerifiesReflectivitiesThatVary) {
  const PolyhedronCertificate means =
      test::certified_solution(furnace_of_polynomials("tetrahedron"), "tetrahedron", 0.5);
  const PolyhedronCertificate values = value_in_a_furnace();
  for (const PolyhedronCertificate* const c : {&means, &values}) {
    for (const Enclosure& one : c->enclosures) EXPECT_LE(abs(one.midpoint - Rational(1)), one.radius);
    const Report report = check(*c, {.elements = 2, .seed = "varies"});
    EXPECT_FALSE(report.refusal) << report.refusal->pointer << report.refusal->says;
  }
  // rho at the point itself.
  EXPECT_LT(values.enclosures[0].radius, Rational(1, 50));
  // Any of its numbers changed: the sums do not follow, or it is not bounded by what is stated.
  Draw draw(13);
  for (int n = 0; n < 100; ++n) {
    PolyhedronCertificate c = means;
    Face& face = c.faces[static_cast<std::size_t>(draw() * static_cast<double>(c.faces.size()))];
    const Rational by(draw() < 0.5 ? -1 : 1, 1000);
    const std::size_t i = static_cast<std::size_t>(3 * draw());
    const std::size_t j = static_cast<std::size_t>(static_cast<double>(3 - i) * draw());
    if (n % 7 == 0)
      face.reflectivity += face.reflectivity * Rational(-1, 20);
    else
      face.varying_reflectivity[i][j] += by;
    EXPECT_TRUE(check(c, {.elements = 0, .seed = {}}).refusal) << n;
  }
}

}  // namespace
}  // namespace radcert::certificate
