#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include "src/core/files.h"
#include "tests/support/files.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;

/// With TMPDIR in a folder of the test.
class Scratch : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    if (const char* set = std::getenv("TMPDIR")) before_ = set;
    setenv("TMPDIR", folder_.c_str(), 1);
  }
  ~Scratch() override { before_ ? setenv("TMPDIR", before_->c_str(), 1) : unsetenv("TMPDIR"); }

 private:
  std::optional<std::string> before_;
};

TEST_F(Scratch, FolderIsRemovedWithWhatIsInIt) {
  fs::path path;
  {
    const ScratchFolder scratch;
    const ScratchFolder another;
    path = scratch.path();
    EXPECT_NE(path, another.path());
    EXPECT_EQ(path.parent_path(), folder_);
    fs::create_directory(path / "within");
    std::ofstream(path / "within" / "file") << "text";
    EXPECT_TRUE(fs::exists(path / "within" / "file"));
  }
  EXPECT_FALSE(fs::exists(path));
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(Scratch, FolderThatCannotBeMadeIsAnErrorOfTheSystem) {
  setenv("TMPDIR", (folder_ / "missing").c_str(), 1);
  EXPECT_THROW(ScratchFolder(), OutputError);
}

}  // namespace
}  // namespace ricochet
