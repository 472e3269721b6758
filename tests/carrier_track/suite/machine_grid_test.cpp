#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/hard_machines.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"
#include "ricochet/run.h"
#include "tests/support/files.h"
#include "tests/support/refusals.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

const SearchedProblem& found(const std::vector<SearchedProblem>& problems,
                             const std::string& name) {
  for (const SearchedProblem& each : problems) {
    if (each.problem.name == name) return each;
  }
  throw std::out_of_range(name);
}

std::set<std::string> machines_of(const std::vector<SearchedProblem>& problems) {
  std::set<std::string> machines;
  for (const SearchedProblem& each : problems) machines.insert(each.problem.machine);
  return machines;
}

/// All of one grid in one test: to scan for best values takes a second or two.
TEST(MachineGrid, AsksOfEveryCombinationWhatItSays) {
  const auto problems =
      grid_problems("C4", {{"restitution", {0.25, 0.75}}, {"disturbance", {0.5}}});
  const double friction = find_case("C4").friction;
  const std::string id = fmt::format("C4-r0.75-f{}-d0.5", friction);
  EXPECT_EQ(machines_of(problems), (std::set{id, fmt::format("C4-r0.25-f{}-d0.5", friction)}));
  for (const SearchedProblem& problem : problems) {
    EXPECT_FALSE(problem.problem.best_known) << problem.problem.name;
    EXPECT_TRUE(problem.problem.name.starts_with(problem.family));
  }
  const std::map<std::string, double> factors{
      {"restitution", 0.75}, {"friction", friction}, {"disturbance", 0.5}};
  EXPECT_EQ(found(problems, "count-" + id).problem.factors, factors);
  const Scene scene = scene_of({"mine", 0.75, friction, 0.5, {}}, default_machine());
  const Problem same = count_problem(machine_of(scene, "mine"));
  for (const std::string family : {"count-", "top-speed-"}) {
    const SearchedProblem& asked = found(problems, family + id);
    const Findings findings = asked.search();
    EXPECT_EQ(findings.at("quiet_limit"), machine_of(scene, "mine").quiet_limit);
    const Problem problem = asked.with(findings);
    ASSERT_TRUE(problem.best_known);
    EXPECT_EQ(problem.best_point, Vector::Constant(1, findings.at("best_point")));
    for (double speed = 0.015; speed < 18; speed += 0.013) {
      const Vector x = Vector::Constant(1, speed);
      const Values values = problem.evaluate(x);
      if (family == "count-") {
        EXPECT_EQ(values.objective, same.evaluate(x).objective);
      }
      if (values.constraints.size() == 0 || values.constraints.maxCoeff() <= 0) {
        EXPECT_GE(values.objective, *problem.best_known - problem.tolerance) << speed;
      }
    }
  }
}

TEST(MachineGrid, SimulatesAtTheLevelThatItNames) {
  const auto problems = grid_problems("C1", {{"fidelity", {"planar", "impact"}}});
  const auto without_level = grid_problems("C1", {});
  const Problem& planar = found(problems, "count-C1-r0.1-f0.1-d0-planar").problem;
  const Problem& impact = found(problems, "count-C1-r0.1-f0.1-d0-impact").problem;
  const Problem& same = found(without_level, "count-C1-r0.1-f0.1-d0").problem;
  EXPECT_EQ(planar.factors.at("fidelity"), 2);
  EXPECT_EQ(impact.factors.at("fidelity"), 0);
  EXPECT_FALSE(same.factors.contains("fidelity"));
  EXPECT_FALSE(planar.smoothed(0.1).differentiate);
  EXPECT_TRUE(impact.smoothed(0.1).differentiate);
  // Friction holds the carrier across its track, so that what the planar machine lacks is
  // contact_friction alone.
  const Scene without = with(case_scene("C1"), set::contact_friction(false));
  int differ = 0;
  for (double speed = 0.5; speed < 18; speed += 0.5) {
    const Vector x = Vector::Constant(1, speed);
    const double counted = impact.evaluate(x).objective;
    EXPECT_EQ(counted, same.evaluate(x).objective);
    EXPECT_EQ(planar.evaluate(x).objective, count_at(without, speed)) << speed;
    differ += planar.evaluate(x).objective == counted ? 0 : 1;
  }
  EXPECT_GT(differ, 0);
}

/// A machine of the user's with two walls unlike each other.
std::string own() {
  return write_scene(with(case_scene("C4"), set::restitution_upper(0.3)));
}

