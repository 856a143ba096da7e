// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/solve/gmres.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "radcert/solve/linear_solver.h"

namespace radcert {
namespace {

/// y -= factor x
void subtract(std::span<double> y, double factor, std::span<const double> x) {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] -= factor * x[i];
}

/// GMRES from zero for (I - K) d = r, with room for its vectors.
class Krylov {
public:
  Krylov(const SystemProducts& k, double least_weight)
      : k_(k),
        parts_(k.parts()),
        least_weight_(least_weight),
        vectors_(k.rows(), std::min(parts_.whole(), krylov_dimension.count()) + 1),
        hessenberg_(vectors_.columns(), vectors_.columns()),
        right_(vectors_.columns()),
        rotations_(vectors_.columns()) {}

  /// r becomes d; the number of Krylov vectors that took.
  std::size_t operator()(std::span<double> r, double goal) {
    constexpr double enough = 0x1p-36;
    // Of size 1, so that no square overflows.
    const double scale = parts_.size_of(r);
    if (scale == 0) return 0;
    const std::span<double> first = vectors_.column(0);
    for (std::size_t i = 0; i < r.size(); ++i) first[i] = r[i] / scale;
    const double length = norm(first);
    for (double& value : first) value /= length;
    std::fill(right_.begin(), right_.end(), 0.0);
    right_[0] = length;
    const double small = std::max(enough * length, goal * least_weight_ / 2 / scale);
    std::size_t m = 0;
    while (m + 1 < vectors_.columns() && std::abs(right_[m]) > small) {
      const bool exhausted = !extend(m);
      rotate(m++);
      if (exhausted) break;
    }
    combine(m, scale, r);
    return m;
  }

private:
  [[nodiscard]] double norm(std::span<const double> a) const { return std::sqrt(parts_.dot(a, a)); }

  struct Rotation {
    double cosine = 1;
    double sine = 0;
  };

  /// The column m of the Hessenberg matrix and the vector m + 1; false if there is none, the space being
  /// invariant.
  bool extend(std::size_t m) {
    const std::span<const double> last = vectors_.column(m);
    const std::span<double> next = vectors_.column(m + 1);
    k_.multiply(last, next);
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = last[i] - next[i];
    const double before = norm(next);
    for (std::size_t i = 0; i <= m; ++i) hessenberg_(i, m) = 0;
    constexpr int times = 2;
    for (int time = 0; time < times; ++time)
      for (std::size_t i = 0; i <= m; ++i) {
        const double along = parts_.dot(vectors_.column(i), next);
        hessenberg_(i, m) += along;
        subtract(next, along, vectors_.column(i));
      }
    const double after = norm(next);
    constexpr double nothing = 0x1p-50;
    const bool independent = after > nothing * before;
    hessenberg_(m + 1, m) = independent ? after : 0;
    if (independent)
      for (double& value : next) value /= after;
    return independent;
  }

  /// Turns the new column into one of an upper triangular matrix.
  void rotate(std::size_t m) {
    for (std::size_t i = 0; i < m; ++i) apply(rotations_[i], hessenberg_(i, m), hessenberg_(i + 1, m));
    const double radius = std::hypot(hessenberg_(m, m), hessenberg_(m + 1, m));
    rotations_[m] =
        radius > 0 ? Rotation{hessenberg_(m, m) / radius, hessenberg_(m + 1, m) / radius} : Rotation{};
    apply(rotations_[m], hessenberg_(m, m), hessenberg_(m + 1, m));
    apply(rotations_[m], right_[m], right_[m + 1]);
  }

  static void apply(const Rotation& rotation, double& a, double& b) {
    const double turned = rotation.cosine * a + rotation.sine * b;
    b = rotation.cosine * b - rotation.sine * a;
    a = turned;
  }

  /// d = scale sum_i y_i q_i with the triangular system's solution y, which takes the place of right_. The
  /// diagonal does not vanish: theta < 1 makes I - K regular, and so its restriction to the space.
  void combine(std::size_t m, double scale, std::span<double> d) {
    for (std::size_t i = m; i-- > 0;) {
      for (std::size_t j = i + 1; j < m; ++j) right_[i] -= hessenberg_(i, j) * right_[j];
      right_[i] = hessenberg_(i, i) != 0 ? right_[i] / hessenberg_(i, i) : 0;
    }
    std::fill(d.begin(), d.end(), 0.0);
    for (std::size_t i = 0; i < m; ++i) subtract(d, -scale * right_[i], vectors_.column(i));
  }

  SystemProducts k_;
  VectorParts parts_;
  double least_weight_;
  Matrix<double> vectors_;
  Matrix<double> hessenberg_;
  std::vector<double> right_;
  std::vector<Rotation> rotations_;
};

}  // namespace

const WorkLimit krylov_dimension("solve/gmres: vectors", 64, 1,
                                 "begun anew; refused with the bound reached where that stands still");

Outcome<IterativeSolution, NotReached> solve_by_gmres(const SystemProducts& k, const Contraction& contraction,
                                                      std::span<const double> e,
                                                      std::optional<double> tolerance, KeptNumbers* kept) {
  Krylov krylov(k, contraction.least_weight());
  return iterate(k, contraction, e, tolerance,
                 {.apply = [&krylov](std::span<double> r, double goal) { return krylov(r, goal); },
                  .reflections = krylov_dimension.count()},
                 kept);
}

LinearSolver gmres_entry() {
  return {.name = "gmres",
          .summary = "GMRES; a proved bound of the linear system's error stops it",
          .iterate = solve_by_gmres,
          .plan = [](MemoryPlan& plan, std::uint64_t n) {
            plan.add("Krylov vectors", n,
                     (std::min<std::uint64_t>(n, krylov_dimension.count()) + 1) * sizeof(double));
          }};
}

}  // namespace radcert
