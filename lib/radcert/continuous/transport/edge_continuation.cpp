// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/edge_continuation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "radcert/continuous/elements/gauss_tables.h"
#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

/// How far columns are continued, in units of their width or of that of the elements beside them.
constexpr std::array<double, 2> parts_of_width{0.25, 0.0625};

/// By i, k: see legendre_elsewhere.
using LegendreTable = std::vector<double>;

/// A_ik with P_i(m + h x) = sum_(k <= i) A_ik P_k(x), each rounded once.
/// Maths     (i+1) P_(i+1)(z) = (2i+1) z P_i(z) - i P_(i-1)(z) and x P_k = ((k+1) P_(k+1) + k P_(k-1))/(2k+1)
LegendreTable legendre_elsewhere(const Rational& m, const Rational& h, std::size_t powers) {
  std::vector<std::vector<Rational>> exact(powers, std::vector<Rational>(powers));
  exact[0][0] = 1;
  for (std::size_t i = 0; i + 1 < powers; ++i) {
    std::vector<Rational> z_times(powers);
    for (std::size_t k = 0; k <= i; ++k) {
      const Rational& a = exact[i][k];
      const Rational moved = h * a / Rational(2 * k + 1);
      z_times[k] += m * a;
      z_times[k + 1] += Rational(k + 1) * moved;
      if (k > 0) z_times[k - 1] += Rational(k) * moved;
    }
    for (std::size_t k = 0; k < powers; ++k) {
      exact[i + 1][k] = Rational(2 * i + 1) * z_times[k];
      if (i > 0) exact[i + 1][k] -= Rational(i) * exact[i - 1][k];
      exact[i + 1][k] /= Rational(i + 1);
    }
  }
  LegendreTable table;
  for (const std::vector<Rational>& row : exact)
    for (const Rational& a : row) table.push_back(a.to_double());
  return table;
}

/// The table for [from, to] of the functions of [whole_from, whole_to].
LegendreTable legendre_from(double whole_from, double whole_to, double from, double to, std::size_t powers) {
  const auto exactly = [](double x) { return Rational::exactly(x); };
  const Rational width = exactly(whole_to) - exactly(whole_from);
  const Rational middle = (exactly(from) + exactly(to) - exactly(whole_from) - exactly(whole_to)) / width;
  return legendre_elsewhere(middle, (exactly(to) - exactly(from)) / width, powers);
}

/// Coefficients of polynomials on another box than their own, and what they are off by.
/// Maths     sum of n^2 products of two rounded entries and a coefficient: 2 n + 4 roundings each at most
struct OtherCoefficients {
  std::vector<double> values;
  std::vector<double> off;
};

class OtherBox {
public:
  OtherBox(const SectorBox& own, const SectorBox& other, std::size_t powers)
      : powers_(powers),
        in_s_(legendre_from(own.s0, own.s1, other.s0, other.s1, powers)),
        in_t_(legendre_from(own.t0, own.t1, other.t0, other.t1, powers)) {}

  [[nodiscard]] OtherCoefficients operator()(std::span<const double> c) const {
    const std::size_t n = powers_;
    OtherCoefficients out{.values = std::vector<double>(n * n), .off = std::vector<double>(n * n)};
    std::vector<double> half(n * n);
    std::vector<double> half_size(n * n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k <= i; ++k)
        for (std::size_t j = 0; j < n; ++j) {
          half[k * n + j] += in_s_[i * n + k] * c[i * n + j];
          half_size[k * n + j] += std::abs(in_s_[i * n + k] * c[i * n + j]);
        }
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t l = 0; l <= j; ++l) {
          out.values[k * n + l] += in_t_[j * n + l] * half[k * n + j];
          out.off[k * n + l] += std::abs(in_t_[j * n + l]) * half_size[k * n + j];
        }
    const double of_sums = static_cast<double>(2 * n + 4) * unit_roundoff<double>() * upward;
    for (double& off : out.off) off = off * of_sums + std::numeric_limits<double>::min();
    return out;
  }

private:
  std::size_t powers_;
  LegendreTable in_s_;
  LegendreTable in_t_;
};

/// sup |f - g| on the box that both have their coefficients for.
double largest_difference(const OtherCoefficients& f, const OtherCoefficients& g) {
  double sum = 0;
  for (std::size_t i = 0; i < f.values.size(); ++i)
    sum += std::abs(f.values[i] - g.values[i]) + f.off[i] + g.off[i];
  return std::isfinite(sum) ? sum * upward : std::numeric_limits<double>::infinity();
}

SlidSizes slid_sizes(const OtherCoefficients& f, std::size_t powers) {
  SectorFunctions largest(1, 1, static_cast<int>(powers) - 1);
  for (std::size_t i = 0; i < f.values.size(); ++i) largest.of(0, 0)[i] = std::abs(f.values[i]) + f.off[i];
  SlidSizes sizes;
  sizes.include(largest, 0);
  return sizes;
}

bool overlap(double a0, double a1, double b0, double b1) { return a0 < b1 && b0 < a1; }

}  // namespace

