#include "src/core/evaluator.h"

#include "ricochet/run.h"
#include "src/core/instance.h"
#include "tests/support/problems.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

/// n equal coordinates.
Vector point(double coordinate, Eigen::Index n = 1) {
  return Vector::Constant(n, coordinate);
}

/// Values, derivatives and Hessians that were asked of the problem, what is charged, refused calls.
using Counts = std::array<std::int64_t, 5>;

enum class Ask { values, derivatives, residuals, residual_values, hessian };

using enum Ask;

bool tells(Evaluator& evaluator, Ask what, const Vector& x, Part part = Part::everything) {
  switch (what) {
    case values:
      return evaluator.values(x, part).has_value();
    case derivatives:
      return evaluator.derivatives(x, part).has_value();
    case residuals:
      return evaluator.residuals(x, part).has_value();
    case residual_values:
      return evaluator.residual_values(x, part).has_value();
    case hessian:
      return evaluator.lagrangian_hessian(x, 1, Vector()).has_value();
  }
  throw std::logic_error("there is no such quantity");
}

/// What a solver asks for at a point of equal coordinates, and the counts after that.
struct Call {
  Ask what;
  double at;
  Counts after;
  Part part = Part::everything;
};

/// parabola(n) with second derivatives.
Problem curved_parabola(Eigen::Index n) {
  Problem problem = parabola(n);
  curve_by(problem, constant_hessian(n, 2));
  return problem;
}

/// Asks an evaluator of curved_parabola(n), which is over only where it has refused.
void expect_counts(Eigen::Index n, const Budget& budget, const std::vector<Call>& calls) {
  const Problem problem = curved_parabola(n);
  Evaluator evaluator(problem, budget);
  EXPECT_EQ(evaluator.remaining(), budget.evaluations);
  for (const auto& [what, at, after, part] : calls) {
    const std::int64_t refused = evaluator.ledger().refused;
    EXPECT_EQ(tells(evaluator, what, point(at, n), part), after[4] == refused);
    const Ledger all = evaluator.ledger();
    EXPECT_EQ((Counts{all.values, all.derivatives, all.hessians, all.charged, all.refused}), after);
    const bool over = after[4] > 0;
    EXPECT_EQ(evaluator.over(), over);
    EXPECT_EQ(evaluator.remaining(), over ? 0 : budget.evaluations - after[3]);
    EXPECT_EQ(evaluator.termination_reason(),
              over ? TerminationReason::evaluations : TerminationReason::none);
  }
}

TEST(Evaluator, ChargesOneForValuesAndNForDerivativesAndRemembersThem) {
  expect_counts(3, {100},
                {{values, 0.5, {1, 0, 0, 1}},
                 {derivatives, 0.25, {1, 1, 0, 1 + 4}},
                 {values, 0.25, {1, 1, 0, 1 + 4}},
                 {values, 0.75, {2, 1, 0, 1 + 4 + 1}},
                 {derivatives, 0.75, {2, 2, 0, 1 + 4 + 1 + 3}}});
  expect_counts(3, {100},
                {{residuals, 0.5, {0, 1, 0, 4}},
                 {values, 0.5, {1, 1, 0, 4 + 1}},
                 {residuals, 0.5, {1, 1, 0, 4 + 1}, Part::jacobian},
                 {values, 0.25, {2, 1, 0, 4 + 1 + 1}},
                 {residuals, 0.25, {2, 2, 0, 4 + 1 + 1 + 4}},  // values make them no cheaper
                 {residuals, 0.25, {2, 3, 0, 4 + 1 + 1 + 4 + 4}}});
  expect_counts(3, {100},
                {{derivatives, 0.5, {0, 1, 0, 4}},
                 {hessian, 0.5, {0, 1, 1, 4 + 6}},  // each of its own entries
                 {values, 0.5, {0, 1, 1, 4 + 6}},   // what was known still is
                 {hessian, 0.5, {0, 1, 2, 4 + 6 + 6}}});
}

