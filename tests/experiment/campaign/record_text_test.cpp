#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "src/experiment/worker.h"

namespace ricochet {
namespace {

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

/// Any bits that a number can have.
double any_number(std::mt19937_64& random) {
  const std::uint64_t bits = random();
  double number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

Vector any_point(std::mt19937_64& random) {
  Vector x(static_cast<Eigen::Index>(random() % 5));
  for (double& coordinate : x) coordinate = any_number(random);
  return x;
}

TEST(RecordText, KeepsEveryBitOfAnImprovement) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000; ++k) {
    const Improvement step{static_cast<std::int64_t>(random() >> 1),
                           any_number(random),
                           {any_number(random), any_number(random)},
                           any_point(random)};
    const Improvement again = improvement_from(text_of(step));
    EXPECT_EQ(again.evaluations, step.evaluations);
    EXPECT_TRUE(same_bits(again.seconds, step.seconds)) << step.seconds;
    EXPECT_TRUE(same_bits(again.true_values.objective, step.true_values.objective));
    EXPECT_TRUE(same_bits(again.true_values.violation, step.true_values.violation));
    ASSERT_EQ(again.x.size(), step.x.size());
    for (Eigen::Index i = 0; i < step.x.size(); ++i) EXPECT_TRUE(same_bits(again.x[i], step.x[i]));
  }
}

TEST(RecordText, KeepsAllOfARecord) {
  RunRecord record;
  record.problem = "valley \"of\" \n tears";
  record.solver = "mine";
  record.instance = 4;
  record.run = 5;
  record.seed = ~0ULL;
  record.budget = {100, std::numeric_limits<double>::infinity()};
  record.ledger = {1, 2, 6, 3, 4, 0.5};
  record.termination_reason = TerminationReason::bad_point;
  record.terminations = {{"done", Vector::Constant(2, 0.1)}, {"stopped"}};
  record.failure = "torn";
  record.trace = {{1, 0.1, {2, 0}, Vector::Constant(1, 3)}, {2, 0.2, {1, 0}, Vector::Zero(1)}};
  for (const bool returned : {false, true}) {
    if (returned) record.budget.gradient_price = 0;
    if (returned) record.returned = ReturnedPoint{Vector::Ones(3), {7, 8}};
    const RunRecord again = record_from(text_of(record));
    EXPECT_EQ(again.problem, record.problem);
    EXPECT_EQ(again.solver, record.solver);
    EXPECT_EQ(again.instance, 4);
    EXPECT_EQ(again.run, 5);
    EXPECT_EQ(again.seed, record.seed);
    EXPECT_EQ(again.budget.evaluations, 100);
    EXPECT_EQ(again.budget.seconds, record.budget.seconds);
    EXPECT_EQ(again.budget.gradient_price, record.budget.gradient_price);
    EXPECT_EQ(again.ledger.values, 1);
    EXPECT_EQ(again.ledger.derivatives, 2);
    EXPECT_EQ(again.ledger.hessians, 6);
    EXPECT_EQ(again.ledger.charged, 3);
    EXPECT_EQ(again.ledger.refused, 4);
    EXPECT_EQ(again.ledger.seconds, 0.5);
    EXPECT_EQ(again.termination_reason, TerminationReason::bad_point);
    EXPECT_EQ(again.terminations, record.terminations);
    EXPECT_EQ(again.failure, "torn");
    ASSERT_EQ(again.trace.size(), 2U);
    EXPECT_EQ(again.trace[1].x, record.trace[1].x);
    ASSERT_EQ(again.returned.has_value(), returned);
    if (returned) {
      EXPECT_EQ(again.returned->true_values.violation, 8);
    }
  }
}

TEST(RecordText, RefusesWhatIsNone) {
  EXPECT_ANY_THROW(record_from(""));
  EXPECT_ANY_THROW(record_from("{}"));
  EXPECT_ANY_THROW(improvement_from("\x83\x01\x02\x03"));
}

}  // namespace
}  // namespace ricochet
