#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "src/core/process.h"

namespace ricochet {
namespace {

TEST(Waiting, IsToldOnStandardErrorAndToWhoeverListens) {
  std::vector<std::string> told;
  on_waiting([&told](const std::string& text) { told.push_back(text); });
  testing::internal::CaptureStderr();
  tell_waiting("waiting for mine");
  tell_waiting("");
  on_waiting({});
  tell_waiting("again");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "waiting for mine\nagain\n");
  EXPECT_THAT(told, testing::ElementsAre("waiting for mine", ""));
}

}  // namespace
}  // namespace ricochet
