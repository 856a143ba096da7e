// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/core/outcome.h"
#include "radcert/surface/surface.h"
#include "radcert/triangulation/triangulation.h"

namespace radcert {

/// Whether a triangulation is conforming on every chart's parameter domain.
/// Maths     T1-T3 on each R_j, its triangles' corners taken as the doubles that they are
/// Source    [m06, T1-T3]
/// Requires  triangles of charts that are there, else ContractViolation
/// Result    exact; else the chart, and what is wrong on it as conforming() says it
/// Limits    says nothing of how charts meet across a seam
[[nodiscard]] Outcome<void> conforming(const Surface& surface, const Triangulation& triangulation);

}  // namespace radcert
