/* SPDX-License-Identifier: GPL-3.0-or-later */

/*
 * For Octave and MATLAB, which read C by such a file: [value, error, guaranteed] = reference_mex(name, parameter, text,
 * ...), a reference value as a double with a bound of its error. Compiled by
 *     mkoctfile --mex reference_mex.c -lradcert_c      mex reference_mex.c -lradcert_c
 */
#include "mex.h"
#include "radcert.h"

enum { MOST = 8 };

void mexFunction(int result_count, mxArray* results[], int argument_count, const mxArray* arguments[]) {
  if (argument_count < 1 || argument_count % 2 != 1 || argument_count > 2 * MOST + 1)
    mexErrMsgIdAndTxt("radcert:arguments", "a name, and for each parameter its name and its value, all as texts");
  char* texts[2 * MOST + 1];
  radcert_parameter parameters[MOST];
  for (int i = 0; i < argument_count; ++i) {
    if (!mxIsChar(arguments[i])) mexErrMsgIdAndTxt("radcert:arguments", "argument %d is no text", i + 1);
    texts[i] = mxArrayToString(arguments[i]);
  }
  const size_t count = (size_t)(argument_count / 2);
  for (size_t i = 0; i < count; ++i) {
    parameters[i].name = texts[2 * i + 1];
    parameters[i].value = texts[2 * i + 2];
  }
  radcert_reference* reference = NULL;
  const radcert_reference_value* number = NULL;
  const radcert_status status = radcert_reference_make(texts[0], parameters, count, 0, NULL, &reference);
  for (int i = 0; i < argument_count; ++i) mxFree(texts[i]);
  if (status != RADCERT_OK || radcert_reference_read(reference, &number) != RADCERT_OK)
    mexErrMsgIdAndTxt("radcert:error", "%s", radcert_last_error()->message);
  const double found[] = {number->value, number->error, (double)number->guaranteed};
  radcert_reference_free(reference);
  for (int i = 0; i < 3 && (i == 0 || i < result_count); ++i) results[i] = mxCreateDoubleScalar(found[i]);
}
