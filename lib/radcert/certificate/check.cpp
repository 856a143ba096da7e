// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "radcert/certificate/ball_transport.h"
#include "radcert/certificate/densities.h"
#include "radcert/certificate/element_check.h"
#include "radcert/certificate/function_facts.h"
#include "radcert/certificate/line_bounds.h"
#include "radcert/certificate/occlusion/shade.h"
#include "radcert/certificate/occlusion/sight.h"
#include "radcert/certificate/point_kernels.h"
#include "radcert/certificate/polyhedron_facts.h"
#include "radcert/certificate/scene.h"
#include "radcert/core/text.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/enclosing_text.h"

namespace radcert::certificate {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string place(const std::string& list, std::size_t number) { return list + "/" + std::to_string(number); }

Rational largest_reflectivity(const PolyhedronCertificate& c) {
  Rational largest = 0;
  for (const Face& face : c.faces) largest = std::max(largest, face.reflectivity);
  return largest;
}

/// A double at least as large as a ball that is not negative.
double above(const Ball& x) { return std::nextafter(x.upper_double(), infinity); }

/// Of the claims, as balls.
struct ClaimSums {
  std::vector<Ball> squares;
  std::vector<Ball> products;
  std::vector<Ball> radii;
};

ClaimSums sums_of_claims(const PolyhedronCertificate& c) {
  ClaimSums out{std::vector<Ball>(c.functions()), std::vector<Ball>(c.goals()), std::vector<Ball>(c.goals())};
  for (const Claim& claim : c.claims) {
    for (std::size_t k = 0; k < claim.norms.size(); ++k) out.squares[k] += power(Ball(claim.norms[k]), 2);
    for (std::size_t k = 0; k < claim.products.size(); ++k) {
      out.products[k] += Ball(claim.products[k]);
      out.radii[k] += Ball(claim.radii[k]);
    }
  }
  return out;
}

/// The mean over each piece, or the value at each point, from sums.
std::vector<Ball> means_of(const PolyhedronCertificate& c, const Sums& sums) {
  if (c.of_values()) return values_of(c, sums, Ball(Rational(1) - largest_reflectivity(c)));
  const std::vector<Ball> areas = piece_areas(c);
  const std::vector<Ball> densities = Densities::integrals(c);
  const Ball gap = Ball(Rational(1) - largest_reflectivity(c));
  std::vector<Ball> out;
  for (std::size_t k = 0; k < c.pieces.size(); ++k) {
    const Ball radius = Ball(sums.radii[k]) + Ball(sums.norms[0]) * Ball(sums.norms[1 + k]) / gap;
    out.push_back(widened(densities[k] + Ball(sums.products[k]), radius) / areas[k]);
  }
  return out;
}

/// A bound that is proved, in words.
std::string bound_text(double bound) {
  return std::isfinite(bound) ? upper_text(bound, DecimalForm::general(6)) : std::string("nothing");
}

/// 2^exponent x for x >= 0, rounded up below the normal numbers.
double scaled_up(double x, int exponent) {
  const double y = std::ldexp(x, exponent);
  return std::ldexp(y, -exponent) < x ? std::nextafter(y, std::numeric_limits<double>::infinity()) : y;
}

/// A claim held against what is proved in scaled units.
/// Maths     lengths are 2^l, function k 2^(e_k) times those: norms 2^(l+e_k), products 2^(2l+e_0+e_k), the
///           largest value 2^e_0
std::optional<Refusal> claim_fault(const PolyhedronCertificate& c, std::size_t element,
                                   const ResidualBounds& proved, int length, const Densities& densities) {
  const Claim& claim = c.claims[element];
  const std::string pointer = place("/claims", element);
  if (c.of_function()) {
    const double largest = scaled_up(proved.largest, densities.exponent());
    if (largest <= claim.largest) return std::nullopt;
    return Refusal{pointer + "/largest",
                   "claims " + shortest(claim.largest) + ", and " + bound_text(largest) + " is proved"};
  }
  for (std::size_t k = 0; k < claim.norms.size(); ++k) {
    const double norm = scaled_up(proved.norms[k], length + densities.exponent(k));
    if (!(norm <= claim.norms[k]))
      return Refusal{place(pointer + "/norms", k),
                     "claims " + shortest(claim.norms[k]) + ", and " + bound_text(norm) + " is proved"};
  }
  for (std::size_t k = 0; k < claim.products.size(); ++k) {
    const int size = densities.exponent() + densities.exponent(1 + k);
    const double product = std::ldexp(proved.products[k], 2 * length + size);
    // As much more as the product is off by where that is below the normal numbers.
    const bool is_exact = std::ldexp(product, -2 * length - size) == proved.products[k];
    const double radius = scaled_up(proved.radii[k], 2 * length + size) +
                          (is_exact ? 0 : std::numeric_limits<double>::denorm_min());
    const bool is_known = std::isfinite(product) && std::isfinite(radius);
    const Ball off = abs(Ball(product) - Ball(claim.products[k])) + Ball(radius);
    if (is_known && certainly_at_most(off, Ball(claim.radii[k]))) continue;
    std::string what = "nothing";
    if (is_known) {
      const EnclosingText text = enclosing_text(product, radius, DecimalForm::general(12));
      what = text.value + " within " + text.radius;
    }
    return Refusal{place(pointer + "/products", k), "claims " + shortest(claim.products[k]) + " within " +
                                                        shortest(claim.radii[k]) + ", and " + what +
                                                        " is proved"};
  }
  return std::nullopt;
}

/// Whether a claim is further from what was found than finer cells could bring it.
bool is_hopeless(const PolyhedronCertificate& c, std::size_t element, const ResidualBounds& found, int length,
                 const Densities& densities) {
  const Claim& claim = c.claims[element];
  if (c.of_function()) return false;
  for (std::size_t k = 0; k < claim.norms.size(); ++k)
    if (std::ldexp(found.norms[k] - found.doubts[k], length + densities.exponent(k)) > claim.norms[k])
      return true;
  for (std::size_t k = 0; k < claim.products.size(); ++k) {
    const int size = 2 * length + densities.exponent() + densities.exponent(1 + k);
    const double off = std::abs(std::ldexp(found.products[k], size) - claim.products[k]);
    if (off - std::ldexp(found.radii[k], size) > claim.radii[k]) return true;
  }
  return false;
}

/// Parts of the claims that rules may leave.
struct Share {
  double of_norm = 0;  ///< and of a largest value
  double of_product = 0;
};

/// Of the claims on one element, in scaled units: what rules may leave.
Allowance allowance_of(const PolyhedronCertificate& c, const Densities& densities, std::size_t element,
                       int length, const Share& share) {
  const Claim& claim = c.claims[element];
  Allowance out;
  if (c.of_function()) {
    out.claim = densities.vanishes(0) ? infinity : std::ldexp(claim.largest, -densities.exponent());
    out.largest = out.claim * share.of_norm;
    return out;
  }
  for (std::size_t k = 0; k < claim.norms.size(); ++k) {
    out.norm_room.push_back(
        densities.vanishes(k) ? infinity : std::ldexp(claim.norms[k], -length - densities.exponent(k)));
    out.norm = std::min(out.norm, out.norm_room[k]);
  }
  for (std::size_t k = 0; k < claim.radii.size(); ++k) {
    out.product_room.push_back(
        densities.vanishes(k + 1)
            ? infinity
            : std::ldexp(claim.radii[k], -2 * length - densities.exponent() - densities.exponent(1 + k)));
    out.product = std::min(out.product, out.product_room[k]);
  }
  for (double& room : out.norm_room) room = out.norm > 0 ? room / out.norm : 1;
  for (double& room : out.product_room) room = out.product > 0 ? room / out.product : 1;
  out.norm *= share.of_norm;
  out.product *= share.of_product;
  return out;
}

/// Whether something is claimed to be 0, or so near to it, that no rounded computation could prove it.
std::optional<Refusal> zero_fault(const PolyhedronCertificate& c, const Scene& scene,
                                  const Densities& densities, std::size_t element) {
  if (c.faces[c.elements[element].face].reflectivity.sign() == 0) return std::nullopt;
  const Allowance allowance = allowance_of(c, densities, element, scene.exponent(), {1, 1});
  // Of a largest value, less than roundings of w and q leave.
  const double least = c.of_function() && !densities.vanishes(0)
                           ? 0x1p-44 * densities.reflectivity(element) *
                                 (densities.largest_of(0) + densities.q_size_of(element, 0))
                           : 0;
  if (allowance.norm > 0 && allowance.product > 0 && allowance.largest > least) return std::nullopt;
  if (least > 0)
    return Refusal{place("/claims", element) + "/largest", "claims less than doubles can tell from 0"};
  return Refusal{place("/claims", element), "claims that something is exactly 0"};
}

std::optional<Refusal> element_fault(const PolyhedronCertificate& c, const Scene& scene,
                                     const Densities& densities, const ElementCheck& elements, bool is_open,
                                     std::size_t element) {
  std::optional<Refusal> fault;
  const Face& face = c.faces[c.elements[element].face];
  if (face.reflectivity.sign() == 0) {
    // rho t^2 and w_k t_0 = rho y t_0 are 0.
    const ResidualBounds nothing{.norms = std::vector<double>(c.functions()),
                                 .products = std::vector<double>(c.goals()),
                                 .radii = std::vector<double>(c.goals()),
                                 .doubts = {}};
    return claim_fault(c, element, nothing, scene.exponent(), densities);
  }
  // The last time the claim is not to be refused for what rules leave. Shade is a large part of a claim, and
  // half of it takes four times as many cells.
  std::vector<Share> shares = is_open ? std::vector<Share>{{0.07, 0.5}, {0.007, 0.05}}
                                      : std::vector<Share>{{0.4, 0.7}, {0.2, 0.5}, {0.07, 0.3}};
  if (c.of_function()) {
    shares = is_open ? std::vector<Share>{{0.15, 0}, {0.05, 0}, {0.015, 0}}
                     : std::vector<Share>{{0.4, 0}, {0.15, 0}, {0.05, 0}};
    const double claimed = allowance_of(c, densities, element, scene.exponent(), {1, 1}).claim;
    // A claim that is false by much is not worth the search for cells.
    ResidualBounds inside;
    inside.largest = elements.residual_inside(element, std::min(1e-6, 0.1 * claimed));
    if ((fault = claim_fault(c, element, inside, scene.exponent(), densities))) return fault;
  }
  for (const Share& share : shares) {
    const Allowance allowance = allowance_of(c, densities, element, scene.exponent(), share);
    const ResidualBounds proved = elements.bounds(element, allowance);
    fault = claim_fault(c, element, proved, scene.exponent(), densities);
    if (!fault || (!is_open && is_hopeless(c, element, proved, scene.exponent(), densities))) return fault;
  }
  return fault;
}

std::optional<Refusal> sums_fault(const PolyhedronCertificate& c) {
  if (c.of_function()) return function_fault(c);
  const ClaimSums claims = sums_of_claims(c);
  for (std::size_t k = 0; k < c.functions(); ++k)
    if (!certainly_at_most(sqrt(claims.squares[k]), Ball(c.sums.norms[k])))
      return Refusal{place("/sums/norms", k), "is less than what the claims sum to"};
  for (std::size_t k = 0; k < c.goals(); ++k)
    if (!certainly_at_most(abs(claims.products[k] - Ball(c.sums.products[k])) + claims.radii[k],
                           Ball(c.sums.radii[k])))
      return Refusal{place("/sums/products", k), "with its radius does not hold what the claims sum to"};
  const std::vector<Ball> means = means_of(c, c.sums);
  for (std::size_t k = 0; k < means.size(); ++k) {
    const Enclosure& stated = c.enclosures[k];
    if (!certainly_at_most(abs(means[k] - Ball(stated.midpoint)), Ball(stated.radius)))
      return Refusal{place(c.of_values() ? "/values" : "/means", k),
                     "with its radius does not hold what the sums prove, " + means[k].to_text(12)};
    if (Rational(2) * stated.radius > c.width)
      return Refusal{place(c.of_values() ? "/values" : "/means", k),
                     "is wider than the width that is stated"};
  }
  return std::nullopt;
}

}  // namespace

