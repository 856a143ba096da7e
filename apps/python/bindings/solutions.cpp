// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "json.h"
#include "python.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/formats/field/ply.h"
#include "radcert/formats/field/vtu.h"
#include "radcert/formats/plot/convergence_plot.h"
#include "radcert/formats/plot/svg_plot.h"
#include "radcert/formats/result/result_json.h"
#include "radcert/formats/table/csv.h"
#include "radcert/formats/table/latex_table.h"
#include "radcert/study/experiment.h"
#include "requests/solution_at.h"
#include "requests/solve_request.h"
#include "work.h"

namespace radcert::python {

namespace {

using app::Solution;

const ErrorKind& kind_named(const std::string& name) {
  std::vector<std::string> known;
  for (const ErrorKind& kind : error_kinds()) {
    if (kind.name == name) return kind;
    known.push_back(kind.name);
  }
  throw InputError({.source = "error", .value = name, .allowed = listed(known)});
}

/// An error of the levels, where all have it.
py::object error_of(const Solution& solution, const std::string& name) {
  const ErrorKind& kind = kind_named(name);
  for (const LevelResult& level : solution.result.levels)
    if (!(level.*kind.figure)) return py::none();
  return approximation_arrays(solution.result.levels,
                              [&](const LevelResult& level) { return *(level.*kind.figure); });
}

py::array_t<double> orders_of(const Solution& solution, const std::string& name) {
  std::vector<double> out;
  for (const LevelResult& level : solution.result.levels) {
    std::optional<double> order;
    if (name == "discretisation_error")
      order = level.discretisation_order;
    else if (name == "node_error")
      order = level.node_order;
    else
      throw InputError({.source = "eoc", .value = name, .allowed = "discretisation_error, node_error"});
    out.push_back(order.value_or(std::nan("")));
  }
  return owning_array(std::move(out));
}

py::dict means_of(const Solution& solution) {
  py::dict out;
  const auto& levels = solution.result.levels;
  for (std::size_t piece = 0; piece < levels.front().piece_means.size(); ++piece)
    out[py::str(levels.front().piece_means[piece].first)] = approximation_arrays(
        levels, [&](const LevelResult& level) { return level.piece_means[piece].second; });
  return out;
}

template <class Number>
auto level_array(const Solution& solution, const Number& number) {
  std::vector<decltype(number(solution.result.levels.front()))> out;
  for (const LevelResult& level : solution.result.levels) out.push_back(number(level));
  return owning_array(std::move(out));
}

void require_place(std::size_t place, std::size_t count) {
  if (place < count) return;
  throw InputError({.source = "level",
                    .value = std::to_string(place),
                    .allowed = "a place among " + std::to_string(count) + " levels"});
}

/// The values at the nodes of one level.
py::dict nodes_of(const Solution& solution, std::size_t place) {
  require_place(place, solution.levels.size());
  const std::vector<NodeValue>& nodes = solution.levels[place].nodes;
  py::list pieces;
  std::vector<double> emission;
  std::vector<double> u;
  std::vector<std::int64_t> elements;
  bool has_u = true;
  for (const NodeValue& node : nodes) {
    pieces.append(node.piece);
    emission.push_back(node.emission);
    elements.push_back(static_cast<std::int64_t>(node.element));
    has_u = has_u && node.u.has_value();
    u.push_back(node.u.value_or(0));
  }
  py::dict out;
  out["points"] = point_array(nodes, [](const NodeValue& node) { return node.point; });
  out["normals"] = point_array(nodes, [](const NodeValue& node) { return node.normal; });
  out["values"] = approximation_arrays(nodes, [](const NodeValue& node) { return node.u_n; });
  out["emission"] = owning_array(std::move(emission));
  out["solution"] = has_u ? py::object(owning_array(std::move(u))) : py::object(py::none());
  out["elements"] = owning_array(std::move(elements));
  out["pieces"] = pieces;
  return out;
}

/// The corners of the elements of one level, and u_n there.
py::dict elements_of(const Solution& solution, std::size_t place) {
  require_place(place, solution.levels.size());
  const std::vector<ElementValue>& elements = solution.levels[place].elements;
  std::vector<double> corners;
  std::vector<double> values;
  py::list pieces;
  for (const ElementValue& element : elements) {
    for (const Vector<double>& p : element.corners) corners.insert(corners.end(), {p.x, p.y, p.z});
    values.insert(values.end(), element.corner_values.begin(), element.corner_values.end());
    pieces.append(element.piece);
  }
  const auto count = static_cast<py::ssize_t>(elements.size());
  py::dict out;
  out["corners"] = owning_array(std::move(corners), {count, 3, 3});
  out["values"] = owning_array(std::move(values), {count, 3});
  out["pieces"] = pieces;
  return out;
}

/// The computed function and its iterate at points of the surface.
py::dict at(const Solution& solution, std::size_t place, const py::object& points, double tolerance,
            bool iterated, const py::object& progress) {
  require_place(place, solution.levels.size());
  const DoubleArray rows = double_rows(points, 3, "points");
  std::vector<Vector<double>> wanted;
  const auto of = rows.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) wanted.push_back({of(i, 0), of(i, 1), of(i, 2)});
  const std::vector<ValueAt> found = compute(progress, [&](Progress& told) {
    return app::solution_at(solution.result.problem, solution.levels[place], wanted,
                            {.tolerance = tolerance, .iterated = iterated}, told);
  });
  py::list pieces;
  std::vector<double> distances;
  for (const ValueAt& value : found) {
    pieces.append(value.piece);
    distances.push_back(value.distance);
  }
  py::dict out;
  out["points"] = point_array(found, [](const ValueAt& value) { return value.point; });
  out["distance"] = owning_array(std::move(distances));
  out["pieces"] = pieces;
  out["u_n"] = approximation_arrays(found, [](const ValueAt& value) { return value.u_n; });
  out["iterated"] = iterated ? py::object(approximation_arrays(
                                   found, [](const ValueAt& value) { return value.iterated->value; }))
                             : py::object(py::none());
  return out;
}

std::string svg_of(const Solution& solution, const std::string& title) {
  const Plot plot = convergence_plot(
      title, {.name = {}, .levels = solution.result.levels, .orders = solution.result.orders});
  if (plot.curves.empty())
    throw InputError({.source = "plot",
                      .problem = "has no error that is positive at two levels",
                      .allowed = "a problem with a solution, and two levels or more"});
  return svg_text(plot);
}

py::object fits_of(const Solution& solution) { return object_of(orders_json(solution.result.orders)); }

}  // namespace

