#include "src/analysis/outcomes.h"

#include "tests/analysis/held_campaign.h"

namespace ricochet::comparison {
namespace {

using testing::_;

std::vector<int> instances_of(const Outcomes& outcomes) {
  std::vector<int> instances;
  for (const Outcome& outcome : outcomes) instances.push_back(outcome.instance);
  return instances;
}

TEST(Outcomes, AreEveryKthOfThemAndOfThose) {
  EXPECT_TRUE(Outcomes().empty());
  EXPECT_THAT(instances_of(Outcomes()), IsEmpty());
  Outcomes second_seeds;
  {
    std::vector<Outcome> twelve(12);
    int number = 0;
    for (Outcome& outcome : twelve) outcome.instance = number++;
    const Outcomes all = twelve;
    EXPECT_EQ(all.size(), 12U);
    second_seeds = all.every(3, 1, 4);
    EXPECT_EQ(&second_seeds[2], &all[7]) << "they are shared";
  }
  EXPECT_THAT(instances_of(second_seeds), ElementsAre(1, 4, 7, 10)) << "and outlive the others";
  EXPECT_THAT(instances_of(second_seeds.every(2, 1, 2)), ElementsAre(4, 10));
  EXPECT_EQ(second_seeds.front().instance, 1);
}

TEST(Outcome, KeepsFeasibleImprovementsExitsAndWhatWasThrown) {
  RunRecord record;
  record.instance = 3;
  record.ledger.charged = 20;
  record.trace = {{1, 0.1, {0.25, 1.0}, {}}, {4, 0.2, {0.5, 0}, {}}, {9, 0.3, {0, 0}, {}}};
  record.terminations = {{"lost"}, {"done"}};
  record.failure = "broken";
  const Outcome outcome = outcome_of(record, valley(0), 0.1);
  EXPECT_EQ(outcome.instance, 3);
  EXPECT_EQ(outcome.evaluations, 20);
  EXPECT_THAT(outcome.steps, ElementsAre(FieldsAre(4, 0.2, 0.5), FieldsAre(9, 0.3, 0)))
      << "the first point was not feasible";
  EXPECT_EQ(outcome.terminations, (std::vector<Reason>{"lost", "done"}));
  EXPECT_EQ(outcome.failure, "broken");
  EXPECT_EQ(outcome.verdict.evaluations_to_solve, 9);
}

/// A run of 20 evaluations whose gaps fall to 1, that returned a point with this gap, if any.
Outcome falling(std::optional<double> returned = {}) {
  Outcome outcome;
  outcome.evaluations = 20;
  outcome.seconds = 2;
  outcome.steps = {{2, 0.2, 9}, {5, 0.5, 4}, {8, 0.8, 1}};
  outcome.verdict.optimality_gap = 1;
  outcome.verdict.returned_optimality_gap = returned;
  return outcome;
}

TEST(Outcome, HasTheStepsThatLedToTheReturnedPoint) {
  EXPECT_THAT(steps_of(falling()), IsEmpty()) << "it returned nothing";
  EXPECT_THAT(reached_by(falling()), FieldsAre(infinity, infinity));
  EXPECT_EQ(falling().optimality_gap(), infinity);
  EXPECT_THAT(steps_of(falling(6)), ElementsAre(FieldsAre(2, _, 9), FieldsAre(5, _, 6)))
      << "the first point that is as good";
  EXPECT_THAT(reached_by(falling(6)), FieldsAre(6, 5));
  EXPECT_EQ(falling(6).optimality_gap(), 6);
  EXPECT_THAT(steps_of(falling(0.5)), ElementsAre(FieldsAre(2, _, 9), FieldsAre(5, _, 4),
                                                  FieldsAre(8, _, 1), FieldsAre(20, _, 0.5)))
      << "better than all that it evaluated";
}

TEST(Outcome, IsSolvedByWhatItReturned) {
  Outcome outcome = falling(0.9);
  outcome.verdict.solved = true;
  outcome.verdict.evaluations_to_solve = 8;
  outcome.verdict.seconds_to_solve = 0.8;
  for (const bool returned : {false, true}) {
    outcome.verdict.returned_solved = returned;
    EXPECT_EQ(outcome.solved(), returned);
    EXPECT_EQ(evaluations_until_solved(outcome), returned ? 8 : 20);
    EXPECT_EQ(seconds_until_solved(outcome), returned ? 0.8 : 2);
    EXPECT_EQ(evaluations_until_solved(outcome, Criterion::evaluated), 8);
  }
  EXPECT_THAT(reached_by(outcome), FieldsAre(0, 8)) << "accuracy beyond the tolerance is nothing";
}

/// A valley whose true values are these.
Problem valley_of(const std::function<TrueValues(const Vector&)>& true_values) {
  Problem problem = valley_problem();
  problem.true_values = true_values;
  return problem;
}

TEST(Targets, OfACountAreAllLevelsBelowThatOfARandomPoint) {
  const auto targets = [](double count) {
    Problem problem = valley_of([count](const Vector&) { return TrueValues{count, 0}; });
    problem.tolerance = 0.5;
    problem.best_known = 3;
    return targets_of(problem);
  };
  EXPECT_THAT(targets(7), ElementsAre(0.5, 1.5, 2.5, 3.5));
  EXPECT_THAT(targets(4), ElementsAre(0.5));
  EXPECT_THAT(targets(3), ElementsAre(0.5)) << "a random point solves it";
  EXPECT_EQ(targets(203).size(), 200U);
}

TEST(Targets, OfOtherObjectivesAre51EvenOnALogarithmicScale) {
  Problem problem = valley_problem();
  const Targets targets = targets_of(problem);
  ASSERT_EQ(targets.size(), 51U);
  EXPECT_EQ(targets.front(), problem.tolerance);
  EXPECT_DOUBLE_EQ(targets.back(), reference_gap(problem));
  // Of |x - 1/2| at a uniform point the median is 1/4.
  EXPECT_NEAR(targets.back(), 0.25, 0.15);
  const double ratio = targets[1] / targets[0];
  for (std::size_t k = 1; k < targets.size(); ++k) {
    EXPECT_NEAR(targets[k] / targets[k - 1], ratio, 1e-9 * ratio);
  }
  problem.tolerance = 0;
  const Targets from_zero = targets_of(problem);
  EXPECT_EQ(from_zero.front(), 0);
  EXPECT_TRUE(std::ranges::is_sorted(from_zero));
  EXPECT_TRUE(std::isfinite(from_zero.back()));
}

TEST(Targets, AreTheToleranceAloneIfNothingIsKnownOfRandomPoints) {
  const auto throws = [](const Vector&) -> TrueValues { throw std::runtime_error(""); };
  const auto is_no_number = [](const Vector&) { return TrueValues{quiet_nan, 0}; };
  for (const Problem& problem : {valley_of(throws), valley_of(is_no_number)}) {
    EXPECT_EQ(targets_of(problem), Targets{1e-9});
  }
  const auto half_feasible = [](const Vector& x) {
    return x[0] < 0.5 ? TrueValues{3, 0} : TrueValues{100, 1};
  };
  EXPECT_EQ(reference_gap(valley_of(half_feasible)), 3) << "of feasible ones, if there are any";
  EXPECT_EQ(reference_gap(valley_of([](const Vector&) { return TrueValues{-5, 1}; })), 5);
}

TEST(Chosen, LeavesOutProblemsWhoseBestValueIsNotKnown) {
  Problem unknown = valley_problem();
  unknown.name = "valley-2";
  unknown.best_known.reset();
  EXPECT_THAT(chosen_problems({valley_problem(), unknown}, "valley*", "--problems"),
              ElementsAre(testing::Field(&Problem::name, "valley")));
}

}  // namespace
}  // namespace ricochet::comparison
