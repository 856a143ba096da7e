// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/factors/input/factor_scene.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "radcert/core/digest.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/geometry/orientation.h"
#include "radcert/visibility/scene.h"

namespace radcert {

namespace {

std::string point_text(const Vector<double>& p) {
  return "(" + shortest(p.x) + ", " + shortest(p.y) + ", " + shortest(p.z) + ")";
}

/// What makes the numbers meaningless is the input's fault, with coordinates.
void require_scene(const std::string& name, const TriangleMesh& mesh) {
  const std::vector<SceneFault> faults = scene_faults(mesh);
  if (faults.empty()) {
    if (const auto words = beyond_doubles(mesh))
      throw InputError({.source = name, .problem = *words, .allowed = "a scene that doubles carry"});
    return;
  }
  const std::string more =
      faults.size() == 1 ? "" : "; and " + std::to_string(faults.size() - 1) + " more faults";
  throw InputError({.source = name,
                    .problem = faults.front().words + more,
                    .allowed = "triangles that have a vertex or a side in common, or nothing"});
}

void require_plates_once(const std::vector<std::string>& two_sided, OptionStyle style) {
  for (auto name = two_sided.begin(); name != two_sided.end(); ++name)
    if (std::find(two_sided.begin(), name, *name) != name)
      throw InputError({.source = option_name(style, "two-sided"),
                        .value = *name,
                        .problem = "is named twice",
                        .allowed = "each group once: it has two sides"});
}

/// The usual reason why a room with furniture cannot be read.
std::string missing_bottom(const MeshTopology& topology) {
  return topology.crowded_edges.empty()
             ? ""
             : "; a body that stands on a face needs a bottom of its own, and what "
               "is covered is taken out";
}

MeshSurvey sound_survey(const std::string& name, const MeshFile& file, const FactorSceneChoice& choice,
                        OptionStyle style) {
  const MeshRepair repair = repair_named(choice.repair);
  MeshSurvey survey = survey_mesh(file, choice.degrees, repair, choice.front, choice.two_sided);
  if (!survey.defects.degenerate_triangles.empty()) {
    const auto corners = survey.mesh.corners(survey.defects.degenerate_triangles.front());
    throw InputError({.source = name,
                      .problem = "has a triangle with its corners on one line: " + point_text(corners[0]) +
                                 ", " + point_text(corners[1]) + ", " + point_text(corners[2]),
                      .allowed = "triangles with an area"});
  }
  if (choice.two_sided.empty())
    require_scene(name, survey.mesh);
  else  // The backs are doubled triangles, which are no fault.
    require_scene(name, survey_mesh(file, choice.degrees, repair).mesh);
  const std::string front = option_name(style, "front");
  if (survey.front.undecided && survey.topology.disagreeing_edges.empty())
    throw InputError({.source = name,
                      .problem = *survey.front.undecided,
                      .allowed = front + " right-hand or " + front +
                                 " left-hand, where a file can be read both ways" +
                                 missing_bottom(survey.topology)});
  if (!survey.front.misoriented.empty())
    throw InputError({.source = name,
                      .problem = "has reversed normals: the triangles connected with the one at " +
                                 point_text(survey.mesh.corners(survey.front.misoriented.front())[0]) +
                                 " look away from where the light of the others is",
                      .allowed = "bodies within a room run the other way round than the room"});
  return survey;
}

std::string edge_text(const FacetScene& scene, std::size_t edge) {
  const MeshEdge& e = scene.topology().edges[edge];
  const auto text = [&](std::size_t vertex) {
    const Vector<Rational> p = scene.unit() * exactly(scene.scene().vertex(vertex));
    return point_text({p.x.to_double(), p.y.to_double(), p.z.to_double()});
  };
  return text(e.from) + " to " + text(e.to);
}

/// What is remarked, or refused, where corners are rounded.
constexpr const char* rounded_corners = "has corners that no doubles hold in one unit of lengths";

void require_orientation(const std::string& name, const FacetScene& scene) {
  const std::vector<std::size_t>& edges = scene.topology().disagreeing_edges;
  if (edges.empty()) return;
  throw InputError({.source = name,
                    .problem = "has reversed normals: triangles run against each other along " +
                               std::to_string(edges.size()) + " edges, the first " +
                               edge_text(scene, edges.front()),
                    .allowed = "neighbours that look to the same side"});
}

/// Whether light can leave; then `space` must have been given.
bool is_open(const std::string& name, const FacetScene& scene, const std::string& front, bool in_the_open,
             bool space, OptionStyle style) {
  const std::vector<std::size_t>& open = scene.topology().open_edges;
  if (open.empty() && in_the_open) {
    if (space) return true;
    throw InputError(
        {.source = name,
         .problem = "has closed bodies, and with front " + front + " its light is outside of them and leaves",
         .allowed = option_name(style, "space") + " for what leaves, or another " +
                    option_name(style, "front") + missing_bottom(scene.topology())});
  }
  if (open.empty()) {
    if (space)
      throw InputError({.source = option_name(style, "space"),
                        .problem = "is for open scenes: " + name + " is closed, its light is inside",
                        .allowed = "with a mesh " + option_name(style, "front") +
                                   " right-hand or left-hand, whichever has it outside"});
    return false;
  }
  if (space) return true;
  constexpr std::size_t most_edges = 3;
  std::string edges;
  for (std::size_t k = 0; k < std::min(open.size(), most_edges); ++k)
    edges += (k == 0 ? "" : ", ") + edge_text(scene, open[k]);
  throw InputError({.source = name,
                    .problem = "is open: " + std::to_string(open.size()) +
                               (open.size() == 1 ? " edge" : " edges") + " with one triangle: " + edges +
                               (open.size() > most_edges ? ", ..." : ""),
                    .allowed = "a closed scene, " + option_name(style, "two-sided") +
                               " for plates without thickness, or " + option_name(style, "space") +
                               " for what leaves it"});
}

}  // namespace

FactorScene factor_scene(const std::string& name, const MeshFile& file, const FactorSceneChoice& choice,
                         OptionStyle style) {
  require_plates_once(choice.two_sided, style);
  const MeshSurvey survey = with_source(name, [&] { return sound_survey(name, file, choice, style); });
  const bool right = survey.front.orientation == Orientation::along_the_cross_product;
  const std::string front = right ? "right-hand" : "left-hand";
  FactorMesh mesh = factor_mesh(survey);
  FacetScene scene(mesh.mesh);
  require_orientation(name, scene);
  const bool open = is_open(name, scene, front, !survey.front.encloses, choice.space, style);
  return {.mesh = std::move(mesh),
          .scene = std::move(scene),
          .identity = length_prefixed(std::vector<std::string>{
              "mesh", survey.digest, survey.format, length_prefixed(choice.repair), front,
              length_prefixed(choice.two_sided), choice.space ? "open" : "closed", shortest(choice.degrees)}),
          .mended = survey.mended,
          .remarks = survey.remarks,
          .front = front,
          .open = open};
}

FactorScene factor_scene(const std::string& name, const Surface& surface, int level, bool space,
                         OptionStyle style) {
  for (const Chart& chart : surface.charts)
    if (!chart.facts().plane)
      throw InputError(
          {.source = "surface",
           .value = name,
           .problem = "is curved",
           .allowed = "surfaces of plane pieces, or a mesh file: then the factors are those of its facets"});
  FactorMesh mesh = factor_mesh(surface, level);
  require_scene(name, mesh.mesh);
  FacetScene scene(mesh.mesh, mesh.unit);
  require_orientation(name, scene);
  const bool open = is_open(name, scene, {}, false, space, style);
  std::string identity = surface.name;
  for (const SurfaceParameter& parameter : surface.parameters)
    identity += " " + parameter.name + " " + parameter.value.to_text();
  std::vector<std::string> remarks;
  if (!mesh.exact)
    remarks.push_back(name + " " + rounded_corners + ": factors and areas are those of the rounded ones");
  return {.mesh = std::move(mesh),
          .scene = std::move(scene),
          .identity = identity + " " + std::to_string(level),
          .mended = {},
          .remarks = std::move(remarks),
          .open = open};
}

void require_exact_corners(const std::string& name, const FactorScene& scene, OptionStyle style) {
  if (scene.mesh.exact) return;
  throw InputError(
      {.source = option_name(style, "certified"),
       .problem = "proves nothing of " + name + ", which " + rounded_corners,
       .allowed = "parameters that are whole multiples, of at most 16 digits, of one fraction; " +
                  std::string("or a mesh file, whose corners are the doubles that are read")});
}

}  // namespace radcert
