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

/// What was asked of the problem, what it is charged, and how many calls were refused.
struct Counts {
  std::int64_t values, derivatives, hessians, charged, refused = 0;
  bool operator==(const Counts&) const = default;
};

std::ostream& operator<<(std::ostream& stream, const Counts& c) {
  return stream << c.values << " values, " << c.derivatives << " derivatives, " << c.hessians
                << " Hessians, charged " << c.charged << ", refused " << c.refused;
}

Counts counts(Evaluator& evaluator) {
  const Ledger all = evaluator.ledger();
  return {all.values, all.derivatives, all.hessians, all.charged, all.refused};
}

enum class Ask { values, derivatives, residuals, residual_values, hessian };

/// What a solver asks for at a point of equal coordinates, and the counts after that.
struct Call {
  Ask what;
  double at;
  Counts after;
  Part part = Part::everything;
};

void expect_counts(Evaluator& evaluator, const std::vector<Call>& calls) {
  for (std::size_t k = 0; k < calls.size(); ++k) {
    const auto& [what, at, after, part] = calls[k];
    const std::int64_t refused = evaluator.ledger().refused;
    const Vector x = point(at, evaluator.dimension());
    const bool told = what == Ask::values        ? evaluator.values(x, part).has_value()
                      : what == Ask::derivatives ? evaluator.derivatives(x, part).has_value()
                      : what == Ask::residuals   ? evaluator.residuals(x, part).has_value()
                      : what == Ask::residual_values
                          ? evaluator.residual_values(x, part).has_value()
                          : evaluator.lagrangian_hessian(x, 1, Vector()).has_value();
    EXPECT_EQ(told, after.refused == refused) << "call " << k;
    EXPECT_EQ(counts(evaluator), after) << "call " << k;
  }
}

/// Expects that the run is over for this reason, with what the problem threw.
template <class Error>
void expect_failed(const Evaluator& evaluator) {
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::failure);
  EXPECT_THROW(std::rethrow_exception(evaluator.failure()), Error);
}

/// parabola(n) with second derivatives.
Problem curved_parabola(Eigen::Index n) {
  Problem problem = parabola(n);
  curve_by(problem, constant_hessian(n, 2));
  return problem;
}

using enum Ask;

TEST(Evaluator, ChargesOneForValuesAndOnePlusNForDerivativesAndRemembersThem) {
  const Problem problem = parabola(3);
  Evaluator evaluator(problem, {100});
  expect_counts(evaluator, {{values, 0.5, {1, 0, 0, 1}},
                            {derivatives, 0.25, {1, 1, 0, 1 + 4}},
                            {values, 0.25, {1, 1, 0, 1 + 4}},
                            {values, 0.75, {2, 1, 0, 1 + 4 + 1}},
                            {derivatives, 0.75, {2, 2, 0, 1 + 4 + 1 + 3}}});
  const Vector x = point(0.25, 3);
  const double objective = evaluator.derivatives(x)->values.objective;
  EXPECT_EQ(evaluator.values(x)->objective, objective);
  EXPECT_EQ(objective, problem.evaluate(x).objective);
}

TEST(Evaluator, ChargesWhoAsksForTheSameAgain) {
  const Problem problem = parabola(2);
  Evaluator evaluator(problem, {100});
  expect_counts(evaluator, {{values, 0.5, {1, 0, 0, 1}, Part::nothing},
                            {values, 0.5, {1, 0, 0, 1}, Part::objective},  // another quantity
                            {values, 0.5, {1, 0, 0, 1}, Part::inequalities},
                            {values, 0.5, {1, 0, 0, 1}, Part::equalities},
                            {values, 0.5, {2, 0, 0, 2}, Part::objective},  // asked anew
                            {values, 0.5, {3, 0, 0, 3}},
                            {derivatives, 0.5, {3, 1, 0, 3 + 2}, Part::objective},
                            {derivatives, 0.5, {3, 1, 0, 3 + 2}, Part::inequalities},
                            {derivatives, 0.5, {3, 2, 0, 3 + 2 + 3}, Part::objective}});
}

