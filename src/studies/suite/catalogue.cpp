#include <utility>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"
#include "solvers/outside/outside.h"
#include "src/studies/suite/suite.h"

namespace ricochet::studies {

Catalogue whole_catalogue() {
  return {
      suite_families(),
      all_solvers(),
      outside::outside_solver,
      carrier_track::machine_keys(),
      [](const MachineGrid& grid) {
        return carrier_track::grid_problems(grid.around, grid.levels, grid.scene);
      },
      carrier_track::drawn_problem,
      [](const VariedSolver& solver) { return varied(solver.of, solver.name, solver.options); }};
}

}  // namespace ricochet::studies
