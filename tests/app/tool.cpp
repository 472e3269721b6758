#include "tests/app/tool.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace ricochet::cli {

// What a command writes where its user stands is no other test's.
Outcome call_in_shell(const std::string& command) {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string stem =
      testing::TempDir() + fmt::format("ricochet_cli_{}_{}", test->test_suite_name(), test->name());
  std::filesystem::create_directories(stem + ".here");
  const int status = std::system(
      fmt::format("cd {}.here && ({}) >{}.out 2>{}.err", stem, command, stem, stem).c_str());
  return {WEXITSTATUS(status), read(stem + ".out"), read(stem + ".err")};
}

std::filesystem::path fresh_folder() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      fmt::format("ricochet_cli_{}_{}", test->test_suite_name(), test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

std::string read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::filesystem::path write(const std::filesystem::path& folder, const std::string& name,
                            const std::string& text) {
  std::ofstream(folder / name) << text;
  return folder / name;
}

Outcome call(const std::string& arguments) {
  return call_in_shell(fmt::format("{} {}", RICOCHET_PROGRAM, arguments));
}

Outcome call_with_output(const std::string& arguments, const std::string& output) {
  return call_in_shell(fmt::format("{} {} {}", RICOCHET_PROGRAM, arguments, output));
}

Outcome call_interrupted(const std::string& signal, const std::string& arguments, int seconds) {
  return call_in_shell(fmt::format("timeout --preserve-status --signal={} {} {} {}", signal,
                                   seconds, RICOCHET_PROGRAM, arguments));
}

void expect_refusal(const std::string& arguments, const std::string& complaint) {
  const Outcome outcome = call(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << arguments;
  EXPECT_EQ(outcome.out, "") << arguments;
  EXPECT_THAT(outcome.err, testing::HasSubstr(complaint)) << arguments;
  EXPECT_THAT(outcome.err, testing::StartsWith("ricochet: ")) << arguments;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

}  // namespace ricochet::cli
