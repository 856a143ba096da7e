// SPDX-License-Identifier: GPL-3.0-or-later

// Radii and integrals of the elements, on the paper's scene with sites 3 apart, and on squares.
//
// Checked      "integral = constant alpha^2" on a plane: 2 pi Int Phi(r/alpha) r dr by enclosed quadrature,
//              alpha = 3/2, against 3 pi/10 alpha^2 for K and 2 pi (1 - e^-8) alpha^2 for G cut at 4.
//              Rejected: elements on a line in the place of the plane. Over the paper's scene: the sum of constant alpha^2
//              against that of the integrals, cut up by place. "expected value 1/delta": the mean of w_j over
//              a scene is area/n, as the elements sum to 1. Rejected: Gauss' elements. pi alpha^2/t: the mean
//              of delta pi alpha^2/t, t = 10, over sites away from the rim of a square, sites anywhere and
//              sites apart; rejected at the rim. Over the paper's scene: sum of pi alpha^2/t over area; on
//              the sphere alone it holds. Radii: whether each site has ten others, or nine, for whom p_i is
//              one of the ten, at a finite distance (15). Supports: whether they cover the scene; whether the elements are independent,
//              by the condition of phi_j(p_i). N for R: whether constant coefficients give constant values.
//              Figure 9: that sites of separation 3 are 3 apart, exactly, for their rounded coordinates.
// Not checked  other scenes; the sites of the paper's figure 9; a proof for curved surfaces.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "radcert/enclosure/interval_integral.h"
#include "radcert/meshless/interpolation_system.h"
#include "radcert/meshless/light_scene.h"
#include "radcert/meshless/sampling.h"
#include "radcert/meshless/weights.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "verification/claims/ac98/surfaces/proved_number.h"
#include "verification/claims/psg10/scenes/sphere_over_disk.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

using std::numbers::pi;

constexpr std::size_t ten = 10;
constexpr double separation = 3;

const Surface& scene() {
  static const Surface surface = sphere_over_disk_surface();
  return surface;
}
constexpr double scene_area = (4 * 25 + 1600) * pi;

SiteSet scene_sites(std::uint64_t seed) {
  return poisson_disk_sites(scene(), {.separation = separation, .seed = seed}).value();
}

/// Where a site has too few others at a finite distance, the farthest of them.
RadialBasis basis_on(const SiteSet& sites, RadialBasisChoice choice) {
  choice.radius.too_few = TooFewNeighbours::farthest;
  return RadialBasis::make(sites, choice).value();
}

constexpr int square_side = 60;

Surface square() {
  Surface surface;
  surface.name = "square";
  surface.charts.push_back(make_rectangle({.name = "square", .piece = "square"}, {0, 0, 0},
                                          {Rational(square_side), 0, 0}, {0, Rational(square_side), 0}));
  surface.diagonals.assign(1, Diagonal::main);
  return surface;
}

/// The mean of delta pi alpha^2 / 10 over the sites at least so far from the rim, or over those that are
/// nearer to it, alpha the distance of the tenth other. The radius is twice the standard error of the mean;
/// each ten sites count as one, since their discs overlap.
Approximation mean_ratio(const SiteSet& sites, double rim, bool inside) {
  const std::vector<double> radii = neighbour_radii(sites, SiteDistance::euclidean, ten).value();
  double sum = 0;
  double squares = 0;
  double count = 0;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Vector<double>& p = sites.points[i];
    const double from_rim = std::min({p.x, p.y, square_side - p.x, square_side - p.y});
    if ((from_rim >= rim) != inside) continue;
    const double square = radii[i] * radii[i];
    sum += square;
    squares += square * square;
    count += 1;
  }
  const double inner = (square_side - 2 * rim) * (square_side - 2 * rim);
  const double density = count / (inside ? inner : square_side * square_side - inner);
  const double scale = pi * density / ten;
  const double mean = sum / count;
  const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
  return {.value = scale * mean, .radius = scale * 2 * deviation * std::sqrt(ten / count)};
}
Approximation inner_ratio(const SiteSet& sites) { return mean_ratio(sites, 6, true); }
Approximation ratio_at_rim(const SiteSet& sites) { return mean_ratio(sites, 3, false); }

/// The sum of pi alpha^2 / 10 over the sites of the scene for which `wanted`, over `area`.
template <class Wanted>
Approximation scene_ratio(SiteDistance distance, double area, const Wanted& wanted) {
  const SiteSet sites = scene_sites(1);
  const std::vector<double> radii = neighbour_radii(sites, distance, ten, TooFewNeighbours::farthest).value();
  double sum = 0;
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (wanted(sites.points[i])) sum += pi * radii[i] * radii[i] / ten;
  return {.value = sum / area, .radius = 1e-9};
}

