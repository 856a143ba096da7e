// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "radcert/core/contract.h"
#include "radcert/scalar/functions/dilogarithm.h"
#include "radcert/scalar/real.h"

namespace radcert {

/// An edge of a polygon in the orthonormal coordinates (x,y) of its plane, with the foot of P at the origin.
/// Maths     points (d tau_y + t tau_x, -d tau_x + t tau_y), start <= t <= end, tau = direction, d =
///           distance; slant = sqrt(d^2 + h^2)
/// Requires  the signs are those of the exact numbers; the polygon lies to the left of its edges
/// Result    data alone
template <Field R>
struct FootEdge {
  R direction_x{};
  R direction_y{};
  R distance{};  ///< positive where the foot lies to the left
  R slant{};
  R length{};
  R start{};
  R end{};
  R start_x{};
  R start_y{};
  R end_x{};
  R end_y{};
  R neglected{};  ///< encloses 0, and the parts of N_00 and 2 h^2 M_00 if distance_sign is 0; 0 where d = 0
  /// 0 where the edge's line goes through the foot, or may do so; then `neglected` stands for what that
  /// leaves undecided.
  int distance_sign = 0;
  int start_sign = 0;
  int end_sign = 0;
};

/// P as its foot sees it.
/// Maths     h, the height of P above the plane along the polygon's inner normal; n_P in the coordinates (x,
///           y, inner normal)
/// Requires  h != 0; a foot on the polygon's boundary is not outside
/// Result    data alone
template <Field R>
struct FootView {
  R height{};
  R normal_x{};
  R normal_y{};
  R normal_z{};
  /// Whether the foot is certainly outside; then logarithms and angles that cancel over the edges are left
  /// out.
  bool foot_outside = false;
};

/// The transcendental values in an edge's integrals.
/// Maths     w = t^2 + slant^2; angle = slant Int dt / w; lambert: the edge's part of 2 h^2 M_00, and
///           logarithm that of N_00, up to parts whose sums over the edges vanish; rise = Int t / w dt
/// Source    KernelMoments
/// Result    data alone
/// Limits    logarithm and rise count from degree 1 on
template <Field R>
struct EdgeIntegrals {
  R angle{};
  R lambert{};
  R logarithm{};
  R rise{};
};

/// The integrals of the radiosity kernel times monomials over a plane polygon, by sums over its edges.
/// Maths     mu_ij = Int h (n_x x + n_y y - h n_z) x^i y^j / w^2 dx dy,  w = x^2 + y^2 + h^2,  i + j <=
///           degree. With M_ij = Int x^i y^j / w^2, N_ij = Int x^i y^j / w, P_ij = Int x^i y^j and line
///           integrals over the boundary: M_{1,n-1} = -1/2 oint y^{n-1} dy / w,  M_{0,n} = (n-1)/2 N_{0,n-2}
///           + 1/2 oint y^{n-1} dx / w, M_{i+2,j} = N_ij - h^2 M_ij - M_{i,j+2}; n N_{1,n-1} = -oint y^n dv,
///           n N_{0,n} = oint x y^{n-1} dv + (n-1) (P_{0,n-2} - h^2 N_{0,n-2}), dv = (x dx + y dy) / w,
///           N_{i+2,j} = P_ij - h^2 N_ij - N_{i,j+2}; N_00 by the dilogarithm, h^2 M_00 by Lambert's angles
/// Source    Green's theorem; Lambert 1760 for h^2 M_00
/// Requires  0 <= degree <= largest_degree; add() every edge once, then finish(). R has the functions of
///           Real, but for exp, sin, cos and pow
/// Result    as R computes; all sums in the order of the edges
/// Limits    cancels where the polygon is small against its distance from P: there a rule of quadrature is
///           better
template <Field R, int most = 8>
class KernelMoments {
public:
  static constexpr int largest_degree = most;
  static constexpr std::size_t table_size = largest_degree + 2;
  /// mu_ij at [i][j].
  using Table = std::array<std::array<R, table_size>, table_size>;

  KernelMoments(const FootView<R>& view, int degree)
      : view_(view), squared_height_(view.height * view.height), degree_(degree) {
    expects(degree >= 0 && degree <= largest_degree, "0 <= degree <= largest_degree",
            named("degree", degree));
  }

