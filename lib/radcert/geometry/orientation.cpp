// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/orientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace radcert {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Vector<double>& p) { return {p.x, p.y, p.z}; }
Kernel::Point_2 point(const ParameterPoint<double>& p) { return {p.s, p.t}; }

}  // namespace

int orientation(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c,
                const Vector<double>& d) {
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

int orientation(const ParameterPoint<double>& a, const ParameterPoint<double>& b,
                const ParameterPoint<double>& c) {
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c)));
}

bool collinear(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c) {
  return CGAL::collinear(point(a), point(b), point(c));
}

Vector<Rational> exactly(const Vector<double>& point) {
  return {Rational::exactly(point.x), Rational::exactly(point.y), Rational::exactly(point.z)};
}

}  // namespace radcert