/// 2 pi Int Phi(r / alpha) r dr, Phi a polynomial or the Gaussian, alpha = 3/2; on a line 2 Int Phi(r / alpha)
/// dr.
Ball stretched_integral(MotherKind kind, bool on_line = false) {
  const Rational alpha(3, 2);
  const bool is_spline = kind == MotherKind::spline;
  const auto integrand = [is_spline, on_line, alpha](const auto& r) {
    using R = std::decay_t<decltype(r)>;
    const R x = r / R(alpha);
    const R bell = is_spline ? R(R(2) * x * x * x - R(3) * x * x + R(1)) : R(exp(-(x * x) / R(2)));
    return on_line ? bell : R(bell * r);
  };
  const Ball end = Ball(alpha) * Ball(is_spline ? 1 : 4);
  return Ball(2) * (on_line ? Ball(1) : Ball::pi()) *
         ac98::known(integral_on_interval(line_function(integrand), Ball(0), end, {.radius = 1e-24}));
}

/// Sites whose tenth other is at an infinite distance: how many of so many sets have one.
double sets_without_radii(SiteDistance distance, std::size_t neighbour, int sets) {
  double count = 0;
  for (int seed = 1; seed <= sets; ++seed)
    if (!neighbour_radii(scene_sites(static_cast<std::uint64_t>(seed)), distance, neighbour)) count += 1;
  return count;
}

Approximation mean_integral(const RadialBasisChoice& choice) {
  const BasisIntegrals integrals =
      integrate_basis(basis_on(scene_sites(1), choice), scene(), {.relative_error = 0.05});
  return {.value = std::accumulate(integrals.weights.begin(), integrals.weights.end(), 0.0) / integrals.area,
          .radius = 1e-10};
}

/// Points of 20000 anywhere on the scene without an element that is not zero.
Approximation not_covered(RadialBasisChoice choice, std::size_t neighbour) {
  choice.radius.neighbour = neighbour;
  const RadialBasis basis = basis_on(scene_sites(1), choice);
  const SiteSet points = uniform_sites(scene(), {.count = 20000, .seed = 2}).value();
  BasisValues room;
  double count = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!basis.evaluate(points[k], room)) count += 1;
  return {.value = count, .radius = 0};
}

Approximation condition(const SiteSet& sites, const RadialBasisChoice& choice) {
  const auto system = InterpolationSystem::make(basis_on(sites, choice));
  return {.value = system ? system->condition() : std::numeric_limits<double>::max(), .radius = 0};
}

/// The mean over the sites of the value there with all coefficients 1.
Approximation mean_value(const RadialBasisChoice& choice) {
  const RadialBasis basis = basis_on(scene_sites(1), choice);
  const std::vector<double> ones(basis.size(), 1.0);
  double sum = 0;
  for (std::size_t i = 0; i < basis.size(); ++i) sum += basis.at(basis.sites()[i], ones).value();
  return {.value = sum / static_cast<double>(basis.size()), .radius = 1e-10};
}

/// Pairs of sites nearer to each other than `least`, their doubles taken as they are.
Rational pairs_nearer_than(const SiteSet& sites, const Rational& least) {
  const double certainly_apart = 1.01 * least.to_double() * least.to_double();
  long total = 0;
  for (std::size_t i = 0; i < sites.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vector<double>& p = sites.points[i];
      const Vector<double>& q = sites.points[j];
      if (dot(p - q, p - q) > certainly_apart) continue;
      const Rational x = Rational::exactly(p.x) - Rational::exactly(q.x);
      const Rational y = Rational::exactly(p.y) - Rational::exactly(q.y);
      const Rational z = Rational::exactly(p.z) - Rational::exactly(q.z);
      if (x * x + y * y + z * z < least * least) ++total;
    }
  return total;
}

}  // namespace

