// SPDX-License-Identifier: GPL-3.0-or-later
// The radius of a matrix entry lies above its error, and not far above: the law of element_integrator.h.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

#include "brute_force.h"
#include "radcert/core/parallel.h"
#include "radcert/quadrature/element_integrator.h"
#include "random_entries.h"
#include "tests/repeats.h"

namespace radcert {
namespace {

/// What rounding alone may do to an entry: ten roundings of every term of the integral, 10 u Int |G l_j|, and
/// off the observer's element one rounding of the coordinates: u X Int (|(Q-P).n_P| + |(P-Q).n_Q|) |l_j| /
/// |P-Q|^4 dS.
constexpr Long roundings_of_a_term = 10;
/// The radius may exceed the larger of error and rounding by this factor.
constexpr double largest_excess = 1000;
/// The same beyond degree 8, where terms are allowed 200 roundings in place of 60.
constexpr double largest_excess_beyond_degree_8 = 4000;
/// The fewest roundings u Int |G l_j| that a radius allows for: see `rounding`.
constexpr double fewest_roundings = 60;
/// The accuracy asked of an entry, relative to the row's Int |G| and to max |l_j|.
constexpr double required_accuracy = 1e-13;

struct Subject {
  Surface surface;
  BruteForce truth;
  std::vector<TouchingElements> levels;
  bool inset_may_vanish;
  bool analytic = true;  ///< every chart is

