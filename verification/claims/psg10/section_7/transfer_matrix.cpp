// SPDX-License-Identifier: GPL-3.0-or-later

// What the entries of R are, and which of them are 0.
//
// Checked      "R_jk is the share of the photons of element k that element j scatters", and "column k is the
//              coefficients of what the scene looks like by element k": two coaxial disks of radii 1 and 4, 3
//              apart, by closed forms in balls, over the albedo: of the photons of the large one F_21 are
//              scattered by the small one; the radiance of the small one, the large one's being 1, is F_12.
//              They differ by the quotient of the integrals, 16, as the kernel is symmetric. Rejected: the
//              quotient of the radii. "R is not very sparse in general": a very sparse matrix has a few
//              entries a row however many rows; here the share of entries that are not 0 stays as the sites
//              grow in number, in the paper's own scene, where sphere and disk see each other alone, and in
//              lit_room(). Its exponent in the separation is within 1/2 of 0, and not 2, as for the matrix
//              phi_j(p_i) of Lehtinen's basis: rejected. "The inverse of I - R is usually full": for entries
//              that are not negative it has a positive entry (i, j) where a path leads from j to i; the share
//              of the others is at most a tenth in both scenes. Rejected: R itself, of the paper's scene.
// Not checked  other scenes, on which "in general" and "usually" depend.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "radcert/closed_form/factor_catalogue.h"
#include "radcert/meshless/sampling.h"
#include "radcert/meshless/transfer_matrix.h"
#include "verification/claims/psg10/scenes/lit_room.h"
#include "verification/claims/psg10/scenes/sphere_over_disk.h"
#include "verification/claims/psg10/section_7/sites_on_scene.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

/// Which sites see which: [j] are the sites that the light of site j reaches.
using Sight = std::vector<std::vector<std::size_t>>;

Sight sight(const LightScene& scene, const SiteSet& sites) {
  const Matrix<double> r = point_light_transfer(scene, sites, std::vector<double>(sites.size(), 1.0));
  double largest = 0;
  for (std::size_t j = 0; j < r.columns(); ++j)
    for (std::size_t i = 0; i < r.rows(); ++i) largest = std::max(largest, r(i, j));
  // Sites of one plane see each other by rounding alone.
  const double rounding = 1e-12 * largest;
  Sight result(sites.size());
  for (std::size_t j = 0; j < r.columns(); ++j)
    for (std::size_t i = 0; i < r.rows(); ++i)
      if (r(i, j) > rounding) result[j].push_back(i);
  return result;
}
Sight sight_in_paper_scene(double separation) {
  return sight(sphere_over_disk_light_scene().value(), sites_on_scene(1, separation));
}
Sight sight_in_room(double separation) {
  const LightScene scene = lit_room().scene;
  return sight(scene, poisson_disk_sites(scene.surface(), {.separation = separation, .seed = 1}).value());
}

double share_of(std::size_t entries, std::size_t sites) {
  return static_cast<double>(entries) / static_cast<double>(sites * sites);
}

/// The share of the entries of R that are 0.
double zeros(const Sight& sight) {
  std::size_t seen = 0;
  for (const auto& column : sight) seen += column.size();
  return 1 - share_of(seen, sight.size());
}
/// The same of (I - R)^-1, whose diagonal is positive.
double zeros_of_inverse(const Sight& sight) {
  std::size_t reached = 0;
  for (std::size_t from = 0; from < sight.size(); ++from) {
    std::vector<bool> is_reached(sight.size());
    std::vector<std::size_t> ahead{from};
    is_reached[from] = true;
    std::size_t count = 1;
    while (!ahead.empty() && count < sight.size()) {
      const std::size_t at = ahead.back();
      ahead.pop_back();
      for (const std::size_t next : sight[at]) {
        if (is_reached[next]) continue;
        is_reached[next] = true;
        ahead.push_back(next);
        ++count;
      }
    }
    reached += count;
  }
  return 1 - share_of(reached, sight.size());
}

Approximation counted(double share) { return {.value = share, .radius = 0}; }

}  // namespace

Finding section_7_photons(const Bench&) {
  const BallPrecision precision(160);
  const Ball of_photons = coaxial_disks(4, 1, 3);
  const AgreesWith coefficient{.value = coaxial_disks(1, 4, 3), .within = 1e-20};
  Finding finding;
  finding.require("share of the large disk's photons that the small one scatters", coefficient, of_photons);
  finding.instead("the same times the quotient of the integrals, 16", coefficient, Ball(16) * of_photons);
  finding.control("the same times the quotient of the radii, 4", coefficient, Ball(4) * of_photons);
  return finding;
}

Finding section_7_sparse(const Bench&) {
  // The exponent of the separation with which the share of entries that are not 0 falls when it is halved.
  const auto order = [](double coarse, double fine) { return counted(std::log2(coarse / fine)); };
  const auto not_zero = [](const Sight& sight) { return 1 - zeros(sight); };
  const LiesIn stays{.least = Rational(-1, 2), .largest = Rational(1, 2)};
  const auto of_elements = [](double separation) {
    const RadialBasis basis = basis_on(sites_on_scene(1, separation), lehtinen_basis());
    BasisValues room;
    std::size_t entries = 0;
    for (std::size_t i = 0; i < basis.size(); ++i)
      if (basis.evaluate(basis.sites()[i], room)) entries += room.size();
    return share_of(entries, basis.size());
  };
  const double of_paper = not_zero(sight_in_paper_scene(3));
  const double of_room = not_zero(sight_in_room(0.8));
  Finding finding;
  finding.require("order of the share of entries that are not 0, the paper's scene, separation 3 to 3/2",
                  stays, order(of_paper, not_zero(sight_in_paper_scene(1.5))));
  finding.require("order of the share of entries that are not 0, lit_room(), separation 4/5 to 2/5", stays,
                  order(of_room, not_zero(sight_in_room(0.4))));
  finding.control("the same of the matrix phi_j(p_i), Lehtinen's basis, the paper's scene", stays,
                  order(of_elements(3), of_elements(1.5)));
  finding.remark("share of the entries of R that are not 0, the paper's scene, separation 3",
                 counted(of_paper));
  finding.remark("share of the entries of R that are not 0, lit_room(), separation 4/5", counted(of_room));
  return finding;
}

Finding section_7_full_inverse(const Bench&) {
  const AtMost tenth{.value = 0.1, .slack = 0, .why = "usually full: nine tenths of the entries are not 0"};
  const Sight paper = sight_in_paper_scene(paper_separation);
  Finding finding;
  finding.require("share of the entries of (I - R)^-1 that are 0, the paper's scene", tenth,
                  counted(zeros_of_inverse(paper)));
  finding.require("share of the entries of (I - R)^-1 that are 0, lit_room()", tenth,
                  counted(zeros_of_inverse(sight_in_room(0.4))));
  finding.control("the same of R itself, the paper's scene", tenth, counted(zeros(paper)));
  return finding;
}

}  // namespace radcert::verification::psg10
