#include "src/benchmark/experiment/store/run_key.h"

#include <fmt/format.h>

namespace ricochet {

std::string name_of(const RunKey& key) {
  const Cell& cell = key.cell;
  return fmt::format(
      "run {} of {} on instance {} of {} (formulation {}, perturbation {}, budget {}, gradient "
      "price {})",
      key.run, cell.solver, key.instance, cell.problem, cell.formulation, cell.perturbation,
      cell.budget, cell.gradient_price);
}

}  // namespace ricochet
