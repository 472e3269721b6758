#include "src/report/report.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "src/report/text.h"

namespace ricochet::report {
namespace {

namespace fs = std::filesystem;

class Report : public testing::Test {
 protected:
  Report()
      : folder_(fs::path(testing::TempDir()) /
                ("report_" + std::to_string(getpid()) + "_" +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {}
  ~Report() override { fs::remove_all(folder_); }

  Json data_of(const fs::path& folder) const {
    std::ifstream stream(folder_ / folder / "data.json", std::ios::binary);
    return data_in({std::istreambuf_iterator<char>(stream), {}});
  }

  fs::path folder_;
};

/// Results that no template fits: drawing them fails.
Json unfit(const char* report) {
  return {{"report", report}, {"computed", "for hours"}};
}

TEST_F(Report, KeepsDataThatCannotBeDrawn) {
  EXPECT_THROW(static_cast<void>(write_report(unfit("surrogate"), folder_)), std::logic_error);
  EXPECT_EQ(data_of("")["computed"], "for hours");
}

TEST_F(Report, KeepsTheDataOfAllPagesBeforeItDrawsTheFirst) {
  Json data = unfit("comparison");
  for (const char* name : {"one", "two"})
    data["pages"].push_back({{"folder", name}, {"data", unfit("comparison_family")}});
  EXPECT_THROW(static_cast<void>(write_report(data, folder_)), std::logic_error);
  EXPECT_EQ(data_of("")["pages"], (Json{"one", "two"}));
  for (const char* name : {"one", "two"}) EXPECT_EQ(data_of(name)["computed"], "for hours");
}

}  // namespace
}  // namespace ricochet::report
