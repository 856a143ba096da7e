// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/cut/cut_triangle.h"
#include "radcert/geometry/mesh_defects.h"
#include "radcert/polynomial/lebesgue_constant.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "radcert/polynomial/nodes/symmetric_certificate.h"
#include "radcert/polynomial/rules/gauss.h"
#include "radcert/scalar/functions/dilogarithm.h"
#include "radcert/scalar/functions/power_difference.h"
#include "radcert/surface/exact_function.h"
#include "tests/limits/limits.h"

namespace radcert::limits {
namespace {

/// A hundred bits and more: of Mpfr<50>, that have 168.
Ball rounded(const Mpfr<50>& x) {
  const Ball exact(x.to_rational());
  return widened(exact, abs(exact) * Ball(0x1p-120));
}

Case dilogarithm(const Rational& angle, const std::string& about) {
  return {.limit = "scalar/dilogarithm: bits for a rounded value",
          .answer =
              [angle] {
                return numbers({rounded(dilogarithm_imaginary(Mpfr<50>(Rational(9, 10)), Mpfr<50>(angle)))});
              },
          .truth =
              [angle] {
                const BallPrecision precision(4000);
                return std::vector<Ball>{dilogarithm_imaginary(Ball(Mpfr<50>(Rational(9, 10)).to_rational()),
                                                               Ball(Mpfr<50>(angle).to_rational()))};
              },
          .about = about};
}

/// The second divided difference over 1 and 1 + step, which is small; by the definition at many bits.
Case bend(const Rational& exponent, const Rational& step, const std::string& about) {
  return {
      .limit = "scalar/power_difference: terms of the binomial series for each bit",
      .answer =
          [=] { return numbers({bend_of_power(1, Ball(Rational(1) + step), Ball(step), Ball(exponent))}); },
      .truth =
          [=] {
            const BallPrecision precision(2000);
            const Ball d(step);
            const Ball e(exponent);
            return std::vector<Ball>{(pow(1 + d, e) - 1 - e * d) / (d * d)};
          },
      .about = about};
}

std::vector<Ball> nodes_and_weights(const IntervalRule<Ball>& rule) {
  std::vector<Ball> all = rule.nodes;
  all.insert(all.end(), rule.weights.begin(), rule.weights.end());
  return all;
}

template <Real R>
Case gauss(int points, IntervalWeight weight, const std::string& about) {
  return {.limit = "polynomial/gauss: steps to a zero",
          .answer =
              [=] {
                const IntervalRule<R> rule = gauss_rule<R>(points, weight);
                std::vector<Ball> all;
                for (const auto* part : {&rule.nodes, &rule.weights})
                  for (const R& x : *part) {
                    const Ball exact(x.to_rational());
                    all.push_back(widened(exact, abs(exact) * Ball(0x1p-140)));
                  }
                return numbers(all);
              },
          .truth =
              [=] {
                const BallPrecision precision(400);
                return nodes_and_weights(gauss_rule<Ball>(points, weight));
              },
          .about = about};
}

Case enclosed_gauss(int points) {
  return {
      .limit = "polynomial/gauss: doublings of an enclosed zero's digits",
      .answer =
          [points] { return numbers(nodes_and_weights(gauss_rule<Ball>(points, IntervalWeight::variable))); },
      .truth =
          [points] {
            const BallPrecision precision(600);
            return nodes_and_weights(gauss_rule<Ball>(points, IntervalWeight::variable));
          }};
}

/// Of nodes on an inset lattice.
Case lebesgue(int degree) {
  return {.limit = "polynomial/lebesgue_constant: triangles", .answer = [degree] {
            const LagrangeFunctions functions =
                lagrange_functions(inset_nodes(degree, Rational(1, 20))).value();
            const LebesgueConstant found = lebesgue_constant(functions, Rational(1, 10000));
            return numbers({hull(Ball(found.lower), Ball(found.upper))}, found.reached ? "reached" : "");
          }};
}

Case certificate(int degree) {
  return {.limit = "polynomial/symmetric_certificate: bits", .answer = [degree] {
            const Outcome<SymmetricCertificate> found =
                certify(symmetric_nodes(degree), 1 / power(Rational(10), 55));
            if (!found) return refusal(found.reason());
            Answer answer = numbers(found->rule.weights, found->determinant.to_text(10));
            answer.verdict = std::to_string(found->triangle.degree);
            return answer;
          }};
}

/// Three triangles that all cross each other.
Case crossings() {
  return {
      .limit = "geometry/mesh_defects: pairs that cross", .answer = [] {
        TriangleMesh mesh;
        for (const double turn : {0.0, 1.0, 2.0}) {
          const std::size_t first = mesh.vertices.size();
          mesh.vertices.insert(mesh.vertices.end(), {{-1, -1, turn / 8}, {1, turn - 1, 0}, {0, 1, 1 - turn}});
          mesh.triangles.push_back({first, first + 1, first + 2});
          mesh.group.push_back(0);
          mesh.face.push_back(0);
        }
        const std::size_t found = mesh_defects(mesh).crossing.size();
        return verdict(found > 0 ? "faulty" : "sound", std::to_string(found));
      }};
}

Case sign(const ExactFunction& f, ParameterRegion region) {
  return {.limit = "surface/exact_function: degree of Bernstein's coefficients",
          .answer = [=] { return verdict(is_nowhere_negative(f, region) ? "nowhere negative" : ""); }};
}

/// The parts of a triangle that lines cut as far as they may: how many there are, and their areas' sum.
Case cut() {
  return {.limit = "geometry/cut_triangle: segments",
          .answer =
              [] {
                const std::vector<PlaneSegment> lines{
                    {{Rational(1, 2), 0}, {0, Rational(1, 2)}},
                    {{0, Rational(1, 4)}, {Rational(3, 4), Rational(1, 4)}},
                    {{Rational(1, 3), 0}, {Rational(1, 3), Rational(2, 3)}}};
                const auto parts = cut_triangle(lines);
                if (!parts) return refusal(parts.reason());
                Rational sum = 0;
                for (const auto& part : *parts) {
                  const auto side = [&](std::size_t k) {
                    return ParameterPoint<Rational>{Rational::exactly(part.at(k).s - part[0].s),
                                                    Rational::exactly(part.at(k).t - part[0].t)};
                  };
                  sum += cross(side(1), side(2));
                }
                return numbers({Ball(sum)});
              },
          .truth = [] { return std::vector<Ball>{Ball(1)}; }};
}

}  // namespace

std::vector<Case> formula_cases() {
  const Rational tiny = 1 / power(Rational(2), 100);
  const ExactFunction s = ExactFunction::s();
  const ExactFunction t = ExactFunction::t();
  return {dilogarithm(Rational(1, 3), "an angle of the usual size"),
          dilogarithm(1 / power(Rational(10), 60), "an angle near 0"),
          dilogarithm(Mpfr<50>::pi().to_rational(), "an angle near pi"),
          bend(Rational(5, 2), tiny, "5/2"),
          bend(Rational(-11, 2), Rational(1, 1024), "-11/2"),
          bend(Rational(101, 2), Rational(1, 4096), "101/2"),
          gauss<Mpfr<50>>(7, IntervalWeight::one, "7 points"),
          gauss<Mpfr<50>>(40, IntervalWeight::variable, "40 points, weight x"),
          enclosed_gauss(6),
          lebesgue(3),
          certificate(2),
          crossings(),
          cut(),
          sign(s * s + t, ParameterRegion::square),
          sign(ExactFunction(1) - s - t, ParameterRegion::triangle)};
}

}  // namespace radcert::limits
