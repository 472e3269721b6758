// The functions of libricochet.so for a machine, against the C++ library that they are made of,
// many threads that use it, and what the library exports.

#include <latch>
#include <regex>

#include "ricochet/machine.h"
#include "tests/interface/opened.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

namespace ricochet::interface {
namespace {

using namespace carrier_track;
using testing::IsSupersetOf;

using Numbers = std::vector<double>;

const std::string file = RICOCHET_SOURCE "/examples/machine.toml";
constexpr double none = NAN;

OpenedMachine machine() {
  OpenedMachine opened(ricochet_open_machine(file.c_str()));
  EXPECT_TRUE(opened) << ricochet_error();
  return opened;
}

OpenedMachine machine(const Scene& scene) {
  OpenedMachine opened(ricochet_parse_machine(write_scene(scene).c_str()));
  EXPECT_TRUE(opened) << ricochet_error();
  return opened;
}

TEST(MachineFunctions, CountAsTheLibraryDoes) {
  const OpenedMachine opened = machine();
  Numbers speeds;
  for (int k = 1; k <= 90; ++k) speeds.push_back(0.2 * k);
  std::vector<int> found(speeds.size(), -1);
  ASSERT_EQ(ricochet_counts(opened.get(), speeds.data(), 90, found.data()), 0);
  const std::vector<int> expected = counts(read_scene(file), speeds);
  EXPECT_EQ(found, expected);
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
  Numbers times(expected.impacts.size()), speeds(times);
  std::vector<std::int32_t> walls(times.size());
  ricochet_impacts(opened.get(), times.data(), speeds.data(), walls.data());
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_THAT(expected.impacts[k],
                FieldsAre(times[k], walls[k] == 1 ? Wall::upper : Wall::lower, speeds[k]));
  }
  Numbers t(expected.path.size()), x(t), v(t);
  ASSERT_EQ(ricochet_path(opened.get(), t.data(), x.data(), v.data()),
            static_cast<std::int64_t>(t.size()));
  ASSERT_GT(t.size(), 500U);
  for (std::size_t k = 0; k < t.size(); ++k) {
    EXPECT_THAT(expected.path[k], FieldsAre(t[k], x[k], v[k]));
  }
}

TEST(MachineFunctions, SimulateAtTheSpeedOfTheFile) {
  Scene scene = read_scene(file);
  scene.omega = 6.5;
  for (const bool varies : {false, true}) {
    if (varies) scene.profile = {{0, 5.0}, {4, 8.0}};
    const OpenedMachine opened = machine(scene);
    const double speed = ricochet_machine_speed(opened.get());
    EXPECT_TRUE(varies ? std::isnan(speed) : speed == 6.5);
    std::int32_t count = -1;
    ASSERT_EQ(ricochet_simulate(opened.get(), none, 0, &count, nullptr), 0);
    EXPECT_EQ(count, simulate(scene).count);
    EXPECT_EQ(ricochet_path(opened.get(), nullptr, nullptr, nullptr), 0);
  }
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
  const OpenedMachine opened = machine(scene);
  const std::vector<Regime> expected = regimes_of(scene, {5.7, 6});
  EXPECT_TRUE(std::ranges::any_of(expected, [](const Regime& regime) {
    return regime.least_per_turn < regime.collisions_per_turn &&
           regime.collisions_per_turn < regime.most_per_turn;
  }));
  const auto size = expected.size();
  ASSERT_GT(size, 1U);
  EXPECT_EQ(ricochet_regimes(opened.get(), 5.7, 6), static_cast<std::int64_t>(size));
  Numbers from(size), to(size), mean(size), least(size), most(size);
  std::vector<std::int32_t> turns(size), rests(size), certain(size);
  ASSERT_EQ(ricochet_regime_table(opened.get(), from.data(), to.data(), mean.data(), least.data(),
                                  most.data(), turns.data(), rests.data(), certain.data()),
            static_cast<std::int64_t>(size));
  for (std::size_t k = 0; k < size; ++k) {
    const Regime& r = expected[k];
    EXPECT_EQ(std::tuple(from[k], to[k], mean[k], least[k], most[k], turns[k], rests[k] == 1,
                         certain[k] == 1),
              std::tuple(r.from, r.to, r.collisions_per_turn, r.least_per_turn, r.most_per_turn,
                         r.turns, r.rests, r.certain));
    EXPECT_EQ(ricochet_regime_end(opened.get(), static_cast<std::int64_t>(k)), name_of(r.ends_by));
  }
  EXPECT_EQ(ricochet_regime_end(opened.get(), 99), nullptr);
  expect_reason("regime 99: there are");
}

TEST(MachineFunctions, FindTheFastestQuietSpeed) {
  const OpenedMachine opened = machine();
  Scene scene = read_scene(file);
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
  scene.friction = 0;
  scene.counting_limit = 1e-6;
  const OpenedMachine never_quiet = machine(scene);
  ASSERT_EQ(ricochet_quiet_speed(never_quiet.get(), nullptr, none, 5, &quiet, &loud, nullptr), 0);
  EXPECT_TRUE(std::isnan(quiet)) << quiet;
  EXPECT_EQ(loud, 0.01);
}

TEST(MachineFunctions, RefuseInTheWordsOfTheLibrary) {
  const OpenedMachine opened = machine();
  const double speeds[] = {5, -1};
  std::int32_t found[] = {42, 42};
  const auto expect_refusal = [](bool refused, const char* reason) {
    EXPECT_TRUE(refused) << reason;
    expect_reason(reason);
  };
  expect_refusal(!ricochet_open_machine("none.toml"), "none.toml: there is no");
  expect_refusal(!ricochet_open_machine(nullptr), "the machine file has no name");
  expect_refusal(!ricochet_parse_machine(nullptr), "the text of the machine is NULL");
  expect_refusal(!ricochet_parse_machine("[scene"), "text:1: not valid TOML");
  expect_refusal(!ricochet_parse_machine("[scene]\nmas = 1\n[window]\nseconds = 1"), "mas");
  expect_refusal(ricochet_counts(opened.get(), speeds, 2, found) == 1,
                 "speed = -1: must be a finite number > 0");
  EXPECT_EQ(found[0], 42);
  expect_refusal(ricochet_counts(opened.get(), speeds, -1, found) == 1, "-1 speeds: must be >= 0");
  expect_refusal(ricochet_counts(opened.get(), nullptr, 2, found) == 1, "NULL");
  expect_refusal(ricochet_simulate(opened.get(), -1, 0, nullptr, nullptr) == 1,
                 "omega = -1: must be");
  expect_refusal(ricochet_simulate(opened.get(), 5, -1, nullptr, nullptr) == 1,
                 "samples -1: must be >= 0");
  expect_refusal(ricochet_regimes(opened.get(), 5, 4) == -1, "speeds 5 to 4: must rise");
  expect_refusal(
      ricochet_quiet_speed(opened.get(), nullptr, none, -1, nullptr, nullptr, nullptr) == 1,
      "fastest = -1: must be within");
  expect_refusal(
      ricochet_quiet_speed(opened.get(), "noise", 1, none, nullptr, nullptr, nullptr) == 1,
      "measure noise: must be collisions, ");
}

TEST(MachineFunctions, KnowWhichMachinesAreOpen) {
  ricochet_machine* const closed = ricochet_open_machine(file.c_str());
  EXPECT_THAT(ricochet_machine_text(closed), HasSubstr("[scene]"));
  ricochet_close_machine(closed);
  for (ricochet_machine* const m : {closed, static_cast<ricochet_machine*>(nullptr)}) {
    EXPECT_EQ(ricochet_machine_text(m), nullptr);
    EXPECT_EQ(ricochet_doubt(m), nullptr);
    EXPECT_TRUE(std::isnan(ricochet_machine_speed(m)));
    EXPECT_THAT(
        (std::vector{ricochet_counts(m, nullptr, 0, nullptr),
                     ricochet_simulate(m, 5, 0, nullptr, nullptr),
                     ricochet_quiet_speed(m, nullptr, none, none, nullptr, nullptr, nullptr)}),
        Each(1));
    EXPECT_THAT((std::vector{ricochet_impacts(m, nullptr, nullptr, nullptr),
                             ricochet_path(m, nullptr, nullptr, nullptr), ricochet_regimes(m, 1, 2),
                             ricochet_regime_table(m, nullptr, nullptr, nullptr, nullptr, nullptr,
                                                   nullptr, nullptr, nullptr)}),
                Each(-1));
    EXPECT_STREQ(ricochet_error(), "the machine is not open");
  }
  ricochet_close_machine(nullptr);
  ricochet_close_machine(closed);
  EXPECT_STREQ(ricochet_error(), "the machine is not open");
}

/// Calls work(0), work(1), ..., each in a thread of its own.
template <class Work>
void in_threads(std::size_t count, const Work& work) {
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < count; ++k) threads.emplace_back([&work, k] { work(k); });
  for (std::thread& thread : threads) thread.join();
}