  /// The edge's part of every line integral.
  void add(const FootEdge<R>& edge);
  /// The same where the caller has found what is not algebraic; the signs in `edge` and its `neglected` do
  /// not count then.
  void add(const FootEdge<R>& edge, const EdgeIntegrals<R>& found);
  /// The integrals, once all edges are in.
  [[nodiscard]] Table finish() const;

private:
  using Row = std::array<R, table_size>;

  [[nodiscard]] R lambert_part(const FootEdge<R>& edge, const R& angle) const;
  [[nodiscard]] R logarithm_part(const FootEdge<R>& edge) const;
  void add_polynomials(const FootEdge<R>& edge);
  [[nodiscard]] static R angle_from(const R& opposite, const R& adjacent);
  [[nodiscard]] R primitive(const FootEdge<R>& edge, const R& t, int sign) const;
  [[nodiscard]] R outer_angle(const FootEdge<R>& edge, const R& size, const R& t) const;
  [[nodiscard]] static R signed_by(int sign, const R& x) { return sign < 0 ? -x : x; }

  FootView<R> view_;
  R squared_height_;
  int degree_;
  R lambert_{};         ///< 2 h^2 M_00
  R logarithm_{};       ///< N_00
  Row along_x_{};       ///< oint y^m dx / w
  Row along_y_{};       ///< oint y^m dy / w
  Row radial_{};        ///< oint y^m dv
  Row radial_x_{};      ///< oint x y^m dv
  Table polynomial_{};  ///< (i + j + 2) P_ij
};

/// The angle of the point (adjacent, opposite), opposite > 0, in (0, pi).
template <Field R, int most>
R KernelMoments<R, most>::angle_from(const R& opposite, const R& adjacent) {
  using std::atan;
  using std::atan2;
  if constexpr (requires { atan2(opposite, adjacent); }) {
    return atan2(opposite, adjacent);
  } else {
    if (certainly_less(opposite, adjacent)) return atan(opposite / adjacent);
    if (certainly_less(opposite, -adjacent)) return pi<R>() - atan(opposite / -adjacent);
    return pi<R>() / R(2) - atan(adjacent / opposite);
  }
}

template <Field R, int most>
void KernelMoments<R, most>::add(const FootEdge<R>& edge) {
  using std::log;
  EdgeIntegrals<R> found;
  const R squared_slant = edge.slant * edge.slant;
  found.angle = angle_from(edge.slant * edge.length, squared_slant + edge.start * edge.end);
  found.lambert = lambert_part(edge, found.angle);
  if (degree_ > 0) {
    found.logarithm = logarithm_part(edge);
    const R start_square = edge.start * edge.start + squared_slant;
    const R end_square = edge.end * edge.end + squared_slant;
    found.rise = log(end_square / start_square) / R(2);
  }
  add(edge, found);
}

template <Field R, int most>
void KernelMoments<R, most>::add(const FootEdge<R>& edge, const EdgeIntegrals<R>& found) {
  // Y_m = Int y^m / w dt and T_m = Int t y^m / w dt, from y = tau_y t - d tau_x and t^2 = w - a^2.
  const R squared_slant = edge.slant * edge.slant;
  R y_part = found.angle / edge.slant;
  lambert_ = lambert_ + found.lambert;
  along_x_[0] = along_x_[0] + edge.direction_x * y_part;
  along_y_[0] = along_y_[0] + edge.direction_y * y_part;
  if (degree_ == 0) return;
  logarithm_ = logarithm_ + found.logarithm;
  add_polynomials(edge);
  R t_part = found.rise;
  const R offset = edge.distance * edge.direction_x;
  const R along = edge.distance * edge.direction_y;
  // Int y^m dt = length / (m + 1) sum_k start_y^k end_y^(m-k)
  R sum = R(1);
  R end_power = R(1);
  for (int m = 0; m < degree_; ++m) {
    const auto place = static_cast<std::size_t>(m);
    const R plain = edge.length * sum / R(m + 1);
    const R cubic = plain - squared_slant * y_part;  // Int t^2 y^m / w dt
    radial_[place] = radial_[place] + t_part;
    radial_x_[place] = radial_x_[place] + along * t_part + edge.direction_x * cubic;
    const R next = edge.direction_y * t_part - offset * y_part;
    t_part = edge.direction_y * cubic - offset * t_part;
    y_part = next;
    along_x_[place + 1] = along_x_[place + 1] + edge.direction_x * y_part;
    along_y_[place + 1] = along_y_[place + 1] + edge.direction_y * y_part;
    end_power = end_power * edge.end_y;
    sum = sum * edge.start_y + end_power;
  }
}

/// Lambert's term. Foot inside: (d/a) [atan(t/a)]. Outside, where the angles at the foot add up to zero:
/// minus h^2 Int dtheta / w, theta the angle at the foot, which has h^2 as a factor.
template <Field R, int most>
R KernelMoments<R, most>::lambert_part(const FootEdge<R>& edge, const R& angle) const {
  if (edge.distance_sign == 0) return edge.neglected;
  if (!view_.foot_outside) return edge.distance / edge.slant * angle;
  const R size = signed_by(edge.distance_sign, edge.distance);
  const R part = outer_angle(edge, size, edge.end) - outer_angle(edge, size, edge.start);
  return -signed_by(edge.distance_sign, part);
}

/// h^2 Int_0^t |d| / (rho^2 w) dt = atan(t (a - |d|) / (a |d| + t^2)) + (a - |d|) / a atan(t/a), rho^2 = d^2
/// + t^2.
template <Field R, int most>
R KernelMoments<R, most>::outer_angle(const FootEdge<R>& edge, const R& size, const R& t) const {
  using std::atan;
  const R& a = edge.slant;
  const R excess = squared_height_ / (a + size);
  return atan(t * excess / (a * size + t * t)) + excess / a * atan(t / a);
}

template <Field R, int most>
R KernelMoments<R, most>::logarithm_part(const FootEdge<R>& edge) const {
  if (edge.distance_sign == 0) return edge.neglected;
  const R part = primitive(edge, edge.end, edge.end_sign) - primitive(edge, edge.start, edge.start_sign);
  return signed_by(edge.distance_sign, part);
}

/// Int_0^t |d| log(w / c^2) / (2 rho^2) dt, c = |h|, or 1 where the foot is outside:
/// (pi/2 - psi) log((a + |d|) / c) + 1/2 Im [Li_2(kappa e^(2 i psi)) - Li_2(e^(2 i psi))], tan psi = |d| / t,
/// kappa = (a - |d|) / (a + |d|).
template <Field R, int most>
R KernelMoments<R, most>::primitive(const FootEdge<R>& edge, const R& t, int sign) const {
  using std::log;
  using std::sqrt;
  if (sign == 0) return R(0);
  const R size = signed_by(edge.distance_sign, edge.distance);
  const R along = signed_by(sign, t);
  const R sum = edge.slant + size;
  // At most 1 but for a rounding.
  const R ratio = smaller_of(squared_height_ / (sum * sum), R(1));
  const R psi = angle_from(size, along);
  const R theta = angle_from(along, size);
  const R double_psi = psi + psi;
  const R logarithm = log(view_.foot_outside ? sum * sum : sum * sum / squared_height_) / R(2);
  const R value = theta * logarithm +
                  (dilogarithm_imaginary(ratio, double_psi) - dilogarithm_imaginary(R(1), double_psi)) / R(2);
  return signed_by(sign, value);
}

/// Int x^i y^j dt for i + j <= degree - 3, each times d:
/// (n + 1) S_ij = [t x^i y^j] + d (i tau_y S_{i-1,j} - j tau_x S_{i,j-1}), n = i + j.
template <Field R, int most>
void KernelMoments<R, most>::add_polynomials(const FootEdge<R>& edge) {
  const int top = degree_ - 3;
  if (top < 0) return;
  Table line{};
  R start_row = edge.start;
  R end_row = edge.end;
  for (int i = 0; i <= top; ++i) {
    R start = start_row;
    R end = end_row;
    for (int j = 0; i + j <= top; ++j) {
      const auto row = static_cast<std::size_t>(i);
      const auto column = static_cast<std::size_t>(j);
      R value = end - start;
      if (i > 0) value = value + R(i) * edge.distance * edge.direction_y * line[row - 1][column];
      if (j > 0) value = value - R(j) * edge.distance * edge.direction_x * line[row][column - 1];
      line[row][column] = value / R(i + j + 1);
      polynomial_[row][column] = polynomial_[row][column] + edge.distance * line[row][column];
      start = start * edge.start_y;
      end = end * edge.end_y;
    }
    start_row = start_row * edge.start_x;
    end_row = end_row * edge.end_x;
  }
}

template <Field R, int most>
typename KernelMoments<R, most>::Table KernelMoments<R, most>::finish() const {
  const auto at = [](int k) { return static_cast<std::size_t>(k); };
  const R half = R(1) / R(2);
  // N_ij, i + j <= degree - 1
  Table n_table{};
  if (degree_ > 0) n_table[0][0] = logarithm_;
  for (int n = 1; n < degree_; ++n) {
    R whole = radial_x_[at(n - 1)];
    if (n > 1) {
      const R inner = polynomial_[0][at(n - 2)] / R(n) - squared_height_ * n_table[0][at(n - 2)];
      whole = whole + R(n - 1) * inner;
    }
    n_table[0][at(n)] = whole / R(n);
    n_table[1][at(n - 1)] = -radial_[at(n)] / R(n);
    for (int i = 0; i + 2 <= n; ++i) {
      const int j = n - 2 - i;
      n_table[at(i + 2)][at(j)] = polynomial_[at(i)][at(j)] / R(n) - squared_height_ * n_table[at(i)][at(j)] -
                                  n_table[at(i)][at(j + 2)];
    }
  }
  // M_ij, i + j <= degree + 1, and h^2 M_ij; M_00 itself is not needed.
  Table m_table{};
  const R scaled = half * lambert_;
  for (int n = 1; n <= degree_ + 1; ++n) {
    R last = half * along_x_[at(n - 1)];
    if (n > 1) last = last + R(n - 1) * half * n_table[0][at(n - 2)];
    m_table[0][at(n)] = last;
    m_table[1][at(n - 1)] = -(half * along_y_[at(n - 1)]);
    for (int i = 0; i + 2 <= n; ++i) {
      const int j = n - 2 - i;
      const R below = n == 2 ? scaled : squared_height_ * m_table[at(i)][at(j)];
      m_table[at(i + 2)][at(j)] = n_table[at(i)][at(j)] - below - m_table[at(i)][at(j + 2)];
    }
  }
  Table moments{};
  for (int i = 0; i <= degree_; ++i) {
    for (int j = 0; i + j <= degree_; ++j) {
      const R below = i + j == 0 ? scaled : squared_height_ * m_table[at(i)][at(j)];
      moments[at(i)][at(j)] = view_.height * (view_.normal_x * m_table[at(i + 1)][at(j)] +
                                              view_.normal_y * m_table[at(i)][at(j + 1)]) -
                              view_.normal_z * below;
    }
  }
  return moments;
}

/// Another pair of coordinates in the plane.
/// Maths     t = t_0 + t_y y,  s = s_0 + s_x x + s_t t
/// Result    data alone
template <Field R>
struct PlaneSubstitution {
  R t_0{};
  R t_y{};
  R s_0{};
  R s_x{};
  R s_t{};
};

/// Integrals of monomials in x and y turned into those of monomials in s and t, in place.
/// Maths     Int s^i t^j dm from Int x^i y^j dm, i + j <= degree, one factor at a time
/// Requires  degree below the table's size
/// Result    as R computes
/// Limits    cancels where the foot is far from the polygon against its size
template <Field R, std::size_t Size>
void substitute(const PlaneSubstitution<R>& to, int degree, std::array<std::array<R, Size>, Size>& table) {
  const auto at = [](int k) { return static_cast<std::size_t>(k); };
  for (int k = 0; k <= degree; ++k) {
    for (int j = 1; j <= degree - k; ++j) {
      for (int l = degree - k; l >= j; --l) {
        table[at(k)][at(l)] = to.t_0 * table[at(k)][at(l - 1)] + to.t_y * table[at(k)][at(l)];
      }
    }
  }
  for (int i = 1; i <= degree; ++i) {
    for (int k = degree; k >= i; --k) {
      for (int l = 0; k + l <= degree; ++l) {
        table[at(k)][at(l)] = to.s_0 * table[at(k - 1)][at(l)] + to.s_x * table[at(k)][at(l)] +
                              to.s_t * table[at(k - 1)][at(l + 1)];
      }
    }
  }
}

}  // namespace radcert
