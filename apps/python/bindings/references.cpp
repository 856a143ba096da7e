// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <vector>

#include "exact.h"
#include "json.h"
#include "python.h"
#include "radcert/core/errors.h"
#include "radcert/formats/result/reference_json.h"
#include "radcert/reference/continuous_means.h"
#include "radcert/reference/reference_value.h"
#include "records/continuous_records.h"
#include "records/reference_records.h"
#include "work.h"

namespace radcert::python {

namespace {

constexpr int usual_digits = 20;

int digits_of(std::int64_t digits) {
  if (digits >= 1 && digits <= reference::most_reference_digits) return static_cast<int>(digits);
  throw InputError(
      {.source = "digits",
       .value = std::to_string(digits),
       .allowed = "a whole number from 1 to " + std::to_string(reference::most_reference_digits)});
}

ReferenceRecord continuous(const reference::ContinuousMean& mean, const std::vector<app::Setting>& settings,
                           std::optional<int> digits) {
  if (!settings.empty())
    throw InputError({.source = mean.name,
                      .value = settings.front().name,
                      .problem = "is for a family, and " + mean.name + " is one value"});
  ReferenceRecord record = app::continuous_record(mean);
  if (digits && *digits > record.digits)
    throw AccuracyNotReached(mean.name, "a radius of 1e-" + std::to_string(*digits) +
                                            " is not proved by its certificate, 1e-" +
                                            std::to_string(record.digits) + " is");
  return record;
}

ReferenceRecord reference_record(const std::string& name, const std::optional<std::int64_t>& digits,
                                 const py::dict& parameters) {
  std::vector<app::Setting> settings;
  for (const auto& [key, value] : parameters) {
    const std::string parameter = py::str(key);
    settings.push_back({parameter, exact_text_of(value, name + ": " + parameter, "an exact number")});
  }
  const std::optional<int> wanted = digits ? std::optional(digits_of(*digits)) : std::nullopt;
  return compute(py::none(), [&](Progress&) {
    if (const reference::ContinuousMean* mean = reference::find_continuous_mean(name))
      return continuous(*mean, settings, wanted);
    return app::record_of(app::wanted_reference(name, settings, OptionStyle::argument),
                          wanted.value_or(usual_digits));
  });
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
