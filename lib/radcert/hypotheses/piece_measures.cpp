// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/hypotheses/piece_measures.h"

#include <algorithm>

#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"
#include "radcert/geometry/plane_classes.h"
#include "radcert/scalar/rational.h"

namespace radcert {
namespace {

/// A direction rounded; its largest coordinate divides the others before they leave the range of doubles.
Vector<double> unit_vector(const Vector<Rational>& direction) {
  const Rational largest = std::max({abs(direction.x), abs(direction.y), abs(direction.z)});
  const Vector<double> v{(direction.x / largest).to_double(), (direction.y / largest).to_double(),
                         (direction.z / largest).to_double()};
  return (1 / norm(v)) * v;
}

}  // namespace

std::vector<PieceMeasures> piece_measures(const TriangleMesh& mesh, std::span<const std::size_t> of_piece,
                                          std::size_t pieces) {
  expects(of_piece.size() == mesh.triangles.size(), "a piece for each triangle",
          named("pieces", of_piece.size()));
  const PlaneClasses planes = plane_classes(mesh);
  std::vector<PieceMeasures> out(pieces);
  std::vector<Ball> area(pieces, Ball(0));
  std::vector<std::optional<std::size_t>> plane(pieces);
  // In balls, whose exponents have no end: the area of a small piece may be none in doubles.
  std::vector<Vector<Ball>> moment(pieces);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::size_t piece = of_piece[t];
    expects(piece < pieces, "numbers of pieces below their count", named("piece", piece));
    PieceMeasures& mine = out[piece];
    const auto corners = mesh.corners(t);
    const Vector<Rational> origin = exactly(corners[0]);
    const Vector<Rational> normal = cross(exactly(corners[1]) - origin, exactly(corners[2]) - origin);
    const Ball of_triangle = sqrt(Ball(dot(normal, normal) / 4));
    const BoundingBox box = box_about(corners);
    if (mine.triangles == 0) {
      mine.box = box;
      mine.normal = unit_vector(normal);
      plane[piece] = planes.of_triangle[t];
    }
    mine.box = hull(mine.box, box);
    if (planes.of_triangle[t] != *plane[piece]) mine.normal.reset();
    ++mine.triangles;
    area[piece] = area[piece] + of_triangle;
    for (const Vector<double>& p : corners)
      moment[piece] = moment[piece] + of_triangle * Vector<Ball>{Ball(p.x), Ball(p.y), Ball(p.z)};
  }
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    expects(out[piece].triangles > 0, "a triangle in each piece", named("piece", piece));
    out[piece].area = enclosing(area[piece]);
    const Vector<Ball> mean = (Ball(1) / (Ball(3) * area[piece])) * moment[piece];
    out[piece].centroid = {mean.x.to_double(), mean.y.to_double(), mean.z.to_double()};
  }
  return out;
}

}  // namespace radcert
