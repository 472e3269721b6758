#include "src/core/question.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "src/core/error.h"
#include "src/core/verdict.h"
#include "tests/core/test_problems.h"

namespace ricochet {
namespace {

/// parabola(2), whose coordinates must sum to 1 at least; `smooth`: with a knob that adds its
/// width.
Question question(bool constrained, bool smooth) {
  Question result{.stated = parabola(2), .width = 0.25, .penalty_weight = 10};
  if (constrained) {
    result.stated.constraints = 1;
    result.stated.evaluate = [evaluate = result.stated.evaluate](const Vector& x) {
      return Values{evaluate(x).objective, Vector::Constant(1, 1 - x.sum())};
    };
  }
  if (smooth) {
    result.stated.smoothed = [stated = result.stated](double width) {
      Problem problem = stated;
      problem.evaluate = [stated, width](const Vector& x) {
        Values values = stated.evaluate(x);
        values.objective += width;
        return values;
      };
      problem.truth = [stated](const Vector& x) { return truth_of(stated.evaluate(x)); };
      return problem;
    };
  }
  return result;
}

std::vector<std::string> names_of_forms(const Question& question,
                                        const std::vector<double>& widths = {}) {
  std::vector<std::string> names;
  for (const Form& form : question.forms(widths)) names.push_back(question.name_of(form));
  return names;
}

using Names = std::vector<std::string>;

TEST(Question, HasTheFormsThatItsConstraintsAndItsKnobAllow) {
  EXPECT_EQ(names_of_forms(question(false, false)), (Names{"as-stated"}));
  EXPECT_EQ(names_of_forms(question(true, false)), (Names{"as-stated", "penalised"}));
  EXPECT_EQ(names_of_forms(question(false, true)), (Names{"count", "surrogate"}));
  EXPECT_EQ(names_of_forms(question(true, true)),
            (Names{"count", "penalised-count", "surrogate", "penalised-surrogate"}));
}

TEST(Question, HasAFormOfEveryWidthOnce) {
  const double usual = question(true, false).width;
  EXPECT_EQ(names_of_forms(question(true, true), {0.1, usual}),
            (Names{"count", "penalised-count", "surrogate", "penalised-surrogate", "surrogate-0.1",
                   "penalised-surrogate-0.1"}));
  EXPECT_EQ(names_of_forms(question(true, false), {0.1}), (Names{"as-stated", "penalised"}));
}

TEST(Question, NamesAWidthThatIsNotTheUsualOne) {
  EXPECT_EQ(question(true, true).name_of({0.1}), "surrogate-0.1");
  EXPECT_EQ(question(true, true).name_of({0.1, true}), "penalised-surrogate-0.1");
}

TEST(Question, KnowsItsFormsByTheirNames) {
  const Question asked = question(true, true);
  for (const Form& form : asked.forms()) {
    EXPECT_EQ(asked.form_named(asked.name_of(form)), form);
  }
  EXPECT_EQ(asked.form_named(""), Form{});
  try {
    asked.form_named("surogate");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "surogate: parabola has no such form; did you mean surrogate or penalised-surrogate?");
  }
}

TEST(Question, IsShownInItsFormsAndJudgedByOneTruth) {
  const Question asked = question(true, true);
  const Vector outside = Vector::Constant(2, 0.25);
  const auto shown = [&](const Form& form) { return asked.problem(form).evaluate(outside); };
  EXPECT_EQ(shown({}).objective, 0);
  EXPECT_EQ(shown({}).constraints, Vector::Constant(1, 0.5));
  EXPECT_EQ(shown({0, true}).objective, 10 * 0.5);
  EXPECT_EQ(shown({0, true}).constraints.size(), 0);
  EXPECT_EQ(shown({0.125}).objective, 0.125);
  EXPECT_EQ(shown({0.125, true}).objective, 0.125 + 10 * 0.5);
  for (const Form& form : asked.forms()) {
    const Problem problem = asked.problem(form);
    EXPECT_EQ(problem.name, asked.name());
    EXPECT_EQ(truth_at(problem, outside).objective, 0);
    EXPECT_EQ(truth_at(problem, outside).violation, 0.5);
  }
}

TEST(Question, RefusesAFormThatItHasNot) {
  EXPECT_THROW(question(true, false).problem({0.25}), std::invalid_argument);
  EXPECT_THROW(question(false, true).problem({0, true}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
