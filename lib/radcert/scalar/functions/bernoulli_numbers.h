// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace radcert {

/// Bernoulli's numbers B_2, B_4, ..., B_24, each as numerator and denominator.
/// Maths     t / (e^t - 1) = sum_n B_n t^n / n!
/// Result    exact
inline constexpr std::array<std::array<double, 2>, 12> bernoulli_numbers{{{1, 6},
                                                                          {-1, 30},
                                                                          {1, 42},
                                                                          {-1, 30},
                                                                          {5, 66},
                                                                          {-691, 2730},
                                                                          {7, 6},
                                                                          {-3617, 510},
                                                                          {43867, 798},
                                                                          {-174611, 330},
                                                                          {854513, 138},
                                                                          {-236364091, 2730}}};

}  // namespace radcert
