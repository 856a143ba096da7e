// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/radial_basis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/expression/batch.h"
#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/neighbour_tree.h"
#include "radcert/meshless/radial_element.h"
#include "radcert/scalar/pack.h"

namespace radcert {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Two sites at distance zero, if there are any.
std::optional<std::pair<std::size_t, std::size_t>> coincident(const SiteSet& sites, SiteDistance distance) {
  const NeighbourTree tree(sites.points);
  std::optional<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = 0; i < sites.size() && !found; ++i)
    tree.visit_by_distance(sites.points[i], [&](std::size_t j, double squared) {
      if (squared > 0) return false;
      if (j == i || sites.points[i] != sites.points[j]) return true;
      if (distance != SiteDistance::euclidean && !(dot(sites.normals[i], sites.normals[j]) > 0)) return true;
      found = std::minmax(i, j);
      return false;
    });
  return found;
}

/// About the ball, so much wider that no rounding of a distance, or of a normal's length, puts what is in the
/// ball outside.
BoundingBox box_about_ball(const Vector<double>& centre, double radius) {
  const double size = std::max({std::abs(centre.x), std::abs(centre.y), std::abs(centre.z)});
  const double width = radius * (1 + 0x1p-40) + size * 0x1p-50;
  const Vector<double> half{width, width, width};
  return {centre - half, centre + half};
}

/// Numbers of the sites in the order of the tree, padded to whole packs.
struct SiteArrays {
  std::vector<double> x, y, z, normal_x, normal_y, normal_z, radius;

  void add(const Vector<double>& p, const Vector<double>& n, double alpha) {
    x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
    normal_x.push_back(n.x), normal_y.push_back(n.y), normal_z.push_back(n.z);
    radius.push_back(alpha);
  }
};

/// Makes the values of a normalised basis of raw ones. False if the sum is not a positive number.
bool normalise(std::span<double> values) {
  const auto sum_of = [&] {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum;
  };
  double sum = sum_of();
  if (!std::isfinite(sum)) {
    const auto infinities = static_cast<double>(std::count(values.begin(), values.end(), infinite));
    if (infinities > 0) {
      for (double& value : values) value = value == infinite ? 1 / infinities : 0;
      return true;
    }
    // Finite values whose sum is not; a NaN stays one.
    for (double& value : values) value *= 0x1p-64;
    sum = sum_of();
  }
  if (!(sum > 0) || !std::isfinite(sum)) return false;
  for (double& value : values) value /= sum;
  return true;
}

}  // namespace

struct RadialBasis::Parts {
  SiteSet sites;
  RadialBasisChoice choice;
  std::vector<double> radii;
  double support = infinite;                     ///< in relative distance
  std::optional<CompiledExpression> expression;  ///< the mother function, where it is one
  BoxTree tree;                                  ///< of the supports; a leaf is looked at in one pack
  SiteArrays arrays;

  void gather(const Site<double>& p, BasisValues& out) const;
  void apply_mother(BasisValues& out) const;
  template <SiteDistance distance>
  void look_at_leaf(std::size_t begin, const Site<double>& p, BasisValues& out) const;
  template <SiteDistance distance>
  void gather_by(const Site<double>& p, BasisValues& out) const;
};

// Relative distances, to the bit as raw_element has them.
template <SiteDistance distance>
void RadialBasis::Parts::look_at_leaf(std::size_t begin, const Site<double>& p, BasisValues& out) const {
  const Vector<Pack> step{Pack(p.point.x) - Pack::load(&arrays.x[begin]),
                          Pack(p.point.y) - Pack::load(&arrays.y[begin]),
                          Pack(p.point.z) - Pack::load(&arrays.z[begin])};
  const Vector<Pack> normal{Pack::load(&arrays.normal_x[begin]), Pack::load(&arrays.normal_y[begin]),
                            Pack::load(&arrays.normal_z[begin])};
  const Pack length = norm(step);
  const Pack radius = Pack::load(&arrays.radius[begin]);
  const Pack cosine = dot({Pack(p.normal.x), Pack(p.normal.y), Pack(p.normal.z)}, normal);
  const Pack relative =
      distance == SiteDistance::normal_sensitive ? length / (radius * cosine) : length / radius;
  const std::size_t end = std::min(begin + Pack::lanes, sites.size());
  for (std::size_t i = begin; i < end; ++i) {
    const double c = cosine.lane(i - begin);
    const double r = relative.lane(i - begin);
    // Written in any case and kept by the count: half of all comparisons would be mispredicted.
    out.sites_[out.count_] = tree.order()[i];
    out.distances_[out.count_] = r;
    out.factors_[out.count_] = c;
    const bool in_reach = r <= support && (distance == SiteDistance::euclidean || c > 0);
    out.count_ += in_reach ? 1 : 0;
  }
}

template <SiteDistance distance>
void RadialBasis::Parts::gather_by(const Site<double>& p, BasisValues& out) const {
  if (support < infinite) {
    const Vector<double>& at = p.point;
    tree.visit_leaves(
        [&](const BoundingBox& box) {
          return box.low.x <= at.x && at.x <= box.high.x && box.low.y <= at.y && at.y <= box.high.y &&
                 box.low.z <= at.z && at.z <= box.high.z;
        },
        [&](std::size_t begin, std::size_t) {
          look_at_leaf<distance>(begin, p, out);
          return true;
        });
  } else {
    for (std::size_t begin = 0; begin < sites.size(); begin += Pack::lanes)
      look_at_leaf<distance>(begin, p, out);
  }
}

