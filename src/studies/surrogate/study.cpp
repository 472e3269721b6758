#include "src/studies/surrogate/study.h"

#include <cmath>

#include "ricochet/problem.h"
#include "src/studies/surrogate/continuity.h"
#include "src/studies/surrogate/derivative_check.h"
#include "src/studies/surrogate/growth.h"

namespace ricochet::studies {

namespace {

using namespace surrogate;

struct Plan {
  BiasPlan bias;
  ContinuationPlan continuation;
  GradientDoubtPlan gradient_doubt;
  ContinuityPlan continuity;
  GrowthPlan growth;
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
          {15, {200, 400}},
          {18, 20, {1, 0.5, 0.25, 0.1, 0.05, 0.01}, falling(-2, -11, 1)},
          {{1, 0.25, 0.05}, 100'000, 1},
          {{3, 6, 10, 15}, {2, 5, 10, 20, 50}, {400, 3, {0.25, 0.05}, falling(-1, -12, 1)}},
          {all_families(), 10'000, 1}};
}

Plan quick_plan() {
  return {{0.1, {1, 0.25, 0.01}},
          {1, {100}},
          {6, 5, {0.25}, falling(-3, -9, 0)},
          {{0.25}, 240, 1},
          {{5}, {2, 10}, {400, 1, {0.25}, falling(-4, -11, 0)}},
          {all_families(), 300, 1}};
}

report::Json results_of(const Plan& plan) {
  return {{"bias", data_of(study_bias(plan.bias))},
          {"continuation", data_of(study_continuation(plan.continuation))},
          {"gradient_doubt", data_of(study_gradient_doubt(plan.gradient_doubt))},
          {"continuity", data_of(study_continuity(plan.continuity))},
          {"growth", data_of(study_growth(plan.growth))},
          {"derivative_check", data_of(study_derivative_check(plan.derivative_check))}};
}

}  // namespace

Study surrogate_study() {
  return {"surrogate", "A coarser study, in seconds",
          [](bool quick) { return results_of(quick ? quick_plan() : full_plan()); }};
}

}  // namespace ricochet::studies
