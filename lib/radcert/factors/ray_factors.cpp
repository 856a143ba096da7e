// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/ray_factors.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/digest.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/parallel.h"
#include "radcert/core/text.h"
#include "radcert/factors/certified_exchange.h"
#include "radcert/factors/convex_parts.h"
#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_classes.h"
#include "radcert/polynomial/rules/sobol_net.h"

namespace radcert {

namespace {

using Point = Vector<double>;

constexpr std::size_t replicates = 32;
/// Two-sided, 1 - 10^-4, 31 degrees of freedom: 4.4810, rounded up.
constexpr double quantile = 4.49;
/// Where a unit is hit with probability p and never met in n rays, p n <= log(10^4) but for 1 in 10,000.
constexpr double rare_hits = 10;
constexpr std::uint64_t first_points = 1024;
/// From round to round, of the points of a row whose radii are too large.
constexpr double growth = 1.5;

/// A ray, with the plane in which it starts.
struct Ray {
  std::size_t plane = 0;
  Point eye;
  Point step;
};

/// The first units along rays. Triangles of one plane and one unit count alike: they are joined into convex
/// polygons.
class FirstHits {
public:
  FirstHits(const FacetScene& scene, const FactorUnits& units) {
    const PlaneClasses classes = plane_classes(scene.scene().mesh());
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> members;
    for (std::size_t t = 0; t < scene.facet_count(); ++t)
      members[{classes.of_triangle[t], units.of_triangle[t]}].push_back(t);
    std::vector<BoundingBox> boxes;
    for (const auto& [key, triangles] : members)
      for (const ConvexPart& part : convex_parts(scene.scene(), triangles)) {
        Polygon polygon{.normal = scene.unit_normal(part.triangle),
                        .first = corners_.size(),
                        .count = part.corners.size(),
                        .plane = scene.scene().plane(part.triangle),
                        .unit = key.second};
        BoundingBox box{part.corners.front(), part.corners.front()};
        for (const Point& p : part.corners) box = hull(box, {p, p});
        corners_.insert(corners_.end(), part.corners.begin(), part.corners.end());
        polygons_.push_back(polygon);
        boxes.push_back(box);
      }
    tree_ = BoxTree(std::move(boxes), TreeParting::least_surface);
  }

  struct Hit {
    std::size_t unit = 0;
    bool front = false;
  };

  [[nodiscard]] std::optional<Hit> along(const Ray& ray) const {
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    // Zero in a step makes infinities, which the comparisons below take as they should; 0 * infinity is no
    // number, and std::min and std::max then keep their first argument.
    const Point inverse{1 / ray.step.x, 1 / ray.step.y, 1 / ray.step.z};
    double nearest = nowhere;
    std::optional<Hit> hit;
    tree_.search(
        -nowhere,
        [&](const BoundingBox& box) {
          double from = 0;
          double to = nearest;
          clip(box.low.x, box.high.x, ray.eye.x, inverse.x, from, to);
          clip(box.low.y, box.high.y, ray.eye.y, inverse.y, from, to);
          clip(box.low.z, box.high.z, ray.eye.z, inverse.z, from, to);
          return from <= to ? -from : -nowhere;
        },
        [&](std::size_t k) {
          // What lies in the plane from which the ray starts is not met, nor is the other side of a plate.
          if (polygons_[k].plane != ray.plane) meet(polygons_[k], ray, nearest, hit);
          return -nearest;
        });
    return hit;
  }

private:
  struct Polygon {
    Point normal;
    std::size_t first;  ///< of its corners
    std::size_t count;
    std::size_t plane;
    std::size_t unit;
  };

  /// Leaves of [from, to] what lies between two planes; each end is off by three roundings.
  static void clip(double low, double high, double eye, double inverse, double& from, double& to) {
    const double a = (low - eye) * inverse;
    const double b = (high - eye) * inverse;
    constexpr double outwards = 8 * std::numeric_limits<double>::epsilon();
    const double first = std::min(a, b);
    const double last = std::max(a, b);
    from = std::max(from, first - outwards * std::abs(first));
    to = std::min(to, last + outwards * std::abs(last));
  }

