#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "src/core/names.h"

namespace ricochet {
namespace {

TEST(Name, IsOfLettersDigitsAndFourCharacters) {
  for (const std::string& name : std::vector<std::string>{"a", "C1", "nlopt-cobyla", "my_solver.2+",
                                                          "-x", std::string(60, 'x')}) {
    EXPECT_TRUE(is_name(name)) << name;
  }
  for (const std::string& text :
       std::vector<std::string>{"", "a b", "a/b", "..", ".hidden", "=cmd", "@SUM(1)", "'", "a'b",
                                "\x1b[31m", "\u202e", "\xc3\xa4", "a\n", std::string(61, 'x')}) {
    EXPECT_FALSE(is_name(text)) << text;
  }
}

}  // namespace
}  // namespace ricochet
