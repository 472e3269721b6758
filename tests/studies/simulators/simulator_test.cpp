#include <gmock/gmock.h>

#include "src/studies/simulators/suite.h"

namespace ricochet::studies::simulators {
namespace {

Simulator own_simulator(const std::string& name) {
  for (Simulator& one : own_simulators())
    if (one.tool.name == name) return std::move(one);
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

TEST(OwnSimulators, HardWallsLoseNothing) {
  for (const char* name : {"ricochet", "planar"}) {
    const Ask ask = own_simulator(name).open(Level::usual);
    for (int k = 0; k < 88; ++k) {
      const ScoredScene scored = drawn_scene(7, k);
      const Score score = score_of(ask(scored), scored);
      EXPECT_EQ(score.ending, Ending::answered);
      EXPECT_EQ(score.wrong() + score.late + score.wrong_speed, 0)
          << name << ", " << scored.scene.scene;
      EXPECT_LT(score.time_error.value_or(0), 1e-7);
    }
  }
}

/// Impacts that a simulator loses in 44 scenes.
Tally tally_at(const char* name, Level level) {
  std::vector<Score> scores;
  const Ask ask = own_simulator(name).open(level);
  for (int k = 0; k < 44; ++k) {
    const ScoredScene scored = drawn_scene(7, k);
    scores.push_back(score_of(ask(scored), scored));
  }
  return tally_of(scores);
}

TEST(OwnSimulators, ComeNearerWithATighterSetting) {
  for (const char* name : {"exact-restitution", "odeint-dopri5", "moreau-jean"}) {
    const Tally loose = tally_at(name, Level::loose), tight = tally_at(name, Level::tight);
    EXPECT_LT(*tight.time_error, *loose.time_error / 3) << name;
    EXPECT_LE(*tight.wrong(), *loose.wrong()) << name;
  }
  const Tally compliant = tally_at("exact-restitution", Level::tight);
  EXPECT_GT(*compliant.penetration, 0);
  EXPECT_LT(*compliant.penetration, 1e-5);
}

TEST(OwnSimulators, OfAScanHaveTheImpactsOfTheScene) {
  const Ask ask = own_simulator("ricochet-scan").open(Level::usual);
  const ScoredScene scored = drawn_scene(7, 0);
  EXPECT_EQ(score_of(ask(scored), scored).wrong(), 0);
  EXPECT_EQ(ask(drawn_scene(7, 10)).ending, Ending::cannot) << "it has a speed profile";
}

TEST(OwnSimulators, SayWhatTheyCannotDo) {
  ScoredScene plastic = drawn_scene(7, 9);
  plastic.machine.restitution_lower = plastic.machine.restitution_upper = 0;
  EXPECT_EQ(own_simulator("exact-restitution").open(Level::usual)(plastic).ending, Ending::cannot);
}

}  // namespace
}  // namespace ricochet::studies::simulators