  /// The determinants change their sign exactly with the order of a side's ends, so that a ray that passes
  /// one polygon at the side meets its neighbour there, where they have both ends in common.
  void meet(const Polygon& polygon, const Ray& ray, double& nearest, std::optional<Hit>& hit) const {
    const double along = dot(polygon.normal, ray.step);
    if (along == 0) return;
    const Point* corner = &corners_[polygon.first];
    const double distance = dot(polygon.normal, corner[0] - ray.eye) / along;
    const bool front = along < 0;
    // Both sides of a plate are met at once: the one that looks at the ray counts.
    constexpr double roundings = 0x1p-40;
    const bool together = hit && std::abs(distance - nearest) <= roundings * nearest;
    if (!(distance > 0) || (together ? hit->front || !front : distance >= nearest)) return;
    Point before = corner[polygon.count - 1] - ray.eye;
    bool positive = false;
    bool negative = false;
    for (std::size_t k = 0; k < polygon.count; ++k) {
      const Point here = corner[k] - ray.eye;
      const double moment = dot(ray.step, cross(before, here));
      positive = positive || moment > 0;
      negative = negative || moment < 0;
      before = here;
    }
    if (positive && negative) return;
    nearest = distance;
    hit = Hit{polygon.unit, front};
  }

  std::vector<Polygon> polygons_;
  std::vector<Point> corners_;
  BoxTree tree_;
};

/// Points and directions of a unit.
class UnitSampler {
public:
  UnitSampler(const FacetScene& scene, const std::vector<std::size_t>& triangles) {
    for (const std::size_t t : triangles) {
      area_ += scene.area(t);
      up_to_.push_back(area_);
      const std::array<Point, 3> c = scene.scene().corners(t);
      const Point& normal = scene.unit_normal(t);
      const Point side = std::abs(normal.x) < 0.5 ? Point{1, 0, 0} : Point{0, 1, 0};
      const Point first = cross(side, normal);
      const Point u = (1 / norm(first)) * first;
      places_.push_back(
          {scene.scene().plane(t), c[0], c[1] - c[0], c[2] - c[0], u, cross(normal, u), normal});
    }
  }

  [[nodiscard]] Ray at(const std::array<double, SobolNet::dimensions>& x) const {
    const double place = x[0] * area_;
    const auto found = std::upper_bound(up_to_.begin(), up_to_.end(), place);
    const std::size_t k = std::min(static_cast<std::size_t>(found - up_to_.begin()), places_.size() - 1);
    const double before = k == 0 ? 0 : up_to_[k - 1];
    // What is left of the first number is uniform again.
    const double within = std::clamp((place - before) / (up_to_[k] - before), 0.0, 1.0);
    const double root = std::sqrt(within);
    const Place& t = places_[k];
    const Point eye = t.corner + (root * (1 - x[1])) * t.first + (root * x[1]) * t.second;
    const auto [a, b] = disk_point(x[2], x[3]);
    const double up = std::sqrt(std::max(0.0, 1 - a * a - b * b));
    return {t.plane, eye, a * t.u + b * t.v + up * t.normal};
  }

private:
  struct Place {
    std::size_t plane;
    Point corner;
    Point first;  ///< from the corner to the others
    Point second;
    Point u;  ///< two unit vectors across the normal
    Point v;
    Point normal;
  };

  /// Squares about the middle of the unit square go to circles, areas in proportion.
  static std::pair<double, double> disk_point(double s, double t) {
    const double a = 2 * s - 1;
    const double b = 2 * t - 1;
    if (a == 0 && b == 0) return {0, 0};
    const bool wide = std::abs(a) > std::abs(b);
    const double radius = wide ? a : b;
    const double angle =
        wide ? std::numbers::pi / 4 * (b / a) : std::numbers::pi / 2 - std::numbers::pi / 4 * (a / b);
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

  std::vector<Place> places_;  ///< its triangles
  std::vector<double> up_to_;  ///< areas up to and with each
  double area_ = 0;
};

/// Hits of a row: of each replicate those on each unit.
struct RowCount {
  std::uint64_t points = 0;  ///< of each replicate
  std::vector<std::uint64_t> hits;
};

class RayCounts {
public:
  RayCounts(const FacetScene& scene, const FactorUnits& units)
      : scene_(scene), units_(units), first_hits_(scene, units), rows_(units.names.size()) {
    std::vector<std::vector<std::size_t>> members(units.names.size());
    for (std::size_t t = 0; t < scene.facet_count(); ++t) members[units.of_triangle[t]].push_back(t);
    for (const std::vector<std::size_t>& triangles : members) samplers_.emplace_back(scene, triangles);
    for (RowCount& row : rows_) row.hits.assign(replicates * size(), 0);
    constexpr std::mt19937_64::result_type seed = 20260;
    std::mt19937_64 random(seed);
    for (std::size_t r = 0; r < replicates; ++r) nets_.emplace_back(random);
    shifts_.resize(size() * replicates);
    for (SobolNet::Digits& shift : shifts_) shift = SobolNet::draw_shift(random);
  }