TEST(Evaluator, ChargesAGradientThePriceOfTheBudget) {
  const Problem problem = curved_parabola(4);
  struct Price {
    std::optional<std::int64_t> of_gradient;
    std::int64_t charged, of_hessian;
  };
  for (const auto& [price, charged, of_hessian] :
       {Price{{}, 4, 10}, Price{0, 0, 1}, Price{1, 1, 2}, Price{3, 3, 7}, Price{10, 10, 25}}) {
    Evaluator evaluator(problem, {.evaluations = 1000, .gradient_price = price});
    expect_counts(evaluator,
                  {{derivatives, 0.5, {0, 1, 0, 1 + charged}},
                   {values, 0.25, {1, 1, 0, 2 + charged}},
                   {derivatives, 0.25, {1, 2, 0, 2 + 2 * charged}},  // the value was paid
                   {residuals, 0.75, {1, 3, 0, 3 + 3 * charged}},
                   {hessian, 0.75, {1, 3, 1, 3 + 3 * charged + of_hessian}}});
  }
}

TEST(Evaluator, ChargesOnePlusNForResidualsAndRemembersThem) {
  const Problem problem = parabola(3);
  Evaluator evaluator(problem, {100});
  expect_counts(evaluator, {{values, 0.5, {1, 0, 0, 1}},
                            {residuals, 0.5, {1, 1, 0, 1 + 4}},  // values make them no cheaper
                            {residuals, 0.5, {1, 1, 0, 1 + 4}, Part::jacobian},
                            {residuals, 0.25, {1, 2, 0, 1 + 4 + 4}},
                            {residuals, 0.25, {1, 3, 0, 1 + 4 + 4 + 4}}});
  EXPECT_EQ(evaluator.residuals(point(0.25, 3), Part::jacobian)->values,
            problem.residuals(point(0.25, 3)).values);
}

TEST(Evaluator, ChargesOneForResidualsAloneAndNForTheirDerivatives) {
  const Problem problem = parabola(3);
  Evaluator evaluator(problem, {10});
  const Vector x = point(0.5, 3);
  expect_counts(evaluator, {{residual_values, 0.5, {0, 1, 0, 1}, Part::nothing}});
  EXPECT_EQ(*evaluator.residual_values(x), problem.residuals(x).values) << "paid before";
  EXPECT_EQ(evaluator.residuals(x)->jacobian, problem.residuals(x).jacobian);
  expect_counts(evaluator, {{residual_values, 0.5, {0, 2, 0, 5}},  // who asks again pays again
                            {residuals, 0.25, {0, 3, 0, 9}},
                            {residual_values, 0.5, {0, 4, 0, 10}},
                            {residuals, 0.5, {0, 4, 0, 10, 1}}});  // three more are not left
}

TEST(Evaluator, ChargesAHessianForEachOfItsOwnEntries) {
  const Problem problem = curved_parabola(3);
  Evaluator evaluator(problem, {100});
  expect_counts(evaluator, {{derivatives, 0.5, {0, 1, 0, 4}},
                            {hessian, 0.5, {0, 1, 1, 4 + 6}},
                            {values, 0.5, {0, 1, 1, 4 + 6}},  // what was known still is
                            {hessian, 0.5, {0, 1, 2, 4 + 6 + 6}}});
  EXPECT_EQ(evaluator.lagrangian_hessian(point(0.5, 3), 1.5, Vector()), 3 * Matrix::Identity(3, 3));
}

TEST(Evaluator, EndsASolverThatAsksForEver) {
  const Problem problem = parabola(2);
  Evaluator at_one_point(problem, {100});
  int asked = 0;
  while (at_one_point.objective(problem.start)) ++asked;
  EXPECT_EQ(asked, 100);
  for (const bool move : {false, true}) {
    Evaluator evaluator(problem, {.evaluations = 10, .gradient_price = 0});
    Vector x = point(0.5, 2);
    for (asked = 0; asked < 1000 && evaluator.derivatives(x); ++asked) x[0] += move ? 0.001 : 0;
    EXPECT_EQ(asked, 10) << "gradients cost nothing";
  }
}

