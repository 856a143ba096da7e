// SPDX-License-Identifier: GPL-3.0-or-later

// What is said of the reference solution, n = m = k = 100.
//
// Checked      "converged after a few iterations": the first iteration that changes no value by more than
//              half a grey level of 255, 1/510, and the first that changes none by more than 1e-6. With (25)
//              as printed there is none among 60. The curves: the sums (22)-(23) against the solution of
//              (21), with the points in the middles of equal parts and with the ends among them: within
//              1/100, what a plot shows. Rejected: F half and a quarter as large, the readings of section II,
//              and B and D without B+ and D+, the light that was scattered twice or more.
// Not checked  figure 10 itself: the picture is not at hand, no number of it is printed, and the readings
//              cannot be told apart without its axes; its entry is open. B at the lowest latitude is 0.577,
//              and 0.287 or 0.143 with the factors of section II.

#include "verification/claims/psg10/picture_at_hand.h"
#include "verification/claims/psg10/sum_errors.h"
#include "verification/framework/check.h"

namespace radcert::verification::psg10 {
namespace {

constexpr int most_iterations = 60;

const AtMost shown{.value = 0.01, .slack = 0, .why = "a hundredth of the axis"};

/// The number of the first iteration that changes nothing by more than the tolerance, one more than the most
/// if none does.
Approximation iterations_to(const SumReading& reading, double tolerance) {
  const auto changes = sum_solution({}, reading, most_iterations, tolerance).changes;
  const std::size_t count = changes.size() + (changes.back() <= tolerance ? 0 : 1);
  return {.value = static_cast<double>(count), .radius = 0};
}

Approximation of_sphere(const SumReading& reading) {
  return {.value = sum_errors(reading).sphere, .radius = 1e-12};
}
Approximation of_disk(const SumReading& reading) {
  return {.value = sum_errors(reading).disk, .radius = 1e-12};
}

}  // namespace

Finding section_8_iterations(const Bench&) {
  const AtMost few{.value = 10, .slack = 0, .why = "a few are not more than ten"};
  const SumReading printed{.weights = SumWeights::as_in_the_text};
  Finding finding;
  finding.require("iterations until lambda changes by half a grey level", few, iterations_to({}, 1.0 / 510));
  finding.require("iterations until lambda changes by 1e-6", few, iterations_to({}, 1e-6));
  finding.control("iterations until lambda changes by half a grey level, (25) as printed", few,
                  iterations_to(printed, 1.0 / 510));
  return finding;
}

Finding section_8_reference(const Bench&) {
  Finding finding;
  finding.require("error of B, points in the middles", shown, of_sphere({}));
  finding.require("error of D, points in the middles", shown, of_disk({}));
  finding.require("error of B, the ends among the points", shown, of_sphere({.spacing = Spacing::with_ends}));
  finding.require("error of D, the ends among the points", shown, of_disk({.spacing = Spacing::with_ends}));
  finding.control("error of B, half of F", shown, of_sphere({.form_factor = Rational(1, 2)}));
  finding.control("error of B, a quarter of F", shown, of_sphere({.form_factor = Rational(1, 4)}));
  finding.control("error of B without B+, F = 0", shown, of_sphere({.form_factor = 0}));
  finding.control("error of D without D+, F = 0", shown, of_disk({.form_factor = 0}));
  return finding;
}

Finding figure_10(const Bench&) {
  Finding finding;
  finding.require("B of figure 10 less that of the sums, largest", shown, read_off_the_picture());
  finding.require("D of figure 10 less that of the sums, largest", shown, read_off_the_picture());
  finding.control("B of the sums with half of F, less B, largest", shown,
                  of_sphere({.form_factor = Rational(1, 2)}));
  return finding;
}

}  // namespace radcert::verification::psg10
