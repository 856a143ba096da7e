// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/psg10/sphere_over_disk/estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/work_limit.h"
#include "radcert/reference/values/families.h"
#include "radcert/scalar/ball.h"
#include "verification/claims/psg10/sphere_over_disk/cubature.h"

namespace radcert::verification::psg10 {
namespace {

using Digits = Mpfr<50>;
using Part = SphereOverDiskPoint::Part;

/// Finer discretisations bring no digits any more: their Gauss rules end at 192 points.
const WorkLimit most_nodes_a_panel("psg10/sphere_over_disk/estimate: nodes a panel", 96, 2,
                                   "refused, with the difference of the last two discretisations");
constexpr int points_of(int nodes) { return 2 * nodes; }

/// The steps of the double exponential rules: at 16 points a unit their error is below that of double.
constexpr int fine_points = 16;
constexpr int coarse_points = 12;

template <class R>
R sine_of_latitude(const SphereOverDiskPoint& point) {
  using std::sin;
  if (point.poles != 0) return R(point.poles);
  return sin(from_rational<R>(point.place));
}

template <class R>
Radiance<R> radiance(const SphereOverDisk<R>& solution, const SphereOverDiskPoint& point) {
  return point.part == Part::sphere ? solution.sphere(sine_of_latitude<R>(point))
                                    : solution.disk(from_rational<R>(point.place));
}

double by_cubature(const SphereOverDisk<double>& solution, const SphereOverDiskPoint& point,
                   int points_a_unit) {
  const double emission = radiance(solution, point).emission;
  return emission + (point.part == Part::sphere
                         ? indirect_on_sphere(solution, sine_of_latitude<double>(point), points_a_unit)
                         : indirect_on_disk(solution, point.place.to_double(), points_a_unit));
}

Ball around(const Digits& midpoint, const Digits& radius) {
  return widened(Ball(midpoint.to_rational()), Ball(radius.to_rational()));
}

SphereOverDiskRule rule_with(int nodes) { return {.nodes = nodes, .points = points_of(nodes)}; }

}  // namespace

std::span<const reference::ValueParameter> sphere_over_disk_parameters() {
  static const std::array<reference::ValueParameter, 5> all = {
      reference::values::positive("radius", "5"), reference::values::positive("disk_radius", "40"),
      reference::values::positive("height", "20"), reference::values::from_to_below("albedo", "9/10", 0, 1),
      reference::values::positive("intensity", "9/10")};
  return all;
}

SphereOverDiskScene sphere_over_disk_scene(const reference::Arguments& arguments) {
  expects(arguments.size() == sphere_over_disk_parameters().size(), "a value for each parameter",
          named("values", arguments.size()));
  return {.radius = arguments[0],
          .disk_radius = arguments[1],
          .height = arguments[2],
          .albedo = arguments[3],
          .intensity = arguments[4]};
}

bool allows(const SphereOverDiskScene& scene, const SphereOverDiskPoint& point) {
  if (point.part == Part::disk)
    return point.poles == 0 && point.place.sign() >= 0 && point.place <= scene.disk_radius;
  if (point.poles != 0) return point.place.sign() == 0 && std::abs(point.poles) == 1;
  const BallPrecision precision(4096);
  const Ball quarter = Ball::pi() / Ball(2);
  return certainly_at_most(Ball(point.place), quarter) && certainly_at_most(-Ball(point.place), quarter);
}

const std::string& sphere_over_disk_route() {
  static const std::string how =
      "collocation on panels and Nystrom's interpolation, the azimuth in closed form; two discretisations "
      "compared";
  return how;
}

const std::string& sphere_over_disk_second_route() {
  static const std::string how =
      "double exponential cubature of the kernel over what the point sees, applied to the solution in double";
  return how;
}

namespace {

Outcome<std::vector<EstimatedRadiance>> estimated(const SphereOverDiskScene& scene,
                                                  std::span<const SphereOverDiskPoint> points, int digits) {
  expects(1 <= digits && digits <= most_sphere_over_disk_digits, "1 <= digits <= 24",
          named("digits", digits));
  for (const SphereOverDiskPoint& point : points)
    expects(allows(scene, point), "a point of the scene", named("place", point.place),
            named("poles", point.poles));
  const BallPrecision precision(256);
  const Digits demanded(power(Rational(10), -digits) / Rational(2));
  // Rounding adds up over some thousand terms of the order of the intensity.
  const Digits rounding = Digits(65536) * Digits::unit_roundoff() * Digits(scene.intensity);
  std::vector<EstimatedRadiance> out;
  int nodes = 8 + 2 * digits;
  auto coarse = std::make_unique<SphereOverDisk<Digits>>(scene, rule_with(nodes));
  int coarse_nodes = nodes;
  const int most_nodes = static_cast<int>(most_nodes_a_panel.value());
  for (nodes += 8;; nodes = std::min(most_nodes, nodes * 4 / 3)) {
    auto fine = std::make_unique<SphereOverDisk<Digits>>(scene, rule_with(nodes));
    out.clear();
    Digits largest = 0;
    for (const SphereOverDiskPoint& point : points) {
      const Radiance<Digits> value = radiance(*fine, point);
      const Digits radius = abs(value.indirect - radiance(*coarse, point).indirect) + rounding;
      largest = max(largest, radius);
      out.push_back({.total = around(value.total(), radius),
                     .emission = around(value.emission, rounding),
                     .indirect = around(value.indirect, radius),
                     .second = Ball()});
    }
    if (largest <= demanded) break;
    if (nodes >= most_nodes)
      return because("two discretisations with " + std::to_string(coarse_nodes) + " and " +
                     std::to_string(nodes) + " nodes a panel differ by " + largest.to_text(3));
    coarse = std::move(fine);
    coarse_nodes = nodes;
  }
  const SphereOverDisk<double> solution(scene, rule_with(nodes));
  const SphereOverDisk<double> coarser(scene, rule_with(coarse_nodes));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double value = by_cubature(solution, points[i], fine_points);
    const double radius = std::max(std::abs(value - by_cubature(solution, points[i], coarse_points)),
                                   std::abs(value - by_cubature(coarser, points[i], fine_points))) +
                          1e-13 * scene.intensity.to_double();
    out[i].second = widened(Ball(value), Ball(radius));
    if (!overlaps(out[i].total, out[i].second))
      return because("two routes do not agree: " + out[i].total.to_text() + " and " +
                     out[i].second.to_text());
  }
  return out;
}

}  // namespace

