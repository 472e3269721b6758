/* The sum of two decays, fitted to measurements that have no errors: rates 5/s and 0.5/s, both from 1. */
#include <math.h>
#include <ricochet/ricochet.h>
#include <stddef.h>

int32_t ricochet_evaluate(const double* x, ricochet_values_at* values) {
  for (int i = 0; i < values->residuals; ++i) {
    const double t = 0.2 * i;
    const double fast = exp(-x[0] * t), slow = exp(-x[1] * t);
    values->residual_values[i] = x[2] * fast + x[3] * slow - (exp(-5 * t) + exp(-0.5 * t));
    if (values->residual_jacobian == NULL) continue;
    double* const row = values->residual_jacobian + 4 * i;
    row[0] = -t * x[2] * fast;
    row[1] = -t * x[3] * slow;
    row[2] = fast;
    row[3] = slow;
  }
  if (values->gradient == NULL) return 0;
  for (int k = 0; k < 4; ++k) {
    values->gradient[k] = 0;
    for (int i = 0; i < values->residuals; ++i) {
      values->gradient[k] += values->residual_values[i] * values->residual_jacobian[4 * i + k];
    }
  }
  return 0;
}
