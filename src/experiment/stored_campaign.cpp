#include "src/experiment/stored_campaign.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "src/core/progress.h"
#include "src/experiment/archived_campaign.h"

namespace ricochet {

namespace {

AllFindings found_by_search(const std::map<std::string, SearchedProblem>& problems) {
  std::vector<std::pair<const SearchedProblem*, Findings*>> searches;
  AllFindings all;
  for (const auto& [name, problem] : problems) searches.emplace_back(&problem, &all[name]);
  Progress progress("searching best values", static_cast<double>(searches.size()));
  tbb::parallel_for(std::size_t{0}, searches.size(), [&](std::size_t k) {
    *searches[k].second = searches[k].first->search();
    progress.advance(1);
  });
  return all;
}

/// The campaign of a plan with the findings of a store; only what it does not have is searched.
Campaign searched_further(const CampaignDescription& description, const Plan& plan,
                          const Catalogue& catalogue) {
  std::map<std::string, SearchedProblem> open = Campaign(plan, catalogue).to_search();
  AllFindings found;
  for (const StoredProblem& problem : description.problems) {
    if (open.erase(problem.name) > 0) found[problem.name] = problem.findings;
  }
  if (!open.empty()) found.merge(found_by_search(open));
  return {plan, catalogue, found};
}

/// Returns true if the solvers have the same names, and those of the suite the same versions, too.
bool differ_in_users_solvers(const CampaignDescription& one, const CampaignDescription& other) {
  const auto lasting = [](const CampaignDescription& description) {
    std::map<std::string, std::string> versions;
    for (const StoredSolver& solver : description.solvers) {
      const bool own = description.made.contains(StoredCampaign::program_key(solver.name));
      versions[solver.name] = own ? "" : solver.version;
    }
    return versions;
  };
  return one.solvers != other.solvers && lasting(one) == lasting(other);
}

/// Returns true if the problems that both have are equal.
bool have_equal_problems(const CampaignDescription& one, const CampaignDescription& other) {
  return std::ranges::all_of(one.problems, [&](const StoredProblem& problem) {
    const auto same = std::ranges::find(other.problems, problem.name, &StoredProblem::name);
    return same == other.problems.end() || *same == problem;
  });
}

/// Continues a store without the runs of the user's solvers that are other ones now.
StoredCampaign renewed(Store found, const Plan& plan, const Catalogue& catalogue,
                       const std::filesystem::path& file, const Provenance& provenance) {
  Campaign campaign = searched_further(found.description(), plan, catalogue);
  CampaignDescription ours = description_of(campaign, provenance);
  for (const auto& [name, value] : found.description().made) {
    ours.made.try_emplace(name, value);
  }
  TakenOver runs(campaign, ours, TakenOver::Versions::any_of_the_suite);
  Store::replace(file, ours, [&](const Store::AddRun& add) { runs.take(found, add); });
  runs.tell_outdated();
  return {std::move(campaign), Store::open(file, Store::For::adding)};
}

StoredCampaign resumed(const Plan& plan, const Catalogue& catalogue,
                       const std::filesystem::path& file, const Provenance& provenance) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(fmt::format("{}: is {}: choose another --out", file.string(), what));
  };
  Store found = Store::open(file, Store::For::reading);
  CampaignDescription theirs = found.description();
  if (theirs.plan != text_of(plan)) refuse("of another plan");
  Campaign campaign = campaign_of(theirs, plan, catalogue);
  const CampaignDescription ours = description_of(campaign, provenance);
  const bool same_program = theirs.program == ours.program;
  theirs.program = ours.program;
  if (differ_in_users_solvers(theirs, ours) && have_equal_problems(ours, theirs)) {
    if (!same_program) refuse("of a solver that has changed, and made by another program");
    return renewed(std::move(found), plan, catalogue, file, provenance);
  }
  theirs.made = ours.made;
  const bool whole = found.size() == campaign.runs();
  if (theirs != ours || (!whole && !same_program)) {
    refuse(same_program ? "of other problems or solvers" : "made by another program");
  }
  if (!whole) found = Store::open(file, Store::For::adding);
  return {std::move(campaign), std::move(found)};
}

}  // namespace

std::string text_of(const Capabilities& capabilities) {
  using Constraints = Capabilities::Constraints;
  std::string text = "constraints ";
  text += capabilities.constraints == Constraints::none           ? "none"
          : capabilities.constraints == Constraints::inequalities ? "inequalities"
                                                                  : "all";
  if (capabilities.derivatives == Capabilities::Order::gradient) text += ", needs derivatives";
  if (capabilities.needs_residuals) text += ", needs residuals";
  return text;
}