TEST(Evaluator, RefusesOnceTheBudgetIsSpentOrDoesNotCoverWhatIsAsked) {
  const Problem problem = curved_parabola(3);
  struct Spent {
    std::int64_t budget;
    std::vector<Call> calls;
  };
  for (const auto& [budget, calls] :
       std::vector<Spent>{{2,
                           {{values, 0.1, {1, 0, 0, 1}},
                            {values, 0.2, {2, 0, 0, 2}},
                            {values, 0.3, {2, 0, 0, 2, 1}},
                            {values, 0.2, {2, 0, 0, 2, 2}}}},
                          {3, {{derivatives, 0.5, {0, 0, 0, 0, 1}}}},
                          {5, {{hessian, 0.5, {0, 0, 0, 0, 1}}}},
                          {7,
                           {{residuals, 0.5, {0, 1, 0, 4}},
                            {residuals, 0.25, {0, 1, 0, 4, 1}},
                            {residuals, 0.5, {0, 1, 0, 4, 2}}}}}) {  // not even what it remembers
    Evaluator evaluator(problem, {budget});
    EXPECT_EQ(evaluator.remaining(), budget);
    expect_counts(evaluator, calls);
    EXPECT_TRUE(evaluator.over());
    EXPECT_EQ(evaluator.remaining(), 0);
    EXPECT_EQ(evaluator.termination_reason(), TerminationReason::evaluations);
  }
}

TEST(Evaluator, RefusesOnceTheTimeIsSpent) {
  const Problem problem = parabola(1);
  Evaluator evaluator(problem, {1000000, 0.0});
  EXPECT_FALSE(evaluator.objective(point(0.1)));
  EXPECT_EQ(evaluator.termination_reason(), TerminationReason::seconds);
}

TEST(Evaluator, RefusesPointsThatAreNotFiniteOrOfTheWrongLength) {
  const Problem problem = parabola(2);
  for (const Vector& x : {point(quiet_nan, 2), point(0.5, 3)}) {
    Evaluator evaluator(problem, {10}), other(problem, {10});
    EXPECT_FALSE(evaluator.values(x));
    EXPECT_EQ(evaluator.termination_reason(), TerminationReason::bad_point);
    EXPECT_FALSE(other.residuals(x));
    EXPECT_EQ(other.termination_reason(), TerminationReason::bad_point);
  }
}

TEST(Evaluator, EvaluatesAPointOutsideTheBoxAtItsProjectionAndScoresItThere) {
  const Problem problem = curved_parabola(1);
  for (const Call& call : {Call{values, 7, {1, 0, 0, 1}}, Call{residuals, 7, {0, 1, 0, 2}},
                           Call{hessian, 7, {0, 0, 1, 1}}}) {
    Scorer scorer(problem);
    Evaluator evaluator(problem, {10}, &scorer);
    expect_counts(evaluator, {call});
    EXPECT_EQ(scorer.best()->x, problem.upper);
    EXPECT_EQ(scorer.best()->evaluations, call.after.charged);
  }
  Evaluator evaluator(problem, {10});
  EXPECT_EQ(evaluator.objective(point(7)), problem.evaluate(problem.upper).objective);
  EXPECT_EQ(evaluator.residuals(point(7))->values, problem.residuals(problem.upper).values);
}

TEST(Evaluator, StoresAnExceptionOfTheProblemAndRefusesFromThenOn) {
  Problem problem = parabola(1);
  problem.evaluate = [](const Vector&) -> Values { throw std::runtime_error("broken scene"); };
  Evaluator evaluator(problem, {10});
  EXPECT_FALSE(evaluator.objective(point(0.1)));
  expect_failed<std::runtime_error>(evaluator);
}

TEST(Evaluator, TakesDerivativesThatDoNotFitOrAreNotThereForAFailure) {
  Problem problem = curved_parabola(2);
  for (const std::optional<Residuals>& loss : {std::optional(Residuals{Vector(0), Matrix(0, 2)}),
                                               {Residuals{Vector::Ones(2), Matrix::Ones(3, 2)}},
                                               {Residuals{Vector::Ones(2), Matrix::Ones(2, 3)}},
                                               {}}) {
    problem.residuals = nullptr;
    if (loss) problem.residuals = [&loss](const Vector&) { return *loss; };
    Evaluator evaluator(problem, {10});
    EXPECT_FALSE(evaluator.residuals(problem.start));
    expect_failed<std::logic_error>(evaluator);
  }
  for (const std::optional<Matrix>& loss :
       {std::optional(Matrix(0, 2)), {Matrix(2, 3)}, std::optional<Matrix>()}) {
    problem.lagrangian_hessian = nullptr;
    if (loss) curve_by(problem, [&loss](const Vector&) { return *loss; });
    Evaluator evaluator(problem, {10});
    EXPECT_FALSE(evaluator.lagrangian_hessian(problem.start, 1, Vector()));
    expect_failed<std::logic_error>(evaluator);
  }
}

