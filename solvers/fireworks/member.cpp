#include "solvers/fireworks/member.h"

#include <stdexcept>
#include <utility>

#include "solvers/unit_box.h"

namespace ricochet::fireworks {

Solver member(std::string name,
              std::function<void(Evaluator&, const Vector& start, Random&)> until_refused) {
  Solver solver;
  solver.name = std::move(name);
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.stochastic = true;
  solver.capabilities.constraints = Capabilities::Constraints::all;
  solver.solve = [until_refused = std::move(until_refused)](Evaluator& evaluator,
                                                            const Vector& start,
                                                            Random& random) -> SolverTermination {
    until_refused(evaluator, start, random);
    return {stopped_by_evaluator};
  };
  return solver;
}

void check_number(const char* option, int number) {
  if (number < 1 || number > 1'000'000) {
    throw std::invalid_argument(std::string(option) + ": must be in 1..1000000");
  }
}

}  // namespace ricochet::fireworks