Capabilities capabilities_from(const std::string& text) {
  using Constraints = Capabilities::Constraints;
  const auto has = [&](const char* words) { return text.find(words) != std::string::npos; };
  Capabilities capabilities;
  capabilities.constraints = has("inequalities")       ? Constraints::inequalities
                             : has("constraints none") ? Constraints::none
                                                       : Constraints::all;
  if (has("derivatives")) capabilities.derivatives = Capabilities::Order::gradient;
  capabilities.needs_residuals = has("residuals");
  return capabilities;
}

void TakenOver::take(const Store& store, const Store::AddRun& add) {
  const CampaignDescription& theirs = store.description();
  const auto hashes = theirs.hashes();
  std::set<std::string> problems, solvers;
  for (const StoredProblem& problem : ours_.problems) {
    const auto hash = hashes.find(problem.name);
    if (hash != hashes.end() && hash->second == problem.hash) problems.insert(problem.name);
  }
  for (const StoredSolver& solver : ours_.solvers) {
    const bool of_the_suite = !campaign_.own_texts().contains(solver.name);
    if ((of_the_suite && versions_ == Versions::any_of_the_suite) ||
        std::ranges::find(theirs.solvers, solver) != theirs.solvers.end()) {
      solvers.insert(solver.name);
    }
  }
  store.each([&](const StoredRun& run) {
    if (!campaign_.has(run.key) || !problems.contains(run.key.cell.problem)) return;
    if (const std::string wrong = contradiction(campaign_, run); !wrong.empty()) {
      throw InputError(fmt::format("run {} of a store to take over: {}", run.number, wrong));
    }
    if (!solvers.contains(run.key.cell.solver)) {
      outdated_.insert(run.key);
    } else if (taken_.insert(run.key).second) {
      add(run.key, run.record);
    }
  });
}

void TakenOver::tell_outdated() const {
  std::set<std::string> solvers;
  int runs = 0;
  for (const RunKey& key : outdated_) {
    if (taken_.contains(key)) continue;
    solvers.insert(key.cell.solver);
    ++runs;
  }
  if (runs == 0) return;
  Progress::announce(fmt::format("{} changed since these runs: {} run{} repeated",
                                 fmt::join(solvers, ", "), runs, runs == 1 ? " is" : "s are"));
}

CampaignDescription description_of(const Campaign& campaign, const Provenance& provenance) {
  CampaignDescription description = campaign.description();
  description.program = provenance.program;
  description.made = provenance.made;
  for (const auto& [name, text] : campaign.own_texts()) {
    description.made[StoredCampaign::program_key(name)] = text;
    const auto solver = std::ranges::find(campaign.solvers(), name, &Solver::name);
    if (solver == campaign.solvers().end()) continue;  // it takes none of the problems
    description.made[StoredCampaign::capabilities_key(name)] = text_of(solver->capabilities);
  }
  return description;
}

Campaign searched_campaign(const Plan& plan, const Catalogue& catalogue,
                           const std::function<void(const Campaign&)>& planned) {
  Campaign campaign(plan, catalogue);
  if (planned) planned(campaign);
  if (campaign.to_search().empty()) return campaign;
  return {plan, catalogue, found_by_search(campaign.to_search())};
}

Campaign campaign_of(const CampaignDescription& description, const Plan& plan,
                     const Catalogue& catalogue) {
  Campaign planned(plan, catalogue);
  if (planned.to_search().empty()) return planned;
  AllFindings found;
  for (const auto& [name, problem] : planned.to_search()) found[name];  // no feasible point
  for (const StoredProblem& problem : description.problems) {
    const auto place = found.find(problem.name);
    if (place != found.end()) place->second = problem.findings;
  }
  return {plan, catalogue, found};
}

StoredCampaign stored_campaign(const Plan& plan, const Catalogue& catalogue,
                               const std::filesystem::path& file, const Provenance& provenance,
                               const std::function<void(const Campaign&)>& planned) {
  if (std::filesystem::exists(file)) return resumed(plan, catalogue, file, provenance);
  Campaign campaign = searched_campaign(plan, catalogue, planned);
  Store store = Store::create(file, description_of(campaign, provenance));
  return {std::move(campaign), std::move(store)};
}

}  // namespace ricochet
