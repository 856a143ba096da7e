// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/check.h"

namespace radcert::verification::m06 {

Finding lemma_1_c_not_convex(const Bench& bench);
Finding lemma_1_d(const Bench& bench);
Finding equation_11(const Bench& bench);
Finding equation_12(const Bench& bench);
Finding equation_13(const Bench& bench);
Finding equation_14(const Bench& bench);
Finding equation_16(const Bench& bench);
Finding equation_17(const Bench& bench);
Finding equation_19(const Bench& bench);
Finding theorem_4(const Bench& bench);
Finding theorem_4_order(const Bench& bench);
Finding equation_24(const Bench& bench);
Finding equation_25(const Bench& bench);
Finding equation_26(const Bench& bench);
Finding equation_29(const Bench& bench);
Finding odd_degree_over_a_rectangle(const Bench& bench);
Finding alpha_0_for_r_1_and_3(const Bench& bench);
Finding alpha_0_for_larger_r(const Bench& bench);
Finding lemma_1_b(const Bench& bench);
Finding lemma_1_e(const Bench& bench);
Finding lemma_2(const Bench& bench);
Finding theorem_3_b(const Bench& bench);
Finding assumption_t1(const Bench& bench);
Finding assumption_t2(const Bench& bench);
Finding assumption_t3(const Bench& bench);
Finding lemma_5(const Bench& bench);
Finding lemma_6(const Bench& bench);
Finding equation_33(const Bench& bench);
Finding equation_34(const Bench& bench);
Finding theorem_7(const Bench& bench);
Finding theorem_7_smoothness(const Bench& bench);
Finding theorem_7_partition(const Bench& bench);
Finding equation_37(const Bench& bench);
Finding even_degree_over_a_rectangle(const Bench& bench);
Finding lemma_8(const Bench& bench);
Finding lemma_8_one_triangle(const Bench& bench);
Finding theorem_9(const Bench& bench);
Finding six_nodes_precision(const Bench& bench);
Finding six_nodes_on_a_curved_piece(const Bench& bench);
Finding six_nodes_without_the_obstacle(const Bench& bench);
Finding abstract(const Bench& bench);

}  // namespace radcert::verification::m06
