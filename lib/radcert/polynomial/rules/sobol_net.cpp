// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/rules/sobol_net.h"

#include <bit>
#include <span>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

constexpr std::uint64_t highest = std::uint64_t{1} << (SobolNet::digits - 1);

/// A primitive polynomial t^s + a_1 t^(s-1) + ... + a_(s-1) t + 1, and the odd numbers m_1, ..., m_s.
struct Direction {
  std::span<const unsigned> middle;  ///< a_1, ..., a_(s-1)
  std::span<const unsigned> first;
};

/// Column b holds m_(b+1) / 2^(b+1), where m_k is 2 a_1 m_(k-1) + 4 a_2 m_(k-2) + ... + 2^s m_(k-s) + m_(k-s)
/// in the field of two elements.
template <std::size_t columns>
std::array<std::uint64_t, columns> direction_numbers(const Direction& direction) {
  const std::size_t degree = direction.first.size();
  std::array<std::uint64_t, columns> out{};
  for (std::size_t b = 0; b < columns; ++b) {
    if (b < degree) {
      out[b] = (highest >> b) * direction.first[b];
      continue;
    }
    out[b] = out[b - degree] ^ (out[b - degree] >> degree);
    for (std::size_t k = 1; k < degree; ++k)
      if (direction.middle[k - 1] == 1) out[b] ^= out[b - k];
  }
  return out;
}

}  // namespace

SobolNet::SobolNet(std::mt19937_64& random) {
  static constexpr std::array<unsigned, 1> square{1};
  static constexpr std::array<unsigned, 2> cube{0, 1};
  static constexpr std::array<unsigned, 3> ones{1, 3, 1};
  for (std::size_t b = 0; b < columns; ++b) matrices_[0][b] = highest >> b;
  const std::span<const unsigned> first(ones);
  matrices_[1] = direction_numbers<columns>({{}, first.first(1)});
  matrices_[2] = direction_numbers<columns>({square, first.first(2)});
  matrices_[3] = direction_numbers<columns>({cube, first});
  for (auto& matrix : matrices_) {
    // Row d of L: random digits before the d-th, and a one there.
    std::array<std::uint64_t, digits> rows{};
    for (std::size_t d = 0; d < digits; ++d) {
      const std::uint64_t one = highest >> d;
      const std::uint64_t before = (2 * highest - 1) ^ (2 * one - 1);
      rows[d] = (random() & before) | one;
    }
    for (std::uint64_t& column : matrix) {
      std::uint64_t scrambled = 0;
      for (std::size_t d = 0; d < digits; ++d)
        if (std::popcount(rows[d] & column) % 2 == 1) scrambled |= highest >> d;
      column = scrambled;
    }
  }
}

SobolNet::Digits SobolNet::at(std::uint64_t k) const {
  expects(k >> columns == 0, "k < 2^32", named("k", k));
  Digits point{};
  for (std::uint64_t gray = k ^ (k >> 1U); gray != 0; gray &= gray - 1)
    for (std::size_t j = 0; j < dimensions; ++j)
      point[j] ^= matrices_[j][static_cast<std::size_t>(std::countr_zero(gray))];
  return point;
}

// Gray's codes of neighbours differ in one bit, that of the lowest zero of k.
void SobolNet::advance(Digits& point, std::uint64_t k) const {
  const auto bit = static_cast<std::size_t>(std::countr_one(k));
  for (std::size_t j = 0; j < dimensions; ++j) point[j] ^= matrices_[j][bit % columns];
}

SobolNet::Digits SobolNet::draw_shift(std::mt19937_64& random) {
  Digits shift{};
  for (std::uint64_t& x : shift) x = random() >> (64U - digits);
  return shift;
}

std::array<double, SobolNet::dimensions> SobolNet::shifted(const Digits& point, const Digits& shift) {
  std::array<double, dimensions> x{};
  for (std::size_t j = 0; j < dimensions; ++j) x[j] = static_cast<double>(point[j] ^ shift[j]) * 0x1p-53;
  return x;
}

}  // namespace radcert
