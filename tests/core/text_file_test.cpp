#include "src/core/text_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "src/core/error.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;

class TextFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string content(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }

  // Tests run side by side, each in a process of its own.
  fs::path folder_ =
      fs::path(testing::TempDir()) / ("ricochet_text_file_" + std::to_string(getpid()));
};

TEST_F(TextFile, ReplacesTheWholeFile) {
  const fs::path path = folder_ / "a.txt";
  write_text_file(path, "a long first text\n");
  write_text_file(path, "short\n");
  EXPECT_EQ(content(path), "short\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "no draft is left behind";
}

TEST_F(TextFile, RefusesAFolderAndAMissingFolderInOneLine) {
  for (const fs::path& path : {folder_, folder_ / "missing" / "a.txt"}) {
    try {
      write_text_file(path, "text");
      FAIL() << path;
    } catch (const InputError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find(path.string()), std::string::npos);
      EXPECT_EQ(message.find('\n'), std::string::npos);
    }
  }
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace ricochet
