#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "src/analysis/comparison/view.h"

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
  const ViewRun solved = view_run(outcome_with(0.5, {{3, 0, 20}, {7, 0, 10}, {40, 0, 0.5}}), six);
  EXPECT_EQ(solved.missing, 0);
  EXPECT_EQ(solved.times, (std::vector<std::int64_t>{7, 40, 40}));
  const ViewRun near = view_run(outcome_with(3, {{3, 0, 20}, {7, 0, 10}, {40, 0, 3}}), six);
  EXPECT_EQ(near.missing, 2);
  EXPECT_EQ(near.times, (std::vector<std::int64_t>{7, 40}));
  EXPECT_EQ(near.evaluations, 100);
  const ViewRun far = view_run(outcome_with(20, {{3, 0, 20}, {7, 0, 0.5}}), six);
  EXPECT_EQ(far.missing, 5) << "by the returned point";
  EXPECT_TRUE(far.times.empty());
  EXPECT_EQ(view_run(outcome_with(40, {{7, 0, 40}}), six).missing, 6);
  EXPECT_EQ(view_run(outcome_with(std::nullopt, {}), six).missing, 7) << "no feasible point";
}

TEST(ViewRun, SolvesAProblemOfOneTargetOnEveryLevelOrNone) {
  const ViewRun solved = view_run(outcome_with(1, {{9, 0, 1}}), {1});
  EXPECT_EQ(solved.times, (std::vector<std::int64_t>{9, 9, 9}));
  EXPECT_EQ(view_run(outcome_with(2, {{9, 0, 2}}), {1}).missing, 1);
}

TEST(ViewRun, TakesThirdsOfTheTargetsRoundedUp) {
  EXPECT_EQ(targets_at(0, 51), 17);
  EXPECT_EQ(targets_at(1, 51), 34);
  EXPECT_EQ(targets_at(2, 51), 51);
  EXPECT_EQ(targets_at(0, 4), 2);
  EXPECT_EQ(targets_at(1, 4), 3);
}

TEST(ViewRunsText, IsThisOfTheseRuns) {
  ViewRunsWriter runs;
  runs.add({0, {1, 31, 32}, 100}, 100);  // B, e (30), B
  runs.add({63, {}, 100}, 100);          // the digit 63, then 0
  runs.add({2, {33, 1057}, 90}, 100);    // 33 = 1 + 1 * 32; 1024 = 0, 0, 1
  runs.add({1, {0, 0}, 103}, 100);       // after none that was whole; 3 beyond: 5
  EXPECT_EQ(runs.text().missing, "A/ACB");
  EXPECT_EQ(runs.text().times, "BeBhBggBAA");
  EXPECT_EQ(runs.text().spent, "BUAF");
  EXPECT_EQ(runs.text().repeats, "");
  runs.add({0, {1, 1, 1}, 100, true}, 100);
  runs.add({0, {1, 1, 1}, 100, true}, 100);
  EXPECT_EQ(runs.text().repeats, "EA");
}

/// Reads digits by arithmetic on the characters, in place of a table.
class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  int digit() {
    const char c = text_.at(at_++);
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : 63;
  }

  std::int64_t number() {
    std::int64_t bits = 0;
    for (int shift = 0;; shift += 5) {
      const int next = digit();
      bits |= static_cast<std::int64_t>(next & 31) << shift;
      if ((next & 32) == 0) return bits;
    }
  }

  bool ended() const { return at_ == text_.size(); }

 private:
  std::string text_;
  std::size_t at_ = 0;
};

TEST(ViewRunsText, GivesEveryRunBack) {
  std::mt19937 random(7);
  const auto below = [&](int end) {
    return static_cast<std::int64_t>(random() % static_cast<unsigned>(end));
  };
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
  Reader missing(writer.text().missing), times(writer.text().times);
  Reader spent(writer.text().spent), repeats(writer.text().repeats);
  std::int64_t single = repeats.number();
  std::int64_t whole = spent.number();
  for (const ViewRun& run : runs) {
    std::int64_t left_out = missing.digit();
    if (left_out == 63) left_out += missing.number();
    EXPECT_EQ(left_out, run.missing);
    EXPECT_EQ(single == 0, run.repeats);
    single = single != 0 ? single - 1 : repeats.ended() ? -1 : repeats.number();
    std::int64_t time = 0;
    for (const std::int64_t own : run.times) EXPECT_EQ(time += times.number(), own);
    if (run.missing == 0) continue;
    std::int64_t evaluations = budget;
    if (whole-- == 0) {
      const std::int64_t code = spent.number();
      evaluations += code % 2 == 0 ? -code / 2 : (code + 1) / 2;
      whole = spent.ended() ? -1 : spent.number();
    }
    EXPECT_EQ(evaluations, run.evaluations);
  }
  EXPECT_TRUE(missing.ended());
  EXPECT_TRUE(times.ended());
  EXPECT_TRUE(spent.ended());
  EXPECT_TRUE(repeats.ended());
}

}  // namespace
}  // namespace ricochet::studies::comparison
