// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/enclosure/demand.h"

namespace radcert {

const WorkLimit most_evaluations(
    "enclosure/demand: evaluations", 20'000'000, 1,
    "undecided, with the ball reached: what was not finished counts with its range");

}  // namespace radcert
