#include "src/research/long_run/count_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ricochet/regimes.h"
#include "ricochet/solvers.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::long_run {
namespace {

using namespace carrier_track;
using variants::VariantConstants;

CountPlan brief_plan(std::int64_t evaluations) {
  return {{solver_named("pagmo-sade"), {}, solver_named("nlopt-sbplx"), evaluations}, 1, 0.5};
}

TEST(CountFit, CountsTheTurnsOfTheWindow) {
  for (const CountInterpretation& what : count_interpretations()) {
    VariantConstants constants{default_interpretation().constants, {}};
    constants.base[static_cast<std::size_t>(Unknown::revolutions)] = 2.4;
    const auto count = what.variant.counts(find_case("C1"), constants, variants::judging);
    const auto brief = what.variant.counts(find_case("C1"), constants, variants::searching);
    EXPECT_EQ(count(0.5), 0) << what.variant.name;
    EXPECT_EQ(count(5), 5) << what.variant.name << ": 2.4 turns of 2";
    EXPECT_EQ(brief(5), 5) << what.variant.name;
  }
}

TEST(CountFit, HasNoEffectOfTheStart) {
  const CountInterpretation what = count_interpretations().at(1);
  VariantConstants constants{default_interpretation().constants, {}};
  const auto count = what.variant.counts(find_case("C2"), constants, variants::judging);
  constants.base[static_cast<std::size_t>(Unknown::start_velocity)] = 0;
  const auto other = what.variant.counts(find_case("C2"), constants, variants::judging);
  for (const double omega : {1.0, 1.7, 2.5, 9.0}) EXPECT_EQ(count(omega), other(omega)) << omega;
}

TEST(CountFit, LowersTheLoss) {
  const CountInterpretation what = count_interpretations().at(1);
  const CountFit fit = fitted(what, brief_plan(90));
  EXPECT_LT(fit.loss, variants::loss_of(what.variant, variants::start_of(what.variant)));
  EXPECT_EQ(fit.loss, variants::loss_of(what.variant, {fit.fit.constants, {}}));
  EXPECT_EQ(fit.left_out.size(), 10U);
  EXPECT_EQ(fit.appraisal.cases.size(), 12U);
}

TEST(CountFit, ReachesThePurityThatIsItsGoal) {
  const CountInterpretation what = count_interpretations().back();
  ASSERT_EQ(what.goal, Goal::purity);
  const CountFit fit = fitted(what, brief_plan(6));
  EXPECT_GE(fit.appraisal.purity, purity_goal);
}

TEST(CountFit, TakesAMissingThresholdAsTheEndOfTheRange) {
  calibration::CaseAppraisal judged{find_case("C1"), {0.5, {0, 0}}, {}};
  EXPECT_NEAR(error_of(judged), std::log(18 / 9.0), 1e-12);
  judged.scan.counts = {9, 9};
  EXPECT_NEAR(error_of(judged), std::log(0.5 / 9.0), 1e-12);
  judged.score.threshold = 8;
  EXPECT_NEAR(error_of(judged), std::log(8 / 9.0), 1e-12);
}

}  // namespace
}  // namespace ricochet::studies::long_run
