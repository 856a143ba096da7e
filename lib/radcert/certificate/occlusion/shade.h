// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "radcert/certificate/densities.h"
#include "radcert/certificate/occlusion/sight.h"
#include "radcert/certificate/polyhedron_certificate.h"

namespace radcert::certificate {

/// What stands for light of which it is not known whether it arrives.
/// Maths     on a box T w_k = F_k + c_k (1 - F 1) + sum over shaded parts p of (1/pi) Int_p V G (w_k - c_k),
///           F the transport of what is seen, since T 1 = 1, for any numbers c_k, or functions of the point
///           between c_k -+ a number. (1/pi) Int_p V G is from 0 to the mass m_p, so that with w_k from l_p
///           to h_p on p the sum is from -D to U, U = sum m_p max(0, h_p - min c_k), D = sum m_p max(0, max
///           c_k - l_p); at most the largest of these differences each, as T 1 = 1: (U - D)/2 -+ (U + D)/2
/// Result    rounded outwards, by function
struct Shade {
  std::vector<double> constants;  ///< c_k
  std::vector<double> shifts;     ///< near (U - D)/2
  std::vector<double> radii;      ///< of T w_k - F_k - c_k (1 - F 1) - shifts[k]
  double largest_constant = 0;    ///< of |c_k|
  double largest_radius = 0;
};

/// The shades of what boxes of a certificate see.
/// Requires  all of it outlives this
class Shades {
public:
  Shades(const PolyhedronCertificate& certificate, const Densities& densities);

  /// Constants in the middle of what shaded parts send; 0 where there are none.
  [[nodiscard]] Shade of(std::span<const ShadedPart> shaded) const;
  /// Where c_k is w_k on the edge t = 0 of an element, from s0 to s1 there; parts on its face are left out,
  /// as T_j (w - xi) of EdgeClosing has them.
  [[nodiscard]] Shade at_edge(std::span<const ShadedPart> shaded, std::size_t element, double s0,
                              double s1) const;

private:
  /// w in the middle of parts, and how far it may be from that, by function.
  struct Values {
    std::vector<double> middle;
    std::vector<double> spread;
  };
  [[nodiscard]] Values values(std::size_t element, double s0, double s1, double t0, double t1) const;
  [[nodiscard]] Shade made(std::span<const ShadedPart> shaded, std::span<const Values> values,
                           std::vector<double> constants, std::span<const double> spread) const;

  const PolyhedronCertificate& certificate_;
  const Densities& densities_;
  std::vector<double> slope_x_;  ///< by element, function: of |dw/dx|, x in [-1,1]
  std::vector<double> slope_y_;
};

}  // namespace radcert::certificate
