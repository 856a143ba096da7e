// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "radcert/quadrature/apex_rule.h"
#include "radcert/quadrature/far_field.h"
#include "radcert/quadrature/integration_scheme.h"
#include "radcert/quadrature/kernel_sums.h"
#include "radcert/quadrature/part_division.h"

namespace radcert {

/// The collocation integrals of one collocation point and one element.
/// Maths     value[j] = Int_Delta G(P,Q) l_j(Q) dS_Q;  absolute = Int_Delta |G| dS
/// Source    [ac98, (40)]
/// Result    |value[j] - exact| <= radius[j] as far as the estimate goes: what the rule leaves out plus the
///           rounding bound
/// Limits    an estimate, not a proof
template <Real R>
struct ElementIntegral {
  std::array<R, KernelSums<R>::most_functions> value{};
  std::array<R, KernelSums<R>::most_functions> radius{};
  R absolute{};
};

/// The same for a block of collocation points, one a lane.
template <Real R>
struct BlockIntegral {
  using B = typename Block<R>::Type;
  std::array<B, KernelSums<R>::most_functions> value;
  std::array<B, KernelSums<R>::most_functions> radius;
  B absolute;
};

/// Integrates G l_j over one element for many collocation points.
/// Maths     far: conical Gauss rules on the element, of an order chosen from the ratio of distance and size;
///           near: it is divided (part_division.h) until the pieces are far in terms of their own size, and
///           change evenly (even_shape.h); near and around a collocation point on the element's own curved
///           chart, or on another one of its smooth piece where the chart's formula continues to P:
///           integrate_around; on the element's own plane: exactly 0.  What a rule leaves out:
///           flat_rule_bound on plane elements seen from afar, elsewhere the difference of two rules.  A
///           piece that rounding does not tell apart from P, or that bisection does not reach, is left out:
///           then |Int G l_j| over it is at most max|l_j| Int |G| dS, and Int |G| dS <= pi over what each ray
///           from P meets once: |cos| over a hemisphere
/// Source    [ac98, section 5.1] asks for effort that grows as P comes near; the rules are ours
/// Requires  P not on an edge of the element at which another piece meets it at an angle
/// Result    each value to the scheme's tolerance, radius with it, or with the radius pi max|l_j| more. A
///           near block's lanes have the bits of their collocation points alone; a far block takes one rule
///           for all its lanes, so that a collocation point's bits depend on its block
/// Limits    one thread at a time; samples are kept for the element's life, so let one element serve all
///           collocation points
template <Real R>
class ElementIntegrator {
public:
  ElementIntegrator(std::shared_ptr<const IntegrationScheme<R>> scheme, const ParameterTriangle& triangle);
  ElementIntegrator(const Surface& surface, const ParameterTriangle& triangle, const TriangleBasis<R>& basis,
                    const Tolerance& tolerance = Tolerance())
      : ElementIntegrator(std::make_shared<const IntegrationScheme<R>>(surface, basis, tolerance), triangle) {
  }

  ElementIntegral<R> integrate(const CollocationPoint<R>& p);
  /// The same over a triangle in the element, a plane one that P is not in the plane of.
  ElementIntegral<R> integrate_part(const CollocationPoint<R>& p, const ElementPart<R>& part);
  const IntegrationScheme<R>& scheme() const { return *scheme_; }

  /// The integrals of a block of `collocation points`, whose members are needed where the block is near.
  void integrate(const CollocationPointBlock<R>& block, std::span<const CollocationPoint<R>> observers,
                 BlockIntegral<R>& integral);

private:
  using B = typename Block<R>::Type;

  /// A ball about the image of a cell.
  struct BoundingBall {
    Vector<R> centre;
    R radius;
    std::array<Vector<R>, 3> corners;
  };
  struct Piece {
    ElementPart<R> cell;
    int depth;
    int failures;  ///< how often two rules differed on a piece that contains this one
  };
  /// How a piece on which two rules of the highest order differ is treated.
  enum class Insistence {
    none,      ///< it is bisected
    rounding,  ///< it counts, with the difference as its error
  };

  const TriangleBasis<R>& basis() const { return scheme_->basis(); }
  BoundingBall ball_about(const ElementPart<R>& cell) const;
  ElementShape shape_of(const ElementPart<R>& cell) const;
  bool is_near(const Vector<R>& p) const;
  ElementIntegral<R> around(const CollocationPoint<R>& p) const;
  /// The largest coordinate in the bounds of rounding, for points within `reach` of P.
  R extent_for(const R& coordinate, std::size_t chart_of_p, const R& reach) const;
  const Samples<R>& kept(int order);
  const Samples<R>& samples(const ElementPart<R>& cell, bool whole, int order);
  KernelSums<R> sums(const CollocationPoint<R>& p, const ElementPart<R>& cell, bool whole, const R& extent,
                     int order);
  /// The sums of a piece if two rules agree on it; otherwise what `insist` says.
  std::optional<CheckedSums<R>> try_piece(const CollocationPoint<R>& p, const ElementPart<R>& cell,
                                          bool whole, double ratio, const R& extent, Insistence insist);
  CheckedSums<R> integrate_away(const CollocationPoint<R>& p) { return integrate_away(p, element_, true); }
  CheckedSums<R> integrate_away(const CollocationPoint<R>& p, const ElementPart<R>& cell, bool is_element);
  ElementIntegral<R> with_radius(const CheckedSums<R>& checked) const;

  B far_rounding(std::size_t points, const FarBounds<R>& bounds, std::size_t j) const;
  void integrate_far_by_bound(const CollocationPointBlock<R>& block, const FarBounds<R>& bounds, int order,
                              BlockIntegral<R>& integral);
  void integrate_far_by_comparison(const CollocationPointBlock<R>& block,
                                   std::span<const CollocationPoint<R>> observers, const FarBounds<R>& bounds,
                                   int order, BlockIntegral<R>& integral);
  void integrate_lane(const CollocationPointBlock<R>& block, std::span<const CollocationPoint<R>> observers,
                      std::size_t lane, BlockIntegral<R>& integral);

  std::shared_ptr<const IntegrationScheme<R>> scheme_;
  const Chart& chart_;
  std::size_t chart_index_;
  ElementPart<R> element_;
  BoundingBall ball_;
  ElementShape shape_;
  R parameter_loss_{};  ///< relative, of integrals around P; 0 but for thin elements
  R extent_{};
  std::optional<FarView<R>> view_;
  std::vector<Piece> pending_;
  PartDivision<R> division_;
  std::array<Samples<R>, 2> scratch_;
  std::vector<std::optional<Samples<R>>> kept_;
  std::vector<B> g_;
  std::array<FarSums<R>, 2> far_;
};

extern template class ElementIntegrator<double>;
extern template class ElementIntegrator<Mpfr<50>>;

}  // namespace radcert