/// Each thread has speeds of its own, on one machine that all use and on one that it opens and
/// closes.
TEST(MachineFunctions, AreUsedByManyThreadsAtOnce) {
  const OpenedMachine shared = machine();
  const Numbers speeds = {5.0, 6.0, 7.0, 8.0};
  const std::vector<int> expected = counts(read_scene(file), speeds);
  std::vector<int> wrong(speeds.size(), 0);
  in_threads(speeds.size(), [&](std::size_t t) {
    for (int k = 0; k < 100; ++k) {
      const OpenedMachine own = machine();
      for (ricochet_machine* asked : {shared.get(), own.get()}) {
        std::int32_t found = -1;
        ricochet_counts(asked, &speeds[t], 1, &found);
        wrong[t] += found == expected[t] ? 0 : 1;
      }
    }
  });
  EXPECT_THAT(wrong, Each(0));
  EXPECT_THAT(expected, Contains(testing::Ne(expected[0])));
}

TEST(MachineFunctions, SayHowFarTheyCameBeforeTheTimeLimit) {
  Scene scene = read_scene(file);
  scene.disturbance = 3;
  scene.disturbance_frequency = 7.3;
  const OpenedMachine opened = machine(scene);
  EXPECT_EQ(ricochet_limit_seconds(0), 1);
  expect_reason("seconds 0: must be > 0");
  ASSERT_EQ(ricochet_limit_seconds(0.2), 0);
  const std::int64_t regimes = ricochet_regimes(opened.get(), 0.01, 18);
  if (regimes < 0) {
    expect_reason("the time limit of 0.2 s was reached");
  } else {
    EXPECT_EQ(ricochet_regime_end(opened.get(), regimes - 1), std::string("time-limit"));
    EXPECT_LT(ricochet_reached(), 18);
  }
  std::thread([] { EXPECT_TRUE(std::isnan(ricochet_reached())) << "of another"; }).join();
  const OpenedMachine usual = machine();
  ASSERT_EQ(ricochet_limit_seconds(INFINITY), 0);
  EXPECT_GT(ricochet_regimes(usual.get(), 0.01, 18), 0);
  EXPECT_TRUE(std::isnan(ricochet_reached()));
  ricochet_limit_seconds(60);
}

