// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/galerkin/pair_integrals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "radcert/core/contract.h"
#include "radcert/core/lazy_table.h"
#include "radcert/factors/exchange_area.h"
#include "radcert/galerkin/touching_rule.h"
#include "radcert/kernel/geometric_kernel.h"
#include "radcert/kernel/rounded_kernel.h"
#include "radcert/polynomial/largest_values.h"
#include "radcert/polynomial/rules/conical_rule.h"
#include "radcert/scalar/pack.h"

namespace radcert {

const WorkLimit deepest_pair("galerkin/pair_integrals: cuts of two near elements", 10, 0,
                             "what two rules differ by there goes into the radius");

const WorkLimit most_stages("galerkin/pair_integrals: rules that are tried after the first", 6, 1,
                            "what two rules differ by goes into the radius");

namespace {

/// A rule for each stage.
constexpr std::size_t rules_of_a_contact = 7;
constexpr std::size_t lanes = Pack::lanes;
constexpr double unit = unit_roundoff<double>();
constexpr double blur_per_extent = coordinate_roundings * unit;

using Triangle = std::array<Barycentric<double>, 3>;

constexpr Triangle whole{Barycentric<double>{{1, 0, 0}}, Barycentric<double>{{0, 1, 0}},
                         Barycentric<double>{{0, 0, 1}}};

/// The orders of the conical rules; those up to `most_kept` are kept for whole elements.
constexpr std::array<int, 12> orders{2, 3, 4, 5, 6, 8, 10, 12, 14, 17, 20, 24};
constexpr std::size_t most_kept = 6;

Barycentric<double> inside(const Triangle& triangle, const Barycentric<double>& x) {
  Barycentric<double> at{{0, 0, 0}};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t d = 0; d < 3; ++d) at.x[d] += x.x[c] * triangle[c].x[d];
  return at;
}

/// The four triangles between the vertices and the middles of the sides.
std::array<Triangle, 4> quarters(const Triangle& t) {
  const auto middle = [](const Barycentric<double>& p, const Barycentric<double>& q) {
    return Barycentric<double>{{(p.x[0] + q.x[0]) / 2, (p.x[1] + q.x[1]) / 2, (p.x[2] + q.x[2]) / 2}};
  };
  const Barycentric<double> a = middle(t[1], t[2]);
  const Barycentric<double> b = middle(t[2], t[0]);
  const Barycentric<double> c = middle(t[0], t[1]);
  return {{{t[0], c, b}, {c, t[1], a}, {b, a, t[2]}, {a, b, c}}};
}

/// How a triangle in an element lies in space: enough to choose a rule for it.
struct Place {
  std::array<Vector<double>, 3> vertices;
  std::vector<Vector<double>> lattice;
  Vector<double> centre;
  double radius = 0;
};

constexpr int lattice_degree = 4;

Place place_of(const Surface& surface, const ParameterTriangle& element, const Triangle& triangle) {
  const ChartIn<double>& chart = surface.charts[element.chart].in<double>();
  Place place;
  for (int i = lattice_degree; i >= 0; --i)
    for (int j = lattice_degree - i; j >= 0; --j) {
      const Barycentric<double> x{{static_cast<double>(i) / lattice_degree,
                                   static_cast<double>(j) / lattice_degree,
                                   static_cast<double>(lattice_degree - i - j) / lattice_degree}};
      const Vector<double> point = chart.frame(element.at(inside(triangle, x).x)).point;
      for (std::size_t c = 0; c < 3; ++c)
        if (x.x[c] == 1) place.vertices[c] = point;
      place.lattice.push_back(point);
      place.centre = place.centre + point;
    }
  place.centre = (1.0 / static_cast<double>(place.lattice.size())) * place.centre;
  for (const Vector<double>& point : place.lattice)
    place.radius = std::max(place.radius, norm(point - place.centre));
  return place;
}

/// The distance of one from the other's centre over the other's radius.
double relative_distance(const Place& of, const Place& from_centre_of) {
  double distance = HUGE_VAL;
  for (const Vector<double>& point : of.lattice)
    distance = std::min(distance, norm(point - from_centre_of.centre));
  return distance / from_centre_of.radius;
}

double largest_coordinate(const Vector<double>& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}
Pack largest_coordinate(const Vector<Pack>& p) { return max(max(abs(p.x), abs(p.y)), abs(p.z)); }

/// A plane element, with what rounded corners may add to what it exchanges with another.
/// Maths     A F is the flux through the contour. A corner that is off by delta moves it by a strip of an
///           area of at most delta times the perimeter, which the other element sees under F <= 1
struct Facet {
  FacetCorners corners;
  double lean = 0;
};

Facet facet_of(const Surface& surface, const ParameterTriangle& element) {
  const ChartIn<double>& chart = surface.charts[element.chart].in<double>();
  Facet facet;
  double extent = 0;
  for (const ParameterPoint<double>& vertex : element.vertices) {
    facet.corners.push_back(chart.frame(vertex).point);
    extent = std::max(extent, largest_coordinate(facet.corners.back()));
  }
  if (dot(vector_area(facet.corners), chart.frame(element.vertices[0]).area_normal) < 0)
    std::swap(facet.corners[1], facet.corners[2]);
  double perimeter = 0;
  for (std::size_t i = 0; i < 3; ++i) perimeter += norm(facet.corners[(i + 1) % 3] - facet.corners[i]);
  constexpr double over_root_three = 2;
  facet.lean = over_root_three * blur_per_extent * extent * perimeter;
  return facet;
}

/// The places of the vertices of two triangles, those in common first and in the same order.
struct Contact {
  std::size_t common = 0;
  std::array<std::size_t, 3> first{};
  std::array<std::size_t, 3> second{};
};

Contact contact_of(const Place& first, const Place& second) {
  const double same = 0x1p-30 * std::min(first.radius, second.radius);
  Contact contact;
  std::array<bool, 3> first_used{};
  std::array<bool, 3> second_used{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (!first_used[i] && !second_used[j] && norm(first.vertices[i] - second.vertices[j]) <= same) {
        contact.first[contact.common] = i;
        contact.second[contact.common] = j;
        ++contact.common;
        first_used[i] = second_used[j] = true;
      }
  const auto fill = [&](std::array<std::size_t, 3>& places, const std::array<bool, 3>& used) {
    std::size_t next = contact.common;
    for (std::size_t i = 0; i < 3; ++i)
      if (!used[i]) places[next++] = i;
  };
  fill(contact.first, first_used);
  fill(contact.second, second_used);
  return contact;
}

/// A point of an element, or several in a pack, with all that the kernel takes there.
template <Real R>
struct SurfaceSample {
  ParameterPoint<R> at;
  Vector<R> point;
  Vector<R> normal;  ///< of unit length
  R area;            ///< that of the parameter triangle times two times the area element
};

template <Real R>
SurfaceSample<R> sample_at(const ChartIn<R>& chart, double doubled_area, const ParameterPoint<R>& at) {
  const Frame<R> frame = chart.frame(at);
  const R area = area_element(frame);
  return {.at = at,
          .point = frame.point,
          .normal = (R(1) / area) * frame.area_normal,
          .area = R(doubled_area) * area};
}

/// The points of a rule on a triangle in an element as structure of arrays, padded to whole packs with points
/// of no weight.
struct RulePoints {
  std::size_t count = 0;
  std::vector<double> x, y, z;
  std::vector<double> normal_x, normal_y, normal_z;  ///< of unit length
  std::vector<double> weights;                       ///< of dS
  Matrix<double> functions;                          ///< a column a function of the basis
  double extent = 0;
};

RulePoints rule_points(const Surface& surface, const ParameterTriangle& element, const Triangle& triangle,
                       const TriangleBasis<double>& basis, const TriangleRule<double>& rule) {
  const double share = std::abs(
      triangle[0].x[0] * (triangle[1].x[1] * triangle[2].x[2] - triangle[1].x[2] * triangle[2].x[1]) -
      triangle[0].x[1] * (triangle[1].x[0] * triangle[2].x[2] - triangle[1].x[2] * triangle[2].x[0]) +
      triangle[0].x[2] * (triangle[1].x[0] * triangle[2].x[1] - triangle[1].x[1] * triangle[2].x[0]));
  RulePoints out;
  out.count = rule.weights.size();
  const std::size_t room = padded<double>(out.count);
  for (std::vector<double>* array :
       {&out.x, &out.y, &out.z, &out.normal_x, &out.normal_y, &out.normal_z, &out.weights})
    array->assign(room, 0.0);
  out.functions = Matrix<double>(room, basis.size());
  std::vector<double> values(basis.size());
  const ChartIn<double>& chart = surface.charts[element.chart].in<double>();
  const double doubled_area = element.doubled_area();
  for (std::size_t q = 0; q < room; ++q) {
    const std::size_t from = std::min(q, out.count - 1);
    const Barycentric<double> x = inside(triangle, rule.points[from]);
    const SurfaceSample<double> sample = sample_at(chart, doubled_area, element.at(x.x));
    out.x[q] = sample.point.x;
    out.y[q] = sample.point.y;
    out.z[q] = sample.point.z;
    out.normal_x[q] = sample.normal.x;
    out.normal_y[q] = sample.normal.y;
    out.normal_z[q] = sample.normal.z;
    out.weights[q] = q < out.count ? rule.weights[q] * share * sample.area : 0.0;
    basis.values(x, values);
    for (std::size_t c = 0; c < values.size(); ++c) out.functions(q, c) = values[c];
    out.extent = std::max(out.extent, largest_coordinate(sample.point));
  }
  return out;
}

/// Integrals in the functions l_c of the basis, of one rule or of several parts.
struct RawBlock {
  Matrix<double> value;    ///< Int Int l_c(P) G l_d(Q)
  double size = 0;         ///< Int Int |G|
  double rounding = 0;     ///< of Int Int |G|, by the points' coordinates
  std::size_t length = 0;  ///< of the longest sum
  bool is_near = false;    ///< whether a part was near and was not cut
  bool is_last = false;    ///< whether a rule of the highest order took part

  explicit RawBlock(std::size_t functions) : value(functions, functions) {}
};

/// Adds a product of two rules.
void add_product(const RulePoints& first, const RulePoints& second, RawBlock& to) {
  const std::size_t p = first.functions.columns();
  const Pack extent(std::max(first.extent, second.extent));
  const Pack blur = Pack(blur_per_extent) * extent;
  std::vector<Pack> sums(p);
  std::vector<double> inner(p);
  for (std::size_t q = 0; q < first.count; ++q) {
    const Vector<Pack> point{Pack(first.x[q]), Pack(first.y[q]), Pack(first.z[q])};
    const Vector<Pack> minus_normal{Pack(-first.normal_x[q]), Pack(-first.normal_y[q]),
                                    Pack(-first.normal_z[q])};
    std::fill(sums.begin(), sums.end(), Pack(0));
    Pack sizes(0);
    Pack leans(0);
    for (std::size_t s = 0; s < second.x.size(); s += lanes) {
      const Vector<Pack> there{Pack::load(&second.x[s]), Pack::load(&second.y[s]), Pack::load(&second.z[s])};
      const Vector<Pack> normal{Pack::load(&second.normal_x[s]), Pack::load(&second.normal_y[s]),
                                Pack::load(&second.normal_z[s])};
      const Pack weight = Pack::load(&second.weights[s]);
      const RoundedKernel<Pack> g = rounded_kernel<Pack>(point - there, minus_normal, normal, extent, blur);
      const Pack value = weight * g.value;
      sizes = sizes + abs(value);
      leans = leans + weight * g.lean;
      for (std::size_t d = 0; d < p; ++d) sums[d] = sums[d] + value * Pack::load(&second.functions(s, d));
    }
    for (std::size_t d = 0; d < p; ++d) inner[d] = sums[d].sum();
    for (std::size_t c = 0; c < p; ++c) {
      const double outer = first.weights[q] * first.functions(q, c);
      for (std::size_t d = 0; d < p; ++d) to.value(c, d) += outer * inner[d];
    }
    to.size += first.weights[q] * sizes.sum();
    to.rounding += first.weights[q] * leans.sum();
  }
  to.length = std::max(to.length, first.count + second.x.size() / lanes + lanes);
}

}  // namespace

class PairIntegrals::Implementation {
public:
  Implementation(const Surface& surface, const Triangulation& triangulation, const LocalFunctions& functions,
                 double accuracy)
      : surface_(surface),
        triangulation_(triangulation),
        functions_(functions),
        accuracy_(accuracy),
        largest_(largest_values(functions.basis())),
        kept_(triangulation.triangles.size()) {
    expects(surface.unoccluded, "an unoccluded surface", named("surface", surface.name));
    expects(0 < accuracy && accuracy < 1, "0 < accuracy < 1", named("accuracy", accuracy));
    expects(functions.elements() == triangulation.triangles.size(), "functions of the triangulation");
    for (const ParameterTriangle& element : triangulation.triangles)
      places_.push_back(place_of(surface, element, whole));
    std::vector<std::size_t> first_of_plane;
    for (std::size_t a = 0; a < surface.charts.size(); ++a) {
      const auto same = std::find_if(first_of_plane.begin(), first_of_plane.end(), [&](std::size_t b) {
        return in_one_plane(surface.charts[a], surface.charts[b]);
      });
      plane_of_.push_back(same == first_of_plane.end() ? a : *same);
      if (plane_of_.back() == a && surface.charts[a].facts().plane) first_of_plane.push_back(a);
    }
    facets_.resize(triangulation.triangles.size());
    for (std::size_t k = 0; k < facets_.size(); ++k)
      if (is_plane(k)) facets_[k] = facet_of(surface, triangulation.triangles[k]);
  }