  Subject(Surface s, int last_level)
      : surface(std::move(s)), truth(surface), inset_may_vanish(!surface.pieces_meet_at_angle) {
    for (int level = 0; level <= last_level; ++level) levels.emplace_back(surface, level);
    for (const Chart& chart : surface.charts)
      analytic = analytic && chart.facts().singular == SingularLine::none;
  }
  Subject(const Subject&) = delete;
};

const std::vector<std::unique_ptr<Subject>>& subjects() {
  static const auto all = [] {
    std::vector<std::unique_ptr<Subject>> list;
    for (const Surface& surface : {cube(), box(1, 2, 5), sphere(), ellipsoid(1, 2, 5), two_piece(2),
                                   two_piece(3), two_piece(Rational(3, 2)), two_squares()})
      list.push_back(std::make_unique<Subject>(surface, 3));
    return list;
  }();
  return all;
}

/// Int |G| over the whole surface; independent of the triangulation.
double row_integral(const Surface& surface, const CollocationPoint<double>& p) {
  if (surface.closed) return pi<double>();
  double sum = 0;
  const InsetBasis<double> constant(0, 0);
  for (const ParameterTriangle& triangle : triangulate(surface, 0).triangles)
    sum += ElementIntegrator<double>(surface, triangle, constant).integrate(p).absolute;
  return sum;
}

/// The worst of one case over its entries.
struct Outcome {
  double error_by_radius = 0;
  double radius_by_error = 0;  ///< by the larger of error and rounding
  double error_by_row = 0;
  double least_radius = std::numeric_limits<double>::infinity();  ///< by u Int |G l_j|
  std::size_t entries = 0;
  std::size_t worst_entry = 0;
};

/// The integral of the observer alone, and that of its lane in a block of its element's nodes, as the
/// assembly has it.
std::array<ElementIntegral<double>, 2> both_ways(const Case& c, const InsetBasis<double>& basis) {
  ElementIntegrator<double> integrator(*c.surface, c.element, basis);
  std::array<ElementIntegral<double>, 2> integrals{
      integrator.integrate(collocation_point<double>(*c.surface, c.observer)), ElementIntegral<double>{}};
  std::vector<CollocationPoint<double>> nodes;
  const std::size_t first = c.node / Pack::lanes * Pack::lanes;
  for (std::size_t i = first; i < std::min(first + Pack::lanes, basis.size()); ++i)
    nodes.push_back(collocation_point<double>(*c.surface, c.node_of_observers_element(basis, i)));
  BlockIntegral<double> block;
  integrator.integrate(observer_blocks<double>(nodes).front(), nodes, block);
  const std::size_t lane = c.node - first;
  integrals[1].absolute = block.absolute.lane(lane);
  for (std::size_t j = 0; j < basis.size(); ++j) {
    integrals[1].value[j] = block.value[j].lane(lane);
    integrals[1].radius[j] = block.radius[j].lane(lane);
  }
  return integrals;
}

Outcome measure(const Subject& subject, const Case& c) {
  const InsetBasis<double> basis(c.degree, c.inset);
  const InsetBasis<Long> exact_basis(c.degree, c.inset);
  const CollocationPoint<double> p = collocation_point<double>(*c.surface, c.observer);
  const BruteForce::Integral truth = subject.truth.integrate(c.observer, c.element, exact_basis);
  const double row = row_integral(*c.surface, p);
  Outcome outcome;
  for (const ElementIntegral<double>& integral : both_ways(c, basis))
    for (std::size_t j = 0; j < basis.size(); ++j) {
      ++outcome.entries;
      const auto error = static_cast<double>(std::abs(static_cast<Long>(integral.value[j]) - truth.value[j]));
      // A comparison with a NaN would let it pass.
      if (!std::isfinite(error) || !std::isfinite(integral.radius[j])) {
        outcome.error_by_radius = std::numeric_limits<double>::infinity();
        outcome.worst_entry = j;
        return outcome;
      }
      const double rounding =
          unit_roundoff<double>() * static_cast<double>(roundings_of_a_term * truth.size[j] + truth.moved[j]);
      if (error / integral.radius[j] > outcome.error_by_radius) outcome.worst_entry = j;
      outcome.error_by_radius = std::max(outcome.error_by_radius, error / integral.radius[j]);
      outcome.radius_by_error =
          std::max(outcome.radius_by_error, integral.radius[j] / std::max(error, rounding));
      outcome.error_by_row = std::max(outcome.error_by_row, error / row);
      outcome.least_radius =
          std::min(outcome.least_radius,
                   integral.radius[j] / (unit_roundoff<double>() * static_cast<double>(truth.size[j])));
    }
  return outcome;
}

/// max |l_j| over the element: what rounding alone may do to an entry grows with it.
double largest_basis_value(const Case& c) {
  const InsetBasis<double> basis(c.degree, c.inset);
  const IntegrationScheme<double> scheme(*c.surface, basis, Tolerance());
  double largest = 0;
  for (std::size_t j = 0; j < basis.size(); ++j) largest = std::max(largest, scheme.largest_value(j));
  return largest;
}

struct Plan {
  Place place;
  std::size_t cases;
  std::uint64_t seed;
  std::optional<bool> analytic = std::nullopt;  ///< only surfaces of analytic charts, only others
  std::vector<int> degrees = {0, 1, 2, 3};
  std::vector<double> insets = {0, 1e-3, 0.1, 1.0 / 6, 0.3};
};

using Cases = std::vector<std::pair<const Subject*, Case>>;

void check(const Cases& cases);

void check(const Plan& plan) {
  Stream stream(plan.seed);
  Cases cases;
  while (cases.size() < plan.cases) {
    const Subject& subject = *stream.pick(subjects());
    if (plan.analytic && subject.analytic != *plan.analytic) continue;
    const TouchingElements& level = stream.pick(subject.levels);
    const int degree = stream.pick(plan.degrees);
    const double inset = stream.pick(plan.insets);
    if (inset == 0 && degree > 0 && !subject.inset_may_vanish) continue;
    if (const auto c = level.draw(plan.place, degree, inset, stream)) cases.emplace_back(&subject, *c);
  }
  check(cases);
}

void check(const Cases& cases) {
  std::vector<Outcome> outcomes(cases.size());
  parallel_for(cases.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) outcomes[i] = measure(*cases[i].first, cases[i].second);
  });
  Outcome worst;
  std::array<std::size_t, 3> witnesses{};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Case& c = cases[i].second;
    const Outcome& outcome = outcomes[i];
    const std::string where = c.text() + ", function " + std::to_string(outcome.worst_entry);
    EXPECT_LE(outcome.error_by_radius, 1) << where;
    EXPECT_LE(outcome.radius_by_error, c.degree > 8 ? largest_excess_beyond_degree_8 : largest_excess)
        << where;
    EXPECT_GE(outcome.least_radius, fewest_roundings) << where;
    EXPECT_LE(outcome.error_by_row, required_accuracy * std::max(1.0, largest_basis_value(c))) << where;
    worst.entries += outcome.entries;
    const auto note = [&](double& largest, double value, std::size_t k) {
      if (value > largest) witnesses[k] = i;
      largest = std::max(largest, value);
    };
    note(worst.error_by_radius, outcome.error_by_radius, 0);
    note(worst.radius_by_error, outcome.radius_by_error, 1);
    note(worst.error_by_row, outcome.error_by_row, 2);
  }
  std::cout << worst.entries << " entries\n  error / radius <= " << worst.error_by_radius << ": "
            << cases[witnesses[0]].second.text()
            << "\n  radius / max(error, rounding) <= " << worst.radius_by_error << ": "
            << cases[witnesses[1]].second.text() << "\n  error / row <= " << worst.error_by_row << ": "
            << cases[witnesses[2]].second.text() << '\n';
}

