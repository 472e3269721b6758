#include "problems/carrier_track/counting/count.h"

#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/counting/threshold.h"
#include "ricochet/error.h"
#include "tests/carrier_track/models/watch.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

TEST(Collisions, StepIsALogisticThatIsTheHeavisideStepAtSmoothingZero) {
  EXPECT_EQ(step(1e-300, 0.0), 1.0);
  EXPECT_EQ(step(0.0, 0.0), 0.0);
  EXPECT_EQ(step(-1e-300, 0.0), 0.0);
  for (const double smoothing : {1e-3, 0.25, 2.0}) {
    EXPECT_EQ(step(0.0, smoothing), 0.5);
    for (double z = -3; z <= 3; z += 0.01) {
      EXPECT_NEAR(step(z, smoothing), 0.5 * (1 + std::tanh(z / smoothing / 2)), 1e-15);
    }
    EXPECT_EQ(step(1e6, smoothing), 1.0);
    EXPECT_EQ(step(-1e6, smoothing), 0.0);
    EXPECT_EQ(step(-infinity, smoothing), 0.0);
  }
}

TEST(Collisions, FadesToTheEndOfTheWindowWithoutACorner) {
  EXPECT_EQ(fading(0.0, 0.0), 1.0);
  for (const double smoothing : {0.01, 0.25, 1.0}) {
    EXPECT_EQ(fading(0.0, smoothing), 0.0);
    EXPECT_NEAR(fading(0.1 * smoothing, smoothing), 1 - 1 / std::numbers::e, 1e-15);
    EXPECT_EQ(fading(0.65 * smoothing, smoothing), 1.0);
    EXPECT_NEAR(fading(std::nextafter(0.65 * smoothing, 0.0), smoothing), 1.0, 1e-15);
    EXPECT_LT(fading(1e-6 * smoothing, smoothing), 1e-9) << "its slope at the end is 0";
    EXPECT_EQ(weight(0.7, 0.1 * smoothing, smoothing),
              step(0.7, smoothing) * fading(0.1 * smoothing, smoothing));
  }
}

TEST(Collisions, CountsWhatTheExploratoryStudyCounted) {
  // The interpretation that the calibration starts from.
  const std::map<std::string, std::vector<double>> counted = {{"C1", {1, 1, 3, 4, 4, 7, 7}},
                                                              {"C2", {13, 14, 24, 40, 55, 66, 73}},
                                                              {"C3", {1, 1, 3, 4, 4, 7, 7}},
                                                              {"C4", {5, 6, 11, 23, 47, 62, 69}}};
  for (const auto& [id, counts] : counted) {
    std::vector<Scene> scenes;
    for (const double omega : {1, 2, 3, 5, 9, 13, 17}) {
      scenes.push_back(at_speed(scene_of(find_case(id), exploratory_scene()), omega));
    }
    EXPECT_EQ(objectives(scenes, 0.0), counts) << id;
  }
}

/// Thrown up from the floor at 8 m/s against 2 m/s^2, e = 1/2: impacts at 8, 4, 2, 1, ... m/s,
/// apexes at 16, 4, 1, 1/4, ... m.
Scene thrown_ball() {
  return with(Scene{}, set::wall_upper(infinity), set::start(0, 8), set::pull(2),
              set::restitution_lower(0.5), set::seconds(30), set::counting_limit(3),
              set::rule(CountRule::peaks), set::peak_high(3), set::peak_low(1e-9));
}

TEST(Collisions, CountsTheImpactsFasterThanTheLimit) {
  const Scene scene = with(thrown_ball(), set::rule(CountRule::impacts));
  EXPECT_EQ(objective(scene, 0.0), 2.0);
  const Scene low = with(scene, set::counting_limit(0.9));
  EXPECT_EQ(objective(low, 0.0), 4.0);
  // Weights 1 / (1 + (limit / v)^4) at smoothing parameter 1/4.
  double sum = 0;
  for (double v = 8; v > 1e-6; v /= 2) sum += 1 / (1 + std::pow(0.9 / v, 4));
  EXPECT_NEAR(objective(low, 0.25), sum, 1e-12);
}

TEST(Collisions, CountsHighAndLowPeaks) {
  // Ends on the floor after the fourth apex.
  const Scene scene = with(thrown_ball(), set::seconds(8.0 + 4.0 + 2.0 + 1.0));
  EXPECT_EQ(objective(scene, 0.0), 2.0);  // 16 and 4
  EXPECT_EQ(objective(with(scene, set::peak_high(0.5)), 0.0), 3.0);
  const Scene both = with(scene, set::peak_high(5), set::peak_low(0.5));
  EXPECT_EQ(objective(both, 0.0), 1.0 + 1.0);  // 16 is high, 1/4 is low
  const auto steps = [](double a) {
    return 1 / (1 + std::exp(-(a - 5) / 5 / 0.5)) + 1 / (1 + std::exp(-(0.5 - a) / 0.5 / 0.5));
  };
  // The apexes are 11, 5, 2 and 1/2 s from the end of the window of 15 s.
  const auto faded = [](double left) { return 1 - std::exp(-std::pow(left / 15 / 0.05, 2)); };
  const double sum =
      steps(16) * faded(11) + steps(4) * faded(5) + steps(1) * faded(2) + steps(0.25) * faded(0.5);
  EXPECT_NEAR(objective(both, 0.5), sum, 1e-12);
}

