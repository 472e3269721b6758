#include "src/catalogue/page.h"

#include <gtest/gtest.h>

#include <set>

#include "problems/carrier_track/families.h"
#include "tests/carrier_track/exploratory_scene.h"

namespace ricochet::catalogue {
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

TEST(Page, HasASectionForEveryFamilyAndDrawsThoseOfOneVariable) {
  const report::Page page = page_of(families(), "one case");
  ASSERT_EQ(page.sections.size(), families().size() + 1);
  std::set<std::string> ids, charts;
  for (const report::Section& section : page.sections) {
    EXPECT_TRUE(ids.insert(section.id).second) << section.id;
    for (const report::Table& table : section.tables) {
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    }
    for (const report::Figure& figure : section.figures) {
      EXPECT_NO_THROW(report::check(figure.chart)) << figure.chart.name;
      EXPECT_TRUE(charts.insert(figure.chart.name).second);
    }
  }
  EXPECT_EQ(charts.size(), 2U * 2);  // count and top speed, in two forms
}

TEST(Page, TellsTheStartAndTheBestOfEveryProblem) {
  std::vector<Family> all = families();
  Problem& problem = all[0].problems[0];
  problem.best_known = 4;
  problem.best_point = Vector::Constant(1, 2.5);
  problem.provenance = "by hand";
  const report::Page page = page_of(all, "one case");
  const auto& row = page.sections[1].tables[1].rows.at(0);
  EXPECT_EQ(row[0].text, "count-C1");
  EXPECT_EQ(std::stod(row[1].text), problem.evaluate(problem.start).objective);
  EXPECT_EQ(row[2].text, "4");
  EXPECT_EQ(row[3].text, "2.5");
  EXPECT_EQ(row[4].text, "by hand");
}

TEST(Page, ShortensLongPoints) {
  std::vector<Family> all = families();
  for (Family& family : all) {
    for (Problem& problem : family.problems) {
      problem.best_point = problem.start;
      problem.best_known = 0;
    }
  }
  for (const report::Section& section : page_of(all, "one case").sections) {
    if (section.id != "profile") continue;
    EXPECT_EQ(section.tables[1].rows.back()[3].text, "1, 1, 1, 1, 1, …");
  }
}

}  // namespace
}  // namespace ricochet::catalogue