TEST(Evaluator, ChargesWhoAsksForTheSameAgain) {
  expect_counts(2, {100},
                {{values, 0.5, {1, 0, 0, 1}, Part::nothing},
                 {values, 0.5, {1, 0, 0, 1}, Part::objective},  // another quantity
                 {values, 0.5, {1, 0, 0, 1}, Part::inequalities},
                 {values, 0.5, {1, 0, 0, 1}, Part::equalities},
                 {values, 0.5, {2, 0, 0, 2}, Part::objective},  // asked anew
                 {values, 0.5, {3, 0, 0, 3}},
                 {derivatives, 0.5, {3, 1, 0, 3 + 2}, Part::objective},
                 {derivatives, 0.5, {3, 1, 0, 3 + 2}, Part::inequalities},
                 {derivatives, 0.5, {3, 2, 0, 3 + 2 + 3}, Part::objective}});
  expect_counts(3, {10},
                {{residual_values, 0.5, {0, 1, 0, 1}, Part::nothing},
                 {residual_values, 0.5, {0, 1, 0, 1}, Part::objective},
                 {residuals, 0.5, {0, 1, 0, 4}, Part::jacobian},
                 {residual_values, 0.5, {0, 2, 0, 5}},
                 {residuals, 0.25, {0, 3, 0, 9}},
                 {residual_values, 0.5, {0, 4, 0, 10}},
                 {residuals, 0.5, {0, 4, 0, 10, 1}}});  // three more are not left
}

TEST(Evaluator, RefusesOnceTheBudgetIsSpentOrDoesNotCoverWhatIsAsked) {
  expect_counts(3, {2},
                {{values, 0.1, {1, 0, 0, 1}},
                 {values, 0.2, {2, 0, 0, 2}},
                 {values, 0.3, {2, 0, 0, 2, 1}},
                 {values, 0.2, {2, 0, 0, 2, 2}}});
  expect_counts(3, {3}, {{derivatives, 0.5, {0, 0, 0, 0, 1}}});
  expect_counts(3, {5}, {{hessian, 0.5, {0, 0, 0, 0, 1}}});
  expect_counts(3, {7},
                {{residuals, 0.5, {0, 1, 0, 4}},
                 {residuals, 0.25, {0, 1, 0, 4, 1}},
                 {residuals, 0.5, {0, 1, 0, 4, 2}}});  // not even what it remembers
}

TEST(Evaluator, ChargesAGradientThePriceOfTheBudget) {
  struct Price {
    std::optional<std::int64_t> of_gradient;
    std::int64_t charged, of_hessian;
  };
  for (const auto& [price, charged, of_hessian] :
       {Price{{}, 4, 10}, Price{0, 0, 1}, Price{1, 1, 2}, Price{3, 3, 7}, Price{10, 10, 25}}) {
    expect_counts(4, {.evaluations = 1000, .gradient_price = price},
                  {{derivatives, 0.5, {0, 1, 0, 1 + charged}},
                   {values, 0.25, {1, 1, 0, 2 + charged}},
                   {derivatives, 0.25, {1, 2, 0, 2 + 2 * charged}},  // the value was paid
                   {derivatives, 0.25, {1, 3, 0, 3 + 3 * charged}},  // but not twice
                   {residuals, 0.75, {1, 4, 0, 4 + 4 * charged}},
                   {hessian, 0.75, {1, 4, 1, 4 + 4 * charged + of_hessian}}});
  }
}

TEST(Evaluator, TellsWhatTheProblemSaysAlsoWhenItRemembers) {
  const Problem problem = curved_parabola(3);
  Evaluator evaluator(problem, {100});
  const Vector x = point(0.5, 3);
  EXPECT_EQ(evaluator.derivatives(x)->gradient, problem.differentiate(x).gradient);
  EXPECT_EQ(evaluator.values(x)->objective, problem.evaluate(x).objective);
  ASSERT_TRUE(evaluator.residual_values(x, Part::nothing));
  EXPECT_EQ(*evaluator.residual_values(x), problem.residuals(x).values);
  EXPECT_EQ(evaluator.residuals(x)->jacobian, problem.residuals(x).jacobian);
  EXPECT_EQ(evaluator.residuals(x, Part::jacobian)->values, problem.residuals(x).values);
  EXPECT_EQ(evaluator.lagrangian_hessian(x, 1.5, Vector()), 3 * Matrix::Identity(3, 3));
}

