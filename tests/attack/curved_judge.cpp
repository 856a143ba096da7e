// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/attack/curved_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "radcert/scalar/ball_precision.h"

namespace radcert::attack {
namespace {

constexpr long digits = 128;         // bits of the values
constexpr long bound_digits = 64;    // bits of the bounds
constexpr double allowance = 1e-20;  // of the truncation on one side of one rectangle
constexpr std::size_t most_values = 20000;

template <class R>
using Triple = std::array<R, 3>;

template <class R>
R inner(const Triple<R>& a, const Triple<R>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class R>
Triple<R> outer(const Triple<R>& a, const Triple<R>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class R>
Triple<R> taken(const Triple<Ball>& a) {
  return {R(a[0]), R(a[1]), R(a[2])};
}
template <class R>
R squared(const R& x) {
  return x * x;
}

/// A function at P and at Q, and what lies between, divided by the step.
template <class R>
struct Pair {
  R p{};
  R q{};
  R d{};
  explicit Pair(const Ball& constant) : p(constant), q(constant) {}
  Pair(R at_p, R at_q, R between) : p(std::move(at_p)), q(std::move(at_q)), d(std::move(between)) {}
  friend Pair operator+(const Pair& a, const Pair& b) { return {a.p + b.p, a.q + b.q, a.d + b.d}; }
  friend Pair operator-(const Pair& a, const Pair& b) { return {a.p - b.p, a.q - b.q, a.d - b.d}; }
  friend Pair operator*(const Pair& a, const Pair& b) {
    return {a.p * b.p, a.q * b.q, a.d * b.q + a.p * b.d};
  }
  friend Pair sqrt(const Pair& a) {
    const R p = sqrt(a.p);
    const R q = sqrt(a.q);
    return {p, q, a.d / (p + q)};
  }
  friend Pair reciprocal(const Pair& a) {
    const R p = reciprocal(a.p);
    const R q = reciprocal(a.q);
    return {p, q, -(a.d * p * q)};
  }
};

/// The places of the coefficients of s^i t^j, i + j <= degree.
template <class Visit>
void each_power(int degree, const Visit& visit) {
  std::size_t place = 0;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) visit(place++, i, j);
}

bool is_quadric(JudgedPatch::Kind kind) {
  return kind != JudgedPatch::Kind::disk && kind != JudgedPatch::Kind::polynomial;
}

template <class T>
T arc_square(const JudgedPatch& f, const T& s, const T& t) {
  const T one{Ball(1)};
  const T two{Ball(2)};
  switch (f.kind) {
    case JudgedPatch::Kind::octant: return squared(one - s - t) + s * s + t * t;
    case JudgedPatch::Kind::mantle: return one - two * s * (one - s);
    default: return one - two * s * t;
  }
}

/// F(s,t) of all but polynomials.
template <class T>
Triple<T> image(const JudgedPatch& f, const T& s, const T& t) {
  using Kind = JudgedPatch::Kind;
  const auto constant = [](const Ball& x) { return T(x); };
  const T one = constant(1);
  const T w = arc_square(f, s, t);
  const T inverse = reciprocal(w);
  const T root = sqrt(inverse);
  const T x_sign = constant(f.sign[0]);
  const T y_sign = constant(f.sign[1]);
  switch (f.kind) {
    case Kind::octant:
      return {constant(f.size[0]) * (one - s - t) * root, constant(f.size[1]) * s * root,
              constant(f.size[2]) * t * root};
    case Kind::paraboloid: return {x_sign * s * root, y_sign * t * root, (one - squared(s + t)) * inverse};
    case Kind::cap: {
      const T fraction = constant(f.size[0]);
      const T height = fraction * (one - squared(s + t));
      const T across = constant(2) * T(sqrt(f.size[0])) * sqrt(w * (one - fraction) + height) * inverse;
      return {x_sign * s * across, y_sign * t * across,
              one - constant(2) * fraction + constant(2) * height * inverse};
    }
    case Kind::mantle: {
      const T radius = constant(f.size[0]) + constant(f.size[1]) * t;
      return {x_sign * radius * (one - s) * root, y_sign * radius * s * root, constant(f.size[2]) * t};
    }
    case Kind::disk:
    case Kind::polynomial: break;
  }
  return {x_sign * constant(f.size[0]) * s * root, y_sign * constant(f.size[0]) * t * root,
          constant(f.size[1])};
}

/// grad q, which points outwards.
template <class R>
Triple<R> gradient(const JudgedPatch& f, const Triple<R>& x) {
  using Kind = JudgedPatch::Kind;
  const auto constant = [](const Ball& c) { return R(c); };
  const R two = constant(2);
  switch (f.kind) {
    case Kind::octant:
      return {two * x[0] * constant(f.inverse[0]), two * x[1] * constant(f.inverse[1]),
              two * x[2] * constant(f.inverse[2])};
    case Kind::paraboloid: return {two * x[0], two * x[1], constant(1)};
    case Kind::cap: return {two * x[0], two * x[1], two * x[2]};
    default: {
      const R slope = constant(f.inverse[0]);
      return {two * x[0], two * x[1], -(two * slope * (constant(f.size[0]) + slope * x[2]))};
    }
  }
}

/// A(d).
template <class R>
R quadratic_part(const JudgedPatch& f, const Triple<R>& d) {
  using Kind = JudgedPatch::Kind;
  const auto constant = [](const Ball& c) { return R(c); };
  const R across = squared(d[0]) + squared(d[1]);
  switch (f.kind) {
    case Kind::octant:
      return squared(d[0]) * constant(f.inverse[0]) + squared(d[1]) * constant(f.inverse[1]) +
             squared(d[2]) * constant(f.inverse[2]);
    case Kind::paraboloid: return across;
    case Kind::cap: return across + squared(d[2]);
    default: return across - squared(constant(f.inverse[0]) * d[2]);
  }
}

/// m: |D_s F x D_t F| = m |grad q|.
template <class R>
R stretch(const JudgedPatch& f, const R& s, const R& t) {
  using Kind = JudgedPatch::Kind;
  const auto constant = [](const Ball& c) { return R(c); };
  const R inverse = reciprocal(arc_square(f, s, t));
  switch (f.kind) {
    case Kind::octant: return constant(abs(f.size[0] * f.size[1] * f.size[2]) / 2) * inverse * sqrt(inverse);
    case Kind::paraboloid: return inverse * inverse;
    case Kind::cap: return constant(2 * f.size[0]) * inverse * inverse;
    default: return constant(f.size[2] / 2) * inverse;
  }
}

template <class R>
std::vector<R> powers(const R& x, int degree) {
  std::vector<R> found{R(1)};
  for (int k = 1; k <= degree; ++k) found.push_back(found.back() * x);
  return found;
}

/// A point and the inner normal, not of unit length: times the area element.
template <class R>
struct Place {
  Triple<R> point;
  Triple<R> area_normal;
};

template <class R>
Place<R> place(const JudgedPatch& f, const R& s, const R& t) {
  using Kind = JudgedPatch::Kind;
  Place<R> found;
  if (f.kind == Kind::polynomial) {
    const std::vector<R> a = powers(s, f.degree);
    const std::vector<R> b = powers(t, f.degree);
    Triple<R> by_s;
    Triple<R> by_t;
    each_power(f.degree, [&](std::size_t k, int i, int j) {
      const auto m = static_cast<std::size_t>(i);
      const auto n = static_cast<std::size_t>(j);
      for (std::size_t c = 0; c < 3; ++c) {
        const R coefficient(f.coefficients[k][c]);
        found.point[c] += coefficient * a[m] * b[n];
        if (i > 0) by_s[c] += R(i) * coefficient * a[m - 1] * b[n];
        if (j > 0) by_t[c] += R(j) * coefficient * a[m] * b[n - 1];
      }
    });
    found.area_normal = f.against ? outer(by_t, by_s) : outer(by_s, by_t);
    return found;
  }
  found.point = image(f, s, t);
  if (f.kind == Kind::disk) {
    found.area_normal = {R(0), R(0),
                         R(f.facing * f.size[0] * f.size[0]) * squared(reciprocal(arc_square(f, s, t)))};
    return found;
  }
  const R m = stretch(f, s, t);
  const Triple<R> outwards = gradient(f, found.point);
  found.area_normal = {-(m * outwards[0]), -(m * outwards[1]), -(m * outwards[2])};
  return found;
}

/// The same quadric: none of the surfaces has two of one kind.
bool same_quadric(const JudgedPatch& a, const JudgedPatch& b) {
  return a.kind == b.kind && is_quadric(a.kind);
}

/// A Gauss rule on [-1, 1] in balls.
struct BallRule {
  std::vector<Ball> nodes;
  std::vector<Ball> weights;

  explicit BallRule(int n) {
    const BallPrecision precision(256);
    // P_n and (1 - z^2) P_n'.
    const auto legendre = [n](const Ball& z) {
      Ball p(1);
      Ball before(0);
      for (int k = 1; k <= n; ++k) {
        Ball next = (Ball(2 * k - 1) * z * p - Ball(k - 1) * before) / Ball(k);
        before = std::exchange(p, std::move(next));
      }
      return std::pair(p, Ball(n) * (before - z * p));
    };
    const Ball reach = power(Ball(2), -180);
    std::vector<Ball> isolated;
    for (int i = 0; i < n; ++i) {
      Ball z(std::cos(3.14159265358979 * (i + 0.75) / (n + 0.5)));
      for (int step = 0; step < 9; ++step) {
        const auto [p, slope] = legendre(z);
        z = (z - p * (1 - z * z) / slope).midpoint();
      }
      const Ball below = legendre(z - reach).first;
      const Ball above = legendre(z + reach).first;
      Ball node =
          certainly_negative(below * above) ? widened(z, reach) : Ball::failed("no zero of Legendre's");
      // n disjoint intervals, a zero in each: these are all of them.
      for (const Ball& other : nodes)
        if (overlaps(node, other)) node = Ball::failed("a zero of Legendre's twice");
      const Ball slope = legendre(node).second;
      weights.push_back(2 * (1 - node * node) / (slope * slope));
      nodes.push_back(node);
    }
  }
};

constexpr std::array<int, 9> orders{4, 6, 8, 11, 14, 18, 22, 27, 32};

const BallRule& rule_of(std::size_t place) {
  static const std::vector<BallRule> rules(orders.begin(), orders.end());
  return rules[place];
}

struct Square {
  double x_low = 0;
  double x_high = 1;
  double y_low = 0;
  double y_high = 1;
};

/// A point of the plane of parameters.
template <class R>
using Parameters = std::array<R, 2>;

class Integration {
public:
  Integration(const std::vector<JudgedPatch>& patches, const SurfacePoint<Rational>& p,
              const ParameterTriangle& element, const std::vector<ElementPolynomial>& functions)
      : of_p_(patches[p.chart]), of_q_(patches[element.chart]), sums_(functions.size()) {
    for (std::size_t i = 0; i < 3; ++i)
      corners_[i] = {Rational::exactly(element.vertices[i].s), Rational::exactly(element.vertices[i].t)};
    at_ = {p.at.s, p.at.t};
    for (const ElementPolynomial& f : functions) {
      functions_.emplace_back();
      for (const ElementPolynomial::Term& term : f.terms)
        functions_.back().push_back({Ball(term.coefficient), term.first, term.second});
    }
    p_parameters_ = {Ball(at_[0]), Ball(at_[1])};
    p_ = place(of_p_, p_parameters_[0], p_parameters_[1]);
    const Ball length = sqrt(inner(p_.area_normal, p_.area_normal));
    for (Ball& c : p_.area_normal) c /= length;
    same_quadric_ = same_quadric(of_p_, of_q_);
    if (same_quadric_) {
      const Triple<Ball> g = gradient(of_p_, p_.point);
      inverse_slope_ = reciprocal(sqrt(inner(g, g)));
    }
    own_ = p.chart == element.chart && contains();
    if (own_ && of_q_.kind == JudgedPatch::Kind::polynomial) expand();
  }

  std::optional<std::vector<Ball>> integrals() {
    if (in_one_plane()) return std::move(sums_);
    if (own_) {
      for (std::size_t i = 0; i < 3; ++i)
        if (!over({at_, corners_[i], corners_[(i + 1) % 3]})) return std::nullopt;
    } else {
      std::size_t nearest = 0;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < 3; ++i) {
        const Triple<Ball> q = place(of_q_, Ball(corners_[i][0]), Ball(corners_[i][1])).point;
        const Triple<Ball> d{q[0] - p_.point[0], q[1] - p_.point[1], q[2] - p_.point[2]};
        const double distance = inner(d, d).to_double();
        if (distance < least) nearest = i;
        least = std::min(least, distance);
      }
      if (!over({corners_[nearest], corners_[(nearest + 1) % 3], corners_[(nearest + 2) % 3]}))
        return std::nullopt;
    }
    return std::move(sums_);
  }

private:
  struct Term {
    Ball coefficient;
    int first;
    int second;
  };

  static Rational area(const Parameters<Rational>& a, const Parameters<Rational>& b,
                       const Parameters<Rational>& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  bool contains() const {
    const Rational whole = area(corners_[0], corners_[1], corners_[2]);
    for (std::size_t i = 0; i < 3; ++i)
      if (area(at_, corners_[i], corners_[(i + 1) % 3]) * whole < Rational(0)) return false;
    return true;
  }

  bool in_one_plane() const {
    using Kind = JudgedPatch::Kind;
    if (of_p_.kind == Kind::disk && of_q_.kind == Kind::disk) return of_p_.facing == of_q_.facing;
    return &of_p_ == &of_q_ && of_q_.kind == Kind::polynomial && of_q_.degree == 1;
  }

  /// Taylor's coefficients at P, by the power of the step.
  void expand() {
    const auto choose = [](int n, int k) {
      Rational found = 1;
      for (int i = 1; i <= k; ++i) found = found * Rational(n - k + i) / Rational(i);
      return found;
    };
    const auto to_the = [](const Rational& x, int n) {
      Rational found = 1;
      for (int i = 0; i < n; ++i) found *= x;
      return found;
    };
    expansion_.assign(of_q_.coefficients.size(), {});
    each_power(of_q_.degree, [&](std::size_t k, int i, int j) {
      each_power(of_q_.degree, [&](std::size_t low, int m, int n) {
        if (m > i || n > j) return;
        const Ball factor(choose(i, m) * choose(j, n) * to_the(at_[0], i - m) * to_the(at_[1], j - n));
        for (std::size_t c = 0; c < 3; ++c) expansion_[low][c] += factor * of_q_.coefficients[k][c];
      });
    });
  }

  struct Ray {
    Parameters<Ball> apex;
    Parameters<Ball> first;
    Parameters<Ball> along;
    Ball determinant;
    std::array<Triple<Ball>, 2> coordinates;  ///< x_1 and x_2 at the apex, along first, along along
  };

  /// G times the Jacobian, and x_1, x_2.
  template <class R>
  Triple<R> kernel(const Ray& ray, const R& x, const R& y) const {
    const auto constant = [](const Ball& c) { return R(c); };
    const R towards_s = constant(ray.first[0]) + y * constant(ray.along[0]);
    const R towards_t = constant(ray.first[1]) + y * constant(ray.along[1]);
    const R s = constant(ray.apex[0]) + x * towards_s;
    const R t = constant(ray.apex[1]) + x * towards_t;
    Triple<R> found;
    found[0] = x * constant(ray.determinant) * kernel_at(s, t, towards_s, towards_t, x);
    for (std::size_t i = 0; i < 2; ++i)
      found[i + 1] = constant(ray.coordinates[i][0]) +
                     x * (constant(ray.coordinates[i][1]) + y * constant(ray.coordinates[i][2]));
    return found;
  }

  template <class R>
  R kernel_at(const R& s, const R& t, const R& towards_s, const R& towards_t, const R& x) const {
    if (same_quadric_) {
      Triple<R> d;
      if (own_) {
        const Triple<Pair<R>> f = image(of_q_, Pair<R>(R(p_parameters_[0]), s, towards_s),
                                        Pair<R>(R(p_parameters_[1]), t, towards_t));
        d = {f[0].d, f[1].d, f[2].d};
      } else {
        const Triple<R> q = image(of_q_, s, t);
        for (std::size_t c = 0; c < 3; ++c) d[c] = q[c] - R(p_.point[c]);
      }
      return stretch(of_q_, s, t) * squared(quadratic_part(of_q_, d) / inner(d, d)) * R(inverse_slope_);
    }
    const Place<R> q = place(of_q_, s, t);
    if (own_) {
      // Q - P = sum_k x^k h_k, and x times the derivative along the ray, which the normal at Q is
      // perpendicular to, is sum_k k x^k h_k.
      std::vector<Triple<R>> h(static_cast<std::size_t>(of_q_.degree + 1));
      const std::vector<R> a = powers(towards_s, of_q_.degree);
      const std::vector<R> b = powers(towards_t, of_q_.degree);
      each_power(of_q_.degree, [&](std::size_t k, int i, int j) {
        const R monomial = a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
        for (std::size_t c = 0; c < 3; ++c)
          h[static_cast<std::size_t>(i + j)][c] += monomial * R(expansion_[k][c]);
      });
      Triple<R> d;
      R at_p(0);
      R at_q(0);
      R power_of_x(1);
      const Triple<R> normal = taken<R>(p_.area_normal);
      for (std::size_t k = 1; k < h.size(); ++k) {
        if (k >= 2) {
          // power_of_x is x^(k-2) here, and x^(k-1) below.
          at_p += power_of_x * inner(h[k], normal);
          at_q += R(static_cast<int>(k) - 1) * power_of_x * inner(h[k], q.area_normal);
          power_of_x *= x;
        }
        for (std::size_t c = 0; c < 3; ++c) d[c] += power_of_x * h[k][c];
      }
      return at_p * at_q / squared(inner(d, d));
    }
    const Triple<R> p = taken<R>(p_.point);
    const Triple<R> d{q.point[0] - p[0], q.point[1] - p[1], q.point[2] - p[2]};
    return -(inner(d, taken<R>(p_.area_normal)) * inner(d, q.area_normal)) / squared(inner(d, d));
  }

  template <class R>
  R function(std::size_t j, const Triple<R>& at) const {
    R sum(0);
    for (const Term& term : functions_[j])
      sum += R(term.coefficient) * power(at[1], term.first) * power(at[2], term.second);
    return sum;
  }

  struct Order {
    std::size_t place = orders.size();
    double error = 0;
  };

  /// The lowest order for one side of a rectangle.
  Order order_for(const Ray& ray, const Square& square, bool in_x) {
    const BallPrecision precision(bound_digits);
    Order best;
    for (const double rho : {1.5, 2.0, 3.0, 4.0, 6.0, 10.0, 20.0}) {
      const auto side = [rho](double low, double high, bool complex) {
        const Ball half = Ball(high - low) / 2;
        const Ball centre = Ball(low) + half;
        if (!complex) return ComplexBall(widened(centre, half));
        const Ball r(rho);
        return ComplexBall(widened(centre, half * (r + reciprocal(r)) / 2),
                           widened(Ball(0), half * (r - reciprocal(r)) / 2));
      };
      const Triple<ComplexBall> f =
          kernel(ray, side(square.x_low, square.x_high, in_x), side(square.y_low, square.y_high, !in_x));
      ++values_;
      if (!f[0].is_finite()) break;
      double largest = 0;
      for (std::size_t j = 0; j < functions_.size(); ++j)
        largest = std::max(largest, (f[0] * function(j, f)).magnitude_bound());
      const Ball r(rho);
      const Ball area = Ball(square.x_high - square.x_low) * Ball(square.y_high - square.y_low) / 2;
      for (std::size_t m = 0; m < best.place; ++m) {
        const Ball error =
            Ball(Rational(64, 15)) * Ball(largest) * area * power(r, -2 * orders[m]) / (1 - power(r, -2));
        if (error.upper_double() <= allowance) best = {m, error.upper_double()};
      }
    }
    return best;
  }

  bool over(const std::array<Parameters<Rational>, 3>& triangle) {
    const Rational determinant = area(triangle[0], triangle[1], triangle[2]);
    if (determinant == Rational(0)) return true;
    Ray ray;
    ray.determinant = Ball(abs(determinant));
    for (std::size_t i = 0; i < 2; ++i) {
      ray.apex[i] = Ball(triangle[0][i]);
      ray.first[i] = Ball(triangle[1][i] - triangle[0][i]);
      ray.along[i] = Ball(triangle[2][i] - triangle[1][i]);
    }
    const Rational whole = area(corners_[0], corners_[1], corners_[2]);
    for (std::size_t i = 0; i < 2; ++i) {
      std::array<Rational, 3> at;
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = area(corners_[(i + 1) % 3], corners_[(i + 2) % 3], triangle[k]) / whole;
      ray.coordinates[i] = {Ball(at[0]), Ball(at[1] - at[0]), Ball(at[2] - at[1])};
    }
    return over(ray, {}, 0);
  }

  bool over(const Ray& ray, const Square& square, int depth) {
    if (values_ > most_values || depth > 60) return false;
    const Order x = order_for(ray, square, true);
    const Order y = order_for(ray, square, false);
    if (x.place < orders.size() && y.place < orders.size()) {
      add(ray, square, x, y);
      return true;
    }
    Square low = square;
    Square high = square;
    const bool taller = square.y_high - square.y_low >= square.x_high - square.x_low;
    if (y.place == orders.size() && (x.place < orders.size() || taller)) {
      low.y_high = high.y_low = (square.y_low + square.y_high) / 2;
    } else {
      low.x_high = high.x_low = (square.x_low + square.x_high) / 2;
    }
    return over(ray, low, depth + 1) && over(ray, high, depth + 1);
  }

  void add(const Ray& ray, const Square& square, const Order& in_x, const Order& in_y) {
    const BallRule& rule_x = rule_of(in_x.place);
    const BallRule& rule_y = rule_of(in_y.place);
    const Ball half_x = Ball(square.x_high - square.x_low) / 2;
    const Ball half_y = Ball(square.y_high - square.y_low) / 2;
    for (std::size_t a = 0; a < rule_x.nodes.size(); ++a)
      for (std::size_t b = 0; b < rule_y.nodes.size(); ++b) {
        const Triple<Ball> f = kernel(ray, Ball(square.x_low) + half_x * (1 + rule_x.nodes[a]),
                                      Ball(square.y_low) + half_y * (1 + rule_y.nodes[b]));
        const Ball weighted = half_x * half_y * rule_x.weights[a] * rule_y.weights[b] * f[0];
        for (std::size_t j = 0; j < sums_.size(); ++j) sums_[j] += weighted * function(j, f);
      }
    values_ += rule_x.nodes.size() * rule_y.nodes.size();
    // The rule in y at the nodes of x has positive weights: the two parts add up.
    const Ball error = Ball(in_x.error) + Ball(in_y.error);
    for (Ball& sum : sums_) sum = widened(sum, error);
  }

  const JudgedPatch& of_p_;
  const JudgedPatch& of_q_;
  std::array<Parameters<Rational>, 3> corners_;
  Parameters<Rational> at_;
  Parameters<Ball> p_parameters_;
  std::vector<std::vector<Term>> functions_;
  std::vector<Ball> sums_;
  Place<Ball> p_;  ///< the normal of unit length
  Ball inverse_slope_;
  bool same_quadric_ = false;
  bool own_ = false;
  std::vector<Triple<Ball>> expansion_;
  std::size_t values_ = 0;
};

/// The coefficients of the polynomials that are 1 at one of the points and 0 at the others: a row a point.
std::vector<std::vector<Rational>> lagrange_coefficients(const std::vector<std::array<Rational, 2>>& points,
                                                         int degree) {
  const std::size_t n = points.size();
  // The columns of the right half will be those of the inverse of the left one, (s^i t^j at point k).
  std::vector<std::vector<Rational>> rows(n, std::vector<Rational>(2 * n));
  for (std::size_t k = 0; k < n; ++k) {
    const std::vector<Rational> a = powers(points[k][0], degree);
    const std::vector<Rational> b = powers(points[k][1], degree);
    each_power(degree, [&](std::size_t column, int i, int j) {
      rows[k][column] = a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
    });
    rows[k][n + k] = 1;
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (rows[pivot][k] == Rational(0)) ++pivot;
    std::swap(rows[k], rows[pivot]);
    const Rational divisor = rows[k][k];
    for (Rational& entry : rows[k]) entry = entry / divisor;
    for (std::size_t i = 0; i < n; ++i) {
      const Rational factor = rows[i][k];
      if (i == k || factor == Rational(0)) continue;
      for (std::size_t j = 0; j < 2 * n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<std::vector<Rational>> found(n, std::vector<Rational>(n));
  for (std::size_t point = 0; point < n; ++point)
    for (std::size_t power = 0; power < n; ++power) found[point][power] = rows[power][n + point];
  return found;
}

/// The polynomial of the given degree that has the chart's values on the lattice a/r, b/r.
JudgedPatch polynomial_patch(const Chart& chart, int degree) {
  JudgedPatch found{.kind = JudgedPatch::Kind::polynomial,
                    .degree = degree,
                    .against = chart.facts().orientation == Orientation::against_the_cross_product,
                    .coefficients = {}};
  std::vector<std::array<Rational, 2>> lattice;
  each_power(degree, [&](std::size_t, int a, int b) {
    lattice.push_back({Rational(a, degree), Rational(b, degree)});
  });
  found.coefficients.resize(lattice.size());
  const std::vector<std::vector<Rational>> lagrange = lagrange_coefficients(lattice, degree);
  for (std::size_t k = 0; k < lattice.size(); ++k) {
    const Vector<Ball> f = chart.in<Ball>().frame({Ball(lattice[k][0]), Ball(lattice[k][1])}).point;
    for (std::size_t m = 0; m < lattice.size(); ++m) {
      const Ball factor(lagrange[k][m]);
      found.coefficients[m][0] += factor * f.x;
      found.coefficients[m][1] += factor * f.y;
      found.coefficients[m][2] += factor * f.z;
    }
  }
  return found;
}

constexpr std::array<std::array<int, 2>, 4> quadrants{{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

void add_disks(std::vector<JudgedPatch>& found, const Rational& radius, const Rational& height, int facing) {
  for (const auto& sign : quadrants)
    found.push_back({.kind = JudgedPatch::Kind::disk,
                     .size = {Ball(radius), Ball(height), 0},
                     .sign = sign,
                     .facing = facing,
                     .coefficients = {}});
}

}  // namespace

std::vector<ElementPolynomial> judged_lagrange(const std::vector<std::array<Rational, 2>>& points,
                                               int degree) {
  std::vector<ElementPolynomial> found;
  for (const std::vector<Rational>& coefficients : lagrange_coefficients(points, degree)) {
    found.emplace_back();
    each_power(degree, [&](std::size_t k, int i, int j) {
      found.back().terms.push_back({coefficients[k], i, j});
    });
  }
  return found;
}

std::vector<JudgedPatch> judged_patches(const Surface& surface, int interpolated) {
  const BallPrecision precision(digits);
  const auto parameter = [&surface](std::string_view name) {
    for (const auto& each : surface.parameters)
      if (each.name == name) return each.value;
    return Rational(0);
  };
  using Kind = JudgedPatch::Kind;
  std::vector<JudgedPatch> found;
  const auto add_quadrants = [&found](Kind kind, const std::array<Rational, 3>& size, const Rational& slope) {
    for (const auto& sign : quadrants)
      found.push_back({.kind = kind,
                       .size = {Ball(size[0]), Ball(size[1]), Ball(size[2])},
                       .inverse = {Ball(slope), 0, 0},
                       .sign = sign,
                       .coefficients = {}});
  };
  if (interpolated > 0) {
    for (const Chart& chart : surface.charts)
      found.push_back(polynomial_patch(chart, chart.facts().plane ? 1 : interpolated));
  } else if (surface.name == "two_piece") {
    found.push_back(polynomial_patch(surface.charts[0], 1));
    found.push_back(polynomial_patch(surface.charts[1], static_cast<int>(parameter("p").to_long().value())));
  } else if (surface.name == "sphere" || surface.name == "ellipsoid") {
    const bool sphere = surface.name == "sphere";
    std::array<Rational, 3> axes{1, 1, 1};
    if (!sphere) axes = {parameter("a"), parameter("b"), parameter("c")};
    std::array<Ball, 3> inverse;
    for (std::size_t i = 0; i < 3; ++i) inverse[i] = Ball(1 / (axes[i] * axes[i]));
    for (const int z : {1, -1})
      for (const int y : {1, -1})
        for (const int x : {1, -1})
          found.push_back({.kind = Kind::octant,
                           .size = {Ball(x * axes[0]), Ball(y * axes[1]), Ball(z * axes[2])},
                           .inverse = inverse,
                           .coefficients = {}});
  } else if (surface.name == "paraboloid_cap") {
    add_disks(found, 1, 0, 1);
    add_quadrants(Kind::paraboloid, {}, 0);
  } else if (surface.name == "spherical_cap") {
    add_quadrants(Kind::cap, {parameter("fraction"), 0, 0}, 0);
  } else if (surface.name == "cylinder" || surface.name == "cone") {
    const Rational radius = parameter("radius");
    const Rational top = surface.name == "cone" ? parameter("top") : radius;
    add_disks(found, radius, 0, 1);
    add_disks(found, top, parameter("height"), -1);
    add_quadrants(Kind::mantle, {radius, top - radius, parameter("height")},
                  (top - radius) / parameter("height"));
  }
  return found;
}

std::optional<std::vector<Ball>> judged_integrals(const std::vector<JudgedPatch>& patches,
                                                  const SurfacePoint<Rational>& p,
                                                  const ParameterTriangle& element,
                                                  const std::vector<ElementPolynomial>& functions) {
  const BallPrecision precision(digits);
  return Integration(patches, p, element, functions).integrals();
}

}  // namespace radcert::attack
