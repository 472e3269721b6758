#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
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

using report::Chart;
using report::Mark;
using report::Range;
using report::Scale;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double cheapest_simulation = 1e-6;  // [s], ends of what is looked at
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
      at[p] = {
          problem.cost * (one.values + price_on(problem, prices[p]) * one.gradients) / variables,
          overhead / variables};
    }
  }
  return spent;
}

/// Mean over the problems.
std::vector<Expense> mean_expenses(const std::vector<Spent>& all,
                                   const std::vector<std::size_t>& problems, std::size_t price) {
  std::vector<Expense> means(all.front().expenses.size(), Expense{0, 0});
  const auto count = static_cast<double>(problems.size());
  for (const std::size_t q : problems) {
    for (std::size_t e = 0; e < means.size(); ++e) {
      const Expense& one = all[q].expenses[e][price];
      means[e].simulations += one.simulations / count;
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
  std::size_t ahead = cheapest_solver(expenses, from);
  while (true) {
    stretches.push_back({ahead, from});
    double next = dearest_simulation;
    for (const Expense& other : expenses) {
      const auto level = break_even_simulation(expenses[ahead], other);
      if (level && *level > from) next = std::min(next, *level);
    }
    if (next >= dearest_simulation) return stretches;
    // If several entries are level, take the one that is ahead just above this cost.
    from = next * (1 + 1e-9);
    const std::size_t after = cheapest_solver(expenses, from);
    if (after == ahead) return stretches;
    ahead = after;
  }
}

/// Returns the share of bootstrap samples of the clusters of problems in which this entry is ahead
/// here.
double sureness(const std::vector<Spent>& spent,
                const std::vector<std::vector<std::size_t>>& clusters, std::size_t price,
                std::size_t entry, double simulation, std::uint64_t seed) {
  Random random(seed);
  int ahead = 0;
  for (int k = 0; k < resamples; ++k) {
    std::vector<std::size_t> drawn;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      const double place = uniform(random) * static_cast<double>(clusters.size());
      const auto& cluster = clusters[static_cast<std::size_t>(place)];
      drawn.insert(drawn.end(), cluster.begin(), cluster.end());
    }
    const auto expenses = mean_expenses(spent, drawn, price);
    if (cheapest_solver(expenses, simulation) == entry) ++ahead;
  }
  return ahead / static_cast<double>(resamples);
}

void add_rows(Table& table, const EntrySet& set, const std::vector<Spent>& spent,
              const std::vector<std::vector<std::size_t>>& clusters,
              const std::vector<Stretch>& stretches, std::size_t price) {
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const Entry& entry = set.entries[stretches[k].entry];
    const bool last = k + 1 == stretches.size();
    const double until = last ? dearest_simulation : stretches[k + 1].from;
    table.add(
        name_of(prices[price]), k == 0 ? Value() : value_of(stretches[k].from),
        last ? Value() : value_of(until), entry.solver, entry.formulation,
        sureness(spent, clusters, price, stretches[k].entry, std::sqrt(stretches[k].from * until),
                 seed_of("break-even", set.family, static_cast<int>(k), static_cast<int>(price))));
  }
}

}  // namespace

void add_break_even(const Campaign& campaign, const EntrySet& set, report::Results& page) {
  std::vector<Spent> spent;
  std::vector<std::size_t> all;
  std::vector<std::string> clusters;
  std::vector<double> simulations;
  for (std::size_t q = 0; q < set.problems.size(); ++q) {
    const Problem& problem = campaign.problems()[set.problems[q]];
    spent.push_back(spent_on(problem, set, q));
    all.push_back(q);
    clusters.push_back(cluster_of(problem));
    if (std::isfinite(spent[q].simulation)) {
      simulations.push_back(spent[q].simulation / problem.cost);
    }
  }
  Table table{"break-even",
              {{"price", "price of a gradient"},
               {"from", "from [s]", ".2g", 3},
               {"until", "until [s]", ".2g", 3},
               {"solver", "ahead"},
               {"formulation"},
               {"sure", "confidence [%]", ".0%", 3}}};
  const auto places = places_by_cluster(clusters);
  for (std::size_t p = 0; p < prices.size(); ++p) {
    add_rows(table, set, spent, places, stretches_of(mean_expenses(spent, all, p)), p);
  }
  page.set("here", simulations.empty() ? Value() : value_of(mean_cost(simulations)));
  page.add(std::move(table));
}

