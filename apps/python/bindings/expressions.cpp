// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "arrays.h"
#include "python.h"
#include "radcert/core/errors.h"
#include "radcert/expression/batch.h"
#include "radcert/expression/parse.h"

namespace radcert::python {

namespace {

Expression parsed(const std::string& text, ExpressionVariables variables) {
  auto expression = parse_expression(text, variables);
  if (!expression)
    throw InputError({.source = "expression",
                      .value = text,
                      .problem = "is no expression: " + expression.reason().to_text(),
                      .allowed =
                          "x, y, z, pi, + - * / ^, parentheses, sqrt, exp, log, sin, cos, tan, atan, abs, "
                          "min, max"});
  return std::move(expression).value();
}

py::array_t<double> evaluated(const std::string& text, const py::object& points) {
  const CompiledExpression expression(parsed(text, ExpressionVariables::space));
  const DoubleArray array = double_rows(points, 3, "points");
  const auto count = static_cast<std::size_t>(array.shape(0));
  std::vector<double> x(count);
  std::vector<double> y(count);
  std::vector<double> z(count);
  std::vector<double> out(count);
  const double* at = array.data();
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = at[3 * i];
    y[i] = at[3 * i + 1];
    z[i] = at[3 * i + 2];
  }
  expression.evaluate(x, y, z, out);
  return owning_array(std::move(out));
}

}  // namespace

void add_expressions(py::module_& module) {
  module.def("evaluate_expression", evaluated, py::arg("text"), py::arg("points"));
  module.def("require_expression", [](const std::string& text, bool barycentric) {
    static_cast<void>(
        parsed(text, barycentric ? ExpressionVariables::barycentric : ExpressionVariables::space));
  });
}

}  // namespace radcert::python
