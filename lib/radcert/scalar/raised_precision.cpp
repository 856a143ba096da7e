// SPDX-License-Identifier: GPL-3.0-or-later
#include "radcert/scalar/raised_precision.h"

namespace radcert {

const WorkLimit most_raised_bits("scalar/raised_precision: bits", 32768, BallPrecision::smallest_bits,
                                 "refused, with the ball reached");

}  // namespace radcert