TEST(Collisions, ListsEachPeakOnceWithItsTimeAndPlace) {
  const auto top = [](double time, double position) {
    return FieldsAre(testing::DoubleNear(time, 1e-13), testing::DoubleNear(position, 1e-13));
  };
  EXPECT_THAT(watch(with(thrown_ball(), set::seconds(14.75))).tops,
              ElementsAre(top(4, 16), top(10, 4), top(13, 1), top(14.5, 0.25)))
      << "the fifth hop has not turned yet";
  // An impact on the upper wall is one, an end of the window is none.
  const Scene scene = with(Scene{}, set::start_velocity(1), set::seconds(1));
  EXPECT_THAT(watch(scene).tops, ElementsAre(FieldsAre(testing::DoubleEq(0.5), 1.0)));
  for (const double velocity : {1.0, -1.0}) {  // still on its way up; down from the start
    EXPECT_TRUE(watch(with(scene, set::seconds(0.4), set::start_velocity(velocity))).tops.empty());
  }
}

TEST(Collisions, CallsAPlateauAPeakOnceItFallsAtTheTimeItWasReached) {
  // Slides up to a stop and is held until a growing force takes it on, up or down.
  for (const double sign : {1.0, -1.0}) {
    const auto watched =
        watch(with(Scene{}, set::start_velocity(0.1), set::friction(0.5), set::normal_force(2),
                   set::centrifugal_mass_radius(1.5), set::seconds(1.2),
                   set::phase(-sign * std::numbers::pi / 2)));  // x'' = sign 1.5 sin t
    ASSERT_EQ(watched.stretches.size(), 3U);
    ASSERT_EQ(watched.tops.size(), sign > 0 ? 0U : 1U);
    if (sign > 0) continue;
    EXPECT_EQ(watched.tops[0].time, watched.stretches[1].time);
    EXPECT_EQ(watched.tops[0].position, watched.stretches[1].flight.position);
  }
}

TEST(Collisions, SurrogateIsContinuousWhereAnImpactIsBorn) {
  // A ball whose apex comes up to the upper wall as its start gets faster than 4 m/s.
  const auto thrown = [](double velocity) {
    return with(thrown_ball(), set::rule(CountRule::impacts), set::pull(8), set::wall_upper(1),
                set::restitution_upper(0.3), set::start_velocity(velocity));
  };
  for (const double distance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    const Scene hitting = thrown(4.0 + distance), missing = thrown(4.0 - distance);
    EXPECT_GT(watch(hitting).hits.size(), watch(missing).hits.size() - 3);
    // The born impact strikes at sqrt(8 distance), which is what the path feels.
    const double jump = std::abs(objective(hitting, 0.25) - objective(missing, 0.25));
    EXPECT_LT(jump, 3 * std::sqrt(8 * distance));
    EXPECT_GT(jump, 0.0);
  }
}

const std::vector<double> some_speeds{0.4, 1, 1.001, 1.002, 3, 7.5, 18};

std::vector<int> one_by_one(const Scene& scene, const std::vector<double>& speeds) {
  std::vector<int> counts;
  for (const double omega : speeds) counts.push_back(count_at(scene, omega));
  return counts;
}

TEST(Counts, AreThoseOfSingleSimulations) {
  RandomScenes random(5);
  for (int i = 0; i < 240; ++i) {
    Scene scene = i < 20 ? random.next_planar() : random.next();
    if (i >= 220) scene.rule = CountRule::peaks;
    EXPECT_EQ(counts_at(scene, some_speeds), one_by_one(scene, some_speeds)) << i;
  }
}

TEST(Counts, AskWhetherAnImpactIsFasterThanTheSlowestAsTheLogarithmDoes) {
  // An elastic body keeps its speed: at the limit, and an ulp beside it.
  const std::vector one{1.0};
  for (const double speed : {0.1, 0.7, 1.9, std::nextafter(2.0, 0.0)}) {
    for (const double limit : {std::nextafter(speed, 0.0), speed, std::nextafter(speed, 9.0)}) {
      const Scene scene =
          with(Scene{}, set::start_velocity(speed), set::counting_limit(limit), set::seconds(10));
      EXPECT_EQ(counts_at(scene, one), one_by_one(scene, one)) << speed << ' ' << limit;
    }
  }
}

