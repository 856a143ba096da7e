// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/densities.h"

#include <algorithm>
#include <cmath>

#include "radcert/certificate/face_polynomial.h"
#include "radcert/certificate/gauss_rule.h"
#include "radcert/geometry/plane_polygon.h"
#include "radcert/scalar/pack.h"

namespace radcert::certificate {
namespace {

/// Plane parameters of a face along a triangle: a + s (1-t) along + t inward, as numbers of the face's frame.
struct Frame {
  ParameterPoint<Ball> a, along, inward;
};

ParameterPoint<Ball> enclosed(const ParameterPoint<Rational>& p) { return {Ball(p.s), Ball(p.t)}; }

Frame frame(const Face& face, std::size_t side) {
  const std::vector<Vector<Rational>>& c = face.corners;
  const auto at = [&](const Vector<Rational>& v) { return coordinates(v, c[1] - c[0], c[2] - c[0]); };
  Vector<Rational> sum;
  for (const Vector<Rational>& p : c) sum = sum + p;
  const Vector<Rational> centre = Rational(1, static_cast<long>(c.size())) * sum;
  return {enclosed(at(c[side] - c[0])), enclosed(at(c[(side + 1) % c.size()] - c[side])),
          enclosed(at(centre - c[side]))};
}

int emission_degree(const Face& face) { return static_cast<int>(face.emission.size()) - 1; }

using BallPolynomial = std::vector<std::vector<Ball>>;

BallPolynomial enclosed(const std::vector<std::vector<Rational>>& f) {
  BallPolynomial out;
  for (const std::vector<Rational>& row : f) {
    out.emplace_back();
    for (const Rational& x : row) out.back().emplace_back(x);
  }
  return out;
}

/// The functions w_k and rho on elements in Legendre polynomials.
class ElementFunctions {
public:
  ElementFunctions(const PolyhedronCertificate& certificate, int degree) : c_(certificate), degree_(degree) {
    for (const Face& face : c_.faces) {
      emission_.push_back(enclosed(face.emission));
      reflectivity_.push_back(enclosed(face.varying_reflectivity));
      frames_.emplace_back();
      for (std::size_t side = 0; side < face.corners.size(); ++side)
        frames_.back().push_back(frame(face, side));
    }
    for (const Ball& node : gauss_rule(degree + 1).nodes) p_.push_back(legendre(degree, node));
  }

  /// w_0 = E + rho q_0 by i, j.
  [[nodiscard]] std::vector<Ball> first(std::size_t e) const {
    const Element& element = c_.elements[e];
    const Face& face = c_.faces[element.face];
    std::vector<Ball> out(size());
    if (emission_degree(face) == 0)
      out[0] = emission_[element.face][0][0];
    else
      out = expanded(element,
                     [&](const At& at) { return polynomial_value(emission_[element.face], at.x, at.y); });
    add_reflected(e, 0, 0, out);
    return out;
  }

  /// w_k = rho (j + q_k) by i, j for k > 0, j constant.
  [[nodiscard]] std::vector<Ball> dual(std::size_t e, std::size_t k, int j) const {
    std::vector<Ball> out(size());
    add_reflected(e, k, j, out);
    return out;
  }

  /// At least sup rho.
  /// Maths     the sum of the sizes of its coefficients, or what is stated for the face
  [[nodiscard]] double largest_reflectivity(std::size_t e) const {
    const Element& element = c_.elements[e];
    const double stated = Ball(c_.faces[element.face].reflectivity).upper_double();
    if (reflectivity_[element.face].empty()) return stated;
    Ball sum;
    for (const Ball& x : expanded(element, [&](const At& at) { return rho(element, at); })) sum += abs(x);
    return std::min(stated, sum.upper_double());
  }

private:
  /// A node of an element, and its place in the face's frame.
  struct At {
    std::size_t m, l;
    Ball x, y;
  };

  [[nodiscard]] std::size_t powers() const { return static_cast<std::size_t>(degree_) + 1; }
  [[nodiscard]] std::size_t size() const { return powers() * powers(); }

  [[nodiscard]] Ball rho(const Element& element, const At& at) const {
    return polynomial_value(reflectivity_[element.face], at.x, at.y);
  }