  [[nodiscard]] bool vanishes(std::size_t first, std::size_t second) const {
    const std::size_t a = triangulation_.triangles[first].chart;
    const std::size_t b = triangulation_.triangles[second].chart;
    return is_plane(first) && plane_of_[a] == plane_of_[b];
  }

  [[nodiscard]] PairBlock block(std::size_t first, std::size_t second) const {
    const std::size_t p = functions_.functions();
    PairBlock out{Matrix<double>(p, p), Matrix<double>(p, p)};
    if (vanishes(first, second)) return out;
    if (p == 1 && is_plane(first) && is_plane(second)) return of_constants(first, second);
    const Contact contact = contact_of(places_[first], places_[second]);
    const auto at_stage = [&](std::size_t stage) {
      if (contact.common > 0) return touching(first, second, contact, stage);
      RawBlock raw(p);
      add_near({first, whole, &places_[first]}, {second, whole, &places_[second]}, 0, stage, raw);
      return raw;
    };
    const double smallest = first_mode(first) * first_mode(second);
    Matrix<double> coarse = turned(at_stage(0).value, first, second);
    const std::size_t last = most_stages.count();
    double before = 0;
    for (std::size_t stage = 1; stage <= last; ++stage) {
      const RawBlock fine = at_stage(stage);
      Matrix<double> value = turned(fine.value, first, second);
      const double difference = largest_difference(value, coarse);
      const bool agree = difference <= accuracy_ * smallest * fine.size;
      if (agree || fine.is_last || stage == last) {
        // Rules converge slowly for what is near and was not cut, and for what has not converged.
        const double least = fine.is_near || !agree
                                 ? std::max(8 * difference, before)
                                 : std::max(difference / 2, std::min(before / 8, 64 * difference));
        put(fine, value, coarse, least, missed(fine.size, first, second), first, second, out);
        break;
      }
      coarse = std::move(value);
      before = difference;
    }
    if (first == second) make_symmetric(out);
    return out;
  }

private:
  static constexpr double far_enough = 1.5;

