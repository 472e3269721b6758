#include "src/studies/limits/goal_search.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>

#include "solvers/solvers.h"
#include "src/campaign/progress.h"
#include "src/core/error.h"
#include "src/core/run.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

double value_at(const Target& target, const Reading& reading, const Constants& constants) {
  return target.value(target.of_thresholds ? judged_by_thresholds(reading, constants)
                                           : judged_coarsely(reading, constants));
}

Problem problem_of(const GoalSearch& search) {
  Problem problem = calibration_problem(search.freedom);
  problem.name += fmt::format("-{}-seed-{}", search.target.name, search.seed);
  problem.residuals = nullptr;
  problem.evaluate = [freedom = search.freedom, target = search.target](const Vector& x) {
    return Values{value_at(target, freedom.reading, constants_at(freedom, x)), {}};
  };
  return problem;
}

GoalFound found_by(const GoalSearch& search) {
  const Problem problem = problem_of(search);
  const RunRecord record =
      run(problem, search.solver, Budget{search.evaluations}, search.from_held ? 0 : search.seed);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  const Freedom& freedom = search.freedom;
  const auto best_within = [&](std::int64_t evaluations) {
    Fit fit{freedom.reading, freedom.freed, freedom.held, 0, ""};
    fit.misfit = value_at(search.target, freedom.reading, freedom.held);
    for (const Improvement& better : record.trace) {
      if (better.evaluations > evaluations) break;
      if (better.truth.objective >= fit.misfit) continue;
      fit.misfit = better.truth.objective;
      fit.constants = constants_at(freedom, better.x);
    }
    return fit;
  };
  return {best_within(search.evaluations / 2), best_within(search.evaluations)};
}

std::string key_for(const GoalSearch& search, const char* look) {
  const auto kind = fmt::format("limits-{}-{}-{}", search.target.name,
                                search.from_held ? "from-held" : "from-anywhere", look);
  return calibration::key_of(kind, search.freedom,
                             {search.solver, {}, {}, search.evaluations, search.seed}, "");
}

GoalFound known_or_found(const GoalSearch& search, FitStore& store) {
  const std::string half = key_for(search, "half");
  const std::string whole = key_for(search, "whole");
  const auto known_half = store.find(half);
  const auto known_whole = store.find(whole);
  if (known_half && known_whole) return {*known_half, *known_whole};
  GoalFound found = found_by(search);
  store.add({{half, found.half}, {whole, found.whole}});
  return found;
}

}  // namespace

double value_of(const Target& target, const Fit& fit) {
  return value_at(target, fit.reading, fit.constants);
}

std::vector<GoalFound> searched(const std::vector<GoalSearch>& searches, const std::string& what,
                                FitStore& store) {
  std::vector<GoalFound> all(searches.size());
  Progress progress(what, static_cast<double>(searches.size()));
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, searches.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          all[i] = known_or_found(searches[i], store);
          progress.advance(1);
        }
      },
      tbb::simple_partitioner());
  return all;
}

Freedom freedom_of(const Reading& reading, const std::vector<Open>& freed) {
  Freedom freedom = full_freedom(reading);
  std::erase_if(freedom.freed, [&](Open open) { return !contains(freed, open); });
  return freedom;
}

Solver solver_named(const std::string& name) {
  for (const Solver& solver : all_solvers()) {
    if (solver.name == name) return solver;
  }
  throw InputError(fmt::format("this build has no {}, by which this study searches", name));
}

}  // namespace ricochet::studies::limits
