// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/polynomial/triangle_basis.h"
#include "radcert/scalar/pack.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// A triangle inside an element: its corners in the parameter plane and in the element's barycentric
/// coordinates.
/// Maths     the element itself, or what divisions left of it: part_division.h
/// Requires  corners, vertices and area belong together
/// Result    data alone
template <Real R>
struct ElementPart {
  std::array<ParameterPoint<R>, 3> vertices;
  std::array<Barycentric<R>, 3> corners;
  /// Twice the area in the parameter plane. The vertices, which are rounded, know that of a thin part less
  /// well.
  R doubled_area{};

  /// The same cell with vertex `i` first.
  ElementPart rotated(std::size_t i) const;
};

/// A whole element as a part of itself.
template <Real R>
ElementPart<R> whole_element(const ParameterTriangle& triangle);

/// Quadrature points of one cell, as structure of arrays, with all that does not depend on the collocation
/// point.
/// Maths     Int_cell f l_j dS ~ sum_q f(Q_q) |normal_q| l_j(x_q); normal_q is the inner normal n_Q times
///           area element times weight
/// Source    [ac98, (30)]
/// Requires  see `take_samples`
/// Result    `count` points; arrays are padded to whole blocks by points of zero weight; basis values lie by
///           blocks: basis[(block * functions + j) * lanes + lane]; (s, t) are relative to `origin`, the
///           cell's first vertex: in a small cell they keep digits that the parameters themselves would lose
template <Real R>
struct Samples {
  static constexpr std::size_t lanes = Block<R>::lanes;

  std::size_t count = 0;
  std::size_t functions = 0;
  ParameterPoint<R> origin;
  std::vector<R> x, y, z;
  std::vector<R> normal_x, normal_y, normal_z;
  std::vector<R> s, t;
  std::vector<R> basis;

  std::size_t blocks() const { return x.size() / lanes; }
  /// The place of l_0 at point q; l_j lies j * lanes further.
  const R* basis_at(std::size_t q) const { return basis.data() + q / lanes * functions * lanes + q % lanes; }
};

/// Points and weights of a rule on a triangle, as structure of arrays.
/// Maths     barycentric coordinates x_1, x_2, x_3 and weights that sum to 1/2
/// Result    padded to whole blocks: the last point again, with zero weight
template <Real R>
struct RuleArrays {
  std::size_t count = 0;
  std::array<std::vector<R>, 3> x;
  std::vector<R> weights;
};

/// The conical rules of every order and grading, each computed once.
template <Real R>
class ConicalRules {
public:
  static constexpr int smallest_order = 2;
  /// Enough for a collocation point 1.35 radii away at the finest tolerance of double; more for more digits.
  static constexpr int largest_order = std::is_same_v<R, double> ? 24 : 72;
  static const RuleArrays<R>& rule(int order, Grading grading);
};

/// Samples of a cell by the conical rule of an order. Where the cell touches a line on which its chart is not
/// analytic, the rule is graded towards it.
/// Maths     see conical_rule
/// Source    ours
/// Requires  smallest_order <= order <= largest_order
/// Result    fills `out`, reusing its storage
template <Real R>
void take_samples(const Chart& chart, const ElementPart<R>& cell,
                  const std::type_identity_t<TriangleBasis<R>>& basis, int order, Samples<R>& out);

extern template struct ElementPart<double>;
extern template ElementPart<double> whole_element<double>(const ParameterTriangle&);
extern template class ConicalRules<double>;
extern template void take_samples<double>(const Chart&, const ElementPart<double>&,
                                          const TriangleBasis<double>&, int, Samples<double>&);
extern template struct ElementPart<Mpfr<50>>;
extern template ElementPart<Mpfr<50>> whole_element<Mpfr<50>>(const ParameterTriangle&);
extern template class ConicalRules<Mpfr<50>>;
extern template void take_samples<Mpfr<50>>(const Chart&, const ElementPart<Mpfr<50>>&,
                                            const TriangleBasis<Mpfr<50>>&, int, Samples<Mpfr<50>>&);

}  // namespace radcert
