// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "radcert/scalar/real.h"

namespace radcert {

/// Eight doubles that go through a formula side by side.
/// Maths     every operation lane by lane
/// Result    each lane has the bits that the same formula gives in double, on every machine: + - * / sqrt fma
///           abs min max are those of IEEE 754, the other functions go through libm one lane at a time
/// Limits    a formula that branches on values cannot run in it; `by_lane` takes such a step. Eight whatever
///           the machine: two registers of AVX2, four of SSE2. std::experimental::simd would serve but for
///           its fma, which GCC 12 takes lane by lane in a library call
class Pack {
public:
  static constexpr std::size_t lanes = 8;

  Pack() = default;
  Pack(double x) : low_(x - Half{}), high_(x - Half{}) {}  // NOLINT(google-explicit-constructor): a constant
  static Pack load(const double* from) {
    Pack p;
    std::memcpy(&p.low_, from, sizeof(Half));
    std::memcpy(&p.high_, from + half, sizeof(Half));
    return p;
  }
  void store(double* to) const {
    std::memcpy(to, &low_, sizeof(Half));
    std::memcpy(to + half, &high_, sizeof(Half));
  }

  double lane(std::size_t i) const { return i < half ? low_[i] : high_[i - half]; }
  void set_lane(std::size_t i, double x) {
    // Clang assigns to no lane that a conditional expression gives.
    if (i < half)
      low_[i] = x;
    else
      high_[i - half] = x;
  }

  Pack operator-() const { return {-low_, -high_}; }
  friend Pack operator+(const Pack& a, const Pack& b) { return {a.low_ + b.low_, a.high_ + b.high_}; }
  friend Pack operator-(const Pack& a, const Pack& b) { return {a.low_ - b.low_, a.high_ - b.high_}; }
  friend Pack operator*(const Pack& a, const Pack& b) { return {a.low_ * b.low_, a.high_ * b.high_}; }
  friend Pack operator/(const Pack& a, const Pack& b) { return {a.low_ / b.low_, a.high_ / b.high_}; }
  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator-=(const Pack& b) { return *this = *this - b; }
  Pack& operator*=(const Pack& b) { return *this = *this * b; }

  /// Whether all lanes are equal.
  friend bool operator==(const Pack& a, const Pack& b) {
    bool equal = true;
    for (std::size_t i = 0; i < lanes; ++i) equal = equal && a.lane(i) == b.lane(i);
    return equal;
  }

  /// a b + c with one rounding.
  friend Pack fma(const Pack& a, const Pack& b, const Pack& c) {
    return {fused(a.low_, b.low_, c.low_), fused(a.high_, b.high_, c.high_)};
  }
  friend Pack sqrt(const Pack& a) { return {root(a.low_), root(a.high_)}; }
  friend Pack abs(const Pack& a) { return {magnitude(a.low_), magnitude(a.high_)}; }
  /// As std::min and std::max: the first where neither is smaller.
  friend Pack min(const Pack& a, const Pack& b) {
    return {b.low_ < a.low_ ? b.low_ : a.low_, b.high_ < a.high_ ? b.high_ : a.high_};
  }
  friend Pack max(const Pack& a, const Pack& b) {
    return {a.low_ < b.low_ ? b.low_ : a.low_, a.high_ < b.high_ ? b.high_ : a.high_};
  }

  /// The sum of the lanes, in a fixed tree.
  double sum() const {
    const Half s = low_ + high_;
    return (s[0] + s[2]) + (s[1] + s[3]);
  }
  double largest() const {
    return extreme([](double a, double b) { return a < b; });
  }
  double smallest() const {
    return extreme([](double a, double b) { return b < a; });
  }

private:
  static constexpr std::size_t half = 4;
  typedef double Half __attribute__((vector_size(half * sizeof(double))));  // NOLINT(modernize-use-using)
  typedef std::int64_t Bits
      __attribute__((vector_size(half * sizeof(double))));  // NOLINT(modernize-use-using)

  Pack(const Half& low, const Half& high) : low_(low), high_(high) {}

