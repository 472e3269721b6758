#include "src/studies/paper/loss.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/machine.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::carrier_track {
namespace {

/// A score that is the claim, word for word.
CoarseScore perfect(const Claim& claim) {
  return {*claim.quiet_count, 1.0, *claim.threshold, 0.0, 2.0, 0, 0.0};
}

TEST(Loss, IsZeroForTheClaimItself) {
  for (const Case& c : all_cases()) {
    if (!c.claim.threshold) continue;
    EXPECT_EQ(loss_of(perfect(c.claim), c.claim), 0) << c.id;
  }
}

TEST(Loss, CountsADistanceOfATolerance) {
  const Claim claim = find_case("C1").claim;
  CoarseScore s = perfect(claim);
  s.threshold *= std::exp(0.05);
  EXPECT_NEAR(loss_of(s, claim), 1, 1e-12);
  s = perfect(claim);
  s.purity = 0.75;
  EXPECT_NEAR(loss_of(s, claim), 1, 1e-12);
  s = perfect(claim);
  s.misclassified = 0.07;
  EXPECT_NEAR(loss_of(s, claim), 1, 1e-12);
  s = perfect(claim);
  s.loudness = 1.5 * std::exp(-0.2);
  EXPECT_NEAR(loss_of(s, claim), 1, 1e-12);
  s = perfect(claim);
  s.wrong_examples = 1;
  s.shape = 0.5;
  EXPECT_NEAR(loss_of(s, claim), 3.5, 1e-12);
  s = perfect(claim);
  s.quiet_count = 6;
  EXPECT_NEAR(loss_of(s, claim), std::log(6.3 / 5.3) / 0.15, 1e-12);
  s = perfect(claim);
  s.threshold *= std::exp(0.05 * 10);  // far off: 3, and the logarithm of what is more
  EXPECT_NEAR(loss_of(s, claim), 3 + std::log(8.0), 1e-12);
}

TEST(Loss, LooksAtTheWholeRangeEvenly) {
  for (const double threshold : {1.9, 3.1, 9.0, 13.0}) {
    double edge = 0;
    for (const SpeedCell& cell : speed_cells(threshold)) {
      EXPECT_NEAR(cell.omega, edge + cell.width / 2, 1e-12);
      edge += cell.width;
    }
    EXPECT_NEAR(edge, 18.0, 1e-9);
  }
}

TEST(Loss, SeesWhatAJudgementSees) {
  const FittedInterpretation& fitted = default_interpretation();
  for (const char* id : {"C1", "C2", "C4", "C9"}) {
    const Case c = find_case(id);
    const Scene scene = scene_of(c, fitted.interpretation, fitted.constants);
    const Score judged = score(scene, c.claim, ScanOptions{0.01, 1, 18.0});
    const CoarseScore seen = coarse_score(fitted, c);
    EXPECT_NEAR(seen.quiet_count, judged.quiet_count, 1) << id;
    EXPECT_NEAR(seen.threshold / judged.threshold.value_or(18), 1, 0.06) << id;
    EXPECT_NEAR(seen.misclassified, judged.misclassified, 0.03) << id;
    EXPECT_NEAR(seen.loudness / judged.loudness.value_or(0), 1, 0.2) << id;
  }
}

TEST(Loss, OfALeftOutCaseIsTheRest) {
  const FittedInterpretation& fitted = default_interpretation();
  const double all = loss(fitted);
  for (const char* id : {"C3", "C4"}) {
    const Case c = find_case(id);
    const double its = loss_of(coarse_score(fitted, c), c.claim);
    EXPECT_NEAR(loss(fitted, {id}), all - its, 1e-9) << id;
  }
}

TEST(Loss, OfALeftOutMachineHasNothingOfIt) {
  const FittedInterpretation& fitted = default_interpretation();
  double expected = loss(fitted);
  int quiet = 0;
  for (const char* id : {"C4", "C8"}) {
    const Case c = find_case(id);
    const CoarseScore s = coarse_score(fitted, c);
    expected -= loss_of(s, c.claim);
    if (c.id == "C4") quiet = s.quiet_count;
  }
  expected -= 4 * quiet_share_of_c11(fitted, quiet);
  EXPECT_NEAR(loss(fitted, {"C4", "C8", "C11"}), expected, 1e-9);
  const auto squares = [&](const CaseIds& left_out) {
    return smooth_loss({fitted.interpretation, {}, fitted.constants}, default_smoothing, left_out)
        .residuals.squaredNorm();
  };
  const CaseIds others = {"C1", "C2", "C3", "C5", "C6", "C7", "C9", "C10"};
  EXPECT_NEAR(squares({"C4", "C8"}) + squares(others), squares({}), 1e-9);
  EXPECT_GT(squares(others), 0.1);
}

/// The default interpretation, counted from a later turn on, or in the long run.
Parameterisation counted(Counted when) {
  Parameterisation fit = default_interpretation();
  fit.interpretation.counted = when;
  fit.constants[static_cast<std::size_t>(Unknown::first_turn)] = 1.2;
  return fit;
}

void expect_slopes_of_differences(Parameterisation fit) {
  const std::vector<Unknown> free = {Unknown::pull, Unknown::clearance, Unknown::phase,
                                     Unknown::counting_limit, Unknown::revolutions};
  fit.free = free;
  const SmoothLoss at = smooth_loss(fit, default_smoothing);
  ASSERT_EQ(at.slopes.cols(), 5);
  int compared = 0;
  int close = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(free[k]);
    const double h = 1e-7 * (free[k] == Unknown::phase ? 1.0 : fit.constants[i]);
    const auto residuals_at = [&](double moved) -> Vector {
      Parameterisation near{fit.interpretation, {}, fit.constants};
      near.constants[i] += moved;
      return smooth_loss(near, default_smoothing).residuals;
    };
    const Vector slope = (residuals_at(h) - residuals_at(-h)) / (2 * h);
    for (Eigen::Index r = 0; r < slope.size(); ++r) {
      const double exact = at.slopes(r, static_cast<Eigen::Index>(k));
      ++compared;
      close += std::abs(exact - slope[r]) <= 1e-3 * std::abs(exact) + 1e-11 / h ? 1 : 0;
    }
  }
  // A difference fails where it meets a jump or a near graze.
  EXPECT_GT(compared, 1000);
  EXPECT_GT(close, 0.95 * compared);
  EXPECT_EQ(at.slopes.col(4).norm(), 0);  // the window
}

