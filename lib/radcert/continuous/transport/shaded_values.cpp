// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/continuous/transport/shaded_values.h"

#include <algorithm>
#include <span>
#include <utility>

#include "radcert/continuous/upward.h"

namespace radcert {

SectorFunctions with_one(const SectorFunctions& w, std::size_t elements) {
  SectorFunctions out(elements, w.count() + 1, w.degree());
  for (std::size_t e = 0; e < elements; ++e) {
    for (std::size_t k = 0; k < w.count(); ++k) {
      const std::span<const double> from = w.of(e, k);
      std::copy(from.begin(), from.end(), out.of(e, k).begin());
    }
    out.of(e, w.count())[0] = 1;
  }
  return out;
}

ShadedValues half_shaded(const Penumbra& penumbra, const Transport::Values& found, double size) {
  Penumbra::Rest rest = penumbra.rest(found.shaded);
  const std::size_t count = rest.constants.size();
  const std::size_t points = found.values.size() / (count + 1);
  ShadedValues out{
      .values = {.values = std::vector<double>(points * count), .radius = found.radius * (1 + size) * upward},
      .shade = std::move(rest.bounds)};
  for (std::size_t p = 0; p < points; ++p) {
    const double* const sent = &found.values[p * (count + 1)];
    for (std::size_t k = 0; k < count; ++k)
      out.values.values[p * count + k] = sent[k] + rest.constants[k] * (1 - sent[count]);
  }
  return out;
}

}  // namespace radcert
