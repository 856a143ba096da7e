// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/contents.h"

namespace radcert::verification {

std::vector<PaperChecks> all_checks() { return {ac98::contents(), m06::contents(), psg10::contents()}; }

}  // namespace radcert::verification