void add_solutions(py::module_& module) {
  py::class_<Solution>(module, "Solution")
      .def_property_readonly("levels",
                             [](const Solution& s) {
                               return level_array(s,
                                                  [](const LevelResult& l) { return std::int64_t{l.level}; });
                             })
      .def_property_readonly(
          "elements",
          [](const Solution& s) {
            return level_array(s, [](const LevelResult& l) { return static_cast<std::int64_t>(l.elements); });
          })
      .def_property_readonly(
          "unknowns",
          [](const Solution& s) {
            return level_array(s, [](const LevelResult& l) { return static_cast<std::int64_t>(l.unknowns); });
          })
      .def_property_readonly(
          "mesh_size",
          [](const Solution& s) { return level_array(s, [](const LevelResult& l) { return l.mesh_size; }); })
      .def_property_readonly("norm_K",
                             [](const Solution& s) {
                               return approximation_arrays(s.result.levels,
                                                           [](const LevelResult& l) { return l.norm_K; });
                             })
      .def_property_readonly("solvers",
                             [](const Solution& s) {
                               py::list out;
                               for (const LevelResult& level : s.result.levels) out.append(level.solver);
                               return out;
                             })
      .def_property_readonly(
          "seconds",
          [](const Solution& s) {
            std::vector<double> out;
            for (const LevelTiming& t : s.result.timing)
              out.push_back(t.assembly_seconds + t.operator_seconds + t.solve_seconds + t.iterated_seconds);
            return owning_array(std::move(out));
          })
      .def("error", error_of, py::arg("name"))
      .def("orders", orders_of, py::arg("name"))
      .def("means", means_of)
      .def("fits", fits_of)
      .def("nodes", nodes_of, py::arg("place"))
      .def("corners", elements_of, py::arg("place"))
      .def("at", at, py::arg("place"), py::arg("points"), py::arg("tolerance"), py::arg("iterated"),
           py::arg("progress"))
      .def("json",
           [](const Solution& s) { return object_of(result_json(s.result, "radcert.Problem.solve")); })
      .def("latex", [](const Solution& s) { return py::bytes(levels_latex(s.result)); })
      .def("svg", [](const Solution& s, const std::string& title) { return py::bytes(svg_of(s, title)); })
      .def("csv", [](const Solution& s) { return py::bytes(errors_csv(s.result)); })
      .def("nodes_csv", [](const Solution& s) { return py::bytes(nodes_csv(s.levels)); })
      .def("vtu",
           [](const Solution& s) {
             const auto& elements = s.levels.back().elements;
             return py::bytes(vtu_text(elements, corner_errors(s.result.problem, elements)));
           })
      .def("ply", [](const Solution& s) {
        const auto& elements = s.levels.back().elements;
        return py::bytes(ply_text(elements, corner_errors(s.result.problem, elements)));
      });
  module.def("error_names", [] {
    std::vector<std::string> out;
    for (const ErrorKind& kind : error_kinds()) out.push_back(kind.name);
    return out;
  });
}

}  // namespace radcert::python
