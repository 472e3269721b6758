#include "problems/families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "problems/carrier_track/questions/families.h"
#include "src/core/instance.h"
#include "src/core/seed.h"
#include "src/core/verdict.h"
#include "tests/carrier_track/questions/exploratory_scene.h"

namespace ricochet {
namespace {

const std::vector<Family>& families() {
  static const std::vector<Family> all = all_families();
  return all;
}

TEST(Families, HaveDistinctNamesAndSoDoTheirQuestions) {
  std::set<std::string> names, questions;
  for (const Family& family : families()) {
    EXPECT_TRUE(names.insert(family.name).second) << family.name;
    for (const Question& question : family.questions) {
      EXPECT_TRUE(questions.insert(question.name()).second) << question.name();
      EXPECT_EQ(question.name().rfind(family.name + "-", 0), 0U) << question.name();
    }
  }
  EXPECT_EQ(names.size(), 13U);
  // Count, top speed, six sizes of two profiles, design and three risks; and the calibration. Then
  // the hard machines, and what the literature has.
  EXPECT_EQ(questions.size(), 12U * (1 + 1 + 2 * 6 + 1 + 3) + 1 + 15 + 27 + 116 + 53);
}

TEST(Families, HaveProblemsThatHoldTogether) {
  for (const Family& family : families()) {
    for (const Question& question : family.questions) {
      const Problem& p = question.stated;
      ASSERT_EQ(p.upper.size(), p.dimension()) << p.name;
      ASSERT_EQ(p.start.size(), p.dimension()) << p.name;
      EXPECT_TRUE((p.lower.array() < p.upper.array()).all()) << p.name;
      EXPECT_TRUE((p.start.array() >= p.lower.array()).all()) << p.name;
      EXPECT_TRUE((p.start.array() <= p.upper.array()).all()) << p.name;
      const auto n = static_cast<std::size_t>(p.dimension());
      EXPECT_TRUE(p.variables.empty() || p.variables.size() == n) << p.name;
      EXPECT_FALSE(p.source.empty()) << p.name;
      EXPECT_EQ(p.best_known.has_value(), p.best_point.has_value()) << p.name;
      EXPECT_EQ(p.best_known.has_value(), !p.provenance.empty()) << p.name;
    }
  }
}

/// As measured: see gradient_cost.h.
TEST(Families, KnowWhatAGradientTakes) {
  std::map<std::string, std::int64_t> costs;
  for (const Family& family : families()) {
    for (const Question& question : family.questions) {
      ASSERT_TRUE(question.gradient_cost) << question.name();
      EXPECT_GE(*question.gradient_cost, 1) << question.name();
      costs[question.name()] = *question.gradient_cost;
    }
  }
  EXPECT_EQ(costs.at("top-speed-C1"), 1);
  EXPECT_EQ(costs.at("robust-worst-C4"), 4);
  EXPECT_EQ(costs.at("calibration-default"), 3);
  EXPECT_EQ(costs.at("design-count-C9"), 3);
  EXPECT_EQ(costs.at("profile-count-16-C4"), 3);
  EXPECT_EQ(costs.at("profile-wear-32-C4"), 7);
  EXPECT_EQ(costs.at("profile-count-64-C1"), 14);
  EXPECT_EQ(costs.at("hs-1"), 1);
  EXPECT_EQ(costs.at("hs-110"), 5);
}

/// Forms of one question have one name, one truth, one box and one best value.
TEST(Families, ShowOneTruthInEveryForm) {
  for (const Family& family : families()) {
    for (const Question* question : {&family.questions.front(), &family.questions.back()}) {
      const Problem& stated = question->stated;
      EXPECT_FALSE(stated.truth) << stated.name;
      if (stated.smoothed) {  // to width 0 it is what is judged
        const Values exact =
            question->problem({question->width}).smoothed(0).evaluate(stated.start);
        EXPECT_EQ(exact.objective, stated.evaluate(stated.start).objective) << stated.name;
        EXPECT_EQ(exact.constraints, stated.evaluate(stated.start).constraints) << stated.name;
      }
      for (const Form& form : question->forms()) {
        const Problem shown = question->problem(form);
        EXPECT_EQ(shown.name, stated.name);
        EXPECT_EQ(shown.start, stated.start);
        EXPECT_EQ(shown.best_known, stated.best_known);
        const Truth truth = truth_at(shown, shown.start);
        const Truth expected = truth_at(stated, stated.start);
        EXPECT_EQ(truth.objective, expected.objective) << shown.name;
        EXPECT_EQ(truth.violation, expected.violation) << shown.name;
      }
    }
  }
}

/// What a solver of penalised problems converges to must be the answer.
TEST(Families, KeepTheBestPointBestWhereConstraintsArePenalised) {
  int looked = 0;
  for (const Family& family : families()) {
    if (family.name.starts_with("robust-")) continue;  // 32 simulations each
    for (const Question& question : family.questions) {
      if (question.stated.constraints == 0) continue;
      if (question.name() == "hs-13") continue;  // no weight is enough: see there
      const Problem penalised = question.problem({0, true});
      const Vector& best = question.stated.best_point.value();
      const double value = penalised.evaluate(best).objective;
      Random random(seed_of(penalised.name, "near", 0, 0));
      for (int k = 0; k < 200; ++k) {
        const Vector off = uniform_point(penalised, random) - best;
        const Vector near = best + off * std::pow(10.0, -(k % 5));
        EXPECT_GE(penalised.evaluate(near).objective, value - question.tolerance)
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
    ASSERT_FALSE(family.questions.empty()) << family.name;
    for (const Question& question : family.questions) {
      const Problem& problem = question.stated;
      EXPECT_FALSE(problem.best_known) << problem.name;
      EXPECT_EQ(problem.name.substr(problem.name.size() - 6), "-scene");
    }
  }
}

}  // namespace
}  // namespace ricochet
