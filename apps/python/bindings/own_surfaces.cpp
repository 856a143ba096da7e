// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/surface/own_surface.h"

#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "python.h"
#include "radcert/core/errors.h"
#include "radcert/study/problem.h"
#include "work.h"

namespace radcert::python {

namespace {

using Parameters = ParameterPoint<double>;

py::array_t<double> rows_of(std::span<const Parameters> at) {
  std::vector<double> numbers;
  numbers.reserve(2 * at.size());
  for (const Parameters& p : at) numbers.insert(numbers.end(), {p.s, p.t});
  return owning_array(std::move(numbers), {static_cast<py::ssize_t>(at.size()), 2});
}

/// The interpolant of a map of Python's. It is called here and now, in this thread with its lock, and is not
/// kept.
OwnChart chart_from(const std::string& name, const py::object& map, const py::object& jacobian) {
  for (const auto& [function, place] : {std::pair(&map, "/map"), std::pair(&jacobian, "/jacobian")})
    if (!(function == &jacobian && function->is_none()) && PyCallable_Check(function->ptr()) == 0)
      throw InputError({.source = name,
                        .pointer = place,
                        .value = std::string(py::str(function->get_type().attr("__name__"))),
                        .problem = "cannot be called",
                        .allowed = "a function of parameters (n, 2)"});
  if (name.empty())
    throw InputError({.source = "chart", .pointer = "/name", .value = "", .allowed = "a name"});
  OwnMap own;
  own.points = [&map](std::span<const Parameters> at, OwnMap::Points points) {
    const DoubleArray found = called(map, rows_of(at), "/map", {3},
                                     "a function of parameters (n, 2) that gives an array of doubles (n, 3)");
    const auto of = found.unchecked<2>();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto row = static_cast<py::ssize_t>(i);
      points[i] = {of(row, 0), of(row, 1), of(row, 2)};
    }
  };
  if (!jacobian.is_none())
    own.tangents = [&jacobian](std::span<const Parameters> at, OwnMap::Tangents tangents) {
      const DoubleArray found =
          called(jacobian, rows_of(at), "/jacobian", {3, 2},
                 "a function of parameters (n, 2) that gives an array of doubles (n, 3, 2), by s and by t");
      const auto of = found.unchecked<3>();
      for (std::size_t i = 0; i < tangents.size(); ++i) {
        const auto row = static_cast<py::ssize_t>(i);
        for (const py::ssize_t by : {0, 1})
          tangents[i].at(static_cast<std::size_t>(by)) = {of(row, 0, by), of(row, 1, by), of(row, 2, by)};
      }
    };
  return with_source(name, [&] { return interpolated_map(name, name, own); });
}

/// A surface of charts, each with the name and the piece that it has there.
SurfaceChoice surface_from(const std::string& name, const std::vector<OwnChart>& charts,
                           const std::vector<std::pair<std::string, std::string>>& names) {
  if (names.size() != charts.size())
    throw InputError(
        {.source = name,
         .pointer = "/names",
         .value = std::to_string(names.size()) + " names",
         .allowed = "a name and a piece a chart, of which there are " + std::to_string(charts.size())});
  std::vector<OwnChart> named = charts;
  for (std::size_t k = 0; k < named.size(); ++k) std::tie(named[k].name, named[k].piece) = names.at(k);
  return with_source(name, [&] {
    auto surface = std::make_shared<const Surface>(compute(py::none(), [&](Progress&) {
      return own_surface("estimated, by functions of Python: " + name, named);
    }));
    return SurfaceChoice{
        .name = surface->name,
        .parameters = {},
        .mesh = MeshChoice{
            .file = surface->name, .digest = {}, .angle = 0, .repair = {}, .mended = {}, .surface = surface}};
  });
}

}  // namespace

void add_own_surfaces(py::module_& module) {
  py::class_<OwnChart>(module, "OwnChart")

      .def_static("of_map", chart_from, py::arg("name"), py::arg("map"), py::arg("jacobian"))
      .def_property_readonly("degrees", [](const OwnChart& chart) { return chart.degrees(); })
      .def_readonly("residual", &OwnChart::residual)
      .def_readonly("tangent_residual", &OwnChart::tangent_residual);
  module.def("surface_of_charts", surface_from, py::arg("name"), py::arg("charts"), py::arg("names"));
}

}  // namespace radcert::python
