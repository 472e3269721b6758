#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "ricochet/random.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/comparison/solver_pages.h"
#include "src/analysis/results.h"
#include "src/analysis/statistics/break_even.h"
#include "src/analysis/statistics/intervals.h"
#include "src/core/instance.h"

namespace ricochet::studies::comparison {

namespace {

using report::Json;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double cheapest_simulation = 1e-6;  // [s], ends of the chart
constexpr double dearest_simulation = 1e4;
constexpr int resamples = 200;

enum class Price { free, measured, variables };
constexpr std::array prices{Price::free, Price::measured, Price::variables};

std::string name_of(Price price) {
  if (price == Price::free) return "0";
  return price == Price::measured ? "measured" : "n";
}

/// Price of a gradient in addition to its value, in evaluations.
double price_on(const Problem& problem, Price price) {
  const std::int64_t n = problem.dimension();
  if (price == Price::free) return 0;
  return static_cast<double>(price == Price::variables ? n : problem.gradient_cost.value_or(n));
}

/// What a run requests until its problem is solved; ten times its total if it never solves it.
struct Requests {
  double values = 0, gradients = 0, seconds = 0;
};

Requests requests_of(const CellResult& result) {
  Requests mean;
  const auto runs = static_cast<double>(result.outcomes.size());
  for (const Outcome& outcome : result.outcomes) {
    // The ledger does not record when each request was made: we assume a constant rate.
    const double all = std::max<double>(static_cast<double>(outcome.evaluations), 1);
    const double times =
        outcome.solved() ? static_cast<double>(evaluations_until_solved(outcome)) / all : 10;
    mean.values += times * static_cast<double>(outcome.values) / runs;
    mean.gradients += times * static_cast<double>(outcome.derivatives) / runs;
    mean.seconds +=
        (outcome.solved() ? seconds_until_solved(outcome) : 10 * outcome.seconds) / runs;
  }
  return mean;
}

/// What the entries spend on one problem, per variable.
struct Spent {
  double simulation = infinity;  ///< [s] per evaluation, an upper bound: the least of any entry
  std::vector<std::array<Expense, prices.size()>> expenses;  ///< of each entry, at each price
};

Spent spent_on(const Problem& problem, const EntrySet& set, std::size_t q) {
  const auto variables = static_cast<double>(problem.dimension());
  std::vector<Requests> asked;
  Spent spent;
  for (const Entry& entry : set.entries) {
    const Requests& one = asked.emplace_back(requests_of(*entry.results[q]));
    const double evaluations = one.values + price_on(problem, Price::measured) * one.gradients;
    if (evaluations > 0) spent.simulation = std::min(spent.simulation, one.seconds / evaluations);
  }
  for (const Requests& one : asked) {
    const double evaluations = one.values + price_on(problem, Price::measured) * one.gradients;
    const double overhead =
        evaluations > 0 ? std::max(one.seconds - evaluations * spent.simulation, 0.0) : one.seconds;
    auto& at = spent.expenses.emplace_back();
    for (std::size_t p = 0; p < prices.size(); ++p) {
      at[p] = {problem.cost * one.values / variables,
               problem.cost * price_on(problem, prices[p]) * one.gradients / variables,
               overhead / variables};
    }
  }
  return spent;
}

/// Mean over the problems.
std::vector<Expense> mean_expenses(const std::vector<Spent>& all,
                                   const std::vector<std::size_t>& problems, std::size_t price) {
  std::vector<Expense> means(all.front().expenses.size(), Expense{0, 0, 0});
  const auto count = static_cast<double>(problems.size());
  for (const std::size_t q : problems) {
    for (std::size_t e = 0; e < means.size(); ++e) {
      const Expense& one = all[q].expenses[e][price];
      means[e].evaluations += one.evaluations / count;
      means[e].gradients += one.gradients / count;
      means[e].overhead += one.overhead / count;
    }
  }
  return means;
}

/// The entry that is ahead from this cost of a simulation on.
struct Stretch {
  std::size_t entry;
  double from;
};

std::vector<Stretch> stretches_of(const std::vector<Expense>& expenses) {
  std::vector<Stretch> stretches;
  double from = cheapest_simulation;
  std::size_t ahead = cheapest_solvers(expenses, {from}, {1})[0][0];
  while (true) {
    stretches.push_back({ahead, from});
    double next = dearest_simulation;
    for (const Expense& other : expenses) {
      const auto level = break_even_simulation(expenses[ahead], other, 1);
      if (level && *level > from) next = std::min(next, *level);
    }
    if (next >= dearest_simulation) return stretches;
    // If several entries are level, take the one that is ahead just above this cost.
    from = next * (1 + 1e-9);
    const std::size_t after = cheapest_solvers(expenses, {from}, {1})[0][0];
    if (after == ahead) return stretches;
    ahead = after;
  }
}

/// Returns the share of bootstrap samples of the problems in which this entry is ahead here.
double sureness(const std::vector<Spent>& spent, std::size_t price, std::size_t entry,
                double simulation, std::uint64_t seed) {
  Random random(seed);
  int ahead = 0;
  for (int k = 0; k < resamples; ++k) {
    std::vector<std::size_t> drawn(spent.size());
    for (std::size_t& q : drawn) {
      q = static_cast<std::size_t>(uniform(random) * static_cast<double>(spent.size()));
    }
    const auto expenses = mean_expenses(spent, drawn, price);
    if (cheapest_solvers(expenses, {simulation}, {1})[0][0] == entry) ++ahead;
  }
  return ahead / static_cast<double>(resamples);
}

std::string seconds_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.3g} µs", 1e6 * seconds);
  return seconds < 1 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

Json rows_of(const EntrySet& set, const std::vector<Spent>& spent,
             const std::vector<Stretch>& stretches, std::size_t price) {
  Json rows = Json::array();
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const Entry& entry = set.entries[stretches[k].entry];
    const bool last = k + 1 == stretches.size();
    const double until = last ? dearest_simulation : stretches[k + 1].from;
    rows.push_back(
        {{"family", set.family},
         {"price", name_of(prices[price])},
         {"solver", entry.solver},
         {"formulation", entry.formulation},
         {"from", k == 0 ? Json() : Json(stretches[k].from)},
         {"until", last ? Json() : Json(until)},
         {"sure", sureness(spent, price, stretches[k].entry, std::sqrt(stretches[k].from * until),
                           seed_of("break-even", set.family, static_cast<int>(k),
                                   static_cast<int>(price)))}});
  }
  return rows;
}

