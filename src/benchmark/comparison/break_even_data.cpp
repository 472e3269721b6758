#include "src/studies/contest/break_even_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "src/core/random.h"
#include "src/core/seed.h"
#include "src/statistics/break_even.h"

namespace ricochet::studies::contest {
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

/// Of a gradient beside its value, in evaluations.
double price_on(const Question& question, Price price) {
  const std::int64_t n = question.stated.dimension();
  if (price == Price::free) return 0;
  return static_cast<double>(price == Price::variables ? n : question.gradient_cost.value_or(n));
}

/// What a run asks for until its question is solved; ten times all of it where that never happens.
struct Asked {
  double values = 0, gradients = 0, seconds = 0;
};

Asked asked_by(const StoredStanding& standing) {
  Asked mean;
  const auto runs = static_cast<double>(standing.outcomes.size());
  for (const Outcome& outcome : standing.outcomes) {
    // The ledger does not say what was asked when: a run is taken to ask evenly.
    const double all = std::max<double>(static_cast<double>(outcome.evaluations), 1);
    const double times = outcome.verdict.solved ? evaluations_of(outcome) / all : 10;
    mean.values += times * static_cast<double>(outcome.values) / runs;
    mean.gradients += times * static_cast<double>(outcome.derivatives) / runs;
    mean.seconds += (outcome.verdict.solved ? seconds_of(outcome) : 10 * outcome.seconds) / runs;
  }
  return mean;
}

/// What the entrants spend on one question, for each variable of it.
struct Spent {
  double simulation = infinity;  ///< seconds an evaluation, at most: the least of any entrant
  std::vector<std::array<Expense, prices.size()>> expenses;  ///< of each entrant, at each price
};

Spent spent_on(const Question& question, const Field& field, std::size_t q) {
  const auto variables = static_cast<double>(question.stated.dimension());
  std::vector<Asked> asked;
  Spent spent;
  for (const Entrant& entrant : field.entrants) {
    const Asked& one = asked.emplace_back(asked_by(*entrant.standings[q]));
    const double evaluations = one.values + price_on(question, Price::measured) * one.gradients;
    if (evaluations > 0) spent.simulation = std::min(spent.simulation, one.seconds / evaluations);
  }
  for (const Asked& one : asked) {
    const double evaluations = one.values + price_on(question, Price::measured) * one.gradients;
    const double overhead =
        evaluations > 0 ? std::max(one.seconds - evaluations * spent.simulation, 0.0) : one.seconds;
    auto& at = spent.expenses.emplace_back();
    for (std::size_t p = 0; p < prices.size(); ++p) {
      at[p] = {question.cost * one.values / variables,
               question.cost * price_on(question, prices[p]) * one.gradients / variables,
               overhead / variables};
    }
  }
  return spent;
}

/// Mean over these questions.
std::vector<Expense> mean_expenses(const std::vector<Spent>& all,
                                   const std::vector<std::size_t>& questions, std::size_t price) {
  std::vector<Expense> means(all.front().expenses.size(), Expense{0, 0, 0});
  const auto count = static_cast<double>(questions.size());
  for (const std::size_t q : questions) {
    for (std::size_t e = 0; e < means.size(); ++e) {
      const Expense& one = all[q].expenses[e][price];
      means[e].evaluations += one.evaluations / count;
      means[e].gradients += one.gradients / count;
      means[e].overhead += one.overhead / count;
    }
  }
  return means;
}

/// From this cost of a simulation on this entrant is ahead.
struct Stretch {
  std::size_t entrant;
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
    // Where several are level, the one that is ahead afterwards.
    from = next * (1 + 1e-9);
    const std::size_t after = cheapest_solvers(expenses, {from}, {1})[0][0];
    if (after == ahead) return stretches;
    ahead = after;
  }
}