Finding section_7_plane_integral(const Bench&) {
  const BallPrecision precision(160);
  const Rational alpha(3, 2);
  const Ball spline = plane_integral(spline_mother()).value();
  const Ball gaussian = plane_integral(gaussian_mother()).value();
  const AgreesWith of_spline{.value = spline * Ball(alpha * alpha), .within = 1e-20};
  const AgreesWith of_gaussian{.value = gaussian * Ball(alpha * alpha), .within = 1e-20};
  Finding finding;
  finding.require("integral of K(r/alpha), alpha = 3/2", of_spline, stretched_integral(MotherKind::spline));
  finding.require("integral of G(r/alpha) up to 4 alpha, alpha = 3/2", of_gaussian,
                  stretched_integral(MotherKind::gaussian));
  finding.control("integral of K(r/alpha) on a line in the place of the plane", of_spline,
                  stretched_integral(MotherKind::spline, true));
  finding.control("integral of G(r/alpha) up to 4 alpha on a line in the place of the plane", of_gaussian,
                  stretched_integral(MotherKind::gaussian, true));
  return finding;
}

Finding section_7_plane_integral_scene(const Bench&) {
  const Equals one{.value = 1, .slack = 0.1, .why = "a tenth: an estimate"};
  const RadialBasis basis = basis_on(scene_sites(1), gaussian_basis());
  const std::vector<double> plane = plane_weights(basis).value();
  const std::vector<double> exact = integrate_basis(basis, scene(), {.relative_error = 0.05}).weights;
  // The quotient of the sums over the sites of the sphere, of the disk away from its rim, and of the rest of
  // the disk.
  constexpr double rim = 12;
  std::array<double, 3> of_plane{};
  std::array<double, 3> of_scene{};
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const Vector<double>& p = basis.sites().points[i];
    const std::size_t where = p.z > 1 ? 0 : std::hypot(p.x, p.y) < rim ? 1 : 2;
    of_plane[where] += plane[i];
    of_scene[where] += exact[i];
  }
  const auto quotient = [&](std::size_t k) {
    return Approximation{.value = of_plane[k] / of_scene[k], .radius = 0.01 * of_plane[k] / of_scene[k]};
  };
  Finding finding;
  finding.require("constant alpha^2 over w_j, Gauss, the disk within 12 of the axis", one, quotient(1));
  finding.require("constant alpha^2 over w_j, Gauss, the rest of the disk", one, quotient(2));
  finding.control("constant alpha^2 over w_j, Gauss, the sphere", one, quotient(0));
  return finding;
}

Finding section_7_mean_integral(const Bench&) {
  const Equals one{.value = 1, .slack = 1e-9, .why = "rounding of some ten thousand terms"};
  Finding finding;
  finding.require("mean w_j over area/n, Shepard", one, mean_integral(shepard_basis()));
  finding.require("mean w_j over area/n, Lehtinen", one, mean_integral(lehtinen_basis()));
  finding.control("mean w_j over area/n, Gauss", one, mean_integral(gaussian_basis()));
  return finding;
}

Finding section_7_estimate(const Bench& bench) {
  const Equals one{.value = 1,
                   .slack = 0.1,
                   .why = "a tenth: an estimate; discs of sites that are apart hold 10.7 others for 10"};
  const int sets = bench.budget == Budget::quick ? 2 : 8;
  const Surface plane = square();
  Finding finding;
  for (int k = 1; k <= sets; ++k) {
    const auto seed = static_cast<std::uint64_t>(k);
    const SiteSet apart = poisson_disk_sites(plane, {.separation = 1, .seed = seed}).value();
    const SiteSet anywhere = uniform_sites(plane, {.count = 3600, .seed = seed}).value();
    const std::string of = ", set " + std::to_string(k);
    finding.require("mean of delta pi alpha^2/10 in a plane, sites anywhere" + of, one,
                    inner_ratio(anywhere));
    finding.require("mean of delta pi alpha^2/10 in a plane, sites apart" + of, one, inner_ratio(apart));
    finding.control("mean of delta pi alpha^2/10 within 3 of the square's rim, sites apart" + of, one,
                    ratio_at_rim(apart));
  }
  return finding;
}

Finding section_7_estimate_scene(const Bench&) {
  const Equals one{.value = 1, .slack = 0.1, .why = "a tenth, as on the plane"};
  const auto all = [](const Vector<double>&) { return true; };
  const auto of_sphere = [](const Vector<double>& p) { return p.z > 1; };
  const auto of_disk = [](const Vector<double>& p) { return p.z < 1; };
  Finding finding;
  finding.require("sum of pi alpha^2/10 over the area, the paper's scene, Euclidean radii", one,
                  scene_ratio(SiteDistance::euclidean, scene_area, all));
  finding.control("the same, radii by (15)", one,
                  scene_ratio(SiteDistance::normal_sensitive, scene_area, all));
  finding.instead("on the sphere alone, Euclidean radii", one,
                  scene_ratio(SiteDistance::euclidean, 100 * pi, of_sphere));
  finding.remark("on the disk alone", scene_ratio(SiteDistance::euclidean, 1600 * pi, of_disk));
  finding.remark("on the sphere alone, radii by (15)",
                 scene_ratio(SiteDistance::normal_sensitive, 100 * pi, of_sphere));
  return finding;
}

