#include "src/studies/best_values/best_values.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>

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

/// The best point so far, and the solver that found it.
struct Best {
  std::optional<TrueValues> true_values;
  Vector x;
  std::string finder;
};

/// Where the last point of a run's trace comes from.
std::string finder_of(const RunRecord& record) {
  return fmt::format("{}, seed {}, {} of {} evaluations", record.solver, record.seed,
                     record.trace.back().evaluations, record.budget.evaluations);
}

/// Runs the solver, if this build has it and it accepts the problem, from this point, or else from
/// the run's own start, and keeps improvements. Gradients are charged what they were measured to
/// cost. Returns what the run was charged.
std::int64_t improve(const Problem& problem, double smoothing, const std::string& name,
                     std::int64_t evaluations, int number, const Vector& start, Best& best) {
  static const std::vector<Solver> solvers = all_solvers();
  const auto solver = std::ranges::find(solvers, name, &Solver::name);
  if (solver == solvers.end()) return 0;
  Problem formulated = problem.formulated({smoothing});
  if (formulated.constraints > 0 && !solver->accepts(formulated))
    formulated = problem.formulated({smoothing, true});
  if (!solver->accepts(formulated)) return 0;
  if (start.size() > 0) {
    formulated.start = start;
    number = 0;  // from there
  }
  Budget budget{evaluations};
  budget.gradient_price = problem.gradient_cost;
  const RunRecord record = run(formulated, *solver, budget, number);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  if (record.trace.empty()) return record.ledger.charged;
  const Improvement& last = record.trace.back();
  if (!best.true_values || better(last.true_values, *best.true_values)) {
    best = {last.true_values, last.x, finder_of(record)};
  }
  return record.ledger.charged;
}

/// Basin hopping (Wales and Doye 1997, doi:10.1021/jp970984n) from the best point, whose gradients
/// must be known: moves some of its coordinates at random and descends from there, again and again,
/// and keeps improvements. On a surrogate if the problem has one.
void hop(const Problem& problem, std::int64_t evaluations, int number, Best& best) {
  constexpr double step = 0.15;                           // of the box
  constexpr std::int64_t descent = 300;                   // evaluations, the most of one
  constexpr double least_moved = 0.05, most_moved = 0.4;  // share of the coordinates
  Random random(seed_of(problem.name, "basin hopping", number, 0));
  const Vector width = problem.upper - problem.lower;
  for (std::int64_t spent = 0; spent < evaluations;) {
    const double moved = least_moved + (most_moved - least_moved) * uniform(random);
    Vector x = best.x;
    const Vector shift = step * width.cwiseProduct(normal(x.size(), random));
    const auto always = static_cast<Eigen::Index>(uniform(random) * static_cast<double>(x.size()));
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      if (i == always || uniform(random) < moved) x[i] += shift[i];
    }
    x = x.cwiseMax(problem.lower).cwiseMin(problem.upper);
    const double smoothing = problem.smoothed ? problem.smoothing : 0;
    spent += std::max<std::int64_t>(
        1, improve(problem, smoothing, problem.constraints > 0 ? "nlopt-slsqp" : "nlopt-lbfgs",
                   std::min(descent, evaluations - spent), 0, x, best));
  }
  best.finder += ", in basin hopping";
}

Best searched(const Problem& problem, const std::string& solver, std::int64_t evaluations,
              int number) {
  Best best;
  improve(problem, 0, solver, evaluations, number, {}, best);
  const std::int64_t more = std::max<std::int64_t>(1, evaluations / 20);
  const auto refine = [&] {
    if (problem.smoothed) improve(problem, problem.smoothing, "nlopt-slsqp", more, 0, best.x, best);
    for (const char* local : {"nlopt-slsqp", "nlopt-cobyla", "nlopt-sbplx"})
      improve(problem, 0, local, more, 0, best.x, best);
  };
  refine();
  const bool descends = static_cast<bool>(
      problem.formulated({problem.smoothed ? problem.smoothing : 0}).differentiate);
  if (!best.true_values || !descends) return best;
  Best hopped = best;
  hop(problem, evaluations, number, hopped);
  if (better(*hopped.true_values, *best.true_values)) {
    best = std::move(hopped);
    refine();
  }
  return best;
}

/// The true objective of a point, evaluated by this version; infinite if it is not a feasible point
/// of the problem.
double worth(const Problem& problem, const Vector& point) {
  constexpr double nothing = std::numeric_limits<double>::infinity();
  if (point.size() != problem.dimension()) return nothing;
  const TrueValues true_values = true_values_at(problem, point);
  return true_values.violation > 0 ? nothing : true_values.objective;
}

