// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/quadrature/samples.h"

#include "radcert/core/contract.h"

namespace radcert {
namespace {

template <Real R>
Barycentric<R> midpoint(const Barycentric<R>& a, const Barycentric<R>& b) {
  const R half = R(1) / R(2);
  return {{half * (a.x[0] + b.x[0]), half * (a.x[1] + b.x[1]), half * (a.x[2] + b.x[2])}};
}

/// The cell turned so that the rule gathers where the chart is not analytic, and how it gathers.
template <Real R>
struct Arrangement {
  Cell<R> cell;
  Gathering gathering;
};

template <Real R>
Arrangement<R> arrange(const Chart& chart, const Cell<R>& cell) {
  if (chart.facts().singular == SingularLine::none) return {cell, Gathering::nowhere};
  std::vector<std::size_t> on_line;
  std::vector<std::size_t> off_line;
  for (std::size_t i = 0; i < 3; ++i) (cell.vertices[i].s == R(0) ? on_line : off_line).push_back(i);
  if (on_line.empty()) return {cell, Gathering::nowhere};
  if (on_line.size() == 1) return {cell.rotated(on_line[0]), Gathering::apex};
  return {cell.rotated(off_line.at(0)), Gathering::base};
}

}  // namespace

template <Real R>
std::array<Cell<R>, 2> Cell<R>::bisected(std::size_t i) const {
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  const ParameterPoint<R> middle = (R(1) / R(2)) * (vertices[j] + vertices[k]);
  const Barycentric<R> corner = midpoint(corners[j], corners[k]);
  return {Cell{{vertices[i], vertices[j], middle}, {corners[i], corners[j], corner}},
          Cell{{vertices[i], middle, vertices[k]}, {corners[i], corner, corners[k]}}};
}

template <Real R>
Cell<R> Cell<R>::rotated(std::size_t i) const {
  const std::size_t j = (i + 1) % 3;
  const std::size_t k = (i + 2) % 3;
  return {{vertices[i], vertices[j], vertices[k]}, {corners[i], corners[j], corners[k]}};
}

template <Real R>
Cell<R> whole_element(const ParameterTriangle& triangle) {
  Cell<R> cell;
  for (std::size_t i = 0; i < 3; ++i) {
    cell.vertices[i] = {R(triangle.vertices[i].s), R(triangle.vertices[i].t)};
    cell.corners[i].x = {R(0), R(0), R(0)};
    cell.corners[i].x[i] = R(1);
  }
  return cell;
}

template <Real R>
ConicalRules<R>::ConicalRules() {
  for (const Gathering gathering : {Gathering::nowhere, Gathering::apex, Gathering::base})
    for (int order = smallest_order; order <= largest_order; ++order)
      rules_[static_cast<std::size_t>(gathering)].push_back(conical_rule<R>(order, gathering));
}

template <Real R>
const ConicalRules<R>& ConicalRules<R>::instance() {
  static const ConicalRules rules;
  return rules;
}

template <Real R>
const TriangleRule<R>& ConicalRules<R>::rule(int order, Gathering gathering) const {
  expects(smallest_order <= order && order <= largest_order, "an order with a rule", named("order", order));
  return rules_[static_cast<std::size_t>(gathering)][static_cast<std::size_t>(order - smallest_order)];
}

template <Real R>
void sample(const Chart& chart, const Cell<R>& cell, const InsetBasis<R>& basis, int order, Samples<R>& out) {
  const auto [turned, gathering] = arrange(chart, cell);
  const TriangleRule<R>& rule = ConicalRules<R>::instance().rule(order, gathering);
  const ChartIn<R>& formula = chart.in<R>();
  constexpr std::size_t lanes = Samples<R>::lanes;

  const ParameterPoint<R>& apex = turned.vertices[0];
  const ParameterPoint<R> first = turned.vertices[1] - apex;
  const ParameterPoint<R> second = turned.vertices[2] - apex;
  const R parallelogram = cross(first, second);

  out.count = rule.weights.size();
  out.functions = basis.size();
  out.origin = apex;
  const std::size_t padded = (out.count + lanes - 1) / lanes * lanes;
  for (std::vector<R>* array : {&out.x, &out.y, &out.z, &out.s, &out.t}) array->resize(padded);
  for (std::vector<R>* array : {&out.normal_x, &out.normal_y, &out.normal_z}) array->assign(padded, R(0));
  out.basis.assign(padded * out.functions, R(0));

  std::array<R, 45> values;
  for (std::size_t q = 0; q < padded; ++q) {
    const bool padding = q >= out.count;
    const std::size_t source = padding ? out.count - 1 : q;
    const std::array<R, 3>& c = rule.points[source].x;
    // Sums of non-negative terms: a parameter on the singular line's side stays on it.
    const ParameterPoint<R> at{c[0] * apex.s + c[1] * turned.vertices[1].s + c[2] * turned.vertices[2].s,
                               c[0] * apex.t + c[1] * turned.vertices[1].t + c[2] * turned.vertices[2].t};
    const Frame<R> frame = formula.frame(at);
    out.x[q] = frame.point.x;
    out.y[q] = frame.point.y;
    out.z[q] = frame.point.z;
    out.s[q] = c[1] * first.s + c[2] * second.s;
    out.t[q] = c[1] * first.t + c[2] * second.t;
    if (padding) continue;
    const Vector<R> normal = (rule.weights[source] * parallelogram) * frame.area_normal;
    out.normal_x[q] = normal.x;
    out.normal_y[q] = normal.y;
    out.normal_z[q] = normal.z;
    Barycentric<R> in_element;
    for (std::size_t i = 0; i < 3; ++i)
      in_element.x[i] =
          c[0] * turned.corners[0].x[i] + c[1] * turned.corners[1].x[i] + c[2] * turned.corners[2].x[i];
    basis.values(in_element, values);
    const std::size_t block = q / lanes;
    for (std::size_t j = 0; j < out.functions; ++j)
      out.basis[(block * out.functions + j) * lanes + q % lanes] = values[j];
  }
}

template struct Cell<double>;
template Cell<double> whole_element<double>(const ParameterTriangle&);
template class ConicalRules<double>;
template void sample<double>(const Chart&, const Cell<double>&, const InsetBasis<double>&, int,
                             Samples<double>&);

}  // namespace radcert
