// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "exact.h"
#include "mesh.h"
#include "python.h"
#include "radcert/core/errors.h"
#include "radcert/factors/input/factor_scene.h"
#include "radcert/formats/table/factor_comparison.h"
#include "radcert/formats/table/factors_csv.h"
#include "radcert/formats/table/unoccluded_factor.h"
#include "radcert/surface/catalogue.h"
#include "requests/factor_request.h"
#include "work.h"

namespace radcert::python {

namespace {

using app::Factors;
using app::FactorWish;

constexpr const char* command = "radcert.factors";

Factors of_mesh(const Mesh& mesh, const std::string& by, const std::optional<double>& accuracy,
                bool certified, bool rays, bool space, const std::string& store, const py::object& progress) {
  const FactorWish wish{
      .by = by, .accuracy = accuracy, .certified = certified, .rays = rays, .unit = mesh.unit};
  app::check(wish, !mesh.choice.two_sided.empty());
  FactorSceneChoice choice = mesh.choice;
  choice.space = space;
  choice.degrees = mesh.angle.to_double();
  return compute(progress, [&](Progress& told) {
    return app::factors_of(factor_scene(mesh.name, mesh.file, choice, OptionStyle::argument), command,
                           mesh.name, wish, store, told);
  });
}

Factors of_surface(const SurfaceChoice& surface, std::int64_t level, const std::string& by,
                   const std::optional<double>& accuracy, bool certified, bool rays, bool space,
                   const std::string& store, const py::object& progress) {
  const FactorWish wish{.by = by, .accuracy = accuracy, .certified = certified, .rays = rays};
  app::check(wish, false);
  if (surface.mesh)
    throw InputError({.source = surface.name,
                      .problem = "has charts of Python, of which no factors are taken",
                      .allowed = "a surface of the catalogue, or a mesh"});
  constexpr std::int64_t most = 8;
  if (level < 0 || level > most)
    throw InputError(
        {.source = "level", .value = std::to_string(level), .allowed = "a whole number from 0 to 8"});
  return compute(progress, [&](Progress& told) {
    Problem problem;
    problem.surface = surface;
    const Surface made = surface_of(problem);
    return app::factors_of(
        factor_scene(surface.name, made, static_cast<int>(level), space, OptionStyle::argument), command,
        surface.name, wish, store, told);
  });
}

/// The square array of a number of each entry, what is not there 0 exactly.
template <class Number>
py::array_t<double> square(const Factors& factors, const Number& number) {
  const std::size_t n = factors.count();
  MemoryPlan plan;
  plan.add("a square array", std::uint64_t{n} * n, sizeof(double)).require(available_memory());
  std::vector<double> numbers(n * n, 0.0);
  for (const ConfigurationFactor& entry : factors.report.matrix.entries)
    numbers[entry.from * n + entry.to] = number(entry.factor);
  const auto side = static_cast<py::ssize_t>(n);
  return owning_array(std::move(numbers), {side, side});
}

py::tuple entries(const Factors& factors) {
  const auto& all = factors.report.matrix.entries;
  std::vector<std::int64_t> from;
  std::vector<std::int64_t> to;
  for (const ConfigurationFactor& entry : all) {
    from.push_back(static_cast<std::int64_t>(entry.from));
    to.push_back(static_cast<std::int64_t>(entry.to));
  }
  const py::tuple numbers = approximation_arrays(all, [](const auto& entry) { return entry.factor; });
  return py::make_tuple(owning_array(std::move(from)), owning_array(std::move(to)), numbers[0], numbers[1]);
}

py::object to_space(const Factors& factors) {
  if (!factors.report.open) return py::none();
  return approximation_arrays(factors.report.matrix.rows, [](const FactorRow& row) {
    return row.to_space.value_or(Approximation::exact(0));
  });
}

/// Factors that Python has as a square array, rows and columns in the order of the names.
ClaimedFactors claimed_array(const Factors& factors, const py::handle& object, double halfwidth) {
  const std::string allowed =
      "a square array of doubles with " + std::to_string(factors.count()) + " rows, in the order of names";
  const DoubleArray array = double_array(object, "other", allowed);
  const auto side = static_cast<py::ssize_t>(factors.count());
  if (array.ndim() != 2 || array.shape(0) != side || array.shape(1) != side)
    throw InputError({.pointer = "other",
                      .value = array_words(array),
                      .problem = "has another shape",
                      .allowed = allowed});
  const auto at = array.unchecked<2>();
  ClaimedFactors out;
  for (py::ssize_t i = 0; i < side; ++i)
    for (py::ssize_t j = 0; j < side; ++j) {
      if (!std::isfinite(at(i, j)))
        throw InputError({.pointer = "other/" + std::to_string(i) + "/" + std::to_string(j),
                          .value = shortest(at(i, j)),
                          .problem = "is not finite",
                          .allowed = "finite numbers"});
      out.emplace(std::pair(factors.units.names[static_cast<std::size_t>(i)],
                            factors.units.names[static_cast<std::size_t>(j)]),
                  ClaimedFactor{Rational::exactly(at(i, j)), Rational::exactly(halfwidth)});
    }
  return out;
}

double tolerance_at(const std::string& name, double value, double most) {
  if (value >= 0 && value <= most) return value;
  throw InputError(
      {.source = name, .value = shortest(value), .allowed = "a number from 0 to " + shortest(most)});
}

struct Comparison {
  std::vector<FactorComparison> pairs;
  std::vector<std::string> names;
};

Comparison compare(const Factors& factors, const py::object& other, double absolute, double relative,
                   double halfwidth) {
  const FactorTolerance tolerance{.absolute = tolerance_at("tolerance", absolute, 1),
                                  .relative = tolerance_at("relative", relative, 1)};
  const double off = tolerance_at("halfwidth", halfwidth, 1);
  const bool is_file = py::isinstance<py::str>(other);
  std::string file;
  ClaimedFactors claimed;
  if (is_file)
    file = std::string(py::str(other));
  else
    claimed = claimed_array(factors, other, off);
  Comparison out{.pairs = {}, .names = factors.units.names};
  out.pairs = compute(py::none(), [&](Progress&) {
    if (is_file) claimed = read_factors(file, factors.units.names);
    return with_source(is_file ? file : "other", [&] {
      std::vector<FactorComparison> pairs =
          compared(factors.report.matrix, factors.units.names, claimed, tolerance);
      explain(pairs, factors.report.matrix, factors.units.names, claimed,
              unoccluded_factor(factors.scene->scene, factors.units));
      return pairs;
    });
  });
  return out;
}

void add_comparison(py::module_& module) {
  py::class_<FactorComparison>(module, "FactorPair", "A pair of surfaces in two matrices of factors.")
      .def_readonly("from_", &FactorComparison::from, "the surface that light leaves")
      .def_readonly("to", &FactorComparison::to)
      .def_property_readonly("ours", [](const FactorComparison& pair) { return pair.ours.value; })
      .def_property_readonly("radius", [](const FactorComparison& pair) { return pair.ours.radius; })
      .def_property_readonly("guaranteed", [](const FactorComparison& pair) { return pair.ours.guaranteed; })
      .def_property_readonly("theirs",
                             [](const FactorComparison& pair) { return pair.theirs.in_double().value; })
      .def_property_readonly("halfwidth",
                             [](const FactorComparison& pair) { return pair.theirs.in_double().radius; })
      .def_property_readonly("difference", [](const FactorComparison& pair) { return pair.difference(); })
      .def_property_readonly(
          "verdict", [](const FactorComparison& pair) { return agreement_word(pair.agreement); },
          "\"agrees\", \"differs\" or \"undecided\"")
      .def_readonly("cause", &FactorComparison::cause, "where they differ a guess at why, else \"\"")
      .def("__repr__", [](const FactorComparison& pair) {
        return "<FactorPair " + pair.from + " to " + pair.to + ": ours " + shortest(pair.ours.value) +
               ", theirs " + shortest(pair.theirs.in_double().value) + ", " + agreement_word(pair.agreement) +
               (pair.cause.empty() ? "" : ": " + pair.cause) + ">";
      });
  py::class_<Comparison>(module, "Comparison")
      .def_readonly("pairs", &Comparison::pairs)
      .def("csv", [](const Comparison& comparison) { return py::bytes(comparison_csv(comparison.pairs)); })
      .def("svg", [](const Comparison& comparison) {
        if (comparison.names.size() > comparison_picture_rows)
          throw InputError({.source = "picture",
                            .value = std::to_string(comparison.names.size()) + " rows",
                            .allowed = "at most " + std::to_string(comparison_picture_rows)});
        return py::bytes(comparison_svg(comparison.pairs, comparison.names));
      });
}

}  // namespace

void add_factors(py::module_& module) {
  add_comparison(module);
  module.def("factors_of_mesh", of_mesh);
  module.def("factors_of_surface", of_surface);
  py::class_<Factors>(module, "Factors")
      .def_property_readonly("names", [](const Factors& factors) { return factors.units.names; })
      .def_property_readonly("by", [](const Factors& factors) { return factors.report.by; })
      .def_property_readonly("guaranteed",
                             [](const Factors& factors) { return factors.report.matrix.guaranteed; })
      .def_property_readonly("open", [](const Factors& factors) { return factors.report.open; })
      .def_property_readonly("facets_only", [](const Factors& factors) { return factors.report.facets_only; })
      .def_property_readonly("warnings", [](const Factors& factors) { return factors.report.warnings; })
      .def_readonly("failures", &Factors::failures)
      .def("value",
           [](const Factors& f) { return square(f, [](const Approximation& x) { return x.value; }); })
      .def("radius",
           [](const Factors& f) { return square(f, [](const Approximation& x) { return x.radius; }); })
      .def("entries", entries)
      .def("area",
           [](const Factors& f) {
             return approximation_arrays(f.report.matrix.rows, [](const FactorRow& row) { return row.area; });
           })
      .def("row_sum",
           [](const Factors& f) {
             return approximation_arrays(f.report.matrix.rows, [](const FactorRow& row) { return row.sum; });
           })
      .def("to_space", to_space)
      .def("closure",
           [](const Factors& f) {
             std::vector<double> out;
             for (std::size_t i = 0; i < f.count(); ++i) out.push_back(f.report.matrix.closure_defect(i));
             return owning_array(std::move(out));
           })
      .def_property_readonly("reciprocity",
                             [](const Factors& f) { return f.report.matrix.largest_reciprocity_defect; })
      .def("compare", compare, py::arg("other"), py::arg("absolute"), py::arg("relative"),
           py::arg("halfwidth"))
      .def("csv", [](const Factors& f) { return py::bytes(factors_csv(f.report.matrix, f.units.names)); })
      .def("surfaces_csv", [](const Factors& f) {
        return py::bytes(factor_surfaces_csv(f.report.matrix, f.units.names, f.report.unit));
      });
}

}  // namespace radcert::python
