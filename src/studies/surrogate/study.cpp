#include "src/studies/surrogate/study.h"

#include <cmath>

#include "ricochet/problem.h"
#include "src/studies/surrogate/continuity.h"
#include "src/studies/surrogate/derivative_check.h"
#include "src/studies/surrogate/grazes.h"

namespace ricochet::studies {

namespace {

using namespace surrogate;

struct Plan {
  BiasPlan bias;
  ContinuityPlan continuity;
  GradientDoubtPlan gradient_doubt;
  GrazePlan grazes;
  DerivativeCheckPlan derivative_check;
};

/// Powers of ten, with `between` further values in each decade.
std::vector<double> falling(int first, int last, int between) {
  std::vector<double> values;
  for (int k = 0; k <= (first - last) * (between + 1); ++k) {
    values.push_back(std::pow(10.0, first - static_cast<double>(k) / (between + 1)));
  }
  return values;
}

Plan full_plan() {
  return {{0.01, {1, 0.5, 0.25, 0.1, 0.05, 0.02, 0.01, 0.003, 0.001}},
          {{1, 0.25, 0.05}, 100'000, 1},
          {18, 20, {1, 0.5, 0.25, 0.1, 0.05, 0.01}, falling(-2, -11, 1)},
          {400, 3, {0.25, 0.05}, falling(-6, -12, 1)},
          {all_families(), 10'000, 1}};
}

Plan quick_plan() {
  return {{0.1, {1, 0.25, 0.01}},
          {{0.25}, 240, 1},
          {6, 5, {0.25}, falling(-3, -9, 0)},
          {400, 1, {0.25}, falling(-6, -11, 0)},
          {all_families(), 300, 1}};
}

report::Json results_of(const Plan& plan) {
  report::Results results;
  add_to(results, study_bias(plan.bias));
  add_to(results, study_continuity(plan.continuity));
  add_to(results, study_gradient_doubt(plan.gradient_doubt));
  add_to(results, study_grazes(plan.grazes));
  add_to(results, study_derivative_check(plan.derivative_check));
  return json_of(results);
}

}  // namespace

Study surrogate_study() {
  return {"surrogate", "A coarser study, in seconds",
          [](bool quick) { return results_of(quick ? quick_plan() : full_plan()); }};
}

}  // namespace ricochet::studies
