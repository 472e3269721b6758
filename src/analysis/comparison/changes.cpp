#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/profiles.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/outcomes.h"
#include "src/analysis/statistics/hypothesis_tests.h"

namespace ricochet::studies::comparison {

namespace {

/// One value of the setting that is varied.
struct Setting {
  std::string name;
  std::vector<Rating> ratings;  ///< the best first
  Order order;
  std::size_t problems;
};

Table no_changes(std::string name) {
  return {std::move(name),
          {{"family"},
           {"changed"},
           {"setting", "to"},
           {"first"},
           {"same", "", "mark"},
           {"best", "P(best)", ".2f", 3},
           {"returned", "success rate [%]", ".0%", 3},
           {"problems"},
           {"entries", "ranked entries"},
           {"correlation", "", ".2f", 3},
           {"lower", "", ".2f", 3},
           {"upper", "", ".2f", 3}}};
}

/// A row for each setting; all are compared with the first.
void add_rows(Table& table, const std::string& family, const std::string& changed,
              const std::vector<Setting>& settings) {
  if (settings.size() < 2) return;
  const Setting& usual = settings.front();
  for (const Setting& setting : settings) {
    const Rating* first = leader_of(setting.ratings);
    const auto agreement =
        &setting == &usual ? std::nullopt : agreement_of(usual.order, setting.order);
    table.add(family, changed, setting.name, setting.order.leader,
              setting.order.leader == usual.order.leader,
              value_of(first, &Rating::probability_of_being_best),
              value_of(first, &Rating::returned), setting.problems, setting.order.entries.size(),
              value_of(agreement, &Agreement::correlation), value_of(agreement, &Agreement::lower),
              value_of(agreement, &Agreement::upper));
  }
}

std::vector<Rating> rated(const Comparison& comparison, const std::vector<std::size_t>& problems) {
  return rate(comparison, problems, comparison.part->budgets.size() - 1);
}

void add_prices(Table& table, const Campaign& campaign, const std::vector<CellResult>& results,
                const ReportedPart& part) {
  std::vector<std::string> prices = campaign.plan().parts[part.part].gradient_prices;
  std::stable_partition(prices.begin(), prices.end(), [&](const std::string& price) {
    return price == part.usual.gradient_price;
  });
  if (prices.size() < 2) return;
  std::vector<std::string> families;  // in the order of the problems
  std::map<std::string, std::vector<Setting>> settings;
  for (const std::string& price : prices) {
    Conditions conditions = part.usual;
    conditions.gradient_price = price;
    const Comparison comparison = comparison_in(campaign, results, part, conditions);
    for (const Group& group : groups_of(comparison)) {
      std::vector<Rating> ratings = rated(comparison, group.problems);
      Order order = order_of(ratings);
      if (!settings.contains(group.family)) families.push_back(group.family);
      settings[group.family].push_back(
          {price, std::move(ratings), std::move(order), group.problems.size()});
    }
  }
  for (const std::string& family : families) {
    add_rows(table, part.families.at(family), "price of a gradient", settings[family]);
  }
}

/// The smoothing parameters of the surrogates that are used, the default one first.
std::vector<double> smoothings_of(const Comparison& comparison, const Group& group,
                                  bool penalised) {
  std::set<double> found;
  for (const CellResult& result : comparison.results) {
    const Formulation& formulation = result.cell->formulation;
    if (!group.has(result)) continue;
    if (formulation.smoothing > 0 && formulation.penalised == penalised)
      found.insert(formulation.smoothing);
  }
  std::vector<double> smoothings(found.begin(), found.end());
  const double usual = comparison.campaign->problems()[group.problems.front()].smoothing;
  std::stable_partition(smoothings.begin(), smoothings.end(), [&](double w) { return w == usual; });
  return smoothings;
}

void add_smoothings(Table& table, const Comparison& comparison, const Group& group) {
  for (const bool penalised : {false, true}) {
    std::vector<Setting> settings;
    const std::vector<double> smoothings = smoothings_of(comparison, group, penalised);
    if (smoothings.size() < 2) continue;
    for (const double smoothing : smoothings) {
      Comparison shown = comparison;
      const Formulation formulation{smoothing, penalised};
      std::erase_if(shown.results,
                    [&](const CellResult& r) { return r.cell->formulation != formulation; });
      std::vector<Rating> ratings = rated(shown, group.problems);
      Order order = order_in(ratings, ratings.front().formulation);
      settings.push_back({fmt::format("{}", smoothing), std::move(ratings), std::move(order),
                          group.problems.size()});
    }
    add_rows(table, group.family,
             penalised ? "smoothing of the penalised surrogate" : "smoothing of the surrogate",
             settings);
  }
}

}  // namespace

Table level_table(const Comparison& comparison, const Group& group) {
  Table table = no_changes("levels");
  std::map<std::string, std::map<double, std::vector<std::size_t>>> factors;
  for (const std::size_t q : group.problems) {
    for (const auto& [name, level] : comparison.campaign->problems()[q].factors) {
      factors[name][level].push_back(q);
    }
  }
  for (const auto& [name, levels] : factors) {
    if (levels.size() < 2) continue;
    std::vector<Setting> settings;
    for (const auto& [level, problems] : levels) {
      std::vector<Rating> ratings = rated(comparison, problems);
      Order order = order_of(ratings);
      settings.push_back(
          {level_name(name, level), std::move(ratings), std::move(order), problems.size()});
    }
    add_rows(table, group.family, name, settings);
  }
  return table;
}

Table change_table(const Campaign& campaign, const std::vector<CellResult>& results,
                   const std::vector<RatedPart>& parts) {
  Table table = no_changes("changes");
  for (const RatedPart& part : parts) {
    add_prices(table, campaign, results, *part.part);
    for (Group group : groups_of(part.comparison)) {
      group.family = part.part->families.at(group.family);
      add_smoothings(table, part.comparison, group);
    }
  }
  return table;
}

namespace {

using namespace ricochet::comparison;

using RunCosts = std::map<std::pair<int, int>, double>;  ///< by instance and run

std::map<Cell, RunCosts> costs_in(const Store& store) {
  std::map<Cell, RunCosts> all;
  each_judged(
      store,
      [&](const JudgedRun& run) {
        const RunKey& key = run.stored.key;
        const auto budget = static_cast<double>(key.cell.budget * run.problem.variables);
        all[key.cell][{key.instance, key.run}] = penalised_cost(run.outcome, budget);
      },
      [](const JudgedCell&) {});
  return all;
}

/// The logarithm of the ratio of the mean costs of the runs that both have; nothing if there are
/// none.
std::optional<double> log_ratio(const RunCosts& first, const RunCosts& second) {
  double of_first = 0;
  double of_second = 0;
  for (const auto& [run, cost] : first) {
    const auto other = second.find(run);
    if (other == second.end()) continue;
    of_first += cost;
    of_second += other->second;
  }
  if (of_first == 0) return std::nullopt;
  return std::log(of_second / of_first);
}

std::string version_in(const CampaignDescription& description, const std::string& solver) {
  const auto found = std::ranges::find(description.solvers, solver, &StoredSolver::name);
  return found == description.solvers.end() ? "" : found->version;
}

EntryChange change_of(const Cell& entry, const std::vector<double>& log_ratios) {
  EntryChange change{
      entry.solver, entry.formulation, entry.perturbation, entry.gradient_price, "", ""};
  change.problems = static_cast<int>(log_ratios.size());
  double sum = 0;
  for (const double ratio : log_ratios) {
    sum += ratio;
    change.cheaper += ratio < 0 ? 1 : 0;
    change.dearer += ratio > 0 ? 1 : 0;
  }
  change.ratio = std::exp(sum / change.problems);
  change.p_value = signed_rank_test(log_ratios);
  return change;
}

}  // namespace

EntryChanges entry_changes(const Store& first, const Store& second) {
  EntryChanges changes;
  const auto hashes = first.description().hashes();
  const auto other_hashes = second.description().hashes();
  for (const auto& [problem, hash] : hashes) {
    const auto other = other_hashes.find(problem);
    if (other == other_hashes.end() || other->second == hash) continue;
    changes.other_problems.push_back(problem);
  }
  struct Compared {
    std::int64_t budget;
    double log_ratio;
  };
  std::map<Cell, std::map<std::string, Compared>> entries;  // by cell without problem and budget
  const auto others = costs_in(second);
  for (const auto& [cell, costs] : costs_in(first)) {
    const auto other = others.find(cell);
    if (other == others.end() || std::ranges::count(changes.other_problems, cell.problem) > 0) {
      continue;
    }
    const auto ratio = log_ratio(costs, other->second);
    if (!ratio) continue;
    Cell entry = cell;
    entry.problem.clear();
    entry.budget = 0;
    const auto [known, fresh] =
        entries[entry].try_emplace(cell.problem, Compared{cell.budget, *ratio});
    if (!fresh && cell.budget > known->second.budget) known->second = {cell.budget, *ratio};
  }
  std::vector<double> p_values;
  for (const auto& [entry, problems] : entries) {
    std::vector<double> log_ratios;
    for (const auto& [problem, on] : problems) log_ratios.push_back(on.log_ratio);
    EntryChange& change = changes.entries.emplace_back(change_of(entry, log_ratios));
    change.version = version_in(first.description(), entry.solver);
    change.other_version = version_in(second.description(), entry.solver);
    p_values.push_back(change.p_value);
  }
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t k = 0; k < adjusted.size(); ++k) changes.entries[k].p_value = adjusted[k];
  std::ranges::stable_sort(changes.entries, {}, &EntryChange::p_value);
  return changes;
}

}  // namespace ricochet::studies::comparison
