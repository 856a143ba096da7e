// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

Finding lemma_2_1(const Bench& bench);
Finding corollary_2_2(const Bench& bench);
Finding equation_37(const Bench& bench);
Finding equation_44(const Bench& bench);
Finding equation_53(const Bench& bench);
Finding equation_54(const Bench& bench);
Finding equation_55(const Bench& bench);
Finding equation_58(const Bench& bench);
Finding equation_59(const Bench& bench);

}  // namespace radcert::verification::ac98