  [[nodiscard]] bool is_plane(std::size_t element) const {
    return surface_.charts[triangulation_.triangles[element].chart].facts().plane.has_value();
  }

  /// A_1 F_12 of two plane elements in closed form, with what their rounded corners leave open.
  [[nodiscard]] Approximation exchange(std::size_t first, std::size_t second) const {
    const Facet& from = facets_[first];
    const Facet& to = facets_[second];
    Approximation area = exchange_area(from.corners, to.corners);
    area.radius += from.lean + to.lean;
    return area;
  }

  /// Of two plane elements whose only functions are constants.
  [[nodiscard]] PairBlock of_constants(std::size_t first, std::size_t second) const {
    const Approximation area = exchange(first, second);
    const double psi = functions_.coefficients(first)(0, 0) * functions_.coefficients(second)(0, 0);
    PairBlock out{Matrix<double>(1, 1), Matrix<double>(1, 1)};
    out.value(0, 0) = psi * area.value;
    out.radius(0, 0) = std::abs(psi) * (area.radius + 4 * unit * area.value);
    return out;
  }

  /// What rules for two plane elements miss of Int Int G, by its closed form: they may agree on what is false
  /// where elements are thin.
  [[nodiscard]] double missed(double found, std::size_t first, std::size_t second) const {
    if (!is_plane(first) || !is_plane(second)) return 0;
    const Approximation area = exchange(first, second);
    return std::max(0.0, std::abs(found - pi<double>() * area.value) - pi<double>() * area.radius);
  }

