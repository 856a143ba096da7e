// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "radcert/enclosure/interval_integral.h"
#include "radcert/enclosure/kernel_integral.h"
#include "radcert/enclosure/maximum.h"
#include "radcert/enclosure/near_polynomial.h"
#include "radcert/enclosure/square_integral.h"
#include "radcert/hypotheses/convex_containment.h"
#include "radcert/surface/catalogue.h"
#include "radcert/surface/catalogue/box.h"
#include "radcert/surface/catalogue/ellipsoid.h"
#include "radcert/surface/catalogue/rectangle.h"
#include "radcert/surface/catalogue/torus.h"
#include "radcert/surface/exact_chart.h"
#include "tests/hypotheses/dome.h"
#include "tests/limits/limits.h"

namespace radcert::limits {
namespace {

const Rational half(1, 2);
constexpr ContainmentBudget little{.boxes_a_pair = 500, .boxes = 4000};

Answer answer_of(const Enclosure& found) {
  const std::string evaluations =
      std::to_string(found ? found->evaluations : found.reason().evaluations) + " evaluations";
  return numbers({found ? found->value : found.reason().reached}, evaluations);
}

/// Int G over the square opposite to the middle of another: 4 x atan x, x = 1/sqrt 5 (Howell, point to
/// rectangle).
Case opposite_square(const std::string& limit) {
  return {.limit = limit,
          .answer =
              [] {
                const Surface surface = cube();
                return answer_of(kernel_integral(ExactObserver::off_surface({half, half, 1}, {0, 0, -1}),
                                                 surface, 4, domain_polygon(surface.charts[4]),
                                                 unit_density(), {.radius = 1e-20}));
              },
          .truth =
              [] {
                const Ball x = 1 / sqrt(Ball(5));
                return std::vector<Ball>{4 * x * atan(x)};
              },
          .about = "a square"};
}

/// From a point of a chart of the unit sphere to that chart, G = 1/4: an eighth of pi.
Case octant_from_itself(const std::string& limit) {
  return {.limit = limit,
          .answer =
              [] {
                const Surface surface = sphere();
                return answer_of(kernel_integral(
                    ExactObserver::on_surface({{.chart = 0, .at = {Rational(1, 5), Rational(1, 3)}}}),
                    surface, 0, domain_polygon(surface.charts[0]), unit_density(), {.radius = 1e-3}));
              },
          .truth = [] { return std::vector<Ball>{Ball::pi() / 8}; },
          .about = "an octant of the sphere from itself",
          .is_long = true};
}

/// 1/((x - 1/2)^2 + a) 1/((y - 1/2)^2 + a), a = 10^-4: neither side has a rule at first.
Case peak(const std::string& limit, long work_limit) {
  return {.limit = limit,
          .answer =
              [work_limit] {
                const auto f = square_function([]<class R>(const R& x, const R& y) {
                  const R s = x - R(0.5);
                  const R t = y - R(0.5);
                  const R a(0x1p-13);
                  return R(1) / ((s * s + a) * (t * t + a));
                });
                return answer_of(
                    integral_over_squares(std::array{f}, {.radius = 1e-2, .work_limit = work_limit}));
              },
          .truth =
              [] {
                const Ball root = sqrt(Ball(0x1p-13));
                const Ball line = 2 / root * atan(1 / (2 * root));
                return std::vector<Ball>{line * line};
              },
          .about = "a peak"};
}

Case highest() {
  return {.limit = "enclosure/demand: evaluations",
          .answer =
              [] {
                const auto hill = cube_function(1, []<class T>(std::span<const T> x) {
                  const T s = x[0] - T(Ball(Rational(1, 3)));
                  return T(1) - s * s;
                });
                return answer_of(maximum(hill, {.radius = 1e-15}));
              },
          .truth = [] { return std::vector<Ball>{Ball(1)}; },
          .about = "a maximum"};
}

Case line() {
  return {.limit = "enclosure/demand: evaluations",
          .answer =
              [] {
                const auto root =
                    line_function([]<class R>(const R& x) { return R(1) / (R(Ball(1) / 1000) + x * x); });
                return answer_of(integral_on_interval(root, Ball(-1), Ball(1), {.radius = 1e-15}));
              },
          .truth =
              [] {
                const Ball root = sqrt(Ball(1000));
                return std::vector<Ball>{2 * root * atan(root)};
              },
          .about = "an interval"};
}

/// What a verdict says, and how many boxes it took.
Case convexity(const std::string& limit, const std::function<Surface()>& surface, const std::string& about,
               std::optional<ContainmentBudget> budget = std::nullopt) {
  return {.limit = limit,
          .answer =
              [=] {
                const ConvexContainment found =
                    budget ? convex_containment(surface(), *budget) : convex_containment(surface());
                return verdict(found.verdict == Containment::undecided ? "" : containment_word(found.verdict),
                               std::to_string(found.boxes) + " boxes, " + std::to_string(found.open.size()) +
                                   " open, " + std::to_string(found.steps.size()) + " steps");
              },
          .truth = [] { return std::vector<Ball>(); },
          .about = about};
}

/// A dome hardly above its floor, its formula not one that is known exactly.
Surface low_dome() {
  Surface surface = sample::dome_over_floor(Rational(8, 100));
  surface.charts.front() =
      make_rectangle({.name = "floor", .piece = "floor"}, {0, 0, Rational(249, 1000)}, {1, 0, 0}, {0, 1, 0});
  return surface;
}

/// The octant of the unit sphere, bent outwards by `height` times s t (1 - s - t): it meets its neighbours at
/// a crease.
template <Field R>
class BentOctant {
public:
  explicit BentOctant(const Rational& height)
      : octant_(1, 1, 1, Octant{1, 1, 1}), height_(from_rational<R>(height)) {}
  template <Field T>
  Vector<T> operator()(const T& s, const T& t) const {
    const T scale = R(1) + height_ * (s * t * (R(1) - (s + t)));
    return scale * octant_(s, t);
  }

private:
  EllipsoidOctant<R> octant_;
  R height_;
};

Case crease() {
  return {.limit = "hypotheses/chart_witness: halvings of a step", .answer = [] {
            Surface surface = sphere();
            surface.charts.front() =
                make_exact_chart<BentOctant>(surface.charts.front().facts(), Rational(1, 1000000));
            const ConvexContainment found = convex_containment(surface, {.boxes_a_pair = 500, .boxes = 4000});
            return verdict(found.verdict == Containment::undecided ? "" : containment_word(found.verdict));
          }};
}

/// 1/(1/5 + s - s) = 5, by a polynomial near it: on large boxes s - s is wider than 1/5.
Case five() {
  return {.limit = "enclosure/near_polynomial: boxes of a bound on two ellipses",
          .answer =
              [] {
                const auto f = []<class R>(const R& s, const R&) { return R(1) / (R(1) / R(5) + s - s); };
                const Outcome<NearPolynomial> near = near_polynomial(plane_function(f), {}, 8);
                if (!near) return refusal(near.reason());
                const Rational value = near->polynomial.value(Rational(1, 3), Rational(1, 7));
                return numbers({widened(Ball(value), Ball(near->distance))});
              },
          .truth = [] { return std::vector<Ball>{Ball(5)}; }};
}

Surface named_surface(const std::string& name, const std::vector<Rational>& values) {
  return find_surface(name)->make(values);
}

}  // namespace

std::vector<Case> enclosure_cases() {
  const auto torus_of = [] { return torus(1, half); };
  const auto dome = [] { return sample::dome_over_floor(0); };
  const auto floor_and_dome = [] { return low_dome(); };
  std::vector<Case> cases;
  cases.push_back(opposite_square("enclosure/demand: evaluations"));
  cases.push_back(octant_from_itself("enclosure/square_integral: evaluations for a bound on an ellipse"));
  cases.push_back(peak("enclosure/square_integral: evaluations for a bound on an ellipse", 20000));
  cases.push_back(peak("enclosure/square_integral: evaluations to compare two sides", 50000));
  const std::vector<Case> others{
      highest(),
      line(),
      convexity("hypotheses/convex_containment: boxes of a pair of charts", dome, "a dome"),
      convexity("hypotheses/convex_containment: boxes in all", dome, "a dome"),
      convexity("hypotheses/convex_containment: boxes of a condition on Q", floor_and_dome,
                "a dome hardly above the floor"),
      convexity("hypotheses/convex_containment: bits of boxes", dome, "a dome", little),
      convexity(
          "hypotheses/convex_containment: bits of boxes", [] { return named_surface("two_piece", {2}); },
          "two_piece", little),
      convexity("hypotheses/chart_shape: boxes of a sign over a domain", sphere, "the sphere", little),
      convexity("hypotheses/chart_witness: bits of a witness", torus_of, "a torus", little),
      convexity(
          "hypotheses/chart_witness: points of the lattices",
          [] { return sample::dome_over_floor(Rational(9, 100)); }, "a dome with a dent"),
      crease(),
      five(),
  };
  cases.insert(cases.end(), others.begin(), others.end());
  return cases;
}

}  // namespace radcert::limits
