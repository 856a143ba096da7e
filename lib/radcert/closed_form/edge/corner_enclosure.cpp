// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/edge/corner_enclosure.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "radcert/closed_form/edge/corner_exponent.h"
#include "radcert/core/contract.h"
#include "radcert/core/interrupt.h"
#include "radcert/core/work_limit.h"

namespace radcert {
namespace {

const WorkLimit most_cells("closed_form/edge/corner_enclosure: cells of a face", 1024, 8,
                           "refused: the exponent is not enclosed to the radius");
constexpr int fewest_cells = 64;
/// Their table of integrals takes a gigabyte.
constexpr int largest_cells = 4096;
/// Into so many parts a cell is cut over which K f is enclosed.
constexpr int parts_of_cell = 4;

/// The step functions whose images are wanted: of each face, its cells counted from the axis that it shares
/// with the face before it, and from that with the face after it.
using Steps = std::array<std::vector<double>, 6>;

/// What a direction on a face receives of steps on the next one, for all of them.
using Received = std::array<Ball, 6>;

/// 1 - cos(a), which is 2 sin^2(a/2).
Ball versine_of(const Ball& a) {
  const Ball half = sin(a / Ball(2));
  return Ball(2) * (half * half);
}

/// The angles that bound the cells of a face, dense at both ends and symmetric about the middle.
struct Arc {
  std::vector<Ball> angle;
  std::vector<Ball> sine;
  std::vector<Ball> cosine;
  std::vector<Ball> versine;  ///< 1 - cosine

  explicit Arc(std::size_t cells) : angle(cells + 1), sine(cells + 1), cosine(cells + 1) {
    const std::size_t half = cells / 2;
    const Ball right = Ball::pi() / Ball(2);
    for (std::size_t m = 0; m <= half; ++m) {
      const Ball share = Ball(m) / Ball(half);
      angle[m] = right / Ball(2) * share * share * share;
      angle[cells - m] = right - angle[m];
      sine[m] = cosine[cells - m] = sin(angle[m]);
      cosine[m] = sine[cells - m] = cos(angle[m]);
    }
    cosine[0] = sine[cells] = Ball(1);
    for (const Ball& a : angle) versine.push_back(versine_of(a));
  }
  [[nodiscard]] std::size_t cells() const { return angle.size() - 1; }
};

class OctantKernel {
public:
  OctantKernel(const Ball& g, std::size_t cells)
      : arc_(cells), nu_(Ball(1) + g), factor_(reciprocal(Ball(2) * sin(Ball::pi() * g))) {}

  [[nodiscard]] const Arc& arc() const { return arc_; }

  /// The integrals over the cells seen from the direction at node k >= 1.
  [[nodiscard]] std::vector<Ball> shares(std::size_t k) const {
    const std::size_t n = arc_.cells();
    std::vector<Ball> out(n);
    if (k == n) {
      const Ball slope = nu_ * cos(nu_ * Ball::pi() / Ball(2));  // T'(0)
      for (std::size_t m = 0; m < n; ++m) out[m] = factor_ * slope * (arc_.cosine[m + 1] - arc_.cosine[m]);
      return out;
    }
    Ball before = transformed(arc_.versine[k]);
    for (std::size_t m = 0; m < n; ++m) {
      const Ball next = transformed(arc_.versine[m + 1] + arc_.cosine[m + 1] * arc_.versine[k]);
      out[m] = factor_ / arc_.cosine[k] * (next - before);
      before = next;
    }
    return out;
  }

  /// What is received from steps at angles x up to pi/4, 0 among them, as one ball.
  [[nodiscard]] Received received(const Ball& x, const Steps& steps) const {
    const std::size_t n = arc_.cells();
    const Ball versine = versine_of(x);
    const Ball sine = sin(x);
    const Ball scale = factor_ / (Ball(1) - versine);
    Received out;
    const Ball whole = sin(nu_ * (Ball::pi() - x));  // sin(x) T(y)
    const Ball none = sine * transformed(Ball(1));
    for (std::size_t s = 0; s < steps.size(); ++s)
      out.at(s) = Ball(steps.at(s)[n - 1]) * none - Ball(steps.at(s)[0]) * whole;
    for (std::size_t m = 1; m < n; ++m) {
      const Ball value = sine * transformed(arc_.versine[m] + arc_.cosine[m] * versine);
      for (std::size_t s = 0; s < steps.size(); ++s)
        out.at(s) = out.at(s) + (Ball(steps.at(s)[m - 1]) - Ball(steps.at(s)[m])) * value;
    }
    for (Ball& value : out) value = scale * value;
    return out;
  }

private:
  /// T(z) = sin(nu (pi - a))/sin(a), z = cos(a), from 1 - z in (0, 1].
  [[nodiscard]] Ball transformed(const Ball& less) const {
    const Ball more = Ball(2) - less;
    const Ball a = Ball(2) * atan(sqrt(less / more));
    return sin(nu_ * (Ball::pi() - a)) / sqrt(less * more);
  }

