#include <gtest/gtest.h>

#include "src/studies/calibration/appraisal.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

TEST(Sensitivity, HasTheSlopesThatScalingDemands) {
  // Without disturbance all forces may grow as one, and with them clearance and speeds of start
  // and limit in the same measure: the thresholds stay. So their logarithmic slopes add up to none.
  const FittedInterpretation& fitted = default_interpretation();
  Fit fit{fitted.interpretation,
          {Unknown::pull, Unknown::normal_force, Unknown::centrifugal_mass_radius,
           Unknown::clearance, Unknown::counting_limit},
          fitted.constants,
          0,
          {}};
  fit.constants[static_cast<std::size_t>(Unknown::start_velocity)] = 0;
  for (const CaseSensitivity& row : sensitivities(fit, 0.05)) {
    ASSERT_EQ(row.slopes.size(), 5U);
    if (row.case_id != "C1" && row.case_id != "C3") continue;
    double sum = 0;
    for (const auto& slope : row.slopes) sum += slope.value_or(1e9);
    EXPECT_NEAR(sum, 0, 1.0) << row.case_id;
  }
}

TEST(Sensitivity, ProfilesAroundTheFit) {
  Fit fit{some_parameterisation().interpretation,
          some_parameterisation().free,
          some_parameterisation().held,
          0,
          {}};
  fit.loss = calibration_problem(some_parameterisation())
                 .evaluate(calibration_problem(some_parameterisation()).start)
                 .objective;
  const auto found = profiles(fit, some_search(2));
  ASSERT_EQ(found.size(), 2U);
  for (const Profile& p : found) {
    const auto i = static_cast<std::size_t>(p.constant);
    EXPECT_NEAR(p.value, fit.constants[i], 1e-9 * std::abs(fit.constants[i]));
    EXPECT_LE(p.lower, p.value);
    EXPECT_GE(p.upper, p.value);
    EXPECT_GE(p.points.size(), 3U);
    for (std::size_t k = 1; k < p.points.size(); ++k) {
      EXPECT_GT(p.points[k].first, p.points[k - 1].first);
    }
  }
}

}  // namespace
}  // namespace ricochet::studies::calibration
