#include "src/studies/paper/loss.h"

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/machine.h"
#include "src/studies/paper/interpretation.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track::inline paper {
namespace {

double constant_of(const Parameterisation& fit, Unknown unknown) {
  return fit.constants[static_cast<std::size_t>(unknown)];
}

/// A score that is the claim, word for word.
CoarseScore perfect(const Claim& claim) {
  return {*claim.quiet_count, 1.0, *claim.threshold, 0.0, 2.0, 0, 0.0};
}

TEST(Loss, CountsADistanceFromTheClaimInTolerances) {
  for (const Case& c : all_cases()) {
    if (!c.claim.threshold) continue;
    EXPECT_EQ(loss_of(perfect(c.claim), c.claim), 0) << c.id;
  }
  const Claim claim = find_case("C1").claim;
  const auto loss_where = [&](auto change) {
    CoarseScore score = perfect(claim);
    change(score);
    return loss_of(score, claim);
  };
  EXPECT_NEAR(loss_where([](auto& s) { s.threshold *= std::exp(0.05); }), 1, 1e-12);
  EXPECT_NEAR(loss_where([](auto& s) { s.purity = 0.75; }), 1, 1e-12);
  EXPECT_NEAR(loss_where([](auto& s) { s.misclassified = 0.07; }), 1, 1e-12);
  EXPECT_NEAR(loss_where([](auto& s) { s.loudness = 1.5 * std::exp(-0.2); }), 1, 1e-12);
  EXPECT_NEAR(loss_where([](auto& s) { s.wrong_examples = 1, s.shape = 0.5; }), 3.5, 1e-12);
  EXPECT_NEAR(loss_where([](auto& s) { s.quiet_count = 6; }), std::log(6.3 / 5.3) / 0.15, 1e-12);
  // Far off: 3, and the logarithm of what is more.
  EXPECT_NEAR(loss_where([](auto& s) { s.threshold *= std::exp(0.05 * 10); }), 3 + std::log(8.0),
              1e-12);
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
    const Score judged = score(scene_of(c, fitted.scene), c.claim, ScanOptions{0.01, 1, 18.0});
    const CoarseScore seen = coarse_score(fitted, c);
    EXPECT_NEAR(seen.quiet_count, judged.quiet_count, 1) << id;
    EXPECT_NEAR(seen.threshold / judged.threshold.value_or(18), 1, 0.06) << id;
    EXPECT_NEAR(seen.misclassified, judged.misclassified, 0.03) << id;
    EXPECT_NEAR(seen.loudness / judged.loudness.value_or(0), 1, 0.2) << id;
  }
}