  /// out += rho (j + q_k).
  void add_reflected(std::size_t e, std::size_t k, int j, std::vector<Ball>& out) const {
    const Element& element = c_.elements[e];
    if (reflectivity_[element.face].empty()) {
      const Ball constant(c_.faces[element.face].reflectivity);
      for (std::size_t i = 0; i < c_.powers(); ++i)
        for (std::size_t l = 0; l < c_.powers(); ++l)
          out[i * powers() + l] += constant * Ball(c_.coefficient(k, e, i, l));
      out[0] += constant * Ball(j);
      return;
    }
    const std::vector<Ball> more = expanded(element, [&](const At& at) {
      Ball q(j);
      for (std::size_t i = 0; i < c_.powers(); ++i)
        for (std::size_t l = 0; l < c_.powers(); ++l)
          q += Ball(c_.coefficient(k, e, i, l)) * p_[at.m][i] * p_[at.l][l];
      return rho(element, at) * q;
    });
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += more[i];
  }

  /// c_ij = (2i+1)(2j+1)/4 sum W_m W_l P_i(x_m) P_j(x_l) f, for f of no higher degree.
  template <class F>
  [[nodiscard]] std::vector<Ball> expanded(const Element& element, const F& f) const {
    std::vector<Ball> out(size());
    const GaussRule& rule = gauss_rule(degree_ + 1);
    const Frame& in = frames_[element.face][element.side];
    const auto place = [](double from, double to, const Ball& x) {
      const Ball low(from);
      const Ball high(to);
      return (low + high + (high - low) * x) / Ball(2);
    };
    for (std::size_t m = 0; m < powers(); ++m)
      for (std::size_t l = 0; l < powers(); ++l) {
        const Ball s = place(element.s0, element.s1, rule.nodes[m]);
        const Ball t = place(element.t0, element.t1, rule.nodes[l]);
        const ParameterPoint<Ball> p = in.a + (s * (Ball(1) - t)) * in.along + t * in.inward;
        const Ball value = f(At{m, l, p.s, p.t}) * rule.weights[m] * rule.weights[l] / Ball(4);
        for (std::size_t i = 0; i < powers(); ++i)
          for (std::size_t j = 0; j < powers(); ++j)
            out[i * powers() + j] += Ball((2 * i + 1) * (2 * j + 1)) * p_[m][i] * p_[l][j] * value;
      }
    return out;
  }

