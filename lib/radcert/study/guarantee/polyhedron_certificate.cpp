// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/study/guarantee/polyhedron_certificate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "radcert/certificate/check.h"
#include "radcert/certificate/function_facts.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert {
namespace {

using certificate::PolyhedronCertificate;

std::vector<std::vector<Rational>> rows_of(const PlanePolynomial<Rational>& f) {
  std::vector<std::vector<Rational>> out;
  for (int i = 0; i <= f.degree(); ++i) {
    out.emplace_back();
    for (int j = 0; i + j <= f.degree(); ++j) out.back().push_back(f(i, j));
  }
  return out;
}

std::vector<certificate::Face> faces_of(const PolyhedronProblem& problem) {
  std::vector<certificate::Face> out;
  for (std::size_t k = 0; k < problem.panels.size(); ++k) {
    certificate::Face face{.piece = problem.panels[k].piece,
                           .corners = problem.panels[k].corners,
                           .reflectivity = problem.reflectivity[k].largest,
                           .emission = rows_of(problem.emission[k])};
    if (!problem.reflectivity[k].is_constant())
      face.varying_reflectivity = rows_of(problem.reflectivity[k].polynomial);
    out.push_back(std::move(face));
  }
  return out;
}

/// Each side of each face.
struct Side {
  std::size_t face;
  std::size_t side;
};
std::vector<Side> sides_of(const PolyhedronProblem& problem) {
  std::vector<Side> out;
  for (std::size_t k = 0; k < problem.panels.size(); ++k)
    for (std::size_t i = 0; i < problem.panels[k].corners.size(); ++i) out.push_back({k, i});
  return out;
}

/// A bound as a short decimal.
/// Result    at least x, up to a hundredth larger
double short_bound(double x) {
  constexpr int digits = 3;
  return Rational::parse(upper_text(x, DecimalForm::general(digits))).value().to_double();
}

/// A number with as few digits as leave it within a fiftieth of its radius.
double rounded_within(double x, double radius) {
  if (!(std::abs(x) > 0.02 * radius)) return 0;
  const double digits = std::ceil(std::log10(std::abs(x) / (0.02 * radius)));
  constexpr double most = 17;
  const DecimalForm form = DecimalForm::general(static_cast<int>(std::clamp(digits + 1, 1.0, most)));
  return Rational::parse(nearest_text(x, form)).value().to_double();
}

/// The claims of a search, wider.
class WiderClaims {
public:
  WiderClaims(const GoalProof& proof, const std::vector<char>& reflects, double gap)
      : proof_(proof), reflects_(reflects), pieces_(proof.norms.size() - 1), floors_(proof.norms.size()) {
    for (std::size_t e = 0; e < reflects.size(); ++e)
      if (reflects[e] != 0) {
        ++elements_;
        if (proof.elements[e].box.t0 == 0) ++at_edges_;
      }
    const double room = proof.wanted * gap;
    const double largest_dual = *std::max_element(proof.norms.begin() + 1, proof.norms.end());
    const auto floor = [&](double own, double other) {
      return std::max(0.3 * own, 0.1 * room / std::max(other, std::sqrt(room)));
    };
    for (std::size_t k = 0; k < proof.norms.size(); ++k)
      floors_[k] = floor(proof.norms[k], k == 0 ? largest_dual : proof.norms[0]) /
                   std::sqrt(static_cast<double>(elements_));
  }

  [[nodiscard]] certificate::Claim on(std::size_t e) const {
    certificate::Claim claim{.norms = std::vector<double>(pieces_ + 1),
                             .products = std::vector<double>(pieces_),
                             .radii = std::vector<double>(pieces_)};
    if (reflects_[e] == 0) return claim;
    const ElementResidual& found = proof_.residuals[e];
    for (std::size_t k = 0; k <= pieces_; ++k) {
      const double norm = std::hypot(1.1 * found.norms[k], floors_[k]);
      claim.norms[k] = short_bound(std::ldexp(norm, k == 0 ? proof_.exponent : proof_.exponents[k - 1]));
    }
    for (std::size_t k = 0; k < pieces_; ++k) {
      const Approximation& product = found.products[1 + k];
      double more = 0.06 / static_cast<double>(elements_);
      if (proof_.elements[e].box.t0 == 0) more += 0.06 / static_cast<double>(at_edges_);
      more *= std::max(proof_.radii[k], proof_.wanted);
      const int exponent = proof_.exponent + proof_.exponents[k];
      const double exact = std::ldexp(product.value, exponent);
      const double radius = std::ldexp(product.radius + more, exponent);
      claim.products[k] = rounded_within(exact, radius);
      claim.radii[k] = short_bound(radius + 1.001 * std::abs(claim.products[k] - exact));
    }
    return claim;
  }

private:
  const GoalProof& proof_;
  const std::vector<char>& reflects_;
  std::size_t pieces_;
  std::size_t elements_ = 0;
  std::size_t at_edges_ = 0;
  std::vector<double> floors_;
};

Rational largest_reflectivity(const PolyhedronProblem& problem) {
  Rational sup = 0;
  for (const PanelReflectivity& rho : problem.reflectivity) sup = std::max(sup, rho.largest);
  return sup;
}

/// The elements of a search.
/// Result    whether each reflects
std::vector<char> put_elements(const PolyhedronProblem& problem, const std::vector<SectorElement>& elements,
                               PolyhedronCertificate& out) {
  const std::vector<Side> sides = sides_of(problem);
  std::vector<char> reflects;
  for (const SectorElement& element : elements) {
    const Side& side = sides[element.sector];
    out.elements.push_back({.face = side.face,
                            .side = side.side,
                            .s0 = element.box.s0,
                            .s1 = element.box.s1,
                            .t0 = element.box.t0,
                            .t1 = element.box.t1});
    reflects.push_back(problem.reflectivity[side.face].largest.sign() > 0 ? 1 : 0);
  }
  return reflects;
}

/// Function k of a search, in its units.
void put_function(const SectorFunctions& q, std::size_t k, int exponent, PolyhedronCertificate& out) {
  for (std::size_t e = 0; e < out.elements.size(); ++e)
    for (const double c : q.of(e, k)) out.coefficients.push_back(std::ldexp(c, exponent));
}

void put_proof(const PolyhedronProblem& problem, const GoalProof& proof, PolyhedronCertificate& out) {
  const std::vector<char> reflects = put_elements(problem, proof.elements, out);
  out.degree = proof.q.degree();
  for (std::size_t k = 0; k < out.functions(); ++k)
    put_function(proof.q, k, k == 0 ? proof.exponent : proof.exponents[k - 1], out);
  const WiderClaims claims(proof, reflects, (Rational(1) - largest_reflectivity(problem)).to_double());
  for (std::size_t e = 0; e < proof.elements.size(); ++e) out.claims.push_back(claims.on(e));
}

/// The largest residual of all elements that are as far from the vertices, by element.
std::vector<double> largest_beyond(const FunctionProof& proof) {
  std::vector<std::size_t> order(proof.elements.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return proof.farthest[a] > proof.farthest[b]; });
  std::vector<double> out(order.size());
  double largest = 0;
  for (const std::size_t e : order) {
    largest = std::max(largest, proof.residuals[e]);
    out[e] = largest;
  }
  return out;
}

