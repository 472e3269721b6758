#include "src/studies/calibration/appraisal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/machine.h"
#include "src/studies/paper/interpretation.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

TEST(Appraisal, IsTheScoreOfEveryCase) {
  const FittedInterpretation& fitted = default_interpretation();
  const Appraisal a = appraise(fitted, 0.05);
  ASSERT_EQ(a.cases.size(), 12U);
  double squares = 0;
  int right = 0;
  double purity = 1;
  for (const CaseAppraisal& c : a.cases) {
    const Score expected =
        score(scene_of(c.the_case, fitted.scene), c.the_case.claim, ScanOptions{0.05, 1, 18.0});
    EXPECT_EQ(c.score.threshold, expected.threshold);
    EXPECT_EQ(c.score.quiet_count, expected.quiet_count);
    if (!c.the_case.claim.threshold) continue;
    squares += std::pow(std::log(*expected.threshold / *c.the_case.claim.threshold), 2);
    for (const Example& e : expected.examples) right += e.right ? 1 : 0;
    purity = std::min(purity, *expected.purity);
  }
  EXPECT_NEAR(a.threshold_error, std::sqrt(squares / 10), 1e-12);
  EXPECT_EQ(a.right_examples, right);
  EXPECT_EQ(a.purity, purity);
}

TEST(Appraisal, ScansWhatItCountsOneByOne) {
  for (const char* name :
       {"projected-constant-revolutions", "projected-constant-revolutions-crossing"}) {
    const Interpretation interpretation = find_interpretation(name);
    const Constants& constants = default_interpretation().constants;
    const Case c = find_case("C9");
    const SpeedScan scan = appraise({interpretation, {}, constants}, c, 0.5).scan;
    const Scene scene = scene_of(c, interpretation, constants);
    ASSERT_EQ(scan.counts.size(), 36U);
    for (std::size_t k = 0; k < scan.counts.size(); ++k) {
      EXPECT_EQ(scan.counts[k],
                objective(scene_at(scene, interpretation, constants, scan.omega(k)), 0.0))
          << name << " at " << scan.omega(k);
    }
  }
}

TEST(Appraisal, WeighsErrorAgainstConstants) {
  // n ln(s / n) + 2 p + 2 p (p + 1) / (n - p - 1) by hand: n = 20, s = 0.2, p = 6.
  EXPECT_NEAR(selection_criterion(0.2, 20, 5), 20 * std::log(0.01) + 12 + 84.0 / 13, 1e-12);
  EXPECT_EQ(selection_criterion(0.2, 20, 18), std::numeric_limits<double>::infinity());
  // A constant more must pay for itself.
  EXPECT_GT(selection_criterion(0.2, 20, 6), selection_criterion(0.2, 20, 5));
  EXPECT_LT(selection_criterion(0.1, 20, 6), selection_criterion(0.2, 20, 5));
}

TEST(Appraisal, ProfilesAroundTheFit) {
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
