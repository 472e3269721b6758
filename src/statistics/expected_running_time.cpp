#include "src/statistics/expected_running_time.h"

namespace ricochet {

std::optional<double> expected_running_time(const std::vector<Effort>& runs) {
  double spent = 0;
  int successes = 0;
  for (const Effort& run : runs) {
    spent += run.spent;
    successes += run.reached ? 1 : 0;
  }
  if (successes == 0) return std::nullopt;
  return spent / successes;
}

}  // namespace ricochet
