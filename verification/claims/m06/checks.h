// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/check.h"

namespace radcert::verification::m06 {

Finding lemma_1_d(const Bench& bench);

}  // namespace radcert::verification::m06
