/* ricochet from C: gcc ask.c -lricochet, and -I and -L where it is not installed. */
#include <ricochet/ricochet.h>
#include <stdio.h>

int main(void) {
  ricochet_machine* machine = ricochet_open_machine("machine.toml");
  ricochet_problem* problem = ricochet_open("hs-71", "", 0, 1000, 0);
  const double omegas[] = {5, 6, 7};
  const double x[] = {1, 5, 5, 1};
  int32_t counts[3];
  double quiet, objective, constraints[2];
  if (!machine || !problem) {
    fprintf(stderr, "%s\n", ricochet_error());
    return 1;
  }
  ricochet_counts(machine, omegas, 3, counts);
  ricochet_quiet_speed(machine, NULL, 0, 18, &quiet, NULL, NULL);
  printf("collisions %d %d %d, quiet up to %.3f rad/s\n", counts[0], counts[1], counts[2], quiet);
  ricochet_values(problem, x, &objective, constraints);
  printf("hs-71: %g, constraints %g %g, best known %.6f\n", objective, constraints[0],
         constraints[1], ricochet_best_known(problem));
  ricochet_close(problem);
  ricochet_close_machine(machine);
  return 0;
}
