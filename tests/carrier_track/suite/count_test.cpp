#include <gtest/gtest.h>

#include <set>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "src/core/instance.h"
#include "tests/carrier_track/gradients/differences.h"
#include "tests/support/scenes.h"
#include "tests/carrier_track/suite/machine_of_case.h"

namespace ricochet::carrier_track {
namespace {

TEST(Count, IsWhatTheScanCounts) {
  const Machine c4 = machine("C4");
  const Problem problem = count_problem(c4);
  EXPECT_EQ(problem.name, "count-C4");
  for (const double omega : {0.5, 3.3, 17.0}) {
    EXPECT_EQ(problem.evaluate(at(omega)).objective, count_at(c4.scene, omega));
  }
}

TEST(Count, JudgesTheSurrogate) {
  const Problem smooth = count_problem(machine("C2")).formulated({0.25});
  const Problem exact = count_problem(machine("C2"));
  EXPECT_EQ(smooth.true_values(at(5.0)).objective, exact.evaluate(at(5.0)).objective);
  EXPECT_NE(smooth.evaluate(at(5.0)).objective, exact.evaluate(at(5.0)).objective);
}

TEST(Count, HasASurrogateWithDerivatives) {
  expect_derivatives_of_values(count_problem(machine("C1")).formulated({0.25}), at(4.321), 1e-7,
                               1e-6);
}

TEST(Count, HasASurrogateThatComesCloserWithLessSmoothing) {
  const Problem problem = count_problem(machine("C2")).formulated({0.25});
  const double count = problem.true_values(at(5.0)).objective;
  const Problem sharper = problem.smoothed(0.01);
  EXPECT_EQ(sharper.name, problem.name);
  EXPECT_EQ(sharper.evaluate(at(5.0)).objective,
            count_problem(machine("C2")).formulated({0.01}).evaluate(at(5.0)).objective);
  EXPECT_LT(std::abs(sharper.evaluate(at(5.0)).objective - count),
            std::abs(problem.evaluate(at(5.0)).objective - count));
}

TEST(Count, HasNoDerivativesWhereTheSimulationCarriesNone) {
  Machine compliant = machine("C1");
  compliant.scene.fidelity = Fidelity::compliant;
  const Problem problem = count_problem(compliant).formulated({0.25});
  EXPECT_FALSE(problem.differentiate);
  EXPECT_GE(problem.evaluate(at(5.0)).objective, 0);
}

TEST(Count, IsTheSameInEveryInstance) {
  const Problem problem = count_problem(machine("C2"));
  for (int number = 1; number <= 5; ++number) {
    const Problem moved = instance(problem, number);
    std::multiset<double> original;
    std::multiset<double> shown;
    for (int k = 0; k <= 20; ++k) {
      const double share = k / 20.0;
      original.insert(
          problem.evaluate(problem.lower + share * (problem.upper - problem.lower)).objective);
      shown.insert(moved.evaluate(moved.lower + share * (moved.upper - moved.lower)).objective);
    }
    EXPECT_EQ(original, shown);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
