// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verification/framework/check.h"

namespace radcert::verification::psg10 {

Finding equation_2(const Bench& bench);
Finding section_2_albedo(const Bench& bench);
Finding section_2_radiosity(const Bench& bench);
Finding equation_4(const Bench& bench);
Finding section_2_surface_form(const Bench& bench);
Finding equation_6(const Bench& bench);
Finding section_3_compact(const Bench& bench);
Finding section_3_cover(const Bench& bench);
Finding section_3_independent(const Bench& bench);
Finding section_4_interpolation(const Bench& bench);
Finding equation_10(const Bench& bench);
Finding section_4_smoothing(const Bench& bench);
Finding equation_11(const Bench& bench);
Finding section_4_normalised(const Bench& bench);
Finding section_5_radius(const Bench& bench);
Finding section_5_support(const Bench& bench);
Finding equation_12(const Bench& bench);
Finding equation_13(const Bench& bench);
Finding equation_13_approximation(const Bench& bench);
Finding equation_14(const Bench& bench);
Finding equation_15(const Bench& bench);
Finding section_5_points(const Bench& bench);
Finding section_5_triangle(const Bench& bench);
Finding section_5_infinite(const Bench& bench);
Finding section_5_orientation(const Bench& bench);
Finding equation_16(const Bench& bench);
Finding equation_16_always(const Bench& bench);
Finding equation_17(const Bench& bench);
Finding equation_18(const Bench& bench);
Finding equation_19(const Bench& bench);
Finding section_7_values(const Bench& bench);
Finding section_7_plane_integral(const Bench& bench);
Finding section_7_plane_integral_scene(const Bench& bench);
Finding section_7_mean_integral(const Bench& bench);
Finding section_7_estimate(const Bench& bench);
Finding section_7_estimate_scene(const Bench& bench);
Finding equation_20(const Bench& bench);
Finding equation_21(const Bench& bench);
Finding section_8_symmetry(const Bench& bench);
Finding section_8_visibility(const Bench& bench);
Finding section_8_angle(const Bench& bench);
Finding equation_22(const Bench& bench);
Finding equation_24(const Bench& bench);
Finding equation_25(const Bench& bench);
Finding section_8_iterations(const Bench& bench);
Finding figure_5(const Bench& bench);
Finding figure_6(const Bench& bench);
Finding figure_6_values(const Bench& bench);
Finding figure_8(const Bench& bench);
Finding figure_8_gaussian(const Bench& bench);
Finding figure_9(const Bench& bench);
Finding figure_10(const Bench& bench);
Finding figure_11(const Bench& bench);
Finding figure_13(const Bench& bench);
Finding section_8_same_values(const Bench& bench);
Finding section_8_gaussian(const Bench& bench);
Finding figure_12(const Bench& bench);
Finding conclusion_accuracy_disk(const Bench& bench);
Finding conclusion_accuracy_sphere(const Bench& bench);
Finding conclusion_images(const Bench& bench);
Finding conclusion_oscillation(const Bench& bench);

}  // namespace radcert::verification::psg10
