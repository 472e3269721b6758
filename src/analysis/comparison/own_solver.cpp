#include <fmt/format.h>
#include <fmt/ranges.h>

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

void add_row(Table& table, const Campaign& campaign, const EntrySet& set, const Entry& own) {
  std::vector<double> shares;
  for (const auto& [problem, share] : shares_of(campaign, own)) shares.push_back(share);
  const auto solved =
      std::ranges::count_if(shares, [](double share) { return share >= most_runs; });
  const MeanShare mean = mean_share(shares, clusters_of(campaign, own));
  const std::vector<Rival> rivals = rivals_of(campaign, set, own);
  const auto count = [&](double sign, double significance) {
    return std::ranges::count_if(rivals, [&](const Rival& rival) {
      return sign * rival.difference > 0 && rival.p < significance;
    });
  };
  table.add(own.solver, set.family, set.budget, own.formulation, own.results.size(),
            set.problems.size(), solved, mean.mean, mean.interval.lower, mean.interval.upper,
            count(1, 2), count(1, significant_rival), count(-1, 2), count(-1, significant_rival),
            rivals.size());
}

}  // namespace

void add_own_solvers(const Campaign& campaign, const std::vector<EntrySet>& sets,
                     const std::vector<Solver>& suite, report::Results& page) {
  Table table{"own-solvers",
              {{"solver"},
               {"family"},
               {"budget", "evaluations a variable"},
               {"formulation"},
               {"takes"},
               {"problems"},
               {"solved"},
               {"share", "success rate [%]", ".0%", 3},
               {"lower", "", ".0%", 3},
               {"upper", "", ".0%", 3},
               {"better"},
               {"clearly_better"},
               {"worse"},
               {"clearly_worse"},
               {"rivals"}}};
  for (const EntrySet& set : sets) {
    if (!set.largest) continue;
    each_entry(set, [&](const Entry& entry) {
      const bool own = std::ranges::find(suite, entry.solver, &Solver::name) == suite.end();
      if (own) add_row(table, campaign, set, entry);
    });
  }
  Table totals = aggregated(table, {"solver"},
                            {{{"solved"}, "solved", sum_of},
                             {{"problems"}, "takes", sum_of},
                             {{"better"}, "better", sum_of},
                             {{"worse"}, "worse", sum_of},
                             {{"rivals"}, "rivals", sum_of}});
  totals.name = "own-totals";
  page.add(std::move(table));
  page.add(std::move(totals));
}

namespace {

constexpr std::array places = {"lower", "middle", "upper"};
using Shares = std::array<Share, places.size()>;  // by place of the optimum

/// Fisher's test of both ends against the middle.
double p_value_of(const Shares& shares) {
  const Share ends{shares[0].successes + shares[2].successes, shares[0].trials + shares[2].trials};
  return fisher_exact_test(ends, shares[1]);
}

void add_rows(Table& table, const std::map<std::string, Shares>& entries) {
  std::vector<double> p_values;
  for (const auto& [entry, shares] : entries) p_values.push_back(p_value_of(shares));
  p_values = holm(p_values);
  auto p_value = p_values.begin();
  for (const auto& [entry, shares] : entries) {
    std::vector<Value> row = {entry};
    for (const Share& share : shares) {
      const Interval interval = wilson_interval(share.successes, share.trials);
      row.insert(row.end(), {share.successes / static_cast<double>(share.trials), interval.lower,
                             interval.upper});
    }
    row.insert(row.end(), {static_cast<std::int64_t>(shares[0].trials), *p_value, *p_value < 0.05});
    table.add_row(std::move(row));
    ++p_value;
  }
}

}  // namespace

void add_relocated_optima(const Campaign& campaign, const std::vector<CellResult>& results,
                          report::Results& page) {
  Table table{"relocated-optima", {{"entry"}}};
  for (const char* place : places) {
    table.columns.push_back({place, "", ".0%", 3});
    table.columns.push_back({fmt::format("{}_lower", place), "", ".0%", 3});
    table.columns.push_back({fmt::format("{}_upper", place), "", ".0%", 3});
  }
  table.columns.insert(table.columns.end(), {{"runs"}, {"p_value", "p", ".3f"}, {"biased"}});
  std::vector<std::string> parts;
  for (std::size_t part = 0; part < campaign.plan().parts.size(); ++part) {
    if (!campaign.plan().parts[part].relocated_optimum) continue;
    std::map<std::string, Shares> entries;
    std::set<std::size_t> problems;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Comparison comparison =
          comparison_of(campaign, results,
                        {.part = part,
                         .perturbation = names_of_places()[k],
                         .gradient_price = usual_price(campaign.plan().parts[part])});
      for (const CellResult& result : comparison.results) {
        const Cell& cell = result.cell->cell;
        add_runs(entries[entry(cell.solver, cell.formulation)][k], result);
        problems.insert(result.cell->problem);
      }
    }
    add_rows(table, entries);
    parts.push_back(fmt::format("{} problem{} of {}", problems.size(),
                                problems.size() == 1 ? "" : "s",
                                variables_of(campaign, {problems.begin(), problems.end()})));
  }
  page.set("relocated",
           parts.empty() ? Value() : value_of(fmt::format("{}", fmt::join(parts, ", "))));
  page.add(std::move(table));
}

}  // namespace ricochet::studies::comparison