  [[nodiscard]] std::size_t size() const { return units_.names.size(); }
  [[nodiscard]] RowCount& row(std::size_t i) { return rows_[i]; }
  [[nodiscard]] const RowCount& row(std::size_t i) const { return rows_[i]; }

  /// More points for a row.
  void extend(std::size_t row, std::uint64_t points) {
    RowCount& count = rows_[row];
    constexpr std::uint64_t grain = 2048;
    const std::uint64_t blocks = (points - count.points + grain - 1) / grain;
    std::mutex mutex;
    parallel_for(static_cast<std::size_t>(blocks) * replicates, 1, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint64_t> hits(size());
      for (std::size_t block = begin; block < end; ++block) {
        std::fill(hits.begin(), hits.end(), 0);
        const std::size_t replicate = block % replicates;
        const std::uint64_t from = count.points + block / replicates * grain;
        const std::uint64_t to = std::min(points, from + grain);
        SobolNet::Digits point = nets_[replicate].at(from);
        for (std::uint64_t k = from; k < to; ++k) {
          const auto x = SobolNet::shifted(point, shifts_[row * replicates + replicate]);
          const auto hit = first_hits_.along(samplers_[row].at(x));
          if (hit && hit->front) ++hits[hit->unit];
          nets_[replicate].advance(point, k);
        }
        const std::scoped_lock lock(mutex);
        for (std::size_t j = 0; j < hits.size(); ++j) count.hits[replicate * size() + j] += hits[j];
      }
    });
    count.points = points;
  }

private:
  const FacetScene& scene_;
  const FactorUnits& units_;
  FirstHits first_hits_;
  std::vector<UnitSampler> samplers_;
  std::vector<RowCount> rows_;
  std::vector<SobolNet> nets_;            ///< of each replicate
  std::vector<SobolNet::Digits> shifts_;  ///< of each row's replicates
};

/// The mean of independent numbers, with the radius of ray_factors.
Approximation mean_of(const std::array<double, replicates>& x, double rays) {
  double sum = 0;
  for (const double one : x) sum += one;
  const double mean = sum / replicates;
  double squares = 0;
  for (const double one : x) squares += (one - mean) * (one - mean);
  const double error = std::sqrt(squares / (replicates - 1) / replicates);
  return Approximation::estimated(mean, quantile * error + rare_hits / rays + 0x1p-40 * mean);
}

/// What the counts say of a row.
class RowEstimate {
public:
  RowEstimate(const RayCounts& counts, const std::vector<double>& areas, std::size_t row)
      : counts_(counts), areas_(areas), row_(row) {}

  [[nodiscard]] Approximation factor(std::size_t to) const {
    const double other = row_ == to ? 0 : weight(to);
    return mean_of(values(to), (weight(row_) + other) * areas_[row_] * replicates);
  }
  [[nodiscard]] Approximation sum() const {
    std::array<double, replicates> sums{};
    for (std::size_t to = 0; to < counts_.size(); ++to) {
      const auto x = values(to);
      for (std::size_t r = 0; r < replicates; ++r) sums[r] += x[r];
    }
    return mean_of(sums, static_cast<double>(counts_.row(row_).points) * replicates);
  }

private:
  /// Rays of a replicate over the area.
  [[nodiscard]] double weight(std::size_t row) const {
    return static_cast<double>(counts_.row(row).points) / areas_[row];
  }
  /// Of each replicate, E / A of this row: E from both sides.
  [[nodiscard]] std::array<double, replicates> values(std::size_t to) const {
    const auto fraction = [&](std::size_t from, std::size_t onto, std::size_t replicate) {
      const RowCount& row = counts_.row(from);
      return static_cast<double>(row.hits[replicate * counts_.size() + onto]) /
             static_cast<double>(row.points);
    };
    const double mine = weight(row_);
    const double other = weight(to);
    std::array<double, replicates> out{};
    for (std::size_t r = 0; r < replicates; ++r)
      out[r] =
          row_ == to
              ? fraction(row_, row_, r)
              : (mine * areas_[row_] * fraction(row_, to, r) + other * areas_[to] * fraction(to, row_, r)) /
                    (mine + other) / areas_[row_];
    return out;
  }

