// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <string>

#include "exact.h"
#include "json.h"
#include "python.h"
#include "records/edge_records.h"
#include "work.h"

namespace radcert::python {

namespace {

py::object edge_of(const py::object& angle, const py::object& rho, const py::object& rho_other,
                   const py::object& up_to, std::int64_t digits) {
  const auto text = [](const py::object& number, const std::string& place) {
    return exact_text_of(number, place, "an exact number");
  };
  const app::EdgeRequest request =
      app::edge_request({.angle = text(angle, "angle"),
                         .rho = text(rho, "rho"),
                         .rho_other = rho_other.is_none() ? std::string() : text(rho_other, "rho_other"),
                         .up_to = text(up_to, "up_to"),
                         .digits = std::to_string(digits)},
                        OptionStyle::argument);
  const JsonValue found =
      compute(py::none(), [&](Progress&) { return edge_json(app::edge_record(request), "radcert.edge"); });
  return object_of(found);
}

}  // namespace

void add_edges(py::module_& module) {
  module.def("edge", edge_of, py::arg("angle"), py::arg("rho"), py::arg("rho_other"), py::arg("up_to"),
             py::arg("digits"));
}

}  // namespace radcert::python
