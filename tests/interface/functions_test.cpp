// The functions of libricochet.so: those that do what the pointers of a ricochet_problem do, and
// those of a machine, against the C++ library that they are made of.

#include "ricochet/machine.h"
#include "ricochet/problem.h"
#include "src/core/instance.h"
#include "tests/interface/opened.h"
#include "tests/support/test.h"

namespace ricochet::interface {
namespace {

using testing::Each;
using testing::HasSubstr;
using namespace carrier_track;

using Numbers = std::vector<double>;

constexpr const char* least_squares = "least-squares-01-linear-full-rank-9x45";

/// Somewhere in the box: `share` of the way along every edge.
Numbers point(const ricochet_problem* problem, double share) {
  Numbers x;
  for (int i = 0; i < problem->dimension; ++i) {
    x.push_back(problem->lower[i] + share * (problem->upper[i] - problem->lower[i]));
  }
  return x;
}

TEST(ProblemFunctions, SayWhatTheStructureSays) {
  for (const char* const name : {"hs-71", "top-speed-C1", least_squares}) {
    SCOPED_TRACE(name);
    const Opened opened = open(name, "", 2);
    ASSERT_TRUE(opened) << ricochet_error();
    const ricochet_problem* const p = opened.get();
    EXPECT_STREQ(ricochet_name(p), name);
    EXPECT_EQ(std::tuple(ricochet_dimension(p), ricochet_constraints(p), ricochet_equalities(p),
                         ricochet_has_derivatives(p), ricochet_has_residuals(p)),
              std::tuple(p->dimension, p->constraints, p->equalities, p->has_derivatives,
                         p->has_residuals));
    const auto size = static_cast<std::size_t>(p->dimension);
    Numbers lower(size), upper(size), start(size);
    EXPECT_EQ(ricochet_bounds(p, lower.data(), upper.data()), 0);
    EXPECT_EQ(ricochet_start(p, start.data()), 0);
    EXPECT_EQ(lower, Numbers(p->lower, p->lower + size));
    EXPECT_EQ(upper, Numbers(p->upper, p->upper + size));
    EXPECT_EQ(start, Numbers(p->start, p->start + size));
    EXPECT_EQ(ricochet_bounds(p, nullptr, nullptr), 0);
  }
}

TEST(ProblemFunctions, SayWhatTheProblemSays) {
  const Problem problem = instance(problem_named("top-speed-C1"), 3);
  const Opened opened = open("top-speed-C1", "", 3);
  EXPECT_EQ(ricochet_best_known(opened.get()), problem.best_known.value());
  EXPECT_EQ(ricochet_tolerance(opened.get()), problem.tolerance);
  EXPECT_EQ(ricochet_unit(opened.get()), problem.unit);
  EXPECT_EQ(problem.unit, "rad/s");
  EXPECT_EQ(ricochet_variable_name(opened.get(), 0), problem.variables.at(0).name);
  EXPECT_EQ(ricochet_variable_unit(opened.get(), 0), problem.variables.at(0).unit);
  EXPECT_EQ(ricochet_variable_name(opened.get(), 1), nullptr);
  EXPECT_STREQ(ricochet_error(), "variable 1: must be from 0 to 0");
  EXPECT_STREQ(ricochet_variable_name(open("hs-71").get(), 3), "");
}

TEST(ProblemFunctions, TellWhatThePointersTell) {
  for (const auto& [name, formulation] :
       {std::pair("hs-71", "original"), {"top-speed-C1", "surrogate"}}) {
    SCOPED_TRACE(name);
    const Opened one = open(name, formulation), other = open(name, formulation);
    const auto n = static_cast<std::size_t>(one->dimension);
    const auto m = static_cast<std::size_t>(one->constraints);
    Numbers f(1), c(m), g(n), j(m * n), f2(1), c2(m), g2(n), j2(m * n);
    for (const double share : {0.2, 0.7}) {
      const Numbers x = point(one.get(), share);
      ASSERT_EQ(ricochet_values(one.get(), x.data(), f.data(), c.data()), 0);
      ASSERT_EQ(other->values(other.get(), x.data(), f2.data(), c2.data()), 0);
      EXPECT_EQ(std::tie(f, c), std::tie(f2, c2));
      const int refused =
          ricochet_derivatives(one.get(), x.data(), f.data(), c.data(), g.data(), j.data());
      EXPECT_EQ(
          other->derivatives(other.get(), x.data(), f2.data(), c2.data(), g2.data(), j2.data()),
          refused);
      EXPECT_EQ(std::tie(g, j), std::tie(g2, j2));
      EXPECT_EQ(ricochet_remaining(one.get()), other->remaining(other.get()));
    }
    EXPECT_EQ(ricochet_uniform(one.get()), other->uniform(other.get()));
  }
}

TEST(ProblemFunctions, TellResiduals) {
  const Opened one = open(least_squares), other = open(least_squares);
  const Numbers x = point(one.get(), 0.4);
  ASSERT_EQ(ricochet_residual_count(one.get(), x.data()), 45);
  Numbers told(45), expected(45), rows(45 * 9), expected_rows(45 * 9);
  ASSERT_EQ(ricochet_residuals(one.get(), x.data(), told.data(), rows.data()), 0);
  ASSERT_EQ(other->residuals(other.get(), x.data(), expected.data(), expected_rows.data()), 0);
  EXPECT_EQ(told, expected);
  EXPECT_EQ(rows, expected_rows);
}

TEST(ProblemFunctions, TellABatchAsPointByPoint) {
  const Opened one = open("hs-71", "", 0, 5), other = open("hs-71");
  Numbers points, expected_objectives, expected_constraints(6, -1);
  for (int k = 0; k < 7; ++k) {
    const Numbers x = point(one.get(), k / 8.0);
    points.insert(points.end(), x.begin(), x.end());
    std::array<double, 3> told = {-1, -1, -1};  // beyond the budget nothing is written
    const bool written = k < 5 && other->values(other.get(), x.data(), &told[0], &told[1]) == 0;
    EXPECT_EQ(written, k < 5);
    expected_objectives.push_back(told[0]);
    if (k >= 3) expected_constraints.insert(expected_constraints.end(), {told[1], told[2]});
  }
  Numbers objectives(7, -1), constraints(14, -1);
  EXPECT_EQ(ricochet_values_batch(one.get(), points.data(), 3, objectives.data(), nullptr), 3);
  EXPECT_EQ(ricochet_remaining(one.get()), 2);
  EXPECT_EQ(ricochet_values_batch(one.get(), points.data() + 12, 4, objectives.data() + 3,
                                  constraints.data() + 6),
            2)
      << "as far as the budget goes";
  EXPECT_STREQ(ricochet_error(), "the run is over: its budget of 5 evaluations is spent");
  EXPECT_EQ(objectives, expected_objectives);
  EXPECT_EQ(constraints, expected_constraints);
  EXPECT_EQ(ricochet_values_batch(other.get(), nullptr, 0, nullptr, nullptr), 0);
  EXPECT_EQ(ricochet_values_batch(other.get(), points.data(), -1, nullptr, nullptr), 0);
  EXPECT_EQ(ricochet_values_batch(other.get(), nullptr, 2, nullptr, nullptr), 0);
  EXPECT_STREQ(ricochet_error(), "the point asked for is NULL");
}

TEST(ProblemFunctions, RefuseWhatIsNotOpen) {
  ricochet_problem* const closed = ricochet_open("hs-71", "", 0, 1, 0);
  ricochet_close(closed);
  double x[4] = {1, 1, 1, 1}, told = 0;
  for (ricochet_problem* const p : {closed, static_cast<ricochet_problem*>(nullptr)}) {
    EXPECT_THAT((std::vector<std::int64_t>{ricochet_dimension(p), ricochet_constraints(p),
                                           ricochet_equalities(p), ricochet_has_derivatives(p),
                                           ricochet_has_residuals(p), ricochet_remaining(p)}),
                Each(-1));
    EXPECT_THAT((Numbers{ricochet_best_known(p), ricochet_tolerance(p), ricochet_uniform(p)}),
                Each(testing::IsNan()));
    EXPECT_EQ(ricochet_name(p), nullptr);
    EXPECT_THAT((std::vector{ricochet_bounds(p, x, x), ricochet_start(p, x),
                             ricochet_values(p, x, &told, nullptr),
                             ricochet_derivatives(p, x, &told, nullptr, nullptr, nullptr),
                             ricochet_residuals(p, x, &told, nullptr)}),
                Each(1));
    EXPECT_EQ(ricochet_values_batch(p, x, 1, &told, nullptr), 0);
    EXPECT_EQ(ricochet_residual_count(p, x), 0);
    EXPECT_STREQ(ricochet_error(), "the problem is not open");
  }
  EXPECT_THAT(x, Each(1.0));
}

const std::string file = RICOCHET_SOURCE "/examples/machine.toml";
constexpr double none = NAN;

OpenedMachine machine() {
  OpenedMachine opened(ricochet_open_machine(file.c_str()));
  EXPECT_TRUE(opened) << ricochet_error();
  return opened;
}

OpenedMachine parsed(const std::string& text) {
  OpenedMachine opened(ricochet_parse_machine(text.c_str()));
  EXPECT_TRUE(opened) << ricochet_error();
  return opened;
}

TEST(MachineFunctions, CountAsTheLibraryDoes) {
  const OpenedMachine opened = machine();
  Numbers speeds;
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
  Numbers times(expected.impacts.size()), speeds(times);
  std::vector<std::int32_t> walls(times.size());
  ricochet_impacts(opened.get(), times.data(), speeds.data(), walls.data());
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_THAT(expected.impacts[k],
                testing::FieldsAre(times[k], walls[k] == 1 ? Wall::upper : Wall::lower, speeds[k]));
  }
  Numbers t(expected.path.size()), x(t), v(t);
  ASSERT_EQ(ricochet_path(opened.get(), t.data(), x.data(), v.data()),
            static_cast<std::int64_t>(t.size()));
  ASSERT_GT(t.size(), 500U);
  for (std::size_t k = 0; k < t.size(); ++k) {
    const auto& at = expected.path[k];
    EXPECT_EQ(std::tie(t[k], x[k], v[k]), std::tie(at.time, at.position, at.velocity));
  }
}

TEST(MachineFunctions, SimulateAtTheSpeedOfTheFile) {
  Scene scene = read_scene(file);
  scene.omega = 6.5;
  const OpenedMachine constant = parsed(write_scene(scene));
  EXPECT_EQ(ricochet_machine_speed(constant.get()), 6.5);
  std::int32_t count = -1;
  ASSERT_EQ(ricochet_simulate(constant.get(), none, 0, &count, nullptr), 0);
  EXPECT_EQ(count, simulate(scene).count);
  EXPECT_EQ(ricochet_path(constant.get(), nullptr, nullptr, nullptr), 0);

  scene.profile = {{0, 5.0}, {4, 8.0}};
  const OpenedMachine profile = parsed(write_scene(scene));
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
  const OpenedMachine opened = parsed(write_scene(scene));
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
  expect_reason("measure noise: must be collisions, ");
}

TEST(MachineFunctions, RefuseWhatIsNoMachine) {
  const auto of_text = [](const char* text) { return OpenedMachine(ricochet_parse_machine(text)); };
  expect_refusal(OpenedMachine(ricochet_open_machine("none.toml")), "none.toml: there is no");
  expect_refusal(OpenedMachine(ricochet_open_machine(nullptr)), "the machine file has no name");
  expect_refusal(of_text(nullptr), "the text of the machine is NULL");
  expect_refusal(of_text("[scene"), "text:1: not valid TOML");
  expect_refusal(of_text("[scene]\nmas = 1\n[window]\nseconds = 1"), "mas");
}

TEST(MachineFunctions, RefuseInTheWordsOfTheLibrary) {
  const OpenedMachine opened = machine();
  const double speeds[] = {5, -1};
  std::int32_t found[] = {42, 42};
  const auto expect_refused = [](bool refused, const char* reason) {
    EXPECT_TRUE(refused) << reason;
    expect_reason(reason);
  };
  expect_refused(ricochet_counts(opened.get(), speeds, 2, found) == 1,
                 "speed = -1: must be a finite number > 0");
  EXPECT_EQ(found[0], 42);
  expect_refused(ricochet_counts(opened.get(), speeds, -1, found) == 1, "-1 speeds: must be >= 0");
  expect_refused(ricochet_counts(opened.get(), nullptr, 2, found) == 1, "NULL");
  expect_refused(ricochet_simulate(opened.get(), -1, 0, nullptr, nullptr) == 1,
                 "omega = -1: must be");
  expect_refused(ricochet_simulate(opened.get(), 5, -1, nullptr, nullptr) == 1,
                 "samples -1: must be >= 0");
  expect_refused(ricochet_regimes(opened.get(), 5, 4) == -1, "speeds 5 to 4: must rise");
  expect_refused(
      ricochet_quiet_speed(opened.get(), nullptr, none, -1, nullptr, nullptr, nullptr) == 1,
      "fastest = -1: must be within");
}

TEST(MachineFunctions, KnowWhichMachinesAreOpen) {
  ricochet_machine* const closed = ricochet_open_machine(file.c_str());
  EXPECT_THAT(ricochet_machine_text(closed), HasSubstr("[scene]"));
  ricochet_close_machine(closed);
  for (ricochet_machine* const m : {closed, static_cast<ricochet_machine*>(nullptr)}) {
    EXPECT_EQ(ricochet_machine_text(m), nullptr);
    EXPECT_EQ(ricochet_doubt(m), nullptr);
    EXPECT_TRUE(std::isnan(ricochet_machine_speed(m)));
    EXPECT_EQ(ricochet_counts(m, nullptr, 0, nullptr), 1);
    EXPECT_EQ(ricochet_simulate(m, 5, 0, nullptr, nullptr), 1);
    EXPECT_EQ(ricochet_quiet_speed(m, nullptr, none, none, nullptr, nullptr, nullptr), 1);
    EXPECT_EQ(ricochet_impacts(m, nullptr, nullptr, nullptr), -1);
    EXPECT_EQ(ricochet_path(m, nullptr, nullptr, nullptr), -1);
    EXPECT_EQ(ricochet_regimes(m, 1, 2), -1);
    EXPECT_EQ(ricochet_regime_table(m, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
                                    nullptr, nullptr),
              -1);
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
  EXPECT_THAT(expected, testing::Contains(testing::Ne(expected[0])));
}

TEST(MachineFunctions, SayHowFarTheyCameBeforeTheTimeLimit) {
  Scene scene = read_scene(file);
  scene.disturbance = 3;
  scene.disturbance_frequency = 7.3;
  const OpenedMachine opened = parsed(write_scene(scene));
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
  in_threads(
      1, [](std::size_t) { EXPECT_TRUE(std::isnan(ricochet_reached())) << "of another thread"; });
  const OpenedMachine usual = machine();
  ASSERT_EQ(ricochet_limit_seconds(INFINITY), 0);
  EXPECT_GT(ricochet_regimes(usual.get(), 0.01, 18), 0);
  EXPECT_TRUE(std::isnan(ricochet_reached()));
  ricochet_limit_seconds(60);
}

TEST(MachineFunctions, TellNoQuietSpeedWhereEverySpeedIsLoud) {
  Scene scene = read_scene(file);
  scene.friction = 0;
  scene.counting_limit = 1e-6;
  const OpenedMachine opened = parsed(write_scene(scene));
  double quiet = 0, loud = 0;
  ASSERT_EQ(ricochet_quiet_speed(opened.get(), nullptr, none, 5, &quiet, &loud, nullptr), 0)
      << ricochet_error();
  EXPECT_TRUE(std::isnan(quiet)) << quiet;
  EXPECT_EQ(loud, 0.01);
}

}  // namespace
}  // namespace ricochet::interface
