#include "problems/families.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "problems/carrier_track/questions/families.h"
#include "tests/carrier_track/questions/exploratory_scene.h"

namespace ricochet {
namespace {

const std::vector<Family>& families() {
  static const std::vector<Family> all = all_families();
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
  // Count, top speed, six sizes of profile, design and three risks, in two forms; six sizes of
  // wear; and the calibration. Then what the literature has.
  EXPECT_EQ(problems.size(), 12U * (2 * (1 + 1 + 6 + 1 + 3) + 6) + 1 + 27 + 31 + 53);
}

TEST(Families, SayWhatTheyAsk) {
  for (const Family& family : families()) {
    for (const std::string& text :
         {family.title, family.question, family.formula, family.instances, family.users}) {
      EXPECT_GT(text.size(), 10U) << family.name;
    }
    const bool constrained = std::any_of(family.problems.begin(), family.problems.end(),
                                         [](const Problem& p) { return p.constraints > 0; });
    EXPECT_EQ(family.constraints.empty(), !constrained) << family.name;
    const Problem& first = family.problems.front();
    EXPECT_EQ(family.derivatives.empty(), !first.differentiate && !first.residuals) << family.name;
  }
}

TEST(Families, HaveProblemsThatHoldTogether) {
  for (const Family& family : families()) {
    for (const Problem& p : family.problems) {
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

/// Forms of one question have one truth, one box and one best value.
TEST(Families, ShareTheirTruthWithTheOneTheyAreJudgedAs) {
  for (const Family& family : families()) {
    if (family.judged_as == family.name) continue;
    const auto other = std::find_if(families().begin(), families().end(),
                                    [&](const Family& f) { return f.name == family.judged_as; });
    ASSERT_NE(other, families().end()) << family.name;
    ASSERT_EQ(other->problems.size(), family.problems.size());
    for (const std::size_t i : {std::size_t{0}, family.problems.size() - 1}) {
      const Problem& shown = family.problems[i];
      const Problem& judged = other->problems[i];
      EXPECT_EQ(shown.start, judged.start);
      EXPECT_EQ(shown.best_known, judged.best_known);
      const Truth truth = shown.truth(shown.start);
      const Truth expected = truth_of(judged.evaluate(judged.start));
      EXPECT_EQ(truth.objective, expected.objective) << shown.name;
      EXPECT_EQ(truth.violation, expected.violation) << shown.name;
      EXPECT_TRUE(shown.smoothed) << shown.name;
    }
  }
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
