#include <gtest/gtest.h>

#include <cmath>

#include "solvers/mads.h"
#include "tests/support/numbers.h"

namespace ricochet {
namespace {

Trial trial(double objective, double violation) {
  return {Vector::Constant(1, objective), objective, violation};
}

TEST(ViolationOf, SumsTheSquaresOfWhatIsBroken) {
  EXPECT_EQ(violation_of({0, Vector{{2, -3, 4, 0}}}, 0), 4 + 16);
  EXPECT_EQ(violation_of({0, Vector{{2, -3, 4, 0}}}, 2), 4 + 9 + 16);
  EXPECT_EQ(violation_of({0, Vector{{-1e-7, 1e-7}}}, 1), 0) << "within constraint_tolerance";
  EXPECT_DOUBLE_EQ(violation_of({0, Vector{{-2e-6, 3e-6}}}, 1), 4e-12 + 9e-12);
  EXPECT_EQ(violation_of({0, Vector()}, 0), 0);
  EXPECT_TRUE(std::isnan(violation_of({0, Vector{{std::nan("")}}}, 0)));
}

TEST(Barrier, TakesATieForNoSuccessAndMovesToItIfItAcceptsTies) {
  for (const bool accepts_ties : {false, true}) {
    Barrier barrier(accepts_ties);
    barrier.add(trial(5, 0));
    barrier.settle(Progress::dominating);
    EXPECT_EQ(barrier.add({Vector::Constant(1, 9), 5, 0}), Progress::none);
    barrier.settle(Progress::none);
    EXPECT_EQ(barrier.feasible()->u[0], accepts_ties ? 9 : 5);
  }
}

TEST(Barrier, TakesALowerFeasiblePointForASuccess) {
  Barrier barrier(false);
  EXPECT_EQ(barrier.add(trial(5, 0)), Progress::dominating);
  barrier.settle(Progress::dominating);
  EXPECT_EQ(barrier.add(trial(6, 0)), Progress::none);
  EXPECT_EQ(barrier.add(trial(4, 0)), Progress::dominating);
  EXPECT_EQ(barrier.feasible()->objective, 5) << "until the iteration ends";
  barrier.settle(Progress::dominating);
  EXPECT_EQ(barrier.feasible()->objective, 4);
}

/// An infeasible incumbent of objective 5 and violation 4.
Barrier infeasible_barrier() {
  Barrier barrier(false);
  barrier.add(trial(5, 4));
  barrier.settle(Progress::none);
  return barrier;
}

TEST(Barrier, JudgesInfeasiblePointsByBothMeasures) {
  EXPECT_EQ(infeasible_barrier().add(trial(4, 4)), Progress::dominating);
  EXPECT_EQ(infeasible_barrier().add(trial(5, 3)), Progress::dominating);
  EXPECT_EQ(infeasible_barrier().add(trial(6, 3)), Progress::improving);
  EXPECT_EQ(infeasible_barrier().add(trial(4, 5)), Progress::none);
  EXPECT_EQ(infeasible_barrier().add(trial(5, 4)), Progress::none);
}

TEST(Barrier, FallsToTheIncumbentsViolationUnlessThereIsALesserOne) {
  Barrier barrier = infeasible_barrier();
  EXPECT_EQ(barrier.limit(), infinity);
  barrier.add(trial(4, 9));
  barrier.settle(Progress::none);
  EXPECT_EQ(barrier.limit(), 4);
  EXPECT_EQ(barrier.infeasible()->objective, 5) << "the lower one is beyond the limit";

  barrier.add(trial(6, 3));
  barrier.add(trial(7, 2));
  barrier.settle(Progress::improving);
  EXPECT_EQ(barrier.limit(), 3) << "the most that is less than the incumbent's";
  EXPECT_EQ(barrier.infeasible()->objective, 6);

  EXPECT_EQ(barrier.add(trial(1, 3.5)), Progress::none) << "beyond the limit";
  EXPECT_EQ(barrier.add(trial(5.5, 2.5)), Progress::dominating);
  barrier.settle(Progress::dominating);
  EXPECT_EQ(barrier.limit(), 3);
  EXPECT_EQ(barrier.infeasible()->violation, 2.5);
}

TEST(Barrier, KeepsBothIncumbents) {
  Barrier barrier = infeasible_barrier();
  EXPECT_EQ(barrier.add(trial(8, 0)), Progress::dominating);
  barrier.settle(Progress::dominating);
  EXPECT_EQ(barrier.feasible()->objective, 8);
  EXPECT_EQ(barrier.infeasible()->objective, 5);
}

TEST(Barrier, DoesNotTakeWhatIsNoNumber) {
  Barrier barrier(false);
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    EXPECT_EQ(barrier.add(trial(bad, 0)), Progress::none);
    EXPECT_EQ(barrier.add(trial(bad, 1)), Progress::none);
  }
  EXPECT_EQ(barrier.add(trial(1, std::nan(""))), Progress::none);
  EXPECT_EQ(barrier.add(trial(1, infinity)), Progress::none);
  barrier.settle(Progress::none);
  EXPECT_FALSE(barrier.feasible());
  EXPECT_FALSE(barrier.infeasible());
}

}  // namespace
}  // namespace ricochet