  const PolyhedronCertificate& c_;
  int degree_;
  std::vector<BallPolynomial> emission_, reflectivity_;
  std::vector<std::vector<Frame>> frames_;
  std::vector<std::vector<Ball>> p_;
};

int whole_degree(const PolyhedronCertificate& c) {
  int degree = c.degree;
  for (const Face& face : c.faces)
    degree = std::max({degree, emission_degree(face), c.degree + reflectivity_degree(face)});
  return degree;
}

double above(double sum) { return sum * upward; }

}  // namespace

LegendreTable::LegendreTable(int degree, std::span<const BoundedDouble> places)
    : powers(static_cast<std::size_t>(degree) + 1) {
  values.reserve(places.size() * powers);
  const auto put = [&](const BoundedDouble& p) {
    values.push_back(p.value());
    error = larger_bound(error, p.error());
  };
  for (const BoundedDouble& x : places) {
    BoundedDouble last(1);
    BoundedDouble now = x;
    put(last);
    if (degree > 0) put(now);
    for (int i = 1; i < degree; ++i) {
      const BoundedDouble next =
          (BoundedDouble(2 * i + 1) * x * now - BoundedDouble(i) * last) / BoundedDouble(i + 1);
      last = now;
      now = next;
      put(now);
    }
  }
}

Densities::Densities(const PolyhedronCertificate& c)
    : degree_(whole_degree(c)),
      count_(c.functions()),
      stride_((count_ + Pack::lanes) / Pack::lanes * Pack::lanes),
      largest_(count_),
      vanishes_(count_, 1) {
  const ElementFunctions functions(c, degree_);
  const std::size_t size = powers() * powers();
  std::vector<std::vector<Ball>> first_coefficients;
  double largest = 0;
  for (std::size_t e = 0; e < c.elements.size(); ++e) {
    first_coefficients.push_back(functions.first(e));
    double sum = 0;
    for (const Ball& x : first_coefficients.back()) sum += abs(x).upper_double();
    largest = std::max(largest, sum);
  }
  exponents_.assign(count_, 0);
  if (largest > 0) std::frexp(largest, exponents_.data());
  // Functions of means are of the size of 1.
  for (std::size_t k = 1; c.of_values() && k < count_; ++k) {
    vanishes_[k] = 0;
    double most = 0;
    for (std::size_t e = 0; e < c.elements.size(); ++e) {
      double sum = 0;
      for (std::size_t i = 0; i < c.powers() * c.powers(); ++i)
        sum += std::abs(c.coefficient(k, e, i / c.powers(), i % c.powers()));
      most = std::max(most, sum);
    }
    if (most > 0) std::frexp(most, &exponents_[k]);
  }
  w_.resize(c.elements.size() * size * stride_);
  q_.resize(w_.size());
  for (std::size_t e = 0; e < c.elements.size(); ++e) {
    const Face& face = c.faces[c.elements[e].face];
    rho_.push_back(functions.largest_reflectivity(e));
    double* const w = w_.data() + e * size * stride_;
    double* const q = q_.data() + e * size * stride_;
    double off = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      double own_off = 0;
      const bool is_one = k > 0 && !c.of_values() && face.piece == k - 1;
      const Ball scale = power(Ball(2), -exponents_[k]);
      const std::vector<Ball> w_k = k == 0 ? first_coefficients[e] : functions.dual(e, k, is_one ? 1 : 0);
      for (std::size_t i = 0; i < powers(); ++i)
        for (std::size_t j = 0; j < powers(); ++j) {
          const bool has_q = i < c.powers() && j < c.powers();
          const Ball of_q(has_q ? c.coefficient(k, e, i, j) : 0.0);
          const Ball of_w = w_k[i * powers() + j] * scale;
          const BoundedDouble near_w = bounded(of_w);
          const BoundedDouble near_q = bounded(of_q * scale);
          w[(i * powers() + j) * stride_ + k] = near_w.value();
          q[(i * powers() + j) * stride_ + k] = near_q.value();
          own_off += near_w.error() + near_q.error();
          if (!certainly_zero(of_w) || !certainly_zero(of_q)) vanishes_[k] = 0;
        }
      off = std::max(off, own_off);
    }
    w[count_] = 1;
    error_.push_back(above(off));
    double all = 1;
    for (std::size_t k = 0; k < count_; ++k) {
      double of_w = 0;
      double of_q = 0;
      for (std::size_t i = 0; i < size; ++i) {
        of_w += std::abs(w[i * stride_ + k]);
        of_q += std::abs(q[i * stride_ + k]);
      }
      w_size_.push_back(above(of_w) + error_.back());
      q_size_.push_back(above(of_q) + error_.back());
      all = std::max({all, w_size_.back(), q_size_.back()});
      largest_[k] = std::max(largest_[k], w_size_.back());
      all_ = std::max(all_, w_size_.back());
    }
    sum_sizes_.push_back(all);
    for (std::size_t i = 0; i < size; ++i) {
      double most = i == 0 ? 1 : 0;
      for (std::size_t k = 0; k < count_; ++k) most = std::max(most, std::abs(w[i * stride_ + k]));
      largest_coefficients_.push_back(most + error_.back());
    }
  }
}

double Densities::error(std::size_t element, const LegendreTable& s, const LegendreTable& t) const {
  // Products of two table entries of size 1 at most, sums over both powers.
  const double relative = 1.01 * (s.error + t.error) + (4.0 * static_cast<double>(powers()) + 16) * 0x1p-53;
  return above(error_[element] + sum_sizes_[element] * relative);
}

void Densities::values(std::span<const double> f, std::size_t stride, const double* s, const double* t,
                       std::size_t powers, std::span<double> out) {
  for (std::size_t lane = 0; lane < stride; lane += Pack::lanes) {
    Pack sum(0.0);
    for (std::size_t i = 0; i < powers; ++i) {
      Pack inner(0.0);
      for (std::size_t j = 0; j < powers; ++j)
        inner = fma(Pack::load(f.data() + (i * powers + j) * stride + lane), Pack(t[j]), inner);
      sum = fma(inner, Pack(s[i]), sum);
    }
    sum.store(out.data() + lane);
  }
}

