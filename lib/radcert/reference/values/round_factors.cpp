// SPDX-License-Identifier: GPL-3.0-or-later

// Configuration factors of disks, cylinders, spheres and strips: the formula of the catalogue, and a single
// integral of the factor of an element, or of the kernel after the axial or azimuthal integrations.
#include "radcert/closed_form/factor_catalogue.h"
#include "radcert/reference/values/families.h"
#include "radcert/reference/values/line.h"

namespace radcert::reference::values {
namespace {

const std::string kernel_mean = "1/(pi A) Int Int cos cos / r^2";
constexpr int digits_of_a_line = 300;

/// An element at the distance x from the axis sees the disk with 1/2 (1 - (h^2 + x^2 - R^2) / sqrt((h^2 + x^2
/// + R^2)^2 - 4 R^2 x^2)).
Enclosure disks(const Arguments& a, const Demand& demand) {
  const auto f = [a]<class R>(const R& x) {
    const R to = in<R>(a[1] * a[1]);
    const R h = in<R>(a[2] * a[2]);
    const R sum = h + x * x + to;
    return x * (R(1) - (h + x * x - to) / sqrt(sum * sum - R(4) * to * x * x));
  };
  return times_integral(Ball(Rational(1) / (a[0] * a[0])), f, Ball(0), Ball(a[0]), demand);
}

/// The flux of a point source through the disk: h x / (h^2 + x^2)^(3/2) per ring, over 4 pi.
Enclosure sphere_and_disk(const Arguments& a, const Demand& demand) {
  const auto f = [a]<class R>(const R& x) {
    const R square = in<R>(a[1] * a[1]) + x * x;
    return x / (square * sqrt(square));
  };
  return times_integral(Ball(a[1] / Rational(2)), f, Ball(0), Ball(a[0]), demand);
}

/// An element of the wall at the distance z from the open end sees that end with (y^2 + 1/2)/sqrt(y^2 + 1) -
/// y, y = z/(2 r); the rest, but for the other end, is the wall.
Enclosure cylinder(const Arguments& a, const Demand& demand) {
  const auto f = [a]<class R>(const R& z) {
    const R y = z * in<R>(Rational(1) / (Rational(2) * a[0]));
    const R square = y * y;
    return R(1) - R(2) * ((square + R(1) / R(2)) / sqrt(square + R(1)) - y);
  };
  return times_integral(Ball(Rational(1) / a[1]), f, Ball(0), Ball(a[1]), demand);
}

/// The arc cosine of 1/q, q > 1.
Ball arc_of(const Rational& q) { return atan(sqrt(Ball(q * q - Rational(1)))); }

/// In units of the inner radius; the two axial integrations of 1/(d^2 + (z - z')^2)^2 give H atan(H/d)/d^3.
Enclosure outer_to_inner(const Arguments& a, const Demand& demand) {
  const auto f = [a]<class R>(const R& angle) {
    const R q = in<R>(a[0]);
    const R c = cos(angle);
    const R d = sqrt(q * q + R(1) - R(2) * q * c);
    return (q - c) * (q * c - R(1)) * atan(in<R>(a[1]) / d) / (d * d * d);
  };
  return times_integral(Ball(2) / Ball::pi(), f, Ball(0), arc_of(a[0]), demand);
}

/// Two points of the outer wall see each other up to an angle of 2 acos(inner/outer) between them.
Enclosure outer_to_itself(const Arguments& a, const Demand& demand) {
  const auto f = [a]<class R>(const R& angle) {
    const R sine = sin(angle / R(2));
    return sine * (pi<R>() / R(2) - atan(in<R>(Rational(2) * a[0] / a[1]) * sine));
  };
  return times_integral(Ball(1) / Ball::pi(), f, Ball(0), Ball(2) * arc_of(a[0]), demand);
}

/// From an element at the distance d of the centre of the unit sphere, facing it: the visible cap, by the
/// cosine c of the polar angle: 2 (d - c)(d c - 1) / (d^2 + 1 - 2 d c)^2.
Enclosure element_and_sphere(const Arguments& a, const Demand& demand) {
  const auto f = [a]<class R>(const R& c) {
    const R d = in<R>(a[0]);
    const R square = d * d + R(1) - R(2) * d * c;
    return (d - c) * (d * c - R(1)) / (square * square);
  };
  return times_integral(Ball(2), f, Ball(Rational(1) / a[0]), Ball(1), demand);
}

/// Strips: half the difference of the sines under which an element sees the ends of the other.
Enclosure strips_opposed(const Arguments& a, const Demand& demand) {
  const auto f = [a]<class R>(const R& x) { return x / sqrt(in<R>(a[1] * a[1]) + x * x); };
  return times_integral(Ball(Rational(1) / a[0]), f, Ball(0), Ball(a[0]), demand);
}
Enclosure strips_inclined(const Arguments& a, const Demand& demand) {
  const auto f = [a]<class R>(const R& x) {
    const R along = in<R>(a[1] * a[2]);
    return R(1) + (along - x) / sqrt(x * x + in<R>(a[1] * a[1]) - R(2) * x * along);
  };
  return times_integral(Ball(Rational(1) / (Rational(2) * a[0])), f, Ball(0), Ball(a[0]), demand);
}

/// x = distance^2 of a ring: h^2 / (h^2 + x)^2.
Enclosure element_and_disk(const Arguments& a, const Demand& demand) {
  const Rational square = a[1] * a[1];
  const auto f = [square]<class R>(const R& x) {
    const R sum = in<R>(square) + x;
    return R(1) / (sum * sum);
  };
  return times_integral(Ball(square), f, Ball(0), Ball(a[0] * a[0]), demand);
}

/// Rectangles with a common edge of length L at the angle Phi, D(t)^2 = 1 + t^2 - 2 t cos Phi. The
/// integrations along the edge give L atan(L/d)/d^3, and with s = t x those over x leave, for the wedge t <
/// b/a, t/D^3 (a atan(L/(a D)) + L/(2 D) log(1 + (a D/L)^2)), and the same with a and b exchanged for the
/// other.
Enclosure wedge(const Ball& factor, const Rational& own, const Rational& other, const Rational& edge,
                const Rational& half_turns, const Demand& demand) {
  const auto f = [=]<class R>(const R& t) {
    const R c = cos(pi<R>() * in<R>(half_turns));
    const R square = R(1) + t * t - R(2) * t * c;
    const R d = sqrt(square);
    const R a = in<R>(own);
    const R l = in<R>(edge);
    const R ratio = a / l * d;
    return t / (square * d) * (a * atan(R(1) / ratio) + l / (R(2) * d) * log(R(1) + ratio * ratio));
  };
  return times_integral(factor, f, Ball(0), Ball(other / own), demand);
}
Enclosure inclined(const Arguments& a, const Demand& demand) {
  const Ball sine = sin(Ball::pi() * Ball(a[3]));
  const Ball factor = sine * sine / (Ball::pi() * Ball(a[1]));
  return sum_of([&](const Demand& half) { return wedge(factor, a[1], a[2], a[0], a[3], half); },
                [&](const Demand& half) { return wedge(factor, a[2], a[1], a[0], a[3], half); }, demand);
}

ValueFamily family(std::string name, std::string summary, std::string source,
                   std::vector<ValueParameter> parameters, std::function<Ball(const Arguments&)> formula,
                   std::string how, std::function<Enclosure(const Arguments&, const Demand&)> integral) {
  return {.name = std::move(name),
          .summary = std::move(summary),
          .formula = kernel_mean,
          .source = source,
          .parameters = std::move(parameters),
          .route = by_formula("closed form, " + source, std::move(formula)),
          .second_route = by_integral(std::move(how), digits_of_a_line, std::move(integral))};
}

/// The ratio of an outer radius or a distance to the inner radius.
ValueParameter ratio(std::string name) {
  return {.name = std::move(name),
          .default_text = "2",
          .allowed = "a number > 1, in units of the inner radius",
          .allows = [](const Rational& x) { return x > Rational(1); }};
}

}  // namespace

Theme round_factors() {
  Theme theme;
  theme.families = {
      family(
          "inclined_rectangles",
          "configuration factor between two rectangles with an edge in common, at an angle of so many half "
          "turns",
          "Howell C-16",
          {positive("edge", "1"), positive("from_width", "1"), positive("to_width", "1"),
           strictly_between("half_turns", "1/3", 0, 1)},
          [](const Arguments& a) { return inclined_rectangles_at_angle(a[0], a[1], a[2], a[3]); },
          "single integral over the ratio of the distances from the edge", inclined),
      family(
          "coaxial_disks", "configuration factor between two parallel disks on one axis", "Howell C-41",
          {positive("from_radius", "1"), positive("to_radius", "1"), positive("distance", "1")},
          [](const Arguments& a) { return coaxial_disks(a[0], a[1], a[2]); },
          "integral of the factor of an element over the radius", disks),
      family(
          "sphere_to_coaxial_disk",
          "configuration factor from a sphere to a disk whose axis runs through its centre", "Howell C-121",
          {positive("disk_radius", "1"), positive("distance", "1")},
          [](const Arguments& a) { return sphere_to_coaxial_disk(a[0], a[1]); },
          "flux of a point source through rings of the disk", sphere_and_disk),
      family(
          "cylinder_to_itself", "configuration factor of the inside of an open cylinder to itself",
          "closure and reciprocity with the two disks at its ends",
          {positive("radius", "1"), positive("length", "1")},
          [](const Arguments& a) { return cylinder_to_itself(a[0], a[1]); },
          "integral of the factor of a wall element to the ends", cylinder),
      family(
          "opposed_strips", "configuration factor between two infinite strips, directly opposed",
          "Hottel's crossed strings; Howell C-1", {positive("width", "1"), positive("distance", "1")},
          [](const Arguments& a) { return opposed_strips(a[0], a[1]); },
          "integral of the sines under which an element sees the edges", strips_opposed),
      family(
          "inclined_strips", "configuration factor between two infinite strips with an edge in common",
          "Hottel's crossed strings; Howell C-2, C-3",
          {positive("from_width", "1"), positive("to_width", "1"), strictly_between("cosine", "1/2", -1, 1)},
          [](const Arguments& a) { return inclined_strips(a[0], a[1], a[2]); },
          "integral of the sines under which an element sees the edges", strips_inclined),
      family(
          "element_to_parallel_disk", "configuration factor from an element to a disk straight above it",
          "sine squared of the half angle", {positive("radius", "1"), positive("distance", "1")},
          [](const Arguments& a) { return element_to_parallel_disk(a[0], a[1]); },
          "integral over the squared radius", element_and_disk),
      family(
          "outer_cylinder_to_inner",
          "configuration factor between concentric cylinders of one length, from the outer to the inner",
          "Howell, section C, concentric cylinders", {ratio("outer"), positive("length", "1")},
          [](const Arguments& a) { return outer_cylinder_to_inner(1, a[0], a[1]); },
          "integral over the angle between the points, axial integrations in closed form", outer_to_inner),
      family(
          "outer_cylinder_to_itself",
          "configuration factor of the outer of two concentric cylinders to itself, past the inner",
          "Howell, section C, concentric cylinders", {ratio("outer"), positive("length", "1")},
          [](const Arguments& a) { return outer_cylinder_to_itself(1, a[0], a[1]); },
          "integral over the angle between the points, axial integrations in closed form", outer_to_itself),
      family(
          "outer_sphere_to_inner",
          "configuration factor between concentric spheres, from the outer to the inner",
          "closure and reciprocity", {ratio("outer")},
          [](const Arguments& a) { return outer_sphere_to_inner(1, a[0]); },
          "integral over the visible cap of the inner sphere", element_and_sphere),
      family(
          "element_to_sphere", "configuration factor from an element to a unit sphere that it faces",
          "sine squared of the half angle", {ratio("distance")},
          [](const Arguments& a) { return element_to_sphere(1, a[0]); },
          "integral over the visible cap of the sphere", element_and_sphere),
  };
  theme.named = {
      {"squares_common_edge_60_degrees", "inclined_rectangles", {1, 1, 1, Rational(1, 3)}},
      {"squares_common_edge_120_degrees", "inclined_rectangles", {1, 1, 1, Rational(2, 3)}},
      {"squares_common_edge_30_degrees", "inclined_rectangles", {1, 1, 1, Rational(1, 6)}},
      {"squares_common_edge_45_degrees", "inclined_rectangles", {1, 1, 1, Rational(1, 4)}},
      {"squares_common_edge_90_degrees", "inclined_rectangles", {1, 1, 1, Rational(1, 2)}},
      {"squares_common_edge_135_degrees", "inclined_rectangles", {1, 1, 1, Rational(3, 4)}},
      {"squares_common_edge_150_degrees", "inclined_rectangles", {1, 1, 1, Rational(5, 6)}},
      {"coaxial_disks_1_1_1", "coaxial_disks", {1, 1, 1}},
      {"coaxial_disks_1_2_1", "coaxial_disks", {1, 2, 1}},
      {"coaxial_disks_2_1_1", "coaxial_disks", {2, 1, 1}},
      {"coaxial_disks_1_1_10", "coaxial_disks", {1, 1, 10}},
      {"sphere_to_coaxial_disk_1_1/2", "sphere_to_coaxial_disk", {1, Rational(1, 2)}},
      {"sphere_to_coaxial_disk_1_1", "sphere_to_coaxial_disk", {1, 1}},
      {"cylinder_to_itself_1_1", "cylinder_to_itself", {1, 1}},
      {"cylinder_to_itself_1_2", "cylinder_to_itself", {1, 2}},
      {"cylinder_to_itself_1_10", "cylinder_to_itself", {1, 10}},
      {"opposed_strips_1_1", "opposed_strips", {1, 1}},
      {"groove_60_degrees", "inclined_strips", {1, 1, Rational(1, 2)}},
      {"groove_90_degrees", "inclined_strips", {1, 1, 0}},
      {"groove_120_degrees", "inclined_strips", {1, 1, Rational(-1, 2)}},
      {"element_to_parallel_disk_1_1", "element_to_parallel_disk", {1, 1}},
      {"concentric_cylinders_1_2_1_to_inner", "outer_cylinder_to_inner", {2, 1}},
      {"concentric_cylinders_1_2_1_to_itself", "outer_cylinder_to_itself", {2, 1}},
      {"concentric_cylinders_1_2_10_to_inner", "outer_cylinder_to_inner", {2, 10}},
      {"concentric_cylinders_1_2_10_to_itself", "outer_cylinder_to_itself", {2, 10}},
      {"concentric_spheres_1_2_to_inner", "outer_sphere_to_inner", {2}},
      {"element_to_sphere_distance_3", "element_to_sphere", {3}},
  };
  return theme;
}

}  // namespace radcert::reference::values
