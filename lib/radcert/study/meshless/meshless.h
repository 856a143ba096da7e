// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "radcert/core/memory_plan.h"
#include "radcert/meshless/light_solution.h"
#include "radcert/meshless/meshless_choice.h"
#include "radcert/scalar/rational.h"
#include "radcert/study/operator_route.h"
#include "radcert/surface/surface.h"

namespace radcert {

struct Problem;
struct LevelOutcome;

/// Sites with a least distance from each other, level by level.
struct PoissonDiskLevels {
  Rational separation = 3;  ///< at level 0
  std::uint64_t seed = 1;
};

/// Sites anywhere, level by level.
struct UniformLevels {
  std::uint64_t count = 400;  ///< at level 0
  std::uint64_t seed = 1;
};

/// The sites of a problem at all its levels.
/// Maths     level k: separation 2^-k, or 4^k sites as many: the mean distance of neighbours halves from
///           level to level
/// Source    [psg10, section VIII]
/// Result    plain data; the same seed at every level
/// Limits    the sites of a level are not among those of the next
using SiteLevels = std::variant<UniformLevels, PoissonDiskLevels>;

/// Which words a problem used for its meshless basis.
enum class MeshlessFamily : std::uint8_t { shepard, gaussian, lehtinen, meshless };

/// A meshless basis, and how light is carried between its sites.
/// Maths     u_n = sum_j lambda_j phi_j, (I - R) lambda = epsilon, R = N or A^-1 N, N_ij = rho_i/pi
///           G(p_i,p_j) V(p_i,p_j) w_j
/// Source    [psg10, sections V to VII]
/// Result    plain data
struct Meshless {
  MeshlessFamily family = MeshlessFamily::meshless;
  RadialBasisChoice basis = shepard_basis();
  SiteLevels sites = UniformLevels{};
  WeightRule weights = WeightRule::integrated;
  CoefficientRule coefficients = CoefficientRule::as_values;
};

/// The word of the file format.
[[nodiscard]] std::string_view name(MeshlessFamily family);

/// One of the paper's three with its defaults. ContractViolation for MeshlessFamily::meshless, which has
/// none.
[[nodiscard]] Meshless basis_of(MeshlessFamily family);

/// The sites of a level. ContractViolation unless level >= 0; nothing where their number exceeds 2^53.
[[nodiscard]] std::optional<SiteChoice> sites_at_level(const SiteLevels& sites, int level);

/// How far neighbours are apart at a level.
/// Maths     the separation, or sqrt(area / count)
/// Requires  level >= 0, area > 0
/// Result    rounded; the h of a level
/// Limits    uniform sites may be as close as they like
[[nodiscard]] double site_spacing(const SiteLevels& sites, int level, double area);

/// The area of a surface.
/// Maths     Int_S dS by the rule of degree 3 on the cells of surface_cells.h
/// Result    rounded; exact but for that on plane charts
/// Limits    six digits or so on the curved charts of the catalogue
[[nodiscard]] double surface_area(const Surface& surface);

/// The memory of one level of a meshless problem.
/// Maths     n sites: R, its powers and the factors of I - R, with `interpolated` coefficients A and its
///           factors, 8 n^2 bytes each
/// Source    the loops of meshless and study
/// Result    bytes by item. Sites that are apart are counted as in the densest packing of a plane, area
///           2/(sqrt(3) separation^2)
/// Limits    what the standard library and the operating system add is not counted
[[nodiscard]] MemoryPlan meshless_plan(std::uint64_t sites, const Meshless& basis, bool is_direct);
[[nodiscard]] std::uint64_t planned_sites(const SiteLevels& sites, int level, double area);

/// Refuses what a meshless basis does not allow in a problem; see check(problem).
void check(const Problem& problem, const Meshless& method, const Surface& surface,
           std::uint64_t memory_limit);

/// Solves a problem with a meshless basis at one level.
/// Maths     (I - R) lambda = epsilon at the sites p_i, u_n = sum_j lambda_j phi_j; E = u - Ku at the sites
/// Source    [psg10, (6), (19), section VII]
/// Requires  a checked problem with this method
/// Result    node_error = max over the sites of |u - u_n|; uniform_error over the points that collocation at
///           this level looks at; discretisation_error is absent: point lights are no K(I-P_n). elements and
///           unknowns: sites; mesh_size: site_spacing. The same bits for any number of threads. Throws
///           InputError at the place in /basis that leaves no basis, or where a point of S has no site in
///           reach, at /reflectivity for an albedo from 1; AccuracyNotReached where the reflections would
///           grow; Interrupted when asked to stop
/// Limits    radii are estimates, of the route, of integrated weights as if their errors were independent,
///           of the solver, of what interpolation leaves at the sites, and of the sums there. On an open
///           surface norm_K is an estimate from the point lights, at most the largest reflectivity
[[nodiscard]] LevelOutcome solve(const Problem& problem, const Meshless& method, int level,
                                 const OperatorRoute& route);

}  // namespace radcert
