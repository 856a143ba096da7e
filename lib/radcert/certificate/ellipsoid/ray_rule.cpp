// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/ellipsoid/ray_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/certificate/gauss_rule.h"
#include "radcert/core/contract.h"
#include "radcert/core/work_limit.h"
#include "radcert/scalar/ball.h"
#include "radcert/scalar/pack.h"

namespace radcert::certificate {

const WorkLimit most_polar_nodes("certificate/ray_rule: nodes of a rule", 262144, 16,
                                 "no rule: the residual is not verified");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Of a few roundings and functions of the C library.
constexpr double slightly = 1 + 0x1p-40;
constexpr double widest_strip = 6;
/// Strips that are tried: parts of the widest.
constexpr int strips = 40;

/// The least number of nodes that misses no more than allowed, and what it misses; 0 where there is none.
struct Choice {
  int nodes = 0;
  double error = 0;
};

/// Maths     error = factor(s) M(s) exp(-rate n s), or with exp(n s) - 1 in its place
template <class Bound, class Error>
Choice least(double strip, const Bound& bound, const Error& error, double rate, double allowed, double most) {
  Choice best;
  for (int k = 1; k < strips; ++k) {
    const double s = strip * k / strips;
    const double size = bound(s);
    if (!(size < infinity)) continue;
    const double about = size > 0 ? std::log1p(error(size, 0.0, s) / allowed) / (rate * s) : 1;
    if (!(about < most) || (best.nodes > 0 && about > best.nodes)) continue;
    for (int n = std::max(1, static_cast<int>(about)); n <= most; ++n) {
      const double missed = size > 0 ? error(size, static_cast<double>(n), s) * slightly : 0;
      if (!(missed <= allowed)) continue;
      if (best.nodes == 0 || n < best.nodes || (n == best.nodes && missed < best.error)) best = {n, missed};
      break;
    }
  }
  return best;
}

}  // namespace

EllipsoidStretch::EllipsoidStretch(const Vector<Rational>& half_axes) {
  expects(half_axes.x.sign() > 0 && half_axes.y.sign() > 0 && half_axes.z.sign() > 0, "half axes > 0");
  const Rational largest = std::max({half_axes.x, half_axes.y, half_axes.z});
  const Rational smallest = std::min({half_axes.x, half_axes.y, half_axes.z});
  inverse_ = {(largest / half_axes.x).to_double(), (largest / half_axes.y).to_double(),
              (largest / half_axes.z).to_double()};
  kappa_ = largest == smallest ? 1 : (largest / smallest).to_double() * slightly;
  determinant_ =
      (half_axes.x * half_axes.y * half_axes.z / (largest * largest * largest)).to_double() * slightly;
}

double EllipsoidStretch::turned(double s) const {
  // tanh s = kappa^-1 tanh of what is sought; the sphere turns nothing.
  if (kappa_ == 1) return s;
  const double r = kappa_ * std::tanh(s) * slightly;
  return r < 1 ? std::atanh(r) * slightly : infinity;
}

double EllipsoidStretch::widest() const {
  return kappa_ == 1 ? widest_strip : std::min(widest_strip, std::atanh(1 / kappa_));
}

double EllipsoidStretch::margin(double s) const {
  // 1 - (kappa^2 - 1) sinh^2 s
  const double sine = std::sinh(s);
  return std::max(0.0, (1 - (kappa_ * kappa_ - 1) * sine * sine * slightly) / slightly - 0x1p-40);
}

PolarRule polar_rule(const PolarBounds& bounds, double tolerance, bool halved) {
  const auto most = static_cast<double>(most_polar_nodes.value());
  PolarRule out;
  const Choice rows = least(
      bounds.meridian_strip, bounds.meridian,
      [](double size, double n, double s) { return 4 * size * std::exp(-2 * n * s) / -std::expm1(-s); }, 2,
      0.4 * tolerance, std::min<double>(most_long_nodes, most));
  if (rows.nodes == 0) return out;
  const GaussRule gauss = long_gauss_rule(rows.nodes);
  out.error = rows.error;
  double left = most;
  for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
    const Ball& x = gauss.nodes[i];
    // Of psi/2: (1 + cos psi)/2 = cos^2(psi/2)
    const Ball cosine = halved ? sqrt((Ball(1) + x) * Ball(Rational(1, 2))) : x;
    const Ball sine = halved ? sqrt((Ball(1) - x) * Ball(Rational(1, 2))) : sqrt(Ball(1) - x * x);
    const double above = sine.upper_double();
    const double weight = gauss.weights[i].to_double() / 2;
    const Choice row = least(
        bounds.row_strip(above), [&](double s) { return bounds.row(s, above); },
        [](double size, double n, double s) { return n > 0 ? 2 * size / std::expm1(n * s) : 2 * size; }, 1,
        0.5 * tolerance, left);
    if (row.nodes == 0) return {};
    left -= row.nodes;
    out.error += weight * row.error * slightly;
    const double z = cosine.to_double();
    for (int j = 0; j < row.nodes; ++j) {
      const Ball angle = Ball(Rational(2L * j, row.nodes)) * Ball::pi();
      out.points.push_back({(sine * cos(angle)).to_double(), (sine * sin(angle)).to_double(), z});
      out.weights.push_back(weight / row.nodes);
    }
  }
  out.error *= slightly;
  out.nodes = out.points.size();
  while (out.points.size() % Pack::lanes != 0) {
    const Vector<double> last = out.points.back();
    out.points.push_back(last);
    out.weights.push_back(0);
  }
  return out;
}

}  // namespace radcert::certificate
