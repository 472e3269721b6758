#include "problems/carrier_track/counting/quiet_speed.h"

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

using testing::DoubleNear, testing::Ge, testing::Gt, testing::Le, testing::Lt;

/// The answer up to 18 rad/s for a limit.
QuietSpeed quiet_speed_for(const Scene& scene, Measure measure, double at_most) {
  return quiet_speed(scene, {Limit{measure, at_most}, 1e-3, 18});
}

/// The first scanned speed whose count is above the limit, by looking at every one.
double first_above(const Scene& scene, double limit) {
  for (int k = 1;; ++k) {
    if (count_at(scene, k * 1e-3) > limit) return k * 1e-3;
  }
}

TEST(QuietSpeed, IsTheSameWhereverTheRangeEnds) {
  const Scene scene = case_scene("C1");
  const QuietSpeed answer = quiet_speed(scene, {});
  ASSERT_TRUE(answer.fastest_quiet);
  for (const double fastest : {9.0, 14.0, 30.0}) {
    const QuietSpeed other = quiet_speed(scene, {std::nullopt, 1e-3, fastest});
    EXPECT_EQ(other.fastest_quiet, answer.fastest_quiet) << fastest;
    EXPECT_NEAR(*other.split.speed, *answer.split.speed, 1e-10) << fastest;
  }
}

TEST(QuietSpeed, IsMissingWhereEverySpeedIsLoud) {
  for (const auto& [restitution, clearance, per_turn] : {std::tuple(0.5, 0.8e-3, 2.0),
                                                         {0.9, 1e-3, 2.0},
                                                         {0.1, 2e-3, 0.0},
                                                         {0.7, 0.5e-3, 1.0},
                                                         {0.3, 4e-3, 1.0}}) {
    Scene scene = with(case_scene("C1"), set::restitution(restitution), set::friction(0),
                       set::pull(0), set::counting_limit(1e-6));
    scene.wall_upper = scene.wall_lower + clearance;
    const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions_per_turn, per_turn}});
    EXPECT_TRUE(answer.loud_everywhere) << restitution;
    EXPECT_FALSE(answer.fastest_quiet || answer.split.speed || answer.reached) << restitution;
    EXPECT_EQ(answer.split.first_loud, 0.01) << "the slowest speed of the range";
  }
  // By a window, too.
  const QuietSpeed window = quiet_speed(case_scene("C3"), {Limit{Measure::collisions, 0}, 1e-3, 4});
  EXPECT_FALSE(window.fastest_quiet || window.split.speed);
  // Loud from the slowest speed on is not loud everywhere.
  EXPECT_FALSE(quiet_speed(case_scene("C1"), {}).loud_everywhere);
}

TEST(QuietSpeed, SaysUpToWhereItIsKnownAtTheTimeLimit) {
  const TimeLimit limit(0.3);
  const QuietSpeed answer =
      quiet_speed_for(with(case_scene("C2"), set::revolutions(2000)), Measure::collisions, 1e9);
  EXPECT_THAT(answer.reached.value(), AllOf(testing::Gt(0), testing::Lt(18)));
  EXPECT_FALSE(answer.fastest_quiet || answer.split.speed || answer.loud_everywhere);
}

TEST(QuietSpeed, IsTheEndOfTwoCollisionsATurnInTheLongRun) {
  for (const char* id : {"C1", "C2", "C3", "C4", "C5", "C9"}) {
    const Scene scene = case_scene(id);
    const QuietSpeed answer = quiet_speed(scene, {});
    ASSERT_TRUE(answer.is_of_the_long_run());
    EXPECT_EQ(answer.limit->measure, Measure::collisions_per_turn);
    // Of each of 100 turns by itself, 60 turns after the start.
    const auto most_in_a_turn = [&](double omega) {
      double most = 0, before = infinity;
      for (int turns = 60; turns <= 160; ++turns) {
        const double count =
            objective(with(at_speed(scene, omega), set::revolutions(turns + 0.25)), 0.0);
        most = std::max(most, count - before);
        before = count;
      }
      return most;
    };
    EXPECT_LE(most_in_a_turn(*answer.fastest_quiet * (1 - 1e-3)), 2) << id;
    EXPECT_GT(most_in_a_turn(*answer.split.first_loud * (1 + 5e-3)), 2) << id;
  }
}