  const RayCounts& counts_;
  const std::vector<double>& areas_;
  std::size_t row_;
};

double largest_radius(const RowEstimate& estimate, std::size_t count) {
  double largest = estimate.sum().radius;
  for (std::size_t to = 0; to < count; ++to) largest = std::max(largest, estimate.factor(to).radius);
  return largest;
}

/// Which units have triangles that look at each other.
class SightOfUnits {
public:
  SightOfUnits(const FacetScene& scene, const FactorUnits& units)
      : scene_(scene), members_(units.names.size()) {
    for (std::size_t t = 0; t < scene.facet_count(); ++t) members_[units.of_triangle[t]].push_back(t);
  }
  /// False: no two triangles have parts in front of each other, exactly.
  [[nodiscard]] bool possible(std::size_t one, std::size_t other) const {
    for (const std::size_t a : members_[one])
      for (const std::size_t b : members_[other])
        if (has_in_front(a, b) && has_in_front(b, a)) return true;
    return false;
  }

private:
  [[nodiscard]] bool has_in_front(std::size_t triangle, std::size_t other) const {
    const std::array<Point, 3> plane = scene_.scene().corners(triangle);
    const std::array<Point, 3> points = scene_.scene().corners(other);
    return std::any_of(points.begin(), points.end(),
                       [&](const Point& p) { return orientation(plane[0], plane[1], plane[2], p) > 0; });
  }
  const FacetScene& scene_;
  std::vector<std::vector<std::size_t>> members_;
};

std::vector<double> unit_areas(const FacetScene& scene, const FactorUnits& units) {
  std::vector<double> areas(units.names.size(), 0);
  const double square = (scene.unit() * scene.unit()).to_double();
  for (std::size_t t = 0; t < scene.facet_count(); ++t) areas[units.of_triangle[t]] += square * scene.area(t);
  return areas;
}

/// The points of a row when it will be done: the standard error of these integrands, which jump in four
/// dimensions, falls as the points to the -5/8.
double final_points(std::uint64_t points, double radius, const RayDemand& demand) {
  constexpr double power = 8.0 / 5;
  const double more = std::max(1.0, std::pow(radius / demand.accuracy, power));
  const double steps = std::ceil(std::log(more) / std::log(growth));
  return std::min(static_cast<double>(demand.most_points),
                  static_cast<double>(points) * std::pow(growth, steps));
}

std::uint64_t grown(std::uint64_t points) {
  return static_cast<std::uint64_t>(std::ceil(growth * static_cast<double>(points)));
}

/// Hits are counted by unit.
std::string key_of(const FactorProgress& progress, const FactorUnits& units) {
  std::string numbers;
  for (const std::size_t unit : units.of_triangle) numbers += std::to_string(unit) + "\n";
  return progress.key + "\nunits " + digest_of(numbers);
}

std::string count_key(const std::string& key, std::size_t row, std::uint64_t points) {
  return key + "\nrays of row " + std::to_string(row) + ", points " + std::to_string(points);
}

std::string count_text(const RowCount& count) {
  std::string out;
  for (const std::uint64_t hits : count.hits) out += std::to_string(hits) + "\n";
  return out;
}

bool read_count(const std::string& text, std::uint64_t points, RowCount& count) {
  std::vector<std::uint64_t> hits;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  while (at != end) {
    std::uint64_t number = 0;
    const auto [after, error] = std::from_chars(at, end, number);
    if (error != std::errc() || after == end || *after != '\n') return false;
    hits.push_back(number);
    at = after + 1;
  }
  if (hits.size() != count.hits.size()) return false;
  count.hits = std::move(hits);
  count.points = points;
  return true;
}

}  // namespace

FactorPlan ray_plan(const FacetScene& scene, const FactorUnits& units, const RayDemand& demand) {
  using Clock = std::chrono::steady_clock;
  FactorPlan plan;
  const std::uint64_t m = units.names.size();
  plan.memory.add("hits", m * m, (replicates + 1) * sizeof(std::uint64_t));
  plan.memory.add("factors", m * m, sizeof(ConfigurationFactor) + 64);
  constexpr std::uint64_t points_of_plan = 4 * first_points;
  RayCounts counts(scene, units);
  const auto start = Clock::now();
  for (std::size_t i = 0; i < counts.size(); ++i) counts.extend(i, points_of_plan);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const std::vector<double> areas = unit_areas(scene, units);
  double points = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    points += final_points(points_of_plan, largest_radius({counts, areas, i}, counts.size()), demand);
  plan.pairs = static_cast<std::uint64_t>(points) * replicates;
  plan.radius = demand.accuracy;
  plan.seconds = seconds * points / static_cast<double>(points_of_plan * m);
  return plan;
}

FactorMatrix ray_factors(const FacetScene& scene, const FactorUnits& units, const RayDemand& demand,
                         const FactorProgress& progress) {
  expects(units.of_triangle.size() == scene.facet_count(), "a unit for each triangle",
          named("units", units.of_triangle.size()));
  expects(demand.accuracy > 0, "accuracy > 0", named("accuracy", demand.accuracy));
  RayCounts counts(scene, units);
  const std::string key_of_scene = key_of(progress, units);
  const std::vector<double> areas = unit_areas(scene, units);
  const std::size_t size = counts.size();
  std::vector<std::uint64_t> wanted(size, std::min(first_points, demand.most_points));
  double done = 0;
  double all = std::numeric_limits<double>::infinity();
  for (bool changed = true; changed;) {
    for (std::size_t i = 0; i < size; ++i) {
      throw_if_interrupted();
      if (counts.row(i).points == wanted[i]) continue;
      done += static_cast<double>(wanted[i] - counts.row(i).points);
      const std::string key = count_key(key_of_scene, i, wanted[i]);
      const auto kept = progress.store == nullptr ? std::nullopt : progress.store->get(key);
      if (!kept || !read_count(*kept, wanted[i], counts.row(i))) {
        counts.extend(i, wanted[i]);
        if (progress.store != nullptr) static_cast<void>(progress.store->put(key, count_text(counts.row(i))));
      }
      progress.at(done / all);
    }
    changed = false;
    all = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const double radius = largest_radius({counts, areas, i}, size);
      all += final_points(counts.row(i).points, radius, demand);
      if (radius <= demand.accuracy || counts.row(i).points >= demand.most_points) continue;
      wanted[i] = std::min(grown(counts.row(i).points), demand.most_points);
      changed = true;
    }
  }

