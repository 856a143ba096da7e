// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/polynomial/nodes/symmetric_nodes.h"

#include <string_view>

#include "radcert/core/contract.h"

namespace radcert {
namespace {

Rational digits(std::string_view text) { return Rational::parse(text).value(); }

SymmetricOrbit centroid() { return {.size = 1}; }
SymmetricOrbit three(std::string_view a) { return {.size = 3, .a = digits(a)}; }
SymmetricOrbit three_held(std::string_view a) { return {.size = 3, .a = digits(a), .is_held = true}; }
SymmetricOrbit six(std::string_view a, std::string_view b) {
  return {.size = 6, .a = digits(a), .b = digits(b)};
}

std::vector<SymmetricNodes> make_sets() {
  return {
      {.degree = 1, .precision = 2, .orbits = {three("1/6")}},
      {.degree = 2,
       .precision = 4,
       .orbits = {three("0.091576213509770743459571463402201507854325295899828968801366831"),
                  three("0.44594849091596488631832925388305198839905746639736916154779930")}},
      {.degree = 3,
       .precision = 5,
       .orbits = {centroid(), three_held("0.03"),
                  six("0.067279646981797057383355309419302801799603122226928928548110899",
                      "0.27813960604313524956172281849242737147078394064836783083582938")}},
      {.degree = 4,
       .precision = 7,
       .orbits = {three_held("0.03"),
                  three("0.47431063696082049925716714369958051290705222987472596011568262"),
                  three("0.24128702427820697393997103781331056542914728735378839130113918"),
                  six("0.046521184952451500082004496108513258071418955591750519517037372",
                      "0.19432578163623916218984490907701826810638047732819403587486062")}},
      {.degree = 5,
       .precision = 9,
       .orbits = {three("0.17887488753490196581020079785042776540401742794989932458154416"),
                  three("0.48117662273927970820344018267701667711388048876702076879368239"),
                  three("0.40578840544865496762373661001687409792153225621212937984538577"),
                  six("0.030895757580252008724159543869752444310275375489537996080877508",
                      "0.062297262946225661256343043428289631864173882190251260072145759"),
                  six("0.036876810630319985779182904967325654821787612503986297934432052",
                      "0.23066040258020438249842803611068175262544697108892303178584711")}},
      {.degree = 6,
       .precision = 10,
       .orbits = {centroid(), three("0.47946207242198503895753520373930103959734221594696624548540884"),
                  three_held("0.013"), three_held("0.41"),
                  six("0.033508828232872910776477564125051178375431547386907701915987641",
                      "0.12208020176710583645088076343811826994587784939645778659153645"),
                  six("0.13238705827628890912211187049327960632252846016044072393345866",
                      "0.23059095955778300604866799171035125480576028960344563233995116"),
                  six("0.025485199234306154360887100990742390055696559808015190188351077",
                      "0.31199054915688683780824030404495337792753435593601787923635939")}},
  };
}

}  // namespace

std::span<const std::array<std::size_t, 3>> symmetric_places(int size) {
  using Permutation = std::array<std::size_t, 3>;
  static constexpr std::array<Permutation, 1> one{{{0, 1, 2}}};
  static constexpr std::array<Permutation, 3> three{{{0, 1, 2}, {1, 0, 2}, {1, 2, 0}}};
  static constexpr std::array<Permutation, 6> six{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  expects(size == 1 || size == 3 || size == 6, "an orbit of 1, 3 or 6 points", named("size", size));
  if (size == 1) return one;
  if (size == 3) return three;
  return six;
}

std::vector<Barycentric<Rational>> SymmetricNodes::nodes() const {
  const Rational third(1, 3);
  std::vector<Barycentric<Rational>> list;
  for (const SymmetricOrbit& orbit : orbits) {
    std::array<Rational, 3> x{third, third, third};
    if (orbit.size == 3) x = {1 - 2 * orbit.a, orbit.a, orbit.a};
    if (orbit.size == 6) x = {orbit.a, orbit.b, 1 - orbit.a - orbit.b};
    for (const auto& p : symmetric_places(orbit.size)) list.push_back({{x[p[0]], x[p[1]], x[p[2]]}});
  }
  return list;
}

const SymmetricNodes& symmetric_nodes(int degree) {
  expects(smallest_symmetric_degree <= degree && degree <= largest_symmetric_degree,
          "a degree with a symmetric set", named("degree", degree));
  static const std::vector<SymmetricNodes> sets = make_sets();
  return sets[static_cast<std::size_t>(degree - smallest_symmetric_degree)];
}

}  // namespace radcert
