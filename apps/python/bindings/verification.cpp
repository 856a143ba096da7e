// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <vector>

#include "json.h"
#include "python.h"
#include "radcert/core/errors.h"
#include "radcert/core/memory_plan.h"
#include "radcert/formats/result/stored_levels.h"
#include "radcert/reference/operator_integral.h"
#include "requests/store.h"
#include "verification/framework/reading/paper.h"
#include "verification/framework/run_verification.h"
#include "verification/report/report_text.h"
#include "work.h"

namespace radcert::python {

namespace {

using verification::ClaimReport;
using verification::Report;

Report verify(const std::vector<std::string>& words, const std::string& budget, const std::string& store,
              const py::object& progress) {
  const auto wanted = verification::budget_named(budget);
  if (!wanted) throw InputError({.source = "budget", .value = budget, .allowed = "quick, standard, full"});
  return compute(progress, [&](Progress& told) {
    const OperatorRoute route = reference::applied_operator;
    ResultStore kept = app::store_named(store);
    StoredLevels levels(kept, solve_with(route, available_memory()));
    const verification::Bench bench{.budget = *wanted, .route = route, .levels = levels, .store = kept};
    Report report = verification::run_verification(words, bench, [&](const verification::Progress& now) {
      told.say(now.total == 0 ? 0 : static_cast<double>(now.done) / static_cast<double>(now.total),
               now.statement);
    });
    app::warn_where_nothing_is_kept(kept, store, told);
    return report;
  });
}

/// The statements of the papers inside radcert: name, says, and the cells of a table.
py::list claim_listing() {
  py::list out;
  for (const verification::Paper& paper : verification::embedded_paper_list()) {
    const std::vector<std::string> labels = verification::statement_labels(paper);
    for (const verification::Claim& claim : paper.claims) {
      const std::string name = paper.key + "/" + claim.label;
      py::list cells;
      for (const std::string& label : labels)
        if (label.starts_with(claim.label + ".")) cells.append(paper.key + "/" + label);
      out.append(py::dict(py::arg("name") = name, py::arg("says") = claim.says, py::arg("cells") = cells));
    }
  }
  return out;
}

}  // namespace

void add_verification(py::module_& module) {
  module.def("claims", claim_listing);
  module.def("verify", verify, py::arg("words"), py::arg("budget"), py::arg("store"), py::arg("progress"));
  py::class_<ClaimReport>(module, "Statement",
                          "What a run found of one statement, or of one cell of a table.")
      .def_property_readonly("name", [](const ClaimReport& claim) { return claim.paper + "/" + claim.label; })
      .def_readonly("says", &ClaimReport::says)
      .def_property_readonly(
          "verdict", [](const ClaimReport& claim) { return std::string(verification::name(claim.found)); })
      .def_property_readonly(
          "recorded",
          [](const ClaimReport& claim) { return std::string(verification::name(claim.recorded)); })
      .def_property_readonly("as_recorded", [](const ClaimReport& claim) { return claim.as_recorded(); })
      .def_property_readonly(
          "value",
          [](const ClaimReport& claim) -> py::object {
            if (!claim.ours) return py::none();
            return py::make_tuple(claim.ours->value, claim.ours->radius, claim.ours->guaranteed);
          },
          "(value, radius, guaranteed) of what was computed here, None where there is no number")
      .def_readonly("printed", &ClaimReport::printed)
      .def_readonly("note", &ClaimReport::note)
      .def_readonly("remarks", &ClaimReport::remarks)
      .def_readonly("failure", &ClaimReport::failure)
      .def_readonly("seconds", &ClaimReport::seconds)
      .def("__repr__", [](const ClaimReport& claim) {
        return "<Statement " + claim.paper + "/" + claim.label + ": " +
               std::string(verification::name(claim.found)) +
               (claim.as_recorded() ? "" : ", recorded " + std::string(verification::name(claim.recorded))) +
               ">";
      });
  py::class_<Report>(module, "Report")
      .def_readonly("statements", &Report::claims)
      .def_property_readonly("as_recorded", [](const Report& report) { return report.as_recorded(); })
      .def("text", [](const Report& report) { return verification::report_table(report); })
      .def("json", [](const Report& report) {
        return object_of(verification::report_json(report, "radcert.verify"));
      });
}

}  // namespace radcert::python
