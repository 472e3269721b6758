#include <ricochet/ricochet.h>

/// Writes into all that it is shown of the problem, and then asks for a point far outside.
const ricochet_solver ricochet_plugin = {
    RICOCHET_ABI,
    "widens-its-box",
    "1",
    0,
    0,
    0,
    0,
    [](ricochet_problem* problem, double* point) -> const char* {
      const int n = problem->dimension;
      for (int i = 0; i < n; ++i) {
        const_cast<double*>(problem->lower)[i] = -1e6;
        const_cast<double*>(problem->upper)[i] = 1e6;
        const_cast<double*>(problem->start)[i] = 1e6;
        point[i] = 1e6;
      }
      problem->dimension = 1;
      problem->values(problem, point, nullptr, nullptr);
      return "widened";
    }};