double Densities::size_of_w(std::size_t element) const {
  double most = 0;
  for (std::size_t k = 0; k < count_; ++k) most = std::max(most, size_of(element, k));
  return most;
}

double Densities::size(std::size_t element, double along, double across) const {
  const double* const c = largest_coefficients_.data() + element * powers() * powers();
  double sum = 0;
  for (std::size_t i = powers(); i-- > 0;) {
    double inner = 0;
    for (std::size_t j = powers(); j-- > 0;) inner = inner * across + c[i * powers() + j];
    sum = sum * along + inner;
  }
  return above(sum);
}

Densities::Slopes Densities::slopes(std::size_t element) const {
  // |P_i'| <= i (i+1)/2
  const double* const c = largest_coefficients_.data() + element * powers() * powers();
  Slopes out;
  for (std::size_t i = 0; i < powers(); ++i)
    for (std::size_t j = 0; j < powers(); ++j) {
      const auto x = static_cast<double>(i);
      const auto y = static_cast<double>(j);
      out.in_x += c[i * powers() + j] * x * (x + 1) / 2;
      out.in_y += c[i * powers() + j] * y * (y + 1) / 2;
    }
  out.in_x = above(out.in_x);
  out.in_y = above(out.in_y);
  return out;
}

std::vector<double> Densities::edge_sizes(std::size_t element) const {
  const std::span<const double> c = w(element);
  std::vector<double> out(powers());
  for (std::size_t k = 0; k < count_; ++k)
    for (std::size_t i = 0; i < powers(); ++i) {
      double sum = 0;
      double size = 0;
      for (std::size_t j = 0; j < powers(); ++j) {
        const double x = c[(i * powers() + j) * stride_ + k];
        sum += j % 2 == 0 ? x : -x;
        size += std::abs(x);
      }
      out[i] = std::max(out[i], above(std::abs(sum) + 64 * 0x1p-53 * size) + error_[element]);
    }
  return out;
}

std::vector<Ball> Densities::integrals(const PolyhedronCertificate& c) {
  const int degree = whole_degree(c);
  const ElementFunctions functions(c, degree);
  std::vector<Ball> out(c.pieces.size());
  for (std::size_t e = 0; e < c.elements.size(); ++e) {
    const Element& element = c.elements[e];
    const Face& face = c.faces[element.face];
    const std::vector<Ball> w = functions.first(e);
    // Int P_0(y) (1-t) and Int P_1(y) (1-t) over [-1,1], 1 - t = 1 - m - h y; P_i, i > 0, has the mean 0.
    const Ball t0(element.t0);
    const Ball t1(element.t1);
    const Ball h = (t1 - t0) / Ball(2);
    Ball sum = w[0] * Ball(2) * (Ball(1) - (t0 + t1) / Ball(2));
    if (degree > 0) sum -= w[1] * h * Ball(Rational(2, 3));
    const std::vector<Vector<Rational>>& p = face.corners;
    Vector<Rational> all;
    for (const Vector<Rational>& corner : p) all = all + corner;
    const Vector<Rational> centre = Rational(1, static_cast<long>(p.size())) * all;
    const Vector<Rational> turned =
        cross(p[(element.side + 1) % p.size()] - p[element.side], centre - p[element.side]);
    const Ball jacobian = sqrt(Ball(dot(turned, turned)));
    out[face.piece] += jacobian * (Ball(element.s1) - Ball(element.s0)) * h * sum;
  }
  return out;
}

Ball area_of(const Face& face) {
  Vector<Rational> sum;
  for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
    sum = sum + cross(face.corners[i] - face.corners[0], face.corners[i + 1] - face.corners[0]);
  return sqrt(Ball(dot(sum, sum))) / Ball(2);
}

std::vector<Ball> piece_areas(const PolyhedronCertificate& c) {
  std::vector<Ball> out(c.pieces.size());
  for (const Face& face : c.faces) out[face.piece] += area_of(face);
  return out;
}

}  // namespace radcert::certificate