/// One that all share, by its own functions and by those of the library, asked for in parts, and
/// one that each thread opens.
TEST(Interface, SharesAProblemAmongThreads) {
  const auto opened = [] { return open("top-speed-C1", "surrogate", 0, 1'000'000); };
  const Opened shared = opened();
  constexpr std::size_t threads_at_once = 4, points = 4000;
  std::latch begin(threads_at_once);
  const auto asked = [](const Opened& problem, std::size_t k) {
    const double x = 0.5 + 17.0 * static_cast<double>(k) / points;
    std::array<double, 6> told{};
    ricochet_values(problem.get(), &x, &told[0], nullptr);
    problem->values(problem.get(), &x, nullptr, &told[1]);
    problem->derivatives(problem.get(), &x, nullptr, nullptr, &told[2], &told[3]);
    ricochet_judge(problem.get(), &x, &told[4], &told[5]);
    return told;
  };
  std::vector<std::array<double, 6>> expected, found(points);
  for (std::size_t k = 0; k < points; ++k) expected.push_back(asked(shared, k));
  in_threads(threads_at_once, [&](std::size_t first) {
    begin.arrive_and_wait();
    for (std::size_t k = first; k < points; k += threads_at_once) {
      found[k] = k % 5 == 0 ? asked(opened(), k) : asked(shared, k);
    }
  });
  EXPECT_EQ(found, expected);
}

TEST(Interface, SaysEachThreadWhyItsCallWasRefused) {
  const Opened problem = open("hs-71", "", 0, 100);
  std::atomic<int> answered = 0, told = 0;
  in_threads(4, [&](std::size_t) {
    for (int k = 0; k < 100; ++k) {
      const bool refused = std::isnan(objective_at(problem, {1, 1, 1, 1}));
      const std::string why = ricochet_error();
      ++(refused ? told : answered);
      EXPECT_EQ(why.find("100 evaluations is spent") != std::string::npos, refused);
    }
  });
  EXPECT_EQ(answered, 100);
  EXPECT_EQ(told, 300);
}

