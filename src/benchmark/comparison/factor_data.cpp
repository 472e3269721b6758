#include "src/benchmark/comparison/factor_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "src/benchmark/comparison/machine_results.h"
#include "src/benchmark/statistics/factorial_effects.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

constexpr std::size_t shown_entries = 5;

std::size_t level_of(const std::vector<double>& levels, double value) {
  return static_cast<std::size_t>(std::find(levels.begin(), levels.end(), value) - levels.begin());
}

bool excludes_zero(double lower, double upper) {
  return lower > 0 || upper < 0;
}

struct Measure {
  const char* name;
  double MachineResult::*value;
};
constexpr Measure measures[] = {{"share solved", &MachineResult::solved},
                                {"log10 of evaluations", &MachineResult::cost},
                                {"targets reached", &MachineResult::accuracy}};

/// Adds the significant effects and the mean to `rows`, the number of effects that are not
/// significant to `unsure`, and all main effects on the share solved to `main`.
void add_effects(Json& rows, std::size_t& unsure, Json& main, const std::string& family,
                 const ByEntry::value_type& entry,
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
    for (const MachineResult& result : entry.second) {
      Response response{{},
                        units.try_emplace(result.problem->machine, units.size()).first->second,
                        result.*measure.value};
      for (const auto& [name, levels] : factors) {
        response.levels.push_back(level_of(levels, result.problem->factors.at(name)));
      }
      responses.push_back(std::move(response));
    }
    std::vector<FactorialEffect> effects;
    try {
      effects = factorial_effects(responses, sizes);
    } catch (const std::invalid_argument&) {
      return;  // too few machines for an estimate
    }
    for (const FactorialEffect& effect : effects) {
      const bool sure = excludes_zero(effect.interval.lower, effect.interval.upper);
      if (measure.value == &MachineResult::solved && effect.factors.size() == 1) {
        main.push_back({{"effect", effect.effect},
                        {"lower", effect.interval.lower},
                        {"upper", effect.interval.upper}});
      }
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
      rows.push_back({{"family", family},
                      {"entry", name_of(entry)},
                      {"measure", measure.name},
                      {"of", of.empty() ? "mean" : of},
                      {"order", effect.factors.size()},
                      {"effect", effect.effect},
                      {"lower", effect.interval.lower},
                      {"upper", effect.interval.upper}});
    }
  }
}

/// The levels of all factors, in the order of their main effects.
Json levels_of(const std::map<std::string, std::vector<double>>& factors) {
  Json all = Json::array();
  for (const auto& [name, levels] : factors) {
    for (const double level : levels) {
      all.push_back({{"level", fmt::format("{} {}", name, level_name(name, level))}});
    }
  }
  return all;
}

/// The largest significant effect of a level on the success rate of an entry; null if none is.
Json strongest_of(const Json& entries, const Json& levels) {
  Json strongest;
  double largest = 0;
  for (const Json& entry : entries) {
    for (std::size_t k = 0; k < entry["effects"].size(); ++k) {
      const Json& one = entry["effects"][k];
      const bool sure = excludes_zero(one["lower"], one["upper"]);
      const double size = std::abs(one["effect"].get<double>());
      if (!sure || size <= largest) continue;
      largest = size;
      strongest = {
          {"entry", entry["entry"]}, {"level", levels.at(k)["level"]}, {"effect", one["effect"]}};
    }
  }
  return strongest;
}

void add_turns(Json& rows, const std::string& family, const ByEntry& entries,
               const std::map<std::string, std::vector<double>>& factors) {
  for (const auto& [name, levels] : factors) {
    for (const double level : levels) {
      ByEntry here;
      for (const auto& [entry, results] : entries) {
        for (const MachineResult& result : results) {
          if (result.problem->factors.at(name) == level) here[entry].push_back(result);
        }
      }
      const auto order = best_first(here);
      const auto overall = best_first(entries);
      // The entry that is best over all machines may not take those of this level.
      const auto again = here.find(overall.front()->first);
      rows.push_back(
          {{"family", family},
           {"factor", name},
           {"level", level},
           {"level_name", level_name(name, level)},
           {"leader", name_of(*order.front())},
           {"share", mean_solved(order.front()->second)},
           {"overall", name_of(*overall.front())},
           {"share_of_overall", again == here.end() ? Json() : Json(mean_solved(again->second))},
           {"same", order.front()->first == overall.front()->first}});
    }
  }
}

}  // namespace

Json factor_data(const Campaign& campaign, const std::vector<CellResult>& results,
                 const std::vector<ReportedPart>& parts) {
  Json effects = Json::array();
  Json turns = Json::array();
  Json main_effects = Json::array();
  std::size_t unsure = 0;
  for (const ReportedPart& part : parts) {
    for (const auto& [family, entries] : machine_results(campaign, results, part)) {
      const auto factors = factors_of(entries);
      if (factors.empty()) continue;
      const auto order = best_first(entries);
      Json shown = Json::array();
      for (std::size_t k = 0; k < std::min(shown_entries, order.size()); ++k) {
        Json main = Json::array();
        add_effects(effects, unsure, main, family, *order[k], factors);
        if (main.empty()) continue;
        shown.push_back({{"entry", name_of(*order[k])}, {"effects", std::move(main)}});
      }
      if (!shown.empty()) {
        Json levels = levels_of(factors);
        Json strongest = strongest_of(shown, levels);
        main_effects.push_back({{"family", family},
                                {"levels", std::move(levels)},
                                {"strongest", std::move(strongest)},
                                {"entries", std::move(shown)}});
      }
      add_turns(turns, family, entries, factors);
    }
  }
  return {{"effects", std::move(effects)},
          {"unsure_effects", unsure},
          {"main_effects", std::move(main_effects)},
          {"turns", std::move(turns)}};
}

}  // namespace ricochet::studies::comparison