namespace {

/// Mean share with its interval: over the clusters of problems, or over the runs that differ if
/// there is one problem.
MeanShare share_of(const Campaign& campaign, const Entry& entry,
                   const std::vector<double>& shares) {
  if (shares.size() > 1) return mean_share(shares, clusters_of(campaign, entry));
  const double distinct = result_of(entry.results.front()->outcomes).distinct;
  return {shares.front(), wilson_interval(shares.front() * distinct, distinct)};
}

void add_row(Table& table, const Campaign& campaign, const EntrySet& set, const Entry& entry) {
  std::vector<double> evaluations, seconds, shares;
  std::size_t runs = 0;
  for (const CellResult* result : entry.results) {
    const OnProblem one = on_problem(campaign, *result);
    evaluations.push_back(one.evaluations);
    seconds.push_back(one.seconds);
    shares.push_back(one.share);
    runs += result->outcomes.size();
  }
  const MeanShare share = share_of(campaign, entry, shares);
  const bool joint = set.budget == 0;
  table.add(
      set.family, joint ? Value() : value_of(set.part + 1), joint ? Value() : value_of(set.budget),
      set.largest, entry.solver, kind_of(entry.solver), entry.formulation, entry.results.size(),
      entry.results.size() == set.problems.size(), runs, mean_cost(evaluations), mean_cost(seconds),
      share.mean, share.interval.lower, share.interval.upper, false, false);
}

/// Marks the complete rows on the Pareto front, from `first` on.
void mark_front(Table& table, std::size_t first, const char* cost, const char* mark) {
  std::vector<CostAndError> points;
  std::vector<std::size_t> places;
  for (std::size_t i = first; i < table.rows.size(); ++i) {
    if (!table[i].is("complete")) continue;
    points.push_back({table[i].number(cost), 1 - table[i].number("share")});
    places.push_back(i);
  }
  for (const std::size_t k : pareto_front(points)) {
    table.rows[places[k]][table.index_of(mark)] = true;
  }
}

/// The Pareto front in words.
std::string title_of(const std::string& name, const Table& front, std::size_t all, bool by_time) {
  const Row fastest = front[0], surest = front[front.rows.size() - 1];
  const char* const cost = by_time ? "seconds" : "evaluations";
  const double spent = surest.number(cost);
  if (surest.number("share") == 0) {
    return fmt::format("{}: none of {} solvers solved a run", name, all);
  }
  if (fastest.number(cost) == spent) {
    return fmt::format(
        "{}: {} ({:.0f} %, {}) solves most, at least cost, of {}", name, surest.text("solver"),
        100 * surest.number("share"),
        by_time ? fmt::format("{:.2g} ms", 1e3 * spent) : fmt::format("{:.3g} evaluations", spent),
        all);
  }
  // The axis names the cost: with it the title would be too long.
  return fmt::format("{}: {} of {} lead, from {} ({:.0f} %) to {} ({:.0f} %)", name,
                     front.rows.size(), all, fastest.text("solver"), 100 * fastest.number("share"),
                     surest.text("solver"), 100 * surest.number("share"));
}

/// Most solvers of a Pareto front that a chart names: the most accurate ones.
constexpr std::size_t most_named = 5;

/// The name beside a dot: of the best few, of the paper's algorithm and of random search.
std::string name_at(const std::string& solver, const Table& front) {
  if (solver == paper_solver) return solver + " (the paper's)";
  if (solver == "random-search") return solver;
  const std::size_t all = front.rows.size();
  for (std::size_t i = all - std::min(most_named, all); i < all; ++i) {
    if (front[i].text("solver") == solver) return solver;
  }
  return "";
}

}  // namespace

Table speed_accuracy_table(const Campaign& campaign, const std::vector<EntrySet>& sets) {
  Table table{"speed-accuracy",
              {{"family"},
               {"part"},
               {"budget", "evaluations a variable"},
               {"largest"},
               {"solver"},
               {"kind"},
               {"formulation"},
               {"problems"},
               {"complete"},
               {"runs"},
               {"evaluations", "evaluations until solved", ".3g", 4},
               {"seconds", "seconds until solved", ".2g", 3},
               {"share", "success rate [%]", ".0%", 3},
               {"lower", "", ".0%", 3},
               {"upper", "", ".0%", 3},
               {"on_front", "on the front", "mark"},
               {"on_time_front", "on the front by time", "mark"}}};
  const auto add = [&](const EntrySet& set) {
    const std::size_t first = table.rows.size();
    each_entry(set, [&](const Entry& entry) { add_row(table, campaign, set, entry); });
    mark_front(table, first, "evaluations", "on_front");
    mark_front(table, first, "seconds", "on_time_front");
  };
  add(joint_entry_set(campaign, sets));
  for (const EntrySet& set : sets) add(set);
  return table;
}

