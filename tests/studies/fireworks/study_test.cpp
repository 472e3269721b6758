#include "src/studies/fireworks/study.h"

#include <gmock/gmock.h>

#include <set>
#include <string>

#include "solvers/fireworks/fireworks.h"
#include "src/report/chart.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"

namespace ricochet::studies::fireworks {
namespace {

using testing::HasSubstr;

/// All parts of the study, of next to no runs.
const report::Results& made() {
  static const report::Results results = compared_with_published({3, 2, 2000});
  return results;
}

Table of(const char* solver) {
  return where(*made().table("results"), "solver", value_of(solver));
}

TEST(FireworksStudy, HasARowForEveryMemberOfTheFamily) {
  std::set<std::string> names;
  each_row(*made().table("variants"), [&](const Row& row) {
    EXPECT_TRUE(names.insert(row.text("solver")).second);
    EXPECT_FALSE(row.text("what").empty());
  });
  const auto family = ricochet::fireworks::family();
  for (const Solver& member : family) EXPECT_EQ(names.count(member.name), 1U) << member.name;
  EXPECT_EQ(names.size(), family.size() + 1);  // an interpretation that is no solver of its own
}

TEST(FireworksStudy, ReproducesTheSevenZerosOf2010) {
  // Table 3 of Tan and Zhu has nine functions, seven of them with a mean of 0.000000.
  for (const char* solver :
       {"fireworks", "fireworks-authors", "fireworks-authors with round(d U)"}) {
    const Table own = of(solver);
    ASSERT_EQ(own.rows.size(), 9U) << solver;
    int zeros = 0;
    each_row(own, [&](const Row& row) {
      if (row.number("published") > 0) return;
      ++zeros;
      EXPECT_LT(row.number("mean"), 5e-7) << row.text("function");
      EXPECT_TRUE(row.is("agrees")) << row.text("function");
    });
    EXPECT_EQ(zeros, 7) << solver;
  }
}

TEST(FireworksStudy, SeesWhoFavoursTheOrigin) {
  std::set<std::string> biased;
  each_row(*made().table("variants"), [&](const Row& row) {
    if (row.is("biased")) biased.insert(row.text("solver"));
  });
  // With two sparks the box around the firework shrinks before it has gone far.
  EXPECT_EQ(biased, (std::set<std::string>{"bbfwa-tuned", "fireworks", "fireworks-as-printed",
                                           "fireworks-authors"}));
  EXPECT_EQ(made().table("shift")->rows.size(), 13U * 6U);
}

TEST(FireworksStudy, ComparesAllThatHasFigures) {
  if (of("efwa").rows.empty()) GTEST_SKIP() << "built without pagmo";
  for (const char* solver : {"efwa", "dynfwa", "bbfwa", "lotfwa"}) {
    EXPECT_EQ(of(solver).rows.size(), 6U) << solver;
  }
  EXPECT_EQ(of("lotfwa")[1].number("published"), 14.6);
  EXPECT_EQ(made().table("results")->rows.size(), 3U * 9U + 4U * 6U);
  const auto lotfwa =
      made().table("variants")->find([](const Row& row) { return row.text("solver") == "lotfwa"; });
  EXPECT_EQ(lotfwa->number("compared"), 6);
  EXPECT_EQ(lotfwa->number("agreeing"), where(of("lotfwa"), "agrees", true).rows.size());
}

TEST(FireworksStudy, FillsItsPage) {
  report::Results results = made();
  results.set("quick", std::optional<std::string>());
  for (const char* name : {"version", "compiler", "threads", "date"}) {
    results.set(std::string("made.") + name, "1");
  }
  results.set("made.seconds", 4.5);
  const auto page = report::page_source(report::page_template("fireworks"));
  const report::PageFiles written = page_files(page, results);
  EXPECT_TRUE(written.failures.empty());
  EXPECT_TRUE(written.files.contains("shift.svg"));
  EXPECT_THAT(written.files.at("summary.md"), HasSubstr("| fireworks | Sphere |"));
  EXPECT_THAT(written.files.at("index.html"),
              HasSubstr("<a href=\"../comparison/index.html\">comparison</a>"));
}

}  // namespace
}  // namespace ricochet::studies::fireworks
