#include <ricochet/ricochet.h>

/* The values that own_problem_test.cpp expects. */
int32_t ricochet_evaluate(const double* x, ricochet_values_at* values) {
  *values->objective = x[0] * x[0] + 3 * x[1];
  values->constraint_values[0] = x[0] * x[0] + x[1] * x[1] - 9;
  values->constraint_values[1] = x[0] - 2 * x[1];
  values->constraint_values[2] = x[1] > 1;
  return 0;
}
