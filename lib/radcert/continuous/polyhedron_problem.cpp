// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/polyhedron_problem.h"

#include <algorithm>
#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/geometry/plane_polygon.h"

namespace radcert {
namespace {

/// A polynomial of two variables by the powers of each: c[i][j] x^i y^j.
using TensorPolynomial = std::vector<std::vector<Rational>>;

TensorPolynomial zero(std::size_t powers) { return {powers, std::vector<Rational>(powers)}; }

TensorPolynomial product(const TensorPolynomial& a, const TensorPolynomial& b) {
  TensorPolynomial out = zero(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j) {
      if (a[i][j].sign() == 0) continue;
      for (std::size_t k = 0; i + k < a.size(); ++k)
        for (std::size_t l = 0; j + l < a.size(); ++l)
          if (b[k][l].sign() != 0) out[i + k][j + l] += a[i][j] * b[k][l];
    }
  return out;
}

/// A polynomial of the plane's parameters as one of those of a sector.
/// Maths     the point (s,t) of the sector is, in the plane, of + s along + t (centre - of) - s t along
TensorPolynomial on_sector(const PlanePolynomial<Rational>& f, const Panel& panel, std::size_t corner,
                           std::size_t powers) {
  const std::vector<Vector<Rational>>& corners = panel.corners;
  const ParameterPoint<Rational> a = plane_coordinates(panel, corners[corner]);
  const ParameterPoint<Rational> b = plane_coordinates(panel, corners[(corner + 1) % corners.size()]);
  const ParameterPoint<Rational> c = plane_coordinates(panel, panel.centre);
  const auto bilinear = [&](const Rational& of_a, const Rational& of_b, const Rational& of_c) {
    TensorPolynomial out = zero(powers);
    out[0][0] = of_a;
    if (powers > 1) {
      out[1][0] = of_b - of_a;
      out[0][1] = of_c - of_a;
      out[1][1] = of_a - of_b;
    }
    return out;
  };
  const TensorPolynomial x = bilinear(a.s, b.s, c.s);
  const TensorPolynomial y = bilinear(a.t, b.t, c.t);
  TensorPolynomial sum = zero(powers);
  for (int i = f.degree(); i >= 0; --i) {
    TensorPolynomial inner = zero(powers);
    for (int j = f.degree() - i; j >= 0; --j) {
      inner = product(inner, y);
      inner[0][0] += f(i, j);
    }
    sum = product(sum, x);
    for (std::size_t k = 0; k < powers; ++k)
      for (std::size_t l = 0; l < powers; ++l) sum[k][l] += inner[k][l];
  }
  return sum;
}

/// The coefficients of f(m + h x) in P_0(x), ..., P_n(x), from those of f in powers.
/// Maths     Horner's rule: sum = sum (m + h x) + c, with x P_i = ((i+1) P_(i+1) + i P_(i-1))/(2i+1)
std::vector<Rational> in_legendre(const std::vector<Rational>& powers, const Rational& m, const Rational& h) {
  const std::size_t n = powers.size();
  std::vector<Rational> sum(n);
  for (std::size_t k = n; k-- > 0;) {
    std::vector<Rational> next(n);
    for (std::size_t i = 0; i < n; ++i) {
      if (sum[i].sign() == 0) continue;
      const auto degree = static_cast<long>(i);
      next[i] += m * sum[i];
      if (i + 1 < n) next[i + 1] += h * Rational(degree + 1, 2 * degree + 1) * sum[i];
      if (i > 0) next[i - 1] += h * Rational(degree, 2 * degree + 1) * sum[i];
    }
    next[0] += powers[k];
    sum = std::move(next);
  }
  return sum;
}

TensorPolynomial transposed(const TensorPolynomial& f) {
  TensorPolynomial out = zero(f.size());
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < f.size(); ++j) out[j][i] = f[i][j];
  return out;
}

TensorPolynomial first_in_legendre(const TensorPolynomial& f, double from, double to) {
  const Rational m = Rational::exactly(0.5 * (from + to));
  const Rational h = Rational::exactly(0.5 * (to - from));
  TensorPolynomial columns = transposed(f);
  for (std::vector<Rational>& column : columns) column = in_legendre(column, m, h);
  return transposed(columns);
}

/// The least sign of a point with regard to the sides of a convex polygon, 1 inside it and 0 on a side; -1
/// also off its plane.
int least_side(const Panel& panel, const Vector<Rational>& p) {
  const std::vector<Vector<Rational>>& corners = panel.corners;
  if (dot(panel.normal, p - corners[0]).sign() != 0) return -1;
  int least = 1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<Rational> side = corners[(i + 1) % corners.size()] - corners[i];
    least = std::min(least, dot(cross(side, p - corners[i]), panel.normal).sign());
  }
  return least;
}

