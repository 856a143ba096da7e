// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

#include "radcert/core/text.h"
#include "radcert/core/work_limit.h"
#include "radcert/meshless/surface_cells.h"

namespace radcert {
namespace {

// More cells than this would not fit beside anything else in memory.
const WorkLimit most_cells("meshless/sampling: cells", 1L << 22U, 1,
                           "no sites: the separation is too small for the surface");

// Covers what rounding does to an area element that is constant.
constexpr double rounding_slack = 1 + 0x1p-20;

/// The bound of some cell was too low: start anew with more slack.
struct BoundExceeded {};

class Stream {
public:
  explicit Stream(std::uint64_t seed) : bits_(seed) {}
  /// In [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(bits_() >> 11U) * 0x1p-53; }

private:
  std::mt19937_64 bits_;
};

double element_at(const Surface& surface, const SurfaceCell& cell, const ParameterPoint<double>& at) {
  return area_element(surface.charts[cell.chart].in<double>().frame(at));
}

/// max |D_s F x D_t F| on a cell: the sampled maximum and `slack` times the sampled variation.
double element_bound(const Surface& surface, const SurfaceCell& cell, double slack) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  const auto look = [&](double a, double b) {
    const double here = element_at(surface, cell, cell.at(surface, a, b));
    low = std::min(low, here);
    high = std::max(high, here);
  };
  look(0, 0);
  if (!surface.charts[cell.chart].facts().plane) {
    look(1, 0), look(0, 1), look(0.5, 0), look(0, 0.5), look(0.5, 0.5);
    look(1.0 / 3, 1.0 / 3);
  }
  return high * rounding_slack + slack * (high - low);
}

/// Throws darts at cells, uniformly by area.
class Darts {
public:
  Darts(const Surface& surface, const std::vector<SurfaceCell>& cells, double slack)
      : surface_(surface), cells_(cells) {
    double sum = 0;
    for (const SurfaceCell& cell : cells) {
      bounds_.push_back(element_bound(surface, cell, slack));
      sum += bounds_.back() * cell.parameter_area();
      sums_.push_back(sum);
    }
  }

  struct Hit {
    Site<double> site;
    SurfacePoint<double> at;
  };

  /// One dart; nothing where it is rejected.
  std::optional<Hit> throw_one(Stream& stream) const {
    const double mark = stream.uniform() * sums_.back();
    const auto found = std::upper_bound(sums_.begin(), sums_.end(), mark);
    const auto k = std::min(static_cast<std::size_t>(found - sums_.begin()), sums_.size() - 1);
    double a = stream.uniform();
    double b = stream.uniform();
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    const SurfacePoint<double> at{cells_[k].chart, cells_[k].at(surface_, a, b)};
    const Frame<double> frame = surface_.charts[at.chart].in<double>().frame(at.at);
    const double element = area_element(frame);
    if (element > bounds_[k]) throw BoundExceeded{};
    if (!(stream.uniform() * bounds_[k] < element)) return std::nullopt;
    return Hit{{frame.point, unit_normal(frame)}, at};
  }

private:
  const Surface& surface_;
  const std::vector<SurfaceCell>& cells_;
  std::vector<double> bounds_;
  std::vector<double> sums_;
};

/// Points in cubes of the edge `separation`: what is nearer than that is in a cube or beside it.
class CubeGrid {
public:
  CubeGrid(const Vector<double>& low, double separation) : low_(low), separation_(separation) {}

  void add(const Vector<double>& p) {
    cubes_[cube_of(p)].push_back(points_.size());
    points_.push_back(p);
  }

  /// Whether some point within reach of p satisfies the condition.
  template <class Condition>
  bool any_near(const Vector<double>& p, const Condition& condition) const {
    const Cube centre = cube_of(p);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz) {
          const auto found = cubes_.find({centre[0] + dx, centre[1] + dy, centre[2] + dz});
          if (found == cubes_.end()) continue;
          for (const std::size_t k : found->second)
            if (condition(points_[k])) return true;
        }
    return false;
  }

private:
  using Cube = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cube& cube) const {
      std::uint64_t h = 0;
      for (const std::int64_t c : cube) h = (h ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15U;
      return static_cast<std::size_t>(h ^ (h >> 32U));
    }
  };

  Cube cube_of(const Vector<double>& p) const {
    const auto place = [this](double x) {
      constexpr double last = 0x1p62;  // further parts share a cube: that costs time alone
      return static_cast<std::int64_t>(std::min<double>(std::floor(x / separation_), last));
    };
    const Vector<double> from_low = p - low_;
    return {place(from_low.x), place(from_low.y), place(from_low.z)};
  }

  Vector<double> low_;
  double separation_;
  std::vector<Vector<double>> points_;
  std::unordered_map<Cube, std::vector<std::size_t>, Hash> cubes_;
};

