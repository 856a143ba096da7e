// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "json.h"
#include "python.h"
#include "radcert/core/memory_plan.h"
#include "radcert/formats/problem/experiment_file.h"
#include "radcert/formats/result/experiment_json.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/formats/table/latex_table.h"
#include "radcert/reference/operator_integral.h"
#include "radcert/study/study.h"
#include "requests/solve_request.h"
#include "requests/store.h"
#include "work.h"

namespace radcert::python {

namespace {

/// An experiment from a document as its file has it.
struct ExperimentRun {
  Experiment experiment;
  std::vector<Result> results;
};

ExperimentRun run_experiment(const py::object& document, const std::string& source, const std::string& store,
                             const py::object& progress) {
  const std::string text = with_source(source, [&] { return json_of(document).compact(); });
  return compute(progress, [&](Progress& told) {
    ExperimentRun out{.experiment = parse_experiment(text, source), .results = {}};
    const std::uint64_t memory = available_memory();
    for (const Combination& combination : out.experiment.combinations)
      with_combination(combination, source, [&] { check(combination.problem, memory); });
    ResultStore kept = app::store_named(store);
    StoredLevels levels(kept, solve_with(reference::applied_operator, memory));
    const auto all = static_cast<double>(out.experiment.combinations.size());
    for (const Combination& combination : out.experiment.combinations) {
      told.say(static_cast<double>(out.results.size()) / all, combination.name);
      std::vector<LevelResult> results;
      std::vector<LevelTiming> timing;
      for (const int level : combination.problem.triangulation.levels)
        with_combination(combination, source, [&] {
          const LevelOutcome outcome = levels.level(combination.problem, level);
          results.push_back(outcome.result);
          timing.push_back(outcome.timing);
        });
      out.results.push_back(collect(combination.problem, std::move(results), std::move(timing)));
    }
    app::warn_where_nothing_is_kept(kept, store, told);
    return out;
  });
}

}  // namespace

void add_experiments(py::module_& module) {
  module.def("run_experiment", run_experiment, py::arg("document"), py::arg("source"), py::arg("store"),
             py::arg("progress"));
  py::class_<ExperimentRun>(module, "ExperimentRun")
      .def_property_readonly("names",
                             [](const ExperimentRun& run) {
                               std::vector<std::string> out;
                               for (const Combination& each : run.experiment.combinations)
                                 out.push_back(each.name);
                               return out;
                             })
      .def("solutions",
           [](const ExperimentRun& run) {
             py::list out;
             for (const Result& result : run.results) out.append(py::cast(app::Solution{result, {}}));
             return out;
           })
      .def("json",
           [](const ExperimentRun& run) {
             return object_of(experiment_json(run.experiment, run.results, "radcert.experiment"));
           })
      .def("csv",
           [](const ExperimentRun& run) {
             return py::bytes(experiment_errors_csv(run.experiment, run.results));
           })
      .def("latex", [](const ExperimentRun& run) {
        return py::bytes(combinations_latex(run.experiment, run.results));
      });
}

}  // namespace radcert::python
