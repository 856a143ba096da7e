// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/light_source.h"

#include <cmath>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

double radiance_of(const LightScene& scene, const ParallelLight& light, const LitPoint& at) {
  const double length = norm(light.towards);
  expects(length > 0 && std::isfinite(length) && std::isfinite(light.power), "a direction and a power",
          named("length", length), named("power", light.power));
  const Vector<double> unit = (1 / length) * light.towards;
  const double cosine = dot(at.site.normal, unit);
  if (!(cosine > 0)) return 0;
  // Beyond everything in the scene.
  if (!scene.visible(at, at.site.point + (4 * scene.reach()) * unit)) return 0;
  return scene.albedo(at.chart) * light.power * cosine;
}

double radiance_of(const LightScene& scene, const PointLight& light, const LitPoint& at) {
  expects(std::isfinite(light.intensity), "a finite intensity", named("intensity", light.intensity));
  const Vector<double> step = light.at - at.site.point;
  const double height = dot(at.site.normal, step);
  if (!(height > 0) || !scene.visible(at, light.at)) return 0;
  const double distance = norm(step);
  return scene.albedo(at.chart) * light.intensity * (height / distance) / (distance * distance);
}

double radiance_of(const LightScene&, const SurfaceEmission& light, const LitPoint& at) {
  return light.radiance(at);
}

}  // namespace

double direct_radiance(const LightScene& scene, const Light& light, const LitPoint& at) {
  const double radiance =
      std::visit([&](const auto& source) { return radiance_of(scene, source, at); }, light);
  expects(std::isfinite(radiance), "a finite radiance", named("radiance", radiance));
  return radiance;
}

}  // namespace radcert
