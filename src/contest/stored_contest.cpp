#include "src/contest/stored_contest.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "src/core/error.h"

namespace ricochet::contest {

std::vector<StoredStanding> stored_standings(const Campaign& campaign, const Store& store,
                                             const std::function<void(const StoredRun&)>& also) {
  std::map<Cell, std::size_t> places;
  std::vector<StoredStanding> all;
  for (const PlannedCell& planned : campaign.cells()) {
    places[planned.cell] = all.size();
    all.push_back({&planned, {}});
  }
  std::int64_t there = 0;
  std::optional<Cell> cell;  // whose runs are read
  StoredStanding* standing = nullptr;
  std::vector<Outcome> outcomes;
  const auto end_cell = [&] {
    if (standing != nullptr) standing->outcomes = std::exchange(outcomes, {});
  };
  store.each([&](const StoredRun& run) {
    also(run);
    if (cell != run.key.cell) {
      end_cell();
      cell = run.key.cell;
      const auto place = places.find(*cell);
      standing = place == places.end() ? nullptr : &all[place->second];
      if (standing == nullptr) return;
      outcomes.reserve(static_cast<std::size_t>(standing->cell->instances) *
                       static_cast<std::size_t>(standing->cell->seeds));
    }
    if (standing == nullptr) return;
    const Question& question = campaign.questions()[standing->cell->question];
    outcomes.push_back(outcome_of(run.record, question.stated, question.tolerance));
    ++there;
  });
  end_cell();
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
    Standing standing{question->second, cell.cell.solver, cell.form,
                      static_cast<std::size_t>(budget - part.budgets.begin()),
                      stored.outcomes.every(static_cast<std::size_t>(cell.seeds),
                                            static_cast<std::size_t>(conditions.run),
                                            static_cast<std::size_t>(part.instances))};
    contest.standings.push_back(std::move(standing));
  }
  for (std::size_t s = 0; s < takes_part.size(); ++s) {
    if (takes_part[s]) contest.plan.solvers.push_back(campaign.solvers()[s]);
  }
  return contest;
}

}  // namespace ricochet::contest
