// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/contraction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "radcert/core/contract.h"
#include "radcert/scalar/real.h"
#include "radcert/solve/estimated_contraction.h"
#include "radcert/solve/rounding/rounding.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Enough for a handful of roundings.
constexpr double upward = 1 + 8 * unit;

/// max_i x_i / w_i over the entries of all ranks, or infinity.
double largest_ratio(const Ranks& ranks, std::span<const double> x, std::span<const double> w) {
  double largest = 0;
  bool finite = true;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double ratio = std::abs(x[i]) / w[i];
    finite = finite && std::isfinite(ratio);
    largest = std::max(largest, ratio);
  }
  return ranks.largest(finite ? largest : infinity);
}

}  // namespace

const WorkLimit most_power_steps("solve/contraction: steps of the power method", 40, 0,
                                 "no contraction: an iteration is refused");

double Contraction::least_weight() const {
  return -parts_.ranks().largest(-*std::min_element(weights_.begin(), weights_.end()));
}

double Contraction::norm(std::span<const double> x) const {
  expects(x.size() == weights_.size(), "a vector of the matrix's size", named("size", x.size()));
  return largest_ratio(parts_.ranks(), x, weights_) * upward;
}

double Contraction::inverse_bound(double norm_of_d) const { return norm_of_d / (1 - theta_) * upward; }

/// Steps from weights to weights.
struct ContractionSearch {
  SystemMatrix k;
  std::span<const double> row_radius;
  VectorParts parts = k.parts();
  std::vector<double> image = std::vector<double>(k.rows());
  double radius_from_below = 0;  ///< of all matrices within the radii; see NoContraction

  /// The image of the weights and a theta for them, rounded up.
  double measure(std::span<const double> weights) {
    k.multiply_sizes(weights, image);
    // What has underflowed is less than a denormal number a term.
    const auto n = static_cast<double>(parts.whole());
    const double sums_upward = upward_of_sums(parts.whole());
    const double underflow = n * std::numeric_limits<double>::denorm_min();
    double least = infinity;
    for (std::size_t i = 0; i < image.size(); ++i) {
      const double radius = row_radius.empty() ? 0.0 : row_radius[i];
      least = std::min(least, (image[i] * (2 - sums_upward) - underflow - radius) / weights[i]);
      image[i] = image[i] * sums_upward + underflow + radius;
    }
    // The sizes of an operator are bounds from above alone.
    if (k.has_entries() && std::isfinite(least))
      radius_from_below = std::max(radius_from_below, least * (2 - upward));
    return largest_ratio(parts.ranks(), image, weights) * upward;
  }

  /// One step of the power method, the largest weight 1 again.
  void step(std::vector<double>& weights, double theta) const {
    double largest = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      weights[i] = image[i] + theta / 2 * weights[i];
      largest = std::max(largest, weights[i]);
    }
    largest = parts.ranks().largest(largest);
    for (double& weight : weights) weight /= largest;
  }

  static double amplification(const Contraction& c) {
    return c.theta_ < 1 ? 1 / ((1 - c.theta_) * c.least_weight()) : infinity;
  }

  static Contraction of_inverse(const VectorParts& parts, double norm_of_inverse) {
    Contraction made;
    made.parts_ = parts;
    made.weights_.assign(parts.size(), 1.0);
    made.theta_ = 1 - 1 / norm_of_inverse * (2 - upward);
    return made;
  }

  Outcome<Contraction, NoContraction> run(long most_steps) {
    Contraction best;
    best.parts_ = parts;
    best.weights_.assign(k.rows(), 1.0);
    best.theta_ = measure(best.weights_);
    double least_theta = best.theta_;
    double theta = best.theta_;
    Contraction now = best;
    for (long i = 0; i < most_steps && std::isfinite(theta) && theta > 0; ++i) {
      step(now.weights_, theta);
      if (!(now.least_weight() >= std::numeric_limits<double>::min())) break;
      now.theta_ = measure(now.weights_);
      if (amplification(now) < amplification(best)) best = now;
      const double gain = theta - now.theta_;
      theta = now.theta_;
      least_theta = std::min(least_theta, theta);
      if (theta < 1 && gain < (1 - theta) / 8) break;
    }
    if (!(best.theta_ < 1))
      return because(NoContraction{.theta = least_theta, .radius_from_below = radius_from_below});
    return best;
  }
};

Outcome<Contraction, NoContraction> find_contraction(const SystemMatrix& k,
                                                     std::span<const double> row_radius, long most_steps) {
  expects(k.rows() == k.columns() && k.rows() > 0 && k.parts().whole() <= longest_sum, "a square matrix",
          named("rows", k.rows()), named("columns", k.columns()));
  expects(row_radius.empty() || row_radius.size() == k.rows(), "a radius a row or none",
          named("radii", row_radius.size()));
  return ContractionSearch{.k = k, .row_radius = row_radius}.run(most_steps);
}

Contraction contraction_by_estimate(const VectorParts& parts, double inverse_norm, double row_radius) {
  expects(std::isfinite(inverse_norm) && inverse_norm >= 1, "a norm of an inverse of 1 at least",
          named("norm", inverse_norm));
  const double moved = inverse_norm * row_radius * upward;
  expects(row_radius >= 0 && moved < 1, "radii so small that all matrices within them are regular",
          named("moved", moved));
  return ContractionSearch::of_inverse(parts, inverse_norm / (1 - moved) * upward);
}

}  // namespace radcert
