// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "radcert/core/outcome.h"
#include "radcert/enclosure/kernel_integral.h"
#include "radcert/surface/surface_point.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// Numbers with proved radii.
/// Maths     |exact_i - values_i| <= radius_i
struct CertifiedValues {
  std::vector<double> values;
  std::vector<double> radius;
};

class CertifiedKernelSums;

/// Such numbers as sums over elements, in a fixed order.
class CertifiedSums {
public:
  /// The integrals of the last of so many functions, over so many elements, at so many points. `use`, if any,
  /// is shown the integrals of all functions over each element. Refused: what CertifiedKernelSums::element
  /// refuses.
  [[nodiscard]] static Outcome<CertifiedSums> over_elements(
      const CertifiedKernelSums& sums, std::size_t elements, std::size_t functions, std::size_t points,
      const std::function<void(std::size_t element, std::span<const double> values,
                               std::span<const double> radius)>& use = {});
  explicit CertifiedSums(std::size_t points)
      : sums_{std::vector<double>(points), std::vector<double>(points)} {}
  void add(std::span<const double> values, std::span<const double> radius);
  void add(const CertifiedSums& other) { add(other.sums_.values, other.sums_.radius); }
  /// The sums over so many elements. Refused where a radius exceeds the demand.
  [[nodiscard]] Outcome<CertifiedValues> within(double demand, std::size_t elements) &&;

private:
  CertifiedValues sums_;
};

/// The radiosity operator's integral of a density at many points, proved.
/// Maths     Int_S G(P_i, Q) u(Q) dS_Q, without 1/pi and reflectivity
/// Source    certified_kernel_sums
/// Requires  an unoccluded surface; a triangulation of it; points by parameters in the domains of their
///           charts; 0 < demand, else ContractViolation
/// Result    radii of at most demand. Refused, with the reason, where that was not reached: see
///           certified_chart_entries; a density that is not analytic on the charts as well. The same bits for
///           any number of threads; Interrupted when asked to stop
/// Limits    V = 1. The triangulation is for speed alone: about one element a few points
Outcome<CertifiedValues> certified_operator(const Surface& surface, const Triangulation& triangulation,
                                            const DensityFormula& u,
                                            std::span<const SurfacePoint<Rational>> points, double demand);

}  // namespace radcert