  FactorMatrix matrix;
  matrix.rows.resize(size);
  for (std::size_t t = 0; t < scene.facet_count(); ++t)
    matrix.rows[units.of_triangle[t]].area += enclosing(certified_area(scene, t));
  const SightOfUnits sight(scene, units);
  std::vector<std::vector<Approximation>> exchange(size);  // of a row with those from it on
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = i; j < size; ++j) {
      Approximation factor = RowEstimate(counts, areas, i).factor(j);
      if (factor.value == 0 && !sight.possible(i, j)) factor = Approximation::exact(0);
      exchange[i].push_back({factor.value * areas[i], factor.radius * areas[i]});
    }
  for (std::size_t i = 0; i < size; ++i) {
    FactorRow& row = matrix.rows[i];
    std::vector<ConfigurationFactor> factors;
    double defect = 0;
    for (std::size_t j = 0; j < size; ++j) {
      const Approximation& both = i <= j ? exchange[i][j - i] : exchange[j][i - j];
      if (both.value == 0 && both.radius == 0) continue;
      const Approximation factor = exchange_over_area(both, row.area);
      factors.push_back({i, j, factor});
      const Approximation& other = matrix.rows[j].area;
      const double back = exchange_over_area(both, other).value;
      defect = std::max(defect, reciprocity_defect(row.area.value, factor.value, other.value, back));
    }
    row.sum = RowEstimate(counts, areas, i).sum();
    if (demand.open_to_space) row.to_space = Approximation::exact(1) + -row.sum;
    matrix.take(factors, defect, progress.row);
  }
  for (std::size_t i = 0; i < size; ++i) matrix.rays += counts.row(i).points * replicates;
  return matrix;
}

}  // namespace radcert
