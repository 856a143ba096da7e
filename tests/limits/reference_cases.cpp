// SPDX-License-Identifier: GPL-3.0-or-later
#include <numbers>

#include "radcert/closed_form/edge/corner_enclosure.h"
#include "radcert/closed_form/edge/edge_exponents.h"
#include "radcert/expression/parse.h"
#include "radcert/reference/cubature/gauss_rule.h"
#include "radcert/reference/nearest_point.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/reference/reference_value.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/two_piece.h"
#include "tests/limits/limits.h"
#include "verification/claims/psg10/sphere_over_disk/estimate.h"

namespace radcert::limits {
namespace {

using namespace reference;
using namespace verification::psg10;
using Place = SurfacePoint<double>;

double one(const Place&, const Vector<double>&) { return 1; }

/// Int_S G u from points of a closed convex surface; pi for u = 1.
Case operator_at(const std::string& limit, const Surface& surface, const std::vector<Place>& points,
                 const std::string& about) {
  return {
      .limit = limit,
      .answer =
          [=] {
            const AppliedOperator prepared(surface, Density(one));
            std::vector<Ball> balls;
            for (const Place& p : points)
              for (const Approximation& found : {prepared(p), operator_integral(surface, p, Density(one))})
                balls.push_back(number(found.value, found.radius));
            return numbers(balls);
          },
      .truth = [=] { return std::vector<Ball>(2 * points.size(), Ball::pi()); },
      .about = about};
}

/// A density with an edge in the middle of a chart, against the two smooth halves.
Case edge_of_density() {
  const Surface surface = cube();
  const Place p{4, {0.375, 0.25}};
  const auto bent = [](const Place&, const Vector<double>& q) { return std::abs(q.x - 0.3); };
  return {.limit = "reference/adaptive_cubature: regions",
          .answer =
              [=] {
                const Approximation found = operator_integral(surface, p, Density(bent));
                return numbers({number(found.value, found.radius)});
              },
          .about = "a density with an edge"};
}

/// One with a peak that few points miss.
Case peak_of_density() {
  const Surface surface = sphere();
  const Place p{0, {0.3, 0.4}};
  const auto peak = [](const Place&, const Vector<double>& q) {
    return 1 / (1e-3 + (q.x + 0.6) * (q.x + 0.6) + (q.y - 0.48) * (q.y - 0.48) + (q.z - 0.64) * (q.z - 0.64));
  };
  return {.limit = "reference/adaptive_cubature: regions",
          .answer =
              [=] {
                const Approximation found = operator_integral(surface, p, Density(peak));
                return numbers({number(found.value, found.radius)});
              },
          // G = 1/4, |Q - C|^2 = 2 - 2 c: 1/4 2 pi Int dc / (a + 2 - 2 c) = pi/4 log((a + 4)/a).
          .truth =
              [] {
                const Ball a = Ball(Rational(1, 1000));
                return std::vector<Ball>{widened(Ball::pi() / 4 * log((a + 4) / a), Ball(1e-12))};
              },
          .about = "a density with a peak"};
}

/// Densities with a feature that few points see, by their formulas: the cells that are left are in the
/// radius.
Case formula_of_density(const std::string& text, const std::string& about) {
  const Surface surface = cube();
  const Place p{4, {0.375, 0.25}};
  const Expression u = parse_expression(text).value();
  return {.limit = "reference/density_cells: halvings",
          .answer =
              [=] {
                const auto density = [u](const Place&, const Vector<double>& q) {
                  return u.evaluate<double>({q.x, q.y, q.z});
                };
                const std::vector<Expression> formulas(surface.chart_count(), u);
                const Approximation found = reference::AppliedOperator(surface, density, formulas)(p);
                return numbers({number(found.value, found.radius)});
              },
          .about = about};
}

/// The distance from points above the roof of two_piece; a fourth of what is found is less.
Case nearest(const std::string& limit, const Surface& surface) {
  return {.limit = limit,
          .answer =
              [=] {
                const ChartIn<double>& roof = surface.charts[1].in<double>();
                std::vector<Ball> all;
                for (const Vector<double>& p :
                     {Vector<double>{1.4744881639087013, 0.8453144338932217, 2.1141748865661971},
                      {1.7273412388477876, 0.19549524488035153, 2.7341680113773146}}) {
                  const Parameters at = nearest_to(p, roof, whole_domain(ChartDomain::unit_square));
                  const double distance = norm(roof.frame(at).point - p);
                  all.push_back(hull(Ball(distance / 4), Ball(distance * (1 + 1e-15))));
                }
                return numbers(all);
              },
          // On a grid of a million points.
          .truth =
              [=] {
                const ChartIn<double>& roof = surface.charts[1].in<double>();
                std::vector<Ball> all;
                for (const Vector<double>& p :
                     {Vector<double>{1.4744881639087013, 0.8453144338932217, 2.1141748865661971},
                      {1.7273412388477876, 0.19549524488035153, 2.7341680113773146}}) {
                  double least = 10;
                  for (int i = 0; i <= 1000; ++i)
                    for (int j = 0; j <= 1000; j += 10)
                      least = std::min(least, norm(roof.frame({i / 1000.0, j / 1000.0}).point - p));
                  all.push_back(number(least, 3e-3));
                }
                return all;
              },
          .about = "a roof from above"};
}

Case legendre(std::size_t points) {
  return {.limit = "reference/gauss_rule: steps to a zero", .answer = [points] {
            const GaussRule rule(points);
            std::vector<Ball> all;
            for (std::size_t k = 0; k < points; ++k) {
              all.push_back(number(rule.nodes()[k], 1e-15));
              all.push_back(number(rule.weights()[k], 1e-15));
            }
            return numbers(all);
          }};
}

Case over_disk(const std::string& limit, const SphereOverDiskScene& scene, int digits,
               const std::string& about) {
  return {.limit = limit,
          .answer =
              [=] {
                const std::vector<SphereOverDiskPoint> points{
                    {.part = SphereOverDiskPoint::Part::sphere, .place = 0, .poles = -1},
                    {.part = SphereOverDiskPoint::Part::disk, .place = Rational(1, 4) * scene.radius}};
                const auto found = estimate(scene, points, digits);
                if (!found) return refusal(found.reason());
                Answer answer = numbers({});
                for (const EstimatedRadiance& at : *found) {
                  answer.numbers.push_back(at.total);
                  answer.numbers.push_back(at.second);
                }
                return answer;
              },
          .truth = [] { return std::vector<Ball>(); },
          .about = about,
          .is_long = true};
}

Case family(const std::string& limit, const std::string& name, const Arguments& arguments, int digits,
            bool second) {
  return {.limit = limit,
          .answer =
              [=] {
                const ValueFamily& found = *find_family(name);
                const Route& route = second ? found.second_route : found.route;
                const Outcome<Ball> value = route.enclose(arguments, 1 / power(Rational(10), digits));
                return value ? numbers({*value}) : refusal(value.reason());
              },
          .truth =
              [=] {
                const ValueFamily& found = *find_family(name);
                const Route& other = second ? found.route : found.second_route;
                return std::vector<Ball>{other.enclose(arguments, 1 / power(Rational(10), 10)).value()};
              },
          .about = name};
}

/// All exponents of an edge below 3; each is one of the equation's solutions, and none is left out.
Case counted_exponents(const std::string& limit) {
  return {.limit = "closed_form/edge/edge_exponents: " + limit, .answer = [] {
            const Outcome<std::vector<EdgeExponent>> found =
                edge_exponents(edge_of_degrees(75, Rational(1, 2), Rational(1, 2)), 3, 12);
            if (!found) return refusal(found.reason());
            std::vector<Ball> all;
            for (const EdgeExponent& exponent : *found) all.push_back(exponent.value.real());
            return numbers(all);
          }};
}

/// Where the spectral radius of the operator at a corner passes 1.
Case corner_exponent() {
  return {.limit = "closed_form/edge/corner_enclosure: cells of a face", .answer = [] {
            const Rational rho(1, 2);
            const Outcome<Ball> found = enclosed_octant_exponent({rho, rho, rho}, Rational(1, 50));
            if (!found) return refusal(found.reason());
            return numbers({*found});
          }};
}

}  // namespace

std::vector<Case> reference_cases() {
  std::vector<Case> cases{
      corner_exponent(),
      edge_of_density(),
      peak_of_density(),
      formula_of_density("1 + exp(-1e6*((x-0.3)^2 + (y-0.4)^2 + (z-1)^2))", "a peak"),
      formula_of_density("1 + max(0, 0.01 - abs(x-0.3) - abs(y-0.4) - abs(z-1))", "a tent"),
      formula_of_density("sqrt(z)", "a root"),
      legendre(8),
      legendre(23),
      over_disk("psg10/sphere_over_disk/solution: rounds of Neumann's series", {}, 1, "the paper's scene"),
      over_disk("psg10/sphere_over_disk/estimate: nodes a panel",
                {.radius = 1, .disk_radius = 3, .height = Rational(101, 100), .albedo = Rational(99, 100)}, 1,
                "a near sphere"),
      family("reference/reference_value: bits of a formula for each bit wanted", "opposed_rectangles",
             {1, 1, 100000}, 30, false),
      family("reference/values/exact_solutions: quarterings towards the symbol's pole", "edge_exponent_90",
             {Rational(1, 5)}, 12, true),
      family("reference/values/edges: halvings towards an exponent", "edge_exponent",
             {75, Rational(1, 5), Rational(1, 2)}, 12, true),
      family("reference/edge_symbol_integral: steps of Newton's method", "edge_exponent",
             {75, Rational(1, 5), Rational(1, 2)}, 12, true),
      family("closed_form/edge/edge_exponents: halvings towards the smallest exponent", "edge_exponent",
             {75, Rational(1, 5), Rational(1, 2)}, 12, false),
      family("closed_form/edge/edge_exponents: steps of Newton's method", "edge_exponent",
             {75, Rational(1, 5), Rational(1, 2)}, 12, false),
      family("closed_form/edge/edge_symbol: terms of the series", "edge_exponent",
             {75, Rational(1, 5), Rational(1, 2)}, 12, false),
      counted_exponents("boxes in which exponents are counted"),
      counted_exponents("terms of the series of all patches")};
  // Near edges, seams and corners, and between plates.
  const std::vector<Place> on_box{{4, {0.375, 0.25}}, {4, {1e-7, 0.4}}, {4, {1e-5, 1e-6}}, {0, {0.5, 0.999}}};
  const std::vector<Place> on_octants{
      {0, {0.3, 0.4}}, {0, {1e-6, 0.4}}, {3, {0.2, 0.7999}}, {7, {0.01, 0.01}}};
  for (const char* limit : {"reference/adaptive_cubature: regions", "reference/nearest_point: steps",
                            "reference/nearest_point: halvings of a step"}) {
    const std::string name = limit;
    if (name == "reference/nearest_point: halvings of a step") {
      cases.push_back(nearest(name, two_piece(9)));
      continue;
    }
    cases.push_back(operator_at(name, ellipsoid(1, 2, 5), on_octants, "ellipsoid"));
    cases.push_back(operator_at(name, cube(), on_box, "cube"));
    cases.push_back(operator_at(name, box(1, 1, Rational(1, 100000)), on_box, "thin box"));
  }
  return cases;
}

}  // namespace radcert::limits
