#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "ricochet/error.h"
#include "src/core/files.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;

TEST(FolderLock, IsHeldByOneProcessAlone) {
  const fs::path folder =
      fs::path(testing::TempDir()) / ("ricochet_folder_lock_" + std::to_string(getpid())) / "out";
  {
    const FolderLock lock(folder);
    EXPECT_THROW(FolderLock second(folder), InputError);
  }
  EXPECT_EXIT(
      {
        const FolderLock lock(folder);
        std::abort();
      },
      testing::KilledBySignal(SIGABRT), "");
  EXPECT_NO_THROW(FolderLock{folder}) << "who was killed holds nothing";
  fs::remove_all(folder.parent_path());
}

}  // namespace
}  // namespace ricochet
