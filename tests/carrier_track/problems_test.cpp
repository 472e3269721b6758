#include "problems/carrier_track/problems.h"

#include <gtest/gtest.h>

#include <set>

#include "src/core/instance.h"
#include "tests/carrier_track/exploratory_scene.h"

namespace ricochet::carrier_track {
namespace {

const Scene& reading() {
  static const Scene scene = exploratory_scene();
  return scene;
}

Vector at(double omega) {
  return Vector::Constant(1, omega);
}

TEST(Problems, HaveDistinctNamesForEveryCase) {
  std::set<std::string> names;
  for (const Case& a_case : all_cases()) {
    for (const Problem& p : problems_of(a_case, reading())) names.insert(p.name);
  }
  EXPECT_EQ(names.size(), 12U * 4U);
}

TEST(Problems, CountWhatTheScanCounts) {
  const Case a_case = find_case("C4");
  const Problem problem = count_problem(a_case, reading());
  for (const double omega : {0.5, 3.3, 17.0}) {
    EXPECT_EQ(problem.evaluate(at(omega)).objective, count_at(scene_of(a_case, reading()), omega));
  }
}

TEST(Problems, JudgeTheSurrogateByTheTrueCount) {
  const Case a_case = find_case("C2");
  const Problem smooth = surrogate_problem(a_case, reading(), 0.25);
  const Problem exact = count_problem(a_case, reading());
  EXPECT_EQ(smooth.truth(at(5.0)).objective, exact.evaluate(at(5.0)).objective);
  EXPECT_NE(smooth.evaluate(at(5.0)).objective, exact.evaluate(at(5.0)).objective);
}

TEST(Problems, ConstrainTheTopSpeedByTheLimit) {
  const Problem problem = top_speed_problem(find_case("C1"), reading(), 6.0);
  const Values quiet = problem.evaluate(at(9.0));
  EXPECT_EQ(quiet.objective, -9.0);
  EXPECT_LE(quiet.constraints[0], 0.0);
  EXPECT_GT(problem.evaluate(at(15.0)).constraints[0], 0.0);
}

TEST(Problems, JudgeTheSmoothTopSpeedByTheTrueCount) {
  const Problem problem = top_speed_surrogate_problem(find_case("C1"), reading(), 6.0, 0.25);
  EXPECT_EQ(problem.truth(at(9.0)).violation, 0.0);
  EXPECT_EQ(problem.truth(at(15.0)).violation, 1.0);
  EXPECT_EQ(problem.truth(at(15.0)).objective, -15.0);
}

TEST(Problems, HaveDerivativesThatAgreeWithDifferences) {
  for (const Problem& problem :
       {surrogate_problem(find_case("C1"), reading(), 0.25),
        top_speed_surrogate_problem(find_case("C1"), reading(), 6.0, 0.25)}) {
    const double h = 1e-6;
    const double omega = 4.321;
    const Derivatives d = problem.differentiate(at(omega));
    const Values up = problem.evaluate(at(omega + h));
    const Values down = problem.evaluate(at(omega - h));
    EXPECT_NEAR(d.gradient[0], (up.objective - down.objective) / (2 * h), 1e-6);
    if (problem.constraints > 0) {
      EXPECT_NEAR(d.jacobian(0, 0), (up.constraints[0] - down.constraints[0]) / (2 * h), 1e-6);
    }
  }
}

TEST(Problems, KnowTheirBestValuesFromAScan) {
  const Case a_case = find_case("C1");
  auto problems = problems_of(a_case, reading());
  const SpeedScan scan = scan_speeds(scene_of(a_case, reading()), 0.01, fastest_speed);
  certify(problems, scan, 6.0);
  EXPECT_EQ(problems[0].best_known, 1.0);
  EXPECT_EQ(problems[1].best_known, 1.0);
  // The fastest quiet speed of the scan is quiet, the next one is loud.
  const double fastest = -*problems[2].best_known;
  EXPECT_LE(count_at(scene_of(a_case, reading()), fastest), 6);
  EXPECT_GT(count_at(scene_of(a_case, reading()), fastest + 0.01), 6);
  EXPECT_EQ(problems[3].best_known, problems[2].best_known);
}

TEST(Problems, ShowTheSameCountsInEveryInstance) {
  const Problem problem = count_problem(find_case("C2"), reading());
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
