#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ricochet/error.h"
#include "src/core/csv.h"

namespace ricochet {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string complaint(const std::string& text) {
  try {
    parse_csv_table(text, "f.csv", {"time", "omega"});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CsvTable, HasColumnsOfNumbers) {
  const CsvTable table = parse_csv_table(
      "# made by hand\r\nomega , time\r\n1, 2.5\r\n\r\n-3e2,+4\n", "f.csv", {"time", "omega"});
  EXPECT_THAT(table.column("time"), ElementsAre(2.5, 4));
  EXPECT_THAT(table.column("omega"), ElementsAre(1, -300));
  EXPECT_THAT(table.lines, ElementsAre(3, 5));
  EXPECT_EQ(table.find("strength"), nullptr);
}

TEST(CsvTable, MayBeginWithAByteOrderMark) {
  const std::string mark = "\xef\xbb\xbf";
  for (const char* text : {"time\n1\n", "time\r\n1\r\n", "# note\ntime\n1\n", "\n time\n1\n"}) {
    EXPECT_THAT(parse_csv_table(mark + text, "f.csv", {"time"}).column("time"), ElementsAre(1));
  }
  EXPECT_THAT(complaint(mark), HasSubstr("must have a header"));
  EXPECT_THAT(complaint("time\n" + mark + "1\n"), HasSubstr("f.csv:2: column time"));
}

TEST(CsvTable, IsRefusedWithFileLineAndColumn) {
  EXPECT_THAT(complaint(""), HasSubstr("f.csv: must have a header"));
  EXPECT_THAT(complaint("time\n"), HasSubstr("lines of numbers"));
  EXPECT_THAT(complaint("tine\n1\n"), HasSubstr("f.csv:1: column tine: did you mean time"));
  EXPECT_THAT(complaint("time,time\n1,2\n"), HasSubstr("f.csv:1: column time is there twice"));
  EXPECT_THAT(complaint("time,omega\n1\n"), HasSubstr("f.csv:2: 1 fields: must be 2"));
  EXPECT_THAT(complaint("time\n1\nx\n"), HasSubstr("f.csv:3: column time: 'x': must be a finite"));
  EXPECT_THAT(complaint("time\n1e999\n"), HasSubstr("must be a finite number"));
  EXPECT_THAT(complaint("time\nnan\n"), HasSubstr("must be a finite number"));
  EXPECT_THAT(complaint("time,omega\n1,\n"), HasSubstr("column omega: ''"));
}

TEST(CsvTable, ChecksNumbersWithTheirPlace) {
  const CsvTable table = parse_csv_table("time\n1\n\n-2\n", "f.csv", {"time"});
  try {
    table.require(
        "time", [](auto, double t) { return t > 0; }, "> 0");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "f.csv:4: column time: -2: must be > 0");
  }
}

TEST(CsvTable, OfAMissingFileIsRefused) {
  EXPECT_THROW(read_csv_table("/nowhere/f.csv", {"time"}), InputError);
}

}  // namespace
}  // namespace ricochet
