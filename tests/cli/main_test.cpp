#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/tool.h"

namespace ricochet::cli {
namespace {

using testing::HasSubstr;

TEST(Main, NamesEveryCommandInItsHelp) {
  const Outcome help = call("--help");
  EXPECT_EQ(help.exit_code, 0);
  for (const char* command :
       {"reproduce", "dynamics", "simulate", "threshold", "scene", "list", "bench"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
    EXPECT_EQ(call(std::string(command) + " --help").exit_code, 0) << command;
  }
}

TEST(Main, TellsItsVersion) {
  EXPECT_THAT(call("--version").out, HasSubstr("ricochet 0.1.0"));
}

TEST(Main, RefusesWhatItDoesNotKnow) {
  expect_refusal("", "ommand");
  expect_refusal("hammer", "hammer is no command; allowed: reproduce, simulate");
  expect_refusal("simulate --case C1 --speed 3", "--speed");
  expect_refusal("simulate --case C1 --omega fast", "--omega");
  expect_refusal("threshold --case C1 --format xml", "--format");
}

}  // namespace
}  // namespace ricochet::cli