TEST(Evaluator, RefusesOnceTheTimeIsSpentAndPointsThatAreNone) {
  const Problem problem = curved_parabola(2);
  const std::tuple<Budget, Vector, TerminationReason> refused[] = {
      {{1000, 0.0}, point(0.1, 2), TerminationReason::seconds},
      {{10}, point(quiet_nan, 2), TerminationReason::bad_point},
      {{10}, point(0.5, 3), TerminationReason::bad_point}};
  for (const auto& [budget, x, reason] : refused) {
    for (const Ask what : {values, derivatives, residuals, residual_values, hessian}) {
      Evaluator evaluator(problem, budget);
      EXPECT_FALSE(tells(evaluator, what, x));
      EXPECT_EQ(evaluator.termination_reason(), reason);
    }
  }
}

TEST(Evaluator, EvaluatesAPointOutsideTheBoxAtItsProjectionAndScoresItThere) {
  const Problem problem = curved_parabola(1);
  for (const Ask what : {values, residuals, hessian}) {
    Scorer scorer(problem);
    Evaluator evaluator(problem, {10}, &scorer);
    EXPECT_TRUE(tells(evaluator, what, point(7)));
    EXPECT_EQ(scorer.best()->x, problem.upper);
    EXPECT_EQ(scorer.best()->evaluations, evaluator.ledger().charged);
  }
  Evaluator evaluator(problem, {10});
  EXPECT_EQ(evaluator.objective(point(7)), problem.evaluate(problem.upper).objective);
  EXPECT_EQ(evaluator.residuals(point(7))->values, problem.residuals(problem.upper).values);
}

/// Expects that the run is over where this is asked for, with what the problem threw.
template <class Error>
void expect_failure(const Problem& problem, Ask what) {
  Evaluator evaluator(problem, {10});
  EXPECT_FALSE(tells(evaluator, what, problem.start));
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::failure);
  EXPECT_THROW(std::rethrow_exception(evaluator.failure()), Error);
}

TEST(Evaluator, TakesWhatTheProblemThrowsAndDerivativesThatDoNotFitForAFailure) {
  Problem problem = curved_parabola(2);
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken scene"); };
  expect_failure<std::runtime_error>(problem, values);
  for (const Residuals& loss : {Residuals{Vector(0), Matrix(0, 2)},
                                {Vector::Ones(2), Matrix::Ones(3, 2)},
                                {Vector::Ones(2), Matrix::Ones(2, 3)}}) {
    problem.residuals = [&loss](const Vector&) { return loss; };
    expect_failure<std::logic_error>(problem, residuals);
  }
  for (const Matrix& loss : {Matrix(0, 2), Matrix(2, 3)}) {
    curve_by(problem, [&loss](const Vector&) { return loss; });
    expect_failure<std::logic_error>(problem, hessian);
  }
  problem.differentiate = nullptr;
  problem.residuals = nullptr;
  problem.lagrangian_hessian = nullptr;
  for (const Ask what : {derivatives, residuals, hessian}) {
    expect_failure<std::logic_error>(problem, what);
  }
}