  Arc arc_;
  Ball nu_;
  Ball factor_;  ///< 1/(2 sin(pi g))
};

/// A line through two points of a convex function, at y.
Ball line(const Ball& y, const Ball& y_0, const Ball& q_0, const Ball& y_1, const Ball& q_1) {
  return q_0 + (q_1 - q_0) * ((y - y_0) / (y_1 - y_0));
}

/// K f / f over the cells of the faces, for step functions that come near to the eigenfunction.
class CollatzQuotients {
public:
  CollatzQuotients(const std::array<Rational, 3>& reflectivities, const Rational& g, std::size_t cells)
      : kernel_(Ball(g), cells), cells_(cells) {
    for (std::size_t i = 0; i < 3; ++i) rho_.at(i) = Ball(reflectivities.at(i));
    for (std::size_t k = 1; k <= cells; ++k) {
      throw_if_interrupted();
      shares_.push_back(kernel_.shares(k));
    }
    iterate();
    // Any positive steps do.
    for (std::vector<double>& steps : steps_)
      for (double& step : steps)
        if (!(step > 0 && step < 1e100)) step = 1;
  }

  [[nodiscard]] BallBounds bounds() const {
    const std::size_t half = cells_ / 2;
    // Near the axis by balls, one for each part of a cell; beyond by sums at the nodes.
    std::vector<Received> near;
    for (std::size_t k = 0; k < half; ++k) {
      throw_if_interrupted();
      for (int part = 0; part < parts_of_cell; ++part)
        near.push_back(kernel_.received(part_of(k, part), steps_));
    }
    std::vector<Received> sums(cells_ + 1);
    for (std::size_t k = half - 1; k <= cells_; ++k) {
      throw_if_interrupted();
      for (std::size_t s = 0; s < steps_.size(); ++s)
        for (std::size_t m = 0; m < cells_; ++m)
          sums[k].at(s) = sums[k].at(s) + Ball(steps_.at(s)[m]) * shares_[k - 1][m];
    }
    BallBounds out;
    bool is_first = true;
    for (std::size_t face = 0; face < 3; ++face) {
      for (std::size_t cell = 0; cell < cells_; ++cell)
        for (int part = 0; part < parts_of_cell; ++part) {
          // From the face after it, whose cells count from the axis at pi/2, and from that before it.
          const Ball after = at_part(near, sums, cells_ - 1 - cell, parts_of_cell - 1 - part, (face + 1) % 3);
          const Ball before = at_part(near, sums, cell, part, 3 + (face + 2) % 3);
          const Ball quotient = rho_.at(face) * (after + before) / Ball(steps_.at(face)[cell]);
          out.lower = is_first ? quotient.lower() : min(out.lower, quotient.lower());
          out.upper = is_first ? quotient.upper() : max(out.upper, quotient.upper());
          is_first = false;
        }
    }
    return out;
  }

private:
  /// The angles of a part of a cell.
  [[nodiscard]] Ball part_of(std::size_t cell, int part) const {
    const Ball& begin = kernel_.arc().angle[cell];
    const Ball step = (kernel_.arc().angle[cell + 1] - begin) / Ball(parts_of_cell);
    return hull(begin + Ball(part) * step, begin + Ball(part + 1) * step);
  }

  /// What the directions in a part of a cell, counted from the axis, receive of a step function.
  [[nodiscard]] Ball at_part(const std::vector<Received>& near, const std::vector<Received>& sums,
                             std::size_t cell, int part, std::size_t s) const {
    if (cell < cells_ / 2) return near[cell * parts_of_cell + static_cast<std::size_t>(part)].at(s);
    const std::vector<Ball>& y = kernel_.arc().cosine;
    const Ball x = part_of(cell, part);
    const auto through = [&](std::size_t k) {
      return line(cos(x), y[k], sums[k].at(s), y[k + 1], sums[k + 1].at(s));
    };
    return sin(x) * hull(through(cell), through(cell - 1));
  }

