#include "src/analysis/comparison/order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "src/analysis/comparison/group.h"
#include "src/analysis/comparison/leaders.h"
#include "src/analysis/comparison/reported_part.h"
#include "src/analysis/comparison/shares.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/analysis/results.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/ranking.h"
#include "src/core/instance.h"
#include "src/core/names.h"

namespace ricochet::studies::comparison {

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

std::optional<Agreement> agreement_of(const Order& a, const Order& b) {
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
  return Agreement{ranks_a.size(), std::set<std::string>(solvers.begin(), solvers.end()).size(),
                   *kendall_rank_correlation(ranks_a, ranks_b), interval->lower, interval->upper};
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
  const Comparison comparison =
      comparison_of(campaign, results,
                    {.part = drawn, .gradient_price = usual_price(campaign.plan().parts[drawn])});
  for (const Group& group : groups_of(comparison)) {
    if (group.family != family) continue;
    return order_of(rate(comparison, group.problems, comparison.part->budgets.size() - 1));
  }
  return std::nullopt;
}

}  // namespace

Table order_table(const std::vector<CellResult>& results, const std::vector<RatedPart>& parts) {
  Table table{"orders",
              {{"family"},
               {"changed"},
               {"problems"},
               {"entries"},
               {"solvers"},
               {"correlation", "", ".2f", 3},
               {"lower", "", ".2f", 3},
               {"upper", "", ".2f", 3},
               {"first"},
               {"other_first", "first after the change"},
               {"same", "", "mark"}}};
  const auto add = [&](const Group& group, const std::string& what, const Order& a,
                       const Order& b) {
    const auto agreement = agreement_of(a, b);
    if (!agreement) return;  // the orders cannot be compared
    table.add(group.family, what, group.problems.size(), agreement->entries, agreement->solvers,
              agreement->correlation, agreement->lower, agreement->upper, a.leader, b.leader,
              a.leader == b.leader);
  };
  each_group(parts, [&](const RatedPart& rated, std::size_t g) {
    const Comparison& comparison = rated.comparison;
    const Campaign& campaign = *comparison.campaign;
    const std::size_t last = comparison.part->budgets.size() - 1;
    const Group& group = rated.groups[g];
    const std::vector<Rating>& first = rated.ratings[g].front();
    const std::vector<Rating>& most = rated.most(g);
    const auto order = [&](const Comparison& compared, std::size_t budget) {
      return order_of(rate(compared, group.problems, budget));
    };
    if (rated.part->repetition) {
      Conditions again = rated.part->usual;
      again.part = *rated.part->repetition;
      again.run = 1;
      add(group, "other seeds", order_of(first), order(comparison_of(campaign, results, again), 0));
    }
    if (comparison.part->instances > 1) {
      add(group, "the other half of the instances", order(half(comparison, 0), last),
          order(half(comparison, 1), last));
    }
    if (last > 0) add(group, "more evaluations", order_of(first), order_of(most));
    if (rated.part->drawn) {
      const auto drawn = order_on_drawn(campaign, results, *rated.part->drawn,
                                        campaign.family_of(group.problems.front()));
      if (drawn) add(group, "machines drawn around the cases", order_of(most), *drawn);
    }
    std::set<std::string> formulations;
    for (const Rating& rating : most) formulations.insert(rating.formulation);
    for (auto a = formulations.begin(); a != formulations.end(); ++a) {
      for (auto b = std::next(a); b != formulations.end(); ++b) {
        add(group, *a + " or " + *b, order_in(most, *a), order_in(most, *b));
      }
    }
  });
  return table;
}

Table summary_of(const Table& orders, std::string name, const std::vector<std::string>& by) {
  const auto times_true = [](const std::vector<Value>& values) {
    return value_of(std::ranges::count(values, Value(true)));
  };
  const Table compared =
      where(orders, [](const Row& row) { return !is_missing(row["correlation"]); });
  Table table = aggregated(compared, by,
                           {{{"compared"}, "", count_of},
                            {{"stays", "the first stays first"}, "same", times_true},
                            {{"median", "correlation, median", ".2f", 3}, "correlation", median_of},
                            {{"least", "correlation, least", ".2f", 3}, "correlation", least_of}});
  table.name = std::move(name);
  return table;
}

Table held_out_table(const std::vector<RatedPart>& parts) {
  Table table{"held-out",
              {{"family"},
               {"problems"},
               {"entries", "ranked entries"},
               {"correlation", "", ".2f", 3},
               {"lower", "", ".2f", 3},
               {"upper", "", ".2f", 3},
               {"first_stays", "first stays first [%]", ".0%", 3}}};
  each_group(parts, [&](const RatedPart& part, std::size_t g) {
    const Group& group = part.groups[g];
    const RankedEntries ranked =
        ranked_entries(part.comparison, group.problems, part.comparison.part->budgets.size() - 1);
    const auto order = held_out_order(ranked.problems, ranked.names.size(),
                                      seed_of("held out", group.family, 0, 0));
    table.add(group.family, group.problems.size(), ranked.names.size(),
              value_of(order, &HeldOutOrder::correlation),
              value_of(order, [](const HeldOutOrder& o) { return o.interval.lower; }),
              value_of(order, [](const HeldOutOrder& o) { return o.interval.upper; }),
              value_of(order, &HeldOutOrder::first_stays));
  });
  return table;
}

namespace {

/// The parts of a campaign's report, without the problems that tell nothing.
std::vector<ReportedPart> telling_parts(const Campaign& campaign,
                                        const std::vector<CellResult>& results) {
  std::vector<ReportedPart> parts = reported_parts(campaign);
  set_silent(campaign, results, parts);
  return parts;
}

}  // namespace

