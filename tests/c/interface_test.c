/* SPDX-License-Identifier: GPL-3.0-or-later */

/* The interface for C, as a program in C uses it: numbers within their radii, and whatever is wrong refused by name. */
#include <fenv.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include "radcert.h"

static int faults = 0;

static void expect(int holds, const char* what, int line) {
  if (holds) return;
  const radcert_error* error = radcert_last_error();
  fprintf(stderr, "line %d: %s; last error %d: %s\n", line, what, (int)error->status, error->message);
  ++faults;
}
#define EXPECT(condition) expect((condition) != 0, #condition, __LINE__)

/* The last call was refused as wrong input, at this place, with words that have this part. */
static void refused(radcert_status status, const char* place, const char* words, int line) {
  const radcert_error* error = radcert_last_error();
  expect(status == RADCERT_INPUT_ERROR && error->status == status, "refused as wrong input", line);
  expect(strcmp(error->place[0] != '\0' ? error->place : error->source, place) == 0, place, line);
  expect(strstr(error->message, words) != NULL, words, line);
}
#define REFUSED(call, place, words) refused((call), place, words, __LINE__)

/* Howell C-11 for the unit cube: 2/pi (log(4/3)/2 + 2 sqrt(2) atan(1/sqrt(2)) - pi/2). */
static double opposite_faces(void) {
  const double pi = 4 * atan(1);
  return 2 / pi * (log(4.0 / 3.0) / 2 + 2 * sqrt(2) * atan(1 / sqrt(2)) - pi / 2);
}

static void reference_values(void) {
  radcert_reference* reference = NULL;
  const radcert_reference_value* value = NULL;
  EXPECT(radcert_reference_make("cube_opposite_faces", NULL, 0, 30, NULL, &reference) == RADCERT_OK);
  EXPECT(radcert_last_error()->status == RADCERT_OK && radcert_last_error()->message[0] == '\0');
  EXPECT(radcert_reference_read(reference, &value) == RADCERT_OK);
  EXPECT(fabs(strtod(value->midpoint, NULL) - opposite_faces()) < 1e-15);
  EXPECT(strtod(value->radius, NULL) <= 1e-30 && strtod(value->radius, NULL) > 0);
  EXPECT(value->lower <= value->value && value->value <= value->upper);
  EXPECT(value->upper - value->lower > 0 && value->upper - value->lower < 1e-15);
  EXPECT(fabs(value->value - opposite_faces()) < 1e-15 && value->error > 0 && value->error < 1e-16);
  EXPECT(value->guaranteed == 1 && value->digits == 30 && value->route_count == 2);
  EXPECT(strlen(value->routes[0]) > 0 && strcmp(value->routes[0], value->routes[1]) != 0);
  EXPECT(strcmp(value->name, "cube_opposite_faces") == 0 && strlen(value->formula) > 0);
  const char* json = NULL;
  EXPECT(radcert_reference_json(reference, &json) == RADCERT_OK && strstr(json, "radcert/reference/1") != NULL);

  const radcert_parameter edge[] = {{"edge", "5"}};
  radcert_reference* member = NULL;
  EXPECT(radcert_reference_make("perpendicular_rectangles", edge, 1, 0, NULL, &member) == RADCERT_OK);
  const radcert_reference_value* other = NULL;
  EXPECT(radcert_reference_read(member, &other) == RADCERT_OK);
  EXPECT(strncmp(other->midpoint, "0.2710369356973576", 18) == 0 && other->digits == 20);
  radcert_reference_free(member);
  EXPECT(strcmp(value->name, "cube_opposite_faces") == 0);

  radcert_reference* kept = reference;
  const radcert_parameter wrong[] = {{"edge", "0"}};
  const radcert_parameter strange[] = {{"edg", "1"}};
  const radcert_parameter empty[] = {{"edge", NULL}};
  REFUSED(radcert_reference_make("cube_oposite_faces", NULL, 0, 0, NULL, &reference), "reference", "did you mean");
  REFUSED(radcert_reference_make("perpendicular_rectangles", wrong, 1, 0, NULL, &reference), "edge", "allowed:");
  REFUSED(radcert_reference_make("perpendicular_rectangles", strange, 1, 0, NULL, &reference),
          "perpendicular_rectangles", "is no parameter");
  REFUSED(radcert_reference_make("perpendicular_rectangles", empty, 1, 0, NULL, &reference), "parameters/0/value",
          "NULL");
  REFUSED(radcert_reference_make("perpendicular_rectangles", NULL, 1, 0, NULL, &reference), "parameters", "NULL");
  REFUSED(radcert_reference_make("cube_opposite_faces", edge, 1, 0, NULL, &reference), "cube_opposite_faces",
          "is for a family");
  REFUSED(radcert_reference_make("cube_opposite_faces", NULL, 0, 1001, NULL, &reference), "digits", "1001");
  REFUSED(radcert_reference_make("cube_opposite_faces", NULL, 0, -1, NULL, &reference), "digits", "-1");
  REFUSED(radcert_reference_make(NULL, NULL, 0, 0, NULL, &reference), "name", "NULL");
  REFUSED(radcert_reference_make("cube_opposite_faces", NULL, 0, 0, NULL, NULL), "reference", "NULL");
  REFUSED(radcert_reference_read(NULL, &value), "reference", "NULL");
  REFUSED(radcert_reference_read(reference, NULL), "value", "NULL");
  EXPECT(reference == kept);
  radcert_reference_free(reference);
  radcert_reference_free(NULL);

  const char* const* names = NULL;
  size_t count = 0;
  EXPECT(radcert_reference_names(&names, &count) == RADCERT_OK && count > 80);
  int found = 0;
  for (size_t i = 0; i < count; ++i) found += strcmp(names[i], "cube_opposite_faces") == 0;
  EXPECT(found == 1);
}

