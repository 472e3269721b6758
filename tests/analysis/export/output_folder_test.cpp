#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ricochet/error.h"
#include "src/analysis/export/output.h"
#include "tests/analysis/export/exported_store.h"

namespace ricochet::exports {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

using OutputFolderTest = TemporaryFolder;

TEST_F(OutputFolderTest, GetsAllOfItsFilesAtOnce) {
  OutputFolder out(folder_ / "new" / "out");
  write_file(out.draft() / "a", "1");
  fs::create_directory(out.draft() / "deep");
  write_file(out.draft() / "deep" / "b", "2");
  EXPECT_FALSE(fs::exists(folder_ / "new" / "out" / "a"));
  out.commit();
  EXPECT_EQ(text_of(folder_ / "new" / "out" / "a"), "1");
  EXPECT_EQ(text_of(folder_ / "new" / "out" / "deep" / "b"), "2");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "new" / "out"), {}), 2);
}

TEST_F(OutputFolderTest, LeavesNoTraceWhereNothingComesOfIt) {
  {
    const OutputFolder out(folder_ / "new" / "out");
    write_file(out.draft() / "a", "1");
  }
  EXPECT_TRUE(fs::is_empty(folder_));
  fs::create_directory(folder_ / "mine");
  {
    const OutputFolder out(folder_ / "mine");
    write_file(out.draft() / "a", "1");
  }
  EXPECT_TRUE(fs::is_empty(folder_ / "mine")) << "the user's own folder stays";
}

TEST_F(OutputFolderTest, IsRefusedWhereSomethingIs) {
  write_file(folder_ / "file", "mine");
  for (const fs::path& path : {folder_, folder_ / "file"}) {
    EXPECT_THAT([&] { OutputFolder{path}; },
                ThrowsMessage<InputError>(HasSubstr("must be a folder that is new or empty")));
  }
  EXPECT_THROW(OutputFolder(folder_ / "file" / "below"), InputError);
  EXPECT_EQ(text_of(folder_ / "file"), "mine");
}

TEST_F(OutputFolderTest, HasNoFileTwice) {
  write_file(folder_ / "file", "mine");
  EXPECT_THROW(write_file(folder_ / "file", "other"), InputError);
  EXPECT_EQ(text_of(folder_ / "file"), "mine");
}

}  // namespace
}  // namespace ricochet::exports
