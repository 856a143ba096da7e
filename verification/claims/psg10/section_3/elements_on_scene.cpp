// SPDX-License-Identifier: GPL-3.0-or-later

// What section III asks of a basis, for one set of sites of the paper's scene, their doubles and those of the
// radii taken as they are.
//
// Checked      The supports cover the scene: sphere and disk are cut into cells of latitude or distance and
//              of azimuth, in balls, until each is certainly in the support of one element: nearer than
//              alpha_i, or 4 alpha_i c by (15), c the cosine of the normals, and c > 0. A cell that stays
//              open where the work ends is not covered if its middle is certainly in no support. Rejected:
//              supports of half the distance to the nearest other site. Independence: where sum_j c_j phi_j =
//              0 it is 0 at the sites, and c = 0 if the matrix phi_j(p_i) is regular: its entries in balls,
//              proved regular by an approximate inverse (verified_system). Rejected: an element taken twice.
//              Shepard's are independent for all sites: the matrix is the identity, section_4_interpolation.
// Not checked  other sets of sites.

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "radcert/meshless/radial_element.h"
#include "radcert/solve/verified_system.h"
#include "verification/claims/psg10/section_7/sites_on_scene.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

Site<Ball> in_balls(const Site<double>& site) {
  const auto of = [](const Vector<double>& v) { return Vector<Ball>{Ball(v.x), Ball(v.y), Ball(v.z)}; };
  return {of(site.point), of(site.normal)};
}
std::vector<Site<Ball>> in_balls(const SiteSet& sites) {
  std::vector<Site<Ball>> balls;
  for (std::size_t i = 0; i < sites.size(); ++i) balls.push_back(in_balls(sites[i]));
  return balls;
}

/// The disk by s = distance/40 and t = azimuth/(2 pi), and the sphere by s = latitude/pi + 1/2.
Site<Ball> on_disk(const Ball& s, const Ball& t) {
  const Ball azimuth = Ball(2) * Ball::pi() * t;
  const Ball distance = Ball(40) * s;
  return {{distance * cos(azimuth), distance * sin(azimuth), 0}, {0, 0, 1}};
}
Site<Ball> on_sphere(const Ball& s, const Ball& t) {
  const Ball azimuth = Ball(2) * Ball::pi() * t;
  const Ball latitude = Ball::pi() * (s - Ball(Rational(1, 2)));
  const Vector<Ball> normal{cos(latitude) * cos(azimuth), cos(latitude) * sin(azimuth), sin(latitude)};
  return {Vector<Ball>{0, 0, 20} + Ball(5) * normal, normal};
}

/// Where elements are positive.
class Supports {
public:
  explicit Supports(const RadialBasis& basis)
      : points_(basis.sites().points),
        normals_(basis.sites().normals),
        rounded_radii_(basis.radii().begin(), basis.radii().end()),
        sites_(in_balls(basis.sites())),
        is_sensitive_(basis.choice().distance == SiteDistance::normal_sensitive),
        reach_(basis.choice().mother.kind == MotherKind::spline ? Ball(1)
                                                                : Ball(*basis.choice().mother.support)) {
    for (const double radius : basis.radii()) radii_.emplace_back(radius);
  }

  [[nodiscard]] bool certainly_contains(std::size_t i, const Site<Ball>& p) const {
    return certainly_positive(cosine(i, p)) && certainly_less(square(i, p), bound(i, p));
  }
  [[nodiscard]] bool certainly_excludes(std::size_t i, const Site<Ball>& p) const {
    return certainly_at_most(cosine(i, p), Ball(0)) || certainly_less(bound(i, p), square(i, p));
  }
  /// Whether one of the elements that seem to reach farthest beyond the cell's middle contains it.
  [[nodiscard]] bool cover(const Site<Ball>& cell) const {
    const Vector<double> p{cell.point.x.to_double(), cell.point.y.to_double(), cell.point.z.to_double()};
    const Vector<double> n{cell.normal.x.to_double(), cell.normal.y.to_double(), cell.normal.z.to_double()};
    std::array<std::pair<double, std::size_t>, 3> best;
    best.fill({-std::numeric_limits<double>::infinity(), 0});
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      const double cosine = dot(n, normals_[i]);
      if (cosine <= 0) continue;
      const double margin =
          reach_.to_double() * rounded_radii_[i] * (is_sensitive_ ? cosine : 1) - norm(p - points_[i]);
      if (margin <= best.back().first) continue;
      best.back() = {margin, i};
      std::sort(best.begin(), best.end(), std::greater<>());
    }
    return std::any_of(best.begin(), best.end(),
                       [&](const auto& candidate) { return certainly_contains(candidate.second, cell); });
  }
  [[nodiscard]] bool leave_out(const Site<Ball>& point) const {
    for (std::size_t i = 0; i < sites_.size(); ++i)
      if (!certainly_excludes(i, point)) return false;
    return true;
  }

private:
  [[nodiscard]] Ball cosine(std::size_t i, const Site<Ball>& p) const {
    return dot(p.normal, sites_[i].normal);
  }
  [[nodiscard]] Ball square(std::size_t i, const Site<Ball>& p) const {
    const Vector<Ball> step = p.point - sites_[i].point;
    return dot(step, step);
  }
  [[nodiscard]] Ball bound(std::size_t i, const Site<Ball>& p) const {
    const Ball radius = reach_ * radii_[i] * (is_sensitive_ ? cosine(i, p) : Ball(1));
    return radius * radius;
  }

  std::vector<Vector<double>> points_;
  std::vector<Vector<double>> normals_;
  std::vector<double> rounded_radii_;
  std::vector<Site<Ball>> sites_;
  std::vector<Ball> radii_;
  bool is_sensitive_;
  Ball reach_;
};

