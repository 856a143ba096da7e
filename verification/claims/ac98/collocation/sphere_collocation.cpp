// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/ac98/collocation/sphere_collocation.h"

namespace radcert::verification::ac98 {
namespace {

Vector<Rational> middle(const Vector<Rational>& a, const Vector<Rational>& b) {
  return Rational(1, 2) * (a + b);
}

Vector<Ball> in_balls(const Vector<Rational>& v) { return {Ball(v.x), Ball(v.y), Ball(v.z)}; }

}  // namespace

std::vector<OctantTriangle> symmetric_octant(int level) {
  std::vector<OctantTriangle> triangles{
      {.corners = {Vector<Rational>{1, 0, 0}, Vector<Rational>{0, 1, 0}, Vector<Rational>{0, 0, 1}}}};
  for (int k = 0; k < level; ++k) {
    std::vector<OctantTriangle> refined;
    for (const OctantTriangle& t : triangles) {
      const auto& [a, b, c] = t.corners;
      const Vector<Rational> ab = middle(a, b);
      const Vector<Rational> bc = middle(b, c);
      const Vector<Rational> ca = middle(c, a);
      refined.push_back({{a, ab, ca}, t.upright});
      refined.push_back({{ab, b, bc}, t.upright});
      refined.push_back({{ca, bc, c}, t.upright});
      refined.push_back({{bc, ca, ab}, !t.upright});
    }
    triangles = std::move(refined);
  }
  return triangles;
}

std::vector<OctantTriangle> upright_divided_octant(int level) {
  std::vector<OctantTriangle> result;
  for (const OctantTriangle& t : symmetric_octant(level)) {
    if (!t.upright) {
      result.push_back(t);
      continue;
    }
    const auto& [a, b, c] = t.corners;
    const Vector<Rational> centroid = Rational(1, 3) * (a + b + c);
    result.push_back({{a, b, centroid}, true});
    result.push_back({{centroid, b, c}, true});
    result.push_back({{a, centroid, c}, true});
  }
  return result;
}

std::array<Ball, 3> coordinate_integrals(const OctantTriangle& triangle) {
  std::array<Vector<Ball>, 3> v;
  std::array<Ball, 3> r;
  for (std::size_t i = 0; i < 3; ++i) {
    v.at(i) = in_balls(triangle.corners.at(i));
    r.at(i) = norm(v.at(i));
  }
  const Ball determinant = dot(v[0], cross(v[1], v[2]));
  const Ball denominator =
      r[0] * r[1] * r[2] + dot(v[0], v[1]) * r[2] + dot(v[1], v[2]) * r[0] + dot(v[2], v[0]) * r[1];
  const Ball omega = Ball(2) * atan(abs(determinant) / denominator);  // below a quarter of the sphere
  const Ball distance = reciprocal(sqrt(Ball(3)));
  const Vector<Ball> normal{distance, distance, distance};
  Vector<Ball> field = omega * normal;
  const bool turned = certainly_negative(determinant);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const Vector<Ball> side = v.at(next) - v.at(i);
    const Ball length = norm(side);
    const Ball along = log((r.at(i) + r.at(next) + length) / (r.at(i) + r.at(next) - length));
    const Vector<Ball> outer = reciprocal(length) * (turned ? cross(normal, side) : cross(side, normal));
    field = field - along * outer;
  }
  std::array<Ball, 3> integrals;
  for (std::size_t i = 0; i < 3; ++i)
    integrals.at(i) = distance * dot(field, cross(v.at((i + 1) % 3), v.at((i + 2) % 3))) / determinant;
  return integrals;
}

SphereCollocation::SphereCollocation(const std::vector<OctantTriangle>& octant, const Rational& alpha) {
  const Ball inset(alpha);
  const Ball scale = Ball(Rational(1) / (4 * (1 - 3 * alpha))) / Ball::pi();
  for (const OctantTriangle& triangle : octant) {
    const std::array<Ball, 3> integrals = coordinate_integrals(triangle);
    const Ball sum = integrals[0] + integrals[1] + integrals[2];
    for (std::size_t j = 0; j < 3; ++j) {
      Vector<Rational> x{0, 0, 0};
      for (std::size_t i = 0; i < 3; ++i) x = x + (i == j ? 1 - 2 * alpha : alpha) * triangle.corners.at(i);
      const Vector<Ball> node = in_balls(x);
      nodes_.push_back(reciprocal(norm(node)) * node);
      weights_.push_back(scale * (integrals.at(j) - inset * sum));
    }
  }
}

Ball SphereCollocation::mean(const Function& f) const {
  Ball sum(0);
  for (const int x : {1, -1})
    for (const int y : {1, -1})
      for (const int z : {1, -1})
        for (std::size_t i = 0; i < nodes_.size(); ++i)
          sum += weights_[i] * f({Ball(x) * nodes_[i].x, Ball(y) * nodes_[i].y, Ball(z) * nodes_[i].z});
  return sum;
}

Ball SphereCollocation::weight_sum() const {
  constexpr int octants = 8;
  Ball sum(0);
  for (const Ball& weight : weights_) sum += abs(weight);
  return Ball(octants) * sum;
}

}  // namespace radcert::verification::ac98
