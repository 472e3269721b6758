#include "src/research/suite/catalogue.h"

#include <utility>

#include "problems/carrier_track/problems/drawn_machine.h"
#include "problems/carrier_track/problems/machine_grid.h"
#include "ricochet/solvers.h"
#include "solvers/outside/outside.h"
#include "solvers/varied.h"
#include "src/research/suite/families.h"

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
