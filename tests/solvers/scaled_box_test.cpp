#include "solvers/scaled_box.h"

#include "tests/support/problems.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

/// sphere(2, 3) on [-100, 300] x [2, upper].
Problem oblong(double upper = 4) {
  Problem problem = sphere(2, 3);
  problem.lower = Vector{{-100, 2}};
  problem.upper = Vector{{300, upper}};
  return problem;
}

TEST(ScaledBox, IsTheUnitCubeEvenOrTheBoxOfTheProblem) {
  const Problem problem = oblong();
  Evaluator evaluator(problem, {10});
  const struct {
    Coordinates coordinates;
    Vector lower, upper, of_1_3_half;
  } cases[] = {{Coordinates::unit, Vector::Zero(2), Vector::Ones(2), Vector{{0.25, 0.5}}},
               {Coordinates::even, Vector::Zero(2), Vector{{1, 0.005}}, Vector{{0.25, 0.0025}}},
               {Coordinates::own, problem.lower, problem.upper, Vector{{0, 3}}}};
  const Vector x{{0, 3}};
  for (const auto& [coordinates, lower, upper, u] : cases) {
    SCOPED_TRACE(name_of(names_of(Coordinates{}), coordinates));
    ScaledBox box(evaluator, coordinates);
    EXPECT_EQ(box.lower(), lower);
    EXPECT_EQ(box.upper(), upper);
    EXPECT_EQ(box.to_scaled(problem.lower), lower);
    EXPECT_EQ(box.to_scaled(problem.upper), upper);
    EXPECT_EQ(box.to_scaled(x), u);
    EXPECT_EQ(box.from_scaled(u), x);
    EXPECT_EQ(box.to_scaled(Vector{{-1000, 1000}}), (Vector{{lower[0], upper[1]}})) << "moved in";
    EXPECT_EQ(box.derivatives(u)->gradient, Vector(Vector{{-6, 0}}.cwiseProduct(box.scale())));
  }
  EXPECT_EQ(ScaledBox(evaluator).scale(), (Vector{{400, 2}}));
  EXPECT_EQ(ScaledBox(evaluator, Coordinates::even).scale(), (Vector{{400, 400}}));
}

TEST(ScaledBox, HasAPlaceForACoordinateWithoutWidth) {
  const Problem problem = oblong(2);
  Evaluator evaluator(problem, {10});
  for (const auto& [name, coordinates] : names_of(Coordinates{})) {
    ScaledBox box(evaluator, coordinates);
    EXPECT_EQ(box.to_scaled(Vector{{100, 2}})[1], 0) << name;
    EXPECT_EQ(box.from_scaled(box.lower()), problem.lower) << name;
    EXPECT_EQ(box.from_scaled(box.upper()), problem.upper) << name;
    EXPECT_LT(box.lower()[1], box.upper()[1]) << name << ": libraries refuse equal bounds";
    EXPECT_EQ(box.derivatives(box.upper())->gradient[1], 0) << name;
  }
}

TEST(ScaledBox, ScalesDerivativesByTheWidth) {
  const Problem constrained = disc();  // on [-2, 2]^2
  Evaluator evaluator(constrained, {10});
  ScaledBox box(evaluator);
  const auto seen = box.derivatives(Vector{{0.75, 0.25}});  // x = (1, -1)
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->gradient, Vector::Constant(2, 4));
  EXPECT_EQ(seen->jacobian.row(0).transpose(), (Vector{{8, -8}}));
  // A constraint at its limit is shown as zero.
  EXPECT_EQ(box.values(Vector{{0.75, 0.5}})->constraints[0], 0);
  EXPECT_EQ(box.derivatives(Vector{{0.5, 0.25}})->values.constraints[0], 0);

  const Problem squares = sphere(2, 3);  // on [-100, 100]^2
  Evaluator of_squares(squares, {10});
  const auto residuals = ScaledBox(of_squares).residuals(Vector{{0.75, 0.25}});  // x = (50, -50)
  ASSERT_TRUE(residuals);
  EXPECT_EQ(residuals->values, std::sqrt(2.0) * Vector({{47, -53}}));
  EXPECT_EQ(residuals->jacobian, 200 * std::sqrt(2.0) * Matrix::Identity(2, 2));
}

TEST(ScaledBox, DoesNotAskTheEvaluatorWhereThePointIsNotFinite) {
  const Problem problem = sphere(1, 3);
  Evaluator evaluator(problem, {10});
  ScaledBox box(evaluator);
  const Vector nowhere = Vector::Constant(1, quiet_nan);
  EXPECT_FALSE(box.values(nowhere) || box.derivatives(nowhere) || box.residuals(nowhere));
  EXPECT_FALSE(box.over()) << "the run goes on from another start";
}

