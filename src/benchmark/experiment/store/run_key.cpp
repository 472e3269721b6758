#include "src/store/run_key.h"

#include <fmt/format.h>

namespace ricochet {

std::string name_of(const RunKey& key) {
  const Cell& cell = key.cell;
  return fmt::format(
      "run {} of {} on instance {} of {} (form {}, feature {}, budget {}, gradient price {})",
      key.run, cell.solver, key.instance, cell.question, cell.form, cell.feature, cell.budget,
      cell.gradient_price);
}

}  // namespace ricochet
