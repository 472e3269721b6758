#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"
#include "ricochet/run.h"
#include "src/core/instance.h"
#include "src/studies/suite/suite.h"
#include "tests/support/scenes.h"

namespace ricochet {
namespace {

const std::vector<Family>& families() {
  static const std::vector<Family> all = suite_families();
  return all;
}

TEST(Families, HaveDistinctNamesAndSoDoTheirProblems) {
  std::set<std::string> names, problems;
  for (const Family& family : families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    for (const Problem& problem : family.problems) {
      EXPECT_TRUE(problems.insert(problem.name).second) << problem.name;
      EXPECT_EQ(problem.name.rfind(family.name + "-", 0), 0U) << problem.name;
    }
  }
  EXPECT_EQ(names.size(), 14U);
  // Count, top speed, six sizes of two profiles, design and three risks; two large sizes of two
  // machines; and the calibration. Then the hard machines, what the literature has, and
  // bowls with defects.
  EXPECT_EQ(problems.size(), 12U * (1 + 1 + 2 * 6 + 1 + 3) + 2 * 2 + 1 + 15 + 27 + 116 + 53 + 9);
}

TEST(Families, HaveClustersOfProblemsThatAreAlike) {
  std::map<std::string, std::string> family_of;  // by cluster
  std::map<std::string, std::map<std::string, std::set<std::string>>> members;
  for (const Family& family : families()) {
    for (const Problem& problem : family.problems) {
      const std::string& cluster = problem.cluster.empty() ? problem.name : problem.cluster;
      EXPECT_EQ(family_of.try_emplace(cluster, family.name).first->second, family.name) << cluster;
      members[family.name][cluster].insert(problem.name);
    }
  }
  const std::map<std::string, std::size_t> clusters = {
      {"count", 8},        {"top-speed", 8},      {"profile-count", 8},
      {"profile-wear", 8}, {"robust-mean", 8},    {"hard-top-speed", 15},
      {"classic", 22},     {"least-squares", 22}, {"hs", 92}};
  for (const auto& [family, number] : clusters) EXPECT_EQ(members[family].size(), number) << family;
  const auto together = [&](const std::string& family, const std::set<std::string>& problems) {
    for (const auto& [cluster, names] : members[family]) {
      if (names == problems) return true;
    }
    return false;
  };
  EXPECT_TRUE(together("top-speed", {"top-speed-C1", "top-speed-C5"}));
  EXPECT_TRUE(together("top-speed", {"top-speed-C9"}))
      << "its disturbance is nearly as strong as friction";
  EXPECT_TRUE(together("hs", {"hs-88", "hs-89", "hs-90", "hs-91", "hs-92"}));
  EXPECT_TRUE(together("classic",
                       {"classic-rosenbrock-2", "classic-rosenbrock-5", "classic-rosenbrock-20"}));
  EXPECT_TRUE(together("classic", {"classic-branin"}));
}

TEST(Families, HaveProblemsThatHoldTogether) {
  for (const Family& family : families()) {
    for (const Problem& problem : family.problems) {
      const Problem& p = problem;
      ASSERT_EQ(p.upper.size(), p.dimension()) << p.name;
      ASSERT_EQ(p.start.size(), p.dimension()) << p.name;
      EXPECT_EQ((p.lower.array() < p.upper.array()).all(), p.name != "pathological-one-choice")
          << p.name;
      EXPECT_TRUE((p.start.array() >= p.lower.array()).all()) << p.name;
      EXPECT_TRUE((p.start.array() <= p.upper.array()).all()) << p.name;
      const auto n = static_cast<std::size_t>(p.dimension());
      EXPECT_TRUE(p.variables.empty() || p.variables.size() == n) << p.name;
      EXPECT_FALSE(p.source.empty()) << p.name;
      EXPECT_EQ(p.best_known.has_value(), p.best_point || p.name == "pathological-infeasible")
          << p.name;
      EXPECT_EQ(p.best_known.has_value(), !p.provenance.empty()) << p.name;
    }
  }
}

/// As measured: see profile.h.
TEST(Families, KnowWhatAGradientTakes) {
  std::map<std::string, std::int64_t> costs;
  for (const Family& family : families()) {
    for (const Problem& problem : family.problems) {
      ASSERT_TRUE(problem.gradient_cost) << problem.name;
      EXPECT_GE(*problem.gradient_cost, 1) << problem.name;
      costs[problem.name] = *problem.gradient_cost;
    }
  }
  EXPECT_EQ(costs.at("top-speed-C1"), 1);
  EXPECT_EQ(costs.at("robust-worst-C4"), 4);
  EXPECT_EQ(costs.at("calibration-default"), 3);
  EXPECT_EQ(costs.at("design-count-C9"), 3);
  EXPECT_EQ(costs.at("profile-count-16-C4"), 2);
  EXPECT_EQ(costs.at("profile-wear-32-C4"), 2);
  EXPECT_EQ(costs.at("profile-count-64-C1"), 2);
  EXPECT_EQ(costs.at("hs-1"), 1);
  EXPECT_EQ(costs.at("hs-110"), 5);
}

/// Formulations of one problem have one name, one true objective, one box and one best value.
TEST(Families, ShowOneTrueValuesInEveryFormulation) {
  for (const Family& family : families()) {
    for (const Problem* problem : {&family.problems.front(), &family.problems.back()}) {
      const Problem& stated = *problem;
      EXPECT_EQ(static_cast<bool>(stated.true_values), stated.hazardous) << stated.name;
      if (stated.smoothed) {  // to smoothing parameter 0 it is what is judged
        const Values exact =
            problem->formulated({problem->smoothing}).smoothed(0).evaluate(stated.start);
        EXPECT_EQ(exact.objective, stated.evaluate(stated.start).objective) << stated.name;
        EXPECT_EQ(exact.constraints, stated.evaluate(stated.start).constraints) << stated.name;
      }
      for (const Formulation& formulation : problem->formulations()) {
        const Problem shown = problem->formulated(formulation);
        EXPECT_EQ(shown.name, stated.name);
        EXPECT_EQ(shown.start, stated.start);
        EXPECT_EQ(shown.best_known, stated.best_known);
        const TrueValues true_values = true_values_at(shown, shown.start);
        const TrueValues expected = true_values_at(stated, stated.start);
        EXPECT_EQ(true_values.objective, expected.objective) << shown.name;
        EXPECT_EQ(true_values.violation, expected.violation) << shown.name;
      }
    }
  }
}

/// What a solver of penalised problems converges to must be the answer.
TEST(Families, KeepTheBestPointBestWhereConstraintsArePenalised) {
  int looked = 0;
  for (const Family& family : families()) {
    if (family.name.starts_with("robust-")) continue;  // 32 simulations each
    for (const Problem& problem : family.problems) {
      if (problem.constraints == 0 || problem.hazardous) continue;
      if (problem.name == "hs-13") continue;  // no weight is enough: see there
      const Problem penalised = problem.formulated({0, true});
      const Vector& best = problem.best_point.value();
      const double value = penalised.evaluate(best).objective;
      Random random(seed_of(penalised.name, "near", 0, 0));
      for (int k = 0; k < 200; ++k) {
        const Vector off = uniform_point(penalised, random) - best;
        const Vector near = best + off * std::pow(10.0, -(k % 5));
        EXPECT_GE(penalised.evaluate(near).objective, value - problem.tolerance)
            << penalised.name << ' ' << near.transpose();
      }
      ++looked;
    }
  }
  EXPECT_GT(looked, 24 + 100);
}

TEST(Families, OfAMachineOfOnesOwnKnowNoBestValues) {
  using namespace carrier_track;
  Machine machine = machine_of(find_case("C1"), exploratory_scene());
  machine.id = "scene";
  for (const Family& family : families_of({machine})) {
    ASSERT_FALSE(family.problems.empty()) << family.name;
    for (const Problem& problem : family.problems) {
      EXPECT_FALSE(problem.best_known) << problem.name;
      EXPECT_EQ(problem.name.substr(problem.name.size() - 6), "-scene");
    }
  }
}

}  // namespace
}  // namespace ricochet