Chart speed_accuracy_chart(const Table& of_family, bool by_time) {
  const char* const cost = by_time ? "seconds" : "evaluations";
  const Table rows = where(of_family, "complete", true);
  const Table front = sorted(where(rows, by_time ? "on_time_front" : "on_front", true), {cost});
  const std::string name = rows[0].text("family");
  Chart chart{.name = by_time ? "speed-accuracy-seconds" : "speed-accuracy",
              .title = title_of(name, front, rows.rows.size(), by_time),
              .x = {by_time ? "processor time until solved, or in all [s]"
                            : "evaluations for each variable until solved, or in all",
                    Scale::logarithmic},
              .y = {"success rate [%]", Scale::linear, Range{0, 100}},
              .series = {{"", Mark::steps, {}, true}},
              .width = 820,
              .height = 480};
  double dearest = 0;
  each_row(rows, [&](const Row& row) { dearest = std::max(dearest, row.number(cost)); });
  auto& steps = chart.series.front().samples;
  std::string leading;
  each_row(front, [&](const Row& row) {
    steps.push_back({row.number(cost), 100 * row.number("share")});
    leading += fmt::format("{}{} {:.0f} %", leading.empty() ? "" : ", ", row.text("solver"),
                           100 * row.number("share"));
  });
  steps.push_back({dearest, steps.back().value});
  chart.description = fmt::format("Success rate against {}, one dot per solver. Pareto front: {}.",
                                  chart.x.label, leading);
  // The kinds by name, so that one has the same colour in charts of the same kinds.
  each_row(sorted(rows, {"kind", "-share"}), [&](const Row& row) {
    if (chart.series.back().label != row.text("kind")) {
      chart.series.push_back({row.text("kind"), Mark::points, {}});
    }
    chart.series.back().samples.push_back(
        {row.number(cost), 100 * row.number("share"),
         Range{100 * row.number("lower"), 100 * row.number("upper")},
         name_at(row.text("solver"), front)});
  });
  return chart;
}

Table kind_table(const Table& of_family) {
  const Table rows = sorted(where(of_family, "complete", true), {"-share", "evaluations"});
  const auto first = [](const std::vector<Value>& values) { return values.front(); };
  Table table = aggregated(rows, {"kind"},
                           {{{"solvers"}, "", count_of},
                            {{"best", "solves most of its kind"}, "solver", first},
                            {{"share", "success rate [%]", ".0%", 3}, "share", first},
                            {{"lower", "", ".0%", 3}, "lower", first},
                            {{"upper", "", ".0%", 3}, "upper", first}});
  table.name = "kinds";
  return table;
}

std::optional<std::string> paper_algorithm_sentence(const Table& of_family) {
  const Table rows = sorted(where(of_family, "complete", true), {"-share", "evaluations"});
  const auto own = rows.find([](const Row& row) { return row.text("solver") == paper_solver; });
  const auto drawn =
      rows.find([](const Row& row) { return row.text("solver") == "random-search"; });
  if (!own || !drawn) return {};
  const Table variants =
      where(rows, [](const Row& row) { return row.text("solver").starts_with(paper_solver); });
  const auto rate = [](const Row& row) {
    return fmt::format("{:.0f} % [{:.0f}, {:.0f}]", 100 * row.number("share"),
                       100 * row.number("lower"), 100 * row.number("upper"));
  };
  const std::string family = own->text("family");
  std::string text = fmt::format(
      "The paper's algorithm ({}) is {} than random search on {} ({:.0f} problems): it solves {} "
      "of "
      "the runs, random search {}.",
      paper_solver,
      own->number("lower") > drawn->number("upper")   ? "better"
      : own->number("upper") < drawn->number("lower") ? "worse"
                                                      : "not measurably better",
      family == "all" ? "the families that most solvers take" : family, own->number("problems"),
      rate(*own), rate(*drawn));
  if (variants.rows.size() > 1) {
    text += fmt::format(" Of its {} variants {} solves most, {}.", variants.rows.size(),
                        variants[0].text("solver"), rate(variants[0]));
  }
  return text;
}

std::string front_sentence(const Table& of_family) {
  const Table rows = where(of_family, "complete", true);
  const Table front = sorted(where(rows, "on_front", true), {"evaluations"});
  const Row surest = front[front.rows.size() - 1];
  const Table level = where(rows, [&](const Row& row) {
    return !row.is("on_front") && row.number("upper") >= surest.number("share");
  });
  return fmt::format(
      "{} of {} solvers are on the Pareto front; {} more {} statistically tied with "
      "the most accurate, {}.",
      front.rows.size(), rows.rows.size(), level.rows.size(), level.rows.size() == 1 ? "is" : "are",
      surest.text("solver"));
}

}  // namespace ricochet::studies::comparison
