// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of transport for complex observers and sources, against integrals at random complex points. The
// rules, the kernel and the moved contours are written here once more: nothing of the library is used but the
// bounds. A bound holds for all densities, and some density makes the integral that of the kernel's modulus.
#include "radcert/continuous/transport/transport_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "radcert/continuous/transport/source_rule.h"
#include "tests/continuous/scenes.h"

namespace radcert {
namespace {

using Complex = std::complex<double>;
using std::numbers::inv_pi;
using std::numbers::pi;

template <class N>
struct Triple {
  N x{};
  N y{};
  N z{};
};
using Real3 = Triple<double>;
using Complex3 = Triple<Complex>;

template <class N, class M>
auto operator+(const Triple<N>& a, const Triple<M>& b) {
  return Triple<decltype(a.x + b.x)>{a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N, class M>
auto operator-(const Triple<N>& a, const Triple<M>& b) {
  return Triple<decltype(a.x - b.x)>{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
auto operator*(const N& a, const Real3& b) {
  return Triple<N>{a * b.x, a * b.y, a * b.z};
}
/// Without conjugation.
template <class N, class M>
auto product(const Triple<N>& a, const Triple<M>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N, class M>
auto vector_product(const Triple<N>& a, const Triple<M>& b) {
  return Triple<decltype(a.x * b.x)>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Real3& a) { return std::sqrt(product(a, a)); }
Real3 direction(const Real3& a) { return (1 / length(a)) * a; }

Complex quotient(const Complex& a, const Complex& b) { return a * std::conj(b) * (1 / std::norm(b)); }

/// n_P.(Q-P) n_Q.(P-Q) / ((P-Q).(P-Q))^2 / pi.
Complex kernel(const Complex3& p, const Real3& n_p, const Complex3& q, const Real3& n_q) {
  const Complex3 way = q - p;
  const Complex squared = product(way, way);
  return quotient(-inv_pi * product(n_p, way) * product(n_q, way), squared * squared);
}

/// Legendre's zeros by Newton's iteration, and the weights.
struct GaussRule {
  static constexpr std::size_t count = 8;
  std::array<double, count> nodes{};
  std::array<double, count> weights{};

  GaussRule() {
    for (std::size_t i = 0; i < count; ++i) {
      double x = std::cos(pi * (static_cast<double>(i) + 0.75) / (count + 0.5));
      double slope = 1;
      for (int step = 0; step < 20; ++step) {
        double before = 1;
        double value = x;
        for (std::size_t k = 1; k < count; ++k)
          before = std::exchange(
              value, ((2.0 * static_cast<double>(k) + 1) * x * value - static_cast<double>(k) * before) /
                         (static_cast<double>(k) + 1));
        slope = count * (x * value - before) / (x * x - 1);
        x -= value / slope;
      }
      nodes[i] = x;
      weights[i] = 2 / ((1 - x * x) * slope * slope);
    }
  }
};

const GaussRule& gauss() {
  static const GaussRule rule;
  return rule;
}

double gap(double from, double to, double x) { return std::max({from - x, x - to, 0.0}); }

/// visit(x, weight) at the nodes of rules on parts of an interval, halved until fine(from, to).
template <class Fine, class Visit>
void by_rules(double from, double to, const Fine& fine, const Visit& visit, int depth = 20) {
  if (!(from < to)) return;
  const double middle = 0.5 * (from + to);
  if (depth > 0 && !fine(from, to)) {
    by_rules(from, middle, fine, visit, depth - 1);
    by_rules(middle, to, fine, visit, depth - 1);
    return;
  }
  const double half = 0.5 * (to - from);
  for (std::size_t i = 0; i < GaussRule::count; ++i)
    visit(middle + half * gauss().nodes[i], half * gauss().weights[i]);
}

/// Numbers that look random, the same on every machine.
class Chance {
public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  double between(double a, double b) { return a + (b - a) * (*this)(); }
  /// Of equal chance for each factor.
  double scale(double a, double b) { return a * std::pow(b / a, (*this)()); }
  bool one_in(int n) { return (*this)() * n < 1; }
  double sign() { return one_in(2) ? 1 : -1; }
  Real3 on_sphere() {
    const double z = between(-1, 1);
    const double angle = between(0, 2 * pi);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  /// On the ellipse with the larger half axis `axis` mostly, else within.
  Complex in_ellipse(double axis) {
    const double angle = one_in(4) ? 0.5 * pi * std::floor(between(0, 4)) : between(0, 2 * pi);
    const double within = one_in(8) ? between(1, axis) : axis;
    return {within * std::cos(angle), std::sqrt(within * within - 1) * std::sin(angle)};
  }

private:
  std::mt19937_64 engine_;
};

double distance_from_segment(const Real3& point, const Real3& from, const Real3& to) {
  const Real3 way = to - from;
  const double along = std::clamp(product(point - from, way) / product(way, way), 0.0, 1.0);
  return length(point - (from + along * way));
}

/// The largest quotient of a value and its bound.
struct Closest {
  double quotient = 0;
  int tried = 0;

  void meet(double value, double bound, double slack, const char* what, int number) {
    ++tried;
    EXPECT_LE(value, bound * (1 + slack)) << what << " in instance " << number;
    quotient = std::max(quotient, value / bound);
  }
};

// Sources: a triangle or a parallelogram ----------------------------------------------------------------

/// corner + u first + v second, u, v >= 0, with u + v <= 1 or u, v <= 1.
struct Plate {
  Real3 corner;
  Real3 first;
  Real3 second;
  Real3 normal;
  bool triangle = false;

  [[nodiscard]] std::vector<Real3> corners() const {
    if (triangle) return {corner, corner + first, corner + second};
    return {corner, corner + first, corner + first + second, corner + second};
  }
  [[nodiscard]] double height(const Real3& point) const { return product(normal, point - corner); }
  [[nodiscard]] double distance(const Real3& point) const {
    const Real3 way = point - corner;
    const double area = product(normal, vector_product(first, second));
    const double u = product(normal, vector_product(way, second)) / area;
    const double v = product(normal, vector_product(first, way)) / area;
    const bool foot_within = u >= 0 && v >= 0 && (triangle ? u + v <= 1 : u <= 1 && v <= 1);
    if (foot_within) return std::abs(height(point));
    const std::vector<Real3> around = corners();
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < around.size(); ++i)
      least = std::min(least, distance_from_segment(point, around[i], around[(i + 1) % around.size()]));
    return least;
  }
};

/// visit(Q, weight) at nodes on parts that are small beside clear(Q), the distance of what is singular.
template <class Clear, class Visit>
void over_plate(const Plate& plate, const Clear& clear, const Visit& visit, int depth = 13) {
  const Real3 middle = plate.corner + (plate.triangle ? 1.0 / 3 : 0.5) * (plate.first + plate.second);
  double radius = 0;
  for (const Real3& corner : plate.corners()) radius = std::max(radius, length(corner - middle));
  if (depth > 0 && !(radius < 0.55 * clear(middle))) {
    const Real3 a = 0.5 * plate.first;
    const Real3 b = 0.5 * plate.second;
    const auto part = [&](const Real3& corner, double sign) {
      over_plate(Plate{corner, sign * a, sign * b, plate.normal, plate.triangle}, clear, visit, depth - 1);
    };
    part(plate.corner, 1);
    part(plate.corner + a, 1);
    part(plate.corner + b, 1);
    part(plate.corner + a + b, plate.triangle ? -1 : 1);
    return;
  }
  const double area = length(vector_product(plate.first, plate.second));
  for (std::size_t i = 0; i < GaussRule::count; ++i)
    for (std::size_t j = 0; j < GaussRule::count; ++j) {
      const double u = 0.5 * (1 + gauss().nodes[i]);
      const double width = plate.triangle ? 1 - u : 1;
      const double v = 0.5 * width * (1 + gauss().nodes[j]);
      visit(plate.corner + u * plate.first + v * plate.second,
            0.25 * width * area * gauss().weights[i] * gauss().weights[j]);
    }
}

/// T 1 by Stokes' theorem: (1/2 pi) Int n_P.((Q-P) x dQ)/((Q-P).(Q-P)) around the plate.
Complex by_border(const Plate& plate, const Complex3& p, const Real3& n_p) {
  const std::vector<Real3> around = plate.corners();
  Complex sum = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Real3 from = around[i];
    const Real3 way = around[(i + 1) % around.size()] - from;
    const auto fine = [&](double a, double b) {
      const Complex3 middle = (from + 0.5 * (a + b) * way) - p;
      // Zeros of the denominator, a quadratic polynomial of the way along the side.
      const double leading = product(way, way);
      const Complex half = product(way, middle) / leading;
      const Complex root = std::sqrt(half * half - product(middle, middle) / leading);
      return b - a < 1.2 * std::min(std::abs(half + root), std::abs(half - root));
    };
    by_rules(0, 1, fine, [&](double x, double weight) {
      const Complex3 seen = (from + x * way) - p;
      sum += weight * quotient(product(n_p, vector_product(seen, way)), product(seen, seen));
    });
  }
  return -0.5 * inv_pi * sum;
}

// Theorem D ---------------------------------------------------------------------------------------------

/// Observers c + z e and a plate that they see.
struct TubeInstance {
  Plate plate;
  Real3 c;
  Real3 n_p;
  Real3 e;
  double axis = 1;
  Complex z;

  [[nodiscard]] Complex3 observer() const { return c + z * e; }
  /// The distance of z from the zeros of (P-Q).(P-Q), in units of length.
  [[nodiscard]] double clear(const Real3& q) const {
    const Real3 w = c - q;
    const double squared = product(e, e);
    const Complex zero = Complex(-product(w, e), length(vector_product(w, e))) / squared;
    return std::min(std::abs(z - zero), std::abs(z - std::conj(zero))) * std::sqrt(squared);
  }
};

/// A polynomial that is at most 1 on the plate.
struct PlateDensity {
  std::array<double, 4> c{};
  Real3 along;
  double offset = 0;

  PlateDensity(const Plate& plate, Chance& chance) {
    Real3 way = chance.on_sphere();
    double least = HUGE_VAL;
    double largest = -HUGE_VAL;
    for (const Real3& corner : plate.corners()) {
      least = std::min(least, product(way, corner));
      largest = std::max(largest, product(way, corner));
    }
    along = (2 / (largest - least)) * way;
    offset = -(largest + least) / (largest - least);
    double sum = 0;
    for (double& x : c) sum += std::abs(x = chance.between(-1, 1));
    for (double& x : c) x /= sum;
  }
  /// Chebyshev's polynomials of a coordinate that runs from -1 to 1.
  double operator()(const Real3& q) const {
    const double x = product(along, q) + offset;
    return c[0] + c[1] * x + c[2] * (2 * x * x - 1) + c[3] * (4 * x * x - 3) * x;
  }
};

Real3 in_frame(const std::array<Real3, 3>& frame, double x, double y, double z) {
  return x * frame[0] + y * frame[1] + z * frame[2];
}

/// Of a kind: 0 any, 1 small plates ahead of grazing lines, 2 large plates below, 3 plates beside the panel
/// of the observers, which may touch its plane.
TubeInstance drawn_tube(int kind, Chance& chance) {
  const double unit = chance.scale(1e-3, 1e3);
  for (;;) {
    std::array<Real3, 3> frame{chance.on_sphere(), {}, {}};
    frame[1] = direction(vector_product(frame[0], chance.on_sphere()));
    frame[2] = vector_product(frame[0], frame[1]);
    const auto point = [&](double x, double y, double z) { return unit * in_frame(frame, x, y, z); };
    TubeInstance made;
    made.plate.triangle = chance.one_in(2);
    made.plate.normal = frame[2];
    double h = chance.scale(0.05, 2);
    double x0 = chance.between(-2, 2);
    double y0 = chance.between(-2, 2);
    std::array<double, 4> way{};  // of the sides
    for (double& s : way) s = chance.between(-1.5, 1.5);
    made.n_p = chance.on_sphere();
    Real3 towards = chance.on_sphere();
    if (kind == 1) {
      h = chance.scale(1e-3, 0.3);
      x0 = 1;
      y0 = 0;
      for (double& s : way) s *= chance.scale(0.003, 0.1);
      const Real3 ahead = in_frame(frame, 1, 0, -h);
      made.n_p = direction(chance.on_sphere() + chance.scale(0.01, 0.5) * ahead);
      made.n_p = direction(made.n_p - (product(made.n_p, ahead) - chance.scale(1e-3, 0.3)) * ahead);
      towards = in_frame(frame, 1, 0, chance.one_in(2) ? 0 : chance.between(-1, 3) * h);
    }
    if (kind == 2) {
      const double size = h * chance.scale(3, 100);
      way = {size, 0, chance.between(-0.5, 0.5) * size, size};
      x0 = -0.5 * (way[0] + way[2]);
      y0 = -0.5 * way[3];
      made.plate.triangle = false;
      made.n_p = in_frame(frame, 0, 0, -1);
      if (chance.one_in(2))
        made.n_p = direction(made.n_p + chance.between(0, 0.5) * h / size * chance.on_sphere());
    }
    if (kind == 3) {
      const double angle = chance.one_in(3) ? 0.5 * pi : chance.between(0.2, 2.8);
      made.n_p = in_frame(frame, 0, std::sin(angle), -std::cos(angle));
      y0 = -h * std::cos(angle) / std::sin(angle) + (chance.one_in(2) ? 1e-6 : chance.scale(0.01, 3)) * h;
      const double size = chance.scale(0.3, 30);
      way = {size, 0, chance.between(-0.5, 0.5) * size, size};
      x0 = -size * chance();
      towards = in_frame(frame, 0, y0, -h);
    }
    made.plate.corner = point(x0, y0, 0);
    made.plate.first = point(way[0], way[1], 0);
    made.plate.second = point(way[2], way[3], 0);
    const double turn = way[0] * way[3] - way[1] * way[2];
    if (std::abs(turn) < 0.1 * std::hypot(way[0], way[1]) * std::hypot(way[2], way[3])) continue;
    if (turn < 0) std::swap(made.plate.first, made.plate.second);
    made.c = point(0, 0, h);
    bool seen = true;
    for (const Real3& corner : made.plate.corners()) seen &= product(made.n_p, corner - made.c) >= 0;
    if (!seen) continue;
    if (kind != 1 && chance.one_in(3)) towards = vector_product(made.n_p, frame[2]);
    towards = towards - product(towards, made.n_p) * made.n_p;
    if (length(towards) < 1e-6) continue;
    made.axis = 1 + chance.scale(0.02, 100);
    const double share = chance.one_in(8) ? chance.between(0.9, 0.97) : chance.between(0.02, 0.9);
    made.e = (chance.sign() * share * made.plate.distance(made.c) / made.axis) * direction(towards);
    made.z = chance.one_in(3) ? Complex(made.axis * chance.sign()) : chance.in_ellipse(made.axis);
    return made;
  }
}

TEST(TubeBound, HoldsInEllipsesOfObservers) {
  Chance chance(101);
  std::array<Closest, 4> of_density;
  std::array<Closest, 2> by_nearest;  // without and with the foot before the observer
  std::array<Closest, 2> by_rings;
  Closest by_area;
  std::array<Closest, 2> majorants_by_nearest;
  std::array<Closest, 2> majorants_by_rings;
  double border = 0;
  for (int i = 0; i < 24000; ++i) {
    const int kind = i % 4;
    const TubeInstance tube = drawn_tube(kind, chance);
    const Plate& plate = tube.plate;
    const double distance = plate.distance(tube.c);
    const double height = plate.height(tube.c);
    const double half = length(tube.e);
    const double a = tube.axis * half;
    const PlateDensity density(plate, chance);

    const Complex3 p = tube.observer();
    Complex all = 0;
    Complex with_density = 0;
    double modulus = 0;
    over_plate(
        plate, [&](const Real3& q) { return tube.clear(q); },
        [&](const Real3& q, double weight) {
          const Complex g = weight * kernel(p, tube.n_p, Complex(1) * q, plate.normal);
          all += g;
          with_density += g * density(q);
          modulus += std::abs(g);
        });
    // T (r/(r-a))^4 at the centre of the line, and T 1.
    double mass = 0;
    double majorant = 0;
    over_plate(
        plate, [&](const Real3& q) { return length(q - tube.c) - a; },
        [&](const Real3& q, double weight) {
          const Real3 way = q - tube.c;
          const double r = length(way);
          const double g =
              -inv_pi * weight * product(tube.n_p, way) * product(plate.normal, way) / (r * r * r * r);
          mass += g;
          majorant += g * std::pow(r / (r - a), 4);
        });
    majorant *= 1 + tube.axis * std::abs(product(tube.e, plate.normal)) / height;
    // The integral as it is, by another theorem.
    border = std::max(border, std::abs(all - by_border(plate, p, tube.n_p)) / modulus);

    const bool foot_before = product(tube.n_p, plate.normal) < 0;
    const bool loose = chance.one_in(4);
    const auto less = [&] { return loose ? chance.between(0.9, 1) : 1; };
    const ObserverLines lines{.half = half / less(),
                              .distance = distance * less(),
                              .height = height * less(),
                              .highest = height / less(),
                              .turned = std::abs(product(tube.e, plate.normal)) / less(),
                              .mass = (chance.one_in(3) ? 1 : mass) * (1 + 1e-7),
                              .rings = foot_before || (loose && chance.one_in(2))};
    const double bound = tube_bound(lines, tube.axis);
    if (!loose) {
      ASSERT_LT(bound, HUGE_VAL);
    }
    of_density[static_cast<std::size_t>(kind)].meet(std::abs(with_density), bound, 1e-6, "density", i);
    of_density[static_cast<std::size_t>(kind)].meet(std::abs(all), bound, 1e-6, "density 1", i);
    // Each of the bounds alone.
    ObserverLines nearest = lines;
    nearest.highest = 1e100;
    ObserverLines rings = lines;
    rings.mass = 1e100;
    ObserverLines area = lines;
    area.height = -1;
    area.area = length(vector_product(plate.first, plate.second)) / (plate.triangle ? 2 : 1);
    by_area.meet(modulus, tube_bound(area, tube.axis), 1e-6, "area", i);
    const auto before = static_cast<std::size_t>(foot_before);
    by_nearest[before].meet(modulus, tube_bound(nearest, tube.axis), 1e-6, "nearest", i);
    by_rings[before].meet(modulus, tube_bound(rings, tube.axis), 1e-6, "rings", i);
    EXPECT_LE(modulus, majorant * (1 + 1e-5)) << "instance " << i;
    majorants_by_nearest[before].meet(majorant, tube_bound(nearest, tube.axis), 1e-5, "majorant", i);
    majorants_by_rings[before].meet(majorant, tube_bound(rings, tube.axis), 1e-5, "majorant by rings", i);
  }
  EXPECT_LT(border, 1e-4);
  for (const Closest& closest : of_density) EXPECT_GT(closest.quotient, 0.8);
  EXPECT_GT(by_area.quotient, 0.6);
  for (const std::size_t before : {0U, 1U}) {
    EXPECT_GT(by_nearest[before].tried, 4000);
    EXPECT_GT(by_nearest[before].quotient, 0.95);
    EXPECT_GT(by_rings[before].quotient, 0.35);
    EXPECT_GT(majorants_by_nearest[before].quotient, 0.98);
  }
  // Half a ring sends 2/pi of what its bound allows at most, whole ones all.
  EXPECT_GT(majorants_by_rings[0].quotient, 0.45);
  EXPECT_GT(majorants_by_rings[1].quotient, 0.95);
}

// Theorem S ---------------------------------------------------------------------------------------------

/// An integral over a moved plate.
struct Moved {
  Complex value = 0;
  double modulus = 0;     ///< with the modulus of kernel and Jacobian
  double size = 0;        ///< of the density, where it was evaluated
  double per_kernel = 0;  ///< the largest quotient of moved and real kernel
  void add(const Complex& g, const Complex& density) {
    value += g * density;
    modulus += std::abs(g);
    size = std::max(size, std::abs(density));
  }
};

/// A polynomial in both coordinates of a plane.
struct PlaneDensity {
  std::array<double, 6> c{};
  double unit = 1;

  PlaneDensity(double size, Chance& chance) : unit(size) {
    for (double& x : c) x = chance.between(-1, 1);
  }
  Complex operator()(const Complex& px, const Complex& py) const {
    const Complex x = (1 / unit) * px;
    const Complex y = (1 / unit) * py;
    return c[0] + x * (c[1] + x * (c[2] + c[3] * x)) + y * (c[4] + c[5] * x);
  }
};

/// A plate in the plane z = 0 between y0 and y1, from left to right ends at both, and observers at the height
/// h over (0, 0) on lines along x.
struct SlideInstance {
  double y0, y1;
  double left0, left1, right0, right1;
  double h;
  Real3 n_p;

  [[nodiscard]] double left(double y) const { return left0 + (left1 - left0) * (y - y0) / (y1 - y0); }
  [[nodiscard]] double right(double y) const { return right0 + (right1 - right0) * (y - y0) / (y1 - y0); }
  /// Of the observer over (x, 0) from the sides that are not parallel to its line.
  [[nodiscard]] double reach(double x) const {
    return std::min(distance_from_segment({x, 0, h}, {left0, y0, 0}, {left1, y1, 0}),
                    distance_from_segment({x, 0, h}, {right0, y0, 0}, {right1, y1, 0}));
  }
  /// Of these observers from the part of the plane between y0 and y1.
  [[nodiscard]] double least_distance() const { return std::hypot(h, gap(y0, y1, 0)); }

  /// For P = (x + i shift, 0, h). Q moves by i phi shift along x, phi = max(0, 1 - |Q - (x,0,h)|/r), or not
  /// at all for r = 0.
  [[nodiscard]] Moved moved(double x, double shift, double r, const PlaneDensity& density) const {
    Moved out;
    const Complex3 p{{x, shift}, 0, h};
    const Real3 n_q{0, 0, 1};
    const double tightness = 1 - std::abs(shift) / std::max(r, least_distance());
    std::vector<double> cuts{y0, y1};
    const double ring = r > h ? std::sqrt(r * r - h * h) : 0;
    for (const double cut : {-ring, 0.0, ring})
      if (y0 < cut && cut < y1) cuts.push_back(cut);
    std::sort(cuts.begin(), cuts.end());
    const auto fine_across = [&](double a, double b) {
      if (b - a > 0.8 * std::hypot(h * (r > 0 ? 1 : tightness), gap(a, b, 0))) return false;
      return ring == 0 || b - a < std::min(gap(a, b, ring), gap(a, b, -ring)) + 0.005 * ring;
    };
    const auto line = [&](double y, double weight_y) {
      const double s = std::hypot(h, y);
      const auto fine_along = [&](double a, double b) {
        return b - a < std::min(1.0, 0.7 * (tightness + gap(a, b, 0)));
      };
      // |Q - p| = s cosh v.
      const auto visit = [&](double v, double weight) {
        const double way = s * std::sinh(v);
        const double distance = s * std::cosh(v);
        const bool moves = distance < r;
        const Complex q_x(x + way, moves ? shift * (1 - distance / r) : 0);
        const Complex jacobian(1, moves ? -shift * way / (distance * r) : 0);
        const double element = weight_y * weight * distance;
        const Complex3 q{q_x, y, 0};
        const Complex g = element * jacobian * kernel(p, n_p, q, n_q);
        out.add(g, density(q_x, y));
        const double real =
            inv_pi * (n_p.x * way + n_p.y * y - n_p.z * h) * h / std::pow(distance, 4) * element;
        out.per_kernel = std::max(out.per_kernel, std::abs(g) / real);
      };
      std::vector<double> ends{std::asinh((left(y) - x) / s), std::asinh((right(y) - x) / s)};
      const double chord = r > s ? std::acosh(r / s) : 0;
      for (const double cut : {-chord, 0.0, chord})
        if (ends.front() < cut && cut < ends.back()) ends.insert(ends.end() - 1, cut);
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) by_rules(ends[i], ends[i + 1], fine_along, visit);
    };
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) by_rules(cuts[i], cuts[i + 1], fine_across, line);
    return out;
  }
};

SlideInstance drawn_slide(Chance& chance) {
  for (;;) {
    SlideInstance made{};
    made.h = chance.scale(0.02, 1);
    const bool below = chance.one_in(2);
    made.y0 = below ? -chance.scale(0.1, 3) : chance.scale(0.01, 2);
    made.y1 = (below ? 0 : made.y0) + chance.scale(0.1, 10);
    made.left0 = chance.one_in(8) ? chance.scale(0.05, 1) : -chance.scale(0.1, 5);
    made.left1 = chance.one_in(3) ? made.left0 : made.left0 * chance.between(0.5, 2);
    made.right0 = std::max(made.left0, 0.0) + chance.scale(0.1, 5);
    made.right1 = chance.one_in(3) ? made.right0 : made.right0 * chance.between(0.5, 2);
    if (!(made.left1 < made.right1)) continue;
    const double angle = chance.one_in(3) ? 0.5 * pi * chance.between(0, 2) : chance.between(-0.2, pi);
    made.n_p = {0, std::sin(angle), -std::cos(angle)};
    if (made.n_p.y * made.y0 - made.n_p.z * made.h < 0 || made.n_p.y * made.y1 - made.n_p.z * made.h < 0)
      continue;
    return made;
  }
}

TEST(SlideBound, HoldsInEllipsesOfObservers) {
  Chance chance(102);
  Closest values;
  Closest moduli;
  Closest with_mass;
  Closest kernels;
  double off = 0;
  int unmoved = 0;
  for (int i = 0; i < 1500; ++i) {
    const SlideInstance slide = drawn_slide(chance);
    const double reach = slide.reach(0);
    const double axis = 1 + chance.scale(0.02, 100);
    const double half = chance.between(0.02, 0.97) * reach / axis;
    const double a = axis * half;
    Complex z = chance.in_ellipse(axis);
    if (chance.one_in(3)) {  // where |Im z|/r is largest
      const double cosine = chance.sign() * a / reach;
      z = {axis * cosine, std::sqrt((axis * axis - 1) * (1 - cosine * cosine))};
    }
    const double x = half * z.real();
    const double shift = half * z.imag();
    const double r = reach - std::abs(x);
    const double bound = slide_bound(slide_part(half, reach, axis));
    if (!(std::abs(shift) < 0.97 * r && bound < HUGE_VAL)) continue;
    const PlaneDensity density(std::max(reach, 0.3), chance);
    const Moved moved = slide.moved(x, shift, r, density);
    // Cauchy's theorem, with another reach.
    const double further = slide.reach(x) > 1.05 * r ? slide.reach(x) : 0.9 * r;
    if (std::abs(shift) < 0.97 * further)
      off = std::max(off, std::abs(slide.moved(x, shift, further, density).value - moved.value) /
                              (moved.modulus * moved.size));
    if (std::abs(shift) < 0.8 * slide.least_distance()) {
      ++unmoved;
      const Moved not_at_all = slide.moved(x, shift, 0, density);
      off = std::max(off, std::abs(not_at_all.value - moved.value) /
                              (std::max(moved.modulus, not_at_all.modulus) * moved.size));
    }
    values.meet(std::abs(moved.value), bound * moved.size, 1e-6, "value", i);
    moduli.meet(moved.modulus, bound, 1e-6, "modulus", i);
    with_mass.meet(moved.modulus, bound * slide.moved(x, 0, 0, density).modulus, 1e-6, "with mass", i);
    kernels.meet(moved.per_kernel, bound, 1e-6, "kernel", i);
  }
  EXPECT_LT(off, 1e-7);
  EXPECT_GT(values.tried, 1000);
  EXPECT_GT(unmoved, 500);
  EXPECT_GT(values.quotient, 0.5);
  EXPECT_GT(moduli.quotient, 0.9);
  EXPECT_GT(with_mass.quotient, 0.99);
  EXPECT_GT(kernels.quotient, 0.99);
}

// The turning about an edge -----------------------------------------------------------------------------

/// A plate in the plane z = 0 with a side along x around 0, and observers t g.
struct TurnInstance {
  std::array<Real3, 4> corners;  ///< the first and the last on the edge
  Real3 g;
  Real3 n_p;

  [[nodiscard]] double reach() const {
    double least = HUGE_VAL;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
      least = std::min(least, distance_from_segment({}, corners[i], corners[i + 1]));
    return least;
  }
  /// Q turns by arg t up to |Q| = inner, and by less and less up to |Q| = outer.
  [[nodiscard]] Moved moved(const Complex& t, double inner, double outer, const PlaneDensity& density) const {
    Moved out;
    const double size = std::abs(t);
    const double turn = std::arg(t);
    const double slope = turn / std::log(outer / inner);
    const Complex3 p = t * g;
    const Real3 n_q{0, 0, 1};
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const Real3& from = corners[i];
      const Real3 side = direction(corners[i + 1] - from);
      const double from_origin = from.x * side.y - from.y * side.x;
      const auto separation = [&](double angle) {
        return std::acos(std::cos(angle) * g.x + std::sin(angle) * g.y);
      };
      const auto fine_around = [&](double a, double b) {
        return b - a < std::min(0.8, 0.8 * separation(0.5 * (a + b)));
      };
      const auto ray = [&](double angle, double weight) {
        const double cosine = std::cos(angle);
        const double sine = std::sin(angle);
        const double end = from_origin / (cosine * side.y - sine * side.x);
        const auto visit = [&](double way, double weight_way) {
          const double alpha = way < inner ? turn : way < outer ? slope * std::log(outer / way) : 0;
          const bool turns = inner < way && way < outer;
          const Complex phase = std::polar(1.0, alpha);
          const Complex3 q{way * cosine * phase, way * sine * phase, 0};
          const Complex jacobian = phase * phase * Complex(1, turns ? -slope : 0);
          const Complex k = weight * weight_way * way * jacobian * kernel(p, n_p, q, n_q);
          out.add(k, density(q.x, q.y));
        };
        const double least = size / 8;
        by_rules(
            0, std::min(least, inner), [](double, double) { return true; }, visit);
        const auto logarithmic = [&](double v, double weight_way) {
          visit(std::exp(v), weight_way * std::exp(v));
        };
        const double near = separation(angle);
        const auto fine_along = [&](double a, double b) {
          return b - a < std::min(0.8, 0.8 * std::hypot(near, gap(a, b, std::log(size))));
        };
        const std::array<double, 4> cuts{std::min(least, inner), inner, outer, end};
        for (std::size_t c = 0; c + 1 < cuts.size(); ++c)
          by_rules(std::log(cuts[c]), std::log(cuts[c + 1]), fine_along, logarithmic);
      };
      by_rules(std::atan2(from.y, from.x), std::atan2(corners[i + 1].y, corners[i + 1].x), fine_around, ray);
    }
    return out;
  }
};

TurnInstance drawn_turn(Chance& chance) {
  const double left = -chance.scale(0.3, 3);
  const double right = chance.scale(0.3, 3);
  const double top = chance.scale(0.3, 3);
  const double top_right = chance.between(left, right + 1);
  const double top_left = top_right - chance.scale(0.1, 3);
  const double along = chance.one_in(2) ? 0 : chance.between(-1.2, 1.2);
  const double between = chance.one_in(4) ? 0.5 * pi : chance.between(0.2, 2.9);
  const double sine = std::sin(between);
  const double cosine = std::cos(between);
  return {.corners = {{{right, 0, 0}, {top_right, top, 0}, {top_left, top, 0}, {left, 0, 0}}},
          .g = {std::sin(along), std::cos(along) * cosine, std::cos(along) * sine},
          .n_p = {0, sine, -cosine}};
}

/// The form of the kernel, area element included, at t and alpha over that at |t| and 0; P on one ray, Q on
/// another in its own plane, c the cosine between them.
double turned_form(double k, double angle, double alpha, double slope, double c) {
  const Complex t = std::polar(1.0, angle);
  const Complex q = std::polar(k, alpha);
  const Complex squared = t * t + q * q - 2.0 * c * t * q;
  const double real_squared = 1 + k * k - 2 * c * k;
  const double quotient = real_squared / std::abs(squared);
  return quotient * quotient * std::hypot(1, slope);
}

TEST(TurnedKernel, BoundsTheFormWhereTheTurnFallsOff) {
  Chance chance(104);
  double closest = 0;
  for (int i = 0; i < 200000; ++i) {
    const double k = chance.scale(3, 30);
    const double logarithm = chance.scale(0.01, 10);
    const double angle = chance.one_in(2) ? 0.5 * pi : 0.5 * pi * chance();
    const double fallen = chance.one_in(4) ? 1 : chance();  // of the logarithm
    const double c = chance.one_in(2) ? -1 : chance.between(-1, 1);
    const double way = k * std::exp(logarithm * fallen);
    const double seen = turned_form(way, angle, angle * (1 - fallen), angle / logarithm, c);
    const double bound = turned_kernel(k, logarithm);
    EXPECT_LE(seen, bound * (1 + 1e-12))
        << k << " " << logarithm << " " << angle << " " << fallen << " " << c;
    closest = std::max(closest, seen / bound);
  }
  EXPECT_GT(closest, 0.95);
}

TEST(TurnBound, HoldsForComplexObserversNearAnEdge) {
  Chance chance(103);
  Closest values;
  Closest moduli;
  double off = 0;
  double off_border = 0;
  for (int i = 0; i < 1500; ++i) {
    const TurnInstance turn = drawn_turn(chance);
    const double reach = turn.reach();
    const double size = reach * chance.scale(0.001, 0.32);
    const double modulus = size * (chance.one_in(4) ? chance() : 1);
    const double angle = chance.one_in(2) ? 0.5 * pi * chance.sign() : 0.5 * pi * chance.between(-1, 1);
    const Complex t = std::polar(modulus, angle);
    const PlaneDensity density(reach, chance);
    const double bound = turn_bound(size, reach);
    ASSERT_LT(bound, HUGE_VAL);
    double least = HUGE_VAL;
    double largest_density = 0;
    const Moved other = turn.moved(t, 2 * size, 0.9 * reach, density);
    for (const double k : {3.0, 5.0, 9.0, 20.0}) {
      if (k * size >= reach) continue;
      const Moved moved = turn.moved(t, k * size, reach, density);
      least = std::min(least, moved.modulus);
      largest_density = std::max(largest_density, moved.size);
      off = std::max(off, std::abs(moved.value - other.value) / (moved.modulus * moved.size));
    }
    values.meet(std::abs(other.value), bound * largest_density, 1e-6, "value", i);
    moduli.meet(least, bound, 1e-6, "modulus", i);
    // A real observer sees what the border says.
    const Moved real = turn.moved(modulus, 2 * size, 0.9 * reach, density);
    double border = 0;
    for (std::size_t c = 1; c + 1 < 4; ++c) {
      const Plate part{turn.corners[0],
                       turn.corners[c] - turn.corners[0],
                       turn.corners[c + 1] - turn.corners[0],
                       {0, 0, 1},
                       true};
      border += by_border(part, Complex(modulus) * turn.g, turn.n_p).real();
    }
    off_border = std::max(off_border, std::abs(real.modulus - border) / border);
  }
  EXPECT_LT(off, 1e-5);
  EXPECT_LT(off_border, 1e-5);
  EXPECT_GT(values.quotient, 0.5);
  EXPECT_GT(moduli.quotient, 0.8);
}

TEST(TurnBound, CountsWhatIsFarAsItsMathsSays) {
  // 1 + 2/(k-1) (f-1), f the form's growth, put together here once more.
  Chance chance(107);
  for (int i = 0; i < 2000; ++i) {
    const double reach = chance.scale(1e-3, 1e3);
    const double size = reach * chance.scale(1e-6, 0.33);
    double least = HUGE_VAL;
    for (const double k : {3.0, 5.0, 9.0, 20.0}) {
      if (!(k * size < reach)) continue;
      const double turn = 0.5 * pi / std::log(reach / (k * size));
      const double form = std::pow((k + 1) * (k + 1) / (k * k + 1), 2) * std::sqrt(1 + turn * turn);
      least = std::min(least, 1 + 2 / (k - 1) * (form - 1));
    }
    const double bound = turn_bound(size, reach);
    EXPECT_GE(bound, least * (1 - 1e-12)) << size << " of " << reach;
    EXPECT_LE(bound, least * (1 + 1e-9)) << size << " of " << reach;
  }
}

// Sources on complex lines ------------------------------------------------------------------------------

TEST(KernelInEllipse, BoundsTheKernelAlongSources) {
  Chance chance(104);
  Closest any;
  Closest short_lines;
  for (int i = 0; i < 80000; ++i) {
    const double unit = chance.scale(1e-3, 1e3);
    const Real3 n_q = chance.on_sphere();
    const Real3 p = unit * chance.on_sphere();
    const double distance = unit;
    const double height = std::abs(product(n_q, p));
    // Along the source's plane, towards P as far as that goes in every other instance.
    Real3 along = chance.one_in(2) ? p : chance.on_sphere();
    along = direction(along - product(along, n_q) * n_q);
    const double axis = 1 + chance.scale(0.02, 100);
    const double share = chance.one_in(2) ? chance.scale(0.01, 0.2) : chance.between(0.1, 0.98);
    const double half = share * distance / axis;
    const Real3 n_p = chance.one_in(2)
                          ? direction((-1 / unit) * p + chance.scale(0.01, 1) * chance.on_sphere())
                          : chance.on_sphere();
    const Complex z = chance.one_in(3) ? Complex(axis * chance.sign()) : chance.in_ellipse(axis);
    const Complex3 q = (half * z) * along;
    const double value = pi * std::abs(kernel(Complex(1) * p, n_p, q, n_q));
    const double less = chance.one_in(4) ? chance.between(share, 1) : 1;
    if (!(less > share)) continue;
    const double bound = kernel_in_ellipse(distance * less, share * distance, height);
    (share < 0.2 ? short_lines : any).meet(value, bound, 1e-9, "kernel", i);
  }
  EXPECT_GT(any.quotient, 0.6);
  EXPECT_GT(short_lines.quotient, 0.95);
}

TEST(RuleOfSources, ErrsAtLeastAsItsMathsSays) {
  // The bounds of kernel, function and area element on the two ellipses, put together here once more.
  Chance chance(105);
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    SeenPart part;
    part.area = chance.scale(1e-4, 10);
    part.half_s = part.half_t = chance.scale(1e-3, 1);
    part.to_s = part.to_t = part.half_s * chance.scale(2, 100);
    part.part_s = part.part_t = chance.between(0.05, 1);
    part.jacobian_part = chance.between(0, 1);
    const double height = chance.scale(1e-3, 10);
    const std::array<double, 3> sizes{chance.scale(0.1, 10), chance.scale(0.1, 10), chance.scale(0.1, 10)};
    const double allowed = chance.scale(1e-12, 1e-3);
    for (const bool in_s : {true, false}) {
      const RuleChoice rule =
          in_s ? rule_in_s(part, height, sizes, allowed) : rule_in_t(part, height, sizes, allowed);
      if (rule.nodes == 0) continue;
      ++found;
      double least = std::numeric_limits<double>::infinity();
      for (const double share : {0.5, 0.7}) {
        const double reach = share * part.to_s;
        const double axis = reach / part.half_s;
        if (!(axis > 1)) continue;
        const double rho = axis + std::sqrt(axis * axis - 1);
        const double of_part = 1 + part.part_s * (axis - 1);
        const double growth = of_part + std::sqrt(of_part * of_part - 1);
        const double function = sizes[0] + growth * (sizes[1] + growth * sizes[2]);
        const double element = in_s ? 1 : 1 + part.jacobian_part * axis;
        const double kernel = std::min(part.to_s, height) / std::pow(part.to_s - reach, 3);
        const double n = rule.nodes;
        const double factor = (2 + 2 / (4 * n * n - 1)) * std::pow(rho, -2 * n) / (1 - std::pow(rho, -2));
        least = std::min(least, factor * part.area / std::numbers::pi * kernel * element * function);
      }
      EXPECT_GE(rule.error, least * (1 - 1e-12)) << i;
      EXPECT_LE(rule.error, 1.26 * allowed) << i;  // for one node, whose factor is 8/3 and not 32/15
    }
  }
  EXPECT_GT(found, 2000);
}

TEST(SeenPart, BoundsWhatEveryObserverSees) {
  const SectorScene scene(test::panels_of("tetrahedron"));
  const std::vector<SectorElement> elements = graded_elements(scene, 2);
  Chance chance(106);
  double nearest = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    std::vector<Vector<double>> points;
    for (int k = 0; k < 5; ++k)
      points.push_back({chance.between(2, 2.3), chance.between(-1, 1), chance.between(-0.2, 0.2)});
    const ObserverBall ball = ball_about(points, scene.extent());
    const SectorBox& box = elements[e].box;
    const SeenPart part = seen_part(scene, elements[e], box, ball);
    const Sector& sector = scene.sectors()[elements[e].sector];
    EXPECT_GE(part.half_s, 0.5 * (1 - box.t0) * (box.s1 - box.s0) * norm(sector.b - sector.a));
    for (const double s : {box.s0, box.s1})
      EXPECT_GE(part.half_t, 0.5 * (box.t1 - box.t0) * norm(sector.c - sector.point(s, 0)));
    EXPECT_GE(part.area, sector.jacobian * box.weight());
    for (const Vector<double>& p : points) {
      EXPECT_LE(norm(p - ball.centre), ball.radius);
      for (int k = 0; k <= 8; ++k) {
        const double s = box.s0 + (box.s1 - box.s0) * k / 8;
        const double t = box.t0 + (box.t1 - box.t0) * k / 8;
        const double to_s = norm(p - sector.point(box.middle_s(), t));
        const double to_t = norm(p - sector.point(s, box.middle_t()));
        EXPECT_LE(part.to_s, to_s);
        EXPECT_LE(part.to_t, to_t);
        nearest = std::max({nearest, part.to_s / to_s, part.to_t / to_t});
      }
    }
  }
  EXPECT_GT(nearest, 0.8);
}

}  // namespace
}  // namespace radcert
