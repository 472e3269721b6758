#include "problems/carrier_track/suite/problem_from_function.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/suite/machine.h"
#include "src/core/instance.h"
#include "tests/support/scenes.h"
#include "tests/core/hessian_check.h"

namespace ricochet::carrier_track {
namespace {

/// One problem of every family, of a profile the shortest.
std::vector<Problem> problems() {
  std::vector<Problem> first;
  for (const Family& family : families_of({machine_of(find_case("C1"), exploratory_scene())})) {
    first.push_back(family.problems.front());
  }
  return first;
}

TEST(ProblemFromFunction, HasSecondDerivativesWhereItHasFirstOnes) {
  int with = 0;
  for (const Problem& problem : problems()) {
    for (const Formulation& formulation : problem.formulations()) {
      const Problem formulated = problem.formulated(formulation);
      EXPECT_EQ(static_cast<bool>(formulated.lagrangian_hessian),
                static_cast<bool>(formulated.differentiate))
          << problem.name;
      with += static_cast<bool>(formulated.lagrangian_hessian);
    }
  }
  EXPECT_GE(with, 8);
}

TEST(ProblemFromFunction, HasTheSecondDerivativesOfItsGradientInEveryInstance) {
  Random random(1);
  for (const Problem& problem : problems()) {
    const bool smooth = static_cast<bool>(problem.differentiate);
    const Problem formulated = problem.formulated({smooth ? 0 : problem.smoothing});
    int compared = 0;
    for (int number = 0; number < 6; ++number) {
      const Problem moved = instance(formulated, number);
      const Vector multipliers = normal(moved.constraints, random);
      compared += expect_hessian_of_gradients(moved, uniform_point(moved, random), uniform(random),
                                              multipliers, 1e-5, 1e-4);
    }
    EXPECT_GT(compared, 2) << problem.name;
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
