#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/design.h"
#include "problems/carrier_track/suite/profile.h"
#include "problems/carrier_track/suite/robust.h"
#include "src/core/instance.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

TEST(Design, CostsWhatItsTermsSay) {
  const auto cost_of = [](const std::array<double, 5>& x) {
    return design_cost(DesignScale{10.0, 1.0, 4.0, 2e-3}, std::span<const double>(x));
  };
  const DesignCost<double> cost = cost_of({5.0, 3.0, 1e-3, 0.4, std::exp(-2.0)});
  EXPECT_DOUBLE_EQ(cost.production, -0.5);
  EXPECT_DOUBLE_EQ(cost.precision, 1.0);  // half the clearance, twice the cost
  EXPECT_DOUBLE_EQ(cost.damping, 0.5);
  EXPECT_DOUBLE_EQ(cost.heat, 0.025);
  EXPECT_DOUBLE_EQ(cost.tension, 0.25);
  EXPECT_DOUBLE_EQ(cost.sum(), 1.275);
  // At the nominal pull, and without damping.
  const DesignCost<double> least = cost_of({5.0, 1.0, 2e-3, 0.1, 1.0});
  EXPECT_EQ(std::pair(least.tension, least.damping), std::pair(0.0, 0.0));
}

TEST(Design, OfTheMachineAsItIsHasItsCount) {
  Machine m = exploratory_machine("C1");
  const Problem problem = design_count_problem(m);
  Vector x = problem.start;
  x[design_speed] = 9.0;
  EXPECT_EQ(problem.evaluate(x).constraints[0] + m.quiet_limit, count_at(m.scene, 9.0));
  m.scene.wall_upper = infinity;
  EXPECT_EQ(families_of({exploratory_machine("C1"), m})[4].problems.size(), 1U)
      << "one has no clearance";
}

TEST(Design, BuildsTheSceneOfItsVariables) {
  const std::array<double, 5> x = {5.0, 2.0, 2 * 1.04e-3, 0.3, 0.7};
  const Scene machine = exploratory_machine("C1").scene;
  const Scene scene = designed(machine, std::span<const double>(x));
  EXPECT_DOUBLE_EQ(scene.wall_upper, 2 * 1.04e-3);
  EXPECT_DOUBLE_EQ(scene.start_position, 0.54 * 2 * 1.04e-3);
  EXPECT_EQ(write_scene(scene),
            write_scene(with(machine, set::omega(5.0), set::pull(2.0), set::friction(0.3),
                             set::restitution(0.7), set::wall_upper(scene.wall_upper),
                             set::start_position(scene.start_position))));
}

/// [rad]: how far the driver plate turns within the profile, exactly.
double angle_of(const std::vector<SpeedKnot<double>>& profile) {
  double angle = 0;
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const SpeedKnot<double>&from = profile[k - 1], &to = profile[k];
    angle += (to.time - from.time) * (from.omega + to.omega) / 2;
  }
  return angle;
}

TEST(Profile, KeepsItsMeanSpeedWhateverTheShape) {
  Machine c1 = exploratory_machine("C1");
  const ProfileFrame frame = profile_frame(c1);
  EXPECT_EQ(frame.mean, 1.25 * 9.0);
  for (const std::size_t n : profile_sizes) {
    Random random(7);
    const Vector x = uniform_point(profile_count_problem(c1, n), random);
    const Scene scene = with_profile(c1.scene, frame, std::span<const double>(x.data(), n));
    ASSERT_EQ(scene.profile.size(), n);
    EXPECT_EQ(scene.profile.front().time, 0);
    EXPECT_NEAR(scene.profile.back().time, frame.seconds, 1e-12);
    EXPECT_NEAR(angle_of(scene.profile) / frame.seconds, frame.mean, 1e-12);
    EXPECT_NEAR(angle_of(scene.profile), 2 * std::numbers::pi * 1.314, 1e-11) << "the window's";
    EXPECT_NEAR(scene.profile[1].omega / scene.profile[0].omega, x[1] / x[0], 1e-12);
  }
  c1.scene.window = Seconds{2.5};
  EXPECT_EQ(profile_frame(c1).seconds, 2.5);
}

TEST(Profile, OfNoShapeIsTheSteadySpeed) {
  for (const char* id : {"C1", "C2", "C9"}) {
    const Machine m = exploratory_machine(id);
    const Problem problem = profile_count_problem(m, 8);
    const double count = count_at(m.scene, loud_speed(m));
    EXPECT_EQ(problem.evaluate(problem.start).objective, count) << id;
    EXPECT_EQ(problem.evaluate(2 * problem.start).objective, count) << id;
  }
}

constexpr RiskMeasure risks[] = {RiskMeasure::mean, RiskMeasure::worst, RiskMeasure::cvar};

