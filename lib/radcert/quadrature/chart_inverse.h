// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "radcert/quadrature/samples.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// The parameters of a point that lies on or beside a cell of another chart of the same smooth piece, as
/// nodes on seams and next to them do.
/// Maths     x with F(x) = P, by Gauss-Newton on |F(x) - P|^2 from the middle of the cell; x may lie outside
///           the chart's domain, where F is the analytic continuation of the chart's formula
/// Result    x if |F(x) - P| is below 64 roundings of |P|'s size; else nothing
/// Limits    chooses a rule and decides nothing about geometry: nothing is told too where the steps do not
///           end. P is then integrated by bisection, which never comes to an end where P is on the cell: what
///           is left counts as incomplete, and the radius of ElementIntegral holds all that the element may
template <Real R>
std::optional<ParameterPoint<R>> parameters_on(const Chart& chart, const ElementPart<R>& cell,
                                               const Vector<R>& point, const R& extent);

/// Whether a parameter point lies in a cell, up to 1e-12 of its size.
template <Real R>
bool contains(const ElementPart<R>& cell, const ParameterPoint<R>& at);

extern template std::optional<ParameterPoint<double>> parameters_on<double>(const Chart&,
                                                                            const ElementPart<double>&,
                                                                            const Vector<double>&,
                                                                            const double&);
extern template bool contains<double>(const ElementPart<double>&, const ParameterPoint<double>&);

extern template std::optional<ParameterPoint<Mpfr<50>>> parameters_on<Mpfr<50>>(const Chart&,
                                                                                const ElementPart<Mpfr<50>>&,
                                                                                const Vector<Mpfr<50>>&,
                                                                                const Mpfr<50>&);
extern template bool contains<Mpfr<50>>(const ElementPart<Mpfr<50>>&, const ParameterPoint<Mpfr<50>>&);

}  // namespace radcert
