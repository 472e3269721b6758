#include "src/analysis/comparison/order.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/results.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/ranking.h"
#include "src/core/instance.h"
#include "src/core/names.h"

namespace ricochet::studies::comparison {

using report::Json;

Order order_of(const std::vector<Rating>& ratings) {
  Order order;
  if (const Rating* leader = leader_of(ratings)) {
    order.leader = entry(leader->solver, leader->formulation);
  }
  for (const Rating& r : ratings) {
    if (r.rank) order.entries[entry(r.solver, r.formulation)] = {r.solver, *r.rank};
  }
  return order;
}

Order order_in(std::vector<Rating> ratings, const std::string& formulation) {
  std::erase_if(ratings, [&](const Rating& r) { return r.formulation != formulation; });
  Order order;
  if (const Rating* leader = leader_of(ratings)) order.leader = leader->solver;
  for (const Rating& r : ratings) {
    if (r.rank) order.entries[r.solver] = {r.solver, *r.rank};
  }
  return order;
}

Json agreement_of(const Order& a, const Order& b) {
  std::vector<double> ranks_a;
  std::vector<double> ranks_b;
  std::vector<std::string> solvers;
  for (const auto& [name, ranked] : a.entries) {
    const auto other = b.entries.find(name);
    if (other == b.entries.end()) continue;
    ranks_a.push_back(ranked.rank);
    ranks_b.push_back(other->second.rank);
    solvers.push_back(ranked.solver);
  }
  if (ranks_a.size() < 2) return {};
  const auto interval = kendall_interval(ranks_a, ranks_b, solvers, seed_of("agreement", "", 0, 0));
  if (!interval) return {};
  return {{"entries", ranks_a.size()},
          {"solvers", std::set<std::string>(solvers.begin(), solvers.end()).size()},
          {"correlation", *kendall_rank_correlation(ranks_a, ranks_b)},
          {"lower", interval->lower},
          {"upper", interval->upper}};
}

namespace {

/// Keeps every second instance, from the first or the second on; both halves have the same size.
Comparison half(Comparison comparison, std::size_t from) {
  for (CellResult& result : comparison.results) {
    result.outcomes = result.outcomes.every(2, from, result.outcomes.size() / 2);
  }
  return comparison;
}

/// Returns the order on drawn machines, for the results of this family.
std::optional<Order> order_on_drawn(const Campaign& campaign,
                                    const std::vector<CellResult>& results, std::size_t drawn,
                                    const std::string& family) {
  const Comparison comparison = comparison_of(campaign, results, {.part = drawn});
  for (const Group& group : groups_of(comparison)) {
    if (group.family != family) continue;
    return order_of(rate(comparison, group.problems, comparison.part->budgets.size() - 1));
  }
  return std::nullopt;
}

}  // namespace

Json order_data(const Comparison& comparison, const std::vector<CellResult>& results,
                const ReportedPart& part, const std::vector<Group>& groups,
                const Ratings& ratings) {
  const Campaign& campaign = *comparison.campaign;
  const std::size_t last = comparison.part->budgets.size() - 1;
  Json rows = Json::array();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Group& group = groups[g];
    const std::vector<Rating>& first = ratings[g].front().by_returned;
    const std::vector<Rating>& most = ratings[g].back().by_returned;
    const auto add = [&](const std::string& what, const Order& a, const Order& b) {
      Json row = agreement_of(a, b);
      if (row.is_null()) return;  // the orders cannot be compared
      row.update({{"family", group.family},
                  {"problems", group.problems.size()},
                  {"what", what},
                  {"leader", a.leader},
                  {"other_leader", b.leader},
                  {"same_leader", a.leader == b.leader}});
      rows.push_back(std::move(row));
    };
    const auto order = [&](const Comparison& compared, std::size_t budget) {
      return order_of(rate(compared, group.problems, budget));
    };
    if (part.repetition) {
      Conditions again = part.usual;
      again.part = *part.repetition;
      again.run = 1;
      add("other seeds", order_of(first), order(comparison_of(campaign, results, again), 0));
    }
    if (comparison.part->instances > 1) {
      add("the other half of the instances", order(half(comparison, 0), last),
          order(half(comparison, 1), last));
    }
    if (last > 0) add("more evaluations", order_of(first), order_of(most));
    if (part.drawn) {
      const auto drawn = order_on_drawn(campaign, results, *part.drawn,
                                        campaign.family_of(group.problems.front()));
      if (drawn) add("machines drawn around the cases", order_of(most), *drawn);
    }
    std::set<std::string> formulations;
    for (const Rating& rating : most) formulations.insert(rating.formulation);
    for (auto a = formulations.begin(); a != formulations.end(); ++a) {
      for (auto b = std::next(a); b != formulations.end(); ++b) {
        add(*a + " or " + *b, order_in(most, *a), order_in(most, *b));
      }
    }
  }
  return rows;
}

