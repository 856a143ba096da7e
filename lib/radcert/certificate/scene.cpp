// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/certificate/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "radcert/certificate/gauss_rule.h"
#include "radcert/geometry/plane.h"
#include "radcert/scalar/ball.h"

namespace radcert::certificate {
namespace {

Vector<Rational> middle(const std::vector<Face>& faces) {
  Vector<Rational> least = faces.front().corners.front();
  Vector<Rational> largest = least;
  for (const Face& face : faces)
    for (const Vector<Rational>& p : face.corners) {
      least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
      largest = {std::max(largest.x, p.x), std::max(largest.y, p.y), std::max(largest.z, p.z)};
    }
  return Rational(1, 2) * (least + largest);
}

Rational power_of_two(int exponent) {
  Rational out = 1;
  for (int k = 0; k < std::abs(exponent); ++k) out *= Rational(2);
  return exponent < 0 ? Rational(1) / out : out;
}

Vector<double> rounded(const Vector<Rational>& p) {
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}

Ball length(const Vector<Rational>& v) { return sqrt(Ball(dot(v, v))); }

/// The corners after they were moved and scaled.
struct ExactTriangle {
  std::size_t face;
  Vector<Rational> a;
  Vector<Rational> along;
  Vector<Rational> inward;
};

}  // namespace

Scene::Scene(const PolyhedronCertificate& certificate) {
  const std::vector<Face>& faces = certificate.faces;
  const Vector<Rational> origin = middle(faces);
  Rational largest = 0;
  for (const Face& face : faces)
    for (const Vector<Rational>& p : face.corners) {
      const Vector<Rational> at = p - origin;
      largest = std::max({largest, abs(at.x), abs(at.y), abs(at.z)});
    }
  std::frexp(largest.to_double(), &exponent_);
  while (power_of_two(exponent_) < largest) ++exponent_;
  const Rational scale = power_of_two(-exponent_);
  std::vector<ExactTriangle> exact;
  std::vector<Vector<Rational>> normals;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    first_.push_back(exact.size());
    std::vector<Vector<Rational>> corners;
    Vector<Rational> sum;
    for (const Vector<Rational>& p : faces[k].corners) {
      corners.push_back(scale * (p - origin));
      sum = sum + corners.back();
    }
    const Vector<Rational> centre = Rational(1, static_cast<long>(corners.size())) * sum;
    for (std::size_t i = 0; i < corners.size(); ++i)
      exact.push_back({.face = k,
                       .a = corners[i],
                       .along = corners[(i + 1) % corners.size()] - corners[i],
                       .inward = centre - corners[i]});
    normals.push_back(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const Ball size = length(normals.back());
    const Vector<Rational>& n = normals.back();
    normals_.push_back(
        {(Ball(n.x) / size).to_double(), (Ball(n.y) / size).to_double(), (Ball(n.z) / size).to_double()});
  }
  first_.push_back(exact.size());
  for (std::size_t k = 0; k < faces.size(); ++k)
    for (std::size_t l = 0; l < faces.size(); ++l) {
      const ExactTriangle& own = exact[first_[k]];
      const ExactTriangle& other = exact[first_[l]];
      coplanar_.push_back(
          same_plane({own.a, own.along, own.inward}, {other.a, other.along, other.inward}) ? 1 : 0);
    }
  for (const ExactTriangle& x : exact) {
    SideTriangle triangle{.face = x.face,
                          .a = rounded(x.a),
                          .along = rounded(x.along),
                          .inward = rounded(x.inward),
                          .length = length(x.along).upper_double(),
                          .jacobian = length(cross(x.along, x.inward)).upper_double(),
                          .height = 0,
                          .beyond = std::nullopt};
    triangle.height = (length(cross(x.along, x.inward)) / length(x.along)).lower_double();
    for (std::size_t other = 0; other < exact.size(); ++other) {
      const ExactTriangle& y = exact[other];
      aligned_.push_back(is_zero(cross(x.along, y.along)) ? 1 : 0);
      if (coplanar_[x.face * faces.size() + y.face] == 0 && y.a == x.a + x.along && y.a + y.along == x.a)
        triangle.beyond = other;
    }
    triangles_.push_back(triangle);
    for (std::size_t l = 0; l < faces.size(); ++l) {
      const Vector<Rational>& n = normals[l];
      const Ball size = length(n);
      const auto over = [&](const Vector<Rational>& v) { return bounded(Ball(dot(n, v)) / size); };
      parallel_.push_back(dot(n, x.along).sign() == 0 ? 1 : 0);
      heights_.push_back({over(x.a - exact[first_[l]].a), over(x.along), over(x.inward)});
    }
  }
}

double segment_distance(const Vector<double>& p, const Vector<double>& from, const Vector<double>& to) {
  const Vector<double> way = to - from;
  const double squared = dot(way, way);
  const double at = squared > 0 ? std::clamp(dot(p - from, way) / squared, 0.0, 1.0) : 0.0;
  return norm(p - (from + at * way));
}

Quadrilateral::Quadrilateral(const SideTriangle& triangle, const Vector<double>& normal, const Box& box)
    : normal_(normal), corners_{triangle.point(box.s0, box.t0), triangle.point(box.s1, box.t1)} {
  const auto unit = [&](const Vector<double>& along) {
    const Vector<double> out = cross(along, normal_);
    const double size = norm(out);
    return size > 0 ? (1 / size) * out : Vector<double>{};
  };
  const Vector<double> below = unit(triangle.along);
  outward_ = {{0, below}, {1, -below}};
  outward_.push_back({0, -unit(triangle.inward - box.s0 * triangle.along)});
  outward_.push_back({1, unit(triangle.inward - box.s1 * triangle.along)});
  // Directions of lines s = const are off by so much more, relative to their length.
  slack_ = slack * (1 + triangle.length / triangle.height);
}

double Quadrilateral::distance(const Vector<double>& p) const {
  const double height = std::max(0.0, std::abs(dot(normal_, p - corners_[0])) - slack);
  double beside = 0;
  for (const auto& [corner, outward] : outward_)
    beside = std::max(beside, dot(outward, p - corners_[corner]) - slack_);
  return std::sqrt(height * height + beside * beside) / upward;
}

}  // namespace radcert::certificate