/// Nothing reflects that the numbers depend on: u = E there, and no residual has to be small.
void put_nothing(const PolyhedronProblem& problem, PolyhedronCertificate& out) {
  constexpr double no_claim = 1e80;
  for (const Side& side : sides_of(problem)) {
    out.elements.push_back({.face = side.face, .side = side.side});
    const double bound = problem.reflectivity[side.face].largest.sign() > 0 ? no_claim : 0;
    out.claims.push_back({.norms = std::vector<double>(out.functions(), bound),
                          .products = std::vector<double>(out.goals()),
                          .radii = std::vector<double>(out.goals(), bound)});
  }
  out.coefficients.resize(out.functions() * out.elements.size());
}

}  // namespace

PolyhedronCertificate polyhedron_certificate(const PolyhedronProblem& problem,
                                             const std::vector<std::string>& pieces, const GoalProof* proof,
                                             const std::vector<SolutionPoint>& points) {
  PolyhedronCertificate out;
  out.pieces = pieces;
  out.faces = faces_of(problem);
  for (const SolutionPoint& point : points) out.points.push_back({.face = point.panel, .at = point.at});
  if (proof != nullptr)
    put_proof(problem, *proof, out);
  else
    put_nothing(problem, out);
  certificate::Summed found = certificate::summed(out);
  out.sums = std::move(found.sums);
  out.enclosures = std::move(found.enclosures);
  double radius = 0;
  for (const certificate::Enclosure& mean : out.enclosures)
    radius = std::max(radius, mean.radius.to_double());
  // Wider than the rounding of both to decimals.
  out.width = Rational::exactly(2 * radius * (1 + 0x1p-40));
  return out;
}

PolyhedronCertificate polyhedron_certificate(const PolyhedronProblem& problem,
                                             const std::vector<std::string>& pieces,
                                             const FunctionProof& proof, const Rational& wanted,
                                             const Rational& outside) {
  PolyhedronCertificate out;
  out.pieces = pieces;
  out.faces = faces_of(problem);
  const std::vector<char> reflects = put_elements(problem, proof.elements, out);
  out.degree = proof.q.degree();
  put_function(proof.q, 0, proof.exponent, out);
  const double gap = (Rational(1) - largest_reflectivity(problem)).to_double();
  const double floor = 0.05 * 0.5 * wanted.to_double() * gap;
  const std::vector<double> largest = largest_beyond(proof);
  for (std::size_t e = 0; e < proof.elements.size(); ++e)
    out.claims.push_back({.largest = reflects[e] != 0
                                         ? short_bound(std::ldexp(1.2 * largest[e], proof.exponent) + floor)
                                         : 0});
  constexpr int digits = 4;
  std::vector<Rational> distances{0, outside};
  for (const double radius : proof.radii)
    distances.push_back(Rational::parse(upper_text(radius, DecimalForm::general(digits))).value());
  std::sort(distances.begin(), distances.end(), [](const Rational& a, const Rational& b) { return b < a; });
  distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
  for (const Rational& distance : distances) out.by_distance.push_back({.outside = distance, .sup = 0});
  const std::vector<Rational> bounds = certificate::bounds_by_distance(out);
  for (std::size_t m = 0; m < bounds.size(); ++m) {
    out.by_distance[m].sup = bounds[m];
    if (out.by_distance[m].outside == outside) out.width = Rational(2) * bounds[m];
  }
  out.outside = outside;
  const Rational everywhere = Rational(2) * bounds.back();
  if (everywhere <= wanted) {
    out.outside = 0;
    out.width = everywhere;
  }
  return out;
}

}  // namespace radcert
