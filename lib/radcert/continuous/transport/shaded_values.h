// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "radcert/continuous/elements/tensor_legendre.h"
#include "radcert/continuous/occlusion/penumbra.h"
#include "radcert/continuous/transport/transport.h"

namespace radcert {

/// Functions on elements and, last, 1.
[[nodiscard]] SectorFunctions with_one(const SectorFunctions& w, std::size_t elements);

/// Functions near T w_k at points, and how near.
struct ShadedValues {
  Transport::Values values;        ///< by point, function
  std::vector<double> shade = {};  ///< by function: of T w_k less that, beside the radius of the values
};

/// What is sent past panels that hide each other.
/// Maths     F_k + c_k (1 - F 1) of Penumbra, for all functions w_k of it
/// Requires  values by a Transport of the functions with_one, of the same observers for all points; size at
///           least sup |w_k|
/// Result    the radius of F_k + c_k (1 - F 1), and what is shaded beside it
[[nodiscard]] ShadedValues half_shaded(const Penumbra& penumbra, const Transport::Values& found, double size);

}  // namespace radcert
