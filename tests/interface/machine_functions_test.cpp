// The machine through libricochet.so, against the C++ library that it is made of.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "ricochet/machine.h"
#include "tests/interface/opened.h"

namespace ricochet::interface {
namespace {

using testing::HasSubstr;
using namespace carrier_track;

using OpenedMachine = std::unique_ptr<ricochet_machine, Closer>;

const std::string file = RICOCHET_SOURCE "/examples/machine.toml";
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The text of the machine with more lines in its table [scene].
std::string scene_with(const std::string& lines) {
  const OpenedMachine opened(ricochet_open_machine(file.c_str()));
  std::string text = ricochet_machine_text(opened.get());
  text.insert(text.find("[window]"), lines);
  return text;
}

OpenedMachine machine() {
  OpenedMachine opened(ricochet_open_machine(file.c_str()));
  EXPECT_TRUE(opened) << ricochet_error();
  return opened;
}

TEST(MachineFunctions, CountAsTheLibraryDoes) {
  const OpenedMachine opened = machine();
  std::vector<double> speeds;
  for (int k = 1; k <= 90; ++k) speeds.push_back(0.2 * k);
  std::vector<std::int32_t> found(speeds.size(), -1);
  ASSERT_EQ(ricochet_counts(opened.get(), speeds.data(), 90, found.data()), 0);
  const std::vector<int> expected = counts(read_scene(file), speeds);
  EXPECT_EQ(found, std::vector<std::int32_t>(expected.begin(), expected.end()));
  EXPECT_GT(expected.back(), 20);
  EXPECT_EQ(ricochet_counts(opened.get(), nullptr, 0, nullptr), 0);
}

TEST(MachineFunctions, TellASimulation) {
  const OpenedMachine opened = machine();
  EXPECT_EQ(ricochet_impacts(opened.get(), nullptr, nullptr, nullptr), 0) << "none yet";
  const Recording expected = simulate(at_speed(read_scene(file), 7.0), default_smoothing, 500);
  std::int32_t count = -1, certain = -1;
  ASSERT_EQ(ricochet_simulate(opened.get(), 7.0, 500, &count, &certain), 0);
  EXPECT_EQ(count, expected.count);
  EXPECT_EQ(certain, 1);
  EXPECT_STREQ(ricochet_doubt(opened.get()), "");
  const std::int64_t impacts = ricochet_impacts(opened.get(), nullptr, nullptr, nullptr);
  ASSERT_EQ(impacts, static_cast<std::int64_t>(expected.impacts.size()));
  ASSERT_GT(impacts, 10);
  std::vector<double> times(expected.impacts.size()), speeds(times);
  std::vector<std::int32_t> walls(times.size());
  ricochet_impacts(opened.get(), times.data(), speeds.data(), walls.data());
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_EQ(times[k], expected.impacts[k].time);
    EXPECT_EQ(speeds[k], expected.impacts[k].speed);
    EXPECT_EQ(walls[k], expected.impacts[k].wall == Wall::upper ? 1 : 0);
  }
  std::vector<double> t(expected.path.size()), x(t), v(t);
  ASSERT_EQ(ricochet_path(opened.get(), t.data(), x.data(), v.data()),
            static_cast<std::int64_t>(t.size()));
  ASSERT_GT(t.size(), 500U);
  for (std::size_t k = 0; k < t.size(); ++k) {
    EXPECT_EQ(t[k], expected.path[k].time);
    EXPECT_EQ(x[k], expected.path[k].position);
    EXPECT_EQ(v[k], expected.path[k].velocity);
  }
}

TEST(MachineFunctions, SimulateAtTheSpeedOfTheFile) {
  Scene scene = read_scene(file);
  scene.omega = 6.5;
  const OpenedMachine constant(ricochet_parse_machine(write_scene(scene).c_str()));
  ASSERT_TRUE(constant) << ricochet_error();
  EXPECT_EQ(ricochet_machine_speed(constant.get()), 6.5);
  std::int32_t count = -1;
  ASSERT_EQ(ricochet_simulate(constant.get(), none, 0, &count, nullptr), 0);
  EXPECT_EQ(count, simulate(scene).count);
  EXPECT_EQ(ricochet_path(constant.get(), nullptr, nullptr, nullptr), 0);

  scene.profile = {{0, 5.0}, {4, 8.0}};
  const OpenedMachine profile(ricochet_parse_machine(write_scene(scene).c_str()));
  ASSERT_TRUE(profile) << ricochet_error();
  EXPECT_TRUE(std::isnan(ricochet_machine_speed(profile.get())));
  ASSERT_EQ(ricochet_simulate(profile.get(), none, 0, &count, nullptr), 0);
  EXPECT_EQ(count, simulate(scene).count);
}

TEST(MachineFunctions, TellWhyACountIsNotCertain) {
  const Scene scene = read_scene(file);
  double quiet = 5, omega = 7;  // ever closer to where the count changes
  Recording expected = simulate(at_speed(scene, omega));
  while (expected.certainty.certain) {
    const double between = (quiet + omega) / 2;
    ASSERT_TRUE(quiet < between && between < omega) << "every count is certain";
    expected = simulate(at_speed(scene, between));
    (expected.count == 0 && expected.certainty.certain ? quiet : omega) = between;
  }
  const OpenedMachine opened = machine();
  std::int32_t certain = -1;
  ASSERT_EQ(ricochet_simulate(opened.get(), omega, 0, nullptr, &certain), 0);
  EXPECT_EQ(certain, 0);
  EXPECT_EQ(ricochet_doubt(opened.get()), expected.certainty.reason);
}

TEST(MachineFunctions, TellRegimes) {
  Scene scene = read_scene(file);
  scene.disturbance = 2;  // so that turns differ in their collisions
  scene.disturbance_frequency = 11;
  const OpenedMachine opened(ricochet_parse_machine(write_scene(scene).c_str()));
  const std::vector<Regime> expected = regimes_of(scene, {5.7, 6});
  EXPECT_TRUE(std::ranges::any_of(expected, [](const Regime& regime) {
    return regime.least_per_turn < regime.collisions_per_turn &&
           regime.collisions_per_turn < regime.most_per_turn;
  }));
  const auto size = expected.size();
  ASSERT_GT(size, 1U);
  EXPECT_EQ(ricochet_regimes(opened.get(), 5.7, 6), static_cast<std::int64_t>(size));
  std::vector<double> from(size), to(size), mean(size), least(size), most(size);
  std::vector<std::int32_t> turns(size), rests(size), certain(size);
  ASSERT_EQ(ricochet_regime_table(opened.get(), from.data(), to.data(), mean.data(), least.data(),
                                  most.data(), turns.data(), rests.data(), certain.data()),
            static_cast<std::int64_t>(size));
  for (std::size_t k = 0; k < size; ++k) {
    EXPECT_EQ(from[k], expected[k].from);
    EXPECT_EQ(to[k], expected[k].to);
    EXPECT_EQ(mean[k], expected[k].collisions_per_turn);
    EXPECT_EQ(least[k], expected[k].least_per_turn);
    EXPECT_EQ(most[k], expected[k].most_per_turn);
    EXPECT_EQ(turns[k], expected[k].turns);
    EXPECT_EQ(rests[k], expected[k].rests ? 1 : 0);
    EXPECT_EQ(certain[k], expected[k].certain ? 1 : 0);
    EXPECT_EQ(ricochet_regime_end(opened.get(), static_cast<std::int64_t>(k)),
              name_of(expected[k].ends_by));
  }
  EXPECT_EQ(ricochet_regime_end(opened.get(), 99), nullptr);
  EXPECT_THAT(ricochet_error(), HasSubstr("regime 99: there are"));
}

TEST(MachineFunctions, FindTheFastestQuietSpeed) {
  const OpenedMachine opened = machine();
  const Scene scene = read_scene(file);
  double quiet = 0, loud = 0, limit = 0;
  ASSERT_EQ(ricochet_quiet_speed(opened.get(), nullptr, none, none, &quiet, &loud, &limit), 0);
  const QuietSpeed expected = quiet_speed(scene);
  EXPECT_EQ(quiet, expected.fastest_quiet.value());
  EXPECT_EQ(loud, expected.split.first_loud.value());
  EXPECT_EQ(limit, quiet_per_turn);
  const std::pair<const char*, Limit> limits[] = {
      {"collisions", {Measure::collisions, 10}},
      {"collisions-per-turn", {Measure::collisions_per_turn, 4}},
      {"energy", {Measure::energy, 1e-3}},
      {"impact-speed", {Measure::impact_speed, 0.03}}};
  for (const auto& [name, asked] : limits) {
    SCOPED_TRACE(name);
    QuietSpeedOptions options;
    options.limit = asked;
    options.fastest = 12;
    ASSERT_EQ(ricochet_quiet_speed(opened.get(), name, asked.at_most, 12, &quiet, nullptr, nullptr),
              0);
    EXPECT_EQ(quiet, quiet_speed(scene, options).fastest_quiet.value());
    EXPECT_LT(quiet, 12);
  }
  EXPECT_EQ(ricochet_quiet_speed(opened.get(), "noise", 1, none, &quiet, nullptr, nullptr), 1);
  EXPECT_THAT(ricochet_error(), HasSubstr("measure noise: must be collisions, "));
}

void expect_refusal(const OpenedMachine& opened, const std::string& reason) {
  EXPECT_FALSE(opened);
  EXPECT_THAT(ricochet_error(), HasSubstr(reason));
}

TEST(MachineFunctions, RefuseWhatIsNoMachine) {
  const auto parsed = [](const char* text) { return OpenedMachine(ricochet_parse_machine(text)); };
  expect_refusal(OpenedMachine(ricochet_open_machine("none.toml")), "none.toml: there is no");
  expect_refusal(OpenedMachine(ricochet_open_machine(nullptr)), "the machine file has no name");
  expect_refusal(parsed(nullptr), "the text of the machine is NULL");
  expect_refusal(parsed("[scene"), "text:1: not valid TOML");
  expect_refusal(parsed("[scene]\nmas = 1\n[window]\nseconds = 1"), "mas");
}

TEST(MachineFunctions, RefuseInTheWordsOfTheLibrary) {
  const OpenedMachine opened = machine();
  const double speeds[] = {5, -1};
  std::int32_t found[] = {42, 42};
  const auto expect_error = [](const std::string& reason) {
    EXPECT_THAT(ricochet_error(), HasSubstr(reason));
  };
  EXPECT_EQ(ricochet_counts(opened.get(), speeds, 2, found), 1);
  expect_error("speed = -1: must be a finite number > 0");
  EXPECT_EQ(found[0], 42);
  EXPECT_EQ(ricochet_counts(opened.get(), speeds, -1, found), 1);
  expect_error("-1 speeds: must be >= 0");
  EXPECT_EQ(ricochet_counts(opened.get(), nullptr, 2, found), 1);
  expect_error("NULL");
  EXPECT_EQ(ricochet_simulate(opened.get(), -1, 0, nullptr, nullptr), 1);
  expect_error("omega = -1: must be");
  EXPECT_EQ(ricochet_simulate(opened.get(), 5, -1, nullptr, nullptr), 1);
  expect_error("samples -1: must be >= 0");
  EXPECT_EQ(ricochet_regimes(opened.get(), 5, 4), -1);
  expect_error("speeds 5 to 4: must rise");
  EXPECT_EQ(ricochet_quiet_speed(opened.get(), nullptr, none, -1, nullptr, nullptr, nullptr), 1);
  expect_error("fastest = -1: must be within");
}

TEST(MachineFunctions, KnowWhichMachinesAreOpen) {
  ricochet_machine* const closed = ricochet_open_machine(file.c_str());
  EXPECT_THAT(ricochet_machine_text(closed), HasSubstr("[scene]"));
  ricochet_close_machine(closed);
  for (ricochet_machine* const machine : {closed, static_cast<ricochet_machine*>(nullptr)}) {
    EXPECT_EQ(ricochet_machine_text(machine), nullptr);
    EXPECT_TRUE(std::isnan(ricochet_machine_speed(machine)));
    EXPECT_EQ(ricochet_counts(machine, nullptr, 0, nullptr), 1);
    EXPECT_EQ(ricochet_simulate(machine, 5, 0, nullptr, nullptr), 1);
    EXPECT_EQ(ricochet_doubt(machine), nullptr);
    EXPECT_EQ(ricochet_impacts(machine, nullptr, nullptr, nullptr), -1);
    EXPECT_EQ(ricochet_path(machine, nullptr, nullptr, nullptr), -1);
    EXPECT_EQ(ricochet_regimes(machine, 1, 2), -1);
    EXPECT_EQ(ricochet_regime_table(machine, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
                                    nullptr, nullptr),
              -1);
    EXPECT_EQ(ricochet_quiet_speed(machine, nullptr, none, none, nullptr, nullptr, nullptr), 1);
    EXPECT_STREQ(ricochet_error(), "the machine is not open");
  }
  ricochet_close_machine(nullptr);
  ricochet_close_machine(closed);
  EXPECT_STREQ(ricochet_error(), "the machine is not open");
}

/// Each thread has speeds of its own, on one machine that all use and on one that it opens and
/// closes.
TEST(MachineFunctions, AreUsedByManyThreadsAtOnce) {
  const OpenedMachine shared = machine();
  const std::vector<double> speeds = {5.0, 6.0, 7.0, 8.0};
  const std::vector<int> expected = counts(read_scene(file), speeds);
  std::vector<int> wrong(speeds.size(), 0);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < speeds.size(); ++t) {
    threads.emplace_back([&, t] {
      for (int k = 0; k < 100; ++k) {
        const OpenedMachine own = machine();
        for (ricochet_machine* asked : {shared.get(), own.get()}) {
          std::int32_t found = -1;
          ricochet_counts(asked, &speeds[t], 1, &found);
          wrong[t] += found == expected[t] ? 0 : 1;
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(wrong, testing::Each(0));
  EXPECT_THAT(expected, testing::Contains(testing::Ne(expected[0])));
}

TEST(MachineFunctions, SayHowFarTheyCameBeforeTheTimeLimit) {
  const std::string text = scene_with("disturbance = 3.0\ndisturbance_frequency = 7.3\n");
  const OpenedMachine opened(ricochet_parse_machine(text.c_str()));
  ASSERT_TRUE(opened) << ricochet_error();
  EXPECT_EQ(ricochet_limit_seconds(0), 1);
  EXPECT_THAT(ricochet_error(), HasSubstr("seconds 0: must be > 0"));
  ASSERT_EQ(ricochet_limit_seconds(0.2), 0);
  const std::int64_t regimes = ricochet_regimes(opened.get(), 0.01, 18);
  if (regimes < 0) {
    EXPECT_THAT(ricochet_error(), HasSubstr("the time limit of 0.2 s was reached"));
  } else {
    EXPECT_EQ(ricochet_regime_end(opened.get(), regimes - 1), std::string("time-limit"));
    EXPECT_LT(ricochet_reached(), 18);
  }
  std::thread([&] { EXPECT_TRUE(std::isnan(ricochet_reached())) << "of another thread"; }).join();
  const OpenedMachine usual = machine();
  ASSERT_EQ(ricochet_limit_seconds(INFINITY), 0);
  EXPECT_GT(ricochet_regimes(usual.get(), 0.01, 18), 0);
  EXPECT_TRUE(std::isnan(ricochet_reached()));
  ricochet_limit_seconds(60);
}

TEST(MachineFunctions, TellNoQuietSpeedWhereEverySpeedIsLoud) {
  std::string text = scene_with("");
  text.replace(text.find("friction = 0.2"), 14, "friction = 0");
  text.replace(text.find("counting_limit = \"5 mm/s\""), 25, "counting_limit = 1e-6");
  const OpenedMachine opened(ricochet_parse_machine(text.c_str()));
  ASSERT_TRUE(opened) << ricochet_error();
  double quiet = 0, loud = 0;
  ASSERT_EQ(ricochet_quiet_speed(opened.get(), nullptr, none, 5, &quiet, &loud, nullptr), 0)
      << ricochet_error();
  EXPECT_TRUE(std::isnan(quiet)) << quiet;
  EXPECT_EQ(loud, 0.01);
}

}  // namespace
}  // namespace ricochet::interface
