// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "radcert/formats/json/json_value.h"
#include "radcert/hypotheses/mesh_survey.h"
#include "radcert/hypotheses/piece_measures.h"
#include "radcert/surface/catalogue.h"

namespace radcert {

/// The survey of `radcert surface` as JSON.
/// Source    the file format radcert/surface/1
/// Requires  measures, normals to the front: for each piece, or none; unit: of lengths, where it is known
/// Result    the same keys for a mesh and for a surface of the catalogue, null where something is not known
///           of it. Lists of places show the first surface_json_places, beside the count of all
[[nodiscard]] JsonValue surface_report(const std::string& file, const MeshSurvey& survey,
                                       std::span<const PieceMeasures> measures,
                                       const std::optional<std::string>& unit, const std::string& command);
[[nodiscard]] JsonValue surface_report(const Surface& surface, const ConvexContainment& containment,
                                       std::span<const PieceMeasures> measures,
                                       const std::optional<std::string>& unit, const std::string& command);

/// How many places of each kind of defect a report lists.
inline constexpr std::size_t surface_json_places = 10;

}  // namespace radcert
