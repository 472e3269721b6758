#include "src/studies/surrogate/study.h"

#include <chrono>
#include <cmath>

#include "problems/families.h"

namespace ricochet::studies::surrogate {
namespace {

/// Powers of ten, and `between` values more in each decade.
std::vector<double> falling(int first, int last, int between) {
  std::vector<double> values;
  for (int k = 0; k <= (first - last) * (between + 1); ++k) {
    values.push_back(std::pow(10.0, first - static_cast<double>(k) / (between + 1)));
  }
  return values;
}

}  // namespace

StudyPlan full_plan() {
  return {{0.01, {1, 0.5, 0.25, 0.1, 0.05, 0.02, 0.01, 0.003, 0.001}},
          {15, {200, 400}},
          {18, 20, {1, 0.5, 0.25, 0.1, 0.05, 0.01}, falling(-2, -11, 1)},
          {{1, 0.25, 0.05}, 100'000, 1},
          {{3, 6, 10, 15}, {2, 5, 10, 20, 50}, {400, 3, {0.25, 0.05}, falling(-1, -12, 1)}},
          {all_families(), 10'000, 1}};
}

StudyPlan quick_plan() {
  return {{0.1, {1, 0.25, 0.01}},
          {1, {100}},
          {6, 5, {0.25}, falling(-3, -9, 0)},
          {{0.25}, 240, 1},
          {{5}, {2, 10}, {400, 1, {0.25}, falling(-4, -11, 0)}},
          {all_families(), 300, 1}};
}

Study make_study(const StudyPlan& plan) {
  const auto start = std::chrono::steady_clock::now();
  Study study;
  study.plan = plan;
  study.gap = study_bias(plan.gap);
  study.guidance = study_continuation(plan.guidance);
  study.validity = study_gradient_doubt(plan.validity);
  study.continuity = study_continuity(plan.continuity);
  study.growth = study_growth(plan.growth);
  study.agreement = study_derivative_check(plan.agreement);
  study.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return study;
}

}  // namespace ricochet::studies::surrogate
