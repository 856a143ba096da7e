// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace radcert::app {

/// Meshes of the scoreboard, embedded at build: a file of an example, and one beside this header.
struct EmbeddedMesh {
  std::string_view name;
  std::string_view text;
};

/// The room around a corner: apps/examples/07_occluded_room/l_room.obj.
EmbeddedMesh l_room_mesh();
/// A sphere of 32 triangles above a disk of 8: sphere_over_disk.obj.
EmbeddedMesh sphere_over_disk_mesh();

}  // namespace radcert::app