Summed summed(const PolyhedronCertificate& c) {
  const ClaimSums claims = sums_of_claims(c);
  Summed out;
  for (const Ball& square : claims.squares) out.sums.norms.push_back(above(sqrt(square)));
  for (std::size_t k = 0; k < c.goals(); ++k) {
    const double middle = claims.products[k].to_double();
    out.sums.products.push_back(middle);
    out.sums.radii.push_back(above(abs(claims.products[k] - Ball(middle)) + claims.radii[k]));
  }
  for (const Ball& mean : means_of(c, out.sums)) {
    // A little wider: both may be rounded to the decimals that read back as the same doubles, and radii of
    // balls have 30 bits.
    const double midpoint = mean.to_double();
    const double radius =
        abs(mean - Ball(midpoint)).upper_double() * (1 + 0x1p-24) + std::abs(midpoint) * 0x1p-50;
    out.enclosures.push_back(
        {Rational::exactly(midpoint), Rational::exactly(std::nextafter(radius, infinity))});
  }
  return out;
}

Report check(const PolyhedronCertificate& c, const Part& part, const CheckListener& progress) {
  Report report;
  for (const auto& fault : {&surface_fault, &reflectivity_fault, &points_fault, &tiling_fault, &sums_fault}) {
    report.refusal = fault(c);
    if (report.refusal) return report;
  }
  report.looked_at = chosen_elements(c.elements.size(), part);
  const Scene scene(c);
  const Densities densities(c);
  for (const std::size_t element : report.looked_at)
    if (report.refusal = zero_fault(c, scene, densities, element); report.refusal) return report;
  const LineBounds lines(c, scene, densities);
  const BallTransport transport(c, scene, densities, lines);
  const Sight sight(c, scene);
  const PointKernels kernels(c, scene, densities, sight);
  const Shades shades(c, densities);
  const ElementCheck elements(c, scene, densities, lines, transport, kernels, sight, shades);
  report.refusal = first_fault(
      report.looked_at,
      [&](std::size_t element) {
        return element_fault(c, scene, densities, elements, sight.is_open(), element);
      },
      progress);
  return report;
}

}  // namespace radcert::certificate
