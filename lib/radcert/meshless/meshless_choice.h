// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "radcert/meshless/mother_function.h"

namespace radcert {

/// How far two sites are from each other, and what their normals do.
/// Maths     normal_sensitive: |p^ - q^| / max{0, p->.q->}, infinite where the normals are not within 90
///           degrees; euclidean_with_normal_factor: |p^ - q^|, and max{0, p->.q->} multiplies the element;
///           euclidean: |p^ - q^| alone
/// Source    [psg10, (15), (18), figure 5]; the print has the normals' arrows in place of the points
/// Limits    normal_sensitive is no metric: see tests/laws/meshless_laws.h
enum class SiteDistance : std::uint8_t { normal_sensitive, euclidean_with_normal_factor, euclidean };

/// The rule for a site from which fewer than m others are at a finite distance.
enum class TooFewNeighbours : std::uint8_t {
  refuse,
  farthest,  ///< take the farthest of those there are; refuse where there is none
};

/// The nominal radii alpha_i.
/// Maths     neighbour m: alpha_i is the distance of the m-th other site from p_i, so that m sites, p_i among
///           them, are nearer than alpha_i; absent (absolute): alpha_i = 1
/// Source    [psg10, section V], m = 10; (16) takes the absolute distance
/// Requires  m >= 1
/// Limits    with euclidean_with_normal_factor the m-th neighbour is that of the Euclidean distance, [psg10,
///           after (18)]. With normal_sensitive a small round part with few sites has radii far above its
///           size, or none: of 20 site sets of separation 3 on a sphere of radius 5 over a disk 4 have a site
///           without ten others
struct RadiusRule {
  std::optional<std::size_t> neighbour = 10;
  TooFewNeighbours too_few = TooFewNeighbours::refuse;
};

/// How the raw elements are normalised.
/// Maths     none: phi_i = psi_i;  partition_of_unity: phi_i = psi_i / sum_j psi_j
/// Source    [psg10, (11)]
enum class Normalisation : std::uint8_t { none, partition_of_unity };

/// The four choices that make a radial basis of sites.
/// Maths     psi_i(p) = Phi(||p, p_i|| / alpha_i), times max{0, p->.p_i->} where the distance says so
/// Source    [psg10, sections V and VI]
/// Result    plain data
struct RadialBasisChoice {
  MotherFunction mother = gaussian_mother();
  SiteDistance distance = SiteDistance::normal_sensitive;
  RadiusRule radius{};
  Normalisation normalise = Normalisation::none;
};

/// phi^S: [psg10, (16)].
[[nodiscard]] RadialBasisChoice shepard_basis();
/// phi^G: [psg10, (17)].
[[nodiscard]] RadialBasisChoice gaussian_basis();
/// phi^L: [psg10, (18)].
[[nodiscard]] RadialBasisChoice lehtinen_basis();

/// Sites with a least distance from each other, as many as find room.
struct PoissonDiskSites {
  double separation = 1;
  std::uint64_t seed = 1;
};

/// So many sites, each anywhere on the surface with equal chance by area.
struct UniformSites {
  std::size_t count = 1000;
  std::uint64_t seed = 1;
};

/// How the sites of a basis are chosen.
using SiteChoice = std::variant<PoissonDiskSites, UniformSites>;

/// All that a meshless basis on a surface is made of.
struct MeshlessChoice {
  RadialBasisChoice basis{};
  SiteChoice sites{};
};

/// The words of the file formats.
[[nodiscard]] std::string_view name(SiteDistance distance);
[[nodiscard]] std::string_view name(Normalisation normalise);
[[nodiscard]] std::string_view name(TooFewNeighbours too_few);

}  // namespace radcert
