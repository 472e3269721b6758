#include "src/studies/problems/page.h"

#include <gtest/gtest.h>

#include <array>

#include "problems/carrier_track/questions/families.h"
#include "tests/carrier_track/questions/exploratory_scene.h"

namespace ricochet::studies::problems {
namespace {

/// Those of one case, but for the robust ones, whose charts take long.
std::vector<Family> families() {
  using namespace carrier_track;
  std::vector<Family> some;
  for (Family& family : families_of({machine_of(find_case("C1"), exploratory_scene())})) {
    if (family.name.rfind("robust-", 0) != 0) some.push_back(std::move(family));
  }
  return some;
}

TEST(Page, OfAllFamiliesHasARowForEach) {
  const report::Page page = overview_of(families(), "one case");
  const report::Table& table = page.sections.at(0).tables.at(0);
  ASSERT_EQ(table.rows.size(), families().size());
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(table.rows[2][0].text, "profile-count");
  EXPECT_EQ(table.rows[2][3].text, "2 to 64");
  EXPECT_EQ(table.rows[2][5].text, "count, surrogate");
}

TEST(Page, DrawsAFamilyOfOneVariable) {
  int drawn = 0;
  for (const Family& family : families()) {
    const report::Page page = page_of(family);
    for (const report::Table& table : page.sections.at(0).tables) {
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    }
    for (const report::Figure& figure : page.sections[0].figures) {
      EXPECT_NO_THROW(report::check(figure.chart)) << figure.chart.name;
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 2);  // count and top speed
}

TEST(Page, HasARowForEveryFormWithItsDerivatives) {
  const report::Page page = page_of(families()[1]);
  const auto& rows = page.sections[0].tables[1].rows;
  const std::vector<std::array<std::string, 3>> expected = {{"count", "1", "no"},
                                                            {"penalised-count", "0", "no"},
                                                            {"surrogate", "1", "yes"},
                                                            {"penalised-surrogate", "0", "yes"}};
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(rows[k][i].text, expected[k][i]) << k;
  }
}

TEST(Page, TellsTheStartAndTheBestOfEveryQuestion) {
  Family family = families()[0];
  Problem& problem = family.questions[0].stated;
  problem.best_known = 4;
  problem.best_point = Vector::Constant(1, 2.5);
  problem.provenance = "by hand";
  const report::Page page = page_of(family);
  const auto& row = page.sections[0].tables[2].rows.at(0);
  EXPECT_EQ(row[0].text, "count-C1");
  EXPECT_EQ(std::stod(row[1].text), problem.evaluate(problem.start).objective);
  EXPECT_EQ(row[2].text, "4");
  EXPECT_EQ(row[3].text, "2.5");
  EXPECT_EQ(row[4].text, "by hand");
}

TEST(Page, ShortensLongPoints) {
  Family family = families()[2];
  ASSERT_EQ(family.name, "profile-count");
  Problem& problem = family.questions.back().stated;
  problem.best_point = problem.start;
  problem.best_known = 0;
  EXPECT_EQ(page_of(family).sections[0].tables[2].rows.back()[3].text, "1, 1, 1, 1, 1, …");
}

}  // namespace
}  // namespace ricochet::studies::problems
