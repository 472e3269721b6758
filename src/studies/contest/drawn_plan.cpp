#include "src/studies/contest/drawn_plan.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "problems/carrier_track/questions/drawn_machine.h"
#include "problems/carrier_track/questions/scanned_best.h"
#include "problems/carrier_track/questions/top_speed.h"

namespace ricochet::studies::contest {
namespace {

/// A scan takes as long as some hundred runs.
constexpr int most_draws = 5;

}  // namespace

ContestPlan drawn_plan(const ContestPlan& plan) {
  using namespace carrier_track;
  std::vector<Machine> machines;
  for (const Machine& machine : all_machines()) {
    const bool asked = std::any_of(
        plan.questions.begin(), plan.questions.end(),
        [&](const Question& q) { return q.name() == top_speed_question(machine).name(); });
    if (!asked) continue;
    for (int draw = 1; draw <= std::min(plan.instances, most_draws); ++draw) {
      machines.push_back(drawn_machine(machine, draw));
    }
  }
  ContestPlan drawn = plan;
  drawn.questions.resize(machines.size());
  tbb::parallel_for(std::size_t{0}, machines.size(), [&](std::size_t k) {
    drawn.questions[k] = with_scanned_best(top_speed_question(machines[k]));
  });
  std::erase_if(drawn.questions, [](const Question& q) { return !q.stated.best_known; });
  drawn.instances = 1;
  drawn.budgets = {plan.budgets.back()};
  return drawn;
}

}  // namespace ricochet::studies::contest