TEST(QuietSpeed, KeepsTheLimitThatIsGiven) {
  const Scene scene = case_scene("C1");
  EXPECT_NEAR(*quiet_speed_for(scene, Measure::collisions_per_turn, 0).fastest_quiet, 1.447, 1e-3);
  const QuietSpeed four = quiet_speed_for(scene, Measure::collisions_per_turn, 4);
  EXPECT_EQ(*four.fastest_quiet, 18);
  EXPECT_FALSE(four.split.first_loud);
  EXPECT_NEAR(*quiet_speed_for(scene, Measure::collisions, 6).fastest_quiet,
              first_above(scene, 6) - 1e-3, 1e-9);
  const QuietSpeed any = quiet_speed_for(scene, Measure::collisions, 1000);
  EXPECT_FALSE(any.split.first_loud);
  EXPECT_NEAR(*any.fastest_quiet, 18, 1e-9);
  EXPECT_FALSE(quiet_speed_for(scene, Measure::collisions, 0).fastest_quiet);
}

TEST(QuietSpeed, KnowsBothStepsOfTheFirstCase) {
  const Scene scene = case_scene("C1");
  const QuietSpeed answer = quiet_speed_for(scene, Measure::collisions, 3);
  const std::vector<Step>& steps = answer.staircase.steps;
  ASSERT_EQ(steps.size(), 2U);
  for (const Step& step : steps) {
    EXPECT_NEAR(step.first_loud.value(), first_above(scene, step.limit()), 1e-9);
    EXPECT_NEAR(step.omega, *step.first_loud, 2e-3);
  }
  EXPECT_NEAR(*answer.fastest_quiet, *steps[0].first_loud - 1e-3, 1e-9);
  ASSERT_EQ(answer.around.size(), 3U);
  EXPECT_LE(answer.around[1].count, answer.limit->at_most);
  EXPECT_GT(answer.around[2].count, answer.limit->at_most);
}

TEST(QuietSpeed, FindsALoudWindowThatTheFineScanStepsOver) {
  RandomScenes random(79);
  for (int i = 0; i < 372; ++i) random.next();
  const Scene scene = random.next();
  const QuietSpeed answer = quiet_speed_for(scene, Measure::collisions, 3);
  EXPECT_GT(first_above(scene, 3), 4.446);
  ASSERT_TRUE(answer.stepped_over);
  EXPECT_EQ(count_at(scene, answer.stepped_over->from), 4);
  EXPECT_EQ(answer.split.first_loud, answer.stepped_over->from);
  EXPECT_LT(answer.stepped_over->to - answer.stepped_over->from, 1e-3);
  EXPECT_NEAR(*answer.fastest_quiet, 4.445, 1e-9);
  EXPECT_FALSE(quiet_speed(case_scene("C1"), {}).stepped_over);
}

TEST(QuietSpeed, RefusesWhatIsInvalid) {
  const Scene scene = case_scene("C1");
  for (const QuietSpeedOptions& options :
       {QuietSpeedOptions{{}, 1e-3, 0.01}, {{}, 1e-3, 1001}, {{}, 0}, {Limit{{}, -1}}}) {
    EXPECT_THROW(quiet_speed(scene, options), InputError);
  }
  EXPECT_THROW(quiet_speed(with(scene, set::restitution_lower(2))), InputError);
  const std::vector<SpeedKnot<double>> profile = {{0.0, 1.0}, {1.0, 2.0}};
  EXPECT_THROW(quiet_speed(with(scene, set::profile(profile))), InputError);
}

/// A carrier that friction holds until the centrifugal force beats it, at the square root of
/// friction normal_force / centrifugal_mass_radius.
Scene held() {
  return with(Scene{}, set::start_position(0.5), set::restitution(0), set::friction(0.2),
              set::normal_force(500), set::centrifugal(Centrifugal::outward),
              set::centrifugal_mass_radius(1), set::seconds(10));
}

const Limit no_collision{Measure::collisions, 0};

TEST(QuietSpeed, ByWhatElseIsMeasuredIsThatOfAScanOfAllSpeeds) {
  constexpr double step = 0.01, fastest = 15;
  for (const auto& [measure, at_most] :
       {std::pair(Measure::impact_speed, 1.5), std::pair(Measure::energy, 2.0)}) {
    const QuietSpeed answer = quiet_speed(held(), {Limit{measure, at_most}, step, fastest});
    int k = 1;
    while (measured(at_speed(held(), k * step), measure) <= at_most && k * step < fastest) ++k;
    ASSERT_LT(k * step, fastest);
    EXPECT_NEAR(answer.split.first_loud.value_or(0), k * step, 1e-9);
    EXPECT_EQ(answer.split.misclassified, 0);
  }
}

