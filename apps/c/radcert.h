/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef RADCERT_H
#define RADCERT_H

/*
 * radcert for C, and for all that speaks with C: reference values, configuration factors of a mesh, problems solved.
 *
 * Every function gives a status, and what it makes by its last argument, which is left alone unless the status is
 * RADCERT_OK. radcert_last_error() has the words. A handle is freed by its own function; what is read from it lives as
 * long. Different threads may compute at the same time; one handle may be read by many threads.
 *
 * A struct that you give begins with its size: `radcert_mesh mesh = {sizeof mesh}`; members that are 0 mean what is
 * said beside them. Structs that you are given may grow at their end with a later version.
 */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Of this header. It changes when a program that was compiled with another one would not run any more. */
#define RADCERT_INTERFACE 1

/* Of the library that runs: RADCERT_INTERFACE as it was compiled, and its version, "0.1.0". */
int32_t radcert_interface(void);
const char* radcert_version(void);

typedef enum radcert_status {
  RADCERT_OK = 0,
  RADCERT_ACCURACY_NOT_REACHED = 1, /* an accuracy or a proof that was asked for */
  RADCERT_INPUT_ERROR = 2,          /* what was given is wrong */
  RADCERT_ENVIRONMENT_ERROR = 3,    /* a disk, memory, threads */
  RADCERT_DEFECT = 4,               /* of radcert itself: please report it */
  RADCERT_INTERRUPTED = 130         /* a listener asked to stop */
} radcert_status;

/*
 * What the last call of this thread has met. message: one line with all that follows. place: where in the source, as
 * "/basis/alpha", "triangle 7", "size"; value: what stands there, NULL where nothing does; allowed: what would have
 * been right. The parts are "" where they do not apply. Never NULL; lives until the thread's next call.
 */
typedef struct radcert_error {
  radcert_status status;
  const char* message;
  const char* source;
  const char* place;
  const char* value;
  const char* problem;
  const char* allowed;
} radcert_error;
const radcert_error* radcert_last_error(void);

/* At most so many threads from now on in this process; 0: as many as there are processors. */
radcert_status radcert_limit_threads(int64_t threads);

/*
 * How a computation is run; NULL in place of it: without all of this.
 * listener: called in the thread that called, about 25 times a second, with how far the work has come, from 0 to 1; not
 * 0 stops it with RADCERT_INTERRUPTED, and with it what other threads of the process compute. It may not leave by
 * longjmp or an exception.
 * store: a folder that keeps finished work, "default" for that of the program; NULL keeps nothing. One that cannot be
 * written keeps nothing, and the listener hears so, in words that begin with "finished work is not kept".
 */
typedef int (*radcert_listener)(double fraction, const char* words, void* context);
typedef struct radcert_run {
  size_t size;
  radcert_listener listener;
  void* context;
  const char* store;
} radcert_run;

/* ---- Reference values ------------------------------------------------------------------------------------------ */

typedef struct radcert_reference radcert_reference;

/* A parameter of a family: a decimal or a fraction, which is taken exactly. */
typedef struct radcert_parameter {
  const char* name;
  const char* value;
} radcert_parameter;

/*
 * A reference value by its name. digits: the radius is at most 10^-digits, from 1 to 1000; 0: 20, and of means of
 * solutions what their certificates prove.
 */
radcert_status radcert_reference_make(const char* name, const radcert_parameter* parameters,
                                      size_t parameter_count, int64_t digits, const radcert_run* run,
                                      radcert_reference** reference);

/*
 * midpoint, radius: decimals with |exact - midpoint| <= radius. lower <= exact <= upper: doubles, rounded outwards.
 * |exact - value| <= error: doubles, the radius rounded up. guaranteed: 1 where that is proved, 0 where it is an
 * estimate. routes: in words, the ways by which it was found, which agree.
 */
typedef struct radcert_reference_value {
  const char* name;
  const char* midpoint;
  const char* radius;
  double lower;
  double upper;
  double value;
  double error;
  int32_t guaranteed;
  int64_t digits;
  const char* formula;
  const char* source;
  size_t route_count;
  const char* const* routes;
} radcert_reference_value;
radcert_status radcert_reference_read(const radcert_reference* reference,
                                      const radcert_reference_value** value);
/* What `radcert reference --json` writes. */
radcert_status radcert_reference_json(const radcert_reference* reference, const char** text);
void radcert_reference_free(radcert_reference* reference);

