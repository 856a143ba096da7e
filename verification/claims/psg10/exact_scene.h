// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "radcert/geometry/vector.h"
#include "verification/claims/psg10/sphere_over_disk/solution.h"

namespace radcert::verification::psg10 {

/// (cos, sin) of an angle, exactly.
struct Direction {
  Rational cosine;
  Rational sine;
};

/// Points of the sphere over the disk with rational coordinates.
/// Maths     ((1 - w^2)/(1 + w^2), 2w/(1 + w^2)) is on the unit circle; latitudes and azimuths that way
/// Source    the scene: [psg10, section VIII]
/// Result    exact; the same on every run
/// Limits    azimuths leave out pi
class ExactScene {
public:
  explicit ExactScene(unsigned long seed) : bits_(seed) {}

  /// A point on the unit circle; on_right: with a positive cosine.
  Direction direction(bool on_right) {
    const long numerator = static_cast<long>(bits_() % 2001) - 1000;
    const Rational w(numerator, on_right ? 1001 : static_cast<long>(1 + bits_() % 1000));
    const Rational square = w * w;
    return {(Rational(1) - square) / (Rational(1) + square), Rational(2) * w / (Rational(1) + square)};
  }
  /// The outer normal at a latitude and an azimuth.
  static Vector<Rational> normal(const Direction& latitude, const Direction& azimuth) {
    return {latitude.cosine * azimuth.cosine, latitude.cosine * azimuth.sine, latitude.sine};
  }
  [[nodiscard]] Vector<Rational> centre() const { return {0, 0, scene_.height}; }
  [[nodiscard]] Vector<Rational> on_sphere(const Vector<Rational>& normal) const {
    return centre() + scene_.radius * normal;
  }
  /// A distance from the axis, the centre, the shadow's rim and the disk's own among them.
  Rational distance() {
    switch (bits_() % 8) {
      case 0: return 0;
      case 1: return scene_.radius;
      case 2: return scene_.disk_radius;
      default: return scene_.disk_radius * Rational(static_cast<long>(bits_() % 1001), 1000);
    }
  }
  static Vector<Rational> on_disk(const Rational& distance, const Direction& azimuth) {
    return {distance * azimuth.cosine, distance * azimuth.sine, 0};
  }
  [[nodiscard]] const SphereOverDiskScene& numbers() const { return scene_; }

private:
  std::mt19937_64 bits_;
  SphereOverDiskScene scene_;
};

}  // namespace radcert::verification::psg10
