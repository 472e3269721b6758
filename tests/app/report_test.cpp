#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "src/report/text.h"
#include "tests/app/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ReportCommand, FailsWhereAChartCannotBeDrawnAndDrawsAllOthers) {
  const auto folder = fresh_folder();
  report::Json data =
      report::data_in(read(RICOCHET_SOURCE "/reports/reference/surrogate/data.json"));
  data["charts"]["speed-gap"]["series"][0]["samples"][0][1] = 1e200;
  write(folder, "data.json", report::json_text(data));
  const Outcome outcome = call("report " + folder.string());
  EXPECT_EQ(outcome.exit_code, 2) << "the data are the input";
  EXPECT_EQ(outcome.err, "ricochet: " + (folder / "data.json").string() +
                             ": chart speed-gap could not be drawn: "
                             "series \"C1\", sample 0: 1e+200 is beyond 1e100\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "speed-gap.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder / "validity-trend.svg"));
  const std::string page = read(folder / "index.html");
  EXPECT_THAT(page, HasSubstr("1e+200 is beyond 1e100"));
  EXPECT_THAT(page, HasSubstr(read(folder / "validity-trend.svg")));
  EXPECT_THAT(read(folder / "summary.md"), Not(HasSubstr("(speed-gap.svg)")));
}

/// What `report` says of the reference's surrogate after this change of their text.
Outcome after(const std::string& from, const std::string& to) {
  const auto folder = fresh_folder();
  std::string text = read(RICOCHET_SOURCE "/reports/reference/surrogate/data.json");
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  text.replace(place, from.size(), to);
  const auto file = write(folder, "data.json", text);
  Outcome outcome = call("report " + folder.string());
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_THAT(outcome.err, testing::StartsWith("ricochet: " + file.string() + ": "));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  return outcome;
}

TEST(ReportCommand, RefusesDamagedDataWithFileAndKey) {
  EXPECT_THAT(after("{", "").err, HasSubstr("parse error"));
  EXPECT_THAT(after("\"report\":\"surrogate\"", "\"report\":7").err, HasSubstr("(/report)"));
  EXPECT_THAT(after("\"report\":\"surrogate\"", "\"report\":\"none\"").err,
              HasSubstr("no such report"));
  EXPECT_THAT(after("\"quiet-speeds\":", "\"quiet-speed\":").err, HasSubstr("quiet-speeds"));
  EXPECT_THAT(after("\"report\":\"surrogate\"", "\"report\":\"surrogate\",\"pages\":7").err,
              HasSubstr("(/pages)"));
  const std::string deep(100'000, '[');
  EXPECT_THAT(after("\"report\":\"surrogate\"", "\"report\":\"surrogate\",\"deep\":" + deep).err,
              HasSubstr("nested deeper than 100"));
}

TEST(ReportCommand, WritesOnlyBelowItsFolder) {
  EXPECT_THAT(
      after("\"report\":\"surrogate\"", "\"report\":\"surrogate\",\"pages\":[\"../other\"]").err,
      HasSubstr("pages: \"../other\" is no folder's name"));
}

TEST(ReportCommand, NamesEveryDamagedReportOfAFolderAndDrawsTheOthers) {
  const auto folder = fresh_folder();
  const auto kept = [&folder](const std::string& report, const std::string& from,
                              const std::string& to) {
    std::string text = read(RICOCHET_SOURCE "/reports/reference/" + report + "/data.json");
    text.replace(text.find(from), from.size(), to);
    std::filesystem::create_directories(folder / report);
    return write(folder / report, "data.json", text).string();
  };
  const std::string calibration = kept("calibration", "\"agreement\":", "\"agrement\":");
  const std::string surrogate = kept("surrogate", "{", "");
  kept("verification", "{", "{");
  for (const auto& out : {folder / "out", folder}) {
    const Outcome outcome = call("report " + folder.string() + " --out " + out.string());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, testing::StartsWith("ricochet: " + calibration + ": "));
    EXPECT_THAT(outcome.err, HasSubstr("agreement"));
    EXPECT_THAT(outcome.err, HasSubstr("; " + surrogate + ": must be the data of a report: "));
    EXPECT_THAT(outcome.err, Not(HasSubstr("verification")));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
    EXPECT_TRUE(std::filesystem::exists(out / "verification" / "index.html"));
    EXPECT_THAT(read(out / "index.html"), HasSubstr("No count called certain is wrong."));
    EXPECT_EQ(read(out / "surrogate" / "data.json"), read(surrogate));
  }
}

TEST(ReportCommand, SaysWhatItWrote) {
  const auto folder = fresh_folder();
  const auto page = [&folder](const char* of) { return (folder / of / "index.html").string(); };
  const std::string from = RICOCHET_SOURCE "/reports/reference";
  EXPECT_EQ(call("report " + from + "/surrogate --out " + (folder / "one").string()).out,
            "The report: " + page("one") + "\n");
  EXPECT_EQ(call("report " + from + " --out " + (folder / "all").string()).out,
            "The reports: " + page("all") + "\n");
  EXPECT_TRUE(std::filesystem::exists(page("all")));
}

}  // namespace
}  // namespace ricochet::cli
