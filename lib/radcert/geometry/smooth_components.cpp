// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/geometry/smooth_components.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/geometry/orientation.h"

namespace radcert {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Compares angles with one that is given in degrees.
class AngleLimit {
public:
  explicit AngleLimit(double degrees)
      : cosine_(std::sin((90 - degrees) * std::numbers::pi / 180)), exact_(Rational::exactly(cosine_)) {}

  /// Whether the angle between u and v exceeds the limit.
  [[nodiscard]] bool exceeded(const Vector<Rational>& u, const Vector<Rational>& v) const {
    const Rational product = dot(u, v);
    const Rational square = product * product;
    const Rational bound = exact_ * exact_ * dot(u, u) * dot(v, v);
    if (exact_.sign() >= 0) return product.sign() < 0 || square < bound;
    return product.sign() < 0 && square > bound;
  }

  /// The same for the normals of two triangles; `sign` is -1 where they run against each other.
  [[nodiscard]] bool exceeded(const std::array<Vector<double>, 3>& s, const std::array<Vector<double>, 3>& t,
                              int sign) const {
    const Vector<double> a = s[1] - s[0];
    const Vector<double> b = s[2] - s[0];
    const Vector<double> c = t[1] - t[0];
    const Vector<double> d = t[2] - t[0];
    const Vector<double> m = cross(a, b);
    const Vector<double> n = cross(c, d);
    const double size_m = norm(m);
    const double size_n = norm(n);
    // A component of a cross product errs by less than 4 u |a||b|; the quotient adds a few u.
    constexpr double unit = 32 * unit_roundoff<double>();
    const double error = unit * (norm(a) * norm(b) / size_m + norm(c) * norm(d) / size_n + 1);
    const double cosine = sign * dot(m, n) / (size_m * size_n);
    if (cosine < cosine_ - error) return true;
    if (cosine > cosine_ + error) return false;
    const auto normal = [](const std::array<Vector<double>, 3>& x) {
      return cross(exactly(x[1]) - exactly(x[0]), exactly(x[2]) - exactly(x[0]));
    };
    return exceeded(Rational(sign) * normal(s), normal(t));
  }

private:
  double cosine_;
  Rational exact_;
};

/// Numbers the sets of triangles that are joined across edges that `join` allows, by their first triangles.
template <class Join>
std::pair<std::vector<std::size_t>, std::size_t> joined_sets(const TriangleMesh& mesh,
                                                             const MeshTopology& topology, const Join& join) {
  std::vector<std::size_t> set(mesh.triangles.size(), none);
  std::size_t count = 0;
  std::vector<std::size_t> members;
  for (std::size_t start = 0; start < set.size(); ++start) {
    if (set[start] != none) continue;
    members.assign(1, start);
    set[start] = count;
    for (std::size_t next = 0; next < members.size(); ++next)
      for (const std::size_t e : topology.edge_of_side[members[next]]) {
        if (e == MeshTopology::no_edge || topology.edges[e].side_count() != 2) continue;
        const std::size_t first = topology.sides[topology.edges[e].begin].triangle;
        const std::size_t second = topology.sides[topology.edges[e].begin + 1].triangle;
        const std::size_t there = first == members[next] ? second : first;
        if (set[there] != none || !join(e, first, second)) continue;
        set[there] = count;
        members.push_back(there);
      }
    ++count;
  }
  return {std::move(set), count};
}

/// Sharp edges put one after the other into lines.
class Lines {
public:
  Lines(const TriangleMesh& mesh, const MeshTopology& topology, const AngleLimit& limit,
        SmoothComponents& result)
      : mesh_(mesh), topology_(topology), limit_(limit), result_(result) {}

