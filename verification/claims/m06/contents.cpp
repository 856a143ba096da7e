// SPDX-License-Identifier: GPL-3.0-or-later
#include "verification/claims/contents.h"

#include "verification/claims/ac98/checks.h"
#include "verification/claims/m06/checks.h"

namespace radcert::verification::m06 {

PaperChecks contents() {
  // What both papers state, one check serves.
  return {.key = "m06",
          .checks = {{"lemma_1_d", lemma_1_d},
                     {"lemma_1_c_not_convex", lemma_1_c_not_convex},
                     {"equation_1", ac98::equation_1},
                     {"equation_2", ac98::equation_2},
                     {"lemma_1_a", ac98::equation_6},
                     {"lemma_1_c", ac98::equation_7},
                     {"equation_6", ac98::equation_17},
                     {"theorem_3_a", ac98::theorem_2_4_a},
                     {"equation_21", ac98::equation_44},
                     {"equation_11", equation_11},
                     {"equation_12", equation_12},
                     {"equation_13", equation_13},
                     {"equation_14", equation_14},
                     {"equation_16", equation_16},
                     {"equation_17", equation_17},
                     {"equation_19", equation_19},
                     {"theorem_4", theorem_4},
                     {"theorem_4_order", theorem_4_order},
                     {"equation_24", equation_24},
                     {"equation_25", equation_25},
                     {"equation_26", equation_26},
                     {"equation_29", equation_29},
                     {"odd_degree_over_a_rectangle", odd_degree_over_a_rectangle},
                     {"alpha_0_for_r_1_and_3", alpha_0_for_r_1_and_3},
                     {"alpha_0_for_larger_r", alpha_0_for_larger_r},
                     {"lemma_1_b", lemma_1_b},
                     {"lemma_1_e", lemma_1_e},
                     {"lemma_2", lemma_2},
                     {"theorem_3_b", theorem_3_b},
                     {"assumption_t1", assumption_t1},
                     {"assumption_t2", assumption_t2},
                     {"assumption_t3", assumption_t3},
                     {"lemma_5", lemma_5},
                     {"lemma_6", lemma_6},
                     {"equation_33", equation_33},
                     {"equation_34", equation_34},
                     {"theorem_7", theorem_7},
                     {"theorem_7_smoothness", theorem_7_smoothness},
                     {"theorem_7_partition", theorem_7_partition},
                     {"equation_37", equation_37},
                     {"even_degree_over_a_rectangle", even_degree_over_a_rectangle},
                     {"lemma_8", lemma_8},
                     {"lemma_8_one_triangle", lemma_8_one_triangle},
                     {"theorem_9", theorem_9},
                     {"six_nodes_precision", six_nodes_precision},
                     {"six_nodes_on_a_curved_piece", six_nodes_on_a_curved_piece},
                     {"six_nodes_without_the_obstacle", six_nodes_without_the_obstacle},
                     {"abstract", abstract}},
          .second_route = nullptr};
}

}  // namespace radcert::verification::m06
