// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "radcert/study/study.h"

namespace radcert::app {

/// Ku by the reference layer, which shares no quadrature with the collocation matrix.
OperatorRoute operator_route();

}  // namespace radcert::app