  struct Part {
    std::size_t element;
    Triangle triangle;
    const Place* place;
    bool is_whole = true;
  };

  [[nodiscard]] RawBlock touching(std::size_t first, std::size_t second, const Contact& contact,
                                  std::size_t stage) const {
    const std::size_t p = functions_.functions();
    const ParameterTriangle& a = triangulation_.triangles[first];
    const ParameterTriangle& b = triangulation_.triangles[second];
    const ChartIn<Pack>& chart = surface_.charts[a.chart].in<Pack>();
    const ChartIn<Pack>& other = surface_.charts[b.chart].in<Pack>();
    const double area = a.doubled_area();
    const double other_area = b.doubled_area();
    const auto placed = [](const Barycentric<double>& x, const std::array<std::size_t, 3>& places) {
      Barycentric<double> at{{0, 0, 0}};
      for (std::size_t i = 0; i < 3; ++i) at.x[places[i]] = x.x[i];
      return at;
    };
    // In chunks, so that no sum is long.
    constexpr std::size_t chunk = 512;
    RawBlock out(p);
    RawBlock part(p);
    std::vector<double> of_first(p);
    std::vector<double> of_second(p);
    std::array<Barycentric<double>, lanes> x;
    std::array<Barycentric<double>, lanes> y;
    const std::vector<PointPair>& pairs = rule(contact.common, stage);
    for (std::size_t first_pair = 0; first_pair < pairs.size(); first_pair += lanes) {
      ParameterPoint<Pack> at_x;
      ParameterPoint<Pack> at_y;
      Pack weights;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const PointPair& pair = pairs[std::min(first_pair + lane, pairs.size() - 1)];
        x[lane] = placed(pair.first, contact.first);
        y[lane] = placed(pair.second, contact.second);
        const ParameterPoint<double> own_x = a.at(x[lane].x);
        const ParameterPoint<double> own_y = b.at(y[lane].x);
        at_x.s.set_lane(lane, own_x.s);
        at_x.t.set_lane(lane, own_x.t);
        at_y.s.set_lane(lane, own_y.s);
        at_y.t.set_lane(lane, own_y.t);
        weights.set_lane(lane, pair.weight);
      }
      const SurfaceSample<Pack> at = sample_at(chart, area, at_x);
      const SurfaceSample<Pack> there = sample_at(other, other_area, at_y);
      RoundedKernel<Pack> g{Pack(0), Pack(0)};
      if (a.chart == b.chart) {
        g = rounded_kernel<Pack>(chart.chord(at.at, there.at - at.at), at.normal, there.normal);
      } else {
        const Pack extent = max(largest_coordinate(at.point), largest_coordinate(there.point));
        g = rounded_kernel<Pack>(at.point - there.point, -at.normal, there.normal, extent,
                                 Pack(blur_per_extent) * extent);
      }
      weights = weights * at.area * there.area;
      const Pack values = weights * g.value;
      const Pack leans = weights * g.lean;
      for (std::size_t q = first_pair; q < std::min(first_pair + lanes, pairs.size()); ++q) {
        const std::size_t lane = q - first_pair;
        functions_.basis().values(x[lane], of_first);
        functions_.basis().values(y[lane], of_second);
        const double value = values.lane(lane);
        for (std::size_t d = 0; d < p; ++d) {
          const double with = value * of_second[d];
          for (std::size_t c = 0; c < p; ++c) part.value(c, d) += with * of_first[c];
        }
        out.size += std::abs(value);
        out.rounding += leans.lane(lane);
        if ((q + 1) % chunk != 0 && q + 1 != pairs.size()) continue;
        for (std::size_t c = 0; c < p; ++c)
          for (std::size_t d = 0; d < p; ++d) out.value(c, d) += std::exchange(part.value(c, d), 0.0);
      }
    }
    out.length = chunk + pairs.size() / chunk + 1;
    return out;
  }

