#include "src/cli/recorded_campaign.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include "src/benchmark/experiment/campaign/archived_campaign.h"
#include "src/research/suite/catalogue.h"

namespace ricochet::cli {
namespace {

using RecordedSolvers = std::map<std::string, Solver>;  ///< by the plan's text for each

/// The user's solvers of a store, able to do what they said of themselves; where an earlier version
/// made the store, all that they could say.
RecordedSolvers recorded_solvers_of(const CampaignDescription& description) {
  RecordedSolvers own;
  for (const StoredSolver& stored : description.solvers) {
    const auto text = description.made.find(StoredCampaign::program_key(stored.name));
    if (text == description.made.end()) continue;
    Solver& solver = own[text->second];
    solver.name = stored.name;
    solver.version = stored.version;
    solver.content = stored.content;
    const auto taken = description.made.find(StoredCampaign::capabilities_key(stored.name));
    if (taken != description.made.end())
      solver.capabilities = capabilities_from(taken->second);
    else
      solver.capabilities.constraints = Capabilities::Constraints::all;
    solver.solve = [](Evaluator&, const Vector&, Random&) -> SolverTermination {
      throw std::logic_error("a recorded solver was started");
    };
  }
  return own;
}

/// The plan of a store, with those of its user's solvers that were recorded.
Plan plan_with(const RecordedSolvers& own, const CampaignDescription& description,
               const Catalogue& catalogue) {
  const Plan stored = plan_from(description.plan, "the store's plan");
  Plan plan = plan_against(description, {}, catalogue);
  for (std::size_t part = 0; part < plan.parts.size(); ++part) {
    for (const std::string& text : stored.parts[part].solvers) {
      if (own.contains(text)) plan.parts[part].solvers.push_back(text);
    }
  }
  return plan;
}

/// What the solver of this name takes, by the problems that it has runs on.
Capabilities capabilities_of(const std::string& solver, const Campaign& most,
                             const std::set<Cell>& run) {
  Capabilities shown;
  bool all_have_derivatives = true, all_have_residuals = true;
  for (const PlannedCell& cell : most.cells()) {
    if (cell.cell.solver != solver || !run.contains(cell.cell)) continue;
    Problem problem = most.problems()[cell.problem].formulated(cell.formulation);
    if (cell.perturbation) problem = cell.perturbation->perturbed(problem, 0);
    if (problem.constraints > 0) {
      shown.constraints = std::max(
          shown.constraints, problem.equalities > 0 ? Capabilities::Constraints::all
                                                    : Capabilities::Constraints::inequalities);
    }
    all_have_derivatives = all_have_derivatives && problem.differentiate;
    all_have_residuals = all_have_residuals && problem.residuals;
  }
  if (all_have_derivatives) shown.derivatives = Capabilities::Order::gradient;
  shown.needs_residuals = all_have_residuals;
  return shown;
}

}  // namespace

Campaign recorded_campaign(const Store& store) {
  const CampaignDescription& description = store.description();
  RecordedSolvers own = recorded_solvers_of(description);
  Catalogue catalogue = studies::whole_catalogue();
  catalogue.own_solver = [&own](const std::string& text) -> std::optional<Solver> {
    const auto place = own.find(text);
    return place == own.end() ? std::nullopt : std::optional(place->second);
  };
  const Plan plan = plan_with(own, description, catalogue);
  Campaign campaign = campaign_of(description, plan, catalogue);
  const auto is_recorded = [&](const auto& text_and_solver) {
    const std::string& name = text_and_solver.second.name;
    return description.made.contains(StoredCampaign::capabilities_key(name));
  };
  if (std::ranges::all_of(own, is_recorded)) return campaign;
  std::set<Cell> run;
  for (const RunKey& key : store.keys()) run.insert(key.cell);
  for (auto& entry : own) {
    if (is_recorded(entry)) continue;
    entry.second.capabilities = capabilities_of(entry.second.name, campaign, run);
  }
  return campaign_of(description, plan, catalogue);
}

}  // namespace ricochet::cli