void RadialBasis::Parts::gather(const Site<double>& p, BasisValues& out) const {
  out.count_ = 0;
  const std::size_t room = arrays.x.size() + 1;  // one place behind the last is written to
  if (out.sites_.size() < room) {
    out.sites_.resize(room);
    out.values_.resize(room);
    out.distances_.resize(room);
    out.factors_.resize(room);
  }
  switch (choice.distance) {
    case SiteDistance::normal_sensitive: return gather_by<SiteDistance::normal_sensitive>(p, out);
    case SiteDistance::euclidean_with_normal_factor:
      return gather_by<SiteDistance::euclidean_with_normal_factor>(p, out);
    case SiteDistance::euclidean: return gather_by<SiteDistance::euclidean>(p, out);
  }
}

void RadialBasis::Parts::apply_mother(BasisValues& out) const {
  const std::span<const double> r = std::span(out.distances_).first(out.count_);
  const std::span<double> values = std::span(out.values_).first(out.count_);
  const auto each = [&](const auto& mother) { std::transform(r.begin(), r.end(), values.begin(), mother); };
  switch (choice.mother.kind) {
    case MotherKind::gaussian: each(gaussian_bell<double>); break;
    case MotherKind::spline: each(spline_bell<double>); break;
    case MotherKind::shepard: each(inverse_square<double>); break;
    case MotherKind::own: each(choice.mother.own.in_double); break;
    case MotherKind::expression: expression->evaluate_radial(r, values); break;
  }
  if (choice.distance == SiteDistance::euclidean_with_normal_factor)
    for (std::size_t k = 0; k < values.size(); ++k) values[k] *= out.factors_[k];
}

RadialBasis::RadialBasis(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}

Outcome<RadialBasis> RadialBasis::make(SiteSet sites, RadialBasisChoice choice) {
  expects(sites.points.size() == sites.normals.size(), "a normal for each point",
          named("points", sites.points.size()), named("normals", sites.normals.size()));
  if (sites.size() == 0) return because("a radial basis needs at least one site");
  auto parts = std::make_shared<Parts>();
  if (choice.radius.neighbour) {
    Outcome<std::vector<double>> radii =
        neighbour_radii(sites, choice.distance, *choice.radius.neighbour, choice.radius.too_few);
    if (!radii) return because(radii.reason());
    parts->radii = std::move(radii).value();
  } else {
    parts->radii.assign(sites.size(), 1.0);
  }
  if (const auto two = coincident(sites, choice.distance))
    return because("sites " + std::to_string(two->first) + " and " + std::to_string(two->second) +
                   " coincide: no basis could tell them apart");
  if (choice.normalise == Normalisation::none && choice.mother.value(0.0) == infinite)
    return because("the mother function " + choice.mother.to_text() +
                   " is infinite at 0: its elements have values only when they are normalised");
  if (choice.mother.support) parts->support = choice.mother.support->to_double();
  if (choice.mother.kind == MotherKind::expression) parts->expression.emplace(choice.mother.expression);

  std::vector<BoundingBox> supports;
  for (std::size_t i = 0; i < sites.size(); ++i)
    supports.push_back(box_about_ball(sites.points[i], parts->radii[i] * parts->support));
  parts->tree = BoxTree(std::move(supports), sites.points, Pack::lanes);
  for (const std::size_t i : parts->tree.order())
    parts->arrays.add(sites.points[i], sites.normals[i], parts->radii[i]);
  while (parts->arrays.x.size() < padded<double>(sites.size())) parts->arrays.add({}, {}, 1);
  parts->sites = std::move(sites);
  parts->choice = std::move(choice);
  return RadialBasis(std::shared_ptr<const Parts>(std::move(parts)));
}

std::size_t RadialBasis::size() const { return parts_->sites.size(); }
const SiteSet& RadialBasis::sites() const { return parts_->sites; }
const RadialBasisChoice& RadialBasis::choice() const { return parts_->choice; }
std::span<const double> RadialBasis::radii() const { return parts_->radii; }

bool RadialBasis::interpolates() const {
  return parts_->choice.normalise == Normalisation::partition_of_unity &&
         parts_->choice.mother.value(0.0) == infinite;
}

bool RadialBasis::evaluate(const Site<double>& p, BasisValues& out) const {
  parts_->gather(p, out);
  parts_->apply_mother(out);
  const std::span<double> values = std::span(out.values_).first(out.count_);
  const bool has_values = parts_->choice.normalise == Normalisation::partition_of_unity
                              ? normalise(values)
                              : out.count_ > 0 && std::all_of(values.begin(), values.end(),
                                                              [](double v) { return std::isfinite(v); });
  if (!has_values) out.count_ = 0;
  return has_values;
}

std::optional<double> RadialBasis::at(const Site<double>& p, std::span<const double> coefficients) const {
  const Site<double> points[] = {p};
  return at(points, coefficients).front();
}

std::vector<std::optional<double>> RadialBasis::at(std::span<const Site<double>> points,
                                                   std::span<const double> coefficients) const {
  expects(coefficients.size() == size(), "a coefficient for each site",
          named("coefficients", coefficients.size()), named("sites", size()));
  std::vector<std::optional<double>> results(points.size());
  parallel_for(points.size(), [&](std::size_t begin, std::size_t end) {
    BasisValues room;
    for (std::size_t k = begin; k < end; ++k) {
      if (!evaluate(points[k], room)) continue;
      double sum = 0;
      for (std::size_t i = 0; i < room.size(); ++i) sum += room.values()[i] * coefficients[room.sites()[i]];
      results[k] = sum;
    }
  });
  return results;
}

}  // namespace radcert
