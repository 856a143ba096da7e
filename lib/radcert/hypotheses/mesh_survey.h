// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "radcert/geometry/mesh_defects.h"
#include "radcert/geometry/mesh_file/face_triangulation.h"
#include "radcert/geometry/mesh_quality.h"
#include "radcert/geometry/mesh_repair.h"
#include "radcert/geometry/mesh_topology.h"
#include "radcert/geometry/plane_classes.h"
#include "radcert/geometry/smooth_components.h"
#include "radcert/hypotheses/convex_containment.h"
#include "radcert/hypotheses/front.h"

namespace radcert {

/// A mesh file with all that radcert decides about it.
/// Maths     see the parts
/// Result    defects, topology and the rest are those of the mesh after what was asked to be mended.
///           components, planes and certificate are there only where no triangle is degenerate; front tells
///           where the inner normals point
struct MeshSurvey {
  std::string format;
  CoordinatePrecision precision;
  std::string digest;
  std::size_t file_vertices = 0;
  std::size_t file_faces = 0;
  std::size_t joined_corners = 0;
  std::size_t cut_faces = 0;
  std::vector<std::size_t> bent_faces;
  double degrees_turned = 0;  ///< by repair.align: coordinates are not the file's any more
  std::vector<std::string> mended;
  std::vector<std::string> remarks;  ///< what looks like a slip and was left as it is
  TriangleMesh mesh;
  MeshTopology topology;
  MeshDefects defects;
  MeshQuality quality;
  double degrees = 0;
  MeshFront front;
  /// Whether an open mesh looks away from its hull, as its file has it: then nothing sees anything.
  bool looks_away = false;
  std::optional<SmoothComponents> components;
  std::vector<std::string> pieces;  ///< names, in the order of components->of_piece
  std::optional<PlaneClasses> planes;
  ConvexContainment containment;

  /// The defect that keeps the mesh from being a surface for radiosity, if there is one.
  [[nodiscard]] std::optional<std::string> obstacle() const;
  /// Whether that is for want of a rule that says which side is the inner one.
  [[nodiscard]] bool needs_front() const;
  /// The mesh as a surface. Requires components, else ContractViolation.
  [[nodiscard]] Surface surface(const std::string& name) const;

private:
  [[nodiscard]] std::optional<std::string> fault_of_triangles() const;
};

/// The default angle beyond which an edge is sharp.
inline constexpr double default_sharp_degrees = 30;

/// Reads a mesh file and decides everything about it.
/// Maths     see MeshSurvey
/// Requires  0 <= degrees <= 180
/// Result    rule: see mesh_front. two_sided: groups whose triangles have a second front, on their back:
///           there a triangle that runs the other way is added, of the group "NAME back"; defects are those
///           without these. InputError, with the file, for what read_mesh_file refuses, for a face that is
///           not plane unless repair.triangulate cuts it, for a surface that is not orientable, and for a
///           mesh of which mending leaves nothing
[[nodiscard]] MeshSurvey survey_mesh(const std::filesystem::path& path, double degrees,
                                     const MeshRepair& repair, FrontRule rule = FrontRule::automatic,
                                     const std::vector<std::string>& two_sided = {});

/// The same for a file that was read.
[[nodiscard]] MeshSurvey survey_mesh(const MeshFile& file, double degrees, const MeshRepair& repair,
                                     FrontRule rule = FrontRule::automatic,
                                     const std::vector<std::string>& two_sided = {});

}  // namespace radcert