/// The sensitivities by their keys. Expects the largest first.
std::map<std::string, double> percents(const Scene& scene, const Limit& limit, double omega) {
  std::map<std::string, double> by_key;
  double before = infinity;
  for (const auto& [key, percent] : sensitivities(scene, limit, omega)) {
    by_key[key] = percent;
    EXPECT_LE(std::abs(percent), std::exchange(before, std::abs(percent))) << key;
  }
  return by_key;
}

TEST(Sensitivity, KnowsTheConstantsThatAreNotZero) {
  EXPECT_THAT(
      constants_of(held()),
      testing::UnorderedElementsAre("mass", "friction", "normal_force", "centrifugal_mass_radius",
                                    "disturbance_frequency", "clearance"));
  const Scene scene =
      with(held(), set::restitution_lower(0.5), set::across(Across<double>{.pull = 2}));
  EXPECT_THAT(constants_of(scene),
              testing::IsSupersetOf(
                  {"restitution", "across.pull", "across.restitution", "across.clearance"}));
}

TEST(Sensitivity, ScalesOneConstant) {
  const Scene scene =
      with(held(), set::walls(3, 5), set::start_position(3.5), set::restitution_lower(0.8));
  const Scene wider = scaled(scene, "clearance", 1.5);
  EXPECT_DOUBLE_EQ(wider.wall_lower, 3);
  EXPECT_DOUBLE_EQ(wider.wall_upper, 6);
  EXPECT_DOUBLE_EQ(wider.start_position, 3.75);
  EXPECT_EQ(wider.mass, scene.mass);
  EXPECT_DOUBLE_EQ(scaled(scene, "mass", 2).mass, 2);
  EXPECT_DOUBLE_EQ(scaled(scene, "restitution", 1.1).restitution_lower, 0.88);
  EXPECT_DOUBLE_EQ(scaled(scene, "restitution", 2).restitution_lower, 1);
}

TEST(Sensitivity, FindsTheDivideToAFiftythousandth) {
  // Where it just reaches the wall in 10 s.
  EXPECT_NEAR(divide_near(held(), no_collision, 9).value(), std::sqrt(100.01), 10 * 2e-5);
  EXPECT_FALSE(divide_near(held(), no_collision, 2));
  EXPECT_FALSE(divide_near(held(), no_collision, 30));
}

TEST(Sensitivity, IsThatOfTheClosedForm) {
  const std::map<std::string, double> expected = {{"friction", 0.5},
                                                  {"normal_force", 0.5},
                                                  {"centrifugal_mass_radius", -0.5},
                                                  {"mass", 0},
                                                  {"clearance", 0}};
  const auto by_key = percents(held(), no_collision, 10);
  for (const auto& [key, percent] : expected) EXPECT_NEAR(by_key.at(key), percent, 0.005) << key;
}

TEST(Sensitivity, AddsUpToNothingOverAllThatHasAMassInItsUnit) {
  // Mass and forces of twice the size move the same way.
  const auto by_key = percents(case_scene("C1"), {Measure::collisions, 6}, 8.27);
  double sum = 0, largest = 0;
  for (const std::string key : {"mass", "normal_force", "pull", "disturbance",
                                "centrifugal_mass_radius", "slider_mass_radius"}) {
    if (!by_key.contains(key)) continue;
    sum += by_key.at(key);
    largest = std::max(largest, std::abs(by_key.at(key)));
  }
  EXPECT_GT(largest, 0.1);
  EXPECT_NEAR(sum, 0, 0.02);
}

TEST(Sensitivity, HasTheCountingLimitWhereImpactsCount) {
  // The long run's border of C1 is where an impact reaches the limit.
  const Scene scene = case_scene("C1");
  const Limit limit{Measure::collisions_per_turn, 2};
  const auto border = [&](double factor) {
    return divide_near(with(scene, set::counting_limit(scene.counting_limit * factor)), limit, 8.08)
        .value();
  };
  const double exponent = std::log(border(1.02) / border(0.98)) / std::log(1.02 / 0.98);
  EXPECT_GT(exponent, 0.8);
  EXPECT_NEAR(percents(scene, limit, 8.08).at("counting_limit"), exponent, 0.01);
  EXPECT_THAT(constants_of(scene), Not(Contains("counting_limit")))
      << "drawn machines and tolerances are those of manufacture";
}