/// parabola(1), whose smoothed formulation has its best point at 0.25 + smoothing parameter.
Problem smoothed_parabola() {
  Problem problem = parabola(1);
  problem.smoothed = [problem](double smoothing) {
    Problem smooth = problem;
    smooth.evaluate = [problem, smoothing](const Vector& x) {
      return problem.evaluate((x.array() - smoothing).matrix());
    };
    return smooth;
  };
  return problem;
}

TEST(Evaluator, ShowsASmootherProblemButJudgesByTheTrueValues) {
  const Problem problem = smoothed_parabola();
  Scorer scorer(problem);
  Evaluator evaluator(problem, {100}, &scorer);
  evaluator.smooth(0.5);
  EXPECT_EQ(evaluator.objective(point(0.75)), 0.0);
  EXPECT_EQ(scorer.best()->true_values.objective, 0.25);
  evaluator.smooth(0.25);
  EXPECT_EQ(evaluator.objective(point(0.75)), 0.0625) << "not remembered";
  EXPECT_EQ(evaluator.ledger().charged, 2);
  const Problem rough = parabola(1);
  EXPECT_THROW(Evaluator(rough, {100}).smooth(0.5), std::logic_error);
}

TEST(Evaluator, TellsTheBestPointShownAtTheSmoothingOfNow) {
  const Problem problem = smoothed_parabola();
  Evaluator evaluator(problem, {100});
  EXPECT_EQ(evaluator.best_shown(), nullptr);
  evaluator.smooth(0.5);
  for (const double x : {0.25, 0.75, 1.0}) evaluator.values(point(x));
  EXPECT_EQ((*evaluator.best_shown())[0], 0.75);
  evaluator.smooth(0.25);
  EXPECT_EQ(evaluator.best_shown(), nullptr);
  for (const double x : {0.75, 0.5}) evaluator.values(point(x));
  EXPECT_EQ((*evaluator.best_shown())[0], 0.5);
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
concept TellsTheProblem = TELLS(t.problem()) ||
    TELLS(t.problem_) || std::convertible_to<T&, const Problem&>;
template <class T>
concept TellsTheTrueObjective = TELLS(t.true_values(x)) || TELLS(t.true_values) || TELLS(t.score());
template <class T>
concept TellsTheBestPoint = TELLS(t.best()) || TELLS(t.best_point) || TELLS(t.best_point());
template <class T>
concept TellsTheBestValue = TELLS(t.best_known) || TELLS(t.best_known());
template <class T>
concept TellsTheTrace = TELLS(t.trace()) || TELLS(t.scorer()) ||
    TELLS(t.scorer_) || std::convertible_to<T&, const Scorer&>;
template <class T>
concept EvaluatesForNothing = TELLS(t.evaluate(x)) || TELLS(t.differentiate(x));
#undef TELLS

static_assert(!TellsTheProblem<Evaluator> && !TellsTheTrueObjective<Evaluator> &&
              !TellsTheBestPoint<Evaluator> && !TellsTheBestValue<Evaluator> &&
              !TellsTheTrace<Evaluator> && !EvaluatesForNothing<Evaluator>);
static_assert(!std::is_copy_constructible_v<Evaluator> && !std::is_move_constructible_v<Evaluator>,
              "a copy would have a budget of its own");
static_assert(!std::is_assignable_v<Evaluator&, const Evaluator&>);

// The checks find what they look for.
static_assert(TellsTheTrueObjective<Problem> && TellsTheBestPoint<Problem> &&
              TellsTheBestValue<Problem> && EvaluatesForNothing<Problem> &&
              TellsTheProblem<Problem>);
static_assert(TellsTheBestPoint<Scorer> && TellsTheTrace<Scorer>);

// A solver is called with nothing else.
static_assert(std::is_same_v<decltype(Solver::solve),
                             std::function<SolverTermination(Evaluator&, const Vector&, Random&)>>);

}  // namespace
}  // namespace ricochet
