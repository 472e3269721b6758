#include <ricochet/ricochet.h>

#include <stdexcept>

const ricochet_solver ricochet_plugin = {
    RICOCHET_ABI,
    "throws",
    "1",
    2,
    0,
    0,
    0,
    [](ricochet_problem* problem, double* point) -> const char* {
      problem->values(problem, point, nullptr, nullptr);
      throw std::runtime_error("lost its way");
    }};