TEST(Loss, OfLeftOutCasesIsTheRest) {
  const FittedInterpretation& fitted = default_interpretation();
  const auto of_case = [&](const char* id) {
    return loss_of(coarse_score(fitted, find_case(id)), find_case(id).claim);
  };
  const double all = loss(fitted);
  for (const char* id : {"C3", "C4"})
    EXPECT_NEAR(loss(fitted, {id}), all - of_case(id), 1e-9) << id;
  // Without a whole machine nothing is left of C11, which is compared with C4.
  const int quiet = coarse_score(fitted, find_case("C4")).quiet_count;
  EXPECT_NEAR(loss(fitted, {"C4", "C8", "C11"}),
              all - of_case("C4") - of_case("C8") - 4 * quiet_share_of_c11(fitted, quiet), 1e-9);
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

TEST(Loss, HasASmoothStandInWithTheSlopesOfDifferences) {
  for (const Counted when : {Counted::from_start, Counted::later, Counted::long_run}) {
    Parameterisation fit = counted(when);
    const std::vector<Unknown> free = {Unknown::pull, Unknown::clearance, Unknown::phase,
                                       Unknown::counting_limit, Unknown::revolutions};
    fit.free = free;
    const SmoothLoss at = smooth_loss(fit, default_smoothing);
    ASSERT_EQ(at.slopes.cols(), 5);
    int compared = 0, close = 0;
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
}

/// Expects that both ways of counting give what `count(scene at the speed)` says.
template <class Count>
void expect_counts(const Parameterisation& fit, const std::vector<const char*>& ids,
                   const std::vector<double>& speeds, Count count) {
  for (const char* id : ids) {
    const Case c = find_case(id);
    std::vector<int> expected, limited;
    for (const double omega : speeds) {
      expected.push_back(count(at_speed(scene_of(c, default_interpretation().scene), omega)));
      limited.push_back(std::min(expected.back(), most_counted + 1));
    }
    EXPECT_EQ(exact_counts(fit, c, speeds), expected) << id;
    EXPECT_EQ(counts_of(fit, c, speeds), limited) << id;
  }
}

TEST(Loss, CountsAsASimulationOfEverySpeedDoes) {
  expect_counts(default_interpretation(), {"C2", "C9", "C11"}, {0.5, 2.03, 2.9, 8.1, 12.4, 17.9},
                [](const Scene& scene) { return count_at(scene, scene.omega); });
  // In a later window the impacts after its first turn count.
  const auto later = [](const Scene& scene) {
    const double turns = std::get<Revolutions>(scene.window).count;
    const auto impacts = simulate(with(scene, set::revolutions(turns + 1.2))).impacts;
    const auto count = std::ranges::count_if(impacts, [&](const Impact& impact) {
      return impact.speed > scene.counting_limit &&
             impact.time > 1.2 * 2 * std::numbers::pi / scene.omega;
    });
    return static_cast<int>(count);
  };
  expect_counts(counted(Counted::later), {"C1", "C2", "C9", "C11"}, {0.5, 2.1, 2.9, 8.1, 12.4},
                later);
  // In the long run what a turn has: the motion of these cases repeats.
  const Parameterisation fit = counted(Counted::long_run);
  expect_counts(fit, {"C1", "C3"}, {1.0, 2.5, 5.0, 8.0, 8.2, 15.0}, [&](const Scene& scene) {
    return static_cast<int>(
        std::lround(constant_of(fit, Unknown::revolutions) * most_per_turn(scene)));
  });
}

Parameterisation with_three_unknowns() {
  return {default_interpretation().interpretation,
          {Unknown::pull, Unknown::start_velocity, Unknown::counting_limit},
          default_interpretation().constants};
}

TEST(Calibration, PlacesConstantsWithinTheirBoundsAndBack) {
  const Parameterisation fit = with_three_unknowns();
  const Parameterisation middle = fit_at(fit, Vector::Constant(3, 0.5));
  // The pull's size is unknown.
  EXPECT_NEAR(constant_of(middle, Unknown::pull), std::sqrt(0.01 * 40), 1e-12);
  EXPECT_NEAR(constant_of(middle, Unknown::start_velocity), 0, 1e-12);
  EXPECT_EQ(constant_of(middle, Unknown::clearance), constant_of(fit, Unknown::clearance));
  EXPECT_THAT(point_of(middle), Each(testing::DoubleNear(0.5, 1e-12)));
}

TEST(Calibration, MinimisesTheLossWithSlopesInTheBox) {
  const Parameterisation fit = with_three_unknowns();
  const Problem problem = calibration_problem(fit);
  EXPECT_EQ(problem.dimension(), 3);
  EXPECT_NEAR(problem.evaluate(problem.start).objective, loss(fit), 1e-6);
  const Residuals r = problem.residuals(problem.start);
  ASSERT_EQ(r.jacobian.rows(), r.values.size());
  const double h = 1e-8;
  Vector near = problem.start;
  near[2] += h;
  const Vector slope = (problem.residuals(near).values - r.values) / h;
  EXPECT_NEAR((slope - r.jacobian.col(2)).norm() / r.jacobian.col(2).norm(), 0, 1e-4);
}

}  // namespace
}  // namespace ricochet::carrier_track::inline paper
