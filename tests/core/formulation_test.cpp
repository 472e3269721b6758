#include <gtest/gtest.h>

#include <stdexcept>

#include "ricochet/error.h"
#include "ricochet/problem.h"
#include "ricochet/run.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

/// parabola(2), whose coordinates must sum to 1 at least; `smooth`: its surrogate adds the
/// smoothing parameter.
Problem problem(bool constrained, bool smooth) {
  Problem result = parabola(2);
  result.smoothing = 0.25;
  result.penalty_weight = 10;
  if (constrained) {
    result.constraints = 1;
    result.evaluate = [evaluate = result.evaluate](const Vector& x) {
      return Values{evaluate(x).objective, Vector::Constant(1, 1 - x.sum())};
    };
  }
  if (smooth) {
    result.smoothed = [stated = result](double smoothing) {
      Problem problem = stated;
      problem.evaluate = [stated, smoothing](const Vector& x) {
        Values values = stated.evaluate(x);
        values.objective += smoothing;
        return values;
      };
      problem.true_values = [stated](const Vector& x) {
        return true_values_of(stated.evaluate(x));
      };
      return problem;
    };
  }
  return result;
}

std::vector<std::string> names_of_formulations(const Problem& problem,
                                               const std::vector<double>& smoothings = {}) {
  std::vector<std::string> names;
  for (const Formulation& formulation : problem.formulations(smoothings))
    names.push_back(problem.name_of(formulation));
  return names;
}

using Names = std::vector<std::string>;

TEST(Problem, HasTheFormulationsThatItsConstraintsAndItsKnobAllow) {
  EXPECT_EQ(names_of_formulations(problem(false, false)), (Names{"original"}));
  EXPECT_EQ(names_of_formulations(problem(true, false)), (Names{"original", "penalised"}));
  EXPECT_EQ(names_of_formulations(problem(false, true)), (Names{"count", "surrogate"}));
  EXPECT_EQ(names_of_formulations(problem(true, true)),
            (Names{"count", "penalised-count", "surrogate", "penalised-surrogate"}));
}

TEST(Problem, HasAFormulationOfEverySmoothingOnce) {
  const double usual = problem(true, false).smoothing;
  EXPECT_EQ(names_of_formulations(problem(true, true), {0.1, usual}),
            (Names{"count", "penalised-count", "surrogate", "penalised-surrogate", "surrogate-0.1",
                   "penalised-surrogate-0.1"}));
  EXPECT_EQ(names_of_formulations(problem(true, false), {0.1}), (Names{"original", "penalised"}));
}

TEST(Problem, NamesASmoothingThatIsNotTheUsualOne) {
  EXPECT_EQ(problem(true, true).name_of({0.1}), "surrogate-0.1");
  EXPECT_EQ(problem(true, true).name_of({0.1, true}), "penalised-surrogate-0.1");
}

TEST(Problem, KnowsItsFormulationsByTheirNames) {
  const Problem asked = problem(true, true);
  for (const Formulation& formulation : asked.formulations()) {
    EXPECT_EQ(asked.formulation_named(asked.name_of(formulation)), formulation);
  }
  EXPECT_EQ(asked.formulation_named(""), Formulation{});
  try {
    asked.formulation_named("surogate");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "surogate: parabola has no such formulation; did you mean surrogate or "
                 "penalised-surrogate?");
  }
}

TEST(Problem, IsShownInItsFormulationsAndJudgedByOneTrueValues) {
  const Problem asked = problem(true, true);
  const Vector outside = Vector::Constant(2, 0.25);
  const auto shown = [&](const Formulation& formulation) {
    return asked.formulated(formulation).evaluate(outside);
  };
  EXPECT_EQ(shown({}).objective, 0);
  EXPECT_EQ(shown({}).constraints, Vector::Constant(1, 0.5));
  EXPECT_EQ(shown({0, true}).objective, 10 * 0.5);
  EXPECT_EQ(shown({0, true}).constraints.size(), 0);
  EXPECT_EQ(shown({0.125}).objective, 0.125);
  EXPECT_EQ(shown({0.125, true}).objective, 0.125 + 10 * 0.5);
  for (const Formulation& formulation : asked.formulations()) {
    const Problem problem = asked.formulated(formulation);
    EXPECT_EQ(problem.name, asked.name);
    EXPECT_EQ(true_values_at(problem, outside).objective, 0);
    EXPECT_EQ(true_values_at(problem, outside).violation, 0.5);
  }
}

TEST(Problem, RefusesAFormulationThatItHasNot) {
  EXPECT_THROW(problem(true, false).formulated({0.25}), std::invalid_argument);
  EXPECT_THROW(problem(false, true).formulated({0, true}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
