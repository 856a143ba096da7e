// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/meshless/meshless_choice.h"

namespace radcert {

RadialBasisChoice shepard_basis() {
  return {.mother = shepard_mother(),
          .distance = SiteDistance::normal_sensitive,
          .radius = {.neighbour = std::nullopt},
          .normalise = Normalisation::partition_of_unity};
}

RadialBasisChoice gaussian_basis() {
  return {.mother = gaussian_mother(),
          .distance = SiteDistance::normal_sensitive,
          .radius = {.neighbour = 10},
          .normalise = Normalisation::none};
}

RadialBasisChoice lehtinen_basis() {
  return {.mother = spline_mother(),
          .distance = SiteDistance::euclidean_with_normal_factor,
          .radius = {.neighbour = 10},
          .normalise = Normalisation::partition_of_unity};
}

std::string_view name(SiteDistance distance) {
  switch (distance) {
    case SiteDistance::normal_sensitive: return "normal_sensitive";
    case SiteDistance::euclidean_with_normal_factor: return "euclidean_with_normal_factor";
    case SiteDistance::euclidean: break;
  }
  return "euclidean";
}

std::string_view name(TooFewNeighbours too_few) {
  return too_few == TooFewNeighbours::refuse ? "refuse" : "farthest";
}

std::string_view name(Normalisation normalise) {
  return normalise == Normalisation::none ? "none" : "partition_of_unity";
}

}  // namespace radcert
