// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "arrays.h"
#include "exact.h"
#include "json.h"
#include "problem.h"
#include "python.h"
#include "radcert/certificate/certificate.h"
#include "radcert/core/errors.h"
#include "radcert/core/files/atomic_file.h"
#include "radcert/formats/field/vtu.h"
#include "radcert/formats/json/json_document.h"
#include "radcert/formats/problem/problem_parts.h"
#include "radcert/formats/result/certificate_json.h"
#include "radcert/formats/result/result_json.h"
#include "radcert/formats/result/stored_numbers.h"
#include "radcert/scalar/enclosing_text.h"
#include "radcert/study/certified_solution.h"
#include "requests/store.h"
#include "work.h"

namespace radcert::python {

namespace {

/// An enclosure of the solution itself, with what proves it where that was asked for.
struct Enclosed {
  Result result;
  std::optional<std::string> certificate;

  [[nodiscard]] const SolutionEnclosure& enclosure() const { return *result.enclosure; }
};

/// "4 layers of degree 6, width 1e-3": how far the search has come.
std::string words_of(const GuaranteeProgress& now) {
  return std::to_string(now.layers) + " layers, degree " + std::to_string(now.degree) + ", width " +
         upper_text(now.width);
}

std::string words_of(const MeshProgress& now) {
  const std::string mesh = std::to_string(now.layers) + " layers, degree " + std::to_string(now.degree);
  if (now.cells == 0 && now.planned > 0)
    return mesh + ", cells planned on " + std::to_string(now.planned) + " of " +
           std::to_string(now.elements) + " elements";
  return mesh + ", cells " + std::to_string(now.cells_done) + " of " + std::to_string(now.cells);
}

double part_of(const MeshProgress& now) {
  return now.cells == 0 ? 0 : static_cast<double>(now.cells_done) / static_cast<double>(now.cells);
}

Enclosed enclose(PythonProblem problem, const py::object& document, bool with_certificate,
                 const std::string& store, const py::object& progress) {
  const JsonValue json = with_source("guarantee", [&] { return json_of(document); });
  problem.problem.guarantee = with_source(
      "guarantee", [&] { return read_guarantee(JsonReader(json), pieces_of(problem.problem.surface)); });
  return compute(progress, [&](Progress& told) {
    return with_source(problem.source, [&] {
      const Guarantee& wanted = *problem.problem.guarantee;
      check_guarantee(problem.problem, wanted);
      if (with_certificate) check_certified(problem.problem, wanted);
      ResultStore folder = app::store_named(store);
      // A mesh or nodes of Python's own stand in the key by their digests.
      StoredNumbers kept(folder, guarantee_key(problem.problem, with_certificate));
      const GuaranteeContext context{
          .progress = [&](const GuaranteeProgress& now) { told.say(0, words_of(now)); },
          .meshes = [&](const MeshProgress& now) { told.say(part_of(now), words_of(now)); },
          .kept = &kept};
      Enclosed out;
      LevelResult level;
      SolutionEnclosure enclosure;
      if (with_certificate) {
        CertifiedSolution found = certified_solution(problem.problem, wanted, context);
        out.certificate = certificate_text(found.certificate, "radcert.Problem.guarantee");
        level = std::move(found.level);
        enclosure = std::move(found.enclosure);
      } else {
        std::tie(level, enclosure) = solve_within(problem.problem, wanted, context);
      }
      app::warn_where_nothing_is_kept(folder, store, told);
      out.result = {.problem = problem.problem,
                    .levels = {std::move(level)},
                    .orders = {},
                    .timing = {{}},
                    .enclosure = std::move(enclosure)};
      return out;
    });
  });
}

py::object means_of(const std::vector<std::pair<std::string, Approximation>>& pieces) {
  py::dict out;
  for (const auto& [piece, mean] : pieces)
    out[py::str(piece)] = py::make_tuple(mean.value, mean.radius, mean.guaranteed);
  return out;
}

py::object points_of(const std::vector<EnclosedValue>& points) {
  py::list out;
  for (const EnclosedValue& value : points)
    out.append(py::dict(py::arg("piece") = value.piece,
                        py::arg("at") = py::make_tuple(fraction_of(value.at.x), fraction_of(value.at.y),
                                                       fraction_of(value.at.z)),
                        py::arg("value") = value.value.value, py::arg("radius") = value.value.radius,
                        py::arg("guaranteed") = value.value.guaranteed));
  return out;
}

py::object function_of(const Enclosed& enclosed) {
  const auto& function = enclosed.enclosure().function;
  if (!function) return py::none();
  py::list pieces;
  for (const FunctionBound::OnPiece& piece : function->pieces)
    pieces.append(py::dict(py::arg("piece") = piece.piece, py::arg("outside") = piece.outside,
                           py::arg("everywhere") = piece.everywhere));
  return py::dict(py::arg("sup") = function->sup, py::arg("outside") = function->outside,
                  py::arg("faces_are_cut") = function->faces_are_cut, py::arg("pieces") = pieces);
}

/// A certificate read and checked again.
py::dict checked(const std::string& file, const std::optional<std::int64_t>& elements,
                 const std::optional<std::string>& seed, const py::object& progress) {
  if (elements && *elements < 1)
    throw InputError({.source = "elements",
                      .value = std::to_string(*elements),
                      .allowed = "a whole number from 1 on, or None for all"});
  struct Verdict {
    ReadCertificate read;
    certificate::Report report;
  };
  const Verdict verdict = compute(progress, [&](Progress& told) {
    const std::string text = with_source(file, [&] { return read_file(file, json_size_limit); });
    Verdict out{.read = read_certificate(text, file), .report = {}};
    if (!out.read.digest_holds) {
      out.report.refusal = certificate::Refusal{"/digest", "is not that of the content"};
      return out;
    }
    const std::size_t count = certificate::part_count(out.read.certificate);
    const std::size_t part = elements ? std::min(count, static_cast<std::size_t>(*elements)) : count;
    out.report = certificate::check(
        out.read.certificate, {.elements = part, .seed = seed.value_or(out.read.digest)},
        [&](std::size_t done) {
          told.say(static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(part, 1)),
                   "elements");
        });
    return out;
  });
  py::dict means;
  py::list points;
  py::object refusal = py::none();
  py::object function = py::none();
  py::object outside = py::none();
  const certificate::Certificate& c = verdict.read.certificate;
  if (verdict.report.refusal) {
    refusal = py::str(verdict.report.refusal->pointer + ": " + verdict.report.refusal->says);
  } else {
    for (const certificate::CertifiedNumber& number : certificate::numbers(c)) {
      const py::tuple enclosed =
          py::make_tuple(fraction_of(number.enclosure.midpoint), fraction_of(number.enclosure.radius));
      if (!number.at) {
        means[py::str(number.piece)] = enclosed;
        continue;
      }
      const Vector<Rational>& at = *number.at;
      points.append(
          py::dict(py::arg("piece") = number.piece,
                   py::arg("at") = py::make_tuple(fraction_of(at.x), fraction_of(at.y), fraction_of(at.z)),
                   py::arg("value") = enclosed));
    }
    if (const std::optional<certificate::BoundAtDistance> bound = certificate::function_bound(c)) {
      function = fraction_of(bound->sup);
      outside = fraction_of(bound->outside);
    }
  }
  return py::dict(py::arg("verified") = !verdict.report.refusal.has_value(), py::arg("refusal") = refusal,
                  py::arg("elements") = certificate::part_count(c),
                  py::arg("looked_at") = verdict.report.looked_at.size(), py::arg("means") = means,
                  py::arg("points") = points, py::arg("function") = function, py::arg("outside") = outside);
}

}  // namespace