/// The rays between which a panel lies as seen from a point of its border, counterclockwise.
struct PanelAngle {
  Vector<Rational> from;
  Vector<Rational> to;
};

PanelAngle angle_at(const Panel& panel, const Vector<Rational>& p) {
  const std::vector<Vector<Rational>>& corners = panel.corners;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i)
    if (corners[i] == p) return {corners[(i + 1) % n] - p, corners[(i + n - 1) % n] - p};
  std::size_t side = 0;
  while (cross(corners[(side + 1) % n] - corners[side], p - corners[side]) != Vector<Rational>{}) ++side;
  return {corners[(side + 1) % n] - p, corners[side] - p};
}

}  // namespace

ParameterPoint<Rational> plane_coordinates(const Panel& panel, const Vector<Rational>& p) {
  const std::vector<Vector<Rational>>& c = panel.corners;
  return coordinates(p - c[0], c[1] - c[0], c[2] - c[0]);
}

std::size_t panel_inside(const std::vector<Panel>& panels, const Vector<Rational>& p) {
  const auto holds = [&](const Panel& panel) { return least_side(panel, p) > 0; };
  return static_cast<std::size_t>(std::find_if(panels.begin(), panels.end(), holds) - panels.begin());
}

std::size_t panel_about(const std::vector<Panel>& panels, const Vector<Rational>& p) {
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const int least = least_side(panels[k], p);
    if (least < 0) continue;
    const bool is_touched = std::any_of(panels.begin(), panels.end(), [&](const Panel& other) {
      return least_side(other, p) >= 0 && !(cross(other.normal, panels[k].normal) == Vector<Rational>{} &&
                                            dot(other.normal, panels[k].normal).sign() > 0);
    });
    if (is_touched) return panels.size();
    if (least > 0) return k;
    std::vector<PanelAngle> angles;
    for (const Panel& other : panels)
      if (other.piece == panels[k].piece && dot(other.normal, panels[k].normal).sign() > 0 &&
          least_side(other, p) == 0)
        angles.push_back(angle_at(other, p));
    const auto goes_on = [&](const PanelAngle& one) {
      return std::any_of(angles.begin(), angles.end(), [&](const PanelAngle& other) {
        return cross(one.to, other.from) == Vector<Rational>{} && dot(one.to, other.from).sign() > 0;
      });
    };
    return std::all_of(angles.begin(), angles.end(), goes_on) ? k : panels.size();
  }
  return panels.size();
}

SectorFunctions emission_functions(const PolyhedronProblem& problem, const SectorScene& scene,
                                   std::span<const SectorElement> elements, std::size_t count, int degree,
                                   int exponent) {
  return plane_functions(problem.emission, scene, elements, count, degree, exponent);
}

SectorFunctions plane_functions(std::span<const PlanePolynomial<Rational>> polynomials,
                                const SectorScene& scene, std::span<const SectorElement> elements,
                                std::size_t count, int degree, int exponent) {
  SectorFunctions out(elements.size(), count, degree);
  const auto powers = static_cast<std::size_t>(degree + 1);
  std::vector<TensorPolynomial> by_sector;
  for (std::size_t k = 0; k < scene.sectors().size(); ++k) {
    const std::size_t panel = scene.sectors()[k].panel;
    const PlanePolynomial<Rational>& f = polynomials[panel];
    expects(f.degree() <= degree, "degree >= that of each polynomial", named("degree", degree));
    const auto own = static_cast<std::size_t>(f.degree() + 1);
    by_sector.push_back(on_sector(f, scene.panels()[panel], k - scene.first_sector(panel), own));
  }
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const SectorBox& box = elements[e].box;
    TensorPolynomial f = first_in_legendre(by_sector[elements[e].sector], box.s0, box.s1);
    f = transposed(first_in_legendre(transposed(f), box.t0, box.t1));
    const std::span<double> c = out.of(e, 0);
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t j = 0; j < f.size(); ++j)
        c[i * powers + j] = std::ldexp(f[i][j].to_double(), -exponent);
  }
  return out;
}

}  // namespace radcert
