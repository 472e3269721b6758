#include "src/studies/impact_test/results.h"

#include <gmock/gmock.h>

#include "ricochet/error.h"
#include "src/report/page_template.h"
#include "src/report/report.h"
#include "tests/studies/impact_test/some_scenes.h"

namespace ricochet::studies::impact_test {
namespace {

using report::Json;

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
  const Json data = data_of(results);
  EXPECT_EQ(data["ours"]["wrong"], 0);
  EXPECT_EQ(data["standings"][0]["tool"], "ricochet");
  const Json& last = data["standings"].back();
  EXPECT_EQ(last["tool"], "quiet");
  EXPECT_EQ(last["missed"], 1000);
  EXPECT_EQ(last["invented"], 0);
  EXPECT_EQ(last["cannot"], 4);
  EXPECT_GT(last["ratio"], 100);
  EXPECT_EQ(data["found"]["tools"], 1);
  EXPECT_EQ(data["found"]["hardest"]["tools"], 1);
  // Every level of a simulator is a dot of its kind; one has its name.
  std::size_t dots = 0, names = 0;
  for (const Json& kind : data["dots"]) {
    dots += kind["rows"].size();
    for (const Json& row : kind["rows"]) names += row["name"] == "quiet";
  }
  EXPECT_EQ(dots, results.measured.size());
  EXPECT_EQ(names, 1U);
  // One impact is enough.
  const Json& broken = data["broken"].back();
  EXPECT_EQ(broken["tool"], "quiet");
  EXPECT_EQ(broken["missed"], 1);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "smallest" / "quiet.jsonl"));
}

TEST(Results, FillTheTemplate) {
  const ScratchFolder folder;
  Json data = data_of(impact_test(small_plan(folder.path())));
  data["made"] = {{"version", "1"}, {"compiler", "c"}, {"threads", 1}, {"seconds", 1.0}};
  const auto page = report::drawn(report::page_template("impact-test"), data);
  EXPECT_THAT(page.epilogue, testing::HasSubstr("quiet"));
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
