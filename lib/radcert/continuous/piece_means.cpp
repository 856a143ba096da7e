// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "radcert/continuous/goals.h"

namespace radcert {
namespace {

class PieceMeans final : public Goals {
public:
  PieceMeans(const SectorScene& scene, Reflectivity reflectivity)
      : scene_(scene), reflectivity_(std::move(reflectivity)) {
    for (std::size_t j = 0; j < scene.panels().size(); ++j) {
      const std::size_t piece = scene.panels()[j].piece;
      areas_.resize(std::max(areas_.size(), piece + 1));
      areas_[piece] += scene.area(j);
    }
  }

  [[nodiscard]] std::size_t count() const override { return areas_.size(); }
  [[nodiscard]] bool depend_on_u() const override { return true; }
  [[nodiscard]] double radius(double wanted) const override {
    return wanted * *std::min_element(areas_.begin(), areas_.end());
  }
  [[nodiscard]] int exponent(std::size_t /*k*/) const override { return 0; }
  [[nodiscard]] int least_degree() const override { return 0; }
  [[nodiscard]] std::vector<SectorElement> refined(std::vector<SectorElement> elements, int /*degree*/,
                                                   double /*allowed*/) const override {
    return elements;
  }
  DualErrors put_duals(std::span<const SectorElement> elements, SectorFunctions& emissions) const override {
    const ElementReflectivity rho(reflectivity_, scene_, elements);
    const std::size_t first = emissions.count() - count();
    const auto from = static_cast<std::size_t>(rho.degree() + 1);
    const auto to = static_cast<std::size_t>(emissions.degree() + 1);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const std::size_t panel = scene_.sectors()[elements[e].sector].panel;
      const std::span<const double> c = rho.functions().of(e, 0);
      const std::span<double> out = emissions.of(e, first + scene_.panels()[panel].piece);
      for (std::size_t i = 0; i < from; ++i)
        for (std::size_t j = 0; j < from; ++j) out[i * to + j] = c[i * from + j];
    }
    return {.left = std::vector<double>(count())};
  }

  [[nodiscard]] std::vector<Approximation> of_density(const Trial& trial, double /*allowed*/,
                                                      std::size_t emission) const override {
    std::vector<double> integrals(count());
    std::vector<double> sizes(count());
    const auto powers = static_cast<std::size_t>(trial.w.degree() + 1);
    for (std::size_t e = 0; e < trial.elements.size(); ++e) {
      const Sector& sector = trial.sector(e);
      const SectorBox& box = trial.elements[e].box;
      const std::span<const double> c = trial.w.of(e, emission);
      // Int P_0(y) (1-t) and Int P_1(y) (1-t): 1 - t = 1 - t_m - (t_1 - t_0)/2 y
      const double second = powers > 1 ? c[1] * (box.t1 - box.t0) / 6 : 0;
      const double scale = sector.jacobian * (box.s1 - box.s0) * (box.t1 - box.t0);
      const std::size_t piece = scene_.panels()[sector.panel].piece;
      integrals[piece] += scale * (c[0] * (1 - box.middle_t()) - second);
      sizes[piece] += scale * (std::abs(c[0]) * (1 - box.middle_t()) + std::abs(second));
    }
    const double terms = static_cast<double>(trial.elements.size() + 16) * unit_roundoff<double>();
    std::vector<Approximation> out;
    for (std::size_t k = 0; k < count(); ++k)
      out.push_back(
          Approximation::proved(integrals[k], (terms * sizes[k] + trial.rounding * areas_[k]) * upward));
    return out;
  }

  [[nodiscard]] Approximation number(std::size_t k, const Approximation& functional,
                                     std::size_t /*emission*/) const override {
    const auto sectors = static_cast<double>(scene_.sectors().size());
    const double value = functional.value / areas_[k];
    // The areas are sums of as many terms as there are sectors.
    return {.value = value,
            .radius = functional.radius / areas_[k] * (1 + sectors * unit_roundoff<double>()) * upward +
                      (64 + sectors) * unit_roundoff<double>() * std::abs(value),
            .guaranteed = functional.guaranteed};
  }

private:
  const SectorScene& scene_;
  Reflectivity reflectivity_;
  std::vector<double> areas_;  ///< by piece
};

}  // namespace

std::unique_ptr<Goals> piece_means(const SectorScene& scene, const Reflectivity& reflectivity) {
  return std::make_unique<PieceMeans>(scene, reflectivity);
}

}  // namespace radcert