TEST(Counts, AndSurrogatesOfManyScenesAreThoseOfEach) {
  RandomScenes random(7);
  std::vector<Scene> scenes(50);
  for (Scene& scene : scenes) scene = random.next();
  for (const double smoothing : {0.0, 0.25}) {
    std::vector<double> single;
    for (const Scene& scene : scenes) single.push_back(objective(scene, smoothing));
    EXPECT_EQ(objectives(scenes, smoothing), single);
  }
}

TEST(Counts, OfAnInvalidSceneOrSpeedAreRefused) {
  Scene scene = RandomScenes(8).next();
  EXPECT_EQ(counts(scene, some_speeds), counts_at(scene, some_speeds));
  EXPECT_THROW(counts(scene, std::vector<double>{1.0, -1.0}), InputError);
  EXPECT_THROW(counts(scene, std::vector<double>{quiet_nan}), InputError);
  scene.wall_upper = scene.wall_lower;
  EXPECT_THROW(counts(scene, some_speeds), InputError);
}

/// A ball of 2 kg thrown from a floor at 3 m/s under 9.81 m/s^2, without friction: it comes back
/// after 0.61 s, and, with restitution 1/2, again 0.31 s later.
Scene worn_ball(double restitution, double seconds) {
  return with(Scene{}, set::mass(2), set::wall_upper(infinity), set::start(0, 3),
              set::restitution(restitution), set::pull(2.0 * 9.81), set::seconds(seconds));
}

constexpr double energy_of_ball = 1e3 * 0.5 * 2.0 * 9.0;         // [mJ]
constexpr double first_loss = energy_of_ball * (1 - 0.5 * 0.5);  // [mJ]

TEST(Wear, IsTheEnergyThatImpactsTake) {
  EXPECT_NEAR(wear(worn_ball(0.5, 10)), energy_of_ball, 1e-8) << "it comes to rest";
  EXPECT_NEAR(wear(worn_ball(0.5, 0.8)), first_loss, 1e-9);
  EXPECT_EQ(wear(worn_ball(1, 10)), 0.0);
  // What friction in contact takes: sqrt(0.4 / 1.6) = 0.5 of the speed is left.
  EXPECT_NEAR(wear(with(worn_ball(1, 0.8), set::contact_friction(true), set::friction(0.6))),
              first_loss, 1e-9);
  // It fades to the end of the window.
  const double time = 2 * 3.0 / 9.81;
  EXPECT_LT(wear(worn_ball(0.5, time * (1 + 1e-9))), 1e-9 * first_loss);
  EXPECT_NEAR(wear(worn_ball(0.5, time / (1 - 0.1 * wear_smoothing))),
              first_loss * (1 - std::exp(-1.0)), 1e-9 * first_loss);
  Watched<double> watched;  // which sees the simulation, too
  wear(worn_ball(0.5, 0.7), watched);
  EXPECT_EQ(watched.hits.size(), 1U);
}

/// The two walls of a slot lose what each returns.
TEST(Wear, GoesByTheRestitutionOfTheWall) {
  const Scene scene = with(Scene{}, set::start_velocity(1), set::restitution_upper(0.5),
                           set::restitution_lower(0.2));  // up after 0.5 s, down 2 s later
  EXPECT_NEAR(wear(with(scene, set::seconds(2))), 1e3 * 0.5 * 0.75, 1e-9);
  EXPECT_NEAR(wear(with(scene, set::seconds(3))), 1e3 * 0.5 * (0.75 + 0.25 * (1 - 0.04)), 1e-9);
}

TEST(Limit, MeasuresWhatItSays) {
  // Between two walls a metre apart without a force: an impact each half second, the first after
  // a quarter.
  const Scene scene = with(Scene{}, set::mass(3), set::start_velocity(2), set::seconds(5),
                           set::omega(4 * std::numbers::pi));
  EXPECT_EQ(measured(scene, Measure::collisions), 10);
  EXPECT_NEAR(measured(scene, Measure::collisions_per_turn), 1, 1e-12);
  EXPECT_NEAR(measured(scene, Measure::impact_speed), 2, 1e-12);
  EXPECT_NEAR(measured(scene, Measure::energy), 0, 1e-12);
  // The first takes 3/4 of 6 J, long before the window ends.
  const Scene soft = with(scene, set::restitution_upper(0.5), set::seconds(1));
  EXPECT_NEAR(measured(soft, Measure::energy), 4.5, 1e-9);
  EXPECT_EQ(measured(with(soft, set::start_velocity(0)), Measure::impact_speed), 0);
}

}  // namespace
}  // namespace ricochet::carrier_track
