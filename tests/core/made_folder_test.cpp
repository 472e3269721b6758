#include "src/core/made_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "src/core/error.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;

class MadeFolderTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(root_); }
  void TearDown() override { fs::remove_all(root_); }

  fs::path root_ =
      fs::path(testing::TempDir()) / ("ricochet_made_folder_" + std::to_string(getpid()));
};

TEST_F(MadeFolderTest, IsTakenBackWhereNothingIsPutIn) {
  {
    const MadeFolder made(root_ / "a" / "b");
    EXPECT_TRUE(fs::is_directory(root_ / "a" / "b"));
  }
  EXPECT_TRUE(fs::is_empty(root_));
  {
    const MadeFolder made(root_ / "a" / "b");
    std::ofstream(root_ / "a" / "mine") << "mine";
  }
  EXPECT_TRUE(fs::exists(root_ / "a" / "mine"));
  EXPECT_FALSE(fs::exists(root_ / "a" / "b"));
}

TEST_F(MadeFolderTest, IsRefusedWhereItCannotBe) {
  std::ofstream(root_ / "file") << "mine";
  fs::create_symlink("loop", root_ / "loop");
  for (const char* name : {"file", "file/deeper/still", "loop", "loop/deeper"})
    EXPECT_THROW(MadeFolder{root_ / name}, InputError) << name;
  EXPECT_EQ(std::distance(fs::directory_iterator(root_), {}), 2);
}

}  // namespace
}  // namespace ricochet
