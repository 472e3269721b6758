#include "src/experiment/archived_campaign.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "ricochet/error.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/experiment/archive.h"

namespace ricochet {

namespace {

namespace fs = std::filesystem;

const Solver* find(const Catalogue& catalogue, const std::string& name) {
  const auto found = std::ranges::find(catalogue.solvers, name, &Solver::name);
  return found == catalogue.solvers.end() ? nullptr : &*found;
}

/// Whether the solver is one of the catalogue, or of the plan with options of its own.
bool can_be_made(const std::string& solver, const Plan& plan, const Catalogue& catalogue) {
  const auto varied = std::ranges::find(plan.solvers, solver, &VariedSolver::name);
  return find(catalogue, varied == plan.solvers.end() ? solver : varied->of) != nullptr;
}

/// Throws InputError if a problem of the campaign is another one than the archive's, or is
/// described otherwise.
void check_problems(const CampaignDescription& archive, const CampaignDescription& campaign) {
  auto hashes = archive.hashes();
  std::vector<std::string> others;
  for (const StoredProblem& problem : campaign.problems) {
    if (hashes[problem.name] != problem.hash) others.push_back(problem.name);
  }
  for (const StoredProblem& problem : archive.problems) {
    const std::string wrong = contradiction(campaign, problem);
    if (!wrong.empty()) throw InputError(wrong);
  }
  if (others.empty()) return;
  constexpr std::size_t named = 5;
  const std::size_t all = others.size();
  others.resize(std::min(all, named));
  throw InputError(fmt::format(
      "the archive has runs on other problems: the hashes of {} of {} differ: {}{}", all,
      campaign.problems.size(), fmt::join(others, ", "), all > named ? ", ..." : ""));
}

/// The first key of what is said of other stores' runs.
constexpr const char* taken_over = "runs taken over from ";

/// The program that made a store, as it says.
std::string made_by(const CampaignDescription& description) {
  const auto version = description.program.find("version");
  if (version == description.program.end()) return "an unknown program";
  return version->second.substr(0, version->second.find('\n'));
}

template <class Entry>
bool has(const std::vector<Entry>& entries, const Entry& entry) {
  return std::ranges::find(entries, entry) != entries.end();
}

/// Leaves only the archive's problems that fit the patterns, and the parts that have some.
void keep_problems(Plan& plan, const CampaignDescription& archive,
                   const std::vector<std::string>& patterns) {
  std::vector<std::string> names;
  for (const StoredProblem& problem : archive.problems) names.push_back(problem.name);
  for (const std::string& pattern : patterns) require_fit({pattern}, names, "--problems");
  for (PlanPart& part : plan.parts) {
    std::vector<std::string> kept;
    for (const StoredProblem& problem : archive.problems) {
      const bool asked = fits_any(problem.name, part.problems) &&
                         part.takes(problem.variables, problem.constraints);
      if (asked && fits_any(problem.name, patterns)) kept.push_back(problem.name);
    }
    part.problems = std::move(kept);
  }
  std::erase_if(plan.parts, [](const PlanPart& part) { return part.problems.empty(); });
}

/// Adds the solvers of a part to those of another, as far as no pattern fits them.
void add_solvers(const PlanPart& from, PlanPart& to) {
  for (const std::string& solver : from.solvers) {
    if (!has(to.solvers, solver) && !fits_any(solver, to.solvers)) to.solvers.push_back(solver);
  }
}

}  // namespace

Plan plan_against(const CampaignDescription& archive, const std::vector<std::string>& own_solvers,
                  const Catalogue& catalogue, const std::vector<std::string>& problems) {
  Plan plan = plan_from(archive.plan, "the archive's plan");
  plan.name = "compare against " + plan.name;
  if (!problems.empty()) keep_problems(plan, archive, problems);
  for (PlanPart& part : plan.parts) {
    std::vector<std::string> solvers;
    for (const StoredSolver& solver : archive.solvers) {
      if (fits_any(solver.name, part.solvers) && can_be_made(solver.name, plan, catalogue)) {
        solvers.push_back(solver.name);
      }
    }
    solvers.insert(solvers.end(), own_solvers.begin(), own_solvers.end());
    part.solvers = std::move(solvers);
  }
  return plan;
}

ChangedSolvers changed_solvers(const CampaignDescription& archive, const Catalogue& catalogue) {
  ChangedSolvers changes;
  for (const StoredSolver& solver : archive.solvers) {
    const Solver* here = find(catalogue, solver.name);
    if (here == nullptr) {
      changes.missing.push_back(solver.name);
    } else if (here->version != solver.version) {
      changes.changed.push_back(
          fmt::format("{} ({}, here {})", solver.name, solver.version, here->version));
    }
  }
  return changes;
}

void start_against(const Store& archive, const fs::path& archive_file, const Campaign& campaign,
                   const Provenance& provenance, const fs::path& file) {
  CampaignDescription description = description_of(campaign, provenance);
  check_problems(archive.description(), description);
  mark_archived(description);
  description.made[taken_over + archive_file.filename().string()] = made_by(archive.description());
  TakenOver runs(campaign, description, TakenOver::Versions::any_of_the_suite);
  Store::write(file, description, [&](const Store::AddRun& add) { runs.take(archive, add); });
  runs.tell_outdated();
}

void start_from(const std::vector<fs::path>& earlier, const Campaign& campaign,
                const Provenance& provenance, const fs::path& file) {
  CampaignDescription description = description_of(campaign, provenance);
  std::vector<Store> stores;
  for (const fs::path& place : earlier) {
    stores.push_back(Store::open(place, Store::For::reading));
    const CampaignDescription& theirs = stores.back().description();
    if (is_archived(theirs)) mark_archived(description);
    description.made[taken_over + place.string()] = made_by(theirs);
  }
  TakenOver runs(campaign, description);
  Store::write(file, description, [&](const Store::AddRun& add) {
    for (const Store& store : stores) runs.take(store, add);
  });
  runs.tell_outdated();
}

std::string foreign_runs_of(const CampaignDescription& description) {
  std::vector<std::string> sentences;
  for (const auto& [name, value] : description.made) {
    if (!name.starts_with(taken_over)) continue;
    sentences.push_back(fmt::format("Some {}, made by {}; they were not repeated.", name, value));
  }
  const auto joined = description.made.find("joined");
  const auto verified = description.made.find("verified");
  if (joined != description.made.end()) {
    sentences.push_back(fmt::format("The runs of {} were joined.", joined->second));
  }
  if (verified != description.made.end()) {
    sentences.push_back(fmt::format("Of these runs, {}.", verified->second));
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

CampaignDescription united(const CampaignDescription& first, const CampaignDescription& second) {
  check_problems(first, second);
  CampaignDescription all = first;
  Plan plan = plan_from(first.plan, "the first plan");
  const Plan other = plan_from(second.plan, "the second plan");
  if (plan.parts.size() != other.parts.size()) {
    throw InputError("the plans differ in more than their solvers");
  }
  for (std::size_t k = 0; k < plan.parts.size(); ++k) add_solvers(other.parts[k], plan.parts[k]);
  all.plan = text_of(plan);
  for (const StoredSolver& solver : second.solvers) {
    const auto known = std::ranges::find(all.solvers, solver.name, &StoredSolver::name);
    if (known == all.solvers.end()) {
      all.solvers.push_back(solver);
    } else if (known->version != solver.version) {
      throw InputError(fmt::format("the first has {} in version {}, this in version {}",
                                   solver.name, known->version, solver.version));
    } else if (known->content != solver.content) {
      throw InputError(fmt::format(
          "the first has runs of another {0}, made of other files under the same name and version: "
          "repeat the runs of one, or give it another name",
          solver.name));
    }
  }
  all.made.insert(second.made.begin(), second.made.end());
  return all;
}

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
    std::string wrong = wrong_length("best_x", record.trace.back().x, problem.dimension());
    if (!wrong.empty()) return wrong;
  }
  if (record.returned) {
    std::string wrong = wrong_length("returned_x", record.returned->x, problem.dimension());
    if (!wrong.empty()) return wrong;
    std::string beyond = out_of_reach(problem, record.returned->true_values);
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
