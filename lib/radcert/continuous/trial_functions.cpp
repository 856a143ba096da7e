// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/trial_functions.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "radcert/continuous/gauss_tables.h"
#include "radcert/continuous/transport.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"

namespace radcert {

const WorkLimit krylov_steps("continuous/trial_functions: Krylov vectors", 60, 2,
                             "a trial function that fits less");

namespace {

/// The operator f -> P T f on functions of sectors.
class ProjectedTransport {
public:
  ProjectedTransport(const SectorScene& scene, std::span<const SectorElement> elements, int degree,
                     double tolerance)
      : scene_(scene),
        elements_(elements),
        powers_(static_cast<std::size_t>(degree + 1)),
        tolerance_(tolerance) {
    const IntervalRule<double>& rule = gauss_on_interval(degree + 1);
    // c_i = (2i+1)/2 sum_m w_m P_i(x_m) f(x_m)
    to_coefficients_.resize(powers_ * powers_);
    std::vector<double> values(powers_);
    for (std::size_t m = 0; m < powers_; ++m) {
      legendre_values<double>(rule.nodes[m], values);
      for (std::size_t i = 0; i < powers_; ++i)
        to_coefficients_[i * powers_ + m] = (static_cast<double>(i) + 0.5) * rule.weights[m] * values[i];
    }
    for (const SectorElement& element : elements) {
      const Sector& sector = scene.sectors()[element.sector];
      ObserverGroup& group = nodes_.emplace_back(ObserverGroup{.panel = sector.panel, .points = {}});
      const SectorBox& box = element.box;
      for (const double x : rule.nodes)
        for (const double y : rule.nodes)
          group.points.push_back(sector.point(box.middle_s() + 0.5 * (box.s1 - box.s0) * x,
                                              box.middle_t() + 0.5 * (box.t1 - box.t0) * y));
    }
  }

  [[nodiscard]] SectorFunctions operator()(const SectorFunctions& f) const {
    const Transport transport(scene_, elements_, f);
    SectorFunctions out(elements_.size(), f.count(), static_cast<int>(powers_) - 1);
    parallel_for(elements_.size(), 1, [&](std::size_t begin, std::size_t end) {
      std::vector<double> half(powers_ * powers_);
      for (std::size_t e = begin; e < end; ++e) {
        const std::vector<double> values = transport(nodes_[e], tolerance_).values;
        for (std::size_t k = 0; k < f.count(); ++k) interpolate(values, f.count(), k, half, out.of(e, k));
      }
    });
    return out;
  }

private:
  void interpolate(std::span<const double> values, std::size_t count, std::size_t k, std::span<double> half,
                   std::span<double> coefficients) const {
    for (std::size_t m = 0; m < powers_; ++m)
      for (std::size_t j = 0; j < powers_; ++j) {
        double sum = 0;
        for (std::size_t l = 0; l < powers_; ++l)
          sum += to_coefficients_[j * powers_ + l] * values[(m * powers_ + l) * count + k];
        half[m * powers_ + j] = sum;
      }
    for (std::size_t i = 0; i < powers_; ++i)
      for (std::size_t j = 0; j < powers_; ++j) {
        double sum = 0;
        for (std::size_t m = 0; m < powers_; ++m)
          sum += to_coefficients_[i * powers_ + m] * half[m * powers_ + j];
        coefficients[i * powers_ + j] = sum;
      }
  }

