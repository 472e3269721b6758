#include <gtest/gtest.h>

#include "src/core/csv.h"

namespace ricochet {
namespace {

TEST(CsvField, QuotesWhatWouldEndIt) {
  EXPECT_EQ(csv_field(""), "");
  EXPECT_EQ(csv_field("nlopt-cobyla"), "nlopt-cobyla");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a\"b"), "\"a\"\"b\"");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
}

TEST(CsvField, IsNoFormula) {
  EXPECT_EQ(csv_field("=cmd|' /C calc'!A0"), "'=cmd|' /C calc'!A0");
  EXPECT_EQ(csv_field("@SUM(1)"), "'@SUM(1)");
  EXPECT_EQ(csv_field("+1+1"), "'+1+1");
  EXPECT_EQ(csv_field("-1+1,2"), "\"'-1+1,2\"");
  EXPECT_EQ(csv_field("\t=1"), "'\t=1");
  EXPECT_EQ(csv_field("\r=1"), "\"'\r=1\"");
}

TEST(CsvField, LeavesNumbersAlone) {
  for (const char* number : {"-1.5", "-inf", "-3e-07", "0", "nan"}) {
    EXPECT_EQ(csv_field(number), number);
  }
}

}  // namespace
}  // namespace ricochet