/// Share of samples of the questions, drawn with replacement, in which this entrant is ahead here.
double sureness(const std::vector<Spent>& spent, std::size_t price, std::size_t entrant,
                double simulation, std::uint64_t seed) {
  Random random(seed);
  int ahead = 0;
  for (int k = 0; k < resamples; ++k) {
    std::vector<std::size_t> drawn(spent.size());
    for (std::size_t& q : drawn) {
      q = static_cast<std::size_t>(uniform(random) * static_cast<double>(spent.size()));
    }
    const auto expenses = mean_expenses(spent, drawn, price);
    if (cheapest_solvers(expenses, {simulation}, {1})[0][0] == entrant) ++ahead;
  }
  return ahead / static_cast<double>(resamples);
}

std::string seconds_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.2g} µs", 1e6 * seconds);
  return seconds < 1 ? fmt::format("{:.2g} ms", 1e3 * seconds) : fmt::format("{:.2g} s", seconds);
}

Json rows_of(const Field& field, const std::vector<Spent>& spent,
             const std::vector<Stretch>& stretches, std::size_t price) {
  Json rows = Json::array();
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const Entrant& entrant = field.entrants[stretches[k].entrant];
    const bool last = k + 1 == stretches.size();
    const double until = last ? dearest_simulation : stretches[k + 1].from;
    rows.push_back(
        {{"family", field.family},
         {"price", name_of(prices[price])},
         {"solver", entrant.solver},
         {"form", entrant.form},
         {"from", k == 0 ? Json() : Json(stretches[k].from)},
         {"until", last ? Json() : Json(until)},
         {"sure", sureness(spent, price, stretches[k].entrant, std::sqrt(stretches[k].from * until),
                           seed_of("break-even", field.family, static_cast<int>(k),
                                   static_cast<int>(price)))}});
  }
  return rows;
}

Json curves_of(const Field& field, const std::vector<Expense>& expenses,
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
    curves.push_back({{"solver", field.entrants[e].solver},
                      {"form", field.entrants[e].form},
                      {"points", std::move(points)}});
  }
  return curves;
}

std::string title_of(const Field& field, const std::vector<Stretch>& stretches) {
  const auto solver = [&](const Stretch& s) { return field.entrants[s.entrant].solver; };
  if (stretches.size() == 1) {
    return fmt::format("{}: {} is ahead at any cost of a simulation", field.family,
                       solver(stretches.front()));
  }
  return fmt::format("{}: {} is ahead of {} from {} a simulation on", field.family,
                     solver(stretches.back()), solver(stretches[stretches.size() - 2]),
                     seconds_text(stretches.back().from));
}

Json break_even_of(const Campaign& campaign, const Field& field) {
  std::vector<Spent> spent;
  std::vector<std::size_t> all;
  std::vector<double> simulations;
  for (std::size_t q = 0; q < field.questions.size(); ++q) {
    const Question& question = campaign.questions()[field.questions[q]];
    spent.push_back(spent_on(question, field, q));
    all.push_back(q);
    if (std::isfinite(spent[q].simulation)) {
      simulations.push_back(spent[q].simulation / question.cost);
    }
  }
  Json rows = Json::array();
  Json curves;
  std::string title;
  std::vector<std::size_t> drawn;
  for (std::size_t p = 0; p < prices.size(); ++p) {
    const std::vector<Stretch> stretches = stretches_of(mean_expenses(spent, all, p));
    for (Json& row : rows_of(field, spent, stretches, p)) rows.push_back(std::move(row));
    for (const Stretch& stretch : stretches) {
      if (std::find(drawn.begin(), drawn.end(), stretch.entrant) == drawn.end()) {
        drawn.push_back(stretch.entrant);
      }
    }
    if (prices[p] == Price::measured) title = title_of(field, stretches);
  }
  constexpr auto measured = static_cast<std::size_t>(Price::measured);
  Json here = Json::array();
  if (!simulations.empty()) here.push_back({{"simulation", mean_cost(simulations)}});
  return {{"family", field.family},
          {"budget", field.budget},
          {"questions", field.questions.size()},
          {"title", title},
          {"here", std::move(here)},
          {"curves", curves_of(field, mean_expenses(spent, all, measured), drawn)},
          {"rows", std::move(rows)}};
}

}  // namespace

Json break_even_data(const Campaign& campaign, const std::vector<Field>& fields) {
  return of_compared(fields, [&](const Field& field) { return break_even_of(campaign, field); });
}

}  // namespace ricochet::studies::contest
