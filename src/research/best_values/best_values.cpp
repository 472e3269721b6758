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
#include <mutex>
#include <optional>

#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/campaign/progress.h"
#include "src/core/error.h"
#include "src/core/interruption.h"
#include "src/core/near_names.h"
#include "src/core/patterns.h"
#include "src/core/text_file.h"
#include "src/core/verdict.h"

namespace ricochet::studies::best_values {
namespace {

using namespace carrier_track;

BestValues read_if_there(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {default_reading().name, {}};
  std::ifstream stream(file, std::ios::binary);
  return parse_best_values({std::istreambuf_iterator<char>(stream), {}}, file.string());
}

/// What the entry is worth today; infinite where it is no feasible point of the problem.
double worth(const Problem& problem, const BestKnown& best) {
  if (best.point.size() != problem.dimension()) return std::numeric_limits<double>::infinity();
  const Truth truth = truth_at(problem, best.point);
  return truth.violation > 0 ? std::numeric_limits<double>::infinity() : truth.objective;
}

/// The values known so far, each as it is worth today.
BestValues known_values(const std::vector<Question>& questions, const std::filesystem::path& file) {
  BestValues known{default_reading().name, {}};
  const BestValues in_file = read_if_there(file);
  for (const Question& question : questions) {
    const Problem& problem = question.stated;
    std::vector<BestKnown> candidates;
    if (problem.best_point) candidates.push_back({0, *problem.best_point, problem.provenance});
    const auto found = in_file.of.find(question.name());
    if (found != in_file.of.end()) candidates.push_back(found->second);
    for (BestKnown& best : candidates) {
      best.value = worth(problem, best);
      const auto before = known.of.find(question.name());
      const double so_far =
          before == known.of.end() ? std::numeric_limits<double>::infinity() : before->second.value;
      if (best.value < so_far) known.of.insert_or_assign(question.name(), best);
    }
  }
  return known;
}

/// What a call that was stopped has finished: what comes out again at its point. What was changed
/// since is looked for anew.
BestValues read_part(const std::vector<Question>& questions, const std::filesystem::path& part) {
  BestValues finished = read_if_there(part);
  if (finished.reading != default_reading().name) {
    throw InputError(fmt::format("{}: must be of the reading {}, and is of {}: move it away",
                                 part.string(), default_reading().name, finished.reading));
  }
  for (const Question& question : questions) {
    const auto found = finished.of.find(question.name());
    if (found == finished.of.end()) continue;
    if (found->second.value != worth(question.stated, found->second)) finished.of.erase(found);
  }
  return finished;
}

std::string nothing_matches(const std::vector<Question>& questions, const std::string& pattern) {
  std::vector<std::string> names;
  for (const Question& question : questions) names.push_back(question.name());
  const std::vector<std::string> near = near_names(pattern, names);
  return fmt::format("--questions {}: none of the paper's cases matches; {}", pattern,
                     near.empty() ? "see ricochet list questions" : what_instead(pattern, names));
}

/// The work of a question, to show progress: about proportional to the time. A scan by steps of
/// 1e-3 takes as long as a search over two variables.
double work_of(const Question& question) {
  const double n = static_cast<double>(question.stated.dimension());
  return n == 1 ? 6e-3 * question.cost / question.scan_step : n * n + 5;
}

}  // namespace

bool matches(const std::string& name, const std::string& pattern) {
  if (pattern.find_first_of("*?[") == std::string::npos) {
    return name.find(pattern) != std::string::npos;
  }
  return fits(name, pattern);
}

Outcome find_best_values(const std::vector<Question>& questions, const Plan& plan,
                         const std::filesystem::path& file) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<const Question*> wanted;
  double work = 0;
  for (const Question& question : questions) {
    if (!matches(question.name(), plan.questions)) continue;
    wanted.push_back(&question);
    work += work_of(question);
  }
  if (wanted.empty()) {
    throw InputError(nothing_matches(questions, plan.questions));
  }
  const std::filesystem::path part = file.string() + ".part";
  BestValues known = known_values(questions, file);
  BestValues finished = read_part(questions, part);
  const AtInterruption kept([] {}, fmt::format("finished searches are kept in {}: the same command "
                                               "goes on",
                                               part.string()));
  // The longest first, so that no core waits for another at the end.
  std::stable_sort(wanted.begin(), wanted.end(),
                   [](const Question* a, const Question* b) { return work_of(*a) > work_of(*b); });
  std::mutex mutex;
  {
    Progress progress("looking for best values", work);
    const auto look = [&](std::size_t i) {
      const Question& question = *wanted[i];
      {
        const std::lock_guard lock(mutex);
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        if (finished.of.contains(question.name()) || passed.count() > plan.seconds) {
          progress.advance(work_of(question));
          return;
        }
      }
      // Alone: a thread that waits within a run must not begin another, which would disturb what
      // the solvers' libraries keep for each thread.
      BestKnown best =
          tbb::this_task_arena::isolate([&] { return best_of(question, plan.effort); });
      const std::lock_guard lock(mutex);
      finished.of.insert_or_assign(question.name(), std::move(best));
      write_text_file(part, write_best_values(finished));
      progress.advance(work_of(question));
    };
    tbb::parallel_for(std::size_t{0}, wanted.size(), look, tbb::simple_partitioner());
  }
  Outcome outcome;
  outcome.wanted = wanted.size();
  for (const Question* question : wanted) {
    const auto found = finished.of.find(question->name());
    if (found == finished.of.end()) continue;
    ++outcome.finished;
    const BestKnown& best = found->second;
    const auto before = known.of.find(question->name());
    if (std::isfinite(best.value) &&
        (before == known.of.end() || best.value < before->second.value)) {
      ++outcome.improved;
      known.of.insert_or_assign(question->name(), best);
    }
    if (!known.of.contains(question->name())) ++outcome.infeasible;
  }
  if (outcome.finished == outcome.wanted) {
    write_text_file(file, write_best_values(known));
    for (const Question* question : wanted) finished.of.erase(question->name());
    if (finished.of.empty()) {
      std::filesystem::remove(part);
    } else {  // of a call that wanted others
      write_text_file(part, write_best_values(finished));
    }
  }
  return outcome;
}

}  // namespace ricochet::studies::best_values
