#include "src/studies/contest/factor_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "problems/carrier_track/scene/enum_names.h"
#include "src/contest/rating.h"
#include "src/statistics/factorial_effects.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

constexpr std::size_t shown_competitors = 5;

/// What a competitor did on one question.
struct Result {
  const Question* question;
  double solved = 0, cost = 0, accuracy = 0;
};

Result result_of(const Question& question, const std::vector<Outcome>& outcomes) {
  Result result{&question};
  const std::vector<double> targets = targets_of(question);
  for (const Outcome& outcome : outcomes) {
    const Verdict& verdict = outcome.verdict;
    result.solved += verdict.solved ? 1 : 0;
    result.cost += std::log10(static_cast<double>(
        std::max<std::int64_t>(1, verdict.evaluations_to_solve.value_or(outcome.evaluations))));
    if (!verdict.regret) continue;
    for (const double target : targets) {
      result.accuracy += *verdict.regret <= target ? 1 / static_cast<double>(targets.size()) : 0;
    }
  }
  const auto runs = static_cast<double>(outcomes.size());
  result.solved /= runs;
  result.cost /= runs;
  result.accuracy /= runs;
  return result;
}

using Competitor = std::pair<std::string, std::string>;  // solver, form
using ByCompetitor = std::map<Competitor, std::vector<Result>>;

double mean_solved(const std::vector<Result>& results) {
  double sum = 0;
  for (const Result& result : results) sum += result.solved;
  return sum / static_cast<double>(results.size());
}

/// The factors of a family's machines that have several levels, with their levels; none where there
/// are no more machines than such factors, which cannot tell one from another.
std::map<std::string, std::vector<double>> factors_of(const ByCompetitor& competitors) {
  std::map<std::string, std::set<double>> found;
  std::set<std::string> machines;
  for (const auto& [competitor, results] : competitors) {
    for (const Result& result : results) {
      machines.insert(result.question->machine);
      for (const auto& [name, value] : result.question->factors) found[name].insert(value);
    }
  }
  std::map<std::string, std::vector<double>> factors;
  for (const auto& [name, levels] : found) {
    if (levels.size() > 1) factors[name] = {levels.begin(), levels.end()};
  }
  if (machines.size() <= factors.size()) factors.clear();
  return factors;
}

std::size_t level_of(const std::vector<double>& levels, double value) {
  return static_cast<std::size_t>(std::find(levels.begin(), levels.end(), value) - levels.begin());
}

/// The competitors of a family, most solved first.
std::vector<const ByCompetitor::value_type*> best_first(const ByCompetitor& competitors) {
  std::vector<const ByCompetitor::value_type*> order;
  for (const auto& competitor : competitors) order.push_back(&competitor);
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return mean_solved(a->second) > mean_solved(b->second);
  });
  return order;
}

struct Measure {
  const char* name;
  double Result::*value;
};
constexpr Measure measures[] = {{"share solved", &Result::solved},
                                {"log10 of evaluations", &Result::cost},
                                {"targets reached", &Result::accuracy}};

/// Adds the effects that are sure, and the mean; how many are not is added to `unsure`.
void add_effects(Json& rows, std::size_t& unsure, const std::string& family,
                 const ByCompetitor::value_type& competitor,
                 const std::map<std::string, std::vector<double>>& factors) {
  std::vector<std::string> names;
  std::vector<std::size_t> sizes;
  for (const auto& [name, levels] : factors) {
    names.push_back(name);
    sizes.push_back(levels.size());
  }
  std::map<std::string, std::size_t> units;
  for (const Measure& measure : measures) {
    std::vector<Response> responses;
    for (const Result& result : competitor.second) {
      Response response{{},
                        units.try_emplace(result.question->machine, units.size()).first->second,
                        result.*measure.value};
      for (const auto& [name, levels] : factors) {
        response.levels.push_back(level_of(levels, result.question->factors.at(name)));
      }
      responses.push_back(std::move(response));
    }
    std::vector<FactorialEffect> effects;
    try {
      effects = factorial_effects(responses, sizes);
    } catch (const std::invalid_argument&) {
      return;  // too few machines to tell
    }
    for (const FactorialEffect& effect : effects) {
      const bool sure = effect.interval.lower > 0 || effect.interval.upper < 0;
      if (!sure && !effect.factors.empty()) {
        ++unsure;
        continue;
      }
      std::string of;
      for (std::size_t f = 0; f < effect.factors.size(); ++f) {
        const std::string& name = names[effect.factors[f]];
        of += fmt::format("{}{} {}", f == 0 ? "" : ", ", name,
                          level_name(name, factors.at(name)[effect.levels[f]]));
      }
      rows.push_back(
          {{"family", family},
           {"competitor", contest::competitor(competitor.first.first, competitor.first.second)},
           {"measure", measure.name},
           {"of", of.empty() ? "mean" : of},
           {"order", effect.factors.size()},
           {"effect", effect.effect},
           {"lower", effect.interval.lower},
           {"upper", effect.interval.upper}});
    }
  }
}

