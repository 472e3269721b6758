#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"
#include "src/report/page_template.h"
#include "src/report/report.h"
#include "src/studies/problems/problems.h"
#include "src/studies/suite/suite.h"
#include "tests/carrier_track/suite/exploratory_scene.h"

namespace ricochet::studies::problems {
namespace {

using report::Table;

/// Those of one case, but for the robust ones, whose charts take long.
std::vector<Family> families() {
  using namespace carrier_track;
  std::vector<Family> some;
  for (Family& family : families_of({machine_of(find_case("C1"), exploratory_scene())})) {
    if (family.name.rfind("robust-", 0) != 0) some.push_back(std::move(family));
  }
  return some;
}

report::Section facts_of(const Family& family) {
  return report::drawn(report::page_template("family"), family_data(family, 10))
      .page.sections.at(0);
}

/// The value of a chart's curve at a position; of steps the last one's.
double value_on(const report::Json& points, double x, bool steps) {
  std::size_t right = 1;
  while (right + 1 < points.size() && points[right]["x"].get<double>() <= x) ++right;
  const auto at = [&](std::size_t i, const char* key) { return points[i][key].get<double>(); };
  if (x >= at(right, "x")) return at(right, "value");
  if (steps) return at(right - 1, "value");
  const double share = (x - at(right - 1, "x")) / (at(right, "x") - at(right - 1, "x"));
  return at(right - 1, "value") + share * (at(right, "value") - at(right - 1, "value"));
}

TEST(FamilyData, ChartsNeedFewPointsAndShowAll) {
  for (const Family& family : families()) {
    if (family.name != "count" && family.name != "top-speed") continue;
    const report::Json data = family_data(family, 10);
    const report::Json& chart = data["charts"].at(0);
    const Problem& problem = family.problems.front();
    for (const bool smooth : {false, true}) {
      const report::Json& points = chart[smooth ? "smoothed" : "true_values"]["points"];
      EXPECT_LT(points.size(), 300U) << family.name;
      const Problem formulated = problem.formulated({smooth ? problem.smoothing : 0});
      for (int k = 0; k <= 720; k += 7) {
        const Vector x = problem.lower + (problem.upper - problem.lower) * k / 720.0;
        const Values values = formulated.evaluate(x);
        const double true_values =
            formulated.constraints > 0 ? values.constraints[0] : values.objective;
        EXPECT_NEAR(value_on(points, x[0], !smooth), true_values, smooth ? 0.05 : 0)
            << family.name << " at " << x[0];
      }
    }
  }
}

/// What is said agrees with what there is.
TEST(FamilyData, SayWhatEveryFamilyAsks) {
  for (const Family& whole : suite_families()) {
    // A chart of a family takes long, and is not asked for with more than one variable.
    if (whole.name.rfind("robust-", 0) == 0) continue;
    const report::Json data = family_data(whole, 10);
    for (const char* text : {"title", "asks", "formula", "instances", "users"}) {
      EXPECT_GT(data[text].get<std::string>().size(), 10U) << whole.name << ' ' << text;
    }
    const auto any_formulation = [&whole](const auto& of) {
      return std::any_of(whole.problems.begin(), whole.problems.end(), [&](const Problem& q) {
        const auto formulations = q.formulations();
        return std::any_of(
            formulations.begin(), formulations.end(),
            [&](const Formulation& formulation) { return of(q.formulated(formulation)); });
      });
    };
    EXPECT_EQ(data["constraints"].get<std::string>().empty(),
              !any_formulation([](const Problem& p) { return p.constraints > 0; }))
        << whole.name;
    EXPECT_EQ(data["surrogate"].get<std::string>().empty(),
              !any_formulation([](const Problem& p) { return static_cast<bool>(p.smoothed); }))
        << whole.name;
    EXPECT_EQ(data["derivatives"].get<std::string>().empty(),
              !any_formulation([](const Problem& p) { return p.differentiate || p.residuals; }))
        << whole.name;
  }
}

TEST(FamilyData, FillInTheTextsOfAFamilyThatIsLikeAnother) {
  Family family = families()[0];
  family.name = "robust-mean";
  const report::Json data = family_data(family, 10);
  EXPECT_EQ(data["title"], "The fastest speed quiet in spite of tolerances, on average");
  EXPECT_EQ(data["constraints"], "The mean of the 32 counts <= quiet limit.");
}

TEST(FamilyData, SayNothingOfAFamilyThatNobodyDescribed) {
  Family family = families()[0];
  family.name = "mine";
  EXPECT_EQ(family_data(family, 10)["title"], "mine");
  EXPECT_EQ(family_data(family, 10)["asks"], "");
}

TEST(FamilyData, MakeARowOfTheTableOfAllFamilies) {
  report::Json data = {{"suite", 3}, {"scene", "mine.toml"}, {"problems", 7}, {"kinds", 3}};
  for (const Family& family : families()) data["families"].push_back(family_row(family));
  const report::DrawnPage drawing = report::drawn(report::page_template("problems"), data);
  const Table& table = drawing.page.sections.at(0).tables.at(0);
  ASSERT_EQ(table.rows.size(), families().size());
  EXPECT_NE(drawing.page.intro.at(0).find("Version 3 of the suite."), std::string::npos);
  EXPECT_EQ(family_data(families()[0], 10)["problems"][0]["hash"].get<std::string>().size(), 16U);
  EXPECT_EQ(table.rows[0][0].text, "count");
  EXPECT_EQ(table.rows[0][3].text, "1");
  EXPECT_EQ(table.rows[2][0].text, "profile-count");
  EXPECT_EQ(table.rows[2][3].text, "2 to 256");
  EXPECT_EQ(table.rows[2][5].text, "count, surrogate");
}

TEST(FamilyData, DrawAFamilyOfOneVariable) {
  int drawn = 0;
  for (const Family& family : families()) {
    for (const report::Figure& figure : facts_of(family).figures) {
      EXPECT_NO_THROW(report::check(figure.chart)) << figure.chart.name;
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 2);  // count and top speed
}

TEST(FamilyData, HaveARowForEveryFormulationWithItsDerivatives) {
  const report::Section facts = facts_of(families()[1]);
  const auto& rows = facts.tables[1].rows;
  const std::vector<std::array<std::string, 3>> expected = {{"count", "1", "no"},
                                                            {"penalised-count", "0", "no"},
                                                            {"surrogate", "1", "yes"},
                                                            {"penalised-surrogate", "0", "yes"}};
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(rows[k][i].text, expected[k][i]) << k;
  }
}

TEST(FamilyData, TellTheStartAndTheBestOfEveryProblem) {
  Family family = families()[0];
  Problem& problem = family.problems[0];
  problem.best_known = 4;
  problem.best_point = Vector::Constant(1, 2.5);
  problem.provenance = "by hand";
  const report::Section facts = facts_of(family);
  const auto& row = facts.tables[2].rows.at(0);
  EXPECT_EQ(row[0].text, "count-C1");
  EXPECT_EQ(std::stod(row[1].text), problem.evaluate(problem.start).objective);
  EXPECT_EQ(row[2].text, "4");
  EXPECT_EQ(row[3].text, "2.5");
  EXPECT_EQ(row[4].text, "by hand");
}

TEST(FamilyData, ShowWhatIsToBeLargeAsItIsMeant) {
  Family family = families()[1];
  ASSERT_EQ(family.name, "top-speed");
  family.problems[0].best_known = -8.25;
  const report::Section facts = facts_of(family);
  EXPECT_EQ(facts.tables[2].columns[2].title, "best known speed [rad/s]");
  EXPECT_EQ(facts.tables[2].rows.at(0)[2].text, "8.25");
  EXPECT_GT(family_data(family, 10)["problems"][0]["start"], 0);
}

TEST(FamilyData, ShortenLongPoints) {
  Family family = families()[2];
  ASSERT_EQ(family.name, "profile-count");
  Problem& problem = family.problems.back();
  problem.best_point = problem.start;
  problem.best_known = 0;
  const report::Section facts = facts_of(family);
  EXPECT_EQ(facts.tables[2].rows.back()[3].text, "1, 1, 1, 1, 1, …");
  EXPECT_EQ(family_data(family, 10)["problems"].back()["point"].size(), 256U);
}

TEST(FamilyData, SayThatNothingIsKnown) {
  Family family = families()[0];
  Problem& problem = family.problems[0];
  problem.best_known.reset();
  problem.best_point.reset();
  problem.provenance.clear();
  const report::Section facts = facts_of(family);
  const auto& row = facts.tables[2].rows.at(0);
  EXPECT_EQ(row[2].text + row[3].text + row[4].text, "–––");
}

}  // namespace
}  // namespace ricochet::studies::problems