EdgeContinuation::EdgeContinuation(const SectorScene& scene, std::span<const SectorElement> elements,
                                   const SectorFunctions& w)
    : scene_(scene), elements_(elements), columns_(1), column_of_(elements.size()) {
  for (std::size_t sector = 0; sector < scene.sectors().size(); ++sector) {
    const std::optional<std::size_t> opposite = scene.opposite(sector);
    if (!opposite) continue;
    const std::size_t panel = scene.sectors()[*opposite].panel;
    const std::vector<ElementSide> sides = sides_across(scene, elements, sector, panel);
    for (std::size_t lowest = 0; lowest < elements.size(); ++lowest) {
      const SectorBox& box = elements[lowest].box;
      if (elements[lowest].sector != *opposite || box.t0 != 0) continue;
      std::vector<std::size_t> column{lowest};
      for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t e = 0; e < elements.size() && !grows; ++e) {
          const SectorBox& next = elements[e].box;
          if (elements[e].sector != *opposite || next.s0 != box.s0 || next.s1 != box.s1 ||
              next.t0 != elements[column.back()].box.t1)
            continue;
          column.push_back(e);
          grows = true;
        }
      }
      Column all;
      for (const double part : parts_of_width) all.push_back(continued(w, column, sides, part));
      columns_.push_back(std::move(all));
      for (std::size_t e = 0; e < elements.size(); ++e)
        if (elements[e].sector == sector && elements[e].box.s0 == 1 - box.s1 &&
            elements[e].box.s1 == 1 - box.s0)
          column_of_[e] = columns_.size() - 1;
    }
  }
}

EdgeContinuation::Continued EdgeContinuation::continued(const SectorFunctions& w,
                                                        std::span<const std::size_t> column,
                                                        const std::vector<ElementSide>& sides,
                                                        double part) const {
  const auto powers = static_cast<std::size_t>(w.degree() + 1);
  const std::size_t sector = elements_[column.front()].sector;
  const SectorBox& lowest = elements_[column.front()].box;
  const double top = elements_[column.back()].box.t1;
  // The sides of the sector itself are no borders that anything is continued across.
  double before = lowest.s0 > 0 ? lowest.s1 - lowest.s0 : 0;
  double after = lowest.s1 < 1 ? lowest.s1 - lowest.s0 : 0;
  for (const SectorElement& element : elements_) {
    const SectorBox& box = element.box;
    if (element.sector != sector || box.t0 >= top) continue;
    if (box.s1 == lowest.s0) before = std::min(before, box.s1 - box.s0);
    if (box.s0 == lowest.s1) after = std::min(after, box.s1 - box.s0);
  }
  const double s0 = lowest.s0 - part * before;
  const double s1 = lowest.s1 + part * after;
  Continued out;
  for (const ElementSide& side : sides) {
    const bool is_crossed = side.sector == sector && side.box.s0 == side.box.s1 && side.box.s0 > s0 &&
                            side.box.s0 < s1 && side.box.t1 <= top;
    if (!is_crossed) out.sides.push_back(side);
  }
  for (const double s : {s0, s1})
    out.sides.push_back(side_of(scene_, sector, {.s0 = s, .s1 = s, .t0 = 0, .t1 = top}));
  for (const std::size_t own : column) {
    const SectorBox& box = elements_[own].box;
    const OtherBox on_all(box, {.s0 = s0, .s1 = s1, .t0 = box.t0, .t1 = box.t1}, powers);
    for (std::size_t k = 0; k < w.count(); ++k) out.sizes.include(slid_sizes(on_all(w.of(own, k)), powers));
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      const SectorBox& other = elements_[e].box;
      if (e == own || elements_[e].sector != sector || !overlap(other.s0, other.s1, s0, s1) ||
          !overlap(other.t0, other.t1, box.t0, box.t1))
        continue;
      const SectorBox shared{.s0 = std::max(other.s0, s0),
                             .s1 = std::min(other.s1, s1),
                             .t0 = std::max(other.t0, box.t0),
                             .t1 = std::min(other.t1, box.t1)};
      const OtherBox from_own(box, shared, powers);
      const OtherBox from_other(other, shared, powers);
      Continued::Part reached{.corners = corners_of(scene_.sectors()[sector], shared), .difference = 0};
      for (std::size_t k = 0; k < w.count(); ++k)
        reached.difference =
            std::max(reached.difference, largest_difference(from_own(w.of(own, k)), from_other(w.of(e, k))));
      out.parts.push_back(reached);
    }
  }
  return out;
}

std::span<const EdgeContinuation::Continued> EdgeContinuation::beyond(std::size_t element) const {
  return columns_[column_of_[element]];
}

double EdgeContinuation::rest(const Continued& continued, std::size_t element,
                              std::span<const Vector<double>> hull) const {
  const std::size_t own = elements_[element].sector;
  const Sector& beyond = scene_.sectors()[*scene_.opposite(own)];
  const double slack = 8 * displacement * scene_.extent();
  const Vector<double>& n = scene_.normal(beyond.panel);
  const Vector<double> along = (1 / norm(beyond.b - beyond.a)) * (beyond.b - beyond.a);
  const Vector<double> away = cross(n, along);
  double height = 0;
  for (const Vector<double>& p : hull) height = std::max(height, dot(n, p - beyond.a));
  const double rings =
      (scene_.before(scene_.sectors()[own].panel, beyond.panel) ? 2 : 1) * (height * upward + slack);
  // Between the projections on a line through the edge.
  const auto gap = [&](const Vector<double>& line, const std::array<Vector<double>, 4>& corners) {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    double least_of_hull = least;
    double most_of_hull = most;
    for (const Vector<double>& q : corners) {
      least = std::min(least, dot(line, q - beyond.a));
      most = std::max(most, dot(line, q - beyond.a));
    }
    for (const Vector<double>& p : hull) {
      least_of_hull = std::min(least_of_hull, dot(line, p - beyond.a));
      most_of_hull = std::max(most_of_hull, dot(line, p - beyond.a));
    }
    return std::max({0.0, least - most_of_hull, least_of_hull - most});
  };
  double sum = 0;
  for (const Continued::Part& part : continued.parts) {
    const double q = std::hypot(gap(along, part.corners), gap(away, part.corners)) / upward - slack;
    sum += part.difference * (q > rings ? rings / q : 1);
  }
  return sum * upward;
}

}  // namespace radcert
