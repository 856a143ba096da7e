// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/residual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include "radcert/continuous/elements/element_interpolation.h"
#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/continuous/elements/local_values.h"
#include "radcert/continuous/residual_samples.h"
#include "radcert/core/contract.h"
#include "radcert/core/digest.h"
#include "radcert/core/parallel.h"

namespace radcert {
namespace {

constexpr double unit = unit_roundoff<double>();

/// What one cell or strip contributes.
struct Share {
  std::vector<double> squares;  ///< of rho (|t_k| + radius)^2
  std::vector<double> missed;   ///< squared, rho (2 sqrt|X| e)^2
  std::vector<double> products;
  std::vector<double> sampling;  ///< radii of the products
  std::vector<double> rounding;
  std::vector<double> shade;  ///< radii of the products from what is shaded
  double truncation = 0;
  double strips = 0;
  std::size_t samples = 0;

  explicit Share(std::size_t count, std::size_t residuals = 1)
      : squares(count),
        missed(count),
        products(residuals * count),
        sampling(count),
        rounding(count),
        shade(count) {}

  [[nodiscard]] std::array<std::vector<double>*, 6> by_function() {
    return {&squares, &missed, &products, &sampling, &rounding, &shade};
  }
  static constexpr std::size_t numbers_of(std::size_t count, std::size_t residuals) {
    return (5 + residuals) * count + 3;
  }
  void put_into(std::vector<double>& numbers) {
    for (const std::vector<double>* part : by_function())
      numbers.insert(numbers.end(), part->begin(), part->end());
    numbers.insert(numbers.end(), {truncation, strips, static_cast<double>(samples)});
  }
  void take_from(std::span<const double> numbers) {
    for (std::vector<double>* part : by_function()) {
      std::copy_n(numbers.begin(), part->size(), part->begin());
      numbers = numbers.subspan(part->size());
    }
    truncation = numbers[0];
    strips = numbers[1];
    samples = static_cast<std::size_t>(numbers[2]);
  }
};

void add(std::vector<double>& to, const std::vector<double>& from) {
  for (std::size_t k = 0; k < to.size(); ++k) to[k] += from[k];
}

Share sum_of(Share a, const Share& b) {
  add(a.squares, b.squares);
  add(a.missed, b.missed);
  add(a.products, b.products);
  add(a.sampling, b.sampling);
  add(a.rounding, b.rounding);
  add(a.shade, b.shade);
  a.truncation += b.truncation;
  a.strips += b.strips;
  a.samples += b.samples;
  return a;
}

class ResidualOverCells {
public:
  explicit ResidualOverCells(const Trial& trial, std::size_t residuals = 1,
                             ShadedParts shaded = ShadedParts::bounded)
      : trial_(trial), samples_(trial, shaded), count_(trial.w.count()), residuals_(residuals) {}