Json curves_of(const EntrySet& set, const std::vector<Expense>& expenses,
               const std::vector<std::size_t>& drawn) {
  Json curves = Json::array();
  for (const std::size_t e : drawn) {
    Json points = Json::array();
    for (int k = -24; k <= 16; ++k) {
      const double simulation = std::pow(10.0, k / 4.0);
      const double mine = seconds_to_target(expenses[e], simulation, 1);
      double least = mine;
      for (const Expense& other : expenses) {
        least = std::min(least, seconds_to_target(other, simulation, 1));
      }
      points.push_back({{"simulation", simulation}, {"ratio", least > 0 ? mine / least : 1}});
    }
    curves.push_back({{"solver", set.entries[e].solver},
                      {"formulation", set.entries[e].formulation},
                      {"points", std::move(points)}});
  }
  return curves;
}

std::string title_of(const EntrySet& set, const std::vector<Stretch>& stretches) {
  const auto solver = [&](const Stretch& s) { return set.entries[s.entry].solver; };
  if (stretches.size() == 1) {
    return fmt::format("{}: {} is ahead at any cost of a simulation", set.family,
                       solver(stretches.front()));
  }
  return fmt::format("{}: {} is ahead of {} from {} a simulation on", set.family,
                     solver(stretches.back()), solver(stretches[stretches.size() - 2]),
                     seconds_text(stretches.back().from));
}

Json break_even_of(const Campaign& campaign, const EntrySet& set) {
  std::vector<Spent> spent;
  std::vector<std::size_t> all;
  std::vector<double> simulations;
  for (std::size_t q = 0; q < set.problems.size(); ++q) {
    const Problem& problem = campaign.problems()[set.problems[q]];
    spent.push_back(spent_on(problem, set, q));
    all.push_back(q);
    if (std::isfinite(spent[q].simulation)) {
      simulations.push_back(spent[q].simulation / problem.cost);
    }
  }
  Json rows = Json::array();
  Json curves;
  std::string title;
  std::vector<std::size_t> drawn;
  for (std::size_t p = 0; p < prices.size(); ++p) {
    const std::vector<Stretch> stretches = stretches_of(mean_expenses(spent, all, p));
    for (Json& row : rows_of(set, spent, stretches, p)) rows.push_back(std::move(row));
    for (const Stretch& stretch : stretches) {
      if (std::find(drawn.begin(), drawn.end(), stretch.entry) == drawn.end()) {
        drawn.push_back(stretch.entry);
      }
    }
    if (prices[p] == Price::measured) title = title_of(set, stretches);
  }
  constexpr auto measured = static_cast<std::size_t>(Price::measured);
  Json here = Json::array();
  if (!simulations.empty()) here.push_back({{"simulation", mean_cost(simulations)}});
  return {{"family", set.family},
          {"budget", set.budget},
          {"problems", set.problems.size()},
          {"title", title},
          {"here", std::move(here)},
          {"curves", curves_of(set, mean_expenses(spent, all, measured), drawn)},
          {"rows", std::move(rows)}};
}

}  // namespace

