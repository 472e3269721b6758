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
  Parameterisation fit = fitted;
  fit.free = {Unknown::pull, Unknown::normal_force, Unknown::centrifugal_mass_radius,
              Unknown::clearance, Unknown::counting_limit};
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
  Fit fit{some_parameterisation()};
  fit.loss = loss(fit);
  Searches searches(fresh_file(), some_provenance());
  const auto found = profiles(fit, some_search(2), searches);
  ASSERT_EQ(found.size(), 2U);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Profile& p = found[k];
    const auto i = static_cast<std::size_t>(p.constant);
    EXPECT_NEAR(p.value, fit.constants[i], 1e-9 * std::abs(fit.constants[i]));
    EXPECT_LE(p.lower, p.value);
    EXPECT_GE(p.upper, p.value);
    EXPECT_LT(p.lower, p.upper);
    // Where a side is closed, the loss has risen, however well the other parameter is fitted.
    for (const auto& [end, open] :
         {std::pair(p.lower, p.lower_open), std::pair(p.upper, p.upper_open)}) {
      Fit start = fit;
      start.free.erase(start.free.begin() + static_cast<std::ptrdiff_t>(k));
      start.constants[i] = end;
      EXPECT_EQ(searches.polished({start}, some_search(2)).at(0).loss > fit.loss + 1, !open);
    }
  }
}

}  // namespace
}  // namespace ricochet::studies::calibration
