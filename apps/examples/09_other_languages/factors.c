/* SPDX-License-Identifier: GPL-3.0-or-later */

/* From C: a number with a proof, and the configuration factors of a tetrahedron. */
#include <stdio.h>

#include "radcert.h"

static int failed(void) {
  fprintf(stderr, "%s\n", radcert_last_error()->message);
  return (int)radcert_last_error()->status;
}

int main(void) {
  const radcert_parameter parameters[] = {{"half_turns", "2/7"}};
  radcert_reference* reference = NULL;
  const radcert_reference_value* number = NULL;
  if (radcert_reference_make("inclined_rectangles", parameters, 1, 30, NULL, &reference) != RADCERT_OK) return failed();
  if (radcert_reference_read(reference, &number) != RADCERT_OK) return failed();
  printf("%s +- %s, between %.17g and %.17g\n", number->midpoint, number->radius, number->lower, number->upper);
  radcert_reference_free(reference);

  const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const int64_t triangles[] = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
  const char* const groups[] = {"floor", "west", "south", "slope"};
  const radcert_mesh mesh = {sizeof mesh, points, 4, triangles, 4, groups, NULL, "corner"};
  const radcert_factor_wish wish = {sizeof wish, "group", 0, 1, 0, 0};
  radcert_factors* factors = NULL;
  const radcert_factor_matrix* matrix = NULL;
  if (radcert_factors_make(&mesh, &wish, NULL, &factors) != RADCERT_OK) return failed();
  if (radcert_factors_read(factors, &matrix) != RADCERT_OK) return failed();
  for (size_t j = 1; j < matrix->count; ++j)
    printf("%s to %s: %.12f +- %.1e, %s\n", matrix->names[0], matrix->names[j], matrix->value[j], matrix->radius[j],
           matrix->guaranteed ? "proved" : "estimated");
  radcert_factors_free(factors);
  return 0;
}
