#include "solvers/plateau_search/drift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/solvers/test_problems.h"

namespace ricochet::drifting {
namespace {

/// What a drift over the problem comes to.
Seen drifted(const Problem& problem, const DriftLimits& limits, std::int64_t evaluations,
             std::uint64_t seed) {
  Evaluator evaluator(problem, {evaluations});
  Sight sight(evaluator);
  const Vector u = sight.to_unit(problem.start);
  Seen at{u, sight.look(u).value()};
  Random random(seed);
  drift(sight, at, limits, random);
  return at;
}

TEST(Drift, MovesAlongAPlateau) {
  // Everything is tied: only a search that accepts ties ends elsewhere.
  for (const Eigen::Index n : {1, 2, 10}) {
    const Problem problem = plateau(n);
    const Vector start = Vector::Constant(n, 0.5);
    EXPECT_GT((drifted(problem, {0.1, 100}, 1000, 1).u - start).norm(), 0.1) << n;
  }
}

TEST(Drift, FindsANarrowStepFarAcrossAPlateau) {
  // 1 but for the cell beyond 0.95 of both coordinates; the first steps are a hundredth of the way.
  const Problem problem = box_problem(
      "far", 2, 0, 1, 0.05, [](const Vector& x) { return x.minCoeff() > 0.95 ? 0.0 : 1.0; });
  int found = 0;
  for (int seed = 0; seed < 20; ++seed) {
    found +=
        drifted(problem, {0.01, 300}, 400, static_cast<std::uint64_t>(seed)).truth.objective == 0;
  }
  EXPECT_GE(found, 15);
}

TEST(Drift, ConvergesOnASlope) {
  EXPECT_LT(drifted(sphere(5, 3), {0.3, 1000}, 1500, 3).truth.objective, 1e-6);
}

TEST(Drift, FollowsAConstraintToItsBest) {
  const Seen end = drifted(disc(), {0.3, 300}, 1000, 4);
  EXPECT_LE(end.truth.violation, 0);
  EXPECT_LT(end.truth.objective, -1.4);
}

TEST(Drift, FollowsAConstraintThatOnlyCounts) {
  // disc(), its constraint in whole numbers: how near it is to be kept shows nowhere.
  Problem problem = disc();
  problem.differentiate = nullptr;
  problem.smoothed = nullptr;
  problem.evaluate = [](const Vector& x) {
    return Values{x.sum(), Vector::Constant(1, std::ceil(4 * (x.squaredNorm() - 1)))};
  };
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Seen end = drifted(problem, {0.3, 300}, 1000, seed);
    EXPECT_LE(end.truth.violation, 0);
    EXPECT_LT(end.truth.objective, -1.38);
  }
}

TEST(Drift, EndsWhenItsPatienceDoes) {
  const Problem problem = plateau(2);
  Evaluator over(problem, {1000});
  Sight sight(over);
  const Vector u = Vector::Constant(2, 0.5);
  Seen at{u, sight.look(u).value()};
  Random random(5);
  EXPECT_TRUE(drift(sight, at, {0.1, 40}, random));
  EXPECT_LE(over.ledger().charged, 41);
  EXPECT_GE(over.ledger().charged, 30);
}

}  // namespace
}  // namespace ricochet::drifting
