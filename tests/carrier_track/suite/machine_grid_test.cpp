#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/error.h"

namespace ricochet::carrier_track {
namespace {

const SearchedProblem* found(const std::vector<SearchedProblem>& problems,
                             const std::string& name) {
  for (const SearchedProblem& problem : problems) {
    if (problem.problem.name == name) return &problem;
  }
  return nullptr;
}

/// All of one grid in one test: to scan for best values takes a second or two.
TEST(MachineGrid, AsksOfEveryCombinationWhatItSays) {
  const auto problems =
      grid_problems("C4", {{"restitution", {0.25, 0.75}}, {"disturbance", {0.5}}});
  const double friction = find_case("C4").friction;
  const std::string id = fmt::format("C4-r0.75-f{}-d0.5", friction);
  std::set<std::string> machines;
  for (const SearchedProblem& problem : problems) {
    machines.insert(problem.problem.machine);
    EXPECT_FALSE(problem.problem.best_known) << problem.problem.name;
    EXPECT_TRUE(problem.problem.name.starts_with(problem.family));
  }
  EXPECT_EQ(machines, (std::set{id, fmt::format("C4-r0.25-f{}-d0.5", friction)}));

  const SearchedProblem* count = found(problems, "count-" + id);
  const SearchedProblem* top_speed = found(problems, "top-speed-" + id);
  ASSERT_NE(count, nullptr);
  ASSERT_NE(top_speed, nullptr);
  EXPECT_EQ(count->problem.factors.at("restitution"), 0.75);
  EXPECT_EQ(count->problem.factors.at("friction"), friction);
  EXPECT_EQ(count->problem.factors.at("disturbance"), 0.5);
  const Scene scene = scene_of({"mine", 0.75, friction, 0.5, {}}, default_machine());
  const Problem same = count_problem(machine_of(scene, "mine"));
  for (const SearchedProblem* asked : {count, top_speed}) {
    const Findings findings = asked->search();
    EXPECT_EQ(findings.at("quiet_limit"), machine_of(scene, "mine").quiet_limit);
    const Problem scanned = asked->with(findings);
    const Problem* problem = &scanned;
    ASSERT_TRUE(problem->best_known);
    EXPECT_EQ(problem->best_point, Vector::Constant(1, findings.at("best_point")));
    for (double speed = 0.015; speed < 18; speed += 0.013) {
      const Vector x = Vector::Constant(1, speed);
      const Values values = problem->evaluate(x);
      if (asked == count) {
        EXPECT_EQ(values.objective, same.evaluate(x).objective);
      }
      const bool feasible = values.constraints.size() == 0 || values.constraints.maxCoeff() <= 0;
      if (feasible) {
        EXPECT_GE(values.objective, *problem->best_known - problem->tolerance) << speed;
      }
    }
  }
}

TEST(MachineGrid, SimulatesAtTheLevelThatItNames) {
  const auto problems = grid_problems("C1", {{"fidelity", {"planar", "impact"}}});
  const auto problem = [](const std::vector<SearchedProblem>& all, const std::string& name) {
    const SearchedProblem* one = found(all, name);
    return one == nullptr ? nullptr : &one->problem;
  };
  const Problem* planar = problem(problems, "count-C1-r0.1-f0.1-d0-planar");
  const Problem* impact = problem(problems, "count-C1-r0.1-f0.1-d0-impact");
  ASSERT_NE(planar, nullptr);
  ASSERT_NE(impact, nullptr);
  EXPECT_EQ(planar->factors.at("fidelity"), 2);
  EXPECT_EQ(impact->factors.at("fidelity"), 0);
  EXPECT_FALSE(planar->smoothed(0.1).differentiate);
  EXPECT_TRUE(impact->smoothed(0.1).differentiate);
  const auto without_level = grid_problems("C1", {});
  const Problem* same = problem(without_level, "count-C1-r0.1-f0.1-d0");
  ASSERT_NE(same, nullptr);
  EXPECT_FALSE(same->factors.contains("fidelity"));
  // Friction holds the carrier across its track, so that what the planar machine lacks is
  // contact_friction alone.
  Scene without = scene_of(find_case("C1"), default_machine());
  without.contact_friction = false;
  int differ = 0;
  for (double speed = 0.5; speed < 18; speed += 0.5) {
    const Vector x = Vector::Constant(1, speed);
    const double counted = impact->evaluate(x).objective;
    EXPECT_EQ(counted, same->evaluate(x).objective);
    EXPECT_EQ(planar->evaluate(x).objective, count_at(without, speed)) << speed;
    differ += planar->evaluate(x).objective == counted ? 0 : 1;
  }
  EXPECT_GT(differ, 0);
}

/// A machine of the user's with two walls unlike each other.
std::string own() {
  Scene scene = scene_of(find_case("C4"), default_machine());
  scene.restitution_upper = 0.3;
  return write_scene(scene);
}

TEST(MachineGrid, IsAroundAMachineOfTheUsersOwn) {
  const auto alone = grid_problems("mine", {}, own());
  const SearchedProblem* count = found(alone, "count-mine");
  ASSERT_NE(count, nullptr);
  EXPECT_EQ(count->problem.machine, "mine");
  const Problem same = count_problem(machine_of(parse_scene(own(), "own"), "own"));
  for (double speed = 0.5; speed < 18; speed += 0.5) {
    const Vector x = Vector::Constant(1, speed);
    EXPECT_EQ(count->problem.evaluate(x).objective, same.evaluate(x).objective);
  }
  std::set<std::string> machines;
  for (const SearchedProblem& each :
       grid_problems("mine", {{"restitution", {0.2, 0.4}}, {"fidelity", {"impact"}}}, own())) {
    machines.insert(each.problem.machine);
    EXPECT_EQ(each.problem.factors.at("friction"), find_case("C4").friction);
  }
  EXPECT_EQ(machines, (std::set<std::string>{"mine-r0.2-impact", "mine-r0.4-impact"}));
}

TEST(MachineGrid, RefusesAMachineOfTheUsersThatIsNone) {
  EXPECT_THROW(grid_problems("C1", {}, own()), InputError);
  EXPECT_THROW(grid_problems("mine", {}, "[scene]\nmass = 1\n"), InputError);
  std::string profile = own();
  profile.replace(profile.find("omega = 3.0"), 11, "omega = [[0.0, 1.0], [1.0, 3.0]]");
  EXPECT_THROW(grid_problems("mine", {}, profile), InputError);
}

TEST(MachineGrid, RefusesACaseThatIsNoneAndAMachineThatIsNone) {
  EXPECT_THROW(grid_problems("C99", {}), InputError);
  EXPECT_THROW(grid_problems("C1", {{"restitution", {1.5}}}), InputError);
  EXPECT_THROW(grid_problems("C1", {{"friction", {-0.5}}}), InputError);
}

TEST(MachineGrid, HasEveryKeyAndTextThatItDeclares) {
  for (const auto& [key, texts] : machine_keys()) {
    const std::vector<OptionValue> levels =
        texts.empty() ? std::vector<OptionValue>{0.25, 0.5}
                      : std::vector<OptionValue>(texts.begin(), texts.end());
    std::set<std::string> machines;
    for (const SearchedProblem& each : grid_problems("C1", {{key, levels}})) {
      machines.insert(each.problem.machine);
    }
    EXPECT_EQ(machines.size(), levels.size()) << key;
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
