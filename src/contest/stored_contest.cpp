#include "src/contest/stored_contest.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "src/core/error.h"

namespace ricochet::contest {

std::vector<StoredStanding> stored_standings(const Campaign& campaign, const Store& store) {
  std::map<Cell, std::size_t> places;
  std::vector<StoredStanding> all;
  std::vector<std::int64_t> missing;
  for (const PlannedCell& planned : campaign.cells()) {
    places[planned.cell] = all.size();
    all.push_back({&planned, {}});
    all.back().outcomes.reserve(static_cast<std::size_t>(planned.instances) *
                                static_cast<std::size_t>(planned.seeds));
  }
  store.each([&](const StoredRun& run) {
    const auto place = places.find(run.key.cell);
    if (place == places.end()) return;
    StoredStanding& standing = all[place->second];
    const Question& question = campaign.questions()[standing.cell->question];
    standing.outcomes.push_back(outcome_of(run.record, question.stated, question.tolerance));
  });
  std::int64_t there = 0;
  for (const StoredStanding& standing : all) {
    there += static_cast<std::int64_t>(standing.outcomes.size());
  }
  if (there != campaign.runs()) {
    throw InputError(fmt::format("{} of {} runs are there: the campaign is not at its end", there,
                                 campaign.runs()));
  }
  return all;
}

std::map<std::size_t, std::int64_t> largest_budgets(const std::vector<StoredStanding>& standings) {
  std::map<std::size_t, std::int64_t> largest;
  for (const StoredStanding& s : standings) {
    auto& budget = largest[s.cell->question];
    budget = std::max(budget, s.cell->cell.budget);
  }
  return largest;
}

StoredContest stored_contest(const Campaign& campaign, const std::vector<StoredStanding>& standings,
                             const Conditions& conditions) {
  const PlanPart& part = campaign.plan().parts[conditions.part];
  StoredContest contest;
  contest.plan.widths = part.widths;
  contest.plan.instances = part.instances;
  contest.plan.budgets = part.budgets;
  contest.plan.run = conditions.run;
  contest.plan.limits = campaign.plan().limits;
  std::map<std::size_t, std::size_t> questions;  // of the campaign, to those of the contest
  std::vector<bool> takes_part(campaign.solvers().size());
  for (const StoredStanding& stored : standings) {
    const PlannedCell& cell = *stored.cell;
    const bool asked =
        std::find(cell.parts.begin(), cell.parts.end(), conditions.part) != cell.parts.end() &&
        cell.cell.feature == conditions.feature &&
        cell.cell.gradient_price == conditions.gradient_price && conditions.run < cell.seeds;
    if (!asked) continue;
    const auto [question, fresh] =
        questions.try_emplace(cell.question, contest.plan.questions.size());
    if (fresh) {
      contest.plan.questions.push_back(campaign.questions()[cell.question]);
      contest.families.push_back(campaign.family_of(cell.question));
    }
    takes_part[cell.solver] = true;
    const auto budget = std::find(part.budgets.begin(), part.budgets.end(), cell.cell.budget);
    Standing standing{question->second,
                      cell.cell.solver,
                      cell.form,
                      static_cast<std::size_t>(budget - part.budgets.begin()),
                      {}};
    for (int i = 0; i < part.instances; ++i) {
      standing.outcomes.push_back(
          stored.outcomes[static_cast<std::size_t>(i * cell.seeds + conditions.run)]);
    }
    contest.standings.push_back(std::move(standing));
  }
  for (std::size_t s = 0; s < takes_part.size(); ++s) {
    if (takes_part[s]) contest.plan.solvers.push_back(campaign.solvers()[s]);
  }
  return contest;
}

}  // namespace ricochet::contest
