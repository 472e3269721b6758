#include "tests/support/scenes.h"

#include "problems/carrier_track/check/oracle.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "src/studies/simulators/suite.h"
#include "tests/carrier_track/models/brute_force.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

namespace ricochet::studies::simulators {
namespace {

using namespace carrier_track;

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

/// Expects the force of equation (31), straight from the formula.
void expect_force_of(const Scene& machine, const TestScene& scene) {
  for (const double share : {0.01, 0.2, 0.37, 0.73, 0.99}) {
    const double time = share * scene.duration;
    const double scale = std::abs(machine.pull) + std::abs(machine.disturbance) + 1;
    EXPECT_NEAR(force_at(scene, time), force_of_plate(machine, time), 1e-11 * scale);
  }
}

TEST(TestScene, HasTheForceOfEquation31) {
  RandomScenes draws(3);
  int profiles = 0;
  for (int k = 0; k < 132; ++k) {
    const ScoredScene drawn = drawn_scene(3, k);
    profiles += !drawn.machine.profile.empty();
    expect_force_of(drawn.machine, drawn.scene);
    Scene machine = with(draws.next(), set::contact_friction(false), set::seconds(2));
    expect_force_of(machine, test_scene(machine));
    machine.profile = {{0.5, machine.omega}, {1.5, draws.within(0.5, 20)}};
    expect_force_of(machine, test_scene(machine));
  }
  EXPECT_EQ(profiles, 12);
}

TEST(Truth, IsTheClosedFormOfABouncingBall) {
  TestScene scene;
  scene.mass = 3;
  scene.restitution_lower = 0.7;
  scene.position = 2;
  scene.duration = 4;
  scene.slowest = 0.01;
  scene.force = {{0, {{{-3 * 9.81, 0, 0}, {}}}}};
  Random random(1);
  const auto known = conditioned_truth(scene, random);
  ASSERT_TRUE(known);
  const auto bounces = bounces_of(2, 9.81, 0.7, known->impacts.size());
  ASSERT_GT(bounces.size(), 15U);
  for (std::size_t k = 0; k < bounces.size(); ++k) {
    const TrueImpact& impact = known->impacts[k];
    EXPECT_NEAR(impact.time, bounces[k].time, 1e-14);
    EXPECT_NEAR(impact.speed, bounces[k].speed, 1e-13);
    EXPECT_EQ(impact.wall, Wall::lower);
    EXPECT_GT(impact.time_sensitivity, 0);
  }
  // The first fall takes sqrt(2 h m / F): it changes by 3 / 2 of a change of all at most.
  EXPECT_LE(known->impacts.front().time_sensitivity, 1.5 * bounces[0].time);
  EXPECT_GT(known->impacts.back().speed, 0.005);
}

TEST(Truth, IsThatOfTheOracleInClosedForm) {
  RandomScenes scenes(5);
  int compared = 0;
  for (int k = 0; k < 200; ++k) {
    const Scene machine =
        with(scenes.next(), set::contact_friction(false), set::rule(CountRule::impacts));
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

TEST(ScoredScene, HasTheKeysOfTheSchema) {
  const report::Json schema = report::Json::parse(
      text_of(fs::path(RICOCHET_SOURCE "/docs/simulators.schema.json")))["$defs"]["scene"];
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
    EXPECT_EQ(json_of(drawn_scene(4, index)).dump(), json_of(drawn).dump()) << "drawn again";
    EXPECT_NE(json_of(drawn_scene(5, index)).dump(), json_of(drawn).dump());
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

/// Breaks a tool that has the true impacts, but none that is slower than 30 % of the fastest.
bool breaks_who_sees_fast_ones_alone(const ScoredScene& scored) {
  const double fastest = std::ranges::max(scored.truth, {}, &TrueImpact::speed).speed;
  Answer answer{scored.scene.scene};
  for (const TrueImpact& i : scored.truth) {
    if (i.speed > 0.3 * fastest) answer.impacts.push_back({i.time, i.wall, i.speed});
  }
  return score_of(answer, scored).wrong() > 0;
}

TEST(SmallestScene, IsSmallerAndStillBreaks) {
  for (const int index : {0, 1, 10}) {
    const ScoredScene from = drawn_scene(2, index);
    ASSERT_TRUE(breaks_who_sees_fast_ones_alone(from));
    int asked = 0;
    const auto breaks = [&](const ScoredScene& scored) {
      ++asked;
      return breaks_who_sees_fast_ones_alone(scored);
    };
    const ScoredScene smallest = smallest_scene(from, breaks, 200);
    EXPECT_LE(asked, 200);
    EXPECT_TRUE(breaks_who_sees_fast_ones_alone(smallest));
    EXPECT_LE(scored_impacts(smallest.scene, smallest.truth), 7) << words_of(smallest.machine);
    EXPECT_LT(words_of(smallest.machine).size(), words_of(from.machine).size());
    EXPECT_EQ(smallest.machine.mass, 1);
    // It is a scene like any other: ricochet has its impacts.
    const Score score = score_of(own_simulators()[0].open(Level::usual)(smallest), smallest);
    EXPECT_EQ(score.wrong() + score.late, 0);
  }
  const ScoredScene from = drawn_scene(2, 3);
  const auto never = [](const ScoredScene&) { return false; };
  EXPECT_EQ(json_of(smallest_scene(from, never, 200)).dump(), json_of(from).dump());
}

TEST(SmallestScene, IsDescribedInWords) {
  EXPECT_EQ(words_of(with(Scene{}, set::pull(2), set::restitution(0.5))),
            "1 kg, walls at 0 and 1 m, restitution 0.5, pull 2 N, from 0.5 m with 0 m/s, 1 s");
}

TEST(SmallestScene, IsNoSceneThatEndsAtAnImpact) {
  // Falls 0.5 m in 1 s.
  const Scene machine = with(Scene{}, set::pull(1), set::restitution_lower(0.5));
  EXPECT_FALSE(exactly(with(machine, set::seconds(1.001))));
  const auto later = exactly(with(machine, set::seconds(1.5)));
  ASSERT_TRUE(later);
  EXPECT_EQ(later->truth.size(), 1U);
  EXPECT_FALSE(exactly(with(machine, set::seconds(1.5), set::mass(-1))));
}

Ask own_simulator(const std::string& name, Level level = Level::usual) {
  for (const Simulator& one : own_simulators())
    if (one.tool.name == name) return one.open(level);
  throw std::invalid_argument(name);
}

TEST(OwnSimulators, AreTheLevelsOfTheModelAndTheMethods) {
  std::vector<std::string> names;
  for (const Simulator& one : own_simulators()) {
    names.push_back(one.tool.name);
    EXPECT_TRUE(one.own);
    EXPECT_NE(one.tool.title, "") << one.tool.name;
    EXPECT_NE(one.tool.kind, "") << one.tool.name;
    for (const std::string& level : one.tool.levels) EXPECT_NE(level, "") << one.tool.name;
  }
  EXPECT_EQ(names.front(), "ricochet");
  EXPECT_THAT(names, testing::IsSupersetOf({"planar", "exact-restitution", "odeint-dopri5",
                                            "semi-implicit-euler", "moreau-jean"}));
  EXPECT_EQ(std::ranges::count(names, "event-driven"), 0) << "it is ricochet";
}

/// The scores of a simulator in some scenes.
std::vector<Score> scores_of(const Ask& ask, int scenes) {
  std::vector<Score> scores;
  for (int k = 0; k < scenes; ++k) {
    const ScoredScene scored = drawn_scene(7, k);
    scores.push_back(score_of(ask(scored), scored));
  }
  return scores;
}

TEST(OwnSimulators, HardWallsLoseNothing) {
  for (const char* name : {"ricochet", "planar"}) {
    for (const Score& score : scores_of(own_simulator(name), 88)) {
      EXPECT_EQ(score.ending, Ending::answered) << name;
      EXPECT_EQ(score.wrong() + score.late + score.wrong_speed, 0) << name;
      EXPECT_LT(score.time_error.value_or(0), 1e-7) << name;
    }
  }
}

TEST(OwnSimulators, ComeNearerWithATighterSetting) {
  for (const char* name : {"exact-restitution", "odeint-dopri5", "moreau-jean"}) {
    const Tally loose = tally_of(scores_of(own_simulator(name, Level::loose), 44));
    const Tally tight = tally_of(scores_of(own_simulator(name, Level::tight), 44));
    EXPECT_LT(*tight.time_error, *loose.time_error / 3) << name;
    EXPECT_LE(*tight.wrong(), *loose.wrong()) << name;
    if (name != std::string("exact-restitution")) continue;
    EXPECT_GT(*tight.penetration, 0) << "its walls give";
    EXPECT_LT(*tight.penetration, 1e-5);
  }
}

TEST(OwnSimulators, SayWhatTheyCannotDo) {
  const Ask scan = own_simulator("ricochet-scan");
  const ScoredScene scored = drawn_scene(7, 0);
  EXPECT_EQ(score_of(scan(scored), scored).wrong(), 0);
  EXPECT_EQ(scan(drawn_scene(7, 10)).ending, Ending::cannot) << "it has a speed profile";
  ScoredScene plastic = drawn_scene(7, 9);
  plastic.machine = with(plastic.machine, set::restitution(0));
  EXPECT_EQ(own_simulator("exact-restitution")(plastic).ending, Ending::cannot);
}

}  // namespace
}  // namespace ricochet::studies::simulators
