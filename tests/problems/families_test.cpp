#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/machine.h"
#include "src/core/instance.h"
#include "src/studies/paper/loss.h"
#include "src/studies/suite/suite.h"
#include "tests/support/scenes.h"

namespace ricochet {
namespace {

const std::vector<Family>& families() {
  static const std::vector<Family> all = suite_families();
  return all;
}

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all = every_problem(families());
  return all;
}

TEST(Families, HaveDistinctNamesAndSoDoTheirProblems) {
  std::set<std::string> names, problems;
  for (const Family& family : families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    for (const Problem& problem : family.problems) {
      EXPECT_TRUE(problems.insert(problem.name).second) << problem.name;
      EXPECT_TRUE(problem.name.starts_with(family.name + "-")) << problem.name;
    }
  }
  EXPECT_EQ(names.size(), 19U);
  // Count, top speed, six sizes of two profiles, design and three risks; two large sizes of two
  // machines; and the calibration. Then the hard machines, what the literature has,
  // bowls with defects, and what is held out.
  EXPECT_EQ(problems.size(),
            12U * (1 + 1 + 2 * 6 + 1 + 3) + 2 * 2 + 1 + 15 + 27 + 116 + 53 + 9 + 70);
}

TEST(Families, HaveClustersOfProblemsThatAreAlike) {
  std::map<std::string, std::set<std::string>> members, clusters_of;
  std::size_t clusters = 0;
  for (const Family& family : families()) {
    for (const Problem& problem : family.problems) {
      const std::string& cluster = problem.cluster.empty() ? problem.name : problem.cluster;
      members[cluster].insert(problem.name);
      clusters_of[family.name].insert(cluster);
    }
    clusters += clusters_of[family.name].size();
  }
  EXPECT_EQ(clusters, members.size()) << "none is in two families";
  const std::map<std::string, std::size_t> numbers = {
      {"count", 8},        {"top-speed", 8},      {"profile-count", 8},
      {"profile-wear", 8}, {"robust-mean", 8},    {"hard-top-speed", 15},
      {"classic", 22},     {"least-squares", 22}, {"hs", 92}};
  for (const auto& [family, number] : numbers)
    EXPECT_EQ(clusters_of[family].size(), number) << family;
  const std::vector<std::set<std::string>> together = {
      {"top-speed-C1", "top-speed-C5"},
      {"top-speed-C9"},  // its disturbance is nearly as strong as friction
      {"hs-88", "hs-89", "hs-90", "hs-91", "hs-92"},
      {"classic-rosenbrock-2", "classic-rosenbrock-5", "classic-rosenbrock-20"},
      {"classic-branin"}};
  for (const auto& problems : together) {
    EXPECT_THAT(members, Contains(testing::Pair(testing::_, problems)));
  }
}

TEST(Families, HaveProblemsThatHoldTogether) {
  for (const Problem& problem : problems()) {
    SCOPED_TRACE(problem.name);
    ASSERT_EQ(problem.upper.size(), problem.dimension());
    ASSERT_EQ(problem.start.size(), problem.dimension());
    EXPECT_EQ((problem.lower.array() < problem.upper.array()).all(),
              problem.name != "pathological-one-choice");
    EXPECT_EQ(problem.start.cwiseMax(problem.lower).cwiseMin(problem.upper), problem.start);
    const auto n = static_cast<std::size_t>(problem.dimension());
    EXPECT_TRUE(problem.variables.empty() || problem.variables.size() == n);
    EXPECT_FALSE(problem.source.empty());
    EXPECT_EQ(problem.best_known.has_value(),
              problem.best_point || problem.name == "pathological-infeasible");
    EXPECT_EQ(problem.best_known.has_value(), !problem.provenance.empty());
  }
}

/// As measured: see profile.h.
TEST(Families, KnowWhatAGradientTakes) {
  std::map<std::string, std::int64_t> costs;
  for (const Problem& problem : problems()) {
    ASSERT_TRUE(problem.gradient_cost) << problem.name;
    EXPECT_GE(*problem.gradient_cost, 1) << problem.name;
    costs[problem.name] = *problem.gradient_cost;
  }
  const std::map<std::string, std::int64_t> some = {{"top-speed-C1", 1},
                                                    {"robust-worst-C4", 4},
                                                    {"calibration-default", 3},
                                                    {"design-count-C9", 3},
                                                    {"profile-count-16-C4", 2},
                                                    {"profile-wear-32-C4", 2},
                                                    {"profile-count-64-C1", 2},
                                                    {"hs-1", 1},
                                                    {"hs-110", 5}};
  EXPECT_THAT(costs, testing::IsSupersetOf(some));
}

/// Formulations of one problem have one name, one true objective, one box and one best value.
TEST(Families, ShowOneTrueValuesInEveryFormulation) {
  for (const Family& family : families()) {
    for (const Problem& stated : {family.problems.front(), family.problems.back()}) {
      EXPECT_EQ(static_cast<bool>(stated.true_values), stated.hazardous) << stated.name;
      if (stated.smoothed) {  // to smoothing parameter 0 it is what is judged
        const Values exact =
            stated.formulated({stated.smoothing}).smoothed(0).evaluate(stated.start);
        EXPECT_EQ(exact.objective, stated.evaluate(stated.start).objective) << stated.name;
        EXPECT_EQ(exact.constraints, stated.evaluate(stated.start).constraints) << stated.name;
      }
      for (const Formulation& formulation : stated.formulations()) {
        const Problem shown = stated.formulated(formulation);
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
  for (const Problem& problem : problems()) {
    if (problem.name.starts_with("robust-")) continue;  // 32 simulations each
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
      EXPECT_TRUE(problem.name.ends_with("-scene")) << problem.name;
    }
  }
}

/// Those of the paper's cases are committed.
TEST(BestValues, AreThereForEveryProblemAndComeOutAgainAtTheirPoints) {
  std::vector<Family> paper = carrier_track::case_families();
  paper.push_back(carrier_track::calibration_family());
  std::set<std::string> names;
  for (const Problem& problem : every_problem(paper)) {
    SCOPED_TRACE(problem.name);
    names.insert(problem.name);
    ASSERT_TRUE(problem.best_known && problem.best_point);
    const Vector& best = *problem.best_point;
    ASSERT_EQ(best.size(), problem.dimension());
    EXPECT_EQ(best.cwiseMax(problem.lower).cwiseMin(problem.upper), best);
    const TrueValues true_values = true_values_at(problem, best);
    EXPECT_EQ(true_values.violation, 0);
    EXPECT_NEAR(true_values.objective, *problem.best_known, 1e-9);
    EXPECT_FALSE(better(true_values_at(problem, problem.start), true_values));
    if (problem.dimension() != 1) continue;
    // Ten speeds of a scan on either side; where the best value is at an edge, the first of them is
    // not quiet.
    for (int k = -10; k <= 10; ++k) {
      const double x = best[0] + k * problem.scan_step;
      if (x < problem.lower[0] || x > problem.upper[0]) continue;
      const TrueValues near = true_values_at(problem, Vector::Constant(1, x));
      EXPECT_FALSE(near.violation == 0 && near.objective < true_values.objective - 1e-6) << x;
    }
  }
  for (const auto& [name, best] : carrier_track::best_values().of) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

}  // namespace
}  // namespace ricochet