  static Half fused(const Half& a, const Half& b, const Half& c) {
#if defined(__FMA__) && defined(__GNUC__) && !defined(__clang__)
    return __builtin_ia32_vfmaddpd256(a, b, c);  // lane by lane some loops would be taken apart
#else
    Half r;
    for (std::size_t i = 0; i < half; ++i) r[i] = __builtin_fma(a[i], b[i], c[i]);
    return r;
#endif
  }
  static Half root(const Half& a) {
#if defined(__AVX__) && defined(__GNUC__) && !defined(__clang__)
    return __builtin_ia32_sqrtpd256(a);  // std::sqrt lane by lane would look at errno
#else
    Half r;
    for (std::size_t i = 0; i < half; ++i) r[i] = std::sqrt(a[i]);
    return r;
#endif
  }
  static Half magnitude(const Half& a) {
    Bits bits;
    std::memcpy(&bits, &a, sizeof(Half));
    bits &= 0x7fffffffffffffff;
    Half r;
    std::memcpy(&r, &bits, sizeof(Half));
    return r;
  }
  template <class Less>
  double extreme(const Less& less) const {
    double found = lane(0);
    for (std::size_t i = 1; i < lanes; ++i) found = less(found, lane(i)) ? lane(i) : found;
    return found;
  }

  Half low_;
  Half high_;
};

/// A function of doubles, lane by lane: for what has no form that all lanes share.
template <class Function, class... Packs>
Pack by_lane(const Function& f, const Packs&... packs) {
  Pack result;
  for (std::size_t i = 0; i < Pack::lanes; ++i) result.set_lane(i, f(packs.lane(i)...));
  return result;
}

/// The elementary functions, lane by lane as the C library has them.
// clang-format off
inline Pack exp(const Pack& a) { return by_lane([](double x) { return std::exp(x); }, a); }
inline Pack log(const Pack& a) { return by_lane([](double x) { return std::log(x); }, a); }
inline Pack sin(const Pack& a) { return by_lane([](double x) { return std::sin(x); }, a); }
inline Pack cos(const Pack& a) { return by_lane([](double x) { return std::cos(x); }, a); }
inline Pack tan(const Pack& a) { return by_lane([](double x) { return std::tan(x); }, a); }
inline Pack atan(const Pack& a) { return by_lane([](double x) { return std::atan(x); }, a); }
inline Pack pow(const Pack& a, const Pack& b) {
  return by_lane([](double x, double y) { return std::pow(x, y); }, a, b); }
// clang-format on

/// In each lane `if_less` where a < b, else `otherwise`.
inline Pack select_less(const Pack& a, const Pack& b, const Pack& if_less, const Pack& otherwise) {
  return by_lane([](double x, double y, double yes, double no) { return x < y ? yes : no; }, a, b, if_less,
                 otherwise);
}

/// The smaller and the larger number in each lane, as for double.
inline Pack smaller_of(const Pack& a, const Pack& b) { return by_lane(smaller_of<double>, a, b); }
inline Pack larger_of(const Pack& a, const Pack& b) { return by_lane(larger_of<double>, a, b); }

/// Numbers as they enter packs: those of double, in each lane.
template <>
struct Constants<Pack> {
  static Pack from_rational(const Rational& q) { return Constants<double>::from_rational(q); }
  static Pack pi() { return Constants<double>::pi(); }
};

/// The type in which an inner loop over numbers of type R runs: several side by side where there is such a
/// type, else R itself.
/// Maths     Block<R>::Type has Block<R>::lanes places
/// Result    double: Pack; any other arithmetic: itself, one lane
template <class R>
struct Block {
  using Type = R;
  static constexpr std::size_t lanes = 1;
  static Type load(const R* from) { return *from; }
  static void store(const Type& block, R* to) { *to = block; }
  static const R& lane(const Type& block, std::size_t) { return block; }
  static void set_lane(Type& block, std::size_t, const R& x) { block = x; }
  static R sum(const Type& block) { return block; }
  static R largest(const Type& block) { return block; }
  static R smallest(const Type& block) { return block; }
};

/// Of doubles eight side by side.
template <>
struct Block<double> {
  using Type = Pack;
  static constexpr std::size_t lanes = Pack::lanes;
  static Type load(const double* from) { return Pack::load(from); }
  static void store(const Type& block, double* to) { block.store(to); }
  static double lane(const Type& block, std::size_t i) { return block.lane(i); }
  static void set_lane(Type& block, std::size_t i, double x) { block.set_lane(i, x); }
  static double sum(const Type& block) { return block.sum(); }
  static double largest(const Type& block) { return block.largest(); }
  static double smallest(const Type& block) { return block.smallest(); }
};

/// The next multiple of the lanes of R: what an array is padded to.
template <class R>
constexpr std::size_t padded(std::size_t count) {
  return (count + Block<R>::lanes - 1) / Block<R>::lanes * Block<R>::lanes;
}

}  // namespace radcert
