// SPDX-License-Identifier: GPL-3.0-or-later

// Checked      As identities in alpha, for r = 1 to 8: the nodes of the library are those printed, (r + 1)(r
//              + 2)/2 of them; each coordinate is alpha + (1 - 3 alpha) k/r with a whole number k >= 0, so
//              that 0 < alpha < 1/3 keeps all of them inside and alpha apart from the sides. At alpha = 0 the
//              border holds 3r of them. Every permutation of the vertices permutes them. At alpha = 1/3,
//              which the paper allows beside (13), they are one point: (14) needs alpha < 1/3.
// Not checked  r = 0, where (13) divides by zero; the one node is the centroid then.

#include <algorithm>

#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

constexpr int largest_degree = 8;

// (i + (r - 3i) alpha)/r, typed in.
RationalPolynomial printed_coordinate(int i, int r) {
  return Rational(1, r) * (i + Rational(r - 3 * i) * RationalPolynomial::variable());
}

using Node = std::array<Rational, 3>;

std::vector<Node> nodes_at(const InsetFamily& family, const Rational& alpha) {
  std::vector<Node> nodes;
  for (std::size_t j = 0; j < family.size(); ++j) {
    const auto node = family.node(j);
    nodes.push_back({node[0](alpha), node[1](alpha), node[2](alpha)});
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

Rational different(std::vector<Node> nodes) {
  return {static_cast<long>(std::unique(nodes.begin(), nodes.end()) - nodes.begin())};
}

Rational on_the_border(const std::vector<Node>& nodes) {
  return {static_cast<long>(std::count_if(
      nodes.begin(), nodes.end(), [](const Node& q) { return *std::min_element(q.begin(), q.end()) == 0; }))};
}

// How many of the nodes a cyclic permutation or an exchange of two vertices does not take to nodes.
Rational moved_off(const std::vector<Node>& nodes) {
  long count = 0;
  for (const Node& q : nodes)
    for (const Node& image : {Node{q[1], q[2], q[0]}, Node{q[1], q[0], q[2]}})
      if (!std::binary_search(nodes.begin(), nodes.end(), image)) ++count;
  return {count};
}

}  // namespace

Finding equation_13(const Bench&) {
  Finding finding;
  const Rational alpha(1, 10);
  for (int r = 1; r <= largest_degree; ++r) {
    const InsetFamily family(r);
    const std::string of = ", r = " + std::to_string(r);
    const Rational count((r + 1) * (r + 2) / 2);
    Rational differing = 0;
    Rational shifted = 0;
    std::size_t place = 0;
    for (const std::array<int, 3>& k : lattice_indices(r)) {
      const auto node = family.node(place++);
      differing += ac98::differing_coefficients({node[2], 0}, {printed_coordinate(k[2], r), 0}) +
                   ac98::differing_coefficients({node[1], 0}, {printed_coordinate(k[1], r), 0});
      shifted += ac98::differing_coefficients({node[2], 0}, {printed_coordinate(k[2] + 1, r), 0});
    }
    finding.require("coefficients in alpha that are not those of (13)" + of, IsExactly{0}, differing);
    finding.control("the same with i + 1 in the place of i" + of, IsExactly{0}, shifted);
    const std::vector<Node> nodes = nodes_at(family, alpha);
    finding.require("different nodes, alpha = 1/10" + of, IsExactly{count}, different(nodes));
    finding.require("smallest coordinate, alpha = 1/10" + of, IsExactly{alpha}, nodes.front()[0]);
    finding.require("nodes that a permutation of the vertices takes off the nodes" + of, IsExactly{0},
                    moved_off(nodes));
    finding.require("nodes on the border, alpha = 0" + of, IsExactly{3 * r},
                    on_the_border(nodes_at(family, 0)));
    finding.control("different nodes, alpha = 1/3" + of, IsExactly{count},
                    different(nodes_at(family, Rational(1, 3))));
  }
  return finding;
}

}  // namespace radcert::verification::m06
