#include "src/studies/paper/theory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

double loss(double restitution) {
  return (1 - restitution) / (1 + restitution);
}

/// The paper's cases, with thresholds twice the formula's.
std::vector<CaseStudy> made_cases() {
  std::vector<CaseStudy> cases;
  for (const auto& it : carrier_track::all_cases()) {
    CaseStudy& c = cases.emplace_back();
    c.the_case = it;
    c.score.threshold = 2 * std::sqrt(loss(it.restitution)) * std::exp(it.friction);
  }
  return cases;
}

report::Results theory_of(const std::vector<CaseStudy>& cases) {
  report::Results results;
  add_theory(cases, results);
  return results;
}

TEST(Theory, FitsEveryFormulaToBothThresholds) {
  const report::Results results = theory_of(made_cases());
  const Table& formulas = *results.table("formulas");
  ASSERT_EQ(formulas.rows.size(), all_formulas().size());
  EXPECT_EQ(formulas[0].text("formula"), "w = c");
  EXPECT_NEAR(formulas[0].number("explained"), 0, 1e-12);
  const auto row =
      formulas.find([](const Row& r) { return r.text("formula") == "w = c √R exp(k μ)"; });
  ASSERT_TRUE(row);
  EXPECT_NEAR(row->number("computed_error"), 0, 1e-12) << "that is how they were made";
  EXPECT_NEAR(row->number("computed_left_out"), 0, 1e-12);
  EXPECT_GT(row->number("left_out"), row->number("error"));
  EXPECT_EQ(*results.value("formula.error"), (*row)["error"]);
  // By hand: 7.56 and 1.45 from the ten thresholds.
  EXPECT_EQ(row->text("constants"), "c = 7.56, k = 1.45");
}

TEST(Theory, LeavesOutWhatIsNotComputed) {
  auto cases = made_cases();
  for (CaseStudy& c : cases) c.score.threshold.reset();
  const report::Results none = theory_of(cases);
  EXPECT_FALSE((*none.table("formulas"))[1].number_if("computed_error"));
  EXPECT_TRUE((*none.table("formulas"))[1].number_if("error"));
}

}  // namespace
}  // namespace ricochet::studies::reproduction