void add_turns(Json& rows, const std::string& family, const ByCompetitor& competitors,
               const std::map<std::string, std::vector<double>>& factors) {
  for (const auto& [name, levels] : factors) {
    for (const double level : levels) {
      ByCompetitor here;
      for (const auto& [competitor, results] : competitors) {
        for (const Result& result : results) {
          if (result.question->factors.at(name) == level) here[competitor].push_back(result);
        }
      }
      const auto order = best_first(here);
      const auto overall = best_first(competitors);
      const auto name_of = [](const ByCompetitor::value_type* c) {
        return competitor(c->first.first, c->first.second);
      };
      // Who is best over all machines may not take those of this level.
      const auto again = here.find(overall.front()->first);
      rows.push_back(
          {{"family", family},
           {"factor", name},
           {"level", level},
           {"level_name", level_name(name, level)},
           {"leader", name_of(order.front())},
           {"share", mean_solved(order.front()->second)},
           {"overall", name_of(overall.front())},
           {"share_of_overall", again == here.end() ? Json() : Json(mean_solved(again->second))},
           {"same", order.front()->first == overall.front()->first}});
    }
  }
}

/// By family, what each competitor did on the questions of a part that are asked of machines.
std::map<std::string, ByCompetitor> competitors_of(const Campaign& campaign,
                                                   const std::vector<StoredStanding>& standings,
                                                   const ReportedPart& part) {
  const std::int64_t budget = campaign.plan().parts[part.part].budgets.back();
  std::map<std::string, ByCompetitor> families;
  for (const StoredStanding& s : standings) {
    const Cell& cell = s.cell->cell;
    const Question& question = campaign.questions()[s.cell->question];
    const auto& asked = s.cell->parts;
    const bool counts = std::find(asked.begin(), asked.end(), part.part) != asked.end() &&
                        !question.factors.empty() && cell.feature == part.usual.feature &&
                        cell.gradient_price == part.usual.gradient_price && cell.budget == budget;
    if (!counts) continue;
    const std::string& family = part.families.at(campaign.family_of(s.cell->question));
    families[family][{cell.solver, cell.form}].push_back(result_of(question, s.outcomes));
  }
  return families;
}

}  // namespace

std::string level_name(const std::string& factor, double level) {
  if (factor != "fidelity") return fmt::format("{}", level);
  using carrier_track::Fidelity;
  return std::string(carrier_track::name_of(carrier_track::fidelity_names(),
                                            static_cast<Fidelity>(std::lround(level))));
}

Json factor_data(const Campaign& campaign, const std::vector<StoredStanding>& standings,
                 const std::vector<ReportedPart>& parts) {
  Json effects = Json::array();
  Json turns = Json::array();
  std::size_t unsure = 0;
  for (const ReportedPart& part : parts) {
    for (const auto& [family, competitors] : competitors_of(campaign, standings, part)) {
      const auto factors = factors_of(competitors);
      if (factors.empty()) continue;
      const auto order = best_first(competitors);
      for (std::size_t k = 0; k < std::min(shown_competitors, order.size()); ++k) {
        add_effects(effects, unsure, family, *order[k], factors);
      }
      add_turns(turns, family, competitors, factors);
    }
  }
  return {{"effects", std::move(effects)}, {"unsure_effects", unsure}, {"turns", std::move(turns)}};
}

}  // namespace ricochet::studies::contest
