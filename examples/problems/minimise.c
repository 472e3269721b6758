/* A function of a program's own, minimised in its process: gcc minimise.c -lricochet_minimise */
#include <ricochet/minimise.h>
#include <stdio.h>

static int32_t banana(ricochet_problem* problem, const double* x, double* objective, double* none) {
  const double across = x[1] - x[0] * x[0], along = 1 - x[0];
  (void)problem;
  (void)none;
  if (objective) *objective = 100 * across * across + along * along;
  return 0;
}

int main(void) {
  const double lower[] = {-2, -2}, upper[] = {2, 2}, start[] = {-1.2, 1};
  double point[2];
  ricochet_problem problem = {0};
  ricochet_minimisation run = {0};
  problem.abi = run.abi = RICOCHET_ABI;
  problem.dimension = 2;
  problem.lower = lower;
  problem.upper = upper;
  problem.start = start;
  problem.values = banana;
  run.solver = "nlopt-bobyqa";
  run.budget = 500;
  run.point = point;
  if (ricochet_minimise(&problem, &run)) {
    fprintf(stderr, "%s\n", run.ended);
    return 1;
  }
  printf("%s: %.6f at %.3f %.3f after %d evaluations\n", run.chosen, run.objective, point[0], point[1],
         (int)run.evaluations);
  return 0;
}
