// The committed best values: each comes out again where it is said to be attained.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "problems/carrier_track/questions/best_known.h"
#include "problems/carrier_track/questions/families.h"
#include "src/core/verdict.h"
#include "src/studies/best_values/question.h"

namespace ricochet::studies::best_values {
namespace {

const std::vector<Question>& questions() {
  static const std::vector<Question> all = questions_of(carrier_track::case_families());
  return all;
}

TEST(BestValues, AreThereForEveryQuestion) {
  std::set<std::string> names;
  for (const Question& question : questions()) {
    names.insert(question.name);
    EXPECT_TRUE(question.forms.front().best_known) << question.name;
  }
  for (const auto& [name, best] : carrier_track::best_values().of) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(BestValues, ComeOutAgainAtTheirPoints) {
  for (const Question& question : questions()) {
    const Problem& problem = question.forms.front();
    if (!problem.best_point) continue;
    ASSERT_EQ(problem.best_point->size(), problem.dimension()) << problem.name;
    EXPECT_TRUE((problem.best_point->array() >= problem.lower.array()).all()) << problem.name;
    EXPECT_TRUE((problem.best_point->array() <= problem.upper.array()).all()) << problem.name;
    const Truth truth = truth_at(problem, *problem.best_point);
    EXPECT_EQ(truth.violation, 0) << problem.name;
    EXPECT_NEAR(truth.objective, *problem.best_known, 1e-9) << problem.name;
    EXPECT_FALSE(better(truth_at(problem, problem.start), truth)) << problem.name;
  }
}

/// Ten speeds of a scan on either side; where the best value is at an edge, the first of them is
/// not quiet.
TEST(BestValues, OfOneVariableHaveNothingBetterNearBy) {
  for (const Question& question : questions()) {
    const Problem& problem = question.forms.front();
    if (problem.dimension() != 1 || !problem.best_point) continue;
    const Truth best = truth_at(problem, *problem.best_point);
    const double step = question.name.rfind("robust-", 0) == 0 ? 1e-2 : 1e-3;
    for (int k = -10; k <= 10; ++k) {
      const double x = (*problem.best_point)[0] + k * step;
      if (x < problem.lower[0] || x > problem.upper[0]) continue;
      Truth near = truth_at(problem, Vector::Constant(1, x));
      EXPECT_FALSE(near.violation == 0 && near.objective < best.objective - 1e-6)
          << question.name << " at " << x;
    }
  }
}

}  // namespace
}  // namespace ricochet::studies::best_values
