#include "tests/solvers/outside/scripts.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace ricochet::outside {

std::filesystem::path fresh_folder() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder =
      std::filesystem::path(testing::TempDir()) /
      (std::string("ricochet_outside_") + test->test_suite_name() + "_" + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

std::string script(const std::filesystem::path& folder, const std::string& lines) {
  std::ofstream(folder / "script.sh") << "HERE=" << folder.string() << "\n" << lines << "\n";
  return "sh " + (folder / "script.sh").string();
}

std::string read(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

}  // namespace ricochet::outside
