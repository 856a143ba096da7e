// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/front.h"

#include <algorithm>
#include <utility>

#include "radcert/hypotheses/nesting.h"

namespace radcert {
namespace {

constexpr Orientation right_hand = Orientation::along_the_cross_product;
constexpr Orientation left_hand = Orientation::against_the_cross_product;

/// The mesh with one number for vertices of equal coordinates.
TriangleMesh joined(TriangleMesh mesh, const MeshDefects& defects) {
  std::vector<std::size_t> number(mesh.vertices.size());
  for (std::size_t v = 0; v < number.size(); ++v) number[v] = v;
  for (const auto& [vertex, earlier] : defects.duplicate_vertices) number[vertex] = earlier;
  for (VertexTriple& triangle : mesh.triangles)
    for (std::size_t& v : triangle) v = number[v];
  return mesh;
}

/// Whether as many triangles run one way along each edge as the other: then the mesh is a boundary.
bool balanced(const MeshTopology& topology) {
  return std::all_of(topology.edges.begin(), topology.edges.end(), [&](const MeshEdge& edge) {
    const auto begin = topology.sides.begin() + static_cast<std::ptrdiff_t>(edge.begin);
    const auto end = topology.sides.begin() + static_cast<std::ptrdiff_t>(edge.end);
    return 2 * std::count_if(begin, end, [](const TriangleSide& side) { return side.forward; }) ==
           end - begin;
  });
}

const std::string outside_and_inside =
    ": with front right-hand its light is outside, and leaves; with front left-hand it is inside";

/// Settles whether the light of a mesh without boundary, its front known, is within or around the bodies.
void settle_by_winding(MeshFront& front, const TriangleMesh& mesh, const MeshTopology& topology) {
  Outcome<std::vector<std::size_t>> in_rooms =
      misoriented_components(mesh, topology, front.orientation, LightOf::rooms);
  Outcome<std::vector<std::size_t>> in_the_open =
      misoriented_components(mesh, topology, front.orientation, LightOf::the_open);
  if (!in_rooms || !in_the_open) {
    front.undecided = in_rooms ? in_the_open.reason() : in_rooms.reason();
  } else if (in_rooms->empty() || in_the_open->empty()) {
    front.encloses = in_rooms->empty();
  } else {
    front.misoriented = front.encloses ? std::move(*in_rooms) : std::move(*in_the_open);
  }
}

MeshFront closed_front(const TriangleMesh& mesh, const MeshTopology& topology, bool crosses, FrontRule rule) {
  MeshFront front;
  const int volume = volume_sign(mesh);
  const Orientation of_room = volume < 0 ? right_hand : left_hand;
  if (rule == FrontRule::automatic) {
    front.orientation = of_room;
    front.known_by = InnerSide::by_volume;
    front.encloses = true;
    if (volume == 0)
      front.undecided =
          "has bodies whose volumes cancel, so that its inside is not known" + outside_and_inside;
    if (crosses || volume == 0) return front;
    Outcome<std::vector<std::size_t>> in_rooms =
        misoriented_components(mesh, topology, of_room, LightOf::rooms);
    const Outcome<std::size_t> beside = outermost_components(mesh, topology);
    if (!in_rooms || !beside) {
      front.undecided = in_rooms ? beside.reason() : in_rooms.reason();
      return front;
    }
    front.misoriented = std::move(*in_rooms);
    if (front.misoriented.empty() && of_room == left_hand && *beside > 1)
      front.undecided = "has " + std::to_string(*beside) +
                        " closed bodies beside each other, counterclockwise as seen from outside: with front "
                        "right-hand they stand in the open, and light leaves; with front left-hand each is a "
                        "room of its own";
    return front;
  }
  front.orientation = rule == FrontRule::right_hand ? right_hand : left_hand;
  front.known_by = InnerSide::by_choice;
  front.encloses = front.orientation == of_room;
  if (!crosses) settle_by_winding(front, mesh, topology);
  return front;
}

}  // namespace

MeshFront mesh_front(const TriangleMesh& mesh, const MeshTopology& topology, const MeshDefects& defects,
                     FrontRule rule) {
  if (!defects.duplicate_vertices.empty()) {
    const TriangleMesh one = joined(mesh, defects);
    MeshDefects rest = defects;
    rest.duplicate_vertices.clear();
    return mesh_front(one, mesh_topology(one), rest, rule);
  }
  if (topology.closed() && topology.disagreeing_edges.empty())
    return closed_front(mesh, topology, !defects.crossing.empty(), rule);
  MeshFront front;
  front.orientation = rule == FrontRule::left_hand ? left_hand : right_hand;
  front.known_by = rule == FrontRule::automatic ? InnerSide::by_file : InnerSide::by_choice;
  if (!topology.open_edges.empty()) return front;
  const bool bounds = balanced(topology);
  const bool faces_in = bounds && volume_sign(mesh) * (front.orientation == right_hand ? -1 : 1) > 0;
  front.encloses = faces_in;
  if (bounds && defects.crossing.empty() && (faces_in || rule != FrontRule::automatic)) {
    settle_by_winding(front, mesh, topology);
    return front;
  }
  if (rule == FrontRule::automatic && !faces_in && !topology.crowded_edges.empty())
    front.undecided = "has no open edge, but edges of more than two triangles" +
                      (bounds ? outside_and_inside
                              : std::string(", so that it bounds no body: with front right-hand the light is "
                                            "where its triangles run counterclockwise, with front left-hand "
                                            "on the other side of each"));
  return front;
}

}  // namespace radcert