/* Eighteen digits of a long double decide on which side of a double a value lies. */
static void doubles_are_rounded_outwards(void) {
  const char* const names[] = {"cube_opposite_faces", "perpendicular_rectangles", "inclined_rectangles",
                               "squares_common_edge_60_degrees"};
  int below = 0;
  int above = 0;
  for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
    radcert_reference* reference = NULL;
    const radcert_reference_value* value = NULL;
    EXPECT(radcert_reference_make(names[i], NULL, 0, 30, NULL, &reference) == RADCERT_OK);
    EXPECT(radcert_reference_read(reference, &value) == RADCERT_OK);
    const long double exact = strtold(value->midpoint, NULL);
    EXPECT(value->lower < exact && exact < value->upper);
    EXPECT(fabsl(exact - value->value) <= value->error + ldexpl(exact, -63));
    below += value->value < exact;
    above += value->value > exact;
    radcert_reference_free(reference);
  }
  /* Both sides were seen: a bound that is the value itself would have been too. */
  EXPECT(below > 0 && above > 0);
}

static void a_certificate_proves_so_many_digits(void) {
  radcert_reference* reference = NULL;
  EXPECT(radcert_reference_make("continuous_mean_cube_floor_rho_1/2", NULL, 0, 40, NULL, &reference) ==
         RADCERT_ACCURACY_NOT_REACHED);
  EXPECT(reference == NULL && strstr(radcert_last_error()->message, "1e-40") != NULL);
}

