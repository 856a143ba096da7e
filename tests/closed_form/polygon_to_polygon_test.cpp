// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/closed_form/polygon_to_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/closed_form/gauss_legendre.h"
#include "tests/closed_form/known_digits.h"

namespace radcert {
namespace {

using Point = Vector<Rational>;

// Widest ball that a factor may be at 128 bits, where no digits are lost by the position of the polygons.
constexpr double narrow = 1e-30;

class Stream {
public:
  explicit Stream(unsigned seed) : bits_(seed) {}
  long below(long count) { return static_cast<long>(bits_() % static_cast<unsigned long>(count)); }
  Rational fraction() { return {below(17) - 8, 1 + below(7)}; }
  Point point() { return {fraction(), fraction(), fraction()}; }

private:
  std::mt19937_64 bits_;
};

PlanePolygon polygon(const std::vector<Point>& corners) { return plane_polygon(corners).value(); }

// The triangle whose inner side is that of `seen`.
PlanePolygon facing(const Point& a, const Point& b, const Point& c, const Point& seen) {
  return dot(cross(b - a, c - a), seen - a).sign() > 0 ? polygon({a, b, c}) : polygon({a, c, b});
}

PlanePolygon turned_over(std::vector<Point> corners) {
  std::reverse(corners.begin(), corners.end());
  return polygon(corners);
}

Ball area(const PlanePolygon& p) {
  return sqrt(Ball(dot(p.normal(), p.normal()))) * Ball(p.parameter_area());
}

std::string text(const Point& p) {
  return "(" + p.x.to_text() + ", " + p.y.to_text() + ", " + p.z.to_text() + ")";
}

std::string text(const PlanePolygon& p) {
  std::string all;
  for (const PolygonLoop& loop : p.loops())
    for (const ParameterPoint<Rational>& at : loop) all += text(p.point(at)) + " ";
  return all;
}

// The faces of a box from the origin, seen from inside.
std::vector<PlanePolygon> box_faces(const Rational& x, const Rational& y, const Rational& z) {
  return {polygon({{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}}),
          polygon({{0, 0, z}, {0, y, z}, {x, y, z}, {x, 0, z}}),
          polygon({{0, 0, 0}, {0, y, 0}, {0, y, z}, {0, 0, z}}),
          polygon({{x, 0, 0}, {x, 0, z}, {x, y, z}, {x, y, 0}}),
          polygon({{0, 0, 0}, {0, 0, z}, {x, 0, z}, {x, 0, 0}}),
          polygon({{0, y, 0}, {x, y, 0}, {x, y, z}, {0, y, z}})};
}

// The triangles of the convex hull, seen from inside; empty where four points lie in a plane, or nothing is
// inside.
std::vector<PlanePolygon> hull_faces(const std::vector<Point>& points) {
  std::vector<PlanePolygon> faces;
  Point centre{};
  for (const Point& p : points) centre = centre + Rational(1, static_cast<long>(points.size())) * p;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Vector<Rational> normal = cross(points[j] - points[i], points[k] - points[i]);
        int above = 0;
        int below = 0;
        for (const Point& p : points) {
          const int sign = dot(normal, p - points[i]).sign();
          above += sign > 0 ? 1 : 0;
          below += sign < 0 ? 1 : 0;
        }
        if (above + below != static_cast<int>(points.size()) - 3) return {};
        if (above == 0 || below == 0) faces.push_back(facing(points[i], points[j], points[k], centre));
      }
  return faces;
}

void expect_closure(const std::vector<PlanePolygon>& faces, double radius) {
  for (const PlanePolygon& from : faces) {
    Ball sum = 0;
    for (const PlanePolygon& to : faces) sum += polygon_to_polygon(from, to);
    EXPECT_TRUE(same_number(sum, 1, radius)) << text(from);
  }
}

TEST(PolygonToPolygon, HasTheKnownValues) {
  const auto opposed = [](const Rational& h) {
    const std::vector<PlanePolygon> faces = box_faces(1, 1, h);
    return polygon_to_polygon(faces[0], faces[1]);
  };
  EXPECT_TRUE(has_digits(opposed(1), "0.19982489569838738304"));
  EXPECT_TRUE(has_digits(opposed(Rational(1, 2)), "0.41525328357714673537"));
  EXPECT_TRUE(has_digits(opposed(2), "0.06858958881855244779"));
  const std::vector<PlanePolygon> cube = box_faces(1, 1, 1);
  for (std::size_t k = 2; k < 6; ++k)
    EXPECT_TRUE(has_digits(polygon_to_polygon(cube[0], cube[k]), "0.20004377607540315424"));
  EXPECT_TRUE(same_number(4 * polygon_to_polygon(cube[0], cube[2]) + polygon_to_polygon(cube[0], cube[1]), 1,
                          narrow));

  const std::array<Point, 4> regular{Point{0, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}};
  const PlanePolygon first = facing(regular[0], regular[1], regular[2], regular[3]);
  const PlanePolygon second = facing(regular[0], regular[1], regular[3], regular[2]);
  EXPECT_TRUE(same_number(polygon_to_polygon(first, second), Ball(Rational(1, 3)), narrow));

  const std::array<Point, 4> corner{Point{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const PlanePolygon leg = facing(corner[0], corner[1], corner[2], corner[3]);
  const PlanePolygon other_leg = facing(corner[0], corner[1], corner[3], corner[2]);
  const PlanePolygon slope = facing(corner[1], corner[2], corner[3], corner[0]);
  EXPECT_TRUE(same_number(polygon_to_polygon(leg, other_leg), (3 - sqrt(Ball(3))) / 6, narrow));
  EXPECT_TRUE(same_number(polygon_to_polygon(slope, leg), Ball(Rational(1, 3)), narrow));
}

TEST(PolygonToPolygon, ClosesAroundConvexPolyhedra) {
  expect_closure(box_faces(1, 2, Rational(1, 3)), narrow);
  expect_closure(box_faces(1, Rational(1, 1000), 50), 1e-25);
  // The octahedron: faces that meet along an edge, at a corner, and opposite ones.
  std::vector<PlanePolygon> octahedron;
  for (const int x : {-1, 1})
    for (const int y : {-1, 1})
      for (const int z : {-1, 1}) octahedron.push_back(facing({x, 0, 0}, {0, y, 0}, {0, 0, z}, {0, 0, 0}));
  expect_closure(octahedron, narrow);
  Stream stream(11);
  int closed = 0;
  for (int k = 0; k < 12; ++k) {
    std::vector<Point> points;
    for (long n = 0; n < 4 + k % 3; ++n) points.push_back(stream.point());
    const std::vector<PlanePolygon> faces = hull_faces(points);
    if (faces.empty()) continue;
    ++closed;
    expect_closure(faces, 1e-24);
  }
  EXPECT_GE(closed, 6);
}

// Two triangles, with corners at hand.
struct Pair {
  std::array<Point, 3> from_corners;
  std::array<Point, 3> to_corners;
  PlanePolygon from;
  PlanePolygon to;
};

// Two triangles far apart, turned to each other's first corner, that may lie across each other's planes.
Pair random_far_pair(Stream& stream) {
  for (;;) {
    const Point apart{20, 0, 0};
    std::array<Point, 3> a{stream.point(), stream.point(), stream.point()};
    std::array<Point, 3> b{apart + stream.point(), apart + stream.point(), apart + stream.point()};
    const Vector<Rational> n_a = cross(a[1] - a[0], a[2] - a[0]);
    const Vector<Rational> n_b = cross(b[1] - b[0], b[2] - b[0]);
    if (dot(n_a, b[0] - a[0]).sign() == 0 || dot(n_b, a[0] - b[0]).sign() == 0) continue;
    return {a, b, facing(a[0], a[1], a[2], b[0]), facing(b[0], b[1], b[2], a[0])};
  }
}

bool lies_before(const std::array<Point, 3>& corners, const PlanePolygon& plane) {
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Point& p) { return dot(plane.normal(), p - plane.origin()).sign() > 0; });
}

bool see_each_other_whole(const Pair& pair) {
  return lies_before(pair.from_corners, pair.to) && lies_before(pair.to_corners, pair.from);
}

Pair random_pair(Stream& stream) {
  for (;;) {
    Pair pair = random_far_pair(stream);
    if (see_each_other_whole(pair)) return pair;
  }
}

Vector<double> nearest(const Point& p) { return {p.x.to_double(), p.y.to_double(), p.z.to_double()}; }

// The double integral itself, by a product rule.
double by_quadrature(const Pair& pair) {
  static const std::vector<std::pair<double, double>> rule = gauss_legendre(14);
  struct Sample {
    Vector<double> point;
    double weight;
  };
  const auto samples = [](const std::array<Point, 3>& corners) {
    const Vector<double> origin = nearest(corners[0]);
    const Vector<double> first = nearest(corners[1] - corners[0]);
    const Vector<double> second = nearest(corners[2] - corners[1]);
    std::vector<Sample> all;
    for (const auto& [s, s_weight] : rule)
      for (const auto& [t, t_weight] : rule)
        all.push_back({origin + s * first + (s * t) * second, s * s_weight * t_weight});
    return all;
  };
  const Vector<double> n_1 = nearest(pair.from.normal());
  const Vector<double> n_2 = nearest(pair.to.normal());
  const std::vector<Sample> to = samples(pair.to_corners);
  double sum = 0;
  for (const Sample& p : samples(pair.from_corners))
    for (const Sample& q : to) {
      const Vector<double> d = q.point - p.point;
      sum += p.weight * q.weight * std::max(0.0, dot(d, n_1)) * std::max(0.0, -dot(d, n_2)) /
             (dot(d, d) * dot(d, d));
    }
  // dS = J ds dt with A = J/2, and J_1 cancels.
  const double j_2 =
      norm(nearest(cross(pair.to_corners[1] - pair.to_corners[0], pair.to_corners[2] - pair.to_corners[0])));
  return 2 * j_2 * sum / (norm(n_1) * norm(n_2) * std::numbers::pi);
}

TEST(PolygonToPolygon, IsTheDoubleIntegral) {
  Stream stream(5);
  for (int k = 0; k < 12; ++k) {
    const Pair pair = random_pair(stream);
    const double factor = polygon_to_polygon(pair.from, pair.to).to_double();
    EXPECT_NEAR(by_quadrature(pair), factor, 1e-9 * factor) << text(pair.from) << " to " << text(pair.to);
  }
}

TEST(PolygonToPolygon, IsTheDoubleIntegralAcrossThePlanes) {
  Stream stream(12);
  int across = 0;
  while (across < 12) {
    const Pair pair = random_far_pair(stream);
    if (see_each_other_whole(pair)) continue;
    ++across;
    const double factor = polygon_to_polygon(pair.from, pair.to).to_double();
    // The integrand has a kink where a triangle crosses the other's plane.
    EXPECT_NEAR(by_quadrature(pair), factor, 2e-2 * factor + 1e-6)
        << text(pair.from) << " to " << text(pair.to);
  }
}

TEST(PolygonToPolygon, IsReciprocal) {
  Stream stream(6);
  for (int k = 0; k < 10; ++k) {
    const Pair pair = random_pair(stream);
    EXPECT_TRUE(same_number(area(pair.from) * polygon_to_polygon(pair.from, pair.to),
                            area(pair.to) * polygon_to_polygon(pair.to, pair.from), 1e-26))
        << text(pair.from) << " to " << text(pair.to);
  }
  // In any position: in front, behind, across each other's planes, with corners in common.
  for (int k = 0; k < 40; ++k) {
    const Point shared = stream.point();
    std::array<Point, 5> p{stream.point(), stream.point(), stream.point(), stream.point(), stream.point()};
    if (k % 2 == 0) p[3] = p[0];
    if (k % 4 == 0) p[4] = p[1];
    if (cross(p[1] - p[0], p[2] - p[0]) == Point{} || cross(p[3] - shared, p[4] - shared) == Point{})
      continue;
    const PlanePolygon a = polygon({p[0], p[1], p[2]});
    const PlanePolygon b = polygon({shared, p[3], p[4]});
    const Ball forth = polygon_to_polygon(a, b);
    EXPECT_TRUE(same_number(area(a) * forth, area(b) * polygon_to_polygon(b, a), 1e-24))
        << text(a) << " to " << text(b);
    EXPECT_GE(forth.upper_double(), 0);
    EXPECT_LE(forth.lower_double(), 1);
  }
}

TEST(PolygonToPolygon, IsAdditive) {
  Stream stream(7);
  for (int k = 0; k < 8; ++k) {
    const Pair pair = random_pair(stream);
    const auto& [a, b, c] = pair.to_corners;
    const Point middle = b + Rational(1 + stream.below(8), 10) * (c - b);
    const PlanePolygon one = facing(a, b, middle, pair.from_corners[0]);
    const PlanePolygon two = facing(a, middle, c, pair.from_corners[0]);
    EXPECT_TRUE(same_number(polygon_to_polygon(pair.from, pair.to),
                            polygon_to_polygon(pair.from, one) + polygon_to_polygon(pair.from, two), 1e-26))
        << text(pair.from) << " to " << text(pair.to);
    EXPECT_TRUE(same_number(
        area(pair.to) * polygon_to_polygon(pair.to, pair.from),
        area(one) * polygon_to_polygon(one, pair.from) + area(two) * polygon_to_polygon(two, pair.from),
        1e-26))
        << text(pair.to) << " to " << text(pair.from);
  }
}

TEST(PolygonToPolygon, SubtractsHoles) {
  const PlanePolygon floor = polygon({{0, 0, 0}, {3, 0, 0}, {2, 2, 0}, {0, 3, 0}});
  const std::vector<Point> plate_corners{{0, 0, 1}, {0, 3, 2}, {3, 3, 2}, {3, 0, 1}};
  const PolygonLoop around{{0, 0}, {3, 0}, {3, 3}, {0, 3}};
  const PolygonLoop hole{{1, 1}, {2, 1}, {Rational(3, 2), 2}};
  // t along (1,0,0), s along (0,1,1/3): the inner normal points down.
  const auto in_the_plane = [](const PolygonLoop& outline, const std::vector<PolygonLoop>& holes) {
    std::vector<PolygonLoop> loops{outline};
    loops.insert(loops.end(), holes.begin(), holes.end());
    return plane_polygon({0, 0, 1}, {0, 1, Rational(1, 3)}, {1, 0, 0}, loops).value();
  };
  const PlanePolygon plate = polygon(plate_corners);
  const PlanePolygon pierced = in_the_plane(around, {hole});
  const PlanePolygon cover = in_the_plane(hole, {});
  EXPECT_TRUE(same_number(polygon_to_polygon(floor, plate),
                          polygon_to_polygon(floor, pierced) + polygon_to_polygon(floor, cover), narrow));
  EXPECT_TRUE(same_number(
      area(plate) * polygon_to_polygon(plate, floor),
      area(pierced) * polygon_to_polygon(pierced, floor) + area(cover) * polygon_to_polygon(cover, floor),
      1e-29));
}

TEST(PolygonToPolygon, KeepsWhatIsInFront) {
  const PlanePolygon floor = polygon({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  // A wall through the floor's plane counts from the plane upwards.
  const PlanePolygon wall = polygon({{0, 0, -1}, {0, 2, -1}, {0, 2, 1}, {0, 0, 1}});
  const PlanePolygon upper_wall = polygon({{0, 0, 0}, {0, 2, 0}, {0, 2, 1}, {0, 0, 1}});
  EXPECT_TRUE(same_number(polygon_to_polygon(floor, wall), polygon_to_polygon(floor, upper_wall), narrow));
  EXPECT_TRUE(
      same_number(2 * polygon_to_polygon(wall, floor), polygon_to_polygon(upper_wall, floor), narrow));
  // Two squares through each other's middle: a half of each sees a half of the other.
  const PlanePolygon upright = polygon({{1, 0, -1}, {1, 2, -1}, {1, 2, 1}, {1, 0, 1}});
  const PlanePolygon half_floor = polygon({{1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}});
  const PlanePolygon half_upright = polygon({{1, 0, 0}, {1, 2, 0}, {1, 2, 1}, {1, 0, 1}});
  EXPECT_TRUE(same_number(2 * polygon_to_polygon(floor, upright),
                          polygon_to_polygon(half_floor, half_upright), narrow));
  // A comb with two teeth above the floor, and one with its back above.
  const PolygonLoop comb{
      {0, -1}, {2, -1}, {2, 1}, {Rational(3, 2), 1}, {1, Rational(-1, 2)}, {Rational(1, 2), 1}, {0, 1}};
  const PlanePolygon teeth = plane_polygon({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {comb}).value();
  const Rational left(5, 6);
  const PlanePolygon near_tooth = polygon({{0, 0, 0}, {0, left, 0}, {0, Rational(1, 2), 1}, {0, 0, 1}});
  const PlanePolygon far_tooth = polygon({{0, 2 - left, 0}, {0, 2, 0}, {0, 2, 1}, {0, Rational(3, 2), 1}});
  EXPECT_TRUE(same_number(polygon_to_polygon(floor, teeth),
                          polygon_to_polygon(floor, near_tooth) + polygon_to_polygon(floor, far_tooth),
                          narrow));
}

TEST(PolygonToPolygon, IsExactlyZeroWhereNothingIsInFront) {
  const std::vector<Point> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Point> above{{0, 0, 1}, {1, 0, 1}, {1, 1, 2}, {0, 1, 1}};
  const std::vector<Point> level{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const PlanePolygon floor = polygon(square);
  const auto expect_zero = [](const PlanePolygon& from, const PlanePolygon& to) {
    EXPECT_TRUE(certainly_zero(polygon_to_polygon(from, to))) << text(from) << " to " << text(to);
  };
  EXPECT_FALSE(plane_polygon(above).has_value());
  expect_zero(floor, polygon(level));                // turned away
  expect_zero(turned_over(square), polygon(level));  // behind
  expect_zero(turned_over(square), turned_over(level));
  EXPECT_FALSE(certainly_zero(polygon_to_polygon(floor, turned_over(level))));
  expect_zero(floor, floor);
  expect_zero(floor, turned_over(square));
  expect_zero(floor, polygon({{1, 0, 0}, {2, 0, 0}, {2, 1, 0}}));   // beside, an edge in common
  expect_zero(floor, polygon({{1, 1, 0}, {2, 1, 0}, {2, 2, 0}}));   // beside, a corner in common
  expect_zero(floor, polygon({{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}));  // below, an edge in common
  expect_zero(floor, polygon({{0, 0, 0}, {1, 3, -1}, {0, 3, -1}}));
  expect_zero(floor, polygon({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}));  // an upright triangle seen from outside
}

TEST(PolygonToPolygon, DoesNotChangeWithPositionAndSize) {
  Stream stream(8);
  const Rational c(3, 5);
  const Rational s(4, 5);
  const auto moved = [&](const Point& p) {
    const Point turned{c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    const Point again{turned.x, c * turned.y - s * turned.z, s * turned.y + c * turned.z};
    return Rational(7, 3) * again + Point{100, -3, Rational(1, 7)};
  };
  for (int k = 0; k < 6; ++k) {
    const Pair pair = random_pair(stream);
    const auto& a = pair.from_corners;
    const auto& b = pair.to_corners;
    const Ball factor = polygon_to_polygon(pair.from, pair.to);
    EXPECT_TRUE(same_number(factor,
                            polygon_to_polygon(facing(moved(a[0]), moved(a[1]), moved(a[2]), moved(b[0])),
                                               facing(moved(b[0]), moved(b[1]), moved(b[2]), moved(a[0]))),
                            1e-26))
        << text(pair.from) << " to " << text(pair.to);
  }
}

TEST(PolygonToPolygon, ReachesTheRadiusDemanded) {
  Stream stream(9);
  const Pair pair = random_pair(stream);
  const Rational radius = power(Rational(1, 10), 60);
  const Ball factor = polygon_to_polygon_within(pair.from, pair.to, radius).value();
  EXPECT_LE(factor.radius(), 1e-60);
  EXPECT_TRUE(overlaps(factor, polygon_to_polygon(pair.from, pair.to)));
  EXPECT_THROW((void)polygon_to_polygon_within(pair.from, pair.to, 0), ContractViolation);
  const std::vector<PlanePolygon> cube = box_faces(1, 1, 1);
  EXPECT_FALSE(polygon_to_polygon_within(cube[0], cube[1], power(Rational(1, 2), 40000)).has_value());
}

}  // namespace
}  // namespace radcert
