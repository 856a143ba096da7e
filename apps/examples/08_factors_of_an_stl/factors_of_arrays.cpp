// SPDX-License-Identifier: GPL-3.0-or-later

// Configuration factors from C++, of a scene that is made of arrays: a room with a screen that hides a part
// of one wall from the other.
#include <array>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "radcert/factors/facet_scene.h"
#include "radcert/factors/factor_matrix.h"
#include "radcert/visibility/scene.h"

namespace {

using namespace radcert;

/// Adds a parallelogram as two triangles of a group. Light travels from where the corners run
/// counterclockwise.
void add(TriangleMesh& mesh, const std::string& name, const std::array<Vector<double>, 4>& corners) {
  if (mesh.group_names.empty() || mesh.group_names.back() != name) mesh.group_names.push_back(name);
  const std::size_t first = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  for (const VertexTriple& triangle :
       {VertexTriple{first, first + 1, first + 2}, {first, first + 2, first + 3}}) {
    mesh.triangles.push_back(triangle);
    mesh.group.push_back(mesh.group_names.size() - 1);
    mesh.face.push_back(mesh.face.size());
  }
}

}  // namespace

int main() try {
  // The room [0,4] x [0,2] x [0,2], seen from inside; the screen stands at x = 2 and has two sides.
  TriangleMesh mesh;
  add(mesh, "floor", {{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}}});
  add(mesh, "ceiling", {{{0, 0, 2}, {0, 2, 2}, {4, 2, 2}, {4, 0, 2}}});
  add(mesh, "west", {{{0, 0, 0}, {0, 2, 0}, {0, 2, 2}, {0, 0, 2}}});
  add(mesh, "east", {{{4, 0, 0}, {4, 0, 2}, {4, 2, 2}, {4, 2, 0}}});
  add(mesh, "south", {{{0, 0, 0}, {0, 0, 2}, {4, 0, 2}, {4, 0, 0}}});
  add(mesh, "north", {{{0, 2, 0}, {4, 2, 0}, {4, 2, 2}, {0, 2, 2}}});
  add(mesh, "screen west", {{{2, 0.5, 0.5}, {2, 0.5, 1.5}, {2, 1.5, 1.5}, {2, 1.5, 0.5}}});
  add(mesh, "screen east", {{{2, 0.5, 0.5}, {2, 1.5, 0.5}, {2, 1.5, 1.5}, {2, 0.5, 1.5}}});

  // What no scene may have is named with its place. Two sides of a plate are no fault: they run against each
  // other.
  for (const SceneFault& fault : scene_faults(mesh))
    if (fault.kind != SceneFaultKind::doubled) {
      std::cerr << fault.words << '\n';
      return 1;
    }
  const FacetScene scene(mesh);
  const FactorUnits units{.of_triangle = mesh.group, .names = mesh.group_names};
  const FactorMatrix factors = factor_matrix(scene, units, {.accuracy = 1e-6}, {});
  for (const ConfigurationFactor& entry : factors.entries)
    if (units.names[entry.from] == "west")
      std::cout << "west to " << units.names[entry.to] << ": " << entry.factor.value << " +- "
                << entry.factor.radius << (entry.factor.guaranteed ? " (proved)" : " (estimated)") << '\n';
  std::cout << "row sums are 1 within " << factors.closure_defect(factors.worst_row()) << '\n';
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
