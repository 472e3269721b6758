#include <gtest/gtest.h>

#include <set>

#include "src/experiment/perturbations.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

/// Replaces everything by what is drawn.
void draw(Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws& draws) {
  for (double& value : values) value = draws.uniform();
  for (double& slope : slopes.reshaped()) slope = draws.uniform();
}

/// All numbers that the problem tells at x, one after the other.
std::vector<double> numbers(const Problem& problem, const Vector& x) {
  std::vector<double> all;
  const auto add = [&all](const auto& list) {
    for (const double number : list.reshaped()) all.push_back(number);
  };
  const Derivatives d = problem.differentiate(x);
  all.push_back(d.values.objective);
  add(d.values.constraints);
  add(d.gradient);
  add(d.jacobian);
  const Residuals r = problem.residuals(x);
  add(r.values);
  add(r.jacobian);
  const Matrix hessian = problem.lagrangian_hessian(x, 1, Vector::Ones(problem.constraints));
  EXPECT_EQ(hessian, hessian.transpose());
  for (Eigen::Index j = 0; j < x.size(); ++j) add(hessian.col(j).head(j + 1));
  return all;
}

TEST(Telling, DrawsForEveryNumberByItself) {
  for (const Problem& problem : random_problems()) {
    for (const Drawn drawn : {Drawn::by_call, Drawn::by_point}) {
      const Problem told = told_by(draw, drawn, 3, problem);
      std::vector<double> all = numbers(told, problem.start);
      const std::vector<double> elsewhere = numbers(told, *problem.best_point);
      all.insert(all.end(), elsewhere.begin(), elsewhere.end());
      EXPECT_EQ(std::set<double>(all.begin(), all.end()).size(), all.size());
    }
  }
}

TEST(Telling, RepeatsAtAPointOrNever) {
  for (const Problem& problem : random_problems()) {
    const Problem by_point = told_by(draw, Drawn::by_point, 3, problem);
    EXPECT_EQ(numbers(by_point, problem.start), numbers(by_point, problem.start));
    const Problem by_call = told_by(draw, Drawn::by_call, 3, problem);
    const Problem again = told_by(draw, Drawn::by_call, 3, problem);
    std::vector<double> all = numbers(by_call, problem.start);
    EXPECT_EQ(numbers(again, problem.start), all);
    const std::vector<double> later = numbers(by_call, problem.start);
    all.insert(all.end(), later.begin(), later.end());
    EXPECT_EQ(std::set<double>(all.begin(), all.end()).size(), all.size());
  }
}

TEST(Telling, TellsTheSameValuesWithDerivativesAndWithout) {
  for (const Problem& problem : random_problems()) {
    const Problem told = told_by(draw, Drawn::by_point, 3, problem);
    const Values alone = told.evaluate(problem.start);
    const Values beside = told.differentiate(problem.start).values;
    EXPECT_EQ(alone.objective, beside.objective);
    EXPECT_EQ(alone.constraints, beside.constraints);
  }
}

TEST(Telling, CountsTheCallsOfEverySmoothingTogether) {
  const Problem problem = random_problems().front();
  const Problem told = told_by(draw, Drawn::by_call, 3, problem);
  const double first = told.evaluate(problem.start).objective;
  const double second = told.smoothed(0.1).evaluate(problem.start).objective;
  EXPECT_NE(first, second);
  EXPECT_NE(told.evaluate(problem.start).objective, second);
}

}  // namespace
}  // namespace ricochet