  /// Power iteration for K + r: with a face that reflects little the eigenvalue r comes with one near -r. In
  /// double: what it finds need not be near to anything.
  void iterate() {
    const std::size_t n = cells_;
    std::vector<std::vector<double>> shares;
    std::vector<double> sine;
    for (std::size_t k = 1; k <= n; ++k) {
      sine.push_back(kernel_.arc().sine[k].to_double());
      std::vector<double> row;
      for (const Ball& share : shares_[k - 1]) row.push_back(share.is_finite() ? share.to_double() : 0);
      shares.push_back(std::move(row));
    }
    for (std::size_t face = 0; face < 3; ++face) steps_.at(face).assign(n, 1);
    mirror();
    constexpr int iterations = 60;
    for (int step = 0; step < iterations; ++step) {
      throw_if_interrupted();
      std::array<std::vector<double>, 6> nodes;
      for (std::size_t s = 0; s < 6; ++s) {
        const std::vector<double>& f = steps_.at(s);
        nodes.at(s).assign(n + 1, f[0] / 2);
        for (std::size_t k = 1; k <= n; ++k) {
          double sum = 0;
          for (std::size_t m = 0; m < n; ++m) sum += shares[k - 1][m] * f[m];
          nodes.at(s)[k] = sine[k - 1] * sum;
        }
      }
      std::array<std::vector<double>, 3> image;
      double largest = 0;
      for (std::size_t face = 0; face < 3; ++face)
        for (std::size_t m = 0; m < n; ++m) {
          const std::vector<double>& after = nodes.at((face + 1) % 3);
          const std::vector<double>& before = nodes.at(3 + (face + 2) % 3);
          const double sum = after[n - m] + after[n - m - 1] + before[m] + before[m + 1];
          image.at(face).push_back(rho_.at(face).to_double() * sum / 2);
          largest = std::max(largest, image.at(face).back());
        }
      for (std::size_t face = 0; face < 3; ++face)
        for (std::size_t m = 0; m < n; ++m)
          steps_.at(face)[m] = (steps_.at(face)[m] + image.at(face)[m] / largest) / 2;
      mirror();
    }
  }

  void mirror() {
    for (std::size_t face = 0; face < 3; ++face)
      steps_.at(3 + face).assign(steps_.at(face).rbegin(), steps_.at(face).rend());
  }

  OctantKernel kernel_;
  std::size_t cells_;
  std::array<Ball, 3> rho_;
  std::vector<std::vector<Ball>> shares_;
  Steps steps_;
};

void require(const std::array<Rational, 3>& rho) {
  for (const Rational& r : rho)
    expects(r > Rational(0) && r < Rational(1), "reflectivities in (0, 1)",
            named("reflectivity", r.to_text()));
}

}  // namespace

BallBounds octant_spectral_bounds(const std::array<Rational, 3>& reflectivities, const Rational& g,
                                  int cells) {
  require(reflectivities);
  expects(g > Rational(0) && g < Rational(1), "0 < g < 1", named("g", g.to_text()));
  expects(8 <= cells && cells <= largest_cells && cells % 2 == 0, "8 <= cells <= 4096, even",
          named("cells", cells));
  return CollatzQuotients(reflectivities, g, static_cast<std::size_t>(cells)).bounds();
}

Outcome<Ball> enclosed_octant_exponent(const std::array<Rational, 3>& reflectivities,
                                       const Rational& radius) {
  require(reflectivities);
  expects(radius > Rational(0) && radius < Rational(1), "0 < radius < 1", named("radius", radius.to_text()));
  std::array<double, 3> rounded{};
  for (std::size_t i = 0; i < 3; ++i) rounded.at(i) = std::min(reflectivities.at(i).to_double(), 1 - 0x1p-53);
  const Rational near = Rational::exactly(octant_exponent(rounded).value);
  const Rational low = near - radius;
  const Rational high = near + radius;
  if (!(low > Rational(0) && high < Rational(1)))
    return because("the exponent is nearer to 0 or 1 than the radius");
  const Ball one(1);
  const auto refused = [] {
    return because("the radius needs more than " + std::to_string(most_cells.value()) + " cells");
  };
  if (radius < Rational(1) / power(Rational(10), 6)) return refused();
  for (int cells = fewest_cells; cells <= most_cells.value(); cells *= 2) {
    if (certainly_less(octant_spectral_bounds(reflectivities, low, cells).upper, one) &&
        certainly_less(one, octant_spectral_bounds(reflectivities, high, cells).lower))
      return hull(Ball(low), Ball(high));
  }
  return refused();
}

}  // namespace radcert
