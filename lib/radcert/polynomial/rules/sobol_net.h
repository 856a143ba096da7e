// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

namespace radcert {

/// Points of the unit cube in four dimensions that fill it evenly, randomised.
/// Maths     the k-th point of Sobol's sequence in the order of Gray's code: coordinate j has the binary
///           digits sum over the bits b of k ^ (k >> 1) of column b of a matrix C_j over the field of two
///           elements. C_j is replaced by L_j C_j with random lower triangular L_j, ones on the diagonal;
///           then random digits, those of a shift, are added. So any 2^m points from a multiple of 2^m on
///           stay as evenly spread as Sobol's, and each point is uniform in the cube (on multiples of 2^-53)
/// Source    Sobol', 1967; Antonov & Saleev, 1979; initial numbers: Joe & Kuo, 2008; scrambling: Matousek,
///           1998
/// Requires  k < 2^32
/// Result    from two nets, drawn one after the other, and two shifts, means that are independent. The same
///           bits on every machine
/// Limits    the mean of an integrand that jumps across surfaces is off by about the -5/8th power of the
///           number of points
class SobolNet {
public:
  static constexpr std::size_t dimensions = 4;
  static constexpr unsigned digits = 53;
  using Digits = std::array<std::uint64_t, dimensions>;  ///< the first of each coordinate's 53 is the highest

  explicit SobolNet(std::mt19937_64& random);

  /// The digits of the k-th point, before a shift.
  [[nodiscard]] Digits at(std::uint64_t k) const;
  /// From the k-th to the next.
  void advance(Digits& point, std::uint64_t k) const;

  [[nodiscard]] static Digits draw_shift(std::mt19937_64& random);
  [[nodiscard]] static std::array<double, dimensions> shifted(const Digits& point, const Digits& shift);

private:
  static constexpr std::size_t columns = 32;
  std::array<std::array<std::uint64_t, columns>, dimensions> matrices_{};  ///< L_j C_j, column by column
};

}  // namespace radcert
