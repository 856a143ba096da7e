// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/quadrature/samples.h"

namespace radcert {

/// The parts into which a part of an element is divided where a point P is too near to it for a rule.
/// Maths     a thin part is cut across its length alone: into slices between its two long sides, each halved
///           until it is far from P or as short as wide, and then cut into two triangles; without a side
///           across its length it is first cut at the foot of its height. Any other is bisected at its
///           longest side. At the distance d from a part of length L and width w some log(L/w) + log(w/d)
///           parts are left in the end, where bisection of longest sides alone, which keeps thin parts thin,
///           leaves some L/w
/// Source    ours
/// Limits    one thread at a time
template <Real R>
class PartDivision {
public:
  /// Requires  `at` are the images of the part's corners on the surface, by which lengths are measured
  /// Result    at least two parts whose union is the part, without common interior, until the next call;
  ///           corners within a rounding, areas within some roundings of their own size. A part without
  ///           length is bisected
  std::span<const ElementPart<R>> divide(const ElementPart<R>& part, const std::array<Vector<R>, 3>& at,
                                         const Vector<R>& p);

private:
  /// Between two shares of the way from the apex of a thin part to its short side.
  struct Slice {
    double begin;
    double end;
  };

  void cut_at(const ElementPart<R>& part, std::size_t opposite, double share);
  void slice(const ElementPart<R>& part, std::size_t apex, const std::array<Vector<R>, 3>& at,
             const Vector<R>& p);

  std::vector<ElementPart<R>> parts_;
  std::vector<Slice> pending_;
};

extern template class PartDivision<double>;
extern template class PartDivision<Mpfr<50>>;

}  // namespace radcert
