#include "src/research/limits/goal_search.h"

#include <fmt/format.h>

#include <stdexcept>

#include "ricochet/run.h"
#include "src/research/calibration/fit_task.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

double value_at(const Target& target, const Interpretation& interpretation,
                const Constants& constants) {
  return target.value(target.of_thresholds ? judged_by_thresholds(interpretation, constants)
                                           : judged_coarsely(interpretation, constants));
}

Problem problem_of(const GoalSearch& search) {
  Problem problem = calibration_problem(search.parameterisation);
  problem.name += fmt::format("-{}-seed-{}", search.target.name, search.seed);
  problem.residuals = nullptr;
  problem.evaluate = [parameterisation = search.parameterisation,
                      target = search.target](const Vector& x) {
    return Values{
        value_at(target, parameterisation.interpretation, constants_at(parameterisation, x)), {}};
  };
  return problem;
}

std::vector<Fit> half_and_whole(const GoalSearch& search) {
  const Problem problem = problem_of(search);
  const RunRecord record =
      run(problem, search.solver, Budget{search.evaluations}, search.from_held ? 0 : search.seed);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  const Parameterisation& parameterisation = search.parameterisation;
  const double loss =
      value_at(search.target, parameterisation.interpretation, parameterisation.held);
  return {calibration::best_within(search.evaluations / 2, record, parameterisation, loss),
          calibration::best_within(search.evaluations, record, parameterisation, loss)};
}

calibration::FitTask task_of(const GoalSearch& search) {
  calibration::FitTask task{
      {}, [&search] { return half_and_whole(search); }, static_cast<double>(search.evaluations)};
  for (const char* look : {"half", "whole"}) {
    task.asked.push_back(
        {fmt::format("limits, {} from {}, {}, by {}, seed {}", search.target.name,
                     search.from_held ? "held" : "anywhere", look, search.solver.name, search.seed),
         search.parameterisation, "",
         calibration::options_of({search.solver, {}, {}, search.evaluations, search.seed}),
         [&search](const Fit& fit) { return value_of(search.target, fit); }});
  }
  return task;
}

}  // namespace

double value_of(const Target& target, const Fit& fit) {
  return value_at(target, fit.interpretation, fit.constants);
}

std::vector<GoalFound> searched(const std::vector<GoalSearch>& searches, const std::string& what,
                                FitStore& store) {
  std::vector<calibration::FitTask> tasks;
  for (const GoalSearch& search : searches) tasks.push_back(task_of(search));
  std::vector<GoalFound> all;
  for (std::vector<Fit>& fits : calibration::searched(what, tasks, store)) {
    all.push_back({std::move(fits[0]), std::move(fits[1])});
  }
  return all;
}

Parameterisation parameterisation_of(const Interpretation& interpretation,
                                     const std::vector<Unknown>& free) {
  Parameterisation parameterisation = full_parameterisation(interpretation);
  std::erase_if(parameterisation.free, [&](Unknown open) { return !contains(free, open); });
  return parameterisation;
}

}  // namespace ricochet::studies::limits
