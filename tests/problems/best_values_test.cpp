// The committed best values: each comes out again where it is said to be attained.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "problems/carrier_track/questions/best_known.h"
#include "problems/carrier_track/questions/families.h"
#include "src/core/verdict.h"

namespace ricochet {
namespace {

const std::vector<Question>& questions() {
  static const std::vector<Question> all = [] {
    std::vector<Question> questions;
    for (const Family& family : carrier_track::case_families()) {
      questions.insert(questions.end(), family.questions.begin(), family.questions.end());
    }
    return questions;
  }();
  return all;
}

TEST(BestValues, AreThereForEveryQuestion) {
  std::set<std::string> names;
  for (const Question& question : questions()) {
    names.insert(question.name());
    EXPECT_TRUE(question.stated.best_known) << question.name();
  }
  for (const auto& [name, best] : carrier_track::best_values().of) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(BestValues, ComeOutAgainAtTheirPoints) {
  for (const Question& question : questions()) {
    const Problem& problem = question.stated;
    ASSERT_TRUE(problem.best_point) << problem.name;
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
    const Problem& problem = question.stated;
    if (problem.dimension() != 1) continue;
    const Truth best = truth_at(problem, *problem.best_point);
    for (int k = -10; k <= 10; ++k) {
      const double x = (*problem.best_point)[0] + k * question.scan_step;
      if (x < problem.lower[0] || x > problem.upper[0]) continue;
      Truth near = truth_at(problem, Vector::Constant(1, x));
      EXPECT_FALSE(near.violation == 0 && near.objective < best.objective - 1e-6)
          << question.name() << " at " << x;
    }
  }
}

}  // namespace
}  // namespace ricochet