BestKnown search_for_best(const Problem& problem, const Effort& effort) {
  // The solvers that do best on problems with derivatives, and without.
  const std::vector<std::string> searchers =
      problem.differentiate || problem.smoothed
          ? std::vector<std::string>{"nlopt-slsqp", "nlopt-ccsaq", "pagmo-cmaes-ipop-tuned"}
          : std::vector<std::string>{"pagmo-cmaes-ipop-tuned", "nlopt-crs2", "mads-tuned"};
  const std::int64_t evaluations = effort.evaluations_per_variable * problem.dimension();
  Best best;
  if (problem.best_point) {
    best = {true_values_at(problem, *problem.best_point), *problem.best_point,
            problem.provenance.substr(0, problem.provenance.find("; "))};
  }
  std::vector<Best> searches;
  std::ptrdiff_t agree = 0;
  for (std::size_t k = 0;
       agree < 2 && k < static_cast<std::size_t>(effort.rounds) * searchers.size(); ++k) {
    const Best found = searched(problem, searchers[k % searchers.size()], evaluations,
                                static_cast<int>(k / searchers.size()));
    if (!found.true_values) continue;
    if (!best.true_values || better(*found.true_values, *best.true_values)) best = found;
    searches.push_back(found);
    agree = std::ranges::count_if(searches, [&](const Best& one) {
      return one.true_values->violation <= best.true_values->violation &&
             one.true_values->objective <= best.true_values->objective + problem.tolerance;
    });
  }
  if (searches.empty()) throw std::runtime_error(problem.name + ": no solver has found a point");
  // Dual numbers round differently: store the value of the plain evaluation.
  const double value = worth(problem, best.x);
  return {value, std::isfinite(value) ? best.x : Vector(),
          fmt::format("{}; {} of {} searches of {} evaluations agree", best.finder, agree,
                      searches.size(), evaluations)};
}

/// Infinite for a problem without a value.
double value_in(const BestValues& values, const std::string& problem) {
  const auto found = values.of.find(problem);
  return found == values.of.end() ? std::numeric_limits<double>::infinity() : found->second.value;
}

/// The best values of the problems: those in the program or in the file, whichever is better, the
/// file's if they are equal; evaluated by this version.
BestValues known_values(const std::vector<Problem>& problems, const std::filesystem::path& file) {
  BestValues known{default_machine_hash(), {}};
  const BestValues in_file = read_if_there(file);
  for (const Problem& problem : problems) {
    const auto keep = [&](const Vector& point, const std::string& provenance) {
      const double value = worth(problem, point);
      if (value <= value_in(known, problem.name))
        known.of.insert_or_assign(problem.name, BestKnown{value, point, provenance});
    };
    if (problem.best_point) keep(*problem.best_point, problem.provenance);
    const auto found = in_file.of.find(problem.name);
    if (found != in_file.of.end()) keep(found->second.point, found->second.provenance);
  }
  return known;
}

/// The finished results of an interrupted call, of those problems whose values are reproduced at
/// their points. The others are searched again.
BestValues read_part(const std::vector<Problem>& problems, const std::filesystem::path& part) {
  BestValues finished = read_if_there(part);
  if (finished.machine != default_machine_hash()) {
    throw InputError(fmt::format("{}: of the default machine {}, and this one is {}: move it away",
                                 part.string(), finished.machine, default_machine_hash()));
  }
  for (const Problem& problem : problems) {
    const auto found = finished.of.find(problem.name);
    if (found != finished.of.end() && found->second.value != worth(problem, found->second.point))
      finished.of.erase(found);
  }
  return finished;
}

/// Estimated work for a problem, about proportional to the time.
double work_of(const Problem& problem) {
  const auto n = static_cast<double>(problem.dimension());
  return n == 1 ? 1e-4 * problem.cost / problem.scan_step : n;
}

/// Searches the wanted problems that are not finished. Writes all finished ones to the file `part`
/// after each.
void search(const std::vector<Problem>& wanted, const Plan& plan, const BestValues& known,
            const std::filesystem::path& part, BestValues& finished) {
  const auto start = std::chrono::steady_clock::now();
  const AtInterruption kept([] {}, fmt::format("finished searches are kept in {}: the same command "
                                               "goes on",
                                               part.string()));
  double work = 0;
  for (const Problem& problem : wanted) work += work_of(problem);
  Progress progress("looking for best values", work);
  std::mutex mutex;
  const auto look = [&](std::size_t i) {
    const Problem& problem = wanted[i];
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    std::unique_lock lock(mutex);
    if (!finished.of.contains(problem.name) && passed.count() <= plan.seconds) {
      lock.unlock();
      const auto before = known.of.find(problem.name);
      // Isolated: a thread that waits within a run must not begin another, which would disturb the
      // solver libraries' thread-local state.
      BestKnown best = tbb::this_task_arena::isolate([&] {
        return best_of(before == known.of.end() ? problem : knowing(problem, before->second),
                       plan.effort);
      });
      lock.lock();
      finished.of.insert_or_assign(problem.name, std::move(best));
      write_text_file(part, write_best_values(finished));
    }
    progress.advance(work_of(problem));
  };
  tbb::parallel_for(std::size_t{0}, wanted.size(), look, tbb::simple_partitioner());
}

}  // namespace

