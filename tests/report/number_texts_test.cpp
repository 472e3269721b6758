#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "src/report/text.h"

namespace ricochet::report {
namespace {

namespace fs = std::filesystem;

TEST(Counted, HasThePluralBesideAllButOne) {
  EXPECT_EQ(counted(0, "run"), "0 runs");
  EXPECT_EQ(counted(1, "run"), "1 run");
  EXPECT_EQ(counted(2, "run"), "2 runs");
  EXPECT_EQ(counted(1, "entry", "entries"), "1 entry");
  EXPECT_EQ(counted(12, "entry", "entries"), "12 entries");
}

TEST(SecondsText, HasTheUnitThatMakesANumberOfAtLeastOne) {
  EXPECT_EQ(seconds_text(2.5e-7), "0.25 µs");
  EXPECT_EQ(seconds_text(1.25e-6), "1.25 µs");
  EXPECT_EQ(seconds_text(0.0123), "12.3 ms");
  EXPECT_EQ(seconds_text(1), "1 s");
  EXPECT_EQ(seconds_text(0.01234, 2), "12 ms");
}

/// What no reader should find, but for what follows a sign, a point or a hyphen, such as 0.1 turns.
std::string wrong_numbers(const std::string& text, bool digits) {
  static const std::regex plurals(
      "(^|[^-0-9.,/_A-Za-z])1 "
      "(borders|cases|collisions|columns|constants|cores|entries|evaluations|families|"
      "fits|impacts|instances|kinds|knots|levels|machines|methods|pages|pairs|parameters|points|"
      "problems|"
      "regimes|reports|rows|runs|scenes|searches|seeds|settings|simulations|solvers|speeds|starts|"
      "steps|"
      "stores|tools|turns|values|variables)\\b");
  static const std::regex microseconds("[0-9] us\\b");
  static const std::regex negative_differences("\\bby (-|−)[0-9]");
  static const std::regex too_exact("\\.[0-9]{13}");
  std::string wrong;
  for (const std::regex* pattern : {&plurals, &microseconds, &negative_differences, &too_exact}) {
    if (pattern == &too_exact && !digits) continue;
    for (std::sregex_iterator it(text.begin(), text.end(), *pattern), end; it != end; ++it)
      wrong += "\"" + it->str() + "\" after \"" +
               it->prefix().str().substr(std::max<std::size_t>(it->prefix().length(), 40) - 40) +
               "\"\n";
  }
  return wrong;
}

TEST(WrongNumbers, AreFound) {
  EXPECT_EQ(wrong_numbers("0.1 turns, 11 runs, 1 run, 1.5 us, by 3, one-1 runs, 0.0009", true),
            "\"5 us\" after \"0.1 turns, 11 runs, 1 run, 1.\"\n");
  for (const char* text :
       {"= 1 turns", "1 runs", "most, by -11", "by −0.5", "1.1 us", "0.0009000000000000001"})
    EXPECT_NE(wrong_numbers(text, true), "") << text;
  EXPECT_EQ(wrong_numbers("0.0009000000000000001", false), "");
}

TEST(ReferenceReports, HaveNumbersAsAReaderWritesThem) {
  int texts = 0;
  for (const auto& file : fs::recursive_directory_iterator(RICOCHET_SOURCE "/reports/reference")) {
    const bool summary = file.path().filename() == "summary.md";
    if (!summary && file.path().filename() != "data.json") continue;
    std::ifstream stream(file.path(), std::ios::binary);
    EXPECT_EQ(wrong_numbers({std::istreambuf_iterator<char>(stream), {}}, summary), "")
        << file.path();
    ++texts;
  }
  EXPECT_GT(texts, 30);
}

}  // namespace
}  // namespace ricochet::report
