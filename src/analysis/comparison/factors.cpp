#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/comparison/sections.h"
#include "src/analysis/statistics/factorial_effects.h"

namespace ricochet::studies::comparison {

namespace {

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

/// The main effects of one entry on the share solved, in the order of the levels.
using MainEffects = std::vector<FactorialEffect>;

/// Adds the significant effects and the mean to the table and counts the others in `unsure`.
/// Returns all main effects on the share solved; none if there are too few machines for an
/// estimate.
MainEffects add_effects(Table& table, std::size_t& unsure, const ByEntry::value_type& entry,
                        const std::map<std::string, std::vector<double>>& factors) {
  std::vector<std::string> names;
  std::vector<std::size_t> sizes;
  for (const auto& [name, levels] : factors) {
    names.push_back(name);
    sizes.push_back(levels.size());
  }
  std::map<std::string, std::size_t> units;
  MainEffects main;
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
      return {};
    }
    for (const FactorialEffect& effect : effects) {
      const bool sure = excludes_zero(effect.interval.lower, effect.interval.upper);
      if (measure.value == &MachineResult::solved && effect.factors.size() == 1) {
        main.push_back(effect);
      }
      if (!sure && !effect.factors.empty()) {
        ++unsure;
        continue;
      }
      std::vector<std::string> of;
      for (std::size_t f = 0; f < effect.factors.size(); ++f) {
        const std::string& name = names[effect.factors[f]];
        of.push_back(
            fmt::format("{} {}", name, level_name(name, factors.at(name)[effect.levels[f]])));
      }
      table.add(name_of(entry), measure.name,
                of.empty() ? "mean" : fmt::format("{}", fmt::join(of, ", ")), effect.effect,
                effect.interval.lower, effect.interval.upper);
    }
  }
  return main;
}

/// The main effects on the share solved of each entry, and in the title the largest significant
/// one.
report::Chart effect_chart(const std::string& family,
                           const std::map<std::string, std::vector<double>>& factors,
                           const std::vector<std::pair<std::string, MainEffects>>& entries) {
  report::Chart chart{.name = "effects",
                      .title = family + ": no level changes a success rate significantly",
                      .x = {"level"},
                      .y = {"added to the success rate [points]"},
                      .width = 820,
                      .height = 360};
  for (const auto& [name, levels] : factors) {
    for (const double level : levels) {
      chart.x.categories.push_back(fmt::format("{} {}", name, level_name(name, level)));
    }
  }
  double largest = 0;
  for (const auto& [entry, effects] : entries) {
    report::Series& series =
        chart.series.emplace_back(report::Series{entry, report::Mark::points, {}});
    for (std::size_t k = 0; k < effects.size(); ++k) {
      const auto& [lower, upper] = effects[k].interval;
      const double effect = effects[k].effect;
      series.samples.push_back(
          {static_cast<double>(k), 100 * effect, report::Range{100 * lower, 100 * upper}});
      if (!excludes_zero(lower, upper) || std::abs(effect) <= largest) continue;
      largest = std::abs(effect);
      chart.title =
          fmt::format("{}: {} changes a success rate most, {:.0f} points {} ({})", family,
                      chart.x.categories.at(k), 100 * largest, effect > 0 ? "up" : "down", entry);
    }
  }
  return chart;
}

/// The entry that solves most at each level of each factor, beside the one over all machines.
Table turn_table(const ByEntry& entries,
                 const std::map<std::string, std::vector<double>>& factors) {
  Table table{"levels",
              {{"factor"},
               {"level"},
               {"first", "solves most"},
               {"share", "success rate [%]", ".0%", 3},
               {"overall", "solves most over all machines"},
               {"share_of_overall", "its success rate here [%]", ".0%", 3},
               {"same", "", "mark"}}};
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
      table.add(name, level_name(name, level), name_of(*order.front()),
                mean_solved(order.front()->second), name_of(*overall.front()),
                again == here.end() ? Value() : value_of(mean_solved(again->second)),
                order.front()->first == overall.front()->first);
    }
  }
  return table;
}

}  // namespace

void add_effects(const std::string& family, const ByEntry& entries, report::Results& page) {
  Table table{"effects",
              {{"entry"},
               {"measure", "on"},
               {"of"},
               {"effect", "", "+.2f", 3},
               {"lower", "", "+.2f", 3},
               {"upper", "", "+.2f", 3}}};
  const auto factors = factors_of(entries);
  const auto order = best_first(entries);
  std::vector<std::pair<std::string, MainEffects>> shown;
  std::size_t unsure = 0;
  for (std::size_t k = 0; k < std::min(shown_entries, order.size()); ++k) {
    MainEffects main = add_effects(table, unsure, *order[k], factors);
    if (!main.empty()) shown.emplace_back(name_of(*order[k]), std::move(main));
  }
  if (!shown.empty()) page.add(effect_chart(family, factors, shown));
  page.set("unsure", unsure);
  page.add(std::move(table));
  page.add(turn_table(entries, factors));
}

}  // namespace ricochet::studies::comparison
