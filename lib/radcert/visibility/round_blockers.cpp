// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/visibility/round_blockers.h"

#include <cmath>

#include "radcert/core/contract.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/scalar/rational.h"
#include "radcert/visibility/scene.h"

namespace radcert {
namespace {

bool fits(double x) { return std::abs(x) <= Scene::largest_coordinate; }
bool fits(const Vector<double>& v) { return fits(v.x) && fits(v.y) && fits(v.z); }

/// A sign, where the arithmetic decides it.
struct Sign {
  int value = 0;
  bool certain = false;
};

// BoundedDouble does not count underflow. With numbers of at most 2^100 each expression below is of degree 6
// in differences of at most 2^101; what underflow takes from a product, 2^-1074, is multiplied by at most
// four of them and added a dozen times.
constexpr double far_from_underflow = 0x1p-600;

Sign sign_of(const BoundedDouble& x) {
  if (!std::isfinite(x.value()) || !(x.smallest_size() > far_from_underflow)) return {};
  return {x.value() > 0 ? 1 : -1, true};
}
Sign sign_of(const Rational& x) { return {x.sign(), true}; }

BoundedDouble number(double x, const BoundedDouble& /*arithmetic*/) { return BoundedDouble::exactly(x); }
Rational number(double x, const Rational& /*arithmetic*/) { return Rational::exactly(x); }

/// Three coordinates of an arithmetic that need not be a Field.
template <class R>
struct Triple {
  R x;
  R y;
  R z;
  friend Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend R operator*(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
};

template <class R>
Triple<R> scaled(const R& c, const Triple<R>& a) {
  return {c * a.x, c * a.y, c * a.z};
}

template <class R>
Triple<R> in(const Vector<double>& v) {
  return {number(v.x, R()), number(v.y, R()), number(v.z, R())};
}

/// What is asked of X = P + t (Q - P), with e = P - centre, d = Q - P, f(t) = |X - centre|^2 - radius^2.
template <class R>
class AlongSegment {
public:
  AlongSegment(const Vector<double>& centre, double radius, const Vector<double>& p, const Vector<double>& q)
      : e_(in<R>(p) - in<R>(centre)), d_(in<R>(q) - in<R>(p)), square_(number(radius, R())) {
    square_ = square_ * square_;
  }
  [[nodiscard]] Sign at_start() const { return sign_of(e_ * e_ - square_); }
  [[nodiscard]] Sign at_end() const {
    const Triple<R> end = e_ + d_;
    return sign_of(end * end - square_);
  }
  /// Of t and of 1 - t at the least value.
  [[nodiscard]] Sign after_start() const { return sign_of(-(e_ * d_)); }
  [[nodiscard]] Sign before_end() const { return sign_of((e_ + d_) * d_); }
  /// Of the least value on the whole line, for d != 0.
  [[nodiscard]] Sign least() const {
    const R along = e_ * d_;
    return sign_of((e_ * e_ - square_) * (d_ * d_) - along * along);
  }

private:
  Triple<R> e_;
  Triple<R> d_;
  R square_;
};

/// The answer, if this arithmetic decides it; `rim` is whether f = 0 counts.
template <class R>
Sign enters(const Vector<double>& centre, double radius, const Vector<double>& p, const Vector<double>& q,
            bool rim) {
  const AlongSegment<R> f(centre, radius, p, q);
  const Sign start = f.at_start();
  const Sign end = f.at_end();
  if ((start.certain && start.value < 0) || (end.certain && end.value < 0)) return {1, true};
  if (!start.certain || !end.certain) return {};
  const Sign after = f.after_start();
  const Sign before = f.before_end();
  if ((after.certain && after.value <= 0) || (before.certain && before.value <= 0)) return {0, true};
  if (!after.certain || !before.certain) return {};
  const Sign least = f.least();
  if (!least.certain) return {};
  return {least.value < 0 || (rim && least.value == 0) ? 1 : 0, true};
}

bool segment_enters(const Vector<double>& centre, double radius, const Vector<double>& p,
                    const Vector<double>& q, bool rim) {
  const Sign quick = enters<BoundedDouble>(centre, radius, p, q, rim);
  return (quick.certain ? quick : enters<Rational>(centre, radius, p, q, rim)).value != 0;
}

/// For the disk: on which sides of its plane the ends lie, and whether the point between them lies on it.
template <class R>
class ThroughPlane {
public:
  ThroughPlane(const DiskBlocker& disk, const Vector<double>& p, const Vector<double>& q)
      : e_(in<R>(p) - in<R>(disk.centre)),
        g_(in<R>(q) - in<R>(disk.centre)),
        height_p_(in<R>(disk.normal) * e_),
        height_q_(in<R>(disk.normal) * g_),
        radius_(number(disk.radius, R())) {}
  [[nodiscard]] Sign side_of_p() const { return sign_of(height_p_); }
  [[nodiscard]] Sign side_of_q() const { return sign_of(height_q_); }
  /// Of |X - centre|^2 - radius^2 where the segment passes the plane: X - centre = (h_p g - h_q e) / (h_p -
  /// h_q).
  [[nodiscard]] Sign beyond_rim() const {
    const Triple<R> x = scaled(height_p_, g_) - scaled(height_q_, e_);
    const R length = radius_ * (height_p_ - height_q_);
    return sign_of(x * x - length * length);
  }

private:
  Triple<R> e_;
  Triple<R> g_;
  R height_p_;
  R height_q_;
  R radius_;
};

template <class R>
Sign passes(const DiskBlocker& disk, const Vector<double>& p, const Vector<double>& q) {
  const ThroughPlane<R> plane(disk, p, q);
  const Sign at_p = plane.side_of_p();
  const Sign at_q = plane.side_of_q();
  if (!at_p.certain || !at_q.certain) return {};
  if (at_p.value == 0 && at_q.value == 0)
    return {segment_enters(disk.centre, disk.radius, p, q, true) ? 1 : 0, true};
  if (at_p.value * at_q.value >= 0) return {0, true};
  const Sign beyond = plane.beyond_rim();
  return {beyond.value <= 0 ? 1 : 0, beyond.certain};
}

}  // namespace

bool hides(const BallBlocker& ball, const Vector<double>& p, const Vector<double>& q) {
  expects(fits(ball.centre) && fits(p) && fits(q), "coordinates of at most 2^100");
  expects(ball.radius >= 0 && fits(ball.radius), "a radius between 0 and 2^100",
          named("radius", ball.radius));
  return segment_enters(ball.centre, ball.radius, p, q, false);
}

bool hides(const DiskBlocker& disk, const Vector<double>& p, const Vector<double>& q) {
  expects(fits(disk.centre) && fits(disk.normal) && fits(p) && fits(q), "coordinates of at most 2^100");
  expects(disk.radius >= 0 && fits(disk.radius), "a radius between 0 and 2^100",
          named("radius", disk.radius));
  expects(!(disk.normal == Vector<double>{0, 0, 0}), "a normal that is not zero");
  if (p == q) return false;
  const Sign quick = passes<BoundedDouble>(disk, p, q);
  return (quick.certain ? quick : passes<Rational>(disk, p, q)).value != 0;
}

}  // namespace radcert
