// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/scalar/ball.h"
#include "radcert/scalar/rational.h"

namespace radcert {

// The classical configuration factors F_12: the part of what surface 1 emits, everywhere alike and in all
// directions as Lambert's law has it, that arrives at surface 2. Each function encloses the exact value at
// the current precision; lengths are in any unit. [Howell] is J. R. Howell, A Catalog of
// Radiation Heat Transfer Configuration Factors; its numbers are given where the configuration has one.

/// Two equal rectangles, directly opposed.
/// Maths     with X = width/distance, Y = depth/distance:  F = 2/(pi X Y) ( log((1+X^2)(1+Y^2)/(1+X^2+Y^2))/2
///           - X atan X - Y atan Y + X sqrt(1+Y^2) atan(X/sqrt(1+Y^2)) + Y sqrt(1+X^2) atan(Y/sqrt(1+X^2)) )
/// Source    [Howell, C-11]
/// Requires  width, depth, distance > 0, else ContractViolation
/// Result    an enclosure, 0 < F < 1
/// Limits    a difference of large terms where the distance is large against either side
[[nodiscard]] Ball opposed_rectangles(const Rational& width, const Rational& depth, const Rational& distance);

/// Two rectangles at right angles with an edge in common.
/// Maths     with W = from_width/edge, H = to_width/edge, c^2 = W^2 + H^2:
///           F = 1/(pi W) ( W atan(1/W) + H atan(1/H) - c atan(1/c) + 1/4 log((1+W^2)(1+H^2)/(1+c^2))
///           + W^2/4 log(W^2 (1+c^2)/((1+W^2) c^2)) + H^2/4 log(H^2 (1+c^2)/((1+H^2) c^2)) )
/// Source    [Howell, C-14]
/// Requires  edge, from_width, to_width > 0, else ContractViolation
/// Result    an enclosure, 0 < F < 1/2
[[nodiscard]] Ball perpendicular_rectangles(const Rational& edge, const Rational& from_width,
                                            const Rational& to_width);

/// Two rectangles with an edge in common, at any angle between them.
/// Maths     with A = from_width/edge, B = to_width/edge, C^2 = A^2 + B^2 - 2 A B cos Phi:
///           F = 1/(4 pi A) ( g(A) + g(B) - g(C) + 2 cot Phi (S(1) - S(0)) )
///           g(x) = (1-x^2) log(1+x^2) + x^2 log x^2 + 4 x atan(1/x);  S(h) = T_h(A,B) + T_h(B,A),
///           T_h(p,q) = d/2 [tau log(rho^2+tau^2) + 2 rho atan(tau/rho)] + h^2 Lambda(tau),  d = p sin Phi,
///           rho^2 = d^2 + h^2, between tau = -p cos Phi and tau = q - p cos Phi; Lambda as in
///           polygon_to_polygon.cpp
/// Source    contour integral of the two outlines; [Howell, C-16] leaves one integral, which is S(1) - S(0)
///           here
/// Requires  edge, from_width, to_width > 0, -1 < cosine < 1; Phi in half turns: 0 < half_turns < 1; else
///           ContractViolation
/// Result    an enclosure, 0 < F < 1
/// Limits    digits are lost as Phi comes near 0 or pi
[[nodiscard]] Ball inclined_rectangles(const Rational& edge, const Rational& from_width,
                                       const Rational& to_width, const Rational& cosine);
[[nodiscard]] Ball inclined_rectangles_at_angle(const Rational& edge, const Rational& from_width,
                                                const Rational& to_width, const Rational& half_turns);

/// Two faces of the regular tetrahedron, and two of the three right-angled faces of the corner of a cube that
/// a plane cuts off at equal lengths.
/// Maths     1/3;  (3 - sqrt 3)/6
/// Source    closure and symmetry; reciprocity with the fourth face, of area sqrt(3) times that of the others
/// Result    an enclosure
[[nodiscard]] Ball regular_tetrahedron();
[[nodiscard]] Ball corner_tetrahedron();

/// Two parallel disks on one axis.
/// Maths     with X = r_1^2 + r_2^2 + h^2:  F = (X - sqrt(X^2 - 4 r_1^2 r_2^2)) / (2 r_1^2)
/// Source    [Howell, C-41]
/// Requires  from_radius, to_radius, distance > 0, else ContractViolation
/// Result    an enclosure, 0 < F < 1, without cancellation
[[nodiscard]] Ball coaxial_disks(const Rational& from_radius, const Rational& to_radius,
                                 const Rational& distance);

/// The inside of an open circular cylinder, to itself.
/// Maths     with H = length/(2 radius):  F = 1 + H - sqrt(1 + H^2)
/// Source    closure and reciprocity with the two disks that close it
/// Requires  radius, length > 0, else ContractViolation
/// Result    an enclosure, 0 < F < 1, without cancellation
[[nodiscard]] Ball cylinder_to_itself(const Rational& radius, const Rational& length);

/// Two circular cylinders on one axis, of equal length, one in the other: the inside of the outer to the
/// outside of the inner, and to itself past the inner.
/// Maths     with R = outer/inner, H = length/inner, s = sqrt(R^2-1), A = H^2 + R^2 - 1, B = H^2 - R^2 + 1:
///           F_21 = 1/R - 1/(pi R) ( 2 atan(s/H) - 1/(2H) [ 2 sqrt((A+2)^2 - 4R^2) atan(sqrt((RA-B)/(RA+B)))
///           + B atan(1/s) - pi A/2 ] )
///           F_22 = 1 - 1/R + 2/(pi R) atan(2s/H) - H/(2 pi R) ( q asin(y) - asin((R^2-2)/R^2) + (q-1) pi/2
///           ), q = sqrt(4R^2+H^2)/H, y = (4(R^2-1) + (R^2-2) H^2/R^2) / (H^2 + 4(R^2-1))
/// Source    [Howell, section C, concentric cylinders of equal finite length], with acos(B/A) = 2 atan(s/H),
///           acos(B/(RA)) = 2 atan(sqrt((RA-B)/(RA+B)))
/// Requires  0 < inner < outer, length > 0, else ContractViolation
/// Result    an enclosure, 0 < F < 1. What is left, 1 - F_21 - F_22, leaves through the open rings
/// Limits    a difference of large terms where the length is small against the outer radius
[[nodiscard]] Ball outer_cylinder_to_inner(const Rational& inner, const Rational& outer,
                                           const Rational& length);
[[nodiscard]] Ball outer_cylinder_to_itself(const Rational& inner, const Rational& outer,
                                            const Rational& length);

/// A sphere to a disk whose axis runs through its centre.
/// Maths     with R = disk_radius/distance:  F = (1 - 1/sqrt(1+R^2)) / 2, the solid angle of the disk over 4
///           pi
/// Source    [Howell, C-121]
/// Requires  disk_radius, distance > 0, else ContractViolation; distance from the sphere's centre
/// Result    an enclosure, 0 < F < 1/2, without cancellation
/// Limits    holds for every radius of the sphere up to the distance
[[nodiscard]] Ball sphere_to_coaxial_disk(const Rational& disk_radius, const Rational& distance);

/// Two concentric spheres: the outer to the inner.
/// Maths     (inner/outer)^2
/// Source    closure and reciprocity: the inner sphere sees nothing but the outer
/// Requires  0 < inner < outer, else ContractViolation
/// Result    an enclosure
[[nodiscard]] Ball outer_sphere_to_inner(const Rational& inner, const Rational& outer);

/// Two infinitely long strips of equal width, directly opposed.
/// Maths     with H = distance/width:  F = sqrt(1+H^2) - H
/// Source    [Howell, C-1]
/// Requires  width, distance > 0, else ContractViolation
/// Result    an enclosure, 0 < F < 1, without cancellation
[[nodiscard]] Ball opposed_strips(const Rational& width, const Rational& distance);

/// Two infinitely long strips with an edge in common: a groove.
/// Maths     F = (a + b - c)/(2a),  c^2 = a^2 + b^2 - 2 a b cos Phi;  1 - sin(Phi/2) where a = b
/// Source    Hottel's crossed strings; [Howell, C-2 and C-3]
/// Requires  from_width = a, to_width = b > 0, -1 < cosine < 1, else ContractViolation
/// Result    an enclosure, 0 < F < 1, without cancellation
[[nodiscard]] Ball inclined_strips(const Rational& from_width, const Rational& to_width,
                                   const Rational& cosine);

/// A plane element to a disk parallel to it, on the axis of the disk.
/// Maths     r^2/(r^2 + h^2)
/// Source    [Howell, section B]: the sine squared of the half angle
/// Requires  radius, distance > 0, else ContractViolation
/// Result    an enclosure
[[nodiscard]] Ball element_to_parallel_disk(const Rational& radius, const Rational& distance);

/// A plane element to a sphere straight above it.
/// Maths     (radius/distance)^2
/// Source    [Howell, section B]: the sine squared of the half angle
/// Requires  0 < radius <= distance, distance from the sphere's centre, else ContractViolation
/// Result    an enclosure
[[nodiscard]] Ball element_to_sphere(const Rational& radius, const Rational& distance);

}  // namespace radcert
