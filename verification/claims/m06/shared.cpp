// SPDX-License-Identifier: GPL-3.0-or-later

// What both papers state, one check serves: the statement of ac98 that each of these is.

#include "verification/framework/check.h"

namespace radcert::verification::ac98 {
Finding equation_1(const Bench& bench);
Finding equation_2(const Bench& bench);
Finding equation_17(const Bench& bench);
Finding equation_44(const Bench& bench);
Finding equation_49(const Bench& bench);
Finding equation_51(const Bench& bench);
}  // namespace radcert::verification::ac98

namespace radcert::verification::m06 {

Finding equation_1(const Bench& bench) { return ac98::equation_1(bench); }
Finding equation_2(const Bench& bench) { return ac98::equation_2(bench); }
Finding equation_6(const Bench& bench) { return ac98::equation_17(bench); }
Finding equation_21(const Bench& bench) { return ac98::equation_44(bench); }
Finding equation_25(const Bench& bench) { return ac98::equation_49(bench); }
Finding equation_26(const Bench& bench) { return ac98::equation_51(bench); }

}  // namespace radcert::verification::m06
