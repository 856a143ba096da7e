// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "radcert/scalar/mpfr_real.h"
#include "radcert/scalar/rational.h"
#include "radcert/scalar/real.h"

namespace radcert::verification::psg10 {

/// A sphere above a disk, with the centre on the disk's axis, and light that falls parallel to the axis.
/// Maths     sphere: |x - (0,0,height)| = radius; disk: z = 0, distance from the axis <= disk_radius, lit and
///           lighting on its upper side; both reflect the share `albedo` of what arrives; `intensity`: the
///           power per area that a plane across the light receives
/// Source    [psg10, section VIII]: r, R, h, beta, mu
/// Requires  see allows()
/// Result    plain data; the defaults are those of the paper
struct SphereOverDiskScene {
  Rational radius = 5;
  Rational disk_radius = 40;
  Rational height = 20;
  Rational albedo = Rational(9, 10);
  Rational intensity = Rational(9, 10);
};

/// Whether 0 < radius < height, radius < disk_radius, 0 <= albedo < 1 and 0 <= intensity.
[[nodiscard]] bool allows(const SphereOverDiskScene& scene);

/// The scene's numbers in an arithmetic.
template <Real R>
struct SceneNumbers {
  R radius;
  R disk_radius;
  R height;
  R albedo;
  R intensity;
  explicit SceneNumbers(const SphereOverDiskScene& scene)
      : radius(from_rational<R>(scene.radius)),
        disk_radius(from_rational<R>(scene.disk_radius)),
        height(from_rational<R>(scene.height)),
        albedo(from_rational<R>(scene.albedo)),
        intensity(from_rational<R>(scene.intensity)) {}
};

/// The kernel between a point of the disk and a point of the sphere, integrated over the azimuth between
/// them.
/// Maths     k(u,t) = Int max(0, cos cos')/(pi d^2) dtau over a full turn, u: distance of the disk's point
///           from the axis, t: sine of the latitude of the sphere's. With a = u sqrt(1 - t^2), b = h t + r
///           the sphere's point is seen where a cos tau > b: nowhere for b >= a, everywhere for b <= -a, else
///           for |tau| < tau_0, cos tau_0 = b/a. With T^2 = u^2 + h^2 - r^2 the squared distance is d^2 = T^2
///           - 2 r (a cos tau - b) = A - B cos tau, A = T^2 + 2 r b, B = 2 r a, and with Delta = A^2 - B^2, k
///           = 2 (h + r t)/(pi Delta) {[2 r (a^2 - b^2) - b T^2] I + w},  I = Int_0^tau_0 dtau/(A - B cos
///           tau), w = sqrt(a^2 - b^2), I = 2/sqrt(Delta) atan sqrt((A + B)(a - b)/((A - B)(a + b)));  seen
///           everywhere: w = 0, I = pi/sqrt(Delta)
/// Source    [psg10, (21)]; cos cos' = (h + r t)(a cos tau - b)/d^2, numerator = (T^2 - d^2)/(2 r), and
///           Delta Int dtau/d^4 = A I + B sin tau_0/d^2(tau_0), where d^2(tau_0) = T^2
/// Requires  0 <= u, -1 <= t <= 1
/// Result    rounded; the absolute error is a few units of rounding of the largest term
/// Limits    arithmetics with an order: double, Mpfr. k has bounded first derivatives; across b = a and b =
///           -a it goes with the power 3/2
template <Real R>
[[nodiscard]] R azimuth_kernel(const SceneNumbers<R>& scene, const R& u, const R& t);

/// Where the tangent plane of a parallel of the sphere touches a circle of the disk, and the other way round.
/// Maths     the roots t_- <= t_+ of h t + r = -+u sqrt(1 - t^2): (-h r -+ u sqrt(h^2 + u^2 - r^2))/(h^2 +
///           u^2); from the circle u the parallels below t_- are seen all around, those above t_+ nowhere
/// Requires  0 <= u
/// Result    rounded
template <Real R>
struct HorizonLatitudes {
  R whole;  ///< t_-
  R last;   ///< t_+
};
template <Real R>
[[nodiscard]] HorizonLatitudes<R> horizon_latitudes(const SceneNumbers<R>& scene, const R& u);

/// A radiance in its parts: total = emission + indirect.
template <Real R>
struct Radiance {
  R emission;  ///< light scattered once, (20)
  R indirect;  ///< light scattered at least twice
  [[nodiscard]] R total() const { return emission + indirect; }
};

/// How finely the two equations are discretised.
struct SphereOverDiskRule {
  int nodes = 24;   ///< interpolation points of each panel
  int points = 32;  ///< Gauss points of each piece of an integral
};

/// The radiance of the sphere over the disk.
/// Maths     B(t) = B*(t) + beta Int_0^R D(u) k(u,t) u du,  D(u) = D*(u) + beta r^2 Int_-1^1 B(t) k(u,t) dt,
///           B* = beta mu max(0,t), D* = beta mu for r <= u <= R, else 0. In radiance as colour: a white
///           surface across the light has mu; a surface of albedo beta reflects beta of what arrives. Unknown
///           are the parts from light scattered twice or more. Panels end where they are not smooth: u = r, t
///           = 0 and the latitudes whose tangent planes touch the circles u = r and u = R; on each the
///           argument goes as sin^2(pi x/2), which makes powers with half-integer exponents at its ends
///           smooth in x, and the function is a polynomial in x through Chebyshev points. At these points the
///           equations are met (collocation); their integrals are cut at the panels' ends and at the horizon,
///           and go by Gauss' rule in an x of each piece; solved by Neumann's series. Off the nodes the
///           right-hand side is evaluated (Nystrom's interpolation)
/// Source    [psg10, (20)-(21)]
/// Requires  allows(scene), 2 <= nodes, 2 <= points <= 192, else ContractViolation
/// Result    rounded; how far it has converged shows by comparison with a finer rule. AccuracyNotReached
///           where Neumann's series has not come down to rounding after 12000 rounds: it contracts by less
///           than (radius/height)^2 albedo^2
/// Limits    nothing is proved. Where the sphere comes close to the disk, (height - radius)/radius << 1, more
///           nodes are needed. Arithmetics: double, Mpfr<50>
template <Real R>
class SphereOverDisk {
public:
  SphereOverDisk(const SphereOverDiskScene& scene, const SphereOverDiskRule& rule);

