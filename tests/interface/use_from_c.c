/* A program of C99 that asks a problem: how a random search does on it. */

#include <ricochet/ricochet.h>
#include <stdio.h>

int main(void) {
  ricochet_problem* problem = ricochet_open("top-speed-C1", "penalised-count", 0, 200, 1);
  double x = 0, objective = 0, violation = 0, best = 1e9, best_x = 0;
  if (!problem) {
    fprintf(stderr, "%s\n", ricochet_error());
    return 1;
  }
  x = problem->start[0];
  while (problem->values(problem, &x, &objective, NULL) == 0) {
    if (objective < best) {
      best = objective;
      best_x = x;
    }
    x = problem->lower[0] + problem->uniform(problem) * (problem->upper[0] - problem->lower[0]);
  }
  if (ricochet_judge(problem, &best_x, &objective, &violation) != 0) {
    fprintf(stderr, "%s\n", ricochet_error());
    return 1;
  }
  printf("%s: fastest quiet speed found: %.3f rad/s, violation %g; then: %s\n", problem->name,
         best_x, violation, ricochet_error());
  ricochet_close(problem);
  /* The fastest quiet speed is 8.079 rad/s; 200 random speeds of 0 to 18 rad/s miss it by a tenth
   * of it in one of 10,000 cases. */
  if (violation != 0 || best_x < 0.9 * 8.079 || best_x > 8.080) return 1;
  return ricochet_open("top-speed-C99", NULL, 0, 1, 0) == NULL ? 0 : 1;
}
