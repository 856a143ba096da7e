// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "radcert/geometry/vector.h"
#include "radcert/polynomial/barycentric.h"
#include "radcert/scalar/bounded_double.h"
#include "radcert/scalar/functions/taylor_model.h"

namespace radcert {

/// A point of an element as the functions beside the kernel see it.
template <Field R>
struct ElementPoint {
  Barycentric<R> in_element;
  std::size_t chart = 0;
  ParameterPoint<R> at;
  Vector<R> point;
};

/// Functions on the elements of a triangulation: Lagrange functions, a density.
/// Maths     f_1, ..., f_p, real on the surface
/// Requires  both arithmetics bound the same functions; where bound() is finite they are analytic on the set
///           of the models; may be called from several threads at once
class ElementFunctions {
public:
  virtual ~ElementFunctions() = default;
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// One value a function.
  virtual void values(const ElementPoint<BoundedDouble>& at, std::span<BoundedDouble> out) const = 0;
  /// At least |f_j| on the set of the models, for all j; infinity where nothing was shown.
  [[nodiscard]] virtual double bound(const ElementPoint<TaylorModel>& at) const = 0;
  /// What an error over the set of the models is allowed to be relative to. Not the bound where the functions
  /// are much larger beside the real points than on them, or where an absolute error is demanded.
  [[nodiscard]] virtual double allowed(const ElementPoint<TaylorModel>& /*at*/, double bound) const {
    return bound;
  }
};

}  // namespace radcert