TEST(RadiusLaw, HoldsOnTheObserversOwnElement) {
  check({.place = Place::own, .cases = test::repeats(150), .seed = 101, .analytic = true});
}

TEST(RadiusLaw, HoldsOnTheObserversOwnElementWhereTheChartIsNotAnalytic) {
  check({.place = Place::own, .cases = test::repeats(4), .seed = 107, .analytic = false});
}

TEST(RadiusLaw, HoldsBesideAnEdge) {
  check({.place = Place::edge, .cases = test::repeats(150), .seed = 102});
}

TEST(RadiusLaw, HoldsAcrossAnEdgeAtAnAngle) {
  check(
      {.place = Place::edge_at_angle, .cases = test::repeats(150), .seed = 103, .insets = {1e-3, 1e-2, 0.1}});
}

TEST(RadiusLaw, HoldsBesideAVertex) {
  check({.place = Place::vertex, .cases = test::repeats(150), .seed = 104});
}

TEST(RadiusLaw, HoldsApart) { check({.place = Place::apart, .cases = test::repeats(300), .seed = 105}); }

TEST(RadiusLaw, HoldsAtChosenPlaces) {
  Cases cases;
  const auto add = [&cases](std::size_t subject, int level, int degree, double inset, std::size_t node,
                            std::size_t observer_element, std::size_t element) {
    const Subject& s = *subjects()[subject];
    cases.emplace_back(
        &s, s.levels[static_cast<std::size_t>(level)].at(degree, inset, node, observer_element, element));
  };
  constexpr std::size_t long_ellipsoid = 3;
  constexpr std::size_t cubic_roof = 5;
  constexpr std::size_t rough_roof = 6;
  // Nearly flat pieces of a roof beside P: the bends keep their digits only if P and Q are not subtracted.
  add(cubic_roof, 1, 3, 1e-3, 0, 11, 9);
  add(cubic_roof, 3, 2, 1e-3, 0, 225, 238);
  // P near the line on which the roof is not analytic: there the rules converge slowly.
  add(rough_roof, 0, 3, 1e-3, 0, 3, 3);
  add(rough_roof, 2, 3, 1e-3, 9, 50, 50);
  add(rough_roof, 1, 1, 1e-3, 2, 11, 8);
  // P at a corner of the octahedron, seen by the next chart.
  add(long_ellipsoid, 0, 1, 0, 1, 6, 7);
  check(cases);
}

TEST(RadiusLaw, HoldsForEveryDegree) {
  for (const Place place : {Place::own, Place::edge, Place::vertex, Place::apart})
    for (const auto& [cases, degrees] :
         {std::pair(30, std::vector<int>{4, 5, 6, 7, 8}), std::pair(8, std::vector<int>{9, 10})})
      check(
          {.place = place, .cases = test::repeats(cases), .seed = 106, .analytic = true, .degrees = degrees});
}

}  // namespace
}  // namespace radcert