  const SectorScene& scene_;
  std::span<const SectorElement> elements_;
  std::size_t powers_;
  double tolerance_;
  std::vector<double> to_coefficients_;
  std::vector<ObserverGroup> nodes_;
};

/// Inner products of single functions, about those of L2.
class InnerProduct {
public:
  InnerProduct(const SectorScene& scene, std::span<const SectorElement> elements, int degree) {
    for (const SectorElement& element : elements) {
      const double area = scene.sectors()[element.sector].jacobian * element.box.weight();
      for (int i = 0; i <= degree; ++i)
        for (int j = 0; j <= degree; ++j) weights_.push_back(area / ((2 * i + 1) * (2 * j + 1)));
    }
  }
  [[nodiscard]] double operator()(const SectorFunctions& f, const SectorFunctions& g, std::size_t k) const {
    double sum = 0;
    const std::size_t size = f.size();
    for (std::size_t e = 0; e * size < weights_.size(); ++e) {
      const std::span<const double> a = f.of(e, k);
      const std::span<const double> b = g.of(e, k);
      for (std::size_t i = 0; i < size; ++i) sum += weights_[e * size + i] * a[i] * b[i];
    }
    return sum;
  }

private:
  std::vector<double> weights_;
};

/// f_k += factor g_k.
void add(SectorFunctions& f, const SectorFunctions& g, std::size_t k, double factor, std::size_t elements) {
  for (std::size_t e = 0; e < elements; ++e) {
    const std::span<double> a = f.of(e, k);
    const std::span<const double> b = g.of(e, k);
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
  }
}

void scale(SectorFunctions& f, std::size_t k, double factor, std::size_t elements) {
  for (std::size_t e = 0; e < elements; ++e)
    for (double& c : f.of(e, k)) c *= factor;
}

}  // namespace

SectorFunctions densities(const SectorScene& scene, std::span<const SectorElement> elements,
                          const PanelData& data, const SectorFunctions& q) {
  SectorFunctions w = q;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const std::size_t panel = scene.sectors()[elements[e].sector].panel;
    for (std::size_t k = 0; k < q.count(); ++k) {
      const std::span<double> c = w.of(e, k);
      for (double& value : c) value *= data.reflectivity[panel];
      c[0] += data.emissions[k][panel];
    }
  }
  return w;
}

SectorFunctions trial_functions(const SectorScene& scene, std::span<const SectorElement> elements,
                                const PanelData& data, int degree, double tolerance) {
  expects(degree >= 0 && degree < most_gauss_nodes, "0 <= degree < most_gauss_nodes",
          named("degree", degree));
  const std::size_t count = data.emissions.size();
  const std::size_t size = elements.size();
  const ProjectedTransport transport(scene, elements, degree, tolerance);
  const InnerProduct product(scene, elements, degree);
  PanelData no_emission = data;
  for (std::vector<double>& emission : no_emission.emissions)
    std::fill(emission.begin(), emission.end(), 0.0);

  SectorFunctions zero(size, count, degree);
  const SectorFunctions right_side = transport(densities(scene, elements, data, zero));
  std::vector<SectorFunctions> basis{right_side};
  std::vector<double> lengths(count);
  for (std::size_t k = 0; k < count; ++k) {
    lengths[k] = std::sqrt(product(right_side, right_side, k));
    if (lengths[k] > 0) scale(basis[0], k, 1 / lengths[k], size);
  }
  const auto most = static_cast<Eigen::Index>(krylov_steps.value());
  std::vector<Eigen::MatrixXd> hessenberg(count, Eigen::MatrixXd::Zero(most + 1, most));
  std::vector<Eigen::VectorXd> found(count);
  for (Eigen::Index m = 0; m < most; ++m) {
    // (I - P T rho) v
    SectorFunctions next = transport(densities(scene, elements, no_emission, basis.back()));
    for (double& c : next.all()) c = -c;
    for (std::size_t k = 0; k < count; ++k) add(next, basis.back(), k, 1, size);
    double worst = 0;
    for (std::size_t k = 0; k < count; ++k) {
      for (Eigen::Index i = 0; i <= m; ++i) {
        const SectorFunctions& v = basis[static_cast<std::size_t>(i)];
        const double along = product(next, v, k);
        hessenberg[k](i, m) = along;
        add(next, v, k, -along, size);
      }
      const double rest = std::sqrt(product(next, next, k));
      hessenberg[k](m + 1, m) = rest;
      if (rest > 0) scale(next, k, 1 / rest, size);
      const Eigen::MatrixXd matrix = hessenberg[k].topLeftCorner(m + 2, m + 1);
      Eigen::VectorXd goal = Eigen::VectorXd::Zero(m + 2);
      goal(0) = lengths[k];
      found[k] = matrix.colPivHouseholderQr().solve(goal);
      worst = std::max(worst, (matrix * found[k] - goal).norm() / std::sqrt(scene.area()));
    }
    if (worst <= tolerance) break;
    basis.push_back(std::move(next));
  }
  SectorFunctions q(size, count, degree);
  for (std::size_t k = 0; k < count; ++k)
    for (Eigen::Index i = 0; i < found[k].size(); ++i)
      add(q, basis[static_cast<std::size_t>(i)], k, found[k](i), size);
  return q;
}

}  // namespace radcert
