// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/trial_functions.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "radcert/continuous/elements/element_interpolation.h"
#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/transport/transport.h"
#include "radcert/core/contract.h"
#include "radcert/core/parallel.h"
#include "radcert/core/work_limit.h"

namespace radcert {

const WorkLimit krylov_steps("continuous/trial_functions: Krylov vectors", 60, 2,
                             "a trial function that fits less");

namespace {

/// The operator f -> P T f on functions of sectors; 0 where nothing of it is reflected.
class ProjectedTransport {
public:
  ProjectedTransport(const SectorScene& scene, std::span<const SectorElement> elements,
                     const ElementReflectivity& rho, int degree, double tolerance)
      : scene_(scene),
        elements_(elements),
        rho_(rho),
        degree_(degree),
        tolerance_(tolerance),
        interpolation_(degree + 1) {
    for (const SectorElement& element : elements) {
      const Sector& sector = scene.sectors()[element.sector];
      const std::array<Vector<double>, 4> corners = corners_of(sector, element.box);
      nodes_.push_back({.panel = sector.panel,
                        .points = interpolation_.points(sector, element.box),
                        .hull = {corners.begin(), corners.end()},
                        .least_mass = negligible_mass,
                        .by_points = true});
    }
  }

  [[nodiscard]] SectorFunctions operator()(const SectorFunctions& f) const {
    const Transport transport(scene_, elements_, f);
    SectorFunctions out(elements_.size(), f.count(), degree_);
    parallel_for(elements_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e) {
        if (rho_.largest(e) == 0) continue;
        const std::vector<double> values = transport(nodes_[e], tolerance_).values;
        for (std::size_t k = 0; k < f.count(); ++k)
          interpolation_.coefficients(std::span(values).subspan(k), f.count(), out.of(e, k));
      }
    });
    return out;
  }

private:
  const SectorScene& scene_;
  std::span<const SectorElement> elements_;
  const ElementReflectivity& rho_;
  int degree_;
  double tolerance_;
  ElementInterpolation interpolation_;
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

void add_to(std::span<double> a, double factor, std::span<const double> b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

/// f_k += factor g_k.
void add(SectorFunctions& f, const SectorFunctions& g, std::size_t k, double factor, std::size_t elements) {
  for (std::size_t e = 0; e < elements; ++e) add_to(f.of(e, k), factor, g.of(e, k));
}

void scale(SectorFunctions& f, std::size_t k, double factor, std::size_t elements) {
  for (std::size_t e = 0; e < elements; ++e)
    for (double& c : f.of(e, k)) c *= factor;
}

}  // namespace

SectorFunctions panel_functions(const SectorScene& scene, std::span<const SectorElement> elements,
                                const std::vector<std::vector<double>>& values, int degree) {
  SectorFunctions f(elements.size(), values.size(), degree);
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (std::size_t k = 0; k < values.size(); ++k)
      f.of(e, k)[0] = values[k][scene.sectors()[elements[e].sector].panel];
  return f;
}

SectorFunctions densities(const ElementReflectivity& reflectivity, const SectorFunctions& emissions,
                          const SectorFunctions& q) {
  expects(emissions.degree() == q.degree() + reflectivity.degree(), "the degree of rho q",
          named("degree", emissions.degree()));
  SectorFunctions w = emissions;
  const std::size_t elements = q.all().size() / (q.count() * q.size());
  for (std::size_t e = 0; e < elements; ++e)
    for (std::size_t k = 0; k < q.count(); ++k) reflectivity.add_product(e, q.of(e, k), w.of(e, k));
  return w;
}

SectorFunctions trial_functions(const SectorScene& scene, std::span<const SectorElement> elements,
                                const Reflectivity& reflectivity, const SectorFunctions& emissions,
                                double tolerance) {
  expects(emissions.degree() >= reflectivity.degree() && emissions.degree() < most_gauss_nodes,
          "the degree of rho <= degree < most_gauss_nodes", named("degree", emissions.degree()));
  const int degree = emissions.degree() - reflectivity.degree();
  const std::size_t count = emissions.count();
  const std::size_t size = elements.size();
  const ElementReflectivity rho(reflectivity, scene, elements);
  const ProjectedTransport transport(scene, elements, rho, degree, tolerance);
  const InnerProduct product(scene, elements, degree);
  const SectorFunctions zero(size, count, emissions.degree());
  const SectorFunctions right_side = transport(emissions);
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
    SectorFunctions next = transport(densities(rho, zero, basis.back()));
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