  [[nodiscard]] Share none() const { return Share(count_, residuals_); }
  [[nodiscard]] std::vector<Share> of_cells(std::span<const ObserverCell> cells,
                                            const CellDemand& demand) const {
    CellTolerances tolerances(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (takes_part(cells[c]) && !cells[c].is_strip()) tolerances[c] = tolerance(cells[c], demand);
    const std::vector<CellSamples> found = samples_(cells, tolerances);
    std::vector<Share> out;
    for (std::size_t c = 0; c < cells.size(); ++c)
      out.push_back(!takes_part(cells[c]) ? none()
                    : cells[c].is_strip() ? of_strip(cells[c])
                                          : of_samples(cells[c], found[c]));
    return out;
  }

  /// Bounds of |t_0|, whose samples are wanted within a part of what is allowed.
  [[nodiscard]] std::vector<double> largest(std::span<const ObserverCell> cells,
                                            std::span<const double> allowed) const {
    CellTolerances tolerances(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (!cells[c].is_strip())
        tolerances[c] = std::min(0.05, 0.1 * allowed[c] / (gain(cells[c]) * trial_.smoothness.size()));
    const std::vector<CellSamples> found = samples_(cells, tolerances);
    std::vector<double> out;
    for (std::size_t c = 0; c < cells.size(); ++c) out.push_back(largest(cells[c], found[c]));
    return out;
  }

  /// Int w_k q_i over a part of an element, by i, k, by a rule that is exact for it.
  [[nodiscard]] std::vector<double> products_with_q(std::size_t e, const SectorBox& part) const {
    // Of the degree of w, of q, and 1 for the area element, which 2 nodes - 1 is at least.
    const int nodes = (trial_.w.degree() + trial_.q.degree() + 3) / 2;
    const IntervalRule<double>& rule = gauss_on_interval(nodes);
    std::vector<double> sums(residuals_ * count_);
    visit(e, part, rule, rule,
          [&](std::size_t, double weight, std::span<const double> w, std::span<const double> q) {
            for (std::size_t i = 0; i < residuals_; ++i)
              for (std::size_t k = 0; k < count_; ++k) sums[i * count_ + k] += weight * w[k] * q[i];
          });
    return sums;
  }

private:
  [[nodiscard]] double area(std::size_t e, const SectorBox& box) const {
    return trial_.sector(e).jacobian * box.weight() * upward;
  }

  /// A bound for the rounding of a sum of w (T w + q) over an area, and of w itself.
  [[nodiscard]] double rounding(const ObserverCell& cell, double over) const {
    const auto powers = static_cast<double>(trial_.w.degree() + 1);
    return over *
           (trial_.smoothness.density_size(cell.element) *
                (trial_.smoothness.size() + trial_.smoothness.residual_size(cell.element)) *
                (96 * powers * powers + 256) * unit +
            trial_.rounding * trial_.smoothness.residual_size(cell.element)) *
           upward;
  }

  template <class Visitor>
  void visit(std::size_t e, const SectorBox& box, const IntervalRule<double>& rule_s,
             const IntervalRule<double>& rule_t, const Visitor& visitor) const {
    const Sector& sector = trial_.sector(e);
    LocalValues w_here(trial_.elements[e], trial_.w, e);
    LocalValues q_here(trial_.elements[e], trial_.q, e);
    std::vector<double> w(count_);
    std::vector<double> q(count_);
    const double scale = 0.25 * sector.jacobian * (box.s1 - box.s0) * (box.t1 - box.t0);
    std::size_t place = 0;
    for (std::size_t i = 0; i < rule_s.nodes.size(); ++i)
      for (std::size_t j = 0; j < rule_t.nodes.size(); ++j) {
        const double t = box.middle_t() + 0.5 * (box.t1 - box.t0) * rule_t.nodes[j];
        w_here.at(box, rule_s.nodes[i], rule_t.nodes[j], w);
        q_here.at(box, rule_s.nodes[i], rule_t.nodes[j], q);
        visitor(place++, scale * (1 - t) * rule_s.weights[i] * rule_t.weights[j], w, q);
      }
  }

  [[nodiscard]] Share of_strip(const ObserverCell& cell) const {
    Share share = none();
    const double over = area(cell.element, cell.box);
    const double most = trial_.smoothness.residual_size(cell.element) * upward;
    for (std::size_t k = 0; k < count_; ++k)
      share.squares[k] = trial_.rho(cell.element) * over * most * most * upward;
    share.strips = over * trial_.smoothness.density_size(cell.element) * most * upward;
    share.products = products_with_q(cell.element, cell.box);
    for (double& rounding_of_k : share.rounding) rounding_of_k = rounding(cell, over);
    return share;
  }

  /// Not what neither reflects nor sends: it is in neither sum.
  [[nodiscard]] bool takes_part(const ObserverCell& cell) const {
    return trial_.rho(cell.element) != 0 || trial_.smoothness.density_size(cell.element) != 0;
  }

  static double gain(const ObserverCell& cell) {
    return lebesgue_constant(cell.nodes_s) * lebesgue_constant(cell.nodes_t);
  }

  /// Of samples, relative to w.
  [[nodiscard]] double tolerance(const ObserverCell& cell, const CellDemand& demand) const {
    const double over = area(cell.element, cell.box);
    const double size = trial_.smoothness.size();
    return std::min(
        {0.05, 0.5 * demand.interpolation / (std::sqrt(over) * size),
         0.15 * demand.quadrature / (over * trial_.smoothness.density_size(cell.element) * size)});
  }

  /// A bound of |t_0| from its samples.
  [[nodiscard]] double largest(const ObserverCell& cell, const CellSamples& found) const {
    if (cell.is_strip()) return trial_.smoothness.residual_size(cell.element) * upward;
    std::vector<double> residual(found.nodes);
    visit(cell.element, cell.box, gauss_on_interval(cell.nodes_s), gauss_on_interval(cell.nodes_t),
          [&](std::size_t place, double, std::span<const double>, std::span<const double> q) {
            residual[place] = found.values[place * count_] - q[0];
          });
    const ElementInterpolation interpolation(cell.nodes_s, cell.nodes_t);
    std::vector<double> coefficients(found.nodes);
    interpolation.coefficients(residual, 1, coefficients);
    const double interpolant = supremum(coefficients, static_cast<std::size_t>(cell.nodes_s),
                                        static_cast<std::size_t>(cell.nodes_t));
    return (interpolant + gain(cell) * found.radius + found.largest_shade() +
            interpolation.rounding(trial_.smoothness.largest_residual(), 0) + cell.of_interpolant +
            cell.beside) *
           upward;
  }

  [[nodiscard]] Share of_samples(const ObserverCell& cell, const CellSamples& found) const {
    Share share = none();
    const double over = area(cell.element, cell.box);
    const double rho = trial_.rho(cell.element);
    visit(cell.element, cell.box, gauss_on_interval(cell.nodes_s), gauss_on_interval(cell.nodes_t),
          [&](std::size_t place, double weight, std::span<const double> w, std::span<const double> q) {
            for (std::size_t k = 0; k < count_; ++k) {
              const double t = std::abs(found.values[place * count_ + k] - q[k]) + found.radius;
              if (rho > 0) share.squares[k] += weight * rho * t * t * upward;
              for (std::size_t i = 0; i < residuals_; ++i)
                share.products[i * count_ + k] += weight * w[k] * found.values[place * count_ + i];
              if (w[k] != 0) share.sampling[k] += weight * std::abs(w[k]) * found.radius * upward;
            }
          });
    const double beside = 2 * cell.interpolation + found.largest_shade();
    const double missed = rho * over * beside * beside * upward;
    for (std::size_t k = 0; k < count_; ++k) {
      share.missed[k] = missed;
      share.rounding[k] = rounding(cell, over);
      if (!found.shade.empty())
        share.shade[k] =
            over * trial_.penumbra.size(cell.element, k) * found.largest_shade(residuals_) * upward;
    }
    share.truncation = over * cell.quadrature * upward;
    share.samples = found.nodes;
    return share;
  }

  const Trial& trial_;
  ResidualSamples samples_;
  std::size_t count_;
  std::size_t residuals_;  ///< for products
};

/// What cells contribute, one by one, as few numbers.
class SharesByCell {
public:
  SharesByCell(std::size_t cells, std::size_t count) : count_(count), numbers_(cells * (3 * count + 1)) {}

  /// Those of some cells in a row; none where nothing is kept.
  [[nodiscard]] std::span<double> of(std::size_t first, std::size_t cells) {
    if (numbers_.empty()) return {};
    return std::span(numbers_).subspan(first * (3 * count_ + 1), cells * (3 * count_ + 1));
  }

  void put(std::size_t cell, const Share& share) {
    double* to = numbers_.data() + cell * (3 * count_ + 1);
    *to++ = share.missed[0];
    for (std::size_t k = 0; k < count_; ++k) {
      *to++ = share.squares[k];
      *to++ = share.products[k];
      *to++ = share.sampling[k] + share.rounding[k] + share.shade[k] + share.truncation + share.strips;
    }
  }
  void add_to(Share& sum, std::size_t cell) const {
    const double* from = numbers_.data() + cell * (3 * count_ + 1);
    const double missed = *from++;
    for (std::size_t k = 0; k < count_; ++k) {
      sum.missed[k] += missed;
      sum.squares[k] += *from++;
      sum.products[k] += *from++;
      sum.sampling[k] += *from++;
    }
  }

private:
  std::size_t count_;
  std::vector<double> numbers_;
};

std::vector<ElementResidual> element_residuals(const Trial& trial, std::span<const ObserverCell> cells,
                                               const ResidualOverCells& residual,
                                               const SharesByCell& shares) {
  const std::size_t count = trial.w.count();
  std::vector<Share> sums(trial.elements.size(), Share(count));
  std::vector<double> terms(trial.elements.size(), 512);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    shares.add_to(sums[cells[c].element], c);
    terms[cells[c].element] += 1;
  }
  std::vector<ElementResidual> out;
  for (std::size_t e = 0; e < trial.elements.size(); ++e) {
    const std::vector<double> with_q = residual.products_with_q(e, trial.elements[e].box);
    const double rounding = terms[e] * unit;
    const double order = rounding * trial.sector(e).jacobian * trial.elements[e].box.weight() *
                         trial.smoothness.size() * 2 * trial.smoothness.largest_residual();
    ElementResidual own;
    for (std::size_t k = 0; k < count; ++k) {
      own.norms.push_back((std::sqrt(sums[e].squares[k]) + std::sqrt(sums[e].missed[k])) * (1 + rounding) *
                          upward);
      own.products.push_back(Approximation::proved(sums[e].products[k] - with_q[k],
                                                   (sums[e].sampling[k] + order) * (1 + rounding) * upward));
    }
    out.push_back(std::move(own));
  }
  return out;
}

/// Cells that one thread takes, and among which what distant parts send is shared; parts are kept together.
constexpr std::size_t cells_at_a_time = 64;
constexpr std::size_t cells_of_a_part = 16 * cells_at_a_time;

/// SHA-256 of some doubles, to the bit.
std::string digest_of_numbers(std::span<const double> numbers) {
  return sha256({reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()});
}

/// A name for these cells and the functions whose residuals they are for: a plan that differs by a rounding
/// is another, and with its cells parts of both would count twice or not at all.
std::string name_of_cells(const std::string& kind, const Trial& trial, std::span<const ObserverCell> cells) {
  std::vector<double> numbers;
  const auto put = [&](std::size_t place, const SectorBox& box) {
    numbers.insert(numbers.end(), {static_cast<double>(place), box.s0, box.s1, box.t0, box.t1});
  };
  for (const SectorElement& element : trial.elements) put(element.sector, element.box);
  std::string digests =
      digest_of_numbers(numbers) + digest_of_numbers(trial.q.all()) + digest_of_numbers(trial.w.all());
  for (std::size_t first = 0; first < cells.size(); first += cells_of_a_part) {
    numbers.clear();
    for (const ObserverCell& cell : cells.subspan(first, std::min(cells_of_a_part, cells.size() - first))) {
      put(cell.element, cell.box);
      numbers.insert(numbers.end(),
                     {static_cast<double>(cell.nodes_s), static_cast<double>(cell.nodes_t),
                      cell.closed ? 1.0 : 0.0, cell.of_interpolant, cell.beside, cell.interpolation,
                      cell.quadrature, cell.shade, cell.least_mass, cell.shade_of_mean});
    }
    digests += digest_of_numbers(numbers);
  }
  return std::to_string(cells.size()) + " " + kind + ", " + digest_of(digests);
}

/// The numbers of cells first, ..., first + size - 1.
std::vector<double> numbers_of_cells(MeshWork* work, const std::string& name, std::size_t first,
                                     std::size_t size, std::size_t count,
                                     const std::function<std::vector<double>()>& find) {
  if (work == nullptr) return find();
  bool is_found = false;
  std::vector<double> numbers = work->numbers(name + " from " + std::to_string(first), count, [&] {
    is_found = true;
    return find();
  });
  if (!is_found) work->add(size);
  return numbers;
}

ResidualSums sums_over(const ResidualOverCells& residual, const Trial& trial,
                       std::span<const ObserverCell> cells, const CellDemand& demand, bool by_element,
                       MeshWork* work, std::size_t residuals) {
  const std::size_t count = trial.w.count();
  SharesByCell by_cell(by_element ? cells.size() : 0, count);
  const std::string name =
      work == nullptr ? "" : name_of_cells(by_element ? "cells of elements" : "cells", trial, cells);
  // Parts end where chunks do, so that sums do not depend on them.
  Share total = residual.none();
  for (std::size_t first = 0; first < cells.size(); first += cells_of_a_part) {
    const std::size_t size = std::min(cells_of_a_part, cells.size() - first);
    const std::span<double> of_cells = by_cell.of(first, size);
    const auto find = [&] {
      Share sum = parallel_reduce_ordered(
          size, cells_at_a_time, total,
          [&](std::size_t begin, std::size_t end) {
            Share share = residual.none();
            const std::vector<Share> own =
                residual.of_cells(cells.subspan(first + begin, end - begin), demand);
            for (std::size_t c = 0; c < own.size(); ++c) {
              if (by_element) by_cell.put(first + begin + c, own[c]);
              share = sum_of(std::move(share), own[c]);
            }
            if (work != nullptr) work->add(end - begin);
            return share;
          },
          sum_of);
      std::vector<double> numbers;
      sum.put_into(numbers);
      numbers.insert(numbers.end(), of_cells.begin(), of_cells.end());
      return numbers;
    };
    const std::vector<double> numbers = numbers_of_cells(
        work, name, first, size, Share::numbers_of(count, residuals) + of_cells.size(), find);
    total.take_from(numbers);
    std::copy(numbers.end() - static_cast<std::ptrdiff_t>(of_cells.size()), numbers.end(), of_cells.begin());
  }
  std::vector<double> with_q(residuals * count);
  for (std::size_t e = 0; e < trial.elements.size(); ++e)
    add(with_q, residual.products_with_q(e, trial.elements[e].box));

  ResidualSums sums;
  // Of the order in which cells are summed: as many terms as there are cells in a chunk, chunks and elements.
  const double terms =
      static_cast<double>(cells_at_a_time + cells.size() / cells_at_a_time + trial.elements.size());
  const double order =
      terms * unit * trial.scene.area() * trial.smoothness.size() * 2 * trial.smoothness.largest_residual();
  std::vector<double> radii;
  for (std::size_t k = 0; k < count; ++k) {
    sums.norms.push_back((std::sqrt(total.squares[k]) + std::sqrt(total.missed[k])) *
                         (1 + (terms + 512) * unit) * upward);
    const double radius =
        (total.sampling[k] + total.rounding[k] + total.shade[k] + total.truncation + total.strips + order) *
        (1 + (terms + 512) * unit) * upward;
    radii.push_back(radius);
    sums.sampling = std::max(sums.sampling, total.sampling[k]);
    sums.shade = std::max(sums.shade, total.shade[k]);
  }
  for (std::size_t i = 0; i < residuals; ++i)
    for (std::size_t k = 0; k < count; ++k)
      sums.products.push_back(
          Approximation::proved(total.products[i * count + k] - with_q[i * count + k], radii[k]));
  sums.truncation = total.truncation;
  sums.strips = total.strips;
  sums.samples = total.samples;
  if (by_element) sums.elements = element_residuals(trial, cells, residual, by_cell);
  return sums;
}

std::vector<double> largest_over(const ResidualOverCells& residual, const Trial& trial,
                                 std::span<const ObserverCell> cells, const LargestDemand& demand,
                                 MeshWork* work) {
  std::vector<double> largest;
  const std::string name = work == nullptr ? "" : name_of_cells("cells for maxima", trial, cells);
  for (std::size_t first = 0; first < cells.size(); first += cells_of_a_part) {
    const std::size_t size = std::min(cells_of_a_part, cells.size() - first);
    const std::vector<double> found = numbers_of_cells(work, name, first, size, size, [&] {
      std::vector<double> part(size);
      parallel_for(size, cells_at_a_time, [&](std::size_t begin, std::size_t end) {
        const std::span<const ObserverCell> own = cells.subspan(first + begin, end - begin);
        std::vector<double> allowed;
        for (const ObserverCell& cell : own)
          allowed.push_back(demand.allowed(cell.element, trial.sector(cell.element), cell.box));
        const std::vector<double> bounds = residual.largest(own, allowed);
        std::copy(bounds.begin(), bounds.end(), part.begin() + static_cast<std::ptrdiff_t>(begin));
        if (work != nullptr) work->add(end - begin);
      });
      return part;
    });
    largest.insert(largest.end(), found.begin(), found.end());
  }
  return largest;
}

}  // namespace

ResidualSums residual_sums(const Trial& trial, std::span<const ObserverCell> cells, const CellDemand& demand,
                           bool by_element, MeshWork* work, std::size_t residuals) {
  expects(residuals >= 1 && residuals <= (by_element ? 1 : trial.w.count()),
          "residuals that products are taken with", named("residuals", residuals));
  return sums_over(ResidualOverCells(trial, residuals), trial, cells, demand, by_element, work, residuals);
}

std::vector<double> largest_residuals(const Trial& trial, std::span<const ObserverCell> cells,
                                      const LargestDemand& demand, MeshWork* work) {
  return largest_over(ResidualOverCells(trial), trial, cells, demand, work);
}

namespace {

/// Whole elements that reflect, each with one rule.
std::vector<ObserverCell> whole_elements(const Trial& trial) {
  const int nodes = trial.q.degree() + 2;
  std::vector<ObserverCell> cells;
  for (std::size_t e = 0; e < trial.elements.size(); ++e)
    if (trial.rho(e) != 0)
      cells.push_back({.element = e, .box = trial.elements[e].box, .nodes_s = nodes, .nodes_t = nodes});
  return cells;
}

/// To which values are wanted that only tell what to expect, relative to w.
double rough(const Trial& trial) { return 0.001 * std::pow(0.25, trial.q.degree()); }

}  // namespace

std::vector<double> expected_norms(const Trial& trial) {
  const double area = trial.scene.area();
  const CellDemand demand{
      .interpolation = rough(trial) * std::sqrt(area / static_cast<double>(trial.elements.size())),
      .quadrature = rough(trial) * area};
  return sums_over(ResidualOverCells(trial, 1, ShadedParts::ignored), trial, whole_elements(trial), demand,
                   false, nullptr, 1)
      .norms;
}

std::vector<double> expected_largest(const Trial& trial) {
  class Rough final : public LargestDemand {
  public:
    explicit Rough(double allowed) : allowed_(allowed) {}
    [[nodiscard]] double allowed(std::size_t /*element*/, const Sector& /*sector*/,
                                 const SectorBox& /*box*/) const override {
      return allowed_;
    }
    [[nodiscard]] bool may_be_strip(const Sector& /*sector*/, const SectorBox& /*box*/) const override {
      return false;
    }

  private:
    double allowed_;
  };
  const auto nodes = static_cast<double>((trial.q.degree() + 2) * (trial.q.degree() + 2));
  const std::vector<ObserverCell> cells = whole_elements(trial);
  const std::vector<double> largest =
      largest_over(ResidualOverCells(trial, 1, ShadedParts::ignored), trial, cells,
                   Rough(10 * nodes * rough(trial) * trial.smoothness.size()), nullptr);
  std::vector<double> by_element(trial.elements.size());
  for (std::size_t c = 0; c < cells.size(); ++c) by_element[cells[c].element] = largest[c];
  return by_element;
}

}  // namespace radcert
