// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/continuous/elements/panel.h"
#include "radcert/continuous/elements/sector.h"
#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/polynomial/plane_polynomial.h"
#include "radcert/scalar/rational.h"
#include "radcert/surface/catalogue.h"

namespace radcert::test {

inline Surface named_surface(const std::string& name) { return default_surface(*find_surface(name)); }

inline std::vector<Panel> panels_of(const std::string& name) {
  return convex_panels(named_surface(name)).value();
}

/// Numbers that look random, the same on every machine.
class Draw {
public:
  explicit Draw(std::uint64_t seed) : state_(seed) {}
  /// In [0,1), of 20 bits.
  double operator()() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 44U) * 0x1p-20;
  }
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>((*this)() * static_cast<double>(count));
  }

private:
  std::uint64_t state_;
};

/// Whole multiples of `unit`, from -9 to 9, as coefficients.
inline PlanePolynomial<Rational> drawn_polynomial(int degree, const Rational& unit, Draw& draw) {
  PlanePolynomial<Rational> f(degree);
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j) f(i, j) = Rational(static_cast<long>(draw.below(19)) - 9) * unit;
  return f;
}

/// Coefficients that fall off as those of smooth functions do.
inline SectorFunctions drawn_functions(std::size_t elements, std::size_t count, int degree, Draw& draw) {
  SectorFunctions f(elements, count, degree);
  const auto powers = static_cast<std::size_t>(degree + 1);
  for (std::size_t e = 0; e < elements; ++e)
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < powers; ++i)
        for (std::size_t j = 0; j < powers; ++j)
          f.of(e, k)[i * powers + j] = (draw() - 0.25) / static_cast<double>(1U << (2 * (i + j)));
  return f;
}

/// The polynomial that a function is on an element, anywhere.
template <class R>
R element_value(const SectorFunctions& f, std::size_t element, std::size_t k, const SectorBox& box,
                const R& s, const R& t) {
  const auto powers = static_cast<std::size_t>(f.degree() + 1);
  std::vector<R> p_s(powers);
  std::vector<R> p_t(powers);
  legendre_values<R>((2.0 * s - box.s0 - box.s1) / (box.s1 - box.s0), p_s);
  legendre_values<R>((2.0 * t - box.t0 - box.t1) / (box.t1 - box.t0), p_t);
  R sum = 0;
  for (std::size_t i = 0; i < powers; ++i)
    for (std::size_t j = 0; j < powers; ++j) sum += f.of(element, k)[i * powers + j] * p_s[i] * p_t[j];
  return sum;
}

}  // namespace radcert::test
