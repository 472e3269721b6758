// The committed best values: each comes out again where it is said to be attained.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"
#include "ricochet/run.h"
#include "src/studies/paper/loss.h"

namespace ricochet {
namespace {

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all = [] {
    std::vector<Family> families = carrier_track::case_families();
    families.push_back(carrier_track::calibration_family());
    return every_problem(families);
  }();
  return all;
}

TEST(BestValues, AreThereForEveryProblem) {
  std::set<std::string> names;
  for (const Problem& problem : problems()) {
    names.insert(problem.name);
    EXPECT_TRUE(problem.best_known) << problem.name;
  }
  for (const auto& [name, best] : carrier_track::best_values().of) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST(BestValues, ComeOutAgainAtTheirPoints) {
  for (const Problem& problem : problems()) {
    ASSERT_TRUE(problem.best_point) << problem.name;
    ASSERT_EQ(problem.best_point->size(), problem.dimension()) << problem.name;
    EXPECT_TRUE((problem.best_point->array() >= problem.lower.array()).all()) << problem.name;
    EXPECT_TRUE((problem.best_point->array() <= problem.upper.array()).all()) << problem.name;
    const TrueValues true_values = true_values_at(problem, *problem.best_point);
    EXPECT_EQ(true_values.violation, 0) << problem.name;
    EXPECT_NEAR(true_values.objective, *problem.best_known, 1e-9) << problem.name;
    EXPECT_FALSE(better(true_values_at(problem, problem.start), true_values)) << problem.name;
  }
}

/// Ten speeds of a scan on either side; where the best value is at an edge, the first of them is
/// not quiet.
TEST(BestValues, OfOneVariableHaveNothingBetterNearBy) {
  for (const Problem& problem : problems()) {
    if (problem.dimension() != 1) continue;
    const TrueValues best = true_values_at(problem, *problem.best_point);
    for (int k = -10; k <= 10; ++k) {
      const double x = (*problem.best_point)[0] + k * problem.scan_step;
      if (x < problem.lower[0] || x > problem.upper[0]) continue;
      TrueValues near = true_values_at(problem, Vector::Constant(1, x));
      EXPECT_FALSE(near.violation == 0 && near.objective < best.objective - 1e-6)
          << problem.name << " at " << x;
    }
  }
}

}  // namespace
}  // namespace ricochet
