#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/rating.h"
#include "src/analysis/statistics/hypothesis_tests.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/ranking.h"
#include "src/core/instance.h"
#include "src/experiment/campaign.h"

namespace ricochet::studies::comparison {

namespace {

using report::Json;

constexpr double significant_rival = 0.05;
constexpr double most_runs = 0.5;

/// Shares solved, by problem.
std::map<std::size_t, double> shares_of(const Campaign& campaign, const Entry& entry) {
  std::map<std::size_t, double> shares;
  for (const CellResult* result : entry.results) {
    shares[result->cell->problem] = on_problem(campaign, *result).share;
  }
  return shares;
}

/// Another solver of the family.
struct Rival {
  double difference;  ///< of the mean shares on the problems that both take: ours less theirs
  double p;           ///< of the signed-rank test
};

std::vector<Rival> rivals_of(const Campaign& campaign, const EntrySet& set, const Entry& own) {
  const std::map<std::size_t, double> ours = shares_of(campaign, own);
  std::vector<Rival> rivals;
  std::vector<double> p_values;
  each_entry(set, [&](const Entry& entry) {
    if (entry.solver == own.solver) return;
    std::vector<double> differences;
    for (const auto& [problem, share] : shares_of(campaign, entry)) {
      const auto mine = ours.find(problem);
      if (mine != ours.end()) differences.push_back(mine->second - share);
    }
    if (2 * differences.size() < set.problems.size()) return;
    double sum = 0;
    for (const double difference : differences) sum += difference;
    rivals.push_back({sum / static_cast<double>(differences.size()), 1});
    p_values.push_back(signed_rank_test(differences));
  });
  const std::vector<double> adjusted = holm(p_values);
  for (std::size_t k = 0; k < rivals.size(); ++k) rivals[k].p = adjusted[k];
  return rivals;
}

Json family_row(const Campaign& campaign, const EntrySet& set, const Entry& own) {
  std::vector<double> shares;
  for (const auto& [problem, share] : shares_of(campaign, own)) shares.push_back(share);
  const MeanShare mean = mean_share(shares);
  int better = 0;
  int worse = 0;
  int clearly_better = 0;
  int clearly_worse = 0;
  const std::vector<Rival> rivals = rivals_of(campaign, set, own);
  for (const Rival& rival : rivals) {
    const bool clear = rival.p < significant_rival;
    if (rival.difference > 0) {
      ++better;
      clearly_better += clear ? 1 : 0;
    } else if (rival.difference < 0) {
      ++worse;
      clearly_worse += clear ? 1 : 0;
    }
  }
  return {{"solver", own.solver},
          {"family", set.family},
          {"budget", set.budget},
          {"formulation", own.formulation},
          {"problems", own.results.size()},
          {"of", set.problems.size()},
          {"share", mean.mean},
          {"lower", mean.interval.lower},
          {"upper", mean.interval.upper},
          {"rivals", rivals.size()},
          {"better", better},
          {"worse", worse},
          {"clearly_better", clearly_better},
          {"clearly_worse", clearly_worse}};
}

struct Total {
  int solved = 0, problems = 0, better = 0, worse = 0, rivals = 0;
};

}  // namespace

Json own_solver_data(const Campaign& campaign, const std::vector<EntrySet>& sets,
                     const std::vector<Solver>& suite) {
  const auto is_own = [&](const Entry& entry) {
    return std::ranges::find(suite, entry.solver, &Solver::name) == suite.end();
  };
  Json rows = Json::array();
  std::map<std::string, Total> totals;
  for (const EntrySet& set : sets) {
    if (!set.largest) continue;
    each_entry(set, [&](const Entry& entry) {
      if (!is_own(entry)) return;
      const Json& row = rows.emplace_back(family_row(campaign, set, entry));
      Total& total = totals[entry.solver];
      for (const auto& [problem, share] : shares_of(campaign, entry)) {
        ++total.problems;
        total.solved += share >= most_runs ? 1 : 0;
      }
      total.better += row["better"].get<int>();
      total.worse += row["worse"].get<int>();
      total.rivals += row["rivals"].get<int>();
    });
  }
  Json sums = Json::array();
  for (const auto& [solver, total] : totals) {
    sums.push_back({{"solver", solver},
                    {"solved", total.solved},
                    {"problems", total.problems},
                    {"better", total.better},
                    {"worse", total.worse},
                    {"rivals", total.rivals}});
  }
  return {{"own_solvers", std::move(rows)}, {"own_totals", std::move(sums)}};
}

Json held_out_data(const Comparison& comparison, const std::vector<Group>& groups) {
  Json rows = Json::array();
  for (const Group& group : groups) {
    const RankedEntries ranked =
        ranked_entries(comparison, group.problems, comparison.part->budgets.size() - 1);
    const auto order = held_out_order(ranked.problems, ranked.names.size(),
                                      seed_of("held out", group.family, 0, 0));
    Json row = {{"family", group.family},
                {"problems", group.problems.size()},
                {"entries", ranked.names.size()},
                {"measured", order.has_value()}};
    if (order) {
      row.update({{"correlation", order->correlation},
                  {"lower", order->interval.lower},
                  {"upper", order->interval.upper},
                  {"first_stays", order->first_stays}});
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

namespace {

constexpr std::array places = {"lower", "middle", "upper"};
using Shares = std::array<Share, places.size()>;  // by place of the optimum

/// Fisher's test of both ends against the middle.
double p_value_of(const Shares& shares) {
  const Share ends{shares[0].successes + shares[2].successes, shares[0].trials + shares[2].trials};
  return fisher_exact_test(ends, shares[1]);
}

void add_rows(Json& rows, const std::map<std::string, Shares>& entries) {
  std::vector<double> p_values;
  for (const auto& [entry, shares] : entries) p_values.push_back(p_value_of(shares));
  p_values = holm(p_values);
  auto p_value = p_values.begin();
  for (const auto& [entry, shares] : entries) {
    Json row = {{"solver", entry},
                {"runs", shares[0].trials},
                {"p_value", *p_value},
                {"leans", *p_value < 0.05}};
    for (std::size_t k = 0; k < places.size(); ++k) row[places[k]] = share_data(shares[k]);
    rows.push_back(std::move(row));
    ++p_value;
  }
}

}  // namespace

Json relocated_optimum_data(const Campaign& campaign, const std::vector<CellResult>& results) {
  Json rows = Json::array();
  Json parts = Json::array();
  for (std::size_t part = 0; part < campaign.plan().parts.size(); ++part) {
    if (!campaign.plan().parts[part].relocated_optimum) continue;
    std::map<std::string, Shares> entries;
    std::set<std::size_t> problems;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Comparison comparison =
          comparison_of(campaign, results, {.part = part, .perturbation = names_of_places()[k]});
      for (const CellResult& result : comparison.results) {
        const Cell& cell = result.cell->cell;
        add_runs(entries[entry(cell.solver, cell.formulation)][k], result);
        problems.insert(result.cell->problem);
      }
    }
    add_rows(rows, entries);
    Json variables = variables_of(campaign, {problems.begin(), problems.end()});
    variables["problems"] = problems.size();
    parts.push_back(std::move(variables));
  }
  Json biased = Json::array();
  for (const Json& row : rows) {
    if (row["leans"] == true) biased.push_back(row["solver"]);
  }
  return {{"relocated_optima", std::move(rows)},
          {"biased", std::move(biased)},
          {"relocated", std::move(parts)}};
}

}  // namespace ricochet::studies::comparison
