#include "src/core/name.h"

#include <gtest/gtest.h>

#include <string>

namespace ricochet {
namespace {

TEST(Name, IsOfLettersDigitsAndFourCharacters) {
  for (const char* name :
       {"a", "C1", "nlopt-cobyla", "my_solver.2+", "-x", std::string(60, 'x').c_str()}) {
    EXPECT_TRUE(is_name(name)) << name;
  }
  for (const char* text : {"", "a b", "a/b", "..", ".hidden", "=cmd", "@SUM(1)", "'", "a'b",
                           "\x1b[31m", "\u202e", "\xc3\xa4", "a\n", std::string(61, 'x').c_str()}) {
    EXPECT_FALSE(is_name(text)) << text;
  }
}

}  // namespace
}  // namespace ricochet
