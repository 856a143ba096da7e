// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/mesh_survey.h"

#include <algorithm>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/geometry/box_tree.h"
#include "radcert/geometry/contacts/aligned_file.h"
#include "radcert/geometry/contacts/joined_sides.h"
#include "radcert/geometry/contacts/mesh_contacts.h"
#include "radcert/geometry/contacts/near_contacts.h"
#include "radcert/scalar/enclosing_text.h"
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

std::string several(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string group_text(const std::string& group) { return group.empty() ? "a face" : group; }

/// Whether every face is of one of these groups.
bool are_plates(const MeshFile& file, const std::vector<std::string>& two_sided) {
  return !two_sided.empty() && std::all_of(file.group.begin(), file.group.end(), [&](std::size_t group) {
    return std::find(two_sided.begin(), two_sided.end(), file.group_names[group]) != two_sided.end();
  });
}

/// The backs of these groups as triangles of their own.
void add_backs(TriangleMesh& mesh, const std::vector<std::string>& two_sided) {
  for (const std::string& name : two_sided) {
    const auto found = std::find(mesh.group_names.begin(), mesh.group_names.end(), name);
    if (found == mesh.group_names.end() || name.empty())
      throw InputError(
          {.value = name, .problem = "is no group of this mesh", .allowed = listed(mesh.group_names)});
    const auto group = static_cast<std::size_t>(found - mesh.group_names.begin());
    const std::size_t back = mesh.group_names.size();
    mesh.group_names.push_back(name + " back");
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
      if (mesh.group[t] != group) continue;
      const VertexTriple front = mesh.triangles[t];
      mesh.triangles.push_back({front[0], front[2], front[1]});
      mesh.group.push_back(back);
      mesh.face.push_back(mesh.face[t]);
    }
  }
}

/// The file's faces along the axes, and what that did to it.
MeshFile align(MeshSurvey& survey, const MeshFile& given) {
  Outcome<AlignedFile> along_axes = aligned(given);
  if (!along_axes)
    throw InputError({.problem = "cannot be aligned: " + along_axes.reason(),
                      .allowed = "rooms with walls at right angles, or a mesh without repair align"});
  survey.degrees_turned = along_axes->degrees;
  const DecimalForm digits = DecimalForm::general(3);
  if (along_axes->degrees > 0)
    survey.mended.push_back("turned by " + nearest_text(along_axes->degrees, DecimalForm::general(6)) +
                            " degrees, so that faces are parallel to the axes");
  if (along_axes->moved > 0)
    survey.mended.push_back("coordinates that differed by rounding made equal: corners moved by " +
                            upper_text(along_axes->moved, digits) + " at most, in a file " +
                            given.precision.words);
  return std::move(along_axes->file);
}

/// Joins what touches along parts of sides, and takes out what bodies that stand on faces cover; the front is
/// decided before, for it says what is a body, and must be the same behind.
std::optional<Orientation> uncover(MeshSurvey& survey, FrontRule rule,
                                   const std::vector<std::string>& two_sided) {
  if (survey.defects.crossing.empty() || !survey.defects.degenerate_triangles.empty()) return std::nullopt;
  const Orientation orientation =
      mesh_front(survey.mesh, mesh_topology(survey.mesh), survey.defects, rule).orientation;
  JoinedSides joined = joined_sides(std::move(survey.mesh));
  survey.mesh = std::move(joined.mesh);
  if (joined.cut > 0) {
    survey.mended.push_back(several(joined.cut, "triangle", "triangles") +
                            " cut where corners of others lie on their sides");
    survey.defects = mesh_defects(survey.mesh);
    if (survey.defects.crossing.empty()) return std::nullopt;
  }
  Outcome<UncoveredMesh> uncovered =
      without_contacts(survey.mesh, orientation == Orientation::along_the_cross_product);
  if (!uncovered) throw InputError({.problem = uncovered.reason()});
  if (uncovered->is_as_it_was()) return std::nullopt;
  if (uncovered->cut > 0)
    survey.mended.push_back(several(uncovered->cut, "triangle", "triangles") +
                            " cut where sides of others lie in them");
  for (const MeshContact& contact : uncovered->contacts) {
    // What stands on one side of a plate leaves the other as it is.
    for (const std::string& group : two_sided)
      if (group == contact.one || group == contact.other)
        throw InputError(
            {.source = "--two-sided",
             .value = group,
             .problem = "touches " + group_text(group == contact.one ? contact.other : contact.one) +
                        ", which covers a part of one of its sides",
             .allowed = "groups that touch nothing; give the plate a thickness, or move it off"});
    survey.mended.push_back("contact of " + group_text(contact.one) + " and " + group_text(contact.other) +
                            ": an area of " + nearest_text(contact.area, DecimalForm::general(6)) +
                            " of each is covered and takes no part");
  }
  survey.mesh = std::move(uncovered->mesh);
  survey.defects = mesh_defects(survey.mesh);
  return orientation;
}

/// That the decimals of a mesh far from the origin are not known as doubles as its size would have it.
std::optional<std::string> rounding_remark(const MeshSurvey& survey) {
  constexpr double most = 1e-14;
  const double rounding = survey.precision.rounding;
  const BoxTree tree(triangle_boxes(survey.mesh));
  const double diagonal = norm(tree.box().high - tree.box().low);
  if (!(rounding > most * diagonal)) return std::nullopt;
  return "coordinates are read as doubles, which are within " + upper_text(rounding) +
         " of the decimals of this file, " + upper_text(rounding / diagonal) +
         " of its extent: areas, and all that is proved, are those of the mesh of these doubles";
}

