// SPDX-License-Identifier: GPL-3.0-or-later
// A judge of what hides what, that knows points, segments and the faces one by one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "radcert/certificate/polyhedron_certificate.h"
#include "radcert/geometry/vector.h"

namespace radcert::test {

inline Vector<double> rounded(const Vector<Rational>& p) {
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

/// Which faces segments cross.
class Segments {
public:
  explicit Segments(const certificate::PolyhedronCertificate& c) {
    for (const certificate::Face& face : c.faces) {
      faces_.emplace_back();
      for (const Vector<Rational>& corner : face.corners) faces_.back().push_back(rounded(corner));
    }
  }

  /// Whether a segment crosses a face: 1 yes, -1 no, 0 next to a border.
  [[nodiscard]] int hidden(const Vector<double>& p, const Vector<double>& q) const {
    int found = -1;
    for (const std::vector<Vector<double>>& face : faces_) found = std::max(found, crosses(face, p, q));
    return found;
  }

private:
  static int crosses(const std::vector<Vector<double>>& c, const Vector<double>& p, const Vector<double>& q) {
    const Vector<double> n = cross(c[1] - c[0], c[2] - c[0]);
    const double a = dot(n, p - c[0]);
    const double b = dot(n, q - c[0]);
    constexpr double margin = 1e-9;
    if (a * b >= 0 || std::min(std::abs(a), std::abs(b)) < margin) return -1;
    const Vector<double> met = p + (a / (a - b)) * (q - p);
    double least = 1;
    for (std::size_t i = 0; i < c.size(); ++i)
      least = std::min(least, dot(n, cross(c[(i + 1) % c.size()] - c[i], met - c[i])));
    return least > margin ? 1 : least < -margin ? -1 : 0;
  }

  std::vector<std::vector<Vector<double>>> faces_;
};

}  // namespace radcert::test