std::vector<RatedFamily> rated_families(const Campaign& campaign,
                                        const std::vector<CellResult>& results) {
  std::vector<RatedFamily> families;
  for (const ReportedPart& part : reported_parts(campaign)) {
    const Comparison comparison = comparison_of(campaign, results, part.usual);
    const std::vector<std::int64_t>& budgets = comparison.part->budgets;
    for (const Group& group : groups_of(comparison)) {
      RatedFamily& family = families.emplace_back();
      family.name = part.families.at(group.family);
      family.problems = group.problems.size();
      family.budget = budgets.back();
      family.ratings = rate(comparison, group.problems, budgets.size() - 1);
      for (const CellResult& result : comparison.results) {
        if (group.has(result)) family.targets[result.cell->cell.problem] = result.targets;
      }
    }
  }
  std::ranges::sort(families, {}, &RatedFamily::name);
  return families;
}

namespace {

constexpr double easy_for_random_search = 20;  // evaluations

/// Expected running time of random search, on the true values, the median over the problems.
Json random_search_time(const Comparison& comparison, const Group& group) {
  std::map<std::size_t, double> times;
  for (const CellResult& result : comparison.results) {
    const PlannedCell& cell = *result.cell;
    const bool largest = cell.cell.budget == comparison.part->budgets.back();
    if (cell.cell.solver != "random-search" || !largest || cell.formulation.smoothing > 0 ||
        !group.has(result)) {
      continue;
    }
    const auto time = result_of(result.outcomes).returned_running_time;
    const double value = time ? time->value : std::numeric_limits<double>::infinity();
    const auto [known, fresh] = times.try_emplace(cell.problem, value);
    known->second = std::min(known->second, value);
  }
  std::vector<double> all;
  for (const auto& [problem, time] : times) all.push_back(time);
  return all.empty() ? Json() : report::as_json(quantile(std::move(all), 0.5));
}

}  // namespace

Json leader_data(const Comparison& comparison, const std::vector<Group>& groups, const Json& rows) {
  Json leaders = Json::array();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Json random = random_search_time(comparison, groups[g]);
    const bool easy = random.is_number() && random.get<double>() <= easy_for_random_search;
    for (const Json& budget : rows[g]["budgets"]) {
      Json row = budget["leader"];
      if (easy) {
        const Json of = row["of"];
        const Json single = row["single"];
        for (auto& [key, value] : row.items()) value = nullptr;
        row.update({{"differs", false}, {"of", of}, {"single", single}});
      }
      row["family"] = rows[g]["family"];
      row["budget"] = budget["budget"];
      row["largest"] = budget == rows[g]["budgets"].back();
      row["random"] = random;
      row["easy"] = easy;
      leaders.push_back(std::move(row));
    }
  }
  return leaders;
}

namespace {

struct Beaten {
  int runs = 0;
  double gap = 0;  // of the best run
  const Cell* cell = nullptr;
};

}  // namespace

Json beaten_data(const Campaign& campaign,
                 const std::vector<ricochet::comparison::CellResult>& results) {
  std::map<std::size_t, Beaten> beaten;
  for (const auto& result : results) {
    const std::size_t number = result.cell->problem;
    for (const auto& outcome : result.outcomes) {
      const double gap = outcome.verdict.optimality_gap.value_or(0);
      if (gap >= -campaign.problems()[number].tolerance) continue;
      Beaten& there = beaten[number];
      ++there.runs;
      if (gap < there.gap) {
        there.gap = gap;
        there.cell = &result.cell->cell;
      }
    }
  }
  Json rows = Json::array();
  for (const auto& [number, there] : beaten) {
    const Problem& problem = campaign.problems()[number];
    rows.push_back({{"problem", problem.name},
                    {"best_known", problem.best_known.value()},
                    {"gap", there.gap},
                    {"tolerance", problem.tolerance},
                    {"runs", there.runs},
                    {"solver", there.cell->solver},
                    {"formulation", there.cell->formulation}});
  }
  return rows;
}

Json lacking_data(const Plan& plan, const std::vector<MissingSolver>& missing) {
  Json rows = Json::array();
  for (const MissingSolver& solver : missing) {
    const bool asked = std::ranges::any_of(
        plan.parts, [&](const PlanPart& part) { return fits_any(solver.solver, part.solvers); });
    if (asked) rows.push_back({{"solver", solver.solver}, {"library", solver.library}});
  }
  return rows;
}

}  // namespace ricochet::studies::comparison
