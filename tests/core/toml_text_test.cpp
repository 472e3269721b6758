#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "ricochet/error.h"
#include "src/core/toml.h"

namespace ricochet {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string complaint_about(const std::string& text) {
  try {
    parse_toml(text, "file");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// A key of so many names.
std::string key_of(int names) {
  std::string key = "a";
  for (int i = 1; i < names; ++i) key += i % 2 == 0 ? ".a" : " . \"a\"";
  return key;
}

TEST(TomlText, ShowsAValueInOneLine) {
  const toml::table table = parse_toml(
      "value = ['word', \"it's\", -3, 0.1, 2.0, true, [], [[1]], {a = 1}, 1979-05-27, "
      "07:32:05.5, 1979-05-27T07:32:05Z]",
      "file");
  EXPECT_EQ(toml_value(*table.get("value")),
            "[ 'word', \"it's\", -3, 0.1, 2.0, true, [], [ [ 1 ] ], {...}, 1979-05-27, 07:32:05, "
            "1979-05-27T07:32:05 ]");
}

TEST(TomlText, GivesAKeyTodaysName) {
  toml::table table = parse_toml("old = 1\nboth = 2\nnew_both = 3", "file");
  testing::internal::CaptureStderr();
  rename_key(table, "old", "new", "file: ");
  rename_key(table, "both", "new_both", "file: ");
  rename_key(table, "absent", "new_absent", "file: ");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: file: old is now called new\n");
  EXPECT_EQ(table, parse_toml("new = 1\nboth = 2\nnew_both = 3", "file"));
}

TEST(TomlText, RefusesAKeyOfTooManyNames) {
  EXPECT_EQ(complaint_about("[" + key_of(deepest_toml) + "]"), "accepted");
  EXPECT_EQ(complaint_about(key_of(deepest_toml) + " = 1"), "accepted");
  for (const int names : {deepest_toml + 1, 50'000}) {
    for (const std::string& text : {"[" + key_of(names) + "]", "[[" + key_of(names) + "]]",
                                    key_of(names) + " = 1", "x = {" + key_of(names) + " = 1}"}) {
      EXPECT_THAT(complaint_about("x_1 = 1\n" + text),
                  StartsWith("file:2: a key has more than 32 names"));
    }
  }
}

TEST(TomlText, TakesKeysOfManyNamesOneInTheOther) {
  // The deepest that the limits leave: the reader has one of its own for values within values.
  std::string text = "x = ";
  for (int i = 0; i < 250; ++i) text += "{" + key_of(deepest_toml) + " = ";
  text += "1" + std::string(250, '}');
  EXPECT_EQ(complaint_about(text), "accepted");
  EXPECT_THAT(complaint_about("x = " + std::string(100'000, '[')), HasSubstr("nested"));
}

TEST(TomlText, TakesNumbersAndRemarksWithAnyNumberOfDots) {
  std::string list = "x = [";
  for (int i = 0; i < 1000; ++i) list += "[0.5, 1.5], ";
  EXPECT_EQ(complaint_about(list + "]"), "accepted");
  EXPECT_EQ(complaint_about("x = 1  # " + std::string(200, '.')), "accepted");
}

TEST(TomlText, RefusesATextThatIsTooLong) {
  std::string text = "#" + std::string(longest_toml - 1, 'x');
  EXPECT_EQ(complaint_about(text), "accepted");
  EXPECT_EQ(complaint_about(text + "x"), "file: too long: must have at most 4000000 bytes");
}

}  // namespace
}  // namespace ricochet