/* All names, of values, families and means. They live as long as the process. */
radcert_status radcert_reference_names(const char* const** names, size_t* count);

/* ---- Configuration factors ------------------------------------------------------------------------------------- */

typedef struct radcert_factors radcert_factors;

/*
 * points: x, y, z of each. triangles: three places of points each, counted from 0. groups: a name a triangle; NULL: all
 * are of one. front: "right-hand" (light travels where the corners run counterclockwise), "left-hand", "auto"; NULL:
 * "auto", which takes a closed mesh for a room. name: for messages; NULL: "mesh". Read during the call alone.
 */
typedef struct radcert_mesh {
  size_t size;
  const double* points;
  size_t point_count;
  const int64_t* triangles;
  size_t triangle_count;
  const char* const* groups;
  const char* front;
  const char* name;
} radcert_mesh;

/*
 * by: "group", "piece" or "triangle", what a row stands for; NULL: "group". accuracy: wanted of each row's sum, from
 * 1e-12 to 0.1; 0: 1e-5, certified 1e-9, rays 1e-4. certified: every radius is proved. rays: quasi-Monte Carlo, for
 * thousands of triangles. space: the scene is open, and what reaches no front goes to space.
 */
typedef struct radcert_factor_wish {
  size_t size;
  const char* by;
  double accuracy;
  int32_t certified;
  int32_t rays;
  int32_t space;
} radcert_factor_wish;

/* wish: NULL for all that is usual. */
radcert_status radcert_factors_make(const radcert_mesh* mesh, const radcert_factor_wish* wish,
                                    const radcert_run* run, radcert_factors** factors);

/*
 * value, radius: count * count numbers row by row, |exact - value[i * count + j]| <= radius[i * count + j] for the part
 * of the light of i that arrives at j; guaranteed: 1 where that is proved. area, row_sum with their radii: count
 * numbers. to_space and its radius: the same, NULL for a closed scene. warnings: what is odd about the scene.
 * failures: why the numbers must not be relied on, or that the accuracy was not reached.
 */
typedef struct radcert_factor_matrix {
  size_t count;
  const char* const* names;
  const double* value;
  const double* radius;
  int32_t guaranteed;
  const double* area;
  const double* area_radius;
  const double* row_sum;
  const double* row_sum_radius;
  const double* to_space;
  const double* to_space_radius;
  size_t warning_count;
  const char* const* warnings;
  size_t failure_count;
  const char* const* failures;
} radcert_factor_matrix;
radcert_status radcert_factors_read(const radcert_factors* factors, const radcert_factor_matrix** matrix);
/* What `radcert factors --json` writes. */
radcert_status radcert_factors_json(const radcert_factors* factors, const char** text);
void radcert_factors_free(radcert_factors* factors);

/* ---- Problems -------------------------------------------------------------------------------------------------- */

typedef struct radcert_solution radcert_solution;

/*
 * Solves a problem over its levels. problem: the text of a problem file, radcert/problem/1; files that it names are
 * sought from the folder of `name`, as if that were its file. name: for messages; NULL: "problem".
 */
radcert_status radcert_solve(const char* problem, const char* name, const radcert_run* run,
                             radcert_solution** solution);

/* What `radcert solve --json` writes: errors, orders, means, each with its radius. */
radcert_status radcert_solution_json(const radcert_solution* solution, const char** text);
radcert_status radcert_solution_level_count(const radcert_solution* solution, size_t* count);

/*
 * The values of a level at its nodes. points, normals: x, y, z of each, normals of unit length, inwards.
 * |u_n - value[i]| <= radius[i] for the solution u_n of the discrete equation; guaranteed[i]: 1 where that is proved;
 * an infinite radius says that nothing is known. emission: E there. solution: u there where the problem states it, else
 * NULL. pieces: the name of each node's. elements: the number of each node's.
 */
typedef struct radcert_nodes {
  int64_t level;
  size_t count;
  const double* points;
  const double* normals;
  const double* value;
  const double* radius;
  const uint8_t* guaranteed;
  const double* emission;
  const double* solution;
  const char* const* pieces;
  const int64_t* elements;
} radcert_nodes;
/* place: of the level among those of the problem, from 0. */
radcert_status radcert_solution_nodes(const radcert_solution* solution, size_t place,
                                      const radcert_nodes** nodes);
void radcert_solution_free(radcert_solution* solution);

#ifdef __cplusplus
}
#endif

#endif