Finding section_5_radius(const Bench& bench) {
  const int sets = bench.budget == Budget::quick ? 20 : 100;
  const Equals none{.value = 0, .slack = 0, .why = "each site has a radius"};
  const std::string of = std::to_string(sets);
  Finding finding;
  finding.require(
      "sets of " + of + " with a site that has no radius, Euclidean distance", none,
      Approximation{.value = sets_without_radii(SiteDistance::euclidean, ten, sets), .radius = 0});
  finding.require(
      "sets of " + of + " with a site that has no radius, distance (15)", none,
      Approximation{.value = sets_without_radii(SiteDistance::normal_sensitive, ten, sets), .radius = 0});
  finding.require(
      "the same, p_i one of the ten: nine others", none,
      Approximation{.value = sets_without_radii(SiteDistance::normal_sensitive, ten - 1, sets), .radius = 0});
  finding.control("the same with a hundred others", none,
                  Approximation{.value = sets_without_radii(SiteDistance::normal_sensitive, 10 * ten, sets),
                                .radius = 0});
  return finding;
}

Finding section_3_cover(const Bench&) {
  const Equals none{.value = 0, .slack = 0, .why = "each point is in a support"};
  Finding finding;
  finding.require("points of 20000 that no element reaches, Lehtinen", none,
                  not_covered(lehtinen_basis(), ten));
  finding.require("points of 20000 that no element reaches, Gauss cut at 4", none,
                  not_covered(gaussian_basis(), ten));
  RadialBasisChoice narrow = lehtinen_basis();
  narrow.mother.kind = MotherKind::gaussian;
  narrow.mother.support = Rational(1, 2);
  finding.control("points of 20000 that no element reaches, supports of half the nearest other", none,
                  not_covered(narrow, 1));
  return finding;
}

Finding section_3_independent(const Bench&) {
  const AtMost regular{.value = 1e11, .slack = 0, .why = "far below 2^53"};
  const SiteSet sites = scene_sites(1);
  SiteSet close = sites;
  Site<double> beside = sites[0];
  beside.point.x += 1e-13;
  close.add(beside, sites.at[0]);
  Finding finding;
  finding.require("condition of phi_j(p_i), Shepard", regular, condition(sites, shepard_basis()));
  finding.require("condition of phi_j(p_i), Gauss", regular, condition(sites, gaussian_basis()));
  finding.require("condition of phi_j(p_i), Lehtinen", regular, condition(sites, lehtinen_basis()));
  finding.control("condition of phi_j(p_i), Lehtinen, two sites 1e-13 apart", regular,
                  condition(close, lehtinen_basis()));
  return finding;
}

Finding section_7_values(const Bench&) {
  const Equals one{.value = 1, .slack = 0.1, .why = "a tenth, as for the weights"};
  Finding finding;
  finding.require("mean value at the sites with all coefficients 1, Shepard", one,
                  mean_value(shepard_basis()));
  finding.require("mean value at the sites with all coefficients 1, Lehtinen", one,
                  mean_value(lehtinen_basis()));
  finding.require("mean value at the sites with all coefficients 1, Gauss", one,
                  mean_value(gaussian_basis()));
  RadialBasisChoice raw = lehtinen_basis();
  raw.normalise = Normalisation::none;
  finding.control("mean value at the sites with all coefficients 1, (18) not normalised", one,
                  mean_value(raw));
  return finding;
}

Finding figure_9(const Bench& bench) {
  const int sets = bench.budget == Budget::quick ? 3 : 20;
  Finding finding;
  for (int seed = 1; seed <= sets; ++seed) {
    const SiteSet sites = scene_sites(static_cast<std::uint64_t>(seed));
    const std::string of = ", set " + std::to_string(seed) + " of " + std::to_string(sites.size()) + " sites";
    finding.require("pairs of sites nearer than 3" + of, IsExactly{0}, pairs_nearer_than(sites, 3));
    finding.control("pairs of sites nearer than 4" + of, IsExactly{0}, pairs_nearer_than(sites, 4));
  }
  return finding;
}

}  // namespace radcert::verification::psg10
