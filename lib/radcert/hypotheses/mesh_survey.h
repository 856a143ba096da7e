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

namespace radcert {

/// How the inner side of a mesh was found.
enum class InnerSide {
  by_volume,       ///< the mesh is closed: the side of the body
  by_certificate,  ///< it is open and lies in the boundary of its convex hull: the side of the hull
  by_convention,   ///< neither: triangles are taken to run counterclockwise as seen from outside
};

/// A mesh file with all that radcert decides about it.
/// Maths     see the parts
/// Result    defects, topology and the rest are those of the mesh after what was asked to be mended.
///           components, planes and certificate are there only where no triangle is degenerate; orientation
///           tells where the inner normals point; misoriented: of closed meshes without other faults
struct MeshSurvey {
  std::string format;
  CoordinatePrecision precision;
  std::string digest;
  std::size_t file_vertices = 0;
  std::size_t file_faces = 0;
  std::size_t joined_corners = 0;
  std::size_t cut_faces = 0;
  std::vector<std::size_t> bent_faces;
  std::vector<std::string> mended;
  TriangleMesh mesh;
  MeshTopology topology;
  MeshDefects defects;
  std::vector<std::size_t> misoriented;  ///< first triangles of components: see misoriented_components
  MeshQuality quality;
  double degrees = 0;
  Orientation orientation = Orientation::against_the_cross_product;
  InnerSide inner_side = InnerSide::by_convention;
  std::optional<SmoothComponents> components;
  std::vector<std::string> pieces;  ///< names, in the order of components->of_piece
  std::optional<PlaneClasses> planes;
  ConvexContainment containment;

  /// The defect that keeps the mesh from being a surface for radiosity, if there is one.
  [[nodiscard]] std::optional<std::string> obstacle() const;
  /// The mesh as a surface. Requires components, else ContractViolation.
  [[nodiscard]] Surface surface(const std::string& name) const;
};

/// The default angle beyond which an edge is sharp.
inline constexpr double default_sharp_degrees = 30;

/// Reads a mesh file and decides everything about it.
/// Maths     see MeshSurvey
/// Requires  0 <= degrees <= 180
/// Result    InputError, with the file, for what read_mesh_file refuses, for a face that is not plane unless
///           repair.triangulate cuts it, for a surface that is not orientable, and for a mesh of which
///           mending leaves nothing
[[nodiscard]] MeshSurvey survey_mesh(const std::filesystem::path& path, double degrees,
                                     const MeshRepair& repair);

/// The same for a file that was read.
[[nodiscard]] MeshSurvey survey_mesh(const MeshFile& file, double degrees, const MeshRepair& repair);

}  // namespace radcert