Json break_even_data(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  return of_solved(sets, [&](const EntrySet& set) { return break_even_of(campaign, set); });
}

namespace {

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

/// Mean share with its interval: over the problems, or over the runs that differ if there is one
/// problem.
MeanShare share_of(const Entry& entry, const std::vector<double>& shares) {
  if (shares.size() > 1) return mean_share(shares);
  const double distinct = result_of(entry.results.front()->outcomes).distinct;
  return {shares.front(), wilson_interval(shares.front() * distinct, distinct)};
}

/// Adds the median optimality gap with its interval.
void add_optimality_gap(Json& row, const Entry& entry, std::vector<double> optimality_gaps) {
  if (optimality_gaps.size() == 1) {
    optimality_gaps.clear();
    for (const Outcome& outcome : entry.results.front()->outcomes) {
      optimality_gaps.push_back(
          outcome.verdict.optimality_gap.value_or(std::numeric_limits<double>::infinity()));
    }
  }
  row["optimality_gap"] = finite(quantile(optimality_gaps, 0.5));
  const auto interval = order_statistic_interval(optimality_gaps);
  row["optimality_gap_lower"] = interval ? finite(interval->lower) : Json();
  row["optimality_gap_upper"] = interval ? finite(interval->upper) : Json();
}

Json row_of(const Campaign& campaign, const EntrySet& set, const Entry& entry) {
  std::vector<double> evaluations;
  std::vector<double> seconds;
  std::vector<double> shares;
  std::vector<double> optimality_gaps;
  std::size_t runs = 0;
  for (const CellResult* result : entry.results) {
    const OnProblem one = on_problem(campaign, *result);
    evaluations.push_back(one.evaluations);
    seconds.push_back(one.seconds);
    shares.push_back(one.share);
    optimality_gaps.push_back(one.optimality_gap);
    runs += result->outcomes.size();
  }
  const MeanShare share = share_of(entry, shares);
  const bool joint = set.budget == 0;
  Json row = {{"family", set.family},
              {"part", joint ? Json() : Json(set.part + 1)},
              {"budget", joint ? Json() : Json(set.budget)},
              {"largest", set.largest},
              {"solver", entry.solver},
              {"formulation", entry.formulation},
              {"problems", entry.results.size()},
              {"complete", entry.results.size() == set.problems.size()},
              {"runs", runs},
              {"evaluations", mean_cost(evaluations)},
              {"seconds", mean_cost(seconds)},
              {"share", share.mean},
              {"share_lower", share.interval.lower},
              {"share_upper", share.interval.upper},
              {"optimality_gap", nullptr},
              {"optimality_gap_lower", nullptr},
              {"optimality_gap_upper", nullptr},
              {"on_front", false},
              {"on_time_front", false}};
  if (!joint) add_optimality_gap(row, entry, std::move(optimality_gaps));
  return row;
}

/// Marks the rows on the Pareto front.
void mark_front(Json& rows, const char* cost, const char* mark) {
  std::vector<CostAndError> points;
  for (const Json& row : rows) {
    points.push_back({row[cost].get<double>(), 1 - row["share"].get<double>()});
  }
  for (const std::size_t k : pareto_front(points)) rows[k][mark] = true;
}

/// The rows of the entries that take all problems.
Json complete_rows(const Campaign& campaign, const EntrySet& set) {
  Json rows = Json::array();
  for (const Entry& entry : set.entries) rows.push_back(row_of(campaign, set, entry));
  mark_front(rows, "evaluations", "on_front");
  mark_front(rows, "seconds", "on_time_front");
  return rows;
}

std::string spent_text(double cost, bool by_time) {
  return by_time ? fmt::format("{:.2g} ms", 1e3 * cost) : fmt::format("{:.3g} evaluations", cost);
}

/// The Pareto front in words.
std::string title_of(const std::string& name, const Json& front, std::size_t all, bool by_time) {
  const auto about = [&](const Json& dot) {
    return fmt::format("{} ({:.0f} %, {})", dot["solver"].get<std::string>(),
                       100 * dot["share"].get<double>(),
                       spent_text(dot["cost"].get<double>(), by_time));
  };
  const Json& fastest = front.front();
  const Json& surest = front.back();
  if (surest["share"].get<double>() == 0) {
    return fmt::format("{}: none of {} solvers solved a run", name, all);
  }
  if (fastest["cost"] == surest["cost"]) {
    return fmt::format("{}: {} is first in both, of {}", name, about(surest), all);
  }
  // The axis names the cost: with it the title would be too long.
  return fmt::format("{}: {} of {} lead, from {} ({:.0f} %) to {} ({:.0f} %)", name, front.size(),
                     all, fastest["solver"].get<std::string>(),
                     100 * fastest["share"].get<double>(), surest["solver"].get<std::string>(),
                     100 * surest["share"].get<double>());
}

/// Most solvers of a Pareto front that a chart names: the most accurate ones.
constexpr std::size_t most_named = 5;

/// The name beside a dot: of the best few, of the paper's algorithm and of random search.
std::string name_at(const std::string& solver, const Json& front) {
  if (solver == paper_solver) return solver + " (the paper's)";
  if (solver == "random-search") return solver;
  for (std::size_t i = front.size() - std::min(most_named, front.size()); i < front.size(); ++i) {
    if (front[i]["solver"] == solver) return solver;
  }
  return "";
}

/// The dots by the solvers' kinds, each kind with its most accurate solver first; the kinds by
/// name, so that one has the same colour in charts of the same kinds.
Json kinds_of(std::vector<Json> dots, const Json& front) {
  std::map<std::string, Json> kinds;
  std::ranges::stable_sort(dots, std::greater(),
                           [](const Json& dot) { return dot["share"].get<double>(); });
  for (Json& dot : dots) {
    const auto solver = dot["solver"].get<std::string>();
    dot["name"] = name_at(solver, front);
    kinds.try_emplace(kind_of(solver), Json::array()).first->second.push_back(std::move(dot));
  }
  return report::list_of(kinds, [](const auto& kind) {
    return Json{{"kind", kind.first}, {"dots", kind.second}};
  });
}

Json chart_of(const std::string& name, const Json& rows, bool by_time) {
  const char* const cost = by_time ? "seconds" : "evaluations";
  const char* const mark = by_time ? "on_time_front" : "on_front";
  Json front = Json::array();
  std::vector<Json> dots;
  std::size_t level = 0;
  double dearest = 0;
  for (const Json& row : rows) {
    Json dot = {{"solver", row["solver"]},
                {"cost", row[cost]},
                {"share", row["share"]},
                {"lower", row["share_lower"]},
                {"upper", row["share_upper"]}};
    dearest = std::max(dearest, row[cost].get<double>());
    if (row[mark].get<bool>()) front.push_back(dot);
    dots.push_back(std::move(dot));
  }
  std::stable_sort(front.begin(), front.end(), [](const Json& a, const Json& b) {
    return a["cost"].get<double>() < b["cost"].get<double>();
  });
  const double best = front.back()["share"].get<double>();
  for (const Json& row : rows) {
    if (!row[mark].get<bool>() && row["share_upper"].get<double>() >= best) ++level;
  }
  Json steps = front;
  steps.push_back({{"cost", dearest}, {"share", best}});
  return {{"name", fmt::format("speed-accuracy-{}{}", name, by_time ? "-seconds" : "")},
          {"family", name},
          {"about", by_time ? name + ", by time" : name},
          {"title", title_of(name, front, rows.size(), by_time)},
          {"axis", by_time ? "processor time until solved, or in all [s]"
                           : "evaluations for each variable until solved, or in all"},
          {"solvers", rows.size()},
          {"leading", front.size()},
          {"surest", front.back()["solver"]},
          {"level", level},
          {"kinds", kinds_of(std::move(dots), front)},
          {"front", std::move(front)},
          {"steps", std::move(steps)}};
}

}  // namespace

Json speed_accuracy_data(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  Json all = Json::array();
  Json charts = Json::array();
  Json fronts = Json::array();
  const auto add = [&](const EntrySet& set, bool draws_time) {
    Json rows = complete_rows(campaign, set);
    if (set.largest && !rows.empty()) {
      charts.push_back(chart_of(set.family, rows, false));
      if (draws_time) charts.push_back(chart_of(set.family, rows, true));
      for (const Json& row : rows) {
        const bool leads = row["on_front"].get<bool>() || row["on_time_front"].get<bool>();
        // An entry that solves nothing is not worth a row, though none may be cheaper.
        if (!leads || row["share"].get<double>() == 0) continue;
        fronts.push_back(row);
      }
    }
    for (Json& row : rows) all.push_back(std::move(row));
    for (const Entry& entry : set.partial) {
      all.push_back(row_of(campaign, set, entry));
    }
  };
  const EntrySet joint = joint_entry_set(campaign, sets);
  add(joint, true);
  for (const EntrySet& set : sets) add(set, joint.entries.empty());
  return {{"speed_accuracy", std::move(all)},
          {"speed_accuracy_charts", std::move(charts)},
          {"speed_accuracy_front", std::move(fronts)}};
}

}  // namespace ricochet::studies::comparison
