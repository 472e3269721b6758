#include <gtest/gtest.h>

#include "src/core/names.h"

namespace ricochet {
namespace {

TEST(Label, IsNotReadAsAMissingValue) {
  EXPECT_EQ(label("nan"), "missing-value");
  for (const char* missing : {"NA", "N/A", "n/a", "NaN", "-nan", "null", "NULL", "None", "<NA>"}) {
    EXPECT_EQ(label(missing), "'" + std::string(missing));
  }
}

TEST(Label, IsTheTextOtherwise) {
  for (const char* text : {"", "plain", "none", "nano", "banana", "NAN", "nlopt-cobyla"}) {
    EXPECT_EQ(label(text), text);
  }
}

}  // namespace
}  // namespace ricochet
