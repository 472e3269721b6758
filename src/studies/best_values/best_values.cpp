#include "src/studies/best_values/best_values.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/core/files.h"
#include "src/core/instance.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/experiment/store.h"

namespace ricochet::studies::best_values {

namespace {

using namespace carrier_track;

/// Returns the finished results of an interrupted call if their values are reproduced at their
/// points. The others are searched again.
BestValues read_part(const std::vector<Problem>& problems, const std::filesystem::path& part) {
  BestValues finished = read_if_there(part);
  if (finished.machine != default_machine_hash()) {
    throw InputError(fmt::format("{}: of the default machine {}, and this one is {}: move it away",
                                 part.string(), finished.machine, default_machine_hash()));
  }
  for (const Problem& problem : problems) {
    const auto found = finished.of.find(problem.name);
    if (found == finished.of.end()) continue;
    if (found->second.value != worth(problem, found->second)) finished.of.erase(found);
  }
  return finished;
}

std::string nothing_matches(const std::vector<Problem>& problems, const std::string& pattern) {
  std::vector<std::string> names;
  for (const Problem& problem : problems) names.push_back(problem.name);
  const std::vector<std::string> near = near_names(pattern, names);
  return fmt::format("--problems {}: none of the paper's cases matches; {}", pattern,
                     near.empty() ? "see ricochet list problems" : what_instead(pattern, names));
}

/// Estimated work for a problem, for the progress display, about proportional to the time.
double work_of(const Problem& problem) {
  const double n = static_cast<double>(problem.dimension());
  return n == 1 ? 1e-4 * problem.cost / problem.scan_step : n;
}

}  // namespace

bool matches(const std::string& name, const std::string& pattern) {
  if (pattern.find_first_of("*?[") == std::string::npos) {
    return name.find(pattern) != std::string::npos;
  }
  return fits(name, pattern);
}

Outcome find_best_values(const std::vector<Problem>& problems, const Plan& plan,
                         const std::filesystem::path& file) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<const Problem*> wanted;
  double work = 0;
  for (const Problem& problem : problems) {
    if (!matches(problem.name, plan.problems)) continue;
    wanted.push_back(&problem);
    work += work_of(problem);
  }
  if (wanted.empty()) {
    throw InputError(nothing_matches(problems, plan.problems));
  }
  const std::filesystem::path part = file.string() + ".part";
  BestValues known = known_values(problems, file);
  BestValues finished = read_part(problems, part);
  const AtInterruption kept([] {}, fmt::format("finished searches are kept in {}: the same command "
                                               "goes on",
                                               part.string()));
  // Longest first, so that no core waits for another at the end.
  std::stable_sort(wanted.begin(), wanted.end(),
                   [](const Problem* a, const Problem* b) { return work_of(*a) > work_of(*b); });
  std::mutex mutex;
  {
    Progress progress("looking for best values", work);
    const auto look = [&](std::size_t i) {
      const Problem& problem = *wanted[i];
      {
        const std::lock_guard lock(mutex);
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        if (finished.of.contains(problem.name) || passed.count() > plan.seconds) {
          progress.advance(work_of(problem));
          return;
        }
      }
      const auto before = known.of.find(problem.name);
      // Isolated: a thread that waits within a run must not begin another, which would disturb the
      // solver libraries' thread-local state.
      BestKnown best = tbb::this_task_arena::isolate([&] {
        return best_of(before == known.of.end() ? problem : knowing(problem, before->second),
                       plan.effort);
      });
      const std::lock_guard lock(mutex);
      finished.of.insert_or_assign(problem.name, std::move(best));
      write_text_file(part, write_best_values(finished));
      progress.advance(work_of(problem));
    };
    tbb::parallel_for(std::size_t{0}, wanted.size(), look, tbb::simple_partitioner());
  }
  Outcome outcome;
  outcome.wanted = wanted.size();
  for (const Problem* problem : wanted) {
    const auto found = finished.of.find(problem->name);
    if (found == finished.of.end()) continue;
    ++outcome.finished;
    const BestKnown& best = found->second;
    const auto before = known.of.find(problem->name);
    const bool is_new = before == known.of.end();
    if (std::isfinite(best.value) && (is_new || best.value < before->second.value)) {
      ++outcome.improved;
      known.of.insert_or_assign(problem->name, best);
    } else if (!is_new && best.point == before->second.point) {
      before->second.provenance = best.provenance;  // how many searches agree
    }
    if (!known.of.contains(problem->name)) ++outcome.infeasible;
  }
  if (outcome.finished == outcome.wanted) {
    write_text_file(file, write_best_values(known));
    for (const Problem* problem : wanted) finished.of.erase(problem->name);
    if (finished.of.empty()) {
      std::filesystem::remove(part);
    } else {  // from a call for other problems
      write_text_file(part, write_best_values(finished));
    }
  }
  return outcome;
}

