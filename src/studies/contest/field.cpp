#include "src/studies/contest/field.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "src/statistics/bootstrap.h"
#include "src/statistics/shifted_geometric_mean.h"

namespace ricochet::studies::contest {
namespace {

/// Question, then standing.
using ByQuestion = std::map<std::size_t, const StoredStanding*>;

/// What makes one form of a solver better than another, the larger the better.
std::tuple<std::size_t, double, double> merit(const Campaign& campaign, const ByQuestion& taken) {
  double share = 0;
  std::vector<double> evaluations;
  for (const auto& [question, standing] : taken) {
    const OnQuestion one = on_question(campaign, *standing);
    share += one.share;
    evaluations.push_back(one.evaluations);
  }
  return {taken.size(), share, -mean_cost(evaluations)};
}

}  // namespace

double evaluations_of(const Outcome& outcome) {
  return static_cast<double>(outcome.verdict.evaluations_to_solve.value_or(outcome.evaluations));
}

double seconds_of(const Outcome& outcome) {
  return outcome.verdict.seconds_to_solve.value_or(outcome.seconds);
}

OnQuestion on_question(const Campaign& campaign, const StoredStanding& standing) {
  OnQuestion result{0, 0, 0, 0};
  std::vector<double> regrets;
  for (const Outcome& outcome : standing.outcomes) {
    result.evaluations += evaluations_of(outcome);
    result.seconds += seconds_of(outcome);
    result.share += outcome.verdict.solved ? 1 : 0;
    regrets.push_back(outcome.verdict.regret.value_or(std::numeric_limits<double>::infinity()));
  }
  const auto runs = static_cast<double>(standing.outcomes.size());
  const auto& stated = campaign.questions()[standing.cell->question].stated;
  result.evaluations =
      std::max(result.evaluations / runs, 1.0) / static_cast<double>(stated.dimension());
  result.seconds /= runs;
  result.share /= runs;
  result.regret = quantile(std::move(regrets), 0.5);
  return result;
}

double mean_cost(const std::vector<double>& costs) {
  return shifted_geometric_mean(costs, 0, 1e-6);
}

std::vector<Field> fields_of(const Campaign& campaign, const std::vector<StoredStanding>& standings,
                             const std::vector<ReportedPart>& parts) {
  using Key = std::tuple<std::size_t, std::string, std::int64_t>;
  std::map<Key, std::map<std::string, std::map<std::string, ByQuestion>>> all;
  for (const StoredStanding& standing : standings) {
    const PlannedCell& cell = *standing.cell;
    const bool plain = cell.cell.feature == "plain" && cell.cell.gradient_price == "n";
    if (!plain || standing.outcomes.empty()) continue;
    const Key key{cell.parts.front(), campaign.family_of(cell.question), cell.cell.budget};
    all[key][cell.cell.solver][cell.cell.form][cell.question] = &standing;
  }
  const auto largest = largest_budgets(standings);
  std::vector<Field> fields;
  for (const auto& [key, solvers] : all) {
    Field field{std::get<1>(key), std::get<0>(key), std::get<2>(key), true, {}, {}, {}};
    std::map<std::size_t, bool> asked;
    for (const auto& [solver, forms] : solvers) {
      for (const auto& [form, taken] : forms) {
        for (const auto& [question, standing] : taken) asked[question] = true;
      }
    }
    for (const auto& [question, yes] : asked) {
      field.questions.push_back(question);
      field.largest = field.largest && largest.at(question) == field.budget;
    }
    for (const auto& [solver, forms] : solvers) {
      const auto best =
          std::max_element(forms.begin(), forms.end(), [&](const auto& a, const auto& b) {
            return merit(campaign, a.second) < merit(campaign, b.second);
          });
      Entrant entrant{solver, best->first, {}};
      for (const auto& [question, standing] : best->second) entrant.standings.push_back(standing);
      const bool takes_all = entrant.standings.size() == field.questions.size();
      (takes_all ? field.entrants : field.partial).push_back(std::move(entrant));
    }
    const auto part = std::find_if(parts.begin(), parts.end(), [&](const ReportedPart& reported) {
      return reported.part == field.part;
    });
    if (part != parts.end()) {
      if (part->asked_again.contains(field.family)) continue;
      field.family = part->families.at(field.family);
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

Field joint_field(const Campaign& campaign, const std::vector<Field>& fields) {
  Field joint{"all", 0, 0, true, {}, {}, {}};
  std::size_t joined = 0;
  std::map<std::string, Entrant> entrants;
  for (const Field& field : fields) {
    if (!field.largest || 2 * field.entrants.size() < campaign.solvers().size()) continue;
    ++joined;
    joint.questions.insert(joint.questions.end(), field.questions.begin(), field.questions.end());
    for (const Entrant& entrant : field.entrants) {
      Entrant& mine = entrants[entrant.solver];
      mine.solver = entrant.solver;
      mine.form = "the best of each";
      mine.standings.insert(mine.standings.end(), entrant.standings.begin(),
                            entrant.standings.end());
    }
  }
  if (joined < 2) return {};
  for (auto& [solver, entrant] : entrants) {
    if (entrant.standings.size() == joint.questions.size()) {
      joint.entrants.push_back(std::move(entrant));
    }
  }
  return joint;
}

}  // namespace ricochet::studies::contest