/// Faces that look at each other across a gap as rounding leaves it.
std::vector<std::string> near_contact_remarks(const MeshSurvey& survey) {
  std::vector<std::string> out;
  for (const NearContact& near :
       near_contacts(survey.mesh, survey.front.orientation == Orientation::along_the_cross_product,
                     survey.precision.unit))
    out.push_back(
        group_text(near.one) + " and " + group_text(near.other) + " face each other across a gap of " +
        nearest_text(near.gap, DecimalForm::general(2)) + " at " + point_text(near.at) +
        (near.pairs > 1 ? ", the least of " + std::to_string(near.pairs) + " pairs of triangles" : "") +
        ": no contact, so that what lies between takes part; where they are to touch, give both the "
        "same coordinates" +
        (near.may_be_rounding ? ", or try repair align: the file is " + survey.precision.words
                              : std::string()));
  return out;
}

bool agrees(const MeshTopology& topology) {
  return topology.disagreeing_edges.empty() && topology.crowded_edges.empty();
}

/// Whether S lies in the boundary of its hull, its inner normals inwards.
void decide_containment(MeshSurvey& survey) {
  const double unit = survey.precision.unit;
  if (!agrees(survey.topology)) {
    survey.containment.reason = "the triangles do not agree which side is which";
    return;
  }
  survey.containment = convex_containment(survey.mesh, survey.front.orientation, unit);
  if (survey.topology.closed() || survey.front.known_by != InnerSide::by_file ||
      survey.containment.verdict == Containment::certified)
    return;
  survey.looks_away = convex_containment(survey.mesh, Orientation::against_the_cross_product, unit).verdict ==
                      Containment::certified;
}

}  // namespace

std::optional<std::string> MeshSurvey::fault_of_triangles() const {
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
  if (!front.misoriented.empty())
    return "has " + several(front.misoriented.size(), "component", "components") +
           " whose inner side is not the inside of the body, the first with a corner at " +
           point_text(mesh.vertices[mesh.triangles[front.misoriented.front()][0]]) +
           ": the triangles of a body within a room run the other way round";
  return std::nullopt;
}

std::optional<std::string> MeshSurvey::obstacle() const {
  if (std::optional<std::string> fault = fault_of_triangles()) return fault;
  if (front.undecided) return *front.undecided;
  if (looks_away)
    return "is open, and by the right-hand rule, as its file has it, all of it looks away from the rest: "
           "with "
           "front right-hand nothing sees anything; with front left-hand the light is on the inner side";
  return std::nullopt;
}

bool MeshSurvey::needs_front() const { return (front.undecided || looks_away) && !fault_of_triangles(); }

Surface MeshSurvey::surface(const std::string& name) const {
  expects(components.has_value(), "a mesh without degenerate triangles");
  return mesh_surface(name, mesh, components->of_piece, pieces,
                      {.orientation = front.orientation,
                       .closed = front.encloses,
                       .unoccluded = containment.verdict == Containment::certified});
}

MeshSurvey survey_mesh(const MeshFile& given, double degrees, const MeshRepair& repair, FrontRule rule,
                       const std::vector<std::string>& two_sided) {
  MeshSurvey survey;
  // Of plates alone both readings are one.
  if (rule == FrontRule::automatic && are_plates(given, two_sided)) rule = FrontRule::right_hand;
  const std::optional<MeshFile> along_axes =
      repair.align ? std::optional(align(survey, given)) : std::nullopt;
  const MeshFile& file = along_axes ? *along_axes : given;
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
  survey.mended.insert(survey.mended.end(), faces.diagonals.begin(), faces.diagonals.end());
  survey.mended.insert(survey.mended.end(), mended.done.begin(), mended.done.end());
  if (survey.mesh.triangles.empty())
    throw InputError({.problem = "has no triangle that is not degenerate", .allowed = "a mesh with faces"});
  survey.defects = mesh_defects(survey.mesh);
  const std::optional<Orientation> before = uncover(survey, rule, two_sided);
  if (survey.mesh.triangles.empty())
    throw InputError({.problem = "has faces that cover each other entirely, so that nothing is left of them",
                      .allowed = "a room that is not filled by a body"});
  add_backs(survey.mesh, two_sided);
  survey.topology = mesh_topology(survey.mesh);
  require_orientable(survey.mesh, survey.topology);
  survey.quality = mesh_quality(survey.mesh);
  if (!survey.defects.degenerate_triangles.empty()) {
    survey.containment.reason = "degenerate triangles have no normals";
    return survey;
  }
  survey.components = smooth_components(survey.mesh, survey.topology, degrees);
  survey.pieces = piece_names(survey.mesh, *survey.components);
  survey.planes = plane_classes(survey.mesh);
  survey.front = mesh_front(survey.mesh, survey.topology, survey.defects, rule);
  if (before && *before != survey.front.orientation)
    throw InputError(
        {.problem = "has faces that touch, and with what they cover taken out its front is another",
         .allowed = "--front right-hand or --front left-hand"});
  survey.remarks = near_contact_remarks(survey);
  if (const std::optional<std::string> remark = rounding_remark(survey)) survey.remarks.push_back(*remark);
  decide_containment(survey);
  return survey;
}

MeshSurvey survey_mesh(const std::filesystem::path& path, double degrees, const MeshRepair& repair,
                       FrontRule rule, const std::vector<std::string>& two_sided) {
  const MeshFile file = read_mesh_file(path);
  return with_source(path.string(), [&] { return survey_mesh(file, degrees, repair, rule, two_sided); });
}

}  // namespace radcert