  [[nodiscard]] const std::vector<PointPair>& rule(std::size_t common, std::size_t stage) const {
    constexpr int first_order = 4;
    const int order = first_order + functions_.basis().degree() / 2 + 2 * static_cast<int>(stage);
    return rules_.at((common - 1) * rules_of_a_contact + stage, [&] { return touching_rule(common, order); });
  }

  void add_near(const Part& first, const Part& second, long depth, std::size_t stage, RawBlock& to) const {
    const double eta_first = relative_distance(*second.place, *first.place);
    const double eta_second = relative_distance(*first.place, *second.place);
    if (std::min(eta_first, eta_second) < far_enough && depth < deepest_pair.value()) {
      const bool cut_first = first.place->radius >= second.place->radius;
      const Part& cut = cut_first ? first : second;
      for (const Triangle& quarter : quarters(cut.triangle)) {
        const Place place = place_of(surface_, triangulation_.triangles[cut.element], quarter);
        const Part part{cut.element, quarter, &place, false};
        add_near(cut_first ? part : first, cut_first ? second : part, depth + 1, stage, to);
      }
      return;
    }
    to.is_near = to.is_near || std::min(eta_first, eta_second) < far_enough;
    add_product_of(first, order_index(eta_first) + stage, second, order_index(eta_second) + stage, to);
  }