void add_guarantees(py::module_& module) {
  module.def("enclose", enclose, py::arg("problem"), py::arg("guarantee"), py::arg("certificate"),
             py::arg("store"), py::arg("progress"));
  module.def("check_certificate", checked, py::arg("file"), py::arg("elements"), py::arg("seed"),
             py::arg("progress"));
  py::class_<Enclosed>(module, "Enclosed")
      .def_property_readonly("width", [](const Enclosed& e) { return e.enclosure().width; })
      .def_property_readonly("wanted",
                             [](const Enclosed& e) { return fraction_of(e.enclosure().wanted.width); })
      .def_property_readonly("hindrance", [](const Enclosed& e) { return e.enclosure().hindrance; })
      .def_readonly("certificate", &Enclosed::certificate)
      .def("means", [](const Enclosed& e) { return means_of(e.enclosure().pieces); })
      .def("points", [](const Enclosed& e) { return points_of(e.enclosure().points); })
      .def("emissions",
           [](const Enclosed& e) {
             py::dict out;
             for (const SolutionEnclosure::OfEmission& own : e.enclosure().emissions)
               out[py::str(own.emission)] = py::make_tuple(means_of(own.pieces), points_of(own.points));
             return out;
           })
      .def("function", function_of)
      .def("json",
           [](const Enclosed& e) { return object_of(result_json(e.result, "radcert.Problem.guarantee")); })
      .def("vtu", [](const Enclosed& e) {
        if (e.enclosure().wanted.of == EnclosedQuantity::means)
          throw InputError({.source = "vtu",
                            .problem = "is of values or of a function, and these are means",
                            .allowed = "of=\"values\" or of=\"function\""});
        return py::bytes(vtu_text(e.enclosure()));
      });
}

}  // namespace radcert::python
