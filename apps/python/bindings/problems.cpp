// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "json.h"
#include "mesh.h"
#include "nodes.h"
#include "own_functions.h"
#include "problem.h"
#include "python.h"
#include "radcert/core/errors.h"
#include "radcert/formats/problem/problem_json.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/solve/linear_solver.h"
#include "radcert/surface/catalogue.h"
#include "requests/solve_request.h"
#include "work.h"

namespace radcert::python {

namespace {

PythonProblem problem_from(const py::object& document, const std::string& source,
                           const SurfaceChoice* surface, const Nodes* nodes, const py::dict& functions,
                           bool basis_by_functions) {
  JsonValue json = with_source(source, [&] { return json_of(document); });
  std::optional<SurfaceChoice> chosen;
  if (surface != nullptr) chosen = *surface;
  PythonProblem out;
  out.source = source;
  std::optional<Method> method;
  if (nodes != nullptr) method = Collocation{node_file_basis(*nodes->file, nodes->name)};
  out.problem = compute(py::none(), [&](Progress&) { return problem_of(json, source, chosen, method); });
  with_source(source, [&] {
    const LinearSolver* solver = find_linear_solver(out.problem.solver.name);
    if (basis_by_functions && solver != nullptr && solver->proves())
      throw InputError(
          {.pointer = "/solver/name",
           .value = out.problem.solver.name,
           .problem = "proves nothing where the basis was made of functions of Python",
           .allowed = "a solver that estimates, or the polynomials that were found, as a space"});
    for (const auto& [part, function] : functions)
      set_function(out.problem, py::str(part), py::reinterpret_borrow<py::object>(function));
  });
  return out;
}

app::Solution solved(const PythonProblem& given, const std::string& store, const py::object& progress) {
  return compute(progress,
                 [&](Progress& told) { return app::solved(given.problem, given.source, store, told); });
}

py::list surface_listing() {
  py::list out;
  for (const SurfaceDescription& surface : surface_catalogue()) {
    py::list parameters;
    for (const ParameterDescription& parameter : surface.parameters)
      parameters.append(
          py::dict(py::arg("name") = parameter.name, py::arg("default") = parameter.default_text,
                   py::arg("requirement") = parameter.requirement, py::arg("meaning") = parameter.meaning));
    out.append(py::dict(py::arg("name") = surface.name, py::arg("summary") = surface.summary,
                        py::arg("pieces") = surface.pieces, py::arg("parameters") = parameters,
                        py::arg("served") = surface.unoccluded));
  }
  return out;
}

}  // namespace

void add_problems(py::module_& module) {
  py::class_<SurfaceChoice>(module, "SurfaceChoice")
      .def_static("named",
                  [](const py::object& document) {
                    const JsonValue json = json_of(document, "");
                    return with_source("surface", [&] { return read_surface(JsonReader(json), {}); });
                  })
      .def_static(
          "of_mesh",
          [](const Mesh& mesh) { return compute(py::none(), [&](Progress&) { return mesh.surface(); }); })
      .def_readonly("name", &SurfaceChoice::name)
      .def_property_readonly("pieces", [](const SurfaceChoice& surface) { return pieces_of(surface); });
  py::class_<PythonProblem>(module, "Problem")

      .def_static("of_document", problem_from, py::arg("document"), py::arg("source"), py::arg("surface"),
                  py::arg("nodes"), py::arg("functions"), py::arg("basis_by_functions"))
      .def_static(
          "read",
          [](const std::string& file) {
            return PythonProblem{compute(py::none(), [&](Progress&) { return read_problem(file); }), file};
          })
      .def("json", [](const PythonProblem& problem) { return object_of(problem_json(problem.problem)); })
      .def("text", [](const PythonProblem& problem) { return problem_text(problem.problem); })
      .def("check",
           [](const PythonProblem& problem) {
             return compute(py::none(), [&](Progress&) {
               with_source(problem.source, [&] { check(problem.problem, available_memory()); });
               return true;
             });
           })
      .def("solve", solved, py::arg("store"), py::arg("progress"));
  module.def("surfaces", surface_listing);
  module.def("solvers", [] {
    std::vector<std::string> out;
    for (const LinearSolver& solver : linear_solvers()) out.push_back(solver.name);
    return out;
  });
}

}  // namespace radcert::python
