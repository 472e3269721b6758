#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

#include "src/report/text.h"

namespace ricochet::report {
namespace {

TEST(DataText, KeepsTheDigitsThatMeanSomething) {
  EXPECT_EQ(rounded(8.274912345, 6).dump(), "8.27491");
  EXPECT_EQ(rounded(8.274912345, 17).dump(), "8.274912345");
  EXPECT_EQ(rounded(-1.23456789e-12, 6).dump(), "-1.23457e-12");
  EXPECT_EQ(rounded(2.0 / 3, 2).dump(), "0.67");
}

TEST(DataText, KeepsWholeNumbersExactly) {
  EXPECT_EQ(rounded(123456789.0, 6).dump(), "123456789");
  EXPECT_EQ(rounded(-9007199254740991, 2).dump(), "-9007199254740991");
  EXPECT_EQ(rounded(1.5e300, 6).dump(), "1.5e+300");
}

TEST(DataText, RoundsTheSmallestAndTheLargestNumbers) {
  EXPECT_EQ(rounded(-1.23456789e-308, 6).dump(), "-1.23457e-308");
  EXPECT_EQ(rounded(5e-324, 6).dump(), "5e-324");
  EXPECT_EQ(rounded(1.797693134e308, 6).dump(), "1.79769e+308");
  EXPECT_EQ(rounded(1.7976931e308, 2).dump(), "1.7976931e+308") << "1.8e308 is beyond all numbers";
}

TEST(DataText, HasNullForWhatIsNoNumber) {
  EXPECT_TRUE(rounded(NAN, 6).is_null());
  EXPECT_TRUE(rounded(std::numeric_limits<double>::infinity(), 6).is_null());
}

TEST(DataText, HasTheFewestDigits) {
  EXPECT_EQ(Json(0.02414).dump(), "0.024140000000000002") << "else this test is not needed";
  EXPECT_EQ(json_text({{"a", {0.02414, -1e-12, 1.5e300, 2, "x", nullptr}}, {"b", Json::object()}}),
            "{\"a\":[0.02414,-1e-12,1.5e+300,2,\"x\",null],\"b\":{}}\n");
}

TEST(DataText, IsReadBackAndHasNoLongLine) {
  Json data = {{"rows", Json::array()}, {"plain", Json::array()}};
  for (int i = 0; i < 300; ++i) {
    data["rows"].push_back({{"x", i / 7.0}, {"name", "a \"b\"\n"}});
    data["plain"].push_back(i / 9.0);
  }
  const std::string text = json_text(data);
  EXPECT_EQ(data_in(text), data);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 140U) << line;
}

TEST(DataText, IsNotReadIfItIsNone) {
  EXPECT_THROW(data_in("{"), Json::exception);
  EXPECT_THROW(data_in(std::string(200, '[') + std::string(200, ']')), std::logic_error);
}

}  // namespace
}  // namespace ricochet::report
