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
    JsonValue line = JsonValue::object();
    line.set("from", pair.from);
    line.set("to", pair.to);
    line.set("ours", pair.ours.value);
    line.set("radius", pair.ours.radius);
    line.set("theirs", pair.theirs.value);
    line.set("halfwidth", pair.theirs.halfwidth);
    line.set("verdict", agreement_word(pair.agreement));
    worst.push(std::move(line));
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
  out.set("facets_only", report.facets_only);
  out.set("guaranteed", matrix.guaranteed);
  JsonValue pairs = JsonValue::object();
  pairs.set("whole", matrix.whole_pairs);
  pairs.set("hidden", matrix.hidden_pairs);
  pairs.set("mixed", matrix.mixed_pairs);
  out.set("pairs", std::move(pairs));
  out.set("largest_radius", matrix.largest_radius());
  out.set("reciprocity_defect", matrix.largest_reciprocity_defect);
  out.set("closure_defect", report.open ? JsonValue() : JsonValue(closure_bound(matrix)));
  JsonValue surfaces = JsonValue::array();
  for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
    const FactorRow& row = matrix.rows[i];
    JsonValue line = JsonValue::object();
    line.set("name", report.names[i]);
    line.set("area", row.area.value);
    line.set("row_sum", row.sum.value);
    line.set("row_radius", row.sum.radius);
    line.set("to_space", row.to_space ? JsonValue(row.to_space->value) : JsonValue());
    line.set("area_radius", row.area.radius);
    line.set("to_space_radius", row.to_space ? JsonValue(row.to_space->radius) : JsonValue());
    surfaces.push(std::move(line));
  }
  out.set("surfaces", std::move(surfaces));
  out.set("factors", json_array(matrix.entries, [&](const ConfigurationFactor& entry) {
            JsonValue line = JsonValue::object();
            line.set("from", report.names[entry.from]);
            line.set("to", report.names[entry.to]);
            line.set("factor", entry.factor.value);
            line.set("radius", entry.factor.radius);
            line.set("guaranteed", entry.factor.guaranteed);
            return line;
          }));
  out.set("warnings", json_array(report.warnings));
  out.set("comparison", report.comparison ? comparison_json(*report.comparison) : JsonValue());
  return out;
}

}  // namespace radcert