namespace {

/// The best point so far, and the solver that found it.
struct Best {
  std::optional<TrueValues> true_values;
  Vector x;
  std::string finder;
};

/// Null if this build does not have it.
const Solver* solver_named(const std::string& name) {
  static const std::vector<Solver> solvers = all_solvers();
  const auto found = std::find_if(solvers.begin(), solvers.end(),
                                  [&](const Solver& solver) { return solver.name == name; });
  return found == solvers.end() ? nullptr : &*found;
}

/// Runs the solver, from the best point if there is one, and keeps improvements.
void improve(const Problem& problem, double smoothing, const std::string& solver_name,
             std::int64_t evaluations, int number, Best& best) {
  const Solver* solver = solver_named(solver_name);
  if (!solver) return;
  Problem formulated = problem.formulated({smoothing});
  if (formulated.constraints > 0 && !solver->accepts(formulated)) {
    formulated = problem.formulated({smoothing, true});
  }
  if (!solver->accepts(formulated)) return;
  if (best.true_values) {
    formulated.start = best.x;
    number = 0;  // from there
  }
  const RunRecord record = run(formulated, *solver, Budget{evaluations}, number);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  if (record.trace.empty()) return;
  const Improvement& last = record.trace.back();
  if (best.true_values && !better(last.true_values, *best.true_values)) return;
  best = {last.true_values, last.x, finder_of(record)};
}

/// The solvers that do best on problems with derivatives, and without.
std::vector<std::string> searchers_of(const Problem& problem) {
  if (problem.differentiate) return {"nlopt-slsqp", "nlopt-ccsaq", "pagmo-cmaes-ipop"};
  return {"pagmo-cmaes-ipop", "nlopt-crs2", "mads"};
}

Best searched(const Problem& problem, const std::string& solver, std::int64_t evaluations,
              int number) {
  Best best;
  improve(problem, 0, solver, evaluations, number, best);
  const std::int64_t more = std::max<std::int64_t>(1, evaluations / 20);
  if (problem.smoothed) improve(problem, problem.smoothing, "nlopt-slsqp", more, 0, best);
  for (const char* local : {"nlopt-slsqp", "nlopt-cobyla", "nlopt-sbplx"}) {
    improve(problem, 0, local, more, 0, best);
  }
  return best;
}

/// The problem's best known point, evaluated by this version.
Best known_best(const Problem& problem) {
  if (!problem.best_point) return {};
  const std::string finder = problem.provenance.substr(0, problem.provenance.find("; "));
  return {true_values_at(problem, *problem.best_point), *problem.best_point, finder};
}

/// The number of searches that end within the tolerance of the best.
int agreeing(const std::vector<Best>& searches, const Best& best, double tolerance) {
  return static_cast<int>(std::ranges::count_if(searches, [&](const Best& search) {
    return search.true_values && search.true_values->violation <= best.true_values->violation &&
           search.true_values->objective <= best.true_values->objective + tolerance;
  }));
}

BestKnown known(const TrueValues& true_values, const Vector& x, std::string provenance) {
  if (true_values.violation > 0) {
    return {std::numeric_limits<double>::infinity(), Vector(), std::move(provenance)};
  }
  return {true_values.objective, x, std::move(provenance)};
}

}  // namespace

