#include "src/research/best_values/best_values.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>

#include "problems/carrier_track/problems/default_machine.h"
#include "ricochet/error.h"
#include "ricochet/verdict.h"
#include "src/core/interruption.h"
#include "src/core/near_names.h"
#include "src/core/patterns.h"
#include "src/core/progress.h"
#include "src/core/text_file.h"
#include "src/research/best_values/known_values.h"

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

}  // namespace ricochet::studies::best_values
