#include "src/benchmark/experiment/campaign/known_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "ricochet/error.h"
#include "src/core/warning.h"

namespace ricochet {
namespace {

/// Whether it is proven that no feasible point has a true objective as low as this.
bool is_out_of_reach(const Problem& problem, double objective) {
  if (!problem.best_known || objective >= *problem.best_known - problem.tolerance) return false;
  if (!problem.machine.empty()) {
    // A count, its mean or another measure of counts; or a speed within the box.
    const double bound = problem.maximises ? -problem.upper[0] : 0;
    if (objective < bound - problem.tolerance) return true;
  }
  if (problem.lower_bound && objective < *problem.lower_bound - problem.tolerance) return true;
  return problem.not_excluded && problem.not_excluded(*problem.best_known).empty();
}

std::string wrong_length(const char* name, const Vector& x, Eigen::Index dimension) {
  if (x.size() == 0 || x.size() == dimension) return "";
  return fmt::format("{} has {} coordinates: must be {}", name, x.size(), dimension);
}

std::string out_of_reach(const Problem& problem, const TrueValues& reached) {
  if (reached.violation > 0 || !is_out_of_reach(problem, reached.objective)) return "";
  return fmt::format("its objective is {}: it is proven that none is better than {}",
                     reached.objective, *problem.best_known);
}

}  // namespace

std::string contradiction(const Campaign& campaign, const StoredRun& run) {
  const PlannedCell* const cell = campaign.find(run.key.cell);
  if (cell == nullptr) return "";
  const RunRecord& record = run.record;
  if (record.budget.evaluations != cell->budget.evaluations) {
    return fmt::format("evaluations_allowed is {}: the plan allows {}", record.budget.evaluations,
                       cell->budget.evaluations);
  }
  const Problem& problem = campaign.problems()[cell->problem];
  std::optional<TrueValues> best;
  if (!record.trace.empty()) {
    best = record.trace.back().true_values;
    const std::string wrong = wrong_length("best_x", record.trace.back().x, problem.dimension());
    if (!wrong.empty()) return wrong;
  }
  if (record.returned) {
    const std::string wrong = wrong_length("returned_x", record.returned->x, problem.dimension());
    if (!wrong.empty()) return wrong;
    const std::string beyond = out_of_reach(problem, record.returned->true_values);
    if (!beyond.empty()) return beyond;
  }
  return best ? out_of_reach(problem, *best) : "";
}

std::string contradiction(const CampaignDescription& ours, const StoredProblem& theirs) {
  const auto found = std::ranges::find(ours.problems, theirs.name, &StoredProblem::name);
  if (found == ours.problems.end() || found->hash != theirs.hash || *found == theirs) return "";
  const auto differs = [&](const char* what, const auto& here, const auto& there) {
    return fmt::format("{} of {} is {}: this program knows the problem by its hash, with {}", what,
                       theirs.name, there, here);
  };
  if (found->variables != theirs.variables) {
    return differs("variables", found->variables, theirs.variables);
  }
  if (found->tolerance != theirs.tolerance) {
    return differs("tolerance", found->tolerance, theirs.tolerance);
  }
  if (found->best_known != theirs.best_known) {
    return differs("best_known", found->best_known, theirs.best_known);
  }
  return fmt::format("{} is not described as this program, which knows its hash, describes it",
                     theirs.name);
}

void check_content(const Campaign& campaign, const Store& store, const std::string& file) {
  const CampaignDescription ours = campaign.description();
  for (const StoredProblem& problem : store.description().problems) {
    const std::string wrong = contradiction(ours, problem);
    if (!wrong.empty()) throw InputError(fmt::format("{}: table problem: {}", file, wrong));
  }
  std::vector<std::string> others;
  const auto known = ours.hashes();
  for (const auto& [name, hash] : store.description().hashes()) {
    const auto here = known.find(name);
    if (here != known.end() && here->second != hash) others.push_back(name);
  }
  if (!others.empty()) {
    warn(fmt::format(
        "{}: {} problem{} not this program's, by hash, and no result on {} is checked: {}{}", file,
        others.size(), others.size() == 1 ? " is" : "s are", others.size() == 1 ? "it" : "them",
        others.front(), others.size() > 1 ? ", ..." : ""));
  }
  store.each([&](const StoredRun& run) {
    if (std::ranges::find(others, run.key.cell.problem) != others.end()) return;
    const std::string wrong = contradiction(campaign, run);
    if (wrong.empty()) return;
    throw InputError(fmt::format("{}: table run, row {}: {}", file, run.number, wrong));
  });
}

}  // namespace ricochet