/* The faces of the unit cube, corners counterclockwise as seen from inside. */
static const double points[24] = {0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1};
static const int64_t triangles[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                      2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
static const char* const groups[12] = {"west",  "west",  "east",  "east",  "south",   "south",
                                       "north", "north", "floor", "floor", "ceiling", "ceiling"};

static radcert_mesh cube(void) {
  radcert_mesh mesh = {sizeof mesh, points, 8, triangles, 12, groups, "right-hand", "cube"};
  return mesh;
}

static void factors_of_a_mesh(void) {
  const radcert_mesh mesh = cube();
  const radcert_factor_wish proved = {sizeof proved, "group", 0, 1, 0, 0};
  radcert_factors* factors = NULL;
  const radcert_factor_matrix* matrix = NULL;
  EXPECT(radcert_factors_make(&mesh, &proved, NULL, &factors) == RADCERT_OK);
  EXPECT(radcert_factors_read(factors, &matrix) == RADCERT_OK);
  EXPECT(matrix->count == 6 && matrix->guaranteed == 1 && matrix->failure_count == 0);
  EXPECT(strcmp(matrix->names[0], "west") == 0 && strcmp(matrix->names[5], "ceiling") == 0);
  /* The four other faces share alike what the opposite one does not get. */
  const double opposite = opposite_faces();
  EXPECT(fabs(matrix->value[0 * 6 + 1] - opposite) <= matrix->radius[1] + 1e-15 && matrix->radius[1] < 1e-12);
  EXPECT(fabs(matrix->value[0 * 6 + 2] - (1 - opposite) / 4) <= matrix->radius[2] + 1e-15);
  for (size_t i = 0; i < 6; ++i) {
    EXPECT(matrix->value[i * 6 + i] == 0);
    EXPECT(fabs(matrix->area[i] - 1) <= matrix->area_radius[i]);
    EXPECT(fabs(matrix->row_sum[i] - 1) <= matrix->row_sum_radius[i]);
  }
  EXPECT(matrix->to_space == NULL);
  const char* json = NULL;
  EXPECT(radcert_factors_json(factors, &json) == RADCERT_OK && strstr(json, "radcert/factors/1") != NULL);
  radcert_factors_free(factors);

  /* Without the ceiling: a fifth of the light, and a bit, goes to space. */
  radcert_mesh open = cube();
  open.triangle_count = 10;
  const radcert_factor_wish to_space = {sizeof to_space, NULL, 0, 0, 0, 1};
  factors = NULL;
  EXPECT(radcert_factors_make(&open, &to_space, NULL, &factors) == RADCERT_OK);
  EXPECT(radcert_factors_read(factors, &matrix) == RADCERT_OK && matrix->count == 5);
  EXPECT(matrix->to_space != NULL && fabs(matrix->to_space[4] - opposite) <= matrix->to_space_radius[4] + 1e-12);
  radcert_factors_free(factors);

  factors = NULL;
  REFUSED(radcert_factors_make(&open, NULL, NULL, &factors), "cube", "space");
  REFUSED(radcert_factors_make(NULL, NULL, NULL, &factors), "mesh", "NULL");
  REFUSED(radcert_factors_make(&mesh, NULL, NULL, NULL), "factors", "NULL");
  radcert_mesh bad = cube();
  bad.size = 0;
  REFUSED(radcert_factors_make(&bad, NULL, NULL, &factors), "mesh/size", "is not the size");
  bad = cube();
  bad.points = NULL;
  REFUSED(radcert_factors_make(&bad, NULL, NULL, &factors), "mesh/points", "NULL");
  bad = cube();
  bad.point_count = SIZE_MAX / 2;
  REFUSED(radcert_factors_make(&bad, NULL, NULL, &factors), "mesh/point_count", "more than memory");
  bad = cube();
  bad.point_count = 7;
  REFUSED(radcert_factors_make(&bad, NULL, NULL, &factors), "triangle 2", "cube");
  bad = cube();
  bad.triangle_count = 0;
  REFUSED(radcert_factors_make(&bad, NULL, NULL, &factors), "cube", "");
  bad = cube();
  bad.front = "left";
  REFUSED(radcert_factors_make(&bad, NULL, NULL, &factors), "front", "right-hand");
  double broken[24];
  memcpy(broken, points, sizeof broken);
  broken[4] = NAN;
  bad = cube();
  bad.points = broken;
  REFUSED(radcert_factors_make(&bad, NULL, NULL, &factors), "point 1", "finite");
  int64_t negative[36];
  memcpy(negative, triangles, sizeof negative);
  negative[3] = -1;
  bad = cube();
  bad.triangles = negative;
  REFUSED(radcert_factors_make(&bad, NULL, NULL, &factors), "triangle 1", "-1");
  const char* unnamed[12];
  memcpy(unnamed, groups, sizeof unnamed);
  unnamed[7] = NULL;
  bad = cube();
  bad.groups = unnamed;
  REFUSED(radcert_factors_make(&bad, NULL, NULL, &factors), "mesh/groups/7", "NULL");
  radcert_factor_wish wish = {sizeof wish, "groups", 0, 0, 0, 0};
  REFUSED(radcert_factors_make(&mesh, &wish, NULL, &factors), "by", "triangle, piece, group");
  wish.by = "triangle";
  wish.accuracy = NAN;
  REFUSED(radcert_factors_make(&mesh, &wish, NULL, &factors), "accuracy", "from 1e-12 to 0.1");
  wish.accuracy = -1;
  REFUSED(radcert_factors_make(&mesh, &wish, NULL, &factors), "accuracy", "-1");
  wish.accuracy = 0;
  wish.rays = wish.certified = 1;
  REFUSED(radcert_factors_make(&mesh, &wish, NULL, &factors), "rays", "proves nothing");
  wish.size = sizeof wish + 8;
  REFUSED(radcert_factors_make(&mesh, &wish, NULL, &factors), "wish/size", "is not the size");
  EXPECT(factors == NULL);
}

#define CUBE "{\"schema\": \"radcert/problem/1\", \"surface\": {\"name\": \"cube\"}, \"triangulation\": {\"levels\": "
#define DATA \
  "}, \"basis\": {\"family\": \"inset\", \"degree\": 1, \"alpha\": \"1/6\"}, \"reflectivity\": \"3/4\", " \
  "\"emission\": 1, \"solver\": {\"name\": \"verified\"}}"

static int count_calls(double fraction, const char* words, void* context) {
  EXPECT(fraction >= 0 && fraction <= 1 && words != NULL);
  ++*(int*)context;
  return 0;
}

static int hear_of_store(double fraction, const char* words, void* context) {
  (void)fraction;
  *(int*)context += strncmp(words, "finished work is not kept: ", 27) == 0;
  return 0;
}

static int stop(double fraction, const char* words, void* context) {
  (void)fraction;
  (void)words;
  ++*(int*)context;
  return 1;
}

static void problems_solved(void) {
  radcert_solution* solution = NULL;
  int calls = 0;
  const radcert_run run = {sizeof run, count_calls, &calls, NULL};
  EXPECT(radcert_solve(CUBE "[0, 1]" DATA, NULL, &run, &solution) == RADCERT_OK);
  EXPECT(calls > 0);
  size_t levels = 0;
  EXPECT(radcert_solution_level_count(solution, &levels) == RADCERT_OK && levels == 2);
  for (size_t place = 0; place < levels; ++place) {
    const radcert_nodes* nodes = NULL;
    EXPECT(radcert_solution_nodes(solution, place, &nodes) == RADCERT_OK);
    EXPECT(nodes->level == (int64_t)place && nodes->count == (place == 0 ? 36u : 144u) && nodes->solution == NULL);
    /* In a closed furnace u = E/(1 - rho) everywhere, and with it u_n. */
    for (size_t i = 0; i < nodes->count; ++i) {
      EXPECT(nodes->guaranteed[i] == 1 && nodes->radius[i] < 1e-9);
      EXPECT(fabs(nodes->value[i] - 4) <= nodes->radius[i]);
      EXPECT(nodes->emission[i] == 1 && strlen(nodes->pieces[i]) > 0 && nodes->elements[i] >= 0);
      const double* n = nodes->normals + 3 * i;
      const double* p = nodes->points + 3 * i;
      EXPECT(fabs(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1) < 1e-14);
      /* Inwards: a small step along the normal stays in [0,1]^3. */
      for (int k = 0; k < 3; ++k) EXPECT(p[k] + 1e-3 * n[k] > 0 && p[k] + 1e-3 * n[k] < 1);
    }
  }
  const radcert_nodes* nodes = NULL;
  REFUSED(radcert_solution_nodes(solution, 2, &nodes), "place", "from 0 to 1");
  REFUSED(radcert_solution_nodes(NULL, 0, &nodes), "solution", "NULL");
  const char* json = NULL;
  EXPECT(radcert_solution_json(solution, &json) == RADCERT_OK && strstr(json, "radcert/solution/1") != NULL);
  radcert_solution_free(solution);

  solution = NULL;
  REFUSED(radcert_solve("{", NULL, NULL, &solution), "problem", "line 1, column 2");
  REFUSED(radcert_solve(CUBE "[1, 0]" DATA, "my.json", NULL, &solution), "/triangulation/levels/1", "my.json");
  REFUSED(radcert_solve(CUBE "[30]" DATA, NULL, NULL, &solution), "/triangulation/levels/0", "");
  REFUSED(radcert_solve(NULL, NULL, NULL, &solution), "problem", "NULL");
  REFUSED(radcert_solve(CUBE "[0]" DATA, NULL, NULL, NULL), "solution", "NULL");
  radcert_run wrong = run;
  wrong.size = 1;
  REFUSED(radcert_solve(CUBE "[0]" DATA, NULL, &wrong, &solution), "run/size", "is not the size");
  /* A folder that cannot be made is said, and the numbers come all the same. */
  int heard = 0;
  const radcert_run unkept = {sizeof unkept, hear_of_store, &heard, "/dev/null/store"};
  EXPECT(radcert_solve(CUBE "[0]" DATA, NULL, &unkept, &solution) == RADCERT_OK && heard == 1);
  radcert_solution_free(solution);
  solution = NULL;
  /* One call stops what would take minutes, and the next computation runs. */
  calls = 0;
  const radcert_run stopped = {sizeof stopped, stop, &calls, NULL};
  EXPECT(radcert_solve(CUBE "[4]" DATA, NULL, &stopped, &solution) == RADCERT_INTERRUPTED);
  EXPECT(calls == 1 && radcert_last_error()->status == RADCERT_INTERRUPTED && solution == NULL);
  EXPECT(radcert_solve(CUBE "[0]" DATA, NULL, NULL, &solution) == RADCERT_OK);
  radcert_solution_free(solution);
}

static void* fail_apart(void* context) {
  radcert_reference* reference = NULL;
  EXPECT(radcert_last_error()->status == RADCERT_OK);
  EXPECT(radcert_reference_make("no_such_value", NULL, 0, 0, NULL, &reference) == RADCERT_INPUT_ERROR);
  *(int*)context = strstr(radcert_last_error()->message, "no_such_value") != NULL;
  return NULL;
}

static void threads_have_their_own_errors(void) {
  radcert_reference* reference = NULL;
  EXPECT(radcert_reference_make("another_value", NULL, 0, 0, NULL, &reference) == RADCERT_INPUT_ERROR);
  pthread_t thread;
  int own = 0;
  EXPECT(pthread_create(&thread, NULL, fail_apart, &own) == 0);
  EXPECT(pthread_join(thread, NULL) == 0);
  EXPECT(own == 1 && strstr(radcert_last_error()->message, "another_value") != NULL);
  EXPECT(strcmp(radcert_last_error()->value, "another_value") == 0);
}

static void threads_are_limited(void) {
  REFUSED(radcert_limit_threads(-1), "threads", "from 1 to 4096");
  REFUSED(radcert_limit_threads(5000), "threads", "5000");
  EXPECT(radcert_limit_threads(1) == RADCERT_OK);
  reference_values();
  EXPECT(radcert_limit_threads(0) == RADCERT_OK);
}

/* All that a matrix of the cube has. */
static size_t cube_factors(double* numbers) {
  const radcert_mesh mesh = cube();
  const radcert_factor_wish proved = {sizeof proved, "triangle", 0, 1, 0, 0};
  radcert_factors* factors = NULL;
  const radcert_factor_matrix* matrix = NULL;
  EXPECT(radcert_factors_make(&mesh, &proved, NULL, &factors) == RADCERT_OK);
  EXPECT(radcert_factors_read(factors, &matrix) == RADCERT_OK && matrix->count == 12);
  size_t count = 0;
  for (size_t k = 0; k < matrix->count * matrix->count; ++k) {
    numbers[count++] = matrix->value[k];
    numbers[count++] = matrix->radius[k];
  }
  for (size_t i = 0; i < matrix->count; ++i) {
    numbers[count++] = matrix->area[i];
    numbers[count++] = matrix->row_sum[i];
    numbers[count++] = matrix->row_sum_radius[i];
  }
  radcert_factors_free(factors);
  return count;
}

/* What proofs take for granted does not depend on what the caller's thread has set, and stays there: not where the
   library makes its threads either, which it does at the first call. */
static void the_callers_rounding_does_not_matter(void) {
  enum { most = 2 * 12 * 12 + 3 * 12 };
  double usual[most];
  double other[4][most];
  const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, FE_TONEAREST};
  for (size_t k = 0; k < 4; ++k) {
    EXPECT(fesetround(modes[k]) == 0);
    EXPECT(cube_factors(other[k]) == most);
    EXPECT(fegetround() == modes[k]);
  }
  EXPECT(cube_factors(usual) == most);
  for (size_t k = 0; k < 4; ++k) EXPECT(memcmp(usual, other[k], sizeof usual) == 0);
#ifdef __SSE2__
  const unsigned flush = 0x8040; /* FTZ and DAZ */
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | flush);
  radcert_reference* tiny = NULL;
  const radcert_reference_value* value = NULL;
  const radcert_parameter edge[] = {{"edge", "5"}};
  EXPECT(radcert_reference_make("perpendicular_rectangles", edge, 1, 0, NULL, &tiny) == RADCERT_OK);
  EXPECT(radcert_reference_read(tiny, &value) == RADCERT_OK && value->lower < value->upper);
  EXPECT(cube_factors(other[0]) == most);
  EXPECT((_mm_getcsr() & flush) == flush);
  _mm_setcsr(before);
  EXPECT(memcmp(usual, other[0], sizeof usual) == 0);
  radcert_reference_free(tiny);
#endif
}

int main(void) {
  EXPECT(radcert_interface() == RADCERT_INTERFACE && strlen(radcert_version()) > 0);
  EXPECT(radcert_last_error() != NULL && radcert_last_error()->status == RADCERT_OK);
  the_callers_rounding_does_not_matter();
  reference_values();
  doubles_are_rounded_outwards();
  a_certificate_proves_so_many_digits();
  factors_of_a_mesh();
  problems_solved();
  threads_have_their_own_errors();
  threads_are_limited();
  if (faults == 0) printf("radcert %s keeps to its header\n", radcert_version());
  return faults == 0 ? 0 : 1;
}
