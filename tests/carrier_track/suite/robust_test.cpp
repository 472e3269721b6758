#include "problems/carrier_track/suite/robust.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/counting/threshold.h"
#include "tests/carrier_track/gradients/differences.h"
#include "tests/support/scenes.h"
#include "tests/carrier_track/suite/machine_of_case.h"

namespace ricochet::carrier_track {
namespace {

constexpr RiskMeasure risks[] = {RiskMeasure::mean, RiskMeasure::worst, RiskMeasure::cvar};

std::vector<double> counts_at(const Machine& m, double omega) {
  std::vector<double> counts;
  for (const Scene& scene : sampled_scenes(m.scene)) counts.push_back(count_at(scene, omega));
  return counts;
}

TEST(Robust, ScenesAreTheSameWhenDrawnAgainAndForEveryMachine) {
  const auto once = sampled_scenes(machine("C1").scene);
  const auto again = sampled_scenes(machine("C1").scene);
  const auto other = sampled_scenes(machine("C4").scene);
  ASSERT_EQ(once.size(), 32U);
  for (std::size_t k = 0; k < once.size(); ++k) {
    EXPECT_EQ(once[k].wall_upper, again[k].wall_upper);
    EXPECT_EQ(once[k].disturbance_phase, again[k].disturbance_phase);
    EXPECT_EQ(once[k].disturbance_phase, other[k].disturbance_phase);
    EXPECT_NEAR(once[k].friction / 0.1, other[k].friction / 0.4, 1e-14);
    EXPECT_NEAR(once[k].restitution_lower / 0.1, other[k].restitution_lower / 0.9, 1e-14);
  }
}

/// Of each tolerance there is one scene in every thirty-second of it, and no two alike.
TEST(Robust, ScenesFillEveryToleranceEvenly) {
  Scene scene = machine("C9").scene;
  std::vector<std::vector<double>> places(6);
  for (const Scene& s : sampled_scenes(scene)) {
    const auto place = [](double ratio, double tolerance) {
      return ((ratio - 1) / tolerance + 1) / 2;
    };
    places[0].push_back(s.disturbance_phase / (2 * std::numbers::pi));
    places[1].push_back(place((s.disturbance - 0.05) / scene.disturbance, 0.2));
    places[2].push_back(place(s.wall_upper / scene.wall_upper, 0.05));
    places[3].push_back(place(s.mass / scene.mass, 0.02));
    places[4].push_back(place(s.friction / scene.friction, 0.1));
    places[5].push_back(place(s.restitution_upper / scene.restitution_upper, 0.05));
    EXPECT_NEAR(s.centrifugal_mass_radius / scene.centrifugal_mass_radius, s.mass / scene.mass,
                1e-14);
    EXPECT_NEAR(s.start_position / s.wall_upper, 0.54, 1e-14);
  }
  for (auto& column : places) {
    std::sort(column.begin(), column.end());
    for (std::size_t k = 0; k < column.size(); ++k) {
      EXPECT_EQ(std::floor(32 * column[k]), static_cast<double>(k));
    }
  }
  EXPECT_NE(places[2], places[3]);
}

TEST(Robust, ScenesOfACaseWithoutDisturbanceHaveOne) {
  for (const Scene& s : sampled_scenes(machine("C1").scene)) EXPECT_EQ(s.disturbance, 0.05);
}

TEST(Robust, ScenesKeepRestitutionAndFrictionWithinWhatIsAllowed) {
  Scene scene;
  scene.friction = 1.0;
  scene.contact_friction = true;
  for (const Scene& s : sampled_scenes(scene)) {
    EXPECT_LE(s.restitution_lower, 1.0);
    EXPECT_LE(s.friction, 1.0);
  }
}

TEST(Robust, ConstrainsTheRiskOfTheCounts) {
  const Machine c2 = machine("C2");
  for (const double omega : {1.5, 4.0}) {
    const auto counts = counts_at(c2, omega);
    double sum = 0;
    for (const double c : counts) sum += c;
    const auto constraint = [&](RiskMeasure risk) {
      return robust_problem(c2, risk).evaluate(at(omega)).constraints[0];
    };
    EXPECT_NEAR(constraint(RiskMeasure::mean), sum / 32 - c2.quiet_limit, 1e-12);
    EXPECT_EQ(constraint(RiskMeasure::worst),
              *std::max_element(counts.begin(), counts.end()) - c2.quiet_limit);
    EXPECT_LE(constraint(RiskMeasure::mean), constraint(RiskMeasure::cvar));
    EXPECT_LE(constraint(RiskMeasure::cvar), constraint(RiskMeasure::worst));
    EXPECT_EQ(robust_problem(c2, RiskMeasure::mean).evaluate(at(omega)).objective, -omega);
  }
}

TEST(Robust, HasSurrogatesWithDerivatives) {
  for (const RiskMeasure risk : risks) {
    expect_derivatives_of_values(robust_problem(machine("C1"), risk).formulated({0.25}), at(4.321),
                                 1e-8, 1e-4);
  }
}

/// Away from its level a sharp surrogate is on the side of the count.
TEST(Robust, HasSurrogatesThatPassTheirLevelWhereTheCountsLeaveTheLimit) {
  const Machine c2 = machine("C2");
  for (const RiskMeasure risk : risks) {
    const Problem sharp = robust_problem(c2, risk).formulated({1e-4});
    int loud = 0;
    for (double omega = 1; omega < 4; omega += 0.1) {
      const double shown = sharp.evaluate(at(omega)).constraints[0];
      const bool quiet = sharp.true_values(at(omega)).violation == 0;
      if (std::abs(shown) > 1e-3) {
        EXPECT_EQ(shown < 0, quiet) << name_of(risk) << omega;
      }
      loud += !quiet;
    }
    EXPECT_GT(loud, 0);
    EXPECT_LT(loud, 30);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
