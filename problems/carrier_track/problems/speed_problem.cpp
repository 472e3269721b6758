#include "problems/carrier_track/problems/speed_problem.h"

#include <fmt/format.h>

#include "problems/carrier_track/problems/best_known.h"

namespace ricochet::carrier_track::inline problems {

Problem speed_problem(const std::string& family, const Machine& machine, std::string source) {
  Problem problem;
  problem.name = fmt::format("{}-{}", family, machine.id);
  problem.source = std::move(source);
  problem.variables = {{"speed", "rad/s"}};
  problem.lower = Vector::Constant(1, slowest_speed);
  problem.upper = Vector::Constant(1, fastest_speed);
  problem.start = Vector::Constant(1, (slowest_speed + fastest_speed) / 2);
  problem.machine = machine.id;
  know_best(problem, machine.default_hash);
  return problem;
}

}  // namespace ricochet::carrier_track::inline problems