Outcome<std::vector<EstimatedRadiance>> estimate(const SphereOverDiskScene& scene,
                                                 std::span<const SphereOverDiskPoint> points, int digits) {
  try {
    return estimated(scene, points, digits);
  } catch (const AccuracyNotReached& refusal) {
    return because(refusal.what());
  }
}

std::vector<CurvePoint> curves(const SphereOverDiskScene& scene, int count) {
  expects(2 <= count, "2 <= count", named("count", count));
  const SphereOverDisk<Digits> solution(scene, rule_with(32));
  std::vector<CurvePoint> out;
  const auto add = [&out](Part part, const Digits& place, bool lit, const Radiance<Digits>& value) {
    out.push_back({.part = part,
                   .place = place.to_double(),
                   .lit = lit,
                   .total = value.total().to_double(),
                   .emission = value.emission.to_double(),
                   .indirect = value.indirect.to_double()});
  };
  for (int i = 0; i < count; ++i) {
    const Digits latitude = Digits::pi() * Digits(Rational(2 * i - count + 1, 2 * (count - 1)));
    const Digits sine = i == 0 ? Digits(-1) : i == count - 1 ? Digits(1) : sin(latitude);
    add(Part::sphere, latitude, Digits(0) < sine, solution.sphere(sine));
  }
  const auto add_rim = [&] {
    const Digits rim(scene.radius);
    const Radiance<Digits> value = solution.disk(rim);
    add(Part::disk, rim, false, {.emission = 0, .indirect = value.indirect});
    add(Part::disk, rim, true, value);
  };
  bool rim_is_open = true;
  for (int i = 0; i < count; ++i) {
    const Rational place = scene.disk_radius * Rational(i, count - 1);
    if (rim_is_open && scene.radius <= place) {
      add_rim();
      rim_is_open = false;
    }
    if (place != scene.radius)
      add(Part::disk, Digits(place), scene.radius < place, solution.disk(Digits(place)));
  }
  return out;
}

}  // namespace radcert::verification::psg10
