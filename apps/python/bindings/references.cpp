// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <vector>

#include "exact.h"
#include "json.h"
#include "python.h"
#include "radcert/formats/result/reference_json.h"
#include "radcert/reference/continuous_means.h"
#include "radcert/reference/reference_value.h"
#include "requests/reference_request.h"
#include "work.h"

namespace radcert::python {

namespace {

ReferenceRecord reference_record(const std::string& name, const std::optional<std::int64_t>& digits,
                                 const py::dict& parameters) {
  std::vector<app::Setting> settings;
  for (const auto& [key, value] : parameters) {
    const std::string parameter = py::str(key);
    settings.push_back({parameter, exact_text_of(value, name + ": " + parameter, "an exact number")});
  }
  return compute(py::none(), [&](Progress&) { return app::requested_reference(name, settings, digits); });
}

/// All that can be asked for: name, kind, words, parameters with default and what is allowed.
py::list listing() {
  py::list out;
  for (const reference::NamedValue& value : reference::named_values())
    out.append(py::dict(py::arg("name") = value.name, py::arg("kind") = "value",
                        py::arg("summary") = reference::find_family(value.family)->summary,
                        py::arg("family") = value.family, py::arg("parameters") = py::dict()));
  for (const reference::ValueFamily& family : reference::value_families()) {
    py::dict parameters;
    for (const reference::ValueParameter& parameter : family.parameters)
      parameters[py::str(parameter.name)] =
          py::make_tuple(fraction_of(Rational::parse(parameter.default_text).value()), parameter.allowed);
    out.append(py::dict(py::arg("name") = family.name, py::arg("kind") = "family",
                        py::arg("summary") = family.summary, py::arg("family") = family.name,
                        py::arg("parameters") = parameters));
  }
  for (const reference::ContinuousMean& mean : reference::continuous_means())
    out.append(py::dict(py::arg("name") = mean.name, py::arg("kind") = "mean",
                        py::arg("summary") = mean.summary, py::arg("family") = mean.scene,
                        py::arg("parameters") = py::dict()));
  return out;
}

}  // namespace

void add_references(py::module_& module) {
  module.def("reference", reference_record, py::arg("name"), py::arg("digits"), py::arg("parameters"));
  module.def("references", listing);
  py::class_<ReferenceRoute>(module, "Route", "A way to a reference value, and the ball that it found.")
      .def_readonly("how", &ReferenceRoute::how, "the theorem, the catalogue number, the method")
      .def_readonly("ball", &ReferenceRoute::value)
      .def_readonly("certificate", &ReferenceRoute::certificate)
      .def("__repr__", [](const ReferenceRoute& route) {
        return "<Route " + route.how + ": " + route.value.to_text(20) + ">";
      });
  py::class_<ReferenceRecord>(module, "ReferenceRecord")
      .def_readonly("name", &ReferenceRecord::name)
      .def_readonly("digits", &ReferenceRecord::digits)
      .def_readonly("formula", &ReferenceRecord::formula)
      .def_readonly("source", &ReferenceRecord::source)
      .def_readonly("guaranteed", &ReferenceRecord::guaranteed)
      .def_readonly("routes", &ReferenceRecord::routes)
      .def_property_readonly("parameters",
                             [](const ReferenceRecord& record) {
                               py::dict out;
                               for (const auto& [name, value] : record.parameters)
                                 out[py::str(name)] =
                                     py::module_::import("fractions").attr("Fraction")(value);
                               return out;
                             })
      .def("decimal",
           [](const ReferenceRecord& record) {
             const BallDecimal text = reference_decimal(record.routes.front().value, record.digits);
             return py::make_tuple(text.midpoint, text.radius);
           })
      .def("json", [](const ReferenceRecord& record) {
        return object_of(reference_json(record, "radcert.reference"));
      });
}

}  // namespace radcert::python
