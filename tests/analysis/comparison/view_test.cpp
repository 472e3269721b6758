#include "src/analysis/comparison/view.h"

#include "tests/analysis/comparison/made_up_results.h"

namespace ricochet::studies::comparison {
namespace {

using ricochet::comparison::Outcome;
using ricochet::comparison::Targets;

const Targets six = {1, 2, 4, 8, 16, 32};

/// A run that returned a point with this gap, after steps to it; solved if the gap is at most 1.
Outcome outcome_with(std::optional<double> gap, std::vector<ricochet::comparison::Step> steps) {
  Outcome outcome;
  outcome.evaluations = 100;
  outcome.verdict.returned_optimality_gap = gap;
  outcome.verdict.returned_solved = gap && *gap <= 1;
  outcome.steps = std::move(steps);
  for (const auto& step : outcome.steps) {
    if (step.optimality_gap > 1 || outcome.verdict.evaluations_to_solve) continue;
    outcome.verdict.evaluations_to_solve = step.evaluations;
  }
  return outcome;
}

TEST(ViewRun, HasTheTimesOfTheLevelsThatTheReturnedPointReaches) {
  EXPECT_THAT(view_run(outcome_with(0.5, {{3, 0, 20}, {7, 0, 10}, {40, 0, 0.5}}), six),
              FieldsAre(0, ElementsAre(7, 40, 40), 100, false));
  EXPECT_THAT(view_run(outcome_with(3, {{3, 0, 20}, {7, 0, 10}, {40, 0, 3}}), six),
              FieldsAre(2, ElementsAre(7, 40), 100, false));
  EXPECT_THAT(view_run(outcome_with(20, {{3, 0, 20}, {7, 0, 0.5}}), six),
              FieldsAre(5, ElementsAre(), 100, false))
      << "by the returned point";
  EXPECT_EQ(view_run(outcome_with(40, {{7, 0, 40}}), six).missing, 6);
  EXPECT_EQ(view_run(outcome_with(std::nullopt, {}), six).missing, 7) << "no feasible point";
  // A problem of one target is solved on every level or none.
  EXPECT_THAT(view_run(outcome_with(1, {{9, 0, 1}}), {1}).times, ElementsAre(9, 9, 9));
  EXPECT_EQ(view_run(outcome_with(2, {{9, 0, 2}}), {1}).missing, 1);
  EXPECT_EQ(targets_at(0, 4), 2) << "thirds are rounded up";
  EXPECT_EQ(targets_at(1, 4), 3);
}

/// Takes a digit off the text: by arithmetic on the character, in place of a table.
int take_digit(std::string_view& text) {
  const char c = text.at(0);
  text.remove_prefix(1);
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : 63;
}

std::int64_t take_number(std::string_view& text) {
  std::int64_t bits = 0;
  for (int shift = 0;; shift += 5) {
    const int next = take_digit(text);
    bits |= static_cast<std::int64_t>(next & 31) << shift;
    if ((next & 32) == 0) return bits;
  }
}

TEST(ViewRunsText, GivesEveryRunBack) {
  std::mt19937 random(7);
  const auto below = [&](unsigned end) { return static_cast<std::int64_t>(random() % end); };
  constexpr std::int64_t budget = 5000;
  constexpr std::size_t targets = 90;
  std::vector<ViewRun> runs;
  ViewRunsWriter writer;
  for (int k = 0; k < 2000; ++k) {
    ViewRun run{below(3) == 0 ? 0 : below(targets + 1), {}, budget};
    for (int level = 0; level < view_levels; ++level) {
      if (static_cast<std::int64_t>(targets) - run.missing < targets_at(level, targets)) break;
      run.times.push_back((run.times.empty() ? 0 : run.times.back()) + below(1500));
    }
    if (below(4) == 0) run.evaluations += below(300) - 200;
    run.repeats = below(3) == 0;
    writer.add(run, budget);
    runs.push_back(run);
  }
  const ViewRunsText& text = writer.text();
  std::string_view missing = text.missing, times = text.times, spent = text.spent;
  std::string_view repeats = text.repeats;
  std::int64_t single = take_number(repeats), whole = take_number(spent);
  for (const ViewRun& run : runs) {
    std::int64_t left_out = take_digit(missing);
    if (left_out == 63) left_out += take_number(missing);
    EXPECT_EQ(left_out, run.missing);
    EXPECT_EQ(single == 0, run.repeats);
    single = single != 0 ? single - 1 : repeats.empty() ? -1 : take_number(repeats);
    std::int64_t time = 0;
    for (const std::int64_t own : run.times) EXPECT_EQ(time += take_number(times), own);
    if (run.missing == 0) continue;
    std::int64_t evaluations = budget;
    if (whole-- == 0) {
      const std::int64_t code = take_number(spent);
      evaluations += code % 2 == 0 ? -code / 2 : (code + 1) / 2;
      whole = spent.empty() ? -1 : take_number(spent);
    }
    EXPECT_EQ(evaluations, run.evaluations);
  }
  EXPECT_THAT((std::array{missing, times, spent, repeats}), Each(IsEmpty()));
}

/// In each group the runs that are alike, the first of the order first.
using Orders = std::map<RankedTogether, std::vector<std::vector<std::size_t>>>;

/// From the bits of their order, the group of each run being known.
Orders orders_in(std::string_view text, const std::vector<RankedTogether>& groups) {
  std::vector<int> digits;
  while (!text.empty()) digits.push_back(take_digit(text));
  std::size_t at = 0;
  Orders orders;
  for (std::size_t run = 0; run < groups.size(); ++run) {
    auto& values = orders[groups[run]];
    std::size_t position = 0;
    for (std::size_t weight = 1; weight <= 2 * values.size(); weight *= 2, ++at) {
      position += weight * (static_cast<unsigned>(digits.at(at / 6)) >> (at % 6) & 1U);
    }
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(position / 2);
    if (position % 2 == 1) {
      place->push_back(run);
    } else {
      values.insert(place, {run});
    }
  }
  EXPECT_EQ(digits.size(), (at + 5) / 6);
  return orders;
}

TEST(ViewOrderText, GivesTheOrderBack) {
  std::mt19937 random(3);
  for (const unsigned many : {3U, 40U, 1000U}) {
    ViewOrderWriter order;
    std::vector<RankedTogether> groups;
    std::map<RankedTogether, std::map<std::pair<double, double>, std::vector<std::size_t>>> sorted;
    for (std::size_t k = 0; k < 400; ++k) {
      groups.emplace_back(random() % 2, random() % 2, random() % 2);
      const auto drawn = static_cast<double>(random() % many);
      const double value = k % 50 == 0 ? infinity : drawn, cost = random() % 2 == 0 ? 1 : 2;
      order.add(groups.back(), {value, cost});
      sorted[groups.back()][{value, cost}].push_back(k);
    }
    Orders expected;
    for (const auto& [group, values] : sorted) {
      for (const auto& [reached, runs] : values) expected[group].push_back(runs);
    }
    EXPECT_EQ(orders_in(order.text(), groups), expected);
  }
}

/// Of runs of which the k-th solves "bowl-1" after k evaluations; the others spend 90.
report::Results view_of(const std::string& plan) {
  const MadeUp made(plan, [](const PlannedCell& cell) {
    std::vector<Outcome> runs;
    for (int k = 1; k <= cell.instances * cell.seeds; ++k) {
      runs.push_back(cell.cell.problem == "bowl-1" ? run_of(k) : run_of({}));
      runs.back().evaluations = 90;
      if (!runs.back().solved()) runs.back().verdict.returned_optimality_gap = 1e9;
    }
    return runs;
  });
  return view_page(made.campaign, made.results, made.reported, made.sets(),
                   {made.campaign.solvers().front()});
}

TEST(ViewData, HasEveryRunOfAnEntryAndItsNames) {
  const report::Results view = view_of(two_runs(both_bowls, "chance-*"));
  EXPECT_THAT(rows_of(*view.table("view-solvers"), "solver,outside"),
              ElementsAre("chance-a | no", "chance-b | yes"))
      << "none of those that are known";
  // They take all problems; the last run is the one before it again.
  const Table& entries = *view.table("view-entries");
  EXPECT_THAT(rows_of(entries, "solver,budget,instances,problems,times,repeats"),
              ElementsAre("0 | 100 | 2 |  | BAACAA | D", "1 | 100 | 2 |  | BAACAA | D"));
  EXPECT_EQ(*view.value("first_instance"), Value(std::int64_t{1}));
  EXPECT_THAT(rows_of(*view.table("view-problems"), "problem"), ElementsAre("bowl-1", "bowl-2"));
  // Two runs that miss nothing, then two that miss all targets, of which each left 10 or 110.
  EXPECT_THAT(entries[1].text("missing"), StartsWith("AA"));
  EXPECT_THAT(entries[1].text("spent"), StartsWith("A"));
  // On bowl-2 each run equals that of the entry before it: 1, in two bits, twice.
  EXPECT_THAT(rows_of(*view.table("view-orders"), "order"), ElementsAre("F"));
}

TEST(ViewData, SaysWhichProblemsAnEntryTakesIfNotAll) {
  const report::Results view =
      view_of(two_runs(both_bowls, "chance-*") +
              part_of(both_bowls, "name = \"more\"\nbudgets = [10]\ninstances = 1") +
              part_of("[\"bowl-2\"]", "name = \"again\"\nsolvers = \"chance-b\"\ninstances = 1"));
  EXPECT_THAT(rows_of(*view.table("view-families"), "family,problems"),
              ElementsAre("bowl | 0 1", "bowl-more | 0 1", "bowl-again | 1"));
  const report::Results mixed =
      view_of(part_of(both_bowls, "instances = 1") +
              part_of("[\"bowl-2\"]", "name = \"b\"\nsolvers = [\"*\"]\ninstances = 2"));
  std::string taken;
  each_row(*mixed.table("view-entries"), [&](const Row& entry) {
    if (entry.number("family") == 0) taken += entry.text("problems") + ";";
  });
  EXPECT_EQ(taken, "10;01;") << "runs of other numbers are other entries";
}

}  // namespace
}  // namespace ricochet::studies::comparison
