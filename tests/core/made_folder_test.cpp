#include <gtest/gtest.h>

#include <fstream>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "tests/support/files.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;

using MadeFolderTest = TemporaryFolder;

TEST_F(MadeFolderTest, IsTakenBackWhereNothingIsPutIn) {
  {
    const MadeFolder made(folder_ / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b"));
  }
  EXPECT_TRUE(fs::is_empty(folder_));
  {
    const MadeFolder made(folder_ / "a" / "b");
    std::ofstream(folder_ / "a" / "mine") << "mine";
  }
  EXPECT_TRUE(fs::exists(folder_ / "a" / "mine"));
  EXPECT_FALSE(fs::exists(folder_ / "a" / "b"));
}

TEST_F(MadeFolderTest, IsRefusedWhereItCannotBe) {
  std::ofstream(folder_ / "file") << "mine";
  fs::create_symlink("loop", folder_ / "loop");
  for (const char* name : {"file", "file/deeper/still", "loop", "loop/deeper"})
    EXPECT_THROW(MadeFolder{folder_ / name}, InputError) << name;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);
}

}  // namespace
}  // namespace ricochet