TEST(Loss, HasASmoothStandInWithTheSlopesOfDifferences) {
  expect_slopes_of_differences(default_interpretation());
}

TEST(Loss, HasTheSameOfALaterWindow) {
  expect_slopes_of_differences(counted(Counted::later));
}

TEST(Loss, HasTheSameInTheLongRun) {
  expect_slopes_of_differences(counted(Counted::long_run));
}

TEST(Loss, CountsInALaterWindowTheImpactsAfterItsFirstTurn) {
  const Parameterisation fit = counted(Counted::later);
  const std::vector<double> speeds = {0.5, 2.1, 2.9, 8.1, 12.4};
  for (const char* id : {"C1", "C2", "C9", "C11"}) {
    const Case c = find_case(id);
    const std::vector<int> exact = exact_counts(fit, c, speeds);
    const std::vector<int> counts = counts_of(fit, c, speeds);
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      Scene scene = scene_of(c, default_interpretation().scene);
      scene.omega = speeds[k];
      const double turn = 2 * std::numbers::pi / speeds[k];
      const double turns = std::get<Revolutions>(scene.window).count;
      scene.window = Revolutions{turns + 1.2};
      const auto impacts = simulate(scene).impacts;
      const auto later = std::ranges::count_if(impacts, [&](const Impact& impact) {
        return impact.speed > scene.counting_limit && impact.time > 1.2 * turn;
      });
      EXPECT_EQ(exact[k], later) << id << " at " << speeds[k];
      EXPECT_EQ(counts[k], later) << id << " at " << speeds[k];
    }
  }
}

TEST(Loss, CountsInTheLongRunWhatATurnHas) {
  const Parameterisation fit = counted(Counted::long_run);
  const double turns = fit.constants[static_cast<std::size_t>(Unknown::revolutions)];
  const std::vector<double> speeds = {1.0, 2.5, 5.0, 8.0, 8.2, 15.0};
  for (const char* id : {"C1", "C3"}) {  // their motion repeats
    const Case c = find_case(id);
    const std::vector<int> exact = exact_counts(fit, c, speeds);
    const std::vector<int> counts = counts_of(fit, c, speeds);
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      const Scene there = at_speed(scene_of(c, default_interpretation().scene), speeds[k]);
      const long count = std::lround(turns * most_per_turn(there));
      EXPECT_EQ(exact[k], count) << id << " at " << speeds[k];
      EXPECT_EQ(counts[k], count) << id << " at " << speeds[k];
    }
  }
}

TEST(Loss, CountsAsASimulationOfEverySpeedDoes) {
  Parameterisation fit = default_interpretation();
  const std::vector<double> speeds = {0.5, 2.03, 2.9, 8.1, 12.4, 17.9};
  for (const char* id : {"C2", "C9", "C11"}) {
    const Case c = find_case(id);
    const std::vector<int> counts = counts_of(fit, c, speeds);
    ASSERT_EQ(counts.size(), speeds.size());
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      const int all = count_at(scene_of(c, fit.interpretation, fit.constants), speeds[k]);
      EXPECT_EQ(counts[k], std::min(all, most_counted + 1)) << id << " at " << speeds[k];
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
