#include <gmock/gmock.h>

#include <fstream>
#include <set>

#include "problems/carrier_track/check/oracle.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/motion/profile_forces.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "tests/studies/simulators/some_scenes.h"

namespace ricochet::studies::simulators {
namespace {

using namespace carrier_track;

using testing::HasSubstr;

/// The applied force [N] at a time [s].
double force_at(const TestScene& scene, double time) {
  const auto next = std::ranges::upper_bound(scene.force, time, {}, &ForceSegment::from);
  const ForceSegment& segment = *(next - 1);
  const double u = time - segment.from;
  const auto at = [u](const auto& p) { return p[0] + u * (p[1] + u * p[2]); };
  double sum = 0;
  for (const ForceTerm& term : segment.terms) sum += at(term.amplitude) * std::cos(at(term.phase));
  return sum;
}

template <class Forces>
double force_of_ricochet(const Scene& machine, double time) {
  Forces forces(machine);
  forces.pass(time);
  return machine.mass * forces.sum();
}

TEST(TestScene, HasTheForceOfTheSimulator) {
  int profiles = 0;
  for (int k = 0; k < 132; ++k) {
    const ScoredScene drawn = drawn_scene(3, k);
    const Scene& machine = drawn.machine;
    profiles += machine.profile.empty() ? 0 : 1;
    for (const double share : {0.01, 0.2, 0.37, 0.73, 0.99}) {
      const double time = share * drawn.scene.duration;
      const double expected = machine.profile.empty()
                                  ? force_of_ricochet<AppliedForces<double>>(machine, time)
                                  : force_of_ricochet<ProfileForces<double>>(machine, time);
      const double scale = std::abs(machine.pull) + std::abs(machine.disturbance) + 1;
      EXPECT_NEAR(force_at(drawn.scene, time), expected, 1e-11 * scale) << drawn.scene.scene;
    }
  }
  EXPECT_EQ(profiles, 12);
}

TEST(TestScene, KnowsAllForcesOfAProfile) {
  Scene machine;
  machine.mass = 2;
  machine.pull = 0.7;
  machine.pull_rotates = true;
  machine.pull_phase = 0.4;
  machine.slider_mass_radius = 0.3;
  machine.centrifugal_mass_radius = 0.2;
  machine.phase = 1;
  machine.disturbance = 0.5;
  machine.disturbance_frequency = 7;
  machine.profile = {{0.5, 2}, {1.5, 4}};
  machine.window = Seconds{2};
  // alpha = 1 + 2 t, then + (t - 0.5)^2, omega = 2 + 2 (t - 0.5), omega' = 2.
  const double t = 1.25, omega = 3.5, alpha = 1 + 2 * t + 0.75 * 0.75;
  for (const auto& [rule, centrifugal] :
       {std::pair{Centrifugal::projected, std::cos(alpha)}, std::pair{Centrifugal::inward, -1.0},
        std::pair{Centrifugal::outward, 1.0}}) {
    machine.centrifugal = rule;
    const double expected = -0.7 * std::cos(alpha + 0.4) + 0.2 * omega * omega * centrifugal -
                            0.3 * (2 * std::sin(alpha) + omega * omega * std::cos(alpha)) +
                            0.5 * std::cos(7 * t);
    EXPECT_NEAR(force_at(test_scene(machine), t), expected, 1e-14);
  }
}

TEST(Truth, IsTheClosedFormOfABouncingBall) {
  const double e = 0.7, gravity = 9.81, height = 2;
  TestScene scene;
  scene.mass = 3;
  scene.restitution_lower = e;
  scene.position = height;
  scene.duration = 4;
  scene.slowest = 0.01;
  scene.force = {{0, {{{-3 * gravity, 0, 0}, {}}}}};
  Random random(1);
  const auto known = conditioned_truth(scene, random);
  ASSERT_TRUE(known);
  const double first = std::sqrt(2 * height / gravity);
  ASSERT_GT(known->impacts.size(), 15U);
  for (std::size_t k = 0; k < known->impacts.size(); ++k) {
    const double power = std::pow(e, k);
    const TrueImpact& impact = known->impacts[k];
    EXPECT_NEAR(impact.time, first * (1 + e - 2 * e * power) / (1 - e), 1e-14);
    EXPECT_NEAR(impact.speed, gravity * first * power, 1e-13);
    EXPECT_EQ(impact.wall, Wall::lower);
    EXPECT_GT(impact.time_sensitivity, 0);
  }
  // The first fall takes sqrt(2 h m / F): it changes by 3 / 2 of a change of all at most.
  EXPECT_LE(known->impacts.front().time_sensitivity, 1.5 * first);
  EXPECT_GT(known->impacts.back().speed, 0.005);
}

TEST(Truth, IsThatOfTheOracleInClosedForm) {
  RandomScenes scenes(5);
  int compared = 0;
  for (int k = 0; k < 200; ++k) {
    Scene machine = scenes.next();
    machine.contact_friction = false;
    machine.rule = CountRule::impacts;
    const OracleRun closed = oracle_run(machine);
    const auto impacts = exact_impacts(test_scene(machine));
    ASSERT_EQ(impacts.has_value(), closed.finished);
    if (!impacts) continue;
    std::size_t next = 0;
    for (const Impact& i : closed.impacts) {
      if (i.speed <= machine.counting_limit / 2) continue;
      ASSERT_LT(next, impacts->size()) << k;
      const Impact& own = (*impacts)[next++];
      EXPECT_EQ(own.wall, i.wall);
      EXPECT_NEAR(own.time, i.time, 1e-11) << k;
      ++compared;
    }
    EXPECT_EQ(next, impacts->size()) << k;
  }
  EXPECT_GT(compared, 1000);
}

TEST(Truth, EndsWhereAnImpactIsBarelyThere) {
  // The path touches the upper wall, or just does not, by 1e-13 of the clearance.
  TestScene scene;
  scene.upper = 1;
  scene.restitution_lower = scene.restitution_upper = 0.9;
  scene.duration = 20;
  scene.slowest = 1e-9;
  scene.force = {{0, {{{-1, 0, 0}, {}}}}};
  for (const double by : {1e-13, -1e-13}) {
    scene.velocity = std::sqrt(2.0) * (1 + by);
    Random random(1);
    const auto known = conditioned_truth(scene, random);
    ASSERT_TRUE(known);
    EXPECT_TRUE(known->impacts.empty());
    EXPECT_NEAR(known->good_until, (by > 0 ? 1 : 2) * std::sqrt(2.0), 1e-5);
  }
}

TEST(Answer, IsReadInAnyOrderOfImpacts) {
  const Answer answer = answer_in(
      R"({"scene":"a","impacts":[[2,"upper",0.5],[1,"lower",3]],"seconds":0.1,"deepest":1e-5,"end":[0,1]})",
      "a");
  EXPECT_EQ(answer.ending, Ending::answered);
  ASSERT_EQ(answer.impacts.size(), 2U);
  EXPECT_EQ(answer.impacts[0].time, 1);
  EXPECT_EQ(answer.impacts[0].wall, Wall::lower);
  EXPECT_EQ(answer.impacts[1].speed, 0.5);
  EXPECT_EQ(answer.seconds, 0.1);
  EXPECT_EQ(answer.deepest, 1e-5);
}

TEST(Answer, MayBeThatTheToolCannotOrHasFailed) {
  EXPECT_EQ(answer_in(R"({"scene":"a","cannot":"one wall only"})", "a").ending, Ending::cannot);
  EXPECT_EQ(answer_in(R"({"scene":"a","error":"overflow"})", "a").reason, "overflow");
}

TEST(Answer, IsAnErrorIfItIsNone) {
  for (const char* line :
       {"", "Traceback:", "[]", R"({"scene":"a"})", R"({"scene":"b","impacts":[],"seconds":1})",
        R"({"scene":"a","impacts":[[1,"left",1]],"seconds":1})",
        R"({"scene":"a","impacts":[[1,"lower"]],"seconds":1})",
        R"({"scene":"a","impacts":[[1,"lower",null]],"seconds":1})",
        R"({"scene":"a","impacts":[],"seconds":-1})", R"({"scene":"a","error":7})"}) {
    const Answer answer = answer_in(line, "a");
    EXPECT_EQ(answer.ending, Ending::error) << line;
    EXPECT_THAT(answer.reason, HasSubstr("no answer")) << line;
  }
}

TEST(Answer, IsWrittenAsItIsRead) {
  const Answer right = right_answer(with_impacts(3));
  const Answer back = answer_in(line_of(right), "made");
  ASSERT_EQ(back.impacts.size(), 3U);
  EXPECT_EQ(back.impacts[2].time, 3);
  for (const Ending ending : {Ending::cannot, Ending::error, Ending::never}) {
    const Answer answer{"made", ending, "why"};
    EXPECT_EQ(answer_in(line_of(answer), "made").ending, ending);
    EXPECT_EQ(answer_in(line_of(answer), "made").reason, "why");
  }
}

TEST(ScoredScene, IsDrawnAgainToTheLastBit) {
  for (const int index : {0, 8, 21}) {
    EXPECT_EQ(json_of(drawn_scene(1, index)).dump(), json_of(drawn_scene(1, index)).dump());
    EXPECT_NE(json_of(drawn_scene(2, index)).dump(), json_of(drawn_scene(1, index)).dump());
  }
}

TEST(ScoredScene, HasTheKeysOfTheSchema) {
  std::ifstream file(RICOCHET_SOURCE "/docs/simulators.schema.json");
  const report::Json schema = report::Json::parse(file)["$defs"]["scene"];
  const report::Json line = json_of(drawn_scene(1, 0));
  std::set<std::string> described, written;
  for (const auto& [key, value] : schema["properties"].items()) described.insert(key);
  for (const auto& [key, value] : line.items()) written.insert(key);
  EXPECT_EQ(described.erase("scales"), 1U) << "sent to a tool, and not kept";
  EXPECT_EQ(described, written);
  EXPECT_EQ(schema["properties"]["version"]["const"], suite_version);
  for (const auto& key : schema["required"]) EXPECT_TRUE(line.contains(key.get<std::string>()));
}

TEST(ScoredScene, IsOfEachKindAndDifficultyInTurn) {
  std::set<std::pair<std::string, int>> seen;
  for (int index = 0; index < 44; ++index) {
    const ScoredScene drawn = drawn_scene(4, index);
    seen.insert({drawn.scene.kind, drawn.scene.difficulty});
    carrier_track::check(drawn.machine, drawn.scene.scene);
    EXPECT_GE(scored_impacts(drawn.scene, drawn.truth), 1);
    EXPECT_LE(scored_impacts(drawn.scene, drawn.truth), most_impacts);
    EXPECT_GE(drawn.scene.slowest, least_slowest);
    for (const TrueImpact& i : drawn.truth) {
      EXPECT_LE(i.time_sensitivity, 2 * most_growth * mean_time_between(drawn.scene, drawn.truth));
      EXPECT_LT(i.time, drawn.scene.duration);
    }
  }
  EXPECT_EQ(seen.size(), scene_kinds().size() * difficulties);
}

}  // namespace
}  // namespace ricochet::studies::simulators
