/* ricochet in Octave and MATLAB.
 * [counts, quiet] = ricochet_mex("machine", FILE, OMEGAS): collision counts at speeds [rad/s], and
 * the fastest quiet speed.
 * [objective, constraints, best_known] = ricochet_mex("problem", NAME, X): a problem at a point.
 * box = ricochet_mex("box", NAME): a row for each variable, its bounds and its start. */
#include <math.h>
#include <mex.h>
#include <ricochet/ricochet.h>
#include <string.h>

static void of_machine(mxArray* told[], const char* file, const mxArray* omegas) {
  const mwSize size = mxGetNumberOfElements(omegas);
  ricochet_machine* const machine = ricochet_open_machine(file);
  double quiet;
  if (!machine) mexErrMsgTxt(ricochet_error());
  told[0] = mxCreateNumericMatrix(1, size, mxINT32_CLASS, mxREAL);
  const int refused =
      ricochet_counts(machine, mxGetPr(omegas), (int64_t)size, mxGetData(told[0])) ||
      ricochet_quiet_speed(machine, NULL, 0, NAN, &quiet, NULL, NULL);
  ricochet_close_machine(machine);
  if (refused) mexErrMsgTxt(ricochet_error());
  told[1] = mxCreateDoubleScalar(quiet);
}

static void of_problem(mxArray* told[], const char* name, const mxArray* x) {
  ricochet_problem* const problem = ricochet_open(name, "", 0, 1000, 0);
  if (!problem) mexErrMsgTxt(ricochet_error());
  if (mxGetNumberOfElements(x) != (mwSize)ricochet_dimension(problem)) {
    ricochet_close(problem);
    mexErrMsgTxt("x has another number of variables");
  }
  told[0] = mxCreateDoubleScalar(0);
  told[1] = mxCreateDoubleMatrix(1, (mwSize)ricochet_constraints(problem), mxREAL);
  told[2] = mxCreateDoubleScalar(ricochet_best_known(problem));
  const int refused = ricochet_values(problem, mxGetPr(x), mxGetPr(told[0]), mxGetPr(told[1]));
  ricochet_close(problem);
  if (refused) mexErrMsgTxt(ricochet_error());
}

static void of_box(mxArray* told[], const char* name) {
  ricochet_problem* const problem = ricochet_open(name, "", 0, 1, 0);
  if (!problem) mexErrMsgTxt(ricochet_error());
  const mwSize size = (mwSize)ricochet_dimension(problem);
  told[0] = mxCreateDoubleMatrix(size, 3, mxREAL);
  ricochet_bounds(problem, mxGetPr(told[0]), mxGetPr(told[0]) + size);
  ricochet_start(problem, mxGetPr(told[0]) + 2 * size);
  ricochet_close(problem);
}

void mexFunction(int told_size, mxArray* told[], int given_size, const mxArray* given[]) {
  char what[16], name[4096];
  mxArray* all[3] = {NULL, NULL, NULL};
  if (given_size < 2 || mxGetString(given[0], what, sizeof what) ||
      mxGetString(given[1], name, sizeof name) ||
      given_size != (strcmp(what, "box") == 0 ? 2 : 3) ||
      (given_size == 3 && !mxIsDouble(given[2]))) {
    mexErrMsgTxt(
        "ricochet_mex(\"machine\", FILE, OMEGAS), (\"problem\", NAME, X) or (\"box\", NAME)");
  }
  if (strcmp(what, "box") == 0) {
    of_box(all, name);
  } else if (strcmp(what, "machine") == 0) {
    of_machine(all, name, given[2]);
  } else {
    of_problem(all, name, given[2]);
  }
  for (int k = 0; k < 3 && (k == 0 || k < told_size); ++k) told[k] = all[k];
}
