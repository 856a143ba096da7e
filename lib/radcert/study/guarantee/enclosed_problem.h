// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "radcert/geometry/vector.h"
#include "radcert/scalar/rational.h"
#include "radcert/study/certified_solution.h"
#include "radcert/study/guarantee.h"
#include "radcert/study/guarantee_context.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// A problem whose solution can be enclosed.
class EnclosedProblem {
public:
  EnclosedProblem() = default;
  EnclosedProblem(const EnclosedProblem&) = delete;
  EnclosedProblem& operator=(const EnclosedProblem&) = delete;
  EnclosedProblem(EnclosedProblem&&) = delete;
  EnclosedProblem& operator=(EnclosedProblem&&) = delete;
  virtual ~EnclosedProblem() = default;

  /// Result    proved; see solve_within
  [[nodiscard]] virtual std::pair<LevelResult, SolutionEnclosure> solve(
      const GuaranteeContext& context) const = 0;

  /// What stands in the way of a certificate, each condition in words; nothing: there is one.
  [[nodiscard]] virtual std::vector<std::string> certificate_hindrances() const = 0;
  /// Requires  no hindrances, else ContractViolation
  [[nodiscard]] virtual CertifiedSolution certified(const GuaranteeContext& context) const = 0;
};

/// The kinds of problems, by their surfaces.
/// Requires  problem and guarantee outlive the result; no interpolated geometry, an emission
/// Result    InputError with the JSON pointer where the problem, or what is asked for, cannot be enclosed
[[nodiscard]] std::unique_ptr<EnclosedProblem> enclosed_polyhedron(const Problem& problem,
                                                                   const Guarantee& guarantee,
                                                                   Surface surface);
[[nodiscard]] std::unique_ptr<EnclosedProblem> enclosed_ellipsoid(const Problem& problem,
                                                                  const Guarantee& guarantee,
                                                                  Surface surface);

/// Of the width that is wanted, what a search aims at whose result becomes a certificate: the claims there
/// are wider than what the search has proved.
inline constexpr double certified_share = 0.75;
/// Says where a certificate is wider than wanted, and nothing where it is not.
void say_width_of_certificate(const Rational& width, const Guarantee& guarantee,
                              SolutionEnclosure& enclosure);

/// "(1/2, 0, 1)".
[[nodiscard]] std::string coordinates_text(const Vector<Rational>& p);

/// Refuses a width below what double can carry for solutions of this size, max |E| / (1 - sup rho).
void require_width(const Guarantee& guarantee, double relative, const Rational& size);

/// Bounds are relative: refuses numbers near the ends of double's range, which have none.
void require_normal(const Rational& value, const std::string& pointer);

}  // namespace radcert