std::vector<RatedFamily> rated_families(const Campaign& campaign,
                                        const std::vector<CellResult>& results) {
  std::vector<RatedFamily> families;
  for (const ReportedPart& part : telling_parts(campaign, results)) {
    const Comparison comparison = comparison_in(campaign, results, part, part.usual);
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

Table beaten_table(const Campaign& campaign, const std::vector<CellResult>& results) {
  Table runs{"beaten",
             {{"problem"},
              {"best_known", "best known", ".10g", 17},
              {"gap", "below", ".3g"},
              {"tolerance", "", ".3g"},
              {"entry", "best run"}}};
  for (const CellResult& result : results) {
    const Problem& problem = campaign.problems()[result.cell->problem];
    const Cell& cell = result.cell->cell;
    for (const Outcome& outcome : result.outcomes) {
      const double gap = outcome.verdict.optimality_gap.value_or(0);
      if (gap >= -problem.tolerance) continue;
      runs.add(problem.name, problem.best_known, gap, problem.tolerance,
               entry(cell.solver, cell.formulation));
    }
  }
  runs = sorted(std::move(runs), {"gap"});
  const Table times = aggregated(runs, {"problem"}, {{{"runs"}, "", count_of}});
  Table best = joined(times, runs, {"problem"});
  best.name = "beaten";
  return sorted(std::move(best), {"problem"});
}

std::vector<MissingSolver> lacking(const Plan& plan, const std::vector<MissingSolver>& missing) {
  std::vector<MissingSolver> asked = missing;
  std::erase_if(asked, [&](const MissingSolver& solver) {
    return std::ranges::none_of(
        plan.parts, [&](const PlanPart& part) { return fits_any(solver.solver, part.solvers); });
  });
  return asked;
}

namespace {

/// Place of an entry among the ranked ones, 1 the first; nothing if it is none of them.
std::optional<std::size_t> place_of(const Rating& wanted, const std::vector<Rating>& ratings) {
  for (std::size_t k = 0; k < ratings.size() && ratings[k].rank; ++k) {
    const Rating& rating = ratings[k];
    if (rating.solver == wanted.solver && rating.formulation == wanted.formulation) return k + 1;
  }
  return {};
}

}  // namespace

std::vector<FamilyAgreement> family_agreements(const Campaign& first,
                                               const std::vector<CellResult>& of_first,
                                               const Campaign& second,
                                               const std::vector<CellResult>& of_second) {
  std::vector<FamilyAgreement> all;
  const std::vector<RatedFamily> others = rated_families(second, of_second);
  for (const RatedFamily& rated : rated_families(first, of_first)) {
    const auto other = std::ranges::find(others, rated.name, &RatedFamily::name);
    if (other == others.end()) continue;
    const Order order = order_of(rated.ratings), other_order = order_of(other->ratings);
    FamilyAgreement& one = all.emplace_back(FamilyAgreement{rated.name,
                                                            rated.problems,
                                                            other->problems,
                                                            agreement_of(order, other_order),
                                                            order.leader,
                                                            {},
                                                            {},
                                                            other_order.leader});
    if (const Rating* leader = leader_of(rated.ratings)) {
      one.best = leader->probability_of_being_best;
      one.place = place_of(*leader, other->ratings);
    }
  }
  return all;
}

namespace {

/// The share of a problem's runs, over all entries, that did not solve it.
double difficulty_of(const Comparison& comparison, std::size_t problem) {
  Share solved{};
  for (const CellResult& result : comparison.results) {
    if (result.cell->problem == problem) add_runs(solved, result);
  }
  return 1 - static_cast<double>(solved.successes) / solved.trials;
}

SampledFamily sampled(const Comparison& comparison, const Group& group, std::size_t number) {
  std::vector<double> difficulties;
  for (const std::size_t problem : group.problems) {
    difficulties.push_back(difficulty_of(comparison, problem));
  }
  SampledFamily family{.family = group.family, .of = group.problems.size()};
  std::vector<std::size_t> drawn;
  for (const std::size_t k :
       stratified_sample(difficulties, number, seed_of("sample", group.family, 0, 0))) {
    drawn.push_back(group.problems[k]);
    family.problems.emplace_back(comparison.campaign->problems()[group.problems[k]].name,
                                 difficulties[k]);
  }
  const std::size_t budget = comparison.part->budgets.size() - 1;
  const std::vector<Rating> ratings = rate(comparison, group.problems, budget);
  const Order whole = order_of(ratings);
  const Order sample = order_of(rate(comparison, drawn, budget));
  family.agreement = agreement_of(whole, sample);
  family.leader = whole.leader;
  family.sample_leader = sample.leader;
  if (const Rating* leader = leader_of(ratings)) {
    family.returned = leader->returned;
    family.best = leader->probability_of_being_best;
  }
  return family;
}

}  // namespace

std::vector<SampledFamily> sampled_families(const Campaign& campaign,
                                            const std::vector<CellResult>& results, double share,
                                            std::size_t least) {
  std::vector<SampledFamily> all;
  for (const ReportedPart& part : telling_parts(campaign, results)) {
    const Comparison comparison = comparison_in(campaign, results, part, part.usual);
    for (Group group : groups_of(comparison)) {
      const auto part_of_all = std::llround(share * static_cast<double>(group.problems.size()));
      group.family = part.families.at(group.family);
      all.push_back(
          sampled(comparison, group, std::max(least, static_cast<std::size_t>(part_of_all))));
    }
  }
  return all;
}

}  // namespace ricochet::studies::comparison
