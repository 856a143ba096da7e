// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "radcert/quadrature/apex_rule.h"
#include "radcert/quadrature/kernel_sums.h"

namespace radcert {

/// The collocation integrals of one observer and one element.
/// Maths     value[j] = Int_Delta G(P,Q) l_j(Q) dS_Q;  absolute = Int_Delta |G| dS
/// Source    [ac98, (40)]
/// Requires  -
/// Result    |value[j] - exact| <= radius[j] as far as the estimate goes: the difference of two rules plus the rounding bound
/// Limits    an estimate, not a proof
template <Real R>
struct ElementIntegral {
  std::array<R, KernelSums<R>::most_functions> value{};
  std::array<R, KernelSums<R>::most_functions> radius{};
  R absolute{};
};

/// Integrates G l_j over one element for many observers.
/// Maths     far: conical Gauss rules on the element, of an order chosen from the ratio of distance and size; near: the
///           longest side is bisected until the pieces are far in terms of their own size; around an observer on the
///           element's own curved chart: integrate_around; on the element's own plane: exactly 0
/// Source    [ac98, section 5.1] asks for effort that grows as P comes near; the rules are ours
/// Requires  P not on an edge of the element at which another piece meets it at an angle
/// Result    each value to about 1e-13 of Int |G l_j| over the element, radius with it
/// Limits    one thread at a time; samples are kept for the element's life, so let one element serve all observers
template <Real R>
class ElementIntegrator {
public:
  ElementIntegrator(const Surface& surface, const ParameterTriangle& triangle, const InsetBasis<R>& basis);

  ElementIntegral<R> integrate(const Observer<R>& p);

private:
  /// A ball about the image of a cell.
  struct Ball {
    Vector<R> centre;
    R radius;
    std::array<Vector<R>, 3> corners;
  };
  struct Piece {
    Cell<R> cell;
    int depth;
    int failures;  ///< how often two rules differed on a piece that contains this one
  };
  /// What becomes of a piece on which two rules of the highest order differ.
  enum class Insistence {
    none,      ///< it is bisected
    rounding,  ///< it counts, with the difference as its error
    deepest,   ///< it counts, with all of its integral as its error
  };

  Ball ball_about(const Cell<R>& cell) const;
  const Samples<R>& samples(const Cell<R>& cell, bool whole, int order);
  KernelSums<R> sums(const Observer<R>& p, const Cell<R>& cell, bool whole, int order);
  /// The sums of a piece if two rules agree on it; otherwise what `insist` says.
  std::optional<CheckedSums<R>> try_piece(const Observer<R>& p, const Cell<R>& cell, bool whole, double ratio,
                                          Insistence insist);
  CheckedSums<R> integrate_away(const Observer<R>& p);
  ElementIntegral<R> with_radius(const CheckedSums<R>& checked) const;

  const Surface& surface_;
  const Chart& chart_;
  std::size_t chart_index_;
  InsetBasis<R> basis_;
  Cell<R> element_;
  Ball ball_;
  R extent_{};
  std::vector<bool> in_plane_of_;  ///< by chart: G vanishes between it and the element
  std::vector<Piece> pending_;
  std::array<Samples<R>, 2> scratch_;
  std::vector<std::optional<Samples<R>>> kept_;
};

extern template class ElementIntegrator<double>;

}  // namespace radcert
