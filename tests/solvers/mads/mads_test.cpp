#include "solvers/mads.h"

#include "tests/solvers/solve.h"

namespace ricochet {
namespace {

TEST(Mesh, GetsFinerByAFactorOfFourAndCoarserUpToItsCoarsest) {
  Mesh mesh(2, 1, 1);
  EXPECT_EQ(mesh.spacing(), 1.0 / 16);
  mesh.refine();
  EXPECT_EQ(mesh.spacing(), 1.0 / 64);
  mesh.coarsen();
  EXPECT_EQ(mesh.index(), 2);
  const struct {
    int index, coarsest;
    double coarsest_spacing, spacing;
    int last_index;
  } cases[] = {{2, 1, 0.5, 0.5 / 4, 1},
               {0, -3, 0.1, 0.1, -3},  // the polls are longer instead: 2^3 times
               {0, 1, 1, 1, 0}};       // it begins coarser than its coarsest
  for (const auto& [index, coarsest, coarsest_spacing, spacing, last_index] : cases) {
    Mesh coarsened(index, coarsest, coarsest_spacing);
    for (int i = 0; i < 5; ++i) coarsened.coarsen();
    EXPECT_EQ(coarsened.index(), last_index);
    EXPECT_EQ(coarsened.spacing(), spacing);
  }
}

TEST(PollBasis, IsOrthogonalAndOfIntegersNoLongerThanThePoll) {
  Random random(1);
  for (const Eigen::Index n : {1, 2, 3, 5, 16}) {
    for (int index = 0; index <= 26; ++index) {
      const Matrix basis = poll_basis(normal(n, random), index);
      EXPECT_EQ(basis, basis.unaryExpr([](double entry) { return std::round(entry); }));
      const double length = basis.col(0).norm(), most = std::ldexp(1.0, index);
      EXPECT_TRUE(length >= 1 && length <= most) << n << " " << index;
      EXPECT_TRUE(index < 12 || length > 0.8 * most) << "the mesh is fine: " << n << " " << index;
      // Integers: what is orthogonal is so to the last digit, but for products beyond 2^53.
      const Matrix off = basis.transpose() * basis - length * length * Matrix::Identity(n, n);
      EXPECT_LE(off.cwiseAbs().maxCoeff(), 1e-14 * length * length) << n << " " << index;
    }
  }
}

TEST(PollBasis, ReflectsTheDirectionItIsGiven) {
  const Vector direction = Vector{{0.3, -0.5, 0.8}}.normalized();
  EXPECT_LT(((poll_basis(direction, 24) * direction).normalized() + direction).norm(), 1e-3);
  EXPECT_EQ(poll_basis(Vector{{0.6, -0.7}}, 0), (Matrix{{1, 0}, {0, -1}})) << "the coarsest mesh";
}

// They span the space positively: every vector makes an acute angle with one of them.
TEST(PollDirections, LeadEverywhereBeginningAlongTheLeadingOne) {
  Random random(3);
  for (const Eigen::Index n : {1, 2, 4, 9}) {
    for (int draw = 0; draw < 200; ++draw) {
      const Matrix basis = poll_basis(normal(n, random), draw % 20);
      const Vector leading = normal(n, random);
      const auto directions = poll_directions(basis, leading);
      ASSERT_EQ(directions.size(), static_cast<std::size_t>(n + 1));
      const std::vector<Vector> first(directions.begin(), directions.end() - 1);
      const auto against = [&](const Vector& d) { return -d.dot(leading); };
      EXPECT_TRUE(std::ranges::is_sorted(first, {}, against));
      EXPECT_LE(against(first.back()), 0);
      EXPECT_EQ(directions.back(),
                -std::accumulate(first.begin(), first.end(), Vector::Zero(n).eval()));
      const Vector any = normal(n, random).normalized();
      double nearest = -1;
      for (const Vector& d : directions) nearest = std::max(nearest, any.dot(d.normalized()));
      // The cosine measure of n orthogonal unit vectors and the opposite of their sum.
      const auto size = static_cast<double>(n);
      const double cosine = 1 / std::sqrt(size * size + 2 * (size - 1) * std::sqrt(size));
      EXPECT_GE(nearest, cosine - 1e-12);
    }
  }
}

TEST(ViolationOf, SumsTheSquaresOfWhatIsBroken) {
  EXPECT_EQ(violation_of({0, Vector{{2, -3, 4, 0}}}, 0), 4 + 16);
  EXPECT_EQ(violation_of({0, Vector{{2, -3, 4, 0}}}, 2), 4 + 9 + 16);
  EXPECT_EQ(violation_of({0, Vector{{-1e-7, 1e-7}}}, 1), 0) << "within constraint_tolerance";
  EXPECT_DOUBLE_EQ(violation_of({0, Vector{{-2e-6, 3e-6}}}, 1), 4e-12 + 9e-12);
  EXPECT_EQ(violation_of({0, Vector()}, 0), 0);
  EXPECT_TRUE(std::isnan(violation_of({0, Vector{{quiet_nan}}}, 0)));
}

Trial trial(double objective, double violation) {
  return {Vector::Constant(1, objective), objective, violation};
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

TEST(Barrier, FallsToTheIncumbentsViolationUnlessThereIsALesserOne) {
  Barrier barrier(false);
  barrier.add(trial(5, 4));
  barrier.settle(Progress::none);
  EXPECT_EQ(barrier.limit(), infinity);
  for (const auto& [judged, progress] : {std::pair(trial(4, 4), Progress::dominating),
                                         {trial(5, 3), Progress::dominating},
                                         {trial(6, 3), Progress::improving},
                                         {trial(4, 5), Progress::none},
                                         {trial(5, 4), Progress::none}}) {
    EXPECT_EQ(Barrier(barrier).add(judged), progress);
  }
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

  EXPECT_EQ(barrier.add(trial(8, 0)), Progress::dominating);
  barrier.settle(Progress::dominating);
  EXPECT_EQ(barrier.feasible()->objective, 8) << "it keeps both incumbents";
  EXPECT_EQ(barrier.infeasible()->objective, 5.5);
}

TEST(Barrier, DoesNotTakeWhatIsNoNumber) {
  Barrier barrier(false);
  for (const double bad : {quiet_nan, infinity, -infinity}) {
    for (const Trial& no : {trial(bad, 0), trial(bad, 1), trial(1, std::abs(bad))}) {
      EXPECT_EQ(barrier.add(no), Progress::none) << bad;
    }
  }
  barrier.settle(Progress::none);
  EXPECT_FALSE(barrier.feasible());
  EXPECT_FALSE(barrier.infeasible());
}

class Mads : public OfSolver {
 protected:
  /// The objective of the feasible point where one call of solve ends.
  double settled(const Problem& problem, std::uint64_t seed = 1) const {
    const Solved end = solved(problem, solver(), 50'000, seed);
    EXPECT_EQ(end.reason, "the mesh is fine") << problem.name;
    EXPECT_EQ(end.best->true_values.violation, 0) << problem.name;
    return end.best->true_values.objective;
  }
};

TEST_P(Mads, ConvergesOnASphereAndOnItsBounds) {
  for (const Eigen::Index n : {1, 2, 5}) EXPECT_LT(settled(sphere(n, 3)), 1e-3) << n;
  EXPECT_EQ(settled(sphere(3, 130)), 3 * 30 * 30);
  EXPECT_NEAR(settled(with_fixed_coordinate(sphere(3, 3), 5)), 4, 1e-3);
}

TEST_P(Mads, ConvergesInRosenbrocksValley) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    EXPECT_LT(settled(suite_problem("classic-rosenbrock-2"), seed), 0.05);
  }
}

/// Inequalities alone, and one optimum; published.
TEST_P(Mads, ConvergesOnProblemsOfHockAndSchittkowski) {
  for (const char* name : {"hs-12", "hs-22", "hs-29", "hs-35", "hs-43", "hs-65", "hs-76"}) {
    const Problem problem = suite_problem(name);
    const double best = *problem.best_known;
    EXPECT_NEAR(settled(problem), best, 2e-2 * std::max(1.0, std::abs(best))) << name;
  }
}

TEST_P(Mads, FindsPointsOnAnArc) {
  if (solver().name == "mads-tuned") GTEST_SKIP() << "it stops when polls are at 1e-4 of the box";
  int found = 0, good = 0;
  for (int number = 0; number < 10; ++number) {
    const TrueValues end = best_of(run(arc(), solver(), {5000}, number));
    found += end.violation == 0;
    good += end.violation == 0 && end.objective <= -1;
  }
  EXPECT_GE(found, 6) << "an equation to 1e-6";
  EXPECT_GE(good, 3);
}

// The largest x + y on [0, 10]^2 at which a count, floor(x) + floor(2 y), is at most 7. With a
// first part of a it is below (a + 1) + (8 - a) / 2, which is most, 8.5, next to (8, 1/2).
TEST_P(Mads, ComesToTheEdgeOfAStepThatIsAConstraint) {
  Problem steps = box_problem("steps", 2, 0, 10, 9, [](const Vector&) { return 0.0; });
  steps.constraints = 1;
  steps.evaluate = [](const Vector& x) {
    return Values{-x.sum(), Vector::Constant(1, std::floor(x[0]) + std::floor(2 * x[1]) - 7)};
  };
  const TrueValues end = best_of(run(steps, solver(), {2000}, 0));
  EXPECT_EQ(end.violation, 0);
  EXPECT_NEAR(end.objective, -8.5, 0.01);
}

TEST_P(Mads, AsksForNoPointTwiceFromOneStartAndEndsOnAPlateauSoon) {
  for (const Problem& problem : {sphere(1, 3), plateau(2)}) {
    const std::vector<Vector> asked = asked_by_a_start(problem, solver(), 50'000, 1);
    EXPECT_GT(asked.size(), 10U);
    for (const Vector& x : asked) {
      EXPECT_EQ(std::count(asked.begin(), asked.end(), x), 1) << x.transpose();
    }
  }
  EXPECT_GT(run(plateau(2), solver(), {1000}, 0).terminations.size(), 10U);
}

INSTANTIATE_TEST_SUITE_P(Of, Mads, testing::Values(mads(Settings::own), mads(Settings::tuned)),
                         by_solver);

}  // namespace
}  // namespace ricochet