TEST(MachineGrid, IsAroundAMachineOfTheUsersOwn) {
  const auto alone = grid_problems("mine", {}, own());
  const SearchedProblem& count = found(alone, "count-mine");
  EXPECT_EQ(count.problem.machine, "mine");
  const Problem same = count_problem(machine_of(parse_scene(own(), "own"), "own"));
  for (double speed = 0.5; speed < 18; speed += 0.5) {
    const Vector x = Vector::Constant(1, speed);
    EXPECT_EQ(count.problem.evaluate(x).objective, same.evaluate(x).objective);
  }
  const auto grid =
      grid_problems("mine", {{"restitution", {0.2, 0.4}}, {"fidelity", {"impact"}}}, own());
  for (const SearchedProblem& each : grid)
    EXPECT_EQ(each.problem.factors.at("friction"), find_case("C4").friction);
  EXPECT_THAT(machines_of(grid), ElementsAre("mine-r0.2-impact", "mine-r0.4-impact"));
}

TEST(MachineGrid, RefusesAMachineThatIsNone) {
  std::string profile = own();
  profile.replace(profile.find("omega = 3.0"), 11, "omega = [[0.0, 1.0], [1.0, 3.0]]");
  EXPECT_THROW(grid_problems("C1", {}, own()), InputError);
  EXPECT_THROW(grid_problems("mine", {}, "[scene]\nmass = 1\n"), InputError);
  EXPECT_THROW(grid_problems("mine", {}, profile), InputError);
  EXPECT_THROW(grid_problems("C99", {}), InputError);
  EXPECT_THROW(grid_problems("C1", {{"restitution", {1.5}}}), InputError);
  EXPECT_THROW(grid_problems("C1", {{"friction", {-0.5}}}), InputError);
}

TEST(MachineGrid, HasEveryKeyAndTextThatItDeclares) {
  for (const auto& [key, texts] : machine_keys()) {
    const std::vector<OptionValue> levels =
        texts.empty() ? std::vector<OptionValue>{0.25, 0.5}
                      : std::vector<OptionValue>(texts.begin(), texts.end());
    EXPECT_EQ(machines_of(grid_problems("C1", {{key, levels}})).size(), levels.size()) << key;
  }
}

TEST(HardMachines, AreReadAsTheyWereWritten) {
  EXPECT_EQ(write_hard_machines(found_hard_machines()),
            text_of(fs::path(RICOCHET_SOURCE) / "problems/carrier_track/suite/hard_machines.toml"));
}

TEST(HardMachines, RefuseWhatIsNoSuchText) {
  const Scene& constants = found_hard_machines().constants;
  const std::string empty = write_hard_machines({constants, {}});
  EXPECT_TRUE(parse_hard_machines(empty, "text").machines.empty());
  std::string negative = write_hard_machines({constants, {hard_machines()[0]}});
  negative.replace(negative.rfind("\nmass = "), 8, "\nmass = -");
  for (const std::string& text :
       {empty + "01 = 3", empty + "[01]\naround = \"C1\"", empty + "[01]\naround = 1",
        std::string("# no constants"), negative}) {
    EXPECT_THROW(parse_hard_machines(text, "text"), InputError) << text;
  }
}

TEST(HardMachines, AreFifteenTheHardestFirstNoMoreThanFiveAroundACase) {
  EXPECT_EQ(hard_machines().size(), 15U);
  EXPECT_TRUE(std::ranges::is_sorted(hard_machines(), {}, quiet_interval_share));
  std::map<std::string, int> around;
  for (const HardMachine& hard : hard_machines()) {
    EXPECT_LE(++around[hard.around], 5);
    EXPECT_NEAR(quiet_interval_share(hard), 5.5e-3, 4.5e-3);
    EXPECT_GE(hard.hardness.quiet_intervals, 2);
    EXPECT_GT(hard.hardness.bisection_gap, speed_tolerance);
  }
}

TEST(HardMachines, AskForASpeedWhoseCountAndThoseNextToItAreCertain) {
  for (const HardMachine& hard : hard_machines()) {
    const double best = hard.best.point[0];
    for (const double off : {-1e-4, 0.0, 1e-4}) {
      const Recording recording = record(at_speed(hard.machine.scene, best + off), 0.25, 0);
      EXPECT_TRUE(recording.certainty.certain) << hard.machine.id << ' ' << off;
      EXPECT_EQ(recording.count <= hard.machine.quiet_limit, off <= 0) << hard.machine.id;
    }
  }
}

TEST(HardMachines, AreAskedInEveryFormulationOfATopSpeed) {
  const Family family = hard_family();
  ASSERT_EQ(family.problems.size(), hard_machines().size());
  EXPECT_EQ(family.problems[0].name, "hard-top-speed-01");
  EXPECT_EQ(family.problems[0].machine, "hard-01");
  for (const Problem& problem : family.problems) {
    EXPECT_EQ(problem.formulations().size(), 4U) << problem.name;
    EXPECT_EQ(true_values_at(problem, *problem.best_point).objective, problem.best_known);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
