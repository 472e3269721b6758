#include <gmock/gmock.h>

#include "src/report/data_text.h"
#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ReportCommand, FailsWhereAChartCannotBeDrawnAndDrawsAllOthers) {
  const auto folder = fresh_folder();
  report::Json data = report::data_in(read(RICOCHET_SOURCE "/reports/reference/limits/data.json"));
  data["paper_curve"][0]["y"] = 1e200;
  write(folder, "data.json", report::data_text(data));
  const Outcome outcome = call("report " + folder.string());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err,
            "ricochet: failed: chart response could not be drawn: "
            "series \"the paper\", sample 0: 1e+200 is beyond 1e100\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "response.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder / "relief.svg"));
  const std::string page = read(folder / "index.html");
  EXPECT_THAT(page, HasSubstr("1e+200 is beyond 1e100</p>"));
  EXPECT_THAT(page, HasSubstr(read(folder / "relief.svg")));
  EXPECT_THAT(read(folder / "summary.md"), Not(HasSubstr("(response.svg)")));
}

TEST(ReportCommand, SaysWhatItWrote) {
  const auto folder = fresh_folder();
  const auto page = [&folder](const char* of) { return (folder / of / "index.html").string(); };
  const std::string from = RICOCHET_SOURCE "/reports/reference";
  EXPECT_EQ(call("report " + from + "/limits --out " + (folder / "one").string()).out,
            "The report: " + page("one") + "\n");
  EXPECT_EQ(call("report " + from + " --out " + (folder / "all").string()).out,
            "The reports: " + page("all") + "\n");
  EXPECT_TRUE(std::filesystem::exists(page("all")));
}

}  // namespace
}  // namespace ricochet::cli