BestKnown best_of(const Problem& problem, const Effort& effort) {
  return problem.dimension() == 1 ? scan_for_best(problem, problem.scan_step)
                                  : search_for_best(problem, effort);
}

std::vector<Problem> matching(const std::vector<Problem>& problems, const std::string& pattern) {
  const bool whole = pattern.find_first_of("*?[") != std::string::npos;
  std::vector<Problem> found;
  std::vector<std::string> names;
  for (const Problem& problem : problems) {
    names.push_back(problem.name);
    if (fits(problem.name, whole ? pattern : "*" + pattern + "*")) found.push_back(problem);
  }
  if (found.empty()) {
    throw InputError(fmt::format("--problems {}: none of the paper's cases matches; {}", pattern,
                                 what_instead(pattern, names, "ricochet list problems")));
  }
  return found;
}

Outcome find_best_values(const std::vector<Problem>& problems, const Plan& plan,
                         const std::filesystem::path& file) {
  std::vector<Problem> wanted = matching(problems, plan.problems);
  // Longest first, so that no core waits for another at the end.
  std::ranges::stable_sort(wanted, std::ranges::greater(), work_of);
  const std::filesystem::path part = file.string() + ".part";
  BestValues known = known_values(problems, file), finished = read_part(problems, part);
  search(wanted, plan, known, part, finished);
  Outcome outcome{wanted.size()};
  for (const Problem& problem : wanted) {
    const auto found = finished.of.find(problem.name);
    if (found == finished.of.end()) continue;
    ++outcome.finished;
    const BestKnown& best = found->second;
    const auto before = known.of.find(problem.name);
    if (best.value < value_in(known, problem.name)) {
      ++outcome.improved;
      known.of.insert_or_assign(problem.name, best);
    } else if (before != known.of.end() && best.point == before->second.point) {
      before->second.provenance = best.provenance;  // how many searches agree
    }
    outcome.infeasible += known.of.contains(problem.name) ? 0 : 1;
  }
  if (outcome.finished < outcome.wanted) return outcome;
  write_text_file(file, write_best_values(known));
  for (const Problem& problem : wanted) finished.of.erase(problem.name);
  if (finished.of.empty()) {
    std::filesystem::remove(part);
  } else {  // from a call for other problems
    write_text_file(part, write_best_values(finished));
  }
  return outcome;
}

BestValues read_if_there(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {default_machine_hash(), {}};
  return parse_best_values(text_of_file(file), file.string());
}

std::size_t take_stored_values(const std::vector<Problem>& problems,
                               const std::filesystem::path& store,
                               const std::filesystem::path& file) {
  BestValues known = known_values(problems, file);
  std::set<std::string> improved;
  Store::open(store, Store::For::reading).each([&](const StoredRun& run) {
    const auto problem = std::ranges::find(problems, run.key.cell.problem, &Problem::name);
    if (problem == problems.end() || run.record.trace.empty()) return;
    const Improvement& last = run.record.trace.back();
    const double enough = value_in(known, problem->name) - problem->tolerance;
    if (!(last.true_values.objective < enough)) return;  // without an evaluation
    const Vector point = stated_point(*problem, run.key.instance, last.x);
    const double value = worth(*problem, point);
    if (!(value < enough)) return;
    improved.insert(problem->name);
    known.of.insert_or_assign(problem->name, BestKnown{value, point, finder_of(run.record)});
  });
  if (!improved.empty()) write_text_file(file, write_best_values(known));
  return improved.size();
}

Table proofs(const std::vector<Problem>& problems) {
  Table table{"proofs", {{"problem"}, {"best"}, {"proven"}, {"left", "not excluded"}}};
  std::vector<const Problem*> told;
  for (const Problem& problem : problems)
    if (problem.not_excluded && problem.best_known) told.push_back(&problem);
  table.rows.resize(told.size());
  Progress progress("proving best values", static_cast<double>(told.size()));
  tbb::parallel_for(std::size_t{0}, told.size(), [&](std::size_t k) {
    const Problem& problem = *told[k];
    std::string left;
    for (const CoordinateRange& range : problem.not_excluded(*problem.best_known))
      left += fmt::format("{}{:.6g} to {:.6g}", left.empty() ? "" : ", ", range.from, range.to);
    table.rows[k] = {problem.name, *problem.best_known, left.empty(), left.empty() ? "none" : left};
    progress.advance(1);
  });
  return table;
}

}  // namespace ricochet::studies::best_values