/// Runs a sampling whose bounds may turn out too low, until they do not.
template <class Sample>
SiteSet with_valid_bounds(const Sample& sample) {
  for (double slack = 1;; slack *= 2) {
    try {
      return sample(slack);
    } catch (const BoundExceeded&) {
      continue;
    }
  }
}

Vector<double> low_corner(const std::vector<SurfaceCell>& cells) {
  Vector<double> low = cells.front().images[0];
  for (const SurfaceCell& cell : cells)
    for (const Vector<double>& p : cell.images)
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  return low;
}

/// Whether one site is nearer than `reach` to the whole cell.
bool is_covered(const Surface& surface, const SurfaceCell& cell, const CubeGrid& grid, double reach) {
  const double from_corners = reach - 4 * cell.deviation(surface);
  if (!(from_corners > 0)) return false;
  return grid.any_near(cell.images[0], [&](const Vector<double>& site) {
    return std::all_of(cell.images.begin(), cell.images.end(),
                       [&](const Vector<double>& p) { return norm(p - site) < from_corners; });
  });
}

SiteSet fill(const Surface& surface, std::vector<SurfaceCell> cells, const PoissonDiskSites& choice,
             double slack) {
  const double separation = choice.separation;
  const double reach = separation * (1 + 0x1p-10);
  SiteSet sites;
  Stream stream(choice.seed);
  CubeGrid grid(low_corner(cells), reach);
  while (!cells.empty()) {
    const Darts darts(surface, cells, slack);
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::optional<Darts::Hit> hit = darts.throw_one(stream);
      if (!hit || grid.any_near(hit->site.point, [&](const Vector<double>& other) {
            return norm(hit->site.point - other) < separation;
          }))
        continue;
      sites.add(hit->site, hit->at);
      grid.add(hit->site.point);
    }
    std::vector<SurfaceCell> open;
    for (const SurfaceCell& cell : cells) {
      if (is_covered(surface, cell, grid, reach)) continue;
      const auto [first, second] = cell.halves(surface);
      for (const SurfaceCell& half : {first, second})
        if (!is_covered(surface, half, grid, reach)) open.push_back(half);
    }
    cells = std::move(open);
  }
  return sites;
}

}  // namespace

Outcome<SiteSet> uniform_sites(const Surface& surface, const UniformSites& choice) {
  if (choice.count == 0) return because("uniform sites: a count of at least 1 is needed");
  // Any size of cell gives the same distribution; on cells of no more than a division the element varies
  // little.
  const std::optional<std::vector<SurfaceCell>> cells =
      cells_below(surface, std::numeric_limits<double>::infinity(), most_cells.count());
  if (!cells || cells->empty()) return because("uniform sites: a surface with charts is needed");
  return with_valid_bounds([&](double slack) {
    SiteSet sites;
    Stream stream(choice.seed);
    const Darts darts(surface, *cells, slack);
    while (sites.size() < choice.count)
      if (const std::optional<Darts::Hit> hit = darts.throw_one(stream)) sites.add(hit->site, hit->at);
    return sites;
  });
}

Outcome<SiteSet> poisson_disk_sites(const Surface& surface, const PoissonDiskSites& choice) {
  if (!(choice.separation > 0) || !std::isfinite(choice.separation))
    return because("Poisson-disk sites: the separation " + shortest(choice.separation) +
                   " is not a positive number");
  const std::optional<std::vector<SurfaceCell>> cells =
      cells_below(surface, choice.separation, most_cells.count());
  if (!cells)
    return because("Poisson-disk sites: the separation " + shortest(choice.separation) +
                   " is too small for the surface: it would be cut into more than " +
                   std::to_string(most_cells.count()) + " cells of that size");
  if (cells->empty()) return because("Poisson-disk sites: a surface with charts is needed");
  return with_valid_bounds([&](double slack) { return fill(surface, *cells, choice, slack); });
}

Outcome<SiteSet> make_sites(const Surface& surface, const SiteChoice& choice) {
  if (const auto* disk = std::get_if<PoissonDiskSites>(&choice)) return poisson_disk_sites(surface, *disk);
  return uniform_sites(surface, std::get<UniformSites>(choice));
}

}  // namespace radcert
