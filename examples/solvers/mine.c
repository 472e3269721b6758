#include <math.h>
#include <ricochet/ricochet.h>
#include <stdlib.h>
#include <string.h>

/* Steps from the best point so far, shorter and shorter. */
static const char* solve(ricochet_problem* problem, double* point) {
  const size_t size = (size_t)problem->dimension * sizeof(double);
  double *x = malloc(size), best = INFINITY, objective;
  memcpy(x, point, size);
  for (double step = 1; step > 1e-6; step *= 0.98) {
    if (problem->values(problem, x, &objective, NULL) != 0) break;
    if (objective <= best) {
      best = objective;
      memcpy(point, x, size);
    }
    for (int i = 0; i < problem->dimension; ++i) {
      const double width = problem->upper[i] - problem->lower[i];
      x[i] = point[i] + step * width * (2 * problem->uniform(problem) - 1);
    }
  }
  free(x);
  return "steps too short";
}

const ricochet_solver ricochet_plugin = {RICOCHET_ABI, "mine", "1.0", 0, 0, 0, 1, solve};