  void add_product_of(const Part& first, std::size_t of_first, const Part& second, std::size_t of_second,
                      RawBlock& to) const {
    std::optional<RulePoints> own_first;
    std::optional<RulePoints> own_second;
    to.is_last = to.is_last || std::max(of_first, of_second) + 1 == orders.size();
    add_product(points(first, of_first, own_first), points(second, of_second, own_second), to);
  }

  const RulePoints& points(const Part& part, std::size_t index, std::optional<RulePoints>& own) const {
    const auto make = [&] {
      return rule_points(
          surface_, triangulation_.triangles[part.element], part.triangle, functions_.basis(),
          conical_.at(index, [&] { return conical_rule<double>(orders[index], Grading::none); }));
    };
    if (part.is_whole && index < most_kept) return kept_[part.element].at(index, make);
    own.emplace(make());
    return *own;
  }

  /// The place among the orders of the coarser rule.
  [[nodiscard]] std::size_t order_index(double eta) const {
    const double at = std::max(eta, far_enough);
    const double rho = at + std::sqrt(at * at - 1);
    const double order = (functions_.basis().degree() + 1) / 2.0 - std::log(accuracy_) / (2 * std::log(rho));
    const auto found =
        std::find_if(orders.begin(), orders.end() - 2, [order](int each) { return each >= order; });
    return static_cast<std::size_t>(found - orders.begin());
  }

  /// A block in the orthonormal functions of the two elements.
  [[nodiscard]] Matrix<double> turned(const Matrix<double>& raw, std::size_t first,
                                      std::size_t second) const {
    const std::size_t p = functions_.functions();
    const Matrix<double>& of_first = functions_.coefficients(first);
    const Matrix<double>& of_second = functions_.coefficients(second);
    Matrix<double> half(p, p);
    for (std::size_t a = 0; a < p; ++a)
      for (std::size_t d = 0; d < p; ++d)
        for (std::size_t c = 0; c < p; ++c) half(a, d) += of_first(a, c) * raw(c, d);
    Matrix<double> both(p, p);
    for (std::size_t a = 0; a < p; ++a)
      for (std::size_t b = 0; b < p; ++b)
        for (std::size_t d = 0; d < p; ++d) both(a, b) += half(a, d) * of_second(b, d);
    return both;
  }

