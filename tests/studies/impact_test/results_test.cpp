#include "src/studies/impact_test/results.h"

#include <gmock/gmock.h>

#include "ricochet/error.h"
#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "tests/studies/impact_test/some_scenes.h"

namespace ricochet::studies::impact_test {
namespace {

/// A tool that says that nothing ever strikes a wall, but for one kind of scenes, which it cannot
/// express.
Tool quiet_tool(const std::filesystem::path& folder) {
  Tool tool = own_tool("quiet=sh " + (folder / "quiet.sh").string());
  write_file(folder / "quiet.sh", R"(while read -r line; do case $line in
*'"plastic"'*) echo '{"cannot":"e = 0"}';;
*) echo '{"impacts":[],"seconds":0.25}';;
esac; done
)");
  return tool;
}

Plan small_plan(const std::filesystem::path& folder) {
  return {1, 44, {Level::usual, Level::tight}, {quiet_tool(folder)}, false, folder / "out"};
}

TEST(Results, CompareEverybody) {
  const ScratchFolder folder;
  const Results results = impact_test(small_plan(folder.path()));
  ASSERT_EQ(results.scenes.size(), 44U);
  const Measured& quiet = results.measured.back();
  ASSERT_EQ(quiet.tool.name, "quiet");
  EXPECT_EQ(quiet.cannot, "e = 0");
  const report::Results all = results_of(results);
  EXPECT_EQ(text_of(*all.value("lost")), "0");
  EXPECT_THAT(
      text_of(*all.value("finding")),
      testing::HasSubstr("Of 1 tools, 0 lose none and 1 lose some: the best, quiet, 1000 per"));
  const Table& tools = *all.table("tools");
  EXPECT_EQ(tools[0].text("tool"), "ricochet");
  const Row last = tools[tools.rows.size() - 1];
  EXPECT_EQ(last.text("tool"), "quiet");
  EXPECT_EQ(last.number("missed"), 1000);
  EXPECT_EQ(last.number("invented"), 0);
  EXPECT_GT(last.number("ratio"), 100);
  EXPECT_EQ((*all.table("levels"))[0].text("tool"), "quiet");
  EXPECT_EQ((*all.table("levels"))[0].number("cannot"), 4);
  each_row(*all.table("kinds"), [](const Row& kind) {
    EXPECT_EQ(kind.number("lost_by"), kind.text("kind") == "plastic" ? 0 : 1);
  });
  // Every level of a simulator is a dot of its kind; one has its name.
  std::size_t dots = 0, names = 0;
  for (const report::Series& series : all.chart("losses-over-time")->series) {
    if (series.pale) continue;
    dots += series.samples.size();
    for (const report::Sample& sample : series.samples) names += sample.name == "quiet";
  }
  EXPECT_EQ(dots, results.measured.size());
  EXPECT_EQ(names, 1U);
  // One impact is enough.
  const auto broken = all.table("smallest-scenes")->find([](const Row& row) {
    return row.text("tool") == "quiet";
  });
  ASSERT_TRUE(broken);
  EXPECT_EQ(broken->number("missed"), 1);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "smallest" / "quiet.jsonl"));
}

TEST(Results, FillThePage) {
  const ScratchFolder folder;
  report::Json data = json_of(results_of(impact_test(small_plan(folder.path()))));
  data["made"] = {{"version", "1"},
                  {"compiler", "c"},
                  {"threads", 1},
                  {"seconds", 1.0},
                  {"date", "2031-02-03"}};
  const report::Results all = report::results_of(data);
  const auto page = report::page_source(report::page_template("impact-test"));
  EXPECT_TRUE(page_files(page, all).failures.empty());
  EXPECT_THAT(terminal_text(page, all), testing::HasSubstr("quiet"));
}

TEST(Results, NameAToolThatDoesNotStart) {
  const ScratchFolder folder;
  Plan plan{1, 3, {Level::usual}, {own_tool("gone=no-such-program-at-all")}, false, folder.path()};
  const Results results = impact_test(plan);
  ASSERT_EQ(results.missing.size(), 1U);
  EXPECT_THAT(results.missing[0].reason, testing::HasSubstr("no such program"));
  Tool tool = plan.tools[0];
  tool.source = folder.path() / "driver";
  tool.version = {"false"};
  plan.tools = {tool};
  EXPECT_EQ(impact_test(plan).missing.size(), 1U);
  plan.needs_all = true;
  EXPECT_THROW(impact_test(plan), InputError);
}

}  // namespace
}  // namespace ricochet::studies::impact_test
