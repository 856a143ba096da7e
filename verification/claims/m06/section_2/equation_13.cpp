// SPDX-License-Identifier: GPL-3.0-or-later

// q_ij = (c_i, c_j) with c_i = (i + (r - 3i) alpha)/r = alpha + (1 - 3 alpha) i/r. The third barycentric
// coordinate is c_k, k = r - i - j: permutations of the vertices permute i, j and k, and with them the nodes.
// c_i - c_m = (1 - 3 alpha)(i - m)/r, so that the nodes are different and lie on a uniform grid unless alpha
// = 1/3; c_i >= alpha for alpha < 1/3, with equality for i = 0: all nodes are inside sigma and alpha apart
// from its sides, and for alpha = 0 those with i j k = 0 lie on the sides. There are (r + 1)(r + 2)/2: r + 1
// more than for r - 1.
//
// Checked      these as identities in i, j, m, r and alpha. The library's nodes are those printed, as
//              identities in alpha for r = 1 to 8; their number, the least coordinate and the symmetry once
//              more at alpha = 1/10, and the 3r on the border at alpha = 0. At alpha = 1/3, which the paper
//              allows beside (13), they are one point: (14) needs alpha < 1/3.
// Not checked  r = 0, where (13) divides by zero; the one node is the centroid then.

#include <algorithm>

#include "radcert/polynomial/nodes/inset_family.h"
#include "radcert/polynomial/nodes/lattice.h"
#include "verification/claims/ac98/collocation/differing_coefficients.h"
#include "verification/claims/rational_function.h"
#include "verification/framework/check.h"

namespace radcert::verification::m06 {
namespace {

constexpr int largest_degree = 8;

// (i + (r - 3i) alpha)/r, typed in.
RationalPolynomial printed_coordinate(int i, int r) {
  return Rational(1, r) * (i + Rational(r - 3 * i) * RationalPolynomial::variable());
}

// r c_i with the variables i, j, m, r and alpha; `three` for the 3 in (13).
struct Letters {
  Polynomial i = Polynomial::variable("i");
  Polynomial j = Polynomial::variable("j");
  Polynomial m = Polynomial::variable("m");
  Polynomial r = Polynomial::variable("r");
  Polynomial alpha = Polynomial::variable("alpha");
  int three = 3;

  [[nodiscard]] Polynomial scaled(const Polynomial& index) const {
    return index + (r - three * index) * alpha;
  }
};

// r (1 - c_i - c_j) - r c_(r-i-j).
Rational terms_of_third(int three) {
  Letters x;
  x.three = three;
  return differing_terms(x.r - x.scaled(x.i) - x.scaled(x.j) - x.scaled(x.r - x.i - x.j), 0);
}

// r (c_i - c_m) - (1 - 3 alpha)(i - m), and r (c_i - alpha) - (1 - 3 alpha) i.
Rational terms_of_differences(int three) {
  Letters x;
  x.three = three;
  return differing_terms(x.scaled(x.i) - x.scaled(x.m) - (1 - 3 * x.alpha) * (x.i - x.m), 0) +
         differing_terms(x.scaled(x.i) - x.r * x.alpha - (1 - 3 * x.alpha) * x.i, 0);
}

// f_r - f_(r-1) - (r + 1), f_r = (r + 1)(r + more)/2.
Rational terms_of_count(int more) {
  const Polynomial r = Letters().r;
  const Polynomial half = Rational(1, 2);
  return differing_terms(half * (r + 1) * (r + more) - half * r * (r + more - 1) - (r + 1), 0);
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
  const IsExactly none{0};
  finding.require("terms of r (1 - c_i - c_j) - r c_(r-i-j)", none, terms_of_third(3));
  finding.require("terms of r (c_i - c_m) - (1 - 3 alpha)(i - m) and r (c_i - alpha) - (1 - 3 alpha) i", none,
                  terms_of_differences(3));
  finding.require("terms of f_r - f_(r-1) - (r + 1)", none, terms_of_count(2));
  finding.control("terms of the first with 2 for 3 in (13)", none, terms_of_third(2));
  finding.control("terms of the second with 2 for 3 in (13)", none, terms_of_differences(2));
  finding.control("terms of the third with (r + 1)(r + 3)/2 for f_r", none, terms_of_count(3));
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
