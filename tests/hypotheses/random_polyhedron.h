// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "radcert/geometry/triangle_mesh.h"

namespace radcert {

/// The convex hull of random points by CGAL, its triangles counterclockwise as seen from outside; points of a
/// coarse lattice, of a ball, of a sphere or of a thin slab, so that coplanar facets and slivers occur.
TriangleMesh random_polyhedron(std::mt19937_64& stream);

}  // namespace radcert
