// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/check.h"

namespace radcert::verification::ac98 {

Finding lemma_2_1(const Bench& bench);
Finding corollary_2_2(const Bench& bench);
Finding equation_1(const Bench& bench);
Finding equation_2(const Bench& bench);
Finding equation_5(const Bench& bench);
Finding equation_6(const Bench& bench);
Finding equation_7(const Bench& bench);
Finding equation_8(const Bench& bench);
Finding equation_10(const Bench& bench);
Finding equation_12(const Bench& bench);
Finding equation_15(const Bench& bench);
Finding equation_17(const Bench& bench);
Finding equation_18(const Bench& bench);
Finding theorem_2_4_a(const Bench& bench);
Finding equation_21(const Bench& bench);
Finding equation_22(const Bench& bench);
Finding equation_23(const Bench& bench);
Finding equation_23_near_edge(const Bench& bench);
Finding equation_24(const Bench& bench);
Finding equation_25(const Bench& bench);
Finding equation_26(const Bench& bench);
Finding equation_26_dominating_term(const Bench& bench);
Finding equation_26_not_c1(const Bench& bench);
Finding equation_37(const Bench& bench);
Finding equation_44(const Bench& bench);
Finding equation_53(const Bench& bench);
Finding equation_54(const Bench& bench);
Finding equation_55(const Bench& bench);
Finding equation_58(const Bench& bench);
Finding equation_59(const Bench& bench);

}  // namespace radcert::verification::ac98