  /// A bound of |psi_a| on an element.
  [[nodiscard]] double largest_of(std::size_t element, std::size_t a) const {
    const Matrix<double>& psi = functions_.coefficients(element);
    double sum = 0;
    for (std::size_t c = 0; c < largest_.size(); ++c) sum += std::abs(psi(a, c)) * largest_[c];
    return sum;
  }

  /// About |psi_0|, which is constant where the weight and the area element are: its values at the nodes.
  [[nodiscard]] double first_mode(std::size_t element) const {
    const Matrix<double>& psi = functions_.coefficients(element);
    double largest = 0;
    for (std::size_t c = 0; c < psi.columns(); ++c) largest = std::max(largest, std::abs(psi(0, c)));
    return largest;
  }

  static double largest_difference(const Matrix<double>& one, const Matrix<double>& other) {
    double largest = 0;
    for (std::size_t a = 0; a < one.rows(); ++a)
      for (std::size_t b = 0; b < one.columns(); ++b)
        largest = std::max(largest, std::abs(one(a, b) - other(a, b)));
    return largest;
  }

  /// `least`: a difference may vanish by chance, but hardly all of a block's, and of two stages.
  void put(const RawBlock& fine, const Matrix<double>& value, const Matrix<double>& coarse, double least,
           double missed, std::size_t first, std::size_t second, PairBlock& out) const {
    const std::size_t p = functions_.functions();
    const double rounding =
        blur_per_extent * fine.rounding + unit * static_cast<double>(fine.length + 4 * p + 16) * fine.size;
    for (std::size_t a = 0; a < p; ++a)
      for (std::size_t b = 0; b < p; ++b) {
        out.value(a, b) = value(a, b) / pi<double>();
        out.radius(a, b) = (std::max(std::abs(value(a, b) - coarse(a, b)), least) +
                            (rounding + missed) * largest_of(first, a) * largest_of(second, b)) /
                           pi<double>();
      }
  }

  static void make_symmetric(PairBlock& block) {
    for (std::size_t a = 0; a < block.value.rows(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        const double mean = (block.value(a, b) + block.value(b, a)) / 2;
        const double radius = std::max(block.radius(a, b), block.radius(b, a)) +
                              std::abs(block.value(a, b) - block.value(b, a)) / 2;
        block.value(a, b) = block.value(b, a) = mean;
        block.radius(a, b) = block.radius(b, a) = radius;
      }
  }

  const Surface& surface_;
  const Triangulation& triangulation_;
  const LocalFunctions& functions_;
  double accuracy_;
  std::vector<double> largest_;  ///< of the functions of the basis
  std::vector<Place> places_;
  std::vector<std::size_t> plane_of_;  ///< by chart: the first chart in the same plane
  std::vector<Facet> facets_;          ///< of plane elements
  mutable std::vector<LazyTable<RulePoints, most_kept>> kept_;
  mutable LazyTable<TriangleRule<double>, orders.size()> conical_;
  mutable LazyTable<std::vector<PointPair>, 3 * rules_of_a_contact> rules_;
};

PairIntegrals::PairIntegrals(const Surface& surface, const Triangulation& triangulation,
                             const LocalFunctions& functions, double accuracy)
    : implementation_(std::make_unique<const Implementation>(surface, triangulation, functions, accuracy)) {}
PairIntegrals::~PairIntegrals() = default;

bool PairIntegrals::vanishes(std::size_t first, std::size_t second) const {
  return implementation_->vanishes(first, second);
}

PairBlock PairIntegrals::block(std::size_t first, std::size_t second) const {
  return implementation_->block(first, second);
}

std::size_t kept_bytes_per_element(std::size_t functions) {
  constexpr std::size_t arrays = 7;
  std::size_t points = 0;
  for (std::size_t i = 0; i < most_kept; ++i)
    points += padded<double>(static_cast<std::size_t>(orders[i] * orders[i]));
  return points * (arrays + functions) * sizeof(double) + 4096;
}

}  // namespace radcert
