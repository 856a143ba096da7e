// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/contents.h"

#include "verification/claims/ac98/checks.h"
#include "verification/claims/ac98/second_route.h"

namespace radcert::verification::ac98 {

PaperChecks contents() {
  return {.key = "ac98",
          .checks = {{"lemma_2_1", lemma_2_1},
                     {"corollary_2_2", corollary_2_2},
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
