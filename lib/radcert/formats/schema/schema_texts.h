// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace radcert {

/// The texts of the schemas, one source a file type.
/// Maths     none
/// Source    the file formats
/// Requires  nothing
/// Result    JSON, draft 2020-12
/// Limits    see schemas()
std::string_view problem_schema();
std::string_view solution_schema();
std::string_view verification_schema();
std::string_view picture_schema();
std::string_view list_schema();
std::string_view nodes_schema();
std::string_view basis_schema();
std::string_view surface_schema();
std::string_view factors_schema();
std::string_view experiment_schema();
std::string_view experiment_result_schema();
std::string_view provenance_schema();
std::string_view reference_schema();
std::string_view references_schema();
std::string_view manifest_schema();

}  // namespace radcert