BestKnown search_for_best(const Problem& problem, const Effort& effort) {
  const std::vector<std::string> searchers = searchers_of(problem);
  const std::int64_t evaluations = effort.evaluations_per_variable * problem.dimension();
  Best best = known_best(problem);
  std::vector<Best> searches;
  int agree = 0;
  for (int number = 0; number < effort.rounds && agree < 2; ++number) {
    for (std::size_t k = 0; k < searchers.size() && agree < 2; ++k) {
      const Best found = searched(problem, searchers[k], evaluations, number);
      if (!found.true_values) continue;
      if (!best.true_values || better(*found.true_values, *best.true_values)) best = found;
      searches.push_back(found);
      agree = agreeing(searches, best, problem.tolerance);
    }
  }
  if (searches.empty()) throw std::runtime_error(problem.name + ": no solver has found a point");
  // Dual numbers round differently: store the value of the plain evaluation.
  return known(true_values_at(problem, best.x), best.x,
               fmt::format("{}; {} of {} searches of {} evaluations agree", best.finder, agree,
                           searches.size(), evaluations));
}

BestKnown best_of(const Problem& problem, const Effort& effort) {
  return problem.dimension() == 1 ? scan_for_best(problem, problem.scan_step)
                                  : search_for_best(problem, effort);
}

BestValues read_if_there(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {default_machine_hash(), {}};
  std::ifstream stream(file, std::ios::binary);
  return parse_best_values({std::istreambuf_iterator<char>(stream), {}}, file.string());
}

double worth(const Problem& problem, const BestKnown& best) {
  if (best.point.size() != problem.dimension()) return std::numeric_limits<double>::infinity();
  const TrueValues true_values = true_values_at(problem, best.point);
  return true_values.violation > 0 ? std::numeric_limits<double>::infinity()
                                   : true_values.objective;
}

std::string finder_of(const RunRecord& record) {
  return fmt::format("{}, seed {}, {} of {} evaluations", record.solver, record.seed,
                     record.trace.back().evaluations, record.budget.evaluations);
}

BestValues known_values(const std::vector<Problem>& problems, const std::filesystem::path& file) {
  BestValues known{default_machine_hash(), {}};
  const BestValues in_file = read_if_there(file);
  for (const Problem& problem : problems) {
    std::vector<BestKnown> candidates;
    if (problem.best_point) candidates.push_back({0, *problem.best_point, problem.provenance});
    const auto found = in_file.of.find(problem.name);
    if (found != in_file.of.end()) candidates.push_back(found->second);
    for (BestKnown& best : candidates) {
      best.value = worth(problem, best);
      const auto before = known.of.find(problem.name);
      const double so_far =
          before == known.of.end() ? std::numeric_limits<double>::infinity() : before->second.value;
      if (best.value <= so_far) known.of.insert_or_assign(problem.name, best);
    }
  }
  return known;
}

namespace {

/// The last point of a run's trace, in the problem as stated, and its value there.
BestKnown best_of(const Problem& problem, const StoredRun& run) {
  const Vector& x = run.record.trace.back().x;
  BestKnown best{0, stated_point(problem, run.key.instance, x), finder_of(run.record)};
  best.value = worth(problem, best);
  return best;
}

}  // namespace

std::size_t take_stored_values(const std::vector<Problem>& problems,
                               const std::filesystem::path& store,
                               const std::filesystem::path& file) {
  std::map<std::string, const Problem*> named;
  for (const Problem& problem : problems) named.emplace(problem.name, &problem);
  BestValues known = known_values(problems, file);
  std::set<std::string> improved;
  Store::open(store, Store::For::reading).each([&](const StoredRun& run) {
    const auto problem = named.find(run.key.cell.problem);
    if (problem == named.end() || run.record.trace.empty()) return;
    const auto before = known.of.find(problem->first);
    const double so_far =
        before == known.of.end() ? std::numeric_limits<double>::infinity() : before->second.value;
    const double least_gain = problem->second->tolerance;
    const double found = run.record.trace.back().true_values.objective;
    if (!(found < so_far - least_gain)) return;  // without an evaluation
    BestKnown best = best_of(*problem->second, run);
    if (!(best.value < so_far - least_gain)) return;
    improved.insert(problem->first);
    known.of.insert_or_assign(problem->first, std::move(best));
  });
  if (!improved.empty()) write_text_file(file, write_best_values(known));
  return improved.size();
}

}  // namespace ricochet::studies::best_values
