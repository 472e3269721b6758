#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

#include "src/report/text.h"

namespace ricochet::report {
namespace {

TEST(DataText, KeepsTheDigitsThatMeanSomething) {
  const Json data = {
      {"speed", 8.274912345}, {"error", -1.23456789e-12}, {"curve", {1.0 / 3, {2.0 / 3}}}};
  EXPECT_EQ(data_text(data),
            R"({"speed":8.27491,"error":-1.23457e-12,"curve":[0.333333,[0.666667]]})"
            "\n");
  EXPECT_EQ(data_text(data, {{"speed", 17}, {"curve", 2}}),
            R"({"speed":8.274912345,"error":-1.23457e-12,"curve":[0.33,[0.67]]})"
            "\n");
}

TEST(DataText, KeepsWholeNumbersAndTextsExactly) {
  const Json data = {{"seed", std::uint64_t{18446744073709551615U}},
                     {"evaluations", 123456789.0},
                     {"hash", "00ff1234567890ab"},
                     {"below", -9007199254740991},
                     {"large", 1.5e300}};
  EXPECT_EQ(data_in(data_text(data)).dump(),
            R"({"seed":18446744073709551615,"evaluations":123456789,"hash":"00ff1234567890ab",)"
            R"("below":-9007199254740991,"large":1.5e+300})");
}

TEST(DataText, RoundsTheSmallestAndTheLargestNumbers) {
  EXPECT_EQ(data_text({-1.23456789e-308, 5e-324, 1.797693134e308}),
            "[-1.23457e-308,5e-324,1.79769e+308]\n");
  EXPECT_EQ(data_text({1.7976931e308}, {}), "[1.79769e+308]\n");
  EXPECT_EQ(data_text({{"x", 1.7976931e308}}, {{"x", 2}}), "{\"x\":1.7976931e+308}\n")
      << "1.8e308 is beyond all numbers";
}

TEST(DataText, HasNullForWhatIsNoNumber) {
  EXPECT_EQ(data_text({NAN, std::numeric_limits<double>::infinity(), 0.5}), "[null,null,0.5]\n");
}

TEST(DataText, IsTheSameWhenItIsWrittenAgain) {
  Json data = {{"rows", Json::array()}, {"plain", Json::array()}};
  for (int i = 0; i < 300; ++i) {
    data["rows"].push_back({{"x", i / 7.0}, {"y", 10000000.4 / (i + 1)}, {"name", "a \"b\"\n"}});
    data["plain"].push_back(i / 9.0);
  }
  const std::string text = data_text(data);
  EXPECT_EQ(data_text(data_in(text)), text);
  // No line is long.
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 140U) << line;
}

TEST(DataText, ReadsDataInWhichNothingIsATable) {
  EXPECT_EQ(data_in("[{\"a\": 1.23456789}, {\"a\": 2}]").dump(), R"([{"a":1.23456789},{"a":2}])");
  EXPECT_THROW(data_in("{"), Json::exception);
}

}  // namespace
}  // namespace ricochet::report
