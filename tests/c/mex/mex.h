/* SPDX-License-Identifier: GPL-3.0-or-later */

/* The declarations of Octave's and MATLAB's mex.h that the example uses: enough to compile it, not to run it. */
#ifndef RADCERT_TESTS_MEX_H
#define RADCERT_TESTS_MEX_H

#include <stddef.h>

typedef struct mxArray_tag mxArray;
_Noreturn void mexErrMsgIdAndTxt(const char* id, const char* format, ...);
void mexFunction(int result_count, mxArray* results[], int argument_count, const mxArray* arguments[]);
_Bool mxIsChar(const mxArray* array);
char* mxArrayToString(const mxArray* array);
void mxFree(void* memory);
mxArray* mxCreateDoubleScalar(double value);

#endif
