#include "src/studies/contest/catalogue.h"

#include <utility>

#include "problems/carrier_track/questions/machine_grid.h"
#include "problems/carrier_track/questions/scanned_best.h"
#include "problems/families.h"
#include "solvers/outside/outside.h"
#include "solvers/solvers.h"
#include "solvers/varied.h"

namespace ricochet::studies {

Catalogue whole_catalogue() {
  return {all_families(),
          all_solvers(),
          outside::outside_solver,
          [](const MachineGrid& grid) {
            return carrier_track::grid_families(
                grid.around, {grid.restitution, grid.friction, grid.disturbance, grid.fidelity});
          },
          [](const VariedSolver& solver) { return varied(solver.of, solver.name, solver.options); },
          [](Question question) { return carrier_track::with_scanned_best(std::move(question)); }};
}

}  // namespace ricochet::studies
