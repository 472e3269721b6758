/* What R calls by .Call: external pointers, which R closes, and vectors. */
#include <Rinternals.h>
#include <math.h>
#include <ricochet/ricochet.h>

static void close_machine(SEXP machine) {
  ricochet_close_machine(R_ExternalPtrAddr(machine));
  R_ClearExternalPtr(machine);
}

static void close_problem(SEXP problem) {
  ricochet_close(R_ExternalPtrAddr(problem));
  R_ClearExternalPtr(problem);
}

static SEXP opened(void* address, R_CFinalizer_t close) {
  SEXP pointer;
  if (!address) Rf_error("%s", ricochet_error());
  pointer = PROTECT(R_MakeExternalPtr(address, R_NilValue, R_NilValue));
  R_RegisterCFinalizerEx(pointer, close, TRUE);
  UNPROTECT(1);
  return pointer;
}

SEXP open_machine(SEXP file) {
  return opened(ricochet_open_machine(CHAR(Rf_asChar(file))), close_machine);
}

SEXP counts(SEXP machine, SEXP omegas) {
  const R_xlen_t size = Rf_xlength(omegas);
  SEXP found = PROTECT(Rf_allocVector(INTSXP, size));
  const int refused =
      ricochet_counts(R_ExternalPtrAddr(machine), REAL(omegas), size, INTEGER(found));
  UNPROTECT(1);
  if (refused) Rf_error("%s", ricochet_error());
  return found;
}

SEXP quiet_speed(SEXP machine) {
  double quiet;
  if (ricochet_quiet_speed(R_ExternalPtrAddr(machine), NULL, 0, NAN, &quiet, NULL, NULL)) {
    Rf_error("%s", ricochet_error());
  }
  return Rf_ScalarReal(quiet);
}

SEXP open_problem(SEXP name) {
  return opened(ricochet_open(CHAR(Rf_asChar(name)), "", 0, INT64_MAX, 0), close_problem);
}

/* A matrix with a row for each variable: its bounds and its start. */
SEXP box(SEXP problem) {
  ricochet_problem* const asked = R_ExternalPtrAddr(problem);
  const int size = ricochet_dimension(asked);
  SEXP told;
  if (size < 0) Rf_error("%s", ricochet_error());
  told = PROTECT(Rf_allocMatrix(REALSXP, size, 3));
  ricochet_bounds(asked, REAL(told), REAL(told) + size);
  ricochet_start(asked, REAL(told) + 2 * size);
  UNPROTECT(1);
  return told;
}

/* The objective, then the constraints. */
SEXP values(SEXP problem, SEXP x) {
  ricochet_problem* const asked = R_ExternalPtrAddr(problem);
  const int constraints = ricochet_constraints(asked);
  SEXP told;
  if (constraints < 0) Rf_error("%s", ricochet_error());
  if (Rf_length(x) != ricochet_dimension(asked)) Rf_error("x has %d numbers", Rf_length(x));
  told = PROTECT(Rf_allocVector(REALSXP, 1 + constraints));
  const int refused = ricochet_values(asked, REAL(x), REAL(told), REAL(told) + 1);
  UNPROTECT(1);
  if (refused) Rf_error("%s", ricochet_error());
  return told;
}

SEXP best_known(SEXP problem) {
  return Rf_ScalarReal(ricochet_best_known(R_ExternalPtrAddr(problem)));
}
