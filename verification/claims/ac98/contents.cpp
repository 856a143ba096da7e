// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/contents.h"

#include "verification/claims/ac98/checks.h"
#include "verification/claims/ac98/second_route.h"

namespace radcert::verification::ac98 {

PaperChecks contents() {
  return {.key = "ac98",
          .checks = {{"lemma_2_1", lemma_2_1},
                     {"corollary_2_2", corollary_2_2},
                     {"equation_1", equation_1},
                     {"equation_2", equation_2},
                     {"equation_5", equation_5},
                     {"equation_6", equation_6},
                     {"equation_7", equation_7},
                     {"equation_8", equation_8},
                     {"equation_10", equation_10},
                     {"equation_12", equation_12},
                     {"equation_15", equation_15},
                     {"equation_17", equation_17},
                     {"equation_18", equation_18},
                     {"theorem_2_4_a", theorem_2_4_a},
                     {"equation_21", equation_21},
                     {"equation_22", equation_22},
                     {"equation_23", equation_23},
                     {"equation_23_near_edge", equation_23_near_edge},
                     {"equation_24", equation_24},
                     {"equation_25", equation_25},
                     {"equation_26", equation_26},
                     {"equation_26_dominating_term", equation_26_dominating_term},
                     {"equation_26_not_c1", equation_26_not_c1},
                     {"equation_37", equation_37},
                     {"equation_44", equation_44},
                     {"equation_53", equation_53},
                     {"equation_54", equation_54},
                     {"equation_55", equation_55},
                     {"equation_58", equation_58},
                     {"equation_59", equation_59}},
          .second_route = second_route};
}

}  // namespace radcert::verification::ac98
