#include "problems/carrier_track/questions/problem_from_function.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/questions/families.h"
#include "src/core/instance.h"
#include "tests/carrier_track/questions/exploratory_scene.h"
#include "tests/core/hessian_check.h"

namespace ricochet::carrier_track {
namespace {

/// One question of every family, of a profile the shortest.
std::vector<Question> questions() {
  std::vector<Question> first;
  for (const Family& family : families_of({machine_of(find_case("C1"), exploratory_scene())})) {
    first.push_back(family.questions.front());
  }
  return first;
}

TEST(ProblemFromFunction, HasSecondDerivativesWhereItHasFirstOnes) {
  int with = 0;
  for (const Question& question : questions()) {
    for (const Form& form : question.forms()) {
      const Problem problem = question.problem(form);
      EXPECT_EQ(static_cast<bool>(problem.lagrangian_hessian),
                static_cast<bool>(problem.differentiate))
          << problem.name;
      with += static_cast<bool>(problem.lagrangian_hessian);
    }
  }
  EXPECT_GE(with, 8);
}

TEST(ProblemFromFunction, HasTheSecondDerivativesOfItsGradientInEveryInstance) {
  Random random(1);
  for (const Question& question : questions()) {
    const bool smooth = static_cast<bool>(question.stated.differentiate);
    const Problem problem = question.problem({smooth ? 0 : question.width});
    int compared = 0;
    for (int number = 0; number < 6; ++number) {
      const Problem moved = instance(problem, number);
      const Vector multipliers = normal(moved.constraints, random);
      compared += expect_hessian_of_gradients(moved, uniform_point(moved, random), uniform(random),
                                              multipliers, 1e-5, 1e-4);
    }
    EXPECT_GT(compared, 2) << problem.name;
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
