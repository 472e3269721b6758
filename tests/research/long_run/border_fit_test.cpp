#include "src/research/long_run/border_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ricochet/regimes.h"
#include "ricochet/solvers.h"
#include "src/research/long_run/count_fit.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::long_run {
namespace {

using namespace carrier_track;

BorderPlan short_plan() {
  return {solver_named("pagmo-sade"), solver_named("ceres-trust-region"),
          solver_named("nlopt-sbplx"), 24, 5};
}

double squares_of(const std::vector<double>& errors) {
  double squares = 0;
  for (const double error : errors) squares += error * error;
  return squares;
}

const BorderInterpretation two_a_turn = {
    "2", 2, Louder::all, {Unknown::centrifugal_mass_radius, Unknown::counting_limit}};

TEST(BorderFit, HasTheBordersOfTheCases) {
  BorderInterpretation what = two_a_turn;
  const Constants& constants = default_interpretation().constants;
  const auto all = exact_borders(what, constants);
  what.louder = Louder::some;
  const auto some = exact_borders(what, constants);
  const auto law = law_borders(what, constants);
  const auto cases = cases_with_threshold();
  ASSERT_EQ(some.size(), cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Scene machine = scene_of(cases[i], default_interpretation().scene);
    if (cases[i].disturbance == 0) {
      EXPECT_EQ(some[i], quiet_up_to(machine, 2)) << cases[i].id;
      EXPECT_NEAR(*all[i] / *some[i], 1, 2e-3) << cases[i].id;  // the pull is small
      EXPECT_NEAR(*law[i] / *some[i], 1, 1e-9) << cases[i].id;
    } else {
      EXPECT_GT(*all[i], *some[i]) << cases[i].id;
    }
  }
}

TEST(BorderFit, ComesNearerThanItsStartAndSaysWhatIsDetermined) {
  const BorderFit fit = fitted(two_a_turn, short_plan());
  std::vector<double> start;
  const auto borders = law_borders(two_a_turn, default_interpretation().constants);
  const auto cases = cases_with_threshold();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    start.push_back(std::log(*borders[i] / *cases[i].claim.threshold));
  }
  EXPECT_LT(squares_of(fit.law_errors), 0.6 * squares_of(start));
  EXPECT_NEAR(squares_of(fit.errors), squares_of(fit.law_errors), 0.01);
  EXPECT_GT(squares_of(fit.left_out), squares_of(fit.errors));
  ASSERT_EQ(fit.directions.size(), 2U);
  EXPECT_LT(fit.directions[0].half_width, fit.directions[1].half_width);
  for (const Direction& d : fit.directions) EXPECT_NEAR(squares_of(d.weights), 1, 1e-12);
  ASSERT_EQ(fit.intervals.size(), 2U);
  for (const ParameterInterval& p : fit.intervals) {
    EXPECT_LT(p.lower, p.value);
    EXPECT_GT(p.upper, p.value);
    EXPECT_FALSE(p.lower_open || p.upper_open);
  }
}

TEST(BorderFit, CannotDetermineForceScaleAndMassRadiusTogether) {
  BorderInterpretation what = two_a_turn;
  what.free = {Unknown::centrifugal_mass_radius, Unknown::clearance, Unknown::counting_limit,
               Unknown::normal_force};
  const BorderFit fit = fitted(what, short_plan());
  EXPECT_GT(fit.directions.back().half_width, 2) << "all four scale together without disturbance";
}

}  // namespace
}  // namespace ricochet::studies::long_run