TEST(Evaluator, ShowsASmootherProblemButJudgesByTheTrueValues) {
  Problem problem = parabola(1);
  problem.smoothed = [problem](double smoothing) {  // best at 0.25 + smoothing
    Problem smooth = problem;
    smooth.evaluate = [problem, smoothing](const Vector& x) {
      return problem.evaluate((x.array() - smoothing).matrix());
    };
    return smooth;
  };
  Scorer scorer(problem);
  Evaluator evaluator(problem, {100}, &scorer);
  EXPECT_EQ(evaluator.best_shown(), nullptr);
  evaluator.smooth(0.5);
  for (const double x : {0.375, 1.0, 0.75}) evaluator.values(point(x));
  EXPECT_EQ(*evaluator.best_shown(), point(0.75));
  EXPECT_EQ(scorer.best()->x, point(0.375));
  EXPECT_EQ(scorer.best()->true_values.objective, 0.015625);
  evaluator.smooth(0.25);
  EXPECT_EQ(evaluator.best_shown(), nullptr);
  EXPECT_EQ(evaluator.objective(point(0.75)), 0.0625) << "not remembered";
  EXPECT_EQ(evaluator.objective(point(0.5)), 0.0);
  EXPECT_EQ(*evaluator.best_shown(), point(0.5));
  EXPECT_EQ(evaluator.ledger().charged, 5);
  const Problem rough = parabola(1);
  EXPECT_THROW(Evaluator(rough, {100}).smooth(0.5), std::logic_error);
}

TEST(Evaluator, TellsASolverHowFarToTrustAGradient) {
  Problem problem = with_idle_knob(parabola(2));
  problem.differentiate = [differentiate = problem.differentiate](const Vector& x) {
    Derivatives d = differentiate(x);
    d.trust = {0.125, GradientDoubt::kink};
    return d;
  };
  for (const Problem& shown : {problem, instance(problem, 1), penalised(problem, 10)}) {
    const Trust trust = Evaluator(shown, {100}).derivatives(shown.start)->trust;
    EXPECT_EQ(trust.reach, 0.125);
    EXPECT_EQ(trust.doubt, GradientDoubt::kink);
  }
}

TEST(Evaluator, RefusesWhatIsNotAllowedForNow) {
  const Problem problem = parabola(1);
  Evaluator evaluator(problem, {10});
  double x = 0;
  const auto spend = [&] {
    int asked = 0;
    while (evaluator.values(point(x += 0.01))) ++asked;
    return asked;
  };
  evaluator.allow(3);
  EXPECT_EQ(evaluator.remaining(), 3);
  EXPECT_EQ(spend(), 3);
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::paused);
  EXPECT_TRUE(evaluator.over());
  evaluator.allow(4);
  EXPECT_FALSE(evaluator.over());
  EXPECT_EQ(spend(), 4);
  evaluator.allow(100);
  EXPECT_EQ(spend(), 3);
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::evaluations);
  evaluator.allow(100);
  EXPECT_TRUE(evaluator.over()) << "the budget is spent all the same";
}

// What a solver holds does not tell what a run is scored by. This is checked by the compiler.

// clang-format off
#define TELLS(expression) requires(T& t, const Vector& x) { expression; }
// clang-format on
template <class T>
constexpr std::array tells_of_the_run = {
    TELLS(t.problem()),    TELLS(t.problem_),        std::convertible_to<T&, const Problem&>,
    TELLS(t.trace()),      TELLS(t.scorer()),        std::convertible_to<T&, const Scorer&>,
    TELLS(t.scorer_),      TELLS(t.score()),         TELLS(t.true_values(x)),
    TELLS(t.true_values),  TELLS(t.best()),          TELLS(t.best_point),
    TELLS(t.best_point()), TELLS(t.best_known),      TELLS(t.best_known()),
    TELLS(t.evaluate(x)),  TELLS(t.differentiate(x))};
#undef TELLS

static_assert(std::ranges::count(tells_of_the_run<Evaluator>, true) == 0);
// The checks find what they look for.
static_assert(std::ranges::count(tells_of_the_run<Problem>, true) == 7);
static_assert(std::ranges::count(tells_of_the_run<Scorer>, true) == 3);
static_assert(!std::is_copy_constructible_v<Evaluator> && !std::is_move_constructible_v<Evaluator>,
              "a copy would have a budget of its own");
static_assert(!std::is_assignable_v<Evaluator&, const Evaluator&>);

// A solver is called with nothing else.
static_assert(std::is_same_v<decltype(Solver::solve),
                             std::function<SolverTermination(Evaluator&, const Vector&, Random&)>>);

}  // namespace
}  // namespace ricochet