TEST(Finite, LooksAtEveryNumber) {
  for (const double number : {1.0, quiet_nan, infinity}) {
    const bool good = std::isfinite(number);
    const Vector one = Vector::Ones(1), vector{{1, number}};
    const Matrix row{{1, 1}}, matrix{{1, number}};
    EXPECT_EQ(finite(Values{number, {}}), good);
    EXPECT_EQ(finite(Values{1.0, vector}), good);
    EXPECT_EQ(finite(Derivatives{{1.0, one}, vector, row}), good);
    EXPECT_EQ(finite(Derivatives{{1.0, one}, Vector::Ones(2), matrix}), good);
    EXPECT_EQ(finite(Residuals{vector, row}), good);
    EXPECT_EQ(finite(Residuals{one, matrix}), good);
  }
}

/// ZDT1 (Zitzler, Deb and Thiele, Evol. Comput. 8 (2000) 173-195): best is f2 = 1 - sqrt(f1), which
/// below (1, 1) dominates 2/3.
SeveralGoals zdt1(Eigen::Index n) {
  return {n, 2, [n](const Vector& u) {
            const double g = 1 + 9 * u.tail(n - 1).sum() / static_cast<double>(n - 1);
            return Vector{{u[0], g * (1 - std::sqrt(u[0] / g))}};
          }};
}

TEST(Front, HoldsWhatNothingDominatesWhateverTheOrder) {
  Random random(1);
  std::vector<FrontPoint> all;
  Front front;
  for (int k = 0; k < 300; ++k) {
    Vector goals(3);
    for (double& goal : goals) goal = std::floor(10 * uniform(random));
    all.push_back({{}, goals});
    add(front, all.back());
  }
  for (const FrontPoint& point : all) {
    bool dominated = false;
    for (const FrontPoint& other : all) {
      const bool is_better =
          (other.goals.array() <= point.goals.array()).all() && other.goals != point.goals;
      EXPECT_EQ(dominates(other.goals, point.goals), is_better);
      dominated |= is_better;
    }
    const auto times = std::ranges::count(front, point.goals, &FrontPoint::goals);
    EXPECT_EQ(times, dominated ? 0 : 1) << point.goals.transpose();
  }
}

TEST(Hypervolume, IsTheAreaOfStairsAndNearlyThatOfTheFrontOfZdt1) {
  const Front stairs = {{{}, Vector{{0, 2}}}, {{}, Vector{{1, 1}}}, {{}, Vector{{5, 0}}}};
  EXPECT_DOUBLE_EQ(hypervolume(stairs, Vector{{3, 3}}), 3 * 1 + 2 * 1);  // the last is beyond
  EXPECT_EQ(hypervolume({}, Vector{{1, 1}}), 0);
  const auto found = [](std::uint64_t seed) { return nsga2_front(zdt1(5), {80, 100, seed, {}}); };
  const Front front = found(1), again = found(1);
  const double volume = hypervolume(front, Vector{{1, 1}});
  EXPECT_LT(volume, 2.0 / 3);
  EXPECT_GT(volume, 0.65);
  for (const auto& [u, goals] : front) {
    EXPECT_NEAR(goals[1], 1 - std::sqrt(goals[0]), 0.02);
    EXPECT_EQ(zdt1(5).evaluate(u), goals);
  }
  EXPECT_TRUE(std::ranges::equal(front, again, {}, &FrontPoint::u, &FrontPoint::u));
  EXPECT_NE(front.front().u, found(2).front().u) << "of another seed";
}

TEST(Nsga2Front, BeginsWithItsStartsAndAsksForAsMuchAsItSaysUnlessTheGoalsThrow) {
  std::vector<Vector> asked;
  SeveralGoals watched = zdt1(3);
  watched.evaluate = [&, inner = watched.evaluate](const Vector& u) {
    asked.push_back(u);
    return inner(u);
  };
  const Vector start = Vector::Constant(3, 0.25);
  nsga2_front(watched, {12, 5, 1, {start, 2 * start}});
  EXPECT_EQ(asked.size(), 12U * 6);
  EXPECT_EQ(asked[0], start);
  EXPECT_EQ(asked[1], 2 * start);
  for (const Vector& u : asked) EXPECT_TRUE(u.minCoeff() >= 0 && u.maxCoeff() <= 1);
  const SeveralGoals broken{2, 2, [](const Vector&) -> Vector { throw std::domain_error("no"); }};
  EXPECT_THROW(nsga2_front(broken, {8, 1, 1, {}}), std::domain_error);
}

}  // namespace
}  // namespace ricochet
