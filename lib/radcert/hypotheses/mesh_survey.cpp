// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/mesh_survey.h"

#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/hypotheses/nesting.h"
#include "radcert/surface/mesh_surface.h"

namespace radcert {
namespace {

std::string point_text(const Vector<double>& p) {
  return "(" + shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + ")";
}

void require_orientable(const TriangleMesh& mesh, const MeshTopology& topology) {
  if (topology.orientable()) return;
  const MeshEdge& edge = topology.edges[*topology.crooked_edge];
  throw InputError({.pointer = "edge from " + point_text(mesh.vertices[edge.from]) + " to " +
                               point_text(mesh.vertices[edge.to]),
                    .problem =
                        "closes a way around the surface that comes back with its sides exchanged: the "
                        "surface is not orientable and has no inner normals",
                    .allowed = "orientable surfaces"});
}

bool agrees(const MeshTopology& topology) {
  return topology.disagreeing_edges.empty() && topology.crowded_edges.empty();
}

/// Finds the inner side and, with it, whether S lies in the boundary of its hull.
void decide_containment(MeshSurvey& survey) {
  const double unit = survey.precision.unit;
  if (!agrees(survey.topology)) {
    survey.containment.reason = "the triangles do not agree which side is which";
    return;
  }
  if (survey.topology.closed()) {
    const int sign = volume_sign(survey.mesh);
    survey.orientation =
        sign < 0 ? Orientation::along_the_cross_product : Orientation::against_the_cross_product;
    survey.inner_side = sign == 0 ? InnerSide::by_convention : InnerSide::by_volume;
    survey.containment = convex_containment(survey.mesh, survey.orientation, unit);
    return;
  }
  survey.containment = convex_containment(survey.mesh, survey.orientation, unit);
  if (survey.containment.verdict == Containment::certified) {
    survey.inner_side = InnerSide::by_certificate;
    return;
  }
  ConvexContainment reversed = convex_containment(survey.mesh, Orientation::along_the_cross_product, unit);
  if (reversed.verdict != Containment::certified) return;
  survey.containment = std::move(reversed);
  survey.orientation = Orientation::along_the_cross_product;
  survey.inner_side = InnerSide::by_certificate;
}

std::string several(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

std::optional<std::string> MeshSurvey::obstacle() const {
  if (!defects.degenerate_triangles.empty())
    return "has " +
           several(defects.degenerate_triangles.size(), "degenerate triangle", "degenerate triangles");
  if (!defects.duplicate_vertices.empty())
    return "has " + several(defects.duplicate_vertices.size(), "vertex", "vertices") +
           " with the coordinates of another";
  if (!topology.crowded_edges.empty())
    return "has " + several(topology.crowded_edges.size(), "edge", "edges") + " of more than two triangles";
  if (!topology.disagreeing_edges.empty())
    return "has " + several(topology.disagreeing_edges.size(), "edge", "edges") +
           " across which the triangles run against each other";
  if (!defects.crossing.empty())
    return "has triangles that cross or overlap, " + several(defects.crossing.size(), "pair", "pairs") +
           (defects.crossing.size() == most_crossings.count() ? " or more" : "");
  if (!misoriented.empty())
    return "has " + several(misoriented.size(), "component", "components") +
           " whose inner side is not the inside of the body, the first with a corner at " +
           point_text(mesh.vertices[mesh.triangles[misoriented.front()][0]]) +
           ": the triangles of a body within a room run the other way round";
  return std::nullopt;
}

Surface MeshSurvey::surface(const std::string& name) const {
  expects(components.has_value(), "a mesh without degenerate triangles");
  return mesh_surface(name, mesh, components->of_piece, pieces,
                      {.orientation = orientation,
                       .closed = topology.closed(),
                       .unoccluded = containment.verdict == Containment::certified});
}

MeshSurvey survey_mesh(const MeshFile& file, double degrees, const MeshRepair& repair) {
  MeshSurvey survey;
  survey.format = file.format;
  survey.precision = file.precision;
  survey.digest = file.digest;
  survey.file_vertices = file.vertices.size();
  survey.file_faces = file.face_count();
  survey.joined_corners = file.joined_corners;
  survey.degrees = degrees;
  TriangulatedFaces faces = triangulate_faces(file, repair.triangulate ? BentFaces::cut : BentFaces::refused);
  survey.cut_faces = faces.cut_faces;
  survey.bent_faces = std::move(faces.bent_faces);
  MendedMesh mended = mend(std::move(faces.mesh), repair);
  survey.mesh = std::move(mended.mesh);
  survey.mended = std::move(faces.diagonals);
  survey.mended.insert(survey.mended.end(), mended.done.begin(), mended.done.end());
  if (survey.mesh.triangles.empty())
    throw InputError({.problem = "has no triangle that is not degenerate", .allowed = "a mesh with faces"});
  survey.topology = mesh_topology(survey.mesh);
  require_orientable(survey.mesh, survey.topology);
  survey.defects = mesh_defects(survey.mesh);
  survey.quality = mesh_quality(survey.mesh);
  if (!survey.defects.degenerate_triangles.empty()) {
    survey.containment.reason = "degenerate triangles have no normals";
    return survey;
  }
  survey.components = smooth_components(survey.mesh, survey.topology, degrees);
  survey.pieces = piece_names(survey.mesh, *survey.components);
  survey.planes = plane_classes(survey.mesh);
  decide_containment(survey);
  if (survey.inner_side == InnerSide::by_volume && survey.defects.crossing.empty())
    survey.misoriented = misoriented_components(survey.mesh, survey.topology, survey.orientation);
  return survey;
}

MeshSurvey survey_mesh(const std::filesystem::path& path, double degrees, const MeshRepair& repair) {
  const MeshFile file = read_mesh_file(path);
  return with_source(path.string(), [&] { return survey_mesh(file, degrees, repair); });
}

}  // namespace radcert
