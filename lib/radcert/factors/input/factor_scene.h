// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "radcert/core/option_name.h"
#include "radcert/factors/facet_scene.h"
#include "radcert/factors/factor_mesh.h"
#include "radcert/geometry/mesh_file/mesh_file.h"
#include "radcert/hypotheses/front.h"
#include "radcert/hypotheses/mesh_survey.h"
#include "radcert/surface/surface.h"

namespace radcert {

/// How a mesh is read as a scene of which factors are wanted.
struct FactorSceneChoice {
  std::vector<std::string> repair = {};     ///< of repair_words
  FrontRule front = FrontRule::automatic;   ///< where light travels
  std::vector<std::string> two_sided = {};  ///< groups that are plates: see survey_mesh
  bool space = false;                       ///< light may leave the scene
  double degrees = default_sharp_degrees;   ///< where normals make more, two pieces meet
};

/// A scene of which factors can be taken.
/// Requires  made by factor_scene
/// Result    scene: of mesh.mesh. identity: all that its factors depend on, beside units and demand
struct FactorScene {
  FactorMesh mesh;
  FacetScene scene;
  std::string identity;
  std::vector<std::string> mended;   ///< what was, in words
  std::vector<std::string> remarks;  ///< of survey_mesh
  std::string front = {};            ///< of a mesh where light travels: "right-hand" or "left-hand"
  bool open = false;                 ///< light leaves, and that was said to be meant
};

/// A mesh as a scene, or what makes factors of it meaningless.
/// Maths     refused are triangles without an area, crossing or overlapping ones, such as doubles cannot
///           carry (beyond_doubles), neighbours that run against each other, components that look away from
///           the light of the others, meshes that do not say where their light is, and scenes that light
///           leaves unless choice.space says so, or closed ones where it does
/// Source    survey_mesh, scene_faults
/// Requires  `name` and `style` for messages
/// Result    the scene; InputError with the name, or with the option that it is about
/// Limits    as survey_mesh
[[nodiscard]] FactorScene factor_scene(const std::string& name, const MeshFile& file,
                                       const FactorSceneChoice& choice, OptionStyle style);

/// A surface of the catalogue as a scene, each triangle cut into 4^level.
/// Requires  0 <= level
/// Result    as above; InputError for a surface that is curved. Rounded corners, see factor_mesh, are
///           remarked
[[nodiscard]] FactorScene factor_scene(const std::string& name, const Surface& surface, int level, bool space,
                                       OptionStyle style);

/// Refuses proved factors where the scene is not what it is called: its corners were rounded.
/// Requires  `name` and `style` for messages
/// Result    returns, or throws InputError at the option `certified`
void require_exact_corners(const std::string& name, const FactorScene& scene, OptionStyle style);

}  // namespace radcert
