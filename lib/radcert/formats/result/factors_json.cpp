// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/formats/result/factors_json.h"
#include "radcert/formats/json/json_document.h"

#include <algorithm>
#include <utility>

namespace radcert {

namespace {

JsonValue comparison_json(const std::vector<FactorComparison>& pairs) {
  const auto count = [&](Agreement agreement) {
    return std::count_if(pairs.begin(), pairs.end(),
                         [&](const FactorComparison& pair) { return pair.agreement == agreement; });
  };
  JsonValue out = JsonValue::object();
  out.set("agrees", count(Agreement::agrees));
  out.set("differs", count(Agreement::differs));
  out.set("undecided", count(Agreement::undecided));
  JsonValue worst = JsonValue::array();
  for (std::size_t k = 0; k < std::min(pairs.size(), factors_json_worst); ++k) {
    const FactorComparison& pair = pairs[k];
    const Approximation theirs = pair.theirs.in_double();
    worst.push(JsonValue::object({{"from", pair.from},
                                  {"to", pair.to},
                                  {"ours", pair.ours.value},
                                  {"radius", pair.ours.radius},
                                  {"theirs", theirs.value},
                                  {"halfwidth", theirs.radius},
                                  {"verdict", agreement_word(pair.agreement)},
                                  {"cause", pair.cause.empty() ? JsonValue() : JsonValue(pair.cause)}}));
  }
  out.set("worst", std::move(worst));
  return out;
}

}  // namespace

double closure_bound(const FactorMatrix& matrix) {
  Ball largest = 0;
  for (const FactorRow& row : matrix.rows) largest = max(largest, abs(Ball(row.sum.value) - Ball(1)));
  return largest.upper_double();
}

JsonValue factors_report(const FactorReport& report) {
  const FactorMatrix& matrix = report.matrix;
  JsonValue out = document_head("factors", report.command);
  out.set("name", report.name);
  out.set("by", report.by);
  out.set("triangles", report.triangles);
  out.set("open", report.open);
  out.set("unit", report.unit);
  out.set("front", report.front);
  out.set("facets_only", report.facets_only);
  out.set("guaranteed", matrix.guaranteed);
  out.set("pairs", JsonValue::object({{"whole", matrix.whole_pairs},
                                      {"hidden", matrix.hidden_pairs},
                                      {"mixed", matrix.mixed_pairs}}));
  out.set("rays", matrix.rays);
  out.set("largest_radius", matrix.largest_radius());
  out.set("reciprocity_defect", matrix.largest_reciprocity_defect);
  out.set("closure_defect", report.open ? JsonValue() : JsonValue(closure_bound(matrix)));
  JsonValue surfaces = JsonValue::array();
  for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
    const FactorRow& row = matrix.rows[i];
    surfaces.push(JsonValue::object(
        {{"name", report.names[i]},
         {"area", row.area.value},
         {"row_sum", row.sum.value},
         {"row_radius", row.sum.radius},
         {"to_space", row.to_space ? JsonValue(row.to_space->value) : JsonValue()},
         {"area_radius", row.area.radius},
         {"to_space_radius", row.to_space ? JsonValue(row.to_space->radius) : JsonValue()}}));
  }
  out.set("surfaces", std::move(surfaces));
  out.set("factors", json_array(matrix.entries, [&](const ConfigurationFactor& entry) {
            return JsonValue::object({{"from", report.names[entry.from]},
                                      {"to", report.names[entry.to]},
                                      {"factor", entry.factor.value},
                                      {"radius", entry.factor.radius},
                                      {"guaranteed", entry.factor.guaranteed}});
          }));
  out.set("warnings", json_array(report.warnings));
  out.set("comparison", report.comparison ? comparison_json(*report.comparison) : JsonValue());
  return out;
}

}  // namespace radcert