  /// At the sine of a latitude, -1 <= t <= 1.
  [[nodiscard]] Radiance<R> sphere(const R& t) const;
  /// At a distance from the axis, 0 <= u <= disk_radius; at u = radius the lit side.
  [[nodiscard]] Radiance<R> disk(const R& u) const;

  /// The parts that are not smooth across: -1, ..., 1 on the sphere; 0, radius, disk_radius.
  [[nodiscard]] const std::vector<R>& latitudes() const { return latitudes_; }
  [[nodiscard]] const std::array<R, 3>& distances() const { return distances_; }
  [[nodiscard]] const SceneNumbers<R>& scene() const { return scene_; }
  /// The rounds of Neumann's series that it took, each over the sphere and the disk.
  [[nodiscard]] int rounds() const { return rounds_; }

private:
  /// A polynomial in x on one panel.
  struct Panel {
    R from;
    R to;
    std::vector<R> values;
  };
  struct Sample {
    R place;
    R weight;
    std::size_t panel;
  };

  [[nodiscard]] std::vector<Sample> seen_from_sphere(const R& t) const;
  [[nodiscard]] std::vector<Sample> seen_from_disk(const R& u) const;
  void add_piece(const R& from, const R& to, std::size_t panel, std::vector<Sample>& samples) const;
  [[nodiscard]] R node(const Panel& panel, std::size_t j) const;
  [[nodiscard]] R angle(const Panel& panel, const R& place) const;
  [[nodiscard]] std::vector<R> lagrange(const Panel& panel, const R& place) const;
  [[nodiscard]] R value(const Panel& panel, const R& place) const;
  void solve();

  SceneNumbers<R> scene_;
  std::vector<R> latitudes_;
  std::array<R, 3> distances_;
  std::vector<R> nodes_;        ///< Chebyshev points of (0,1)
  std::vector<R> barycentric_;  ///< their weights in the barycentric formula
  std::vector<R> squared_sines_;
  std::vector<R> gauss_weights_;  ///< with the derivative of sin^2(pi x/2)
  std::vector<Panel> sphere_;     ///< the indirect part, panel by panel
  std::vector<Panel> disk_;
  int rounds_ = 0;
};

extern template double azimuth_kernel<double>(const SceneNumbers<double>&, const double&, const double&);
extern template Mpfr<50> azimuth_kernel<Mpfr<50>>(const SceneNumbers<Mpfr<50>>&, const Mpfr<50>&,
                                                  const Mpfr<50>&);
extern template HorizonLatitudes<double> horizon_latitudes<double>(const SceneNumbers<double>&,
                                                                   const double&);
extern template HorizonLatitudes<Mpfr<50>> horizon_latitudes<Mpfr<50>>(const SceneNumbers<Mpfr<50>>&,
                                                                       const Mpfr<50>&);
extern template class SphereOverDisk<double>;
extern template class SphereOverDisk<Mpfr<50>>;

}  // namespace radcert::verification::psg10