TEST(Sensitivity, RefusesWhatIsInvalid) {
  const Scene broken = with(held(), set::mass(-1));
  EXPECT_THROW(sensitivities(broken, no_collision, 1), InputError);
  EXPECT_THROW(sensitivities(held(), no_collision, 0), InputError);
  EXPECT_THROW(tolerance_range(broken, no_collision, 1, 0.1, 9, 1), InputError);
  const auto drawn = [](double omega, double tolerance, int machines = 9) {
    return tolerance_range(held(), no_collision, omega, tolerance, machines, 1);
  };
  for (const double bad : {0.0, -1.0, quiet_nan}) EXPECT_THROW(drawn(bad, 0.1), InputError) << bad;
  for (const double bad : {-0.1, 0.6, quiet_nan}) EXPECT_THROW(drawn(1, bad), InputError) << bad;
  EXPECT_THROW(drawn(1, 0.1, 0), InputError);
}

TEST(Sensitivity, DrawsMachinesWithinTheTolerance) {
  const double lowest = 10 * std::sqrt(0.9 * 0.9 / 1.1);
  const double highest = 10 * std::sqrt(1.1 * 1.1 / 0.9);
  const auto range = tolerance_range(held(), no_collision, 10, 0.1, 300, 1).value();
  // They reach far into the corners.
  EXPECT_THAT(range,
              FieldsAre(AllOf(Ge(lowest * (1 - 1e-4)), Lt(10 - 0.6 * (10 - lowest))),
                        AllOf(Le(highest * (1 + 1e-4)), Gt(10 + 0.6 * (highest - 10))), 300, 0));
  EXPECT_THAT(tolerance_range(held(), no_collision, 10, 0.1, 300, 1).value(),
              FieldsAre(range.lowest, range.highest, 300, 0));
  EXPECT_FALSE(tolerance_range(held(), no_collision, 2, 0.1, 3, 1));
}

/// Silent up to sqrt(friction normal_force / (mass path_radius)), where the first impact counts.
SceneFile silent_below(const std::string& friction, const std::string& mass) {
  return parse_scene_file("[scene]\nmass = " + mass + "\nfriction = " + friction +
                              "\nnormal_force = 10\npath_radius = 0.1\nwall_lower = 0\n"
                              "wall_upper = 1e-3\nrestitution = 0\nstart_position = 0\n"
                              "[window]\nrevolutions = 4\n[count]\ncounting_limit = 1e-9\n",
                          "own");
}

TEST(Uncertainty, MovesTheAnswerAsTheClosedFormDoes) {
  const SceneFile file =
      silent_below("{value = 0.2, plus_minus = 0.02}", "{value = \"1 kg\", plus_minus = \"50 g\"}");
  const double omega = std::sqrt(0.2 * 10 / 0.1);
  const UncertainDivide divide = uncertain_divide(file, no_collision, omega, 200, 1).value();
  const double by_friction = (std::sqrt(22.0) - std::sqrt(18.0)) / 2;
  const double by_mass = omega * (1 / std::sqrt(1.05) - 1 / std::sqrt(0.95)) / 2;
  ASSERT_THAT(divide.effects,
              ElementsAre(FieldsAre("scene.friction", DoubleNear(by_friction, 1e-3)),
                          // and with it the centrifugal force
                          FieldsAre("scene.mass", DoubleNear(by_mass, 1e-3))));
  EXPECT_NEAR(divide.first_order, divide.effects[0].change - divide.effects[1].change, 1e-12);
  const double lowest = std::sqrt(18 / 1.05), highest = std::sqrt(22 / 0.95);
  EXPECT_THAT(divide.range,
              FieldsAre(AllOf(Gt(lowest), Lt(lowest + 0.2 * (omega - lowest))),
                        AllOf(Lt(highest), Gt(highest - 0.2 * (highest - omega))), 200, 0));
  // There is none without uncertain numbers, or without a divide.
  EXPECT_FALSE(uncertain_divide(silent_below("0.2", "1"), no_collision, 4.47, 9, 1));
  EXPECT_FALSE(uncertain_divide(file, no_collision, 40, 9, 1));
}

}  // namespace
}  // namespace ricochet::carrier_track
