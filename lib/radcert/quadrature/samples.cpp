// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/samples.h"

#include <concepts>

#include "radcert/core/contract.h"
#include "radcert/core/lazy_table.h"
#include "radcert/polynomial/basis_limits.h"

namespace radcert {
namespace {

/// The cell turned so that the rule is graded towards where the chart is not analytic, and how it is graded.
template <Real R>
struct Arrangement {
  ElementPart<R> cell;
  Grading grading;
};

template <Real R>
Arrangement<R> arrange(const Chart& chart, const ElementPart<R>& cell) {
  if (chart.facts().singular == SingularLine::none) return {cell, Grading::none};
  std::vector<std::size_t> on_line;
  std::vector<std::size_t> off_line;
  for (std::size_t i = 0; i < 3; ++i) (cell.vertices[i].s == R(0) ? on_line : off_line).push_back(i);
  if (on_line.empty()) return {cell, Grading::none};
  if (on_line.size() == 1) return {cell.rotated(on_line[0]), Grading::apex};
  return {cell.rotated(off_line.at(0)), Grading::base};
}

template <Real R>
RuleArrays<R> in_arrays(const TriangleRule<R>& rule) {
  RuleArrays<R> arrays;
  arrays.count = rule.weights.size();
  for (std::size_t q = 0; q < padded<R>(arrays.count); ++q) {
    const bool padding = q >= arrays.count;
    const std::size_t source = padding ? arrays.count - 1 : q;
    for (std::size_t i = 0; i < 3; ++i) arrays.x[i].push_back(rule.points[source].x[i]);
    arrays.weights.push_back(padding ? R(0) : rule.weights[source]);
  }
  return arrays;
}

}  // namespace

template <Real R>
ElementPart<R> ElementPart<R>::rotated(std::size_t i) const {
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  return {{vertices[i], vertices[j], vertices[k]}, {corners[i], corners[j], corners[k]}, doubled_area};
}

template <Real R>
ElementPart<R> whole_element(const ParameterTriangle& triangle) {
  ElementPart<R> cell;
  for (std::size_t i = 0; i < 3; ++i) {
    cell.vertices[i] = {R(triangle.vertices[i].s), R(triangle.vertices[i].t)};
    cell.corners[i].x = {R(0), R(0), R(0)};
    cell.corners[i].x[i] = R(1);
  }
  if constexpr (std::same_as<R, double>)
    cell.doubled_area = triangle.doubled_area();
  else
    cell.doubled_area = cross(cell.vertices[1] - cell.vertices[0], cell.vertices[2] - cell.vertices[0]);
  return cell;
}

template <Real R>
const RuleArrays<R>& ConicalRules<R>::rule(int order, Grading grading) {
  expects(smallest_order <= order && order <= largest_order, "an order with a rule", named("order", order));
  constexpr std::size_t orders = largest_order + 1;
  static LazyTable<RuleArrays<R>, 3 * orders> rules;
  return rules.at(static_cast<std::size_t>(grading) * orders + static_cast<std::size_t>(order),
                  [&] { return in_arrays(conical_rule<R>(order, grading)); });
}

template <Real R>
void take_samples(const Chart& chart, const ElementPart<R>& cell,
                  const std::type_identity_t<TriangleBasis<R>>& basis, int order, Samples<R>& out) {
  using B = typename Block<R>::Type;
  const auto [turned, grading] = arrange(chart, cell);
  const RuleArrays<R>& rule = ConicalRules<R>::rule(order, grading);
  const ChartIn<B>& formula = chart.in<B>();

  const std::array<ParameterPoint<R>, 3>& v = turned.vertices;
  const ParameterPoint<R> first = v[1] - v[0];
  const ParameterPoint<R> second = v[2] - v[0];
  const B parallelogram = B(turned.doubled_area);

  out.count = rule.count;
  out.functions = basis.size();
  out.origin = v[0];
  const std::size_t size = rule.weights.size();
  for (std::vector<R>* array :
       {&out.x, &out.y, &out.z, &out.s, &out.t, &out.normal_x, &out.normal_y, &out.normal_z})
    array->resize(size);
  out.basis.resize(size * out.functions);

  std::array<B, most_basis_functions> values;
  for (std::size_t q = 0; q < size; q += Block<R>::lanes) {
    const std::array<B, 3> c{Block<R>::load(&rule.x[0][q]), Block<R>::load(&rule.x[1][q]),
                             Block<R>::load(&rule.x[2][q])};
    // Sums of non-negative terms: a parameter on the singular line's side stays on it.
    const ParameterPoint<B> at{c[0] * B(v[0].s) + c[1] * B(v[1].s) + c[2] * B(v[2].s),
                               c[0] * B(v[0].t) + c[1] * B(v[1].t) + c[2] * B(v[2].t)};
    const Frame<B> frame = formula.frame(at);
    const Vector<B> normal = (Block<R>::load(&rule.weights[q]) * parallelogram) * frame.area_normal;
    Block<R>::store(frame.point.x, &out.x[q]);
    Block<R>::store(frame.point.y, &out.y[q]);
    Block<R>::store(frame.point.z, &out.z[q]);
    Block<R>::store(normal.x, &out.normal_x[q]);
    Block<R>::store(normal.y, &out.normal_y[q]);
    Block<R>::store(normal.z, &out.normal_z[q]);
    Block<R>::store(c[1] * B(first.s) + c[2] * B(second.s), &out.s[q]);
    Block<R>::store(c[1] * B(first.t) + c[2] * B(second.t), &out.t[q]);
    Barycentric<B> in_element;
    for (std::size_t i = 0; i < 3; ++i)
      in_element.x[i] = c[0] * B(turned.corners[0].x[i]) + c[1] * B(turned.corners[1].x[i]) +
                        c[2] * B(turned.corners[2].x[i]);
    basis.values(in_element, std::span<B>(values));
    for (std::size_t j = 0; j < out.functions; ++j)
      Block<R>::store(values[j], &out.basis[q * out.functions + j * Block<R>::lanes]);
  }
}

template struct ElementPart<double>;
template ElementPart<double> whole_element<double>(const ParameterTriangle&);
template class ConicalRules<double>;
template void take_samples<double>(const Chart&, const ElementPart<double>&, const TriangleBasis<double>&,
                                   int, Samples<double>&);
template struct ElementPart<Mpfr<50>>;
template ElementPart<Mpfr<50>> whole_element<Mpfr<50>>(const ParameterTriangle&);
template class ConicalRules<Mpfr<50>>;
template void take_samples<Mpfr<50>>(const Chart&, const ElementPart<Mpfr<50>>&,
                                     const TriangleBasis<Mpfr<50>>&, int, Samples<Mpfr<50>>&);

}  // namespace radcert
