/* What a call costs from C: measure_calls PROBLEM CALLS prints nanoseconds of processor time for
 * one evaluation by the pointer, by the flat function, and in a batch. */
#include <ricochet/ricochet.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return (double)time.tv_sec * 1e9 + (double)time.tv_nsec;
}

int main(int argc, char** argv) {
  const long calls = argc > 2 ? atol(argv[2]) : 1000;
  ricochet_problem* const problem = ricochet_open(argc > 1 ? argv[1] : "", "", 0, INT64_MAX, 0);
  if (!problem) {
    fprintf(stderr, "%s\n", ricochet_error());
    return 1;
  }
  const int n = problem->dimension;
  double* const points = malloc((size_t)calls * (size_t)n * sizeof(double));
  double* const objectives = malloc((size_t)calls * sizeof(double));
  for (long k = 0; k < calls; ++k) {
    for (int i = 0; i < n; ++i) {
      const double share = ricochet_uniform(problem);
      points[k * n + i] = problem->lower[i] + share * (problem->upper[i] - problem->lower[i]);
    }
  }
  for (int way = 0; way < 3; ++way) {
    const double begin = now();
    if (way == 2) {
      ricochet_values_batch(problem, points, calls, objectives, NULL);
    } else {
      for (long k = 0; k < calls; ++k) {
        const double* const x = points + k * n;
        if (way == 0) problem->values(problem, x, &objectives[k], NULL);
        if (way == 1) ricochet_values(problem, x, &objectives[k], NULL);
      }
    }
    printf("%.1f\n", (now() - begin) / (double)calls);
  }
  free(points);
  free(objectives);
  ricochet_close(problem);
  return 0;
}