/// What is closed stays until its last call has returned.
TEST(Interface, ClosesAProblemThatAnotherThreadUses) {
  for (int repeat = 0; repeat < 20; ++repeat) {
    ricochet_problem* const problem = ricochet_open("count-C4", "surrogate", 0, 1000, 0);
    std::thread user([problem] {
      const double x = 5;
      double objective = 0;
      while (ricochet_values(problem, &x, &objective, nullptr) == 0) {
      }
    });
    ricochet_close(problem);
    user.join();
  }
}

/// What a pattern's group finds in a text.
std::set<std::string> found_in(const std::string& text, const char* pattern) {
  const std::regex wanted(pattern);
  return {std::sregex_token_iterator(text.begin(), text.end(), wanted, 1), {}};
}

std::string printed_by(const std::string& command) {
  FILE* const pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error(command);
  std::string text;
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

TEST(Interface, ExportsTheFunctionsThatItsHeaderDeclares) {
  auto declared = found_in(text_of(fs::path(RICOCHET_SOURCE "/include/ricochet/ricochet.h")),
                           R"((?:^|\n)[a-z][a-z0-9_ ]*[ *]+(ricochet_[a-z_]+)\()");
  EXPECT_EQ(declared.erase("ricochet_evaluate"), 1U) << "a user's library exports it";
  EXPECT_THAT(declared, IsSupersetOf({"ricochet_open", "ricochet_values", "ricochet_counts"}));
  EXPECT_EQ(
      found_in(printed_by("nm --dynamic --defined-only --format=just-symbols " RICOCHET_LIBRARY),
               "(.+)\n"),
      declared);
  EXPECT_EQ(
      printed_by("nm --dynamic --defined-only --format=just-symbols " RICOCHET_MINIMISE_LIBRARY),
      "ricochet_minimise\n");
}

/// So that it runs where these are not: from a wheel of Python.
TEST(Interface, NeedsNoOtherLibraryThanTbbAndThoseOfTheCompiler) {
  const auto needed = found_in(printed_by("readelf --dynamic --wide " RICOCHET_LIBRARY),
                               R"(\(NEEDED\) +Shared library: \[([^\]]+)\])");
  const std::set<std::string> allowed = {"libtbb.so.12",  "libstdc++.so.6", "libm.so.6",
                                         "libgcc_s.so.1", "libc.so.6",      "ld-linux-x86-64.so.2"};
  EXPECT_THAT(needed, Contains("libc.so.6"));
  EXPECT_THAT(allowed, IsSupersetOf(needed));
}

/// So that a program that was built with one version of the header runs with another, unless
/// RICOCHET_ABI says that it cannot.
TEST(Interface, KeepsTheLayoutOfItsStructures) {
  EXPECT_EQ(ricochet_abi(), RICOCHET_ABI);
  static_assert(RICOCHET_ABI == 3, "a new layout: write down its offsets here");
  if (sizeof(void*) != 8) GTEST_SKIP() << "the offsets are those of 64 bits";
  using P = ricochet_problem;
  EXPECT_THAT((std::vector{
                  offsetof(P, abi), offsetof(P, dimension), offsetof(P, constraints),
                  offsetof(P, equalities), offsetof(P, has_derivatives), offsetof(P, has_residuals),
                  offsetof(P, name), offsetof(P, lower), offsetof(P, upper), offsetof(P, start),
                  offsetof(P, values), offsetof(P, derivatives), offsetof(P, residual_count),
                  offsetof(P, residuals), offsetof(P, remaining), offsetof(P, uniform), sizeof(P)}),
              ElementsAre(0, 4, 8, 12, 16, 20, 24, 32, 40, 48, 56, 64, 72, 80, 88, 96, 104));
  using S = ricochet_solver;
  EXPECT_THAT((std::vector{offsetof(S, abi), offsetof(S, name), offsetof(S, version),
                           offsetof(S, takes_constraints), offsetof(S, needs_derivatives),
                           offsetof(S, needs_residuals), offsetof(S, stochastic),
                           offsetof(S, solve), sizeof(S)}),
              ElementsAre(0, 8, 16, 24, 28, 32, 36, 40, 48));
  using V = ricochet_values_at;
  EXPECT_THAT(
      (std::vector{offsetof(V, abi), offsetof(V, dimension), offsetof(V, constraints),
                   offsetof(V, residuals), offsetof(V, objective), offsetof(V, constraint_values),
                   offsetof(V, gradient), offsetof(V, jacobian), offsetof(V, residual_values),
                   offsetof(V, residual_jacobian), sizeof(V)}),
      ElementsAre(0, 4, 8, 12, 16, 24, 32, 40, 48, 56, 64));
}

}  // namespace
}  // namespace ricochet::interface
