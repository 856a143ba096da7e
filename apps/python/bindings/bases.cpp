// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arrays.h"
#include "exact.h"
#include "json.h"
#include "nodes.h"
#include "python.h"
#include "radcert/core/errors.h"
#include "radcert/core/text.h"
#include "radcert/formats/problem/node_file.h"
#include "radcert/formats/result/basis_json.h"
#include "radcert/polynomial/nodes/symmetric_nodes.h"
#include "radcert/study/triangle_basis_choice.h"
#include "records/basis_records.h"
#include "work.h"

namespace radcert::python {

namespace {

constexpr int largest_inset_degree = 12;

int degree_of(std::int64_t degree, int least, int most) {
  if (degree >= least && degree <= most) return static_cast<int>(degree);
  throw InputError(
      {.source = "degree",
       .value = std::to_string(degree),
       .allowed = "a whole number from " + std::to_string(least) + " to " + std::to_string(most)});
}

py::list weights_of(const BasisRecord& record) {
  py::list out;
  for (const Rational& weight : record.facts.weights) out.append(fraction_of(weight));
  return out;
}

py::list nodes_of(const BasisRecord& record) {
  py::list out;
  for (const Barycentric<Rational>& node : record.facts.nodes)
    out.append(py::make_tuple(fraction_of(node.x[0]), fraction_of(node.x[1]), fraction_of(node.x[2])));
  return out;
}

std::string proof_word(PrecisionProof proof) {
  switch (proof) {
    case PrecisionProof::exact: return "exact";
    case PrecisionProof::algebraic: return "algebraic";
    case PrecisionProof::certificate: return "certificate";
  }
  return {};
}

py::object orders_of(const BasisRecord& record) {
  const PredictedOrders orders = record.orders();
  return py::dict(py::arg("everywhere") = orders.everywhere, py::arg("nodes") = orders.curved,
                  py::arg("nodes_logarithm") = orders.curved_has_logarithm,
                  py::arg("smooth_kernel") = orders.smooth_kernel, py::arg("edges") = orders.at_edges);
}

/// The values of a function of Python's at barycentric points, all of them finite.
DoubleArray function_values(const py::object& function, const py::object& points, const std::string& place) {
  const std::string allowed =
      "a function of barycentric coordinates (n, 3) that gives an array of doubles (n,)";
  if (PyCallable_Check(function.ptr()) == 0)
    throw InputError(
        {.pointer = place, .value = kind_of(function), .problem = "cannot be called", .allowed = allowed});
  const DoubleArray rows = double_rows(points, 3, "points");
  DoubleArray values = called(function, rows, place, {}, allowed);
  const auto x = rows.unchecked<2>();
  const auto at = values.unchecked<1>();
  for (py::ssize_t i = 0; i < at.shape(0); ++i)
    if (!std::isfinite(at(i)))
      throw InputError({.pointer = place,
                        .value = shortest(at(i)),
                        .problem = "is not finite at (" + shortest(x(i, 0)) + ", " + shortest(x(i, 1)) +
                                   ", " + shortest(x(i, 2)) + ")",
                        .allowed = allowed});
  return values;
}

}  // namespace

void add_bases(py::module_& module) {
  module.def("inset_facts", [](std::int64_t degree, const py::object& alpha) {
    const int wanted = degree_of(degree, 0, largest_inset_degree);
    std::string text;
    if (py::isinstance<py::str>(alpha))
      text = std::string(py::str(alpha));
    else if (!alpha.is_none())
      text = exact_text_of(alpha, "alpha", "a number in [0, 1/3), or \"superconvergent\"");
    return compute(py::none(),
                   [&](Progress&) { return app::inset_record(wanted, text, OptionStyle::argument); });
  });
  module.def("function_values", function_values);
  module.def("symmetric_facts", [](std::int64_t degree) {
    const int wanted = degree_of(degree, smallest_symmetric_degree, largest_symmetric_degree);
    return compute(py::none(), [&](Progress&) { return app::symmetric_record(wanted); });
  });
  py::class_<Nodes>(module, "Nodes")
      .def_static(
          "of_document",
          [](const std::string& name, const py::object& document) {
            const std::string text = with_source(name, [&] { return json_of(document).compact(); });
            return Nodes{name, std::make_shared<const NodeFile>(
                                   compute(py::none(), [&](Progress&) { return parse_nodes(text, name); }))};
          },
          py::arg("name"), py::arg("document"))
      .def_static("read",
                  [](const std::string& file) {
                    return Nodes{file, std::make_shared<const NodeFile>(
                                           compute(py::none(), [&](Progress&) { return read_nodes(file); }))};
                  })
      .def_readonly("name", &Nodes::name)
      .def_property_readonly("digest", [](const Nodes& nodes) { return nodes.file->digest; })
      .def("facts", [](const Nodes& nodes) {
        return compute(py::none(), [&](Progress&) { return app::basis_record(nodes.name, *nodes.file); });
      });
  py::class_<BasisRecord>(module, "BasisFacts", "What is known of interpolation at nodes on a triangle.")
      .def_readonly("family", &BasisRecord::family)
      .def_property_readonly("degree", [](const BasisRecord& record) { return record.facts.degree; })
      .def_property_readonly("reproduced", [](const BasisRecord& record) { return record.facts.reproduced; })
      .def_property_readonly("precision",
                             [](const BasisRecord& record) {
                               return py::dict(py::arg("triangle") = record.facts.triangle.degree,
                                               py::arg("parallelogram") = record.facts.parallelogram.degree,
                                               py::arg("proof") = proof_word(record.facts.proof));
                             })
      .def_property_readonly("weights", weights_of)
      .def_property_readonly("nodes", nodes_of)
      .def_property_readonly("orders", orders_of)
      .def("json", [](const BasisRecord& record) {
        return object_of(basis_record_json({&record, 1}, "radcert.Basis.facts"));
      });
}

}  // namespace radcert::python
