// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/contents.h"

#include "verification/claims/m06/checks.h"

namespace radcert::verification::m06 {

PaperChecks contents() {
  return {.key = "m06", .checks = {{"lemma_1_d", lemma_1_d}}, .second_route = nullptr};
}

}  // namespace radcert::verification::m06