struct Cell {
  double s = 0;
  double t = 0;
  double width = 1;   ///< in s
  double height = 1;  ///< in t
};

/// 0 where the supports cover the scene, 1 where a point is in none, between them where that is not decided.
Approximation whether_not_covered(const RadialBasis& basis) {
  constexpr double finest = 0x1p-10;
  const Supports supports(basis);
  for (const auto& piece : {on_disk, on_sphere}) {
    std::vector<Cell> cells{{}};
    while (!cells.empty()) {
      const Cell cell = cells.back();
      cells.pop_back();
      const auto across = [](double from, double width) { return hull(Ball(from), Ball(from + width)); };
      if (supports.cover(piece(across(cell.s, cell.width), across(cell.t, cell.height)))) continue;
      if (cell.width < finest && cell.height < finest) {
        const Site<Ball> middle = piece(Ball(cell.s + cell.width / 2), Ball(cell.t + cell.height / 2));
        return supports.leave_out(middle) ? Approximation::exact(1) : Approximation::proved(0.5, 0.5);
      }
      // An azimuth is some six times as long as a distance.
      Cell half = cell;
      Cell other = cell;
      if (cell.width > 4 * cell.height) {
        half.width = other.width = cell.width / 2;
        other.s += half.width;
      } else {
        half.height = other.height = cell.height / 2;
        other.t += half.height;
      }
      cells.push_back(half);
      cells.push_back(other);
    }
  }
  return Approximation::exact(0);
}

RadialBasis basis_with(RadialBasisChoice choice, std::size_t neighbour) {
  choice.radius.neighbour = neighbour;
  return basis_on(sites_on_scene(1), std::move(choice));
}

/// I - A, a_ij = phi_j(p_i), and what the entries may be off by; an element in the place of the one before
/// it, or none.
struct Interpolation {
  Matrix<double> defect;
  Matrix<double> radius;
};
Interpolation interpolation(const RadialBasis& basis) {
  const std::vector<Site<Ball>> sites = in_balls(basis.sites());
  std::vector<Ball> radii;
  for (const double radius : basis.radii()) radii.emplace_back(radius);
  const std::size_t n = sites.size();
  Interpolation result{.defect = Matrix<double>(n, n), .radius = Matrix<double>(n, n)};
  for (std::size_t i = 0; i < n; ++i) {
    const std::vector<Ball> row = basis_values<Ball>(basis.choice(), sites, radii, sites[i]);
    for (std::size_t j = 0; j < n; ++j) {
      const Ball entry = Ball(i == j ? 1 : 0) - row[j];
      const double value = entry.to_double();
      result.defect(i, j) = value;
      result.radius(i, j) = abs(entry - Ball(value)).upper_double();
    }
  }
  return result;
}

/// 0 where A is proved regular, and between 0 and 1 where not.
Approximation whether_dependent(Interpolation of) {
  return verified_system(std::move(of.defect), std::move(of.radius)) ? Approximation::exact(0)
                                                                     : Approximation::proved(0.5, 0.5);
}
/// The same with the second element equal to the first: 1, for its column of A is that of the first, if the
/// proof does not take it for regular.
Approximation whether_dependent_with_twins(Interpolation of) {
  for (std::size_t i = 0; i < of.defect.rows(); ++i) {
    const double unit_first = i == 0 ? 1 : 0;
    const double unit_second = i == 1 ? 1 : 0;
    of.defect(i, 1) = unit_second - (unit_first - of.defect(i, 0));
    of.radius(i, 1) = of.radius(i, 0) + std::numeric_limits<double>::epsilon();
  }
  return whether_dependent(std::move(of)).radius == 0 ? Approximation::exact(0) : Approximation::exact(1);
}

}  // namespace

Finding section_3_cover(const Bench&) {
  const Equals no{.value = 0, .slack = 0, .why = "each point is in a support"};
  RadialBasisChoice narrow = lehtinen_basis();
  narrow.mother = gaussian_mother(Rational(1, 2));
  Finding finding;
  finding.require("whether a point is in no support, Lehtinen", no,
                  whether_not_covered(basis_with(lehtinen_basis(), 10)));
  finding.require("whether a point is in no support, Gauss cut at 4", no,
                  whether_not_covered(basis_with(gaussian_basis(), 10)));
  finding.control("whether a point is in no support, half of the distance to the nearest other", no,
                  whether_not_covered(basis_with(narrow, 1)));
  return finding;
}

Finding section_3_independent(const Bench&) {
  const Equals no{.value = 0, .slack = 0, .why = "the matrix is regular"};
  const Interpolation lehtinen = interpolation(basis_with(lehtinen_basis(), 10));
  const Interpolation gaussian = interpolation(basis_with(gaussian_basis(), 10));
  Finding finding;
  finding.require("whether the elements may be dependent, Lehtinen", no, whether_dependent(lehtinen));
  finding.require("whether the elements may be dependent, Gauss", no, whether_dependent(gaussian));
  finding.control("whether they are, Lehtinen, the second element taken for the first", no,
                  whether_dependent_with_twins(lehtinen));
  return finding;
}

}  // namespace radcert::verification::psg10