  void find() {
    for (std::size_t i = 0; i < result_.sharp_edges.size(); ++i) {
      ends_.emplace_back(edge(i).from, i);
      ends_.emplace_back(edge(i).to, i);
    }
    std::sort(ends_.begin(), ends_.end());
    for (std::size_t k = 0; k < ends_.size(); k = next_vertex(k))
      if (is_corner(k)) result_.corners.push_back(ends_[k].first);
    walked_.assign(result_.sharp_edges.size(), 0);
    for (const std::size_t corner : result_.corners)
      for (std::size_t k = first_end(corner); k < ends_.size() && ends_[k].first == corner; ++k)
        walk(corner, ends_[k].second);
    for (std::size_t i = 0; i < walked_.size(); ++i) walk(edge(i).from, i);
  }

private:
  [[nodiscard]] const MeshEdge& edge(std::size_t i) const { return topology_.edges[result_.sharp_edges[i]]; }
  [[nodiscard]] std::size_t first_end(std::size_t vertex) const {
    return static_cast<std::size_t>(
        std::lower_bound(ends_.begin(), ends_.end(), std::pair(vertex, std::size_t{0})) - ends_.begin());
  }
  [[nodiscard]] std::size_t next_vertex(std::size_t k) const {
    std::size_t next = k;
    while (next < ends_.size() && ends_[next].first == ends_[k].first) ++next;
    return next;
  }
  [[nodiscard]] std::size_t far_end(std::size_t i, std::size_t vertex) const {
    return edge(i).from == vertex ? edge(i).to : edge(i).from;
  }
  [[nodiscard]] bool is_corner(std::size_t k) const {
    if (next_vertex(k) - k != 2) return true;
    const std::size_t vertex = ends_[k].first;
    const Vector<Rational> here = exactly(mesh_.vertices[vertex]);
    const Vector<Rational> before = exactly(mesh_.vertices[far_end(ends_[k].second, vertex)]);
    const Vector<Rational> after = exactly(mesh_.vertices[far_end(ends_[k + 1].second, vertex)]);
    return limit_.exceeded(here - before, after - here);
  }
  void walk(std::size_t start, std::size_t i) {
    if (walked_[i]) return;
    SharpLine line{.vertices = {start}, .closed = false, .open_border = edge(i).side_count() == 1};
    for (std::size_t here = start; i != none;) {
      walked_[i] = 1;
      here = far_end(i, here);
      i = none;
      if (here == start) {
        line.closed = true;
        break;
      }
      line.vertices.push_back(here);
      if (std::binary_search(result_.corners.begin(), result_.corners.end(), here)) break;
      for (std::size_t k = first_end(here); k < ends_.size() && ends_[k].first == here; ++k)
        if (!walked_[ends_[k].second]) i = ends_[k].second;
    }
    result_.lines.push_back(std::move(line));
  }

  const TriangleMesh& mesh_;
  const MeshTopology& topology_;
  const AngleLimit& limit_;
  SmoothComponents& result_;
  std::vector<std::pair<std::size_t, std::size_t>> ends_;  ///< vertex, place among the sharp edges
  std::vector<char> walked_;
};

}  // namespace

SmoothComponents smooth_components(const TriangleMesh& mesh, const MeshTopology& topology, double degrees) {
  expects(degrees >= 0 && degrees <= 180, "0 <= degrees <= 180", named("degrees", degrees));
  const AngleLimit limit(degrees);
  SmoothComponents result;
  std::vector<char> sharp(topology.edges.size(), 0);
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    if (edge.side_count() == 2) {
      const TriangleSide& first = topology.sides[edge.begin];
      const TriangleSide& second = topology.sides[edge.begin + 1];
      sharp[e] = limit.exceeded(mesh.corners(first.triangle), mesh.corners(second.triangle),
                                first.forward == second.forward ? -1 : 1)
                     ? 1
                     : 0;
    } else {
      sharp[e] = 1;
    }
    if (sharp[e]) result.sharp_edges.push_back(e);
  }
  std::tie(result.of_triangle, result.count) =
      joined_sets(mesh, topology, [&](std::size_t e, std::size_t, std::size_t) { return !sharp[e]; });
  std::tie(result.of_piece, result.piece_count) =
      joined_sets(mesh, topology, [&](std::size_t e, std::size_t a, std::size_t b) {
        return !sharp[e] && mesh.group[a] == mesh.group[b];
      });
  Lines(mesh, topology, limit, result).find();
  return result;
}

std::vector<std::string> piece_names(const TriangleMesh& mesh, const SmoothComponents& components) {
  std::vector<std::size_t> group(components.piece_count, none);
  std::vector<std::size_t> pieces(mesh.group_names.size(), 0);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    std::size_t& of_piece = group[components.of_piece[k]];
    if (of_piece != none) continue;
    of_piece = mesh.group[k];
    ++pieces[of_piece];
  }
  std::vector<std::size_t> number(mesh.group_names.size(), 0);
  std::vector<std::string> names;
  std::unordered_set<std::string> taken{"*"};  // which stands for all other pieces in a problem
  for (const std::size_t g : group) {
    const std::string base = mesh.group_names[g].empty() ? "piece" : mesh.group_names[g];
    const bool alone = pieces[g] == 1 && !mesh.group_names[g].empty();
    std::string name = alone ? base : base + "_" + std::to_string(++number[g]);
    // A group may be called like a numbered piece of another.
    while (!taken.insert(name).second) name += "_";
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace radcert