/// The definition of Rockafellar and Uryasev; its minimum is at one of the losses.
double cvar_by_definition(const std::vector<double>& losses) {
  double least = infinity;
  for (const double t : losses) {
    double excess = 0;
    for (const double loss : losses) excess += std::max(0.0, loss - t);
    least = std::min(least, t + excess / (0.1 * static_cast<double>(losses.size())));
  }
  return least;
}

TEST(RiskMeasure, IsThatOfItsDefinition) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> counts(0, 9);
    std::vector<double> losses;
    // A tenth of them is whole, or not, or less than one.
    for (const int number = std::array{5, 20, 25, 32}[seed % 4]; std::ssize(losses) < number;)
      losses.push_back(counts(random));
    const auto size = static_cast<double>(losses.size());
    const double sum = std::accumulate(losses.begin(), losses.end(), 0.0);
    EXPECT_NEAR(risk_of(RiskMeasure::mean, losses), sum / size, 1e-12);
    EXPECT_EQ(risk_of(RiskMeasure::worst, losses), std::ranges::max(losses));
    EXPECT_NEAR(risk_of(RiskMeasure::cvar, losses), cvar_by_definition(losses), 1e-12);
  }
}

/// A limit that is met exactly must not be missed by rounding.
TEST(RiskMeasure, OfEqualWholeLossesIsExact) {
  for (const RiskMeasure risk : risks) {
    for (const double loss : {7.0, 18.0, 1e6 + 1})
      EXPECT_EQ(risk_of(risk, std::vector<double>(32, loss)), loss);
  }
}

TEST(Robust, ScenesAreTheSameWhenDrawnAgainAndForEveryMachine) {
  const auto once = sampled_scenes(exploratory_machine("C1").scene);
  const auto again = sampled_scenes(exploratory_machine("C1").scene);
  const auto other = sampled_scenes(exploratory_machine("C4").scene);
  ASSERT_EQ(once.size(), 32U);
  for (std::size_t k = 0; k < once.size(); ++k) {
    EXPECT_EQ(write_scene(once[k]), write_scene(again[k]));
    EXPECT_EQ(once[k].disturbance_phase, other[k].disturbance_phase);
    EXPECT_NEAR(once[k].friction / 0.1, other[k].friction / 0.4, 1e-14);
    EXPECT_NEAR(once[k].restitution_lower / 0.1, other[k].restitution_lower / 0.9, 1e-14);
    EXPECT_EQ(once[k].disturbance, 0.05) << "of a case without";
  }
}

/// Of each tolerance there is one scene in every thirty-second of it, and no two alike.
TEST(Robust, ScenesFillEveryToleranceEvenly) {
  const Scene scene = exploratory_machine("C9").scene;
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
  EXPECT_NE(places[2], places[3]);
  for (auto& column : places) {
    std::ranges::sort(column);
    for (std::size_t k = 0; k < column.size(); ++k)
      EXPECT_EQ(std::floor(32 * column[k]), static_cast<double>(k));
  }
}

TEST(Robust, ScenesKeepRestitutionAndFrictionWithinWhatIsAllowed) {
  const Scene utmost = with(Scene{}, set::friction(1.0), set::contact_friction(true));
  for (const Scene& s : sampled_scenes(utmost)) {
    EXPECT_LE(s.restitution_lower, 1.0);
    EXPECT_LE(s.friction, 1.0);
  }
}

TEST(Robust, ConstrainsTheRiskOfTheCounts) {
  const Machine c2 = exploratory_machine("C2");
  for (const double omega : {1.5, 4.0}) {
    std::vector<double> counts;
    for (const Scene& scene : sampled_scenes(c2.scene)) counts.push_back(count_at(scene, omega));
    for (const RiskMeasure risk : risks) {
      const Values values = robust_problem(c2, risk).evaluate(Vector::Constant(1, omega));
      EXPECT_EQ(values.constraints[0], risk_of(risk, counts) - c2.quiet_limit);
      EXPECT_EQ(values.objective, -omega);
    }
  }
}

/// Away from its level a sharp surrogate is on the side of the count.
TEST(Robust, HasSurrogatesThatPassTheirLevelWhereTheCountsLeaveTheLimit) {
  for (const RiskMeasure risk : risks) {
    const Problem sharp = robust_problem(exploratory_machine("C2"), risk).formulated({1e-4});
    int loud = 0;
    for (double omega = 1; omega < 4; omega += 0.1) {
      const Vector x = Vector::Constant(1, omega);
      const double shown = sharp.evaluate(x).constraints[0];
      const bool quiet = sharp.true_values(x).violation == 0;
      EXPECT_TRUE(std::abs(shown) <= 1e-3 || (shown < 0) == quiet) << name_of(risk) << omega;
      loud += !quiet;
    }
    EXPECT_GT(loud, 0);
    EXPECT_LT(loud, 30);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
