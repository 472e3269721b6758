#include "src/core/files.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

#include "tests/support/files.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

class TextFile : public TemporaryFolder {
 protected:
  /// Also of what a draft has left behind.
  auto number_of_files() const { return std::distance(fs::directory_iterator(folder_), {}); }

  const fs::path path_ = folder_ / "a.txt";
};

TEST_F(TextFile, ReplacesTheWholeFile) {
  write_text_file(path_, "a long first text\n");
  write_text_file(path_, "short\n");
  { const TextDraft not_committed(path_, "text"); }
  EXPECT_EQ(text_of(path_), "short\n");
  EXPECT_EQ(number_of_files(), 1);
}

TEST_F(TextFile, RefusesAFolderAndAMissingFolderInOneLine) {
  for (const fs::path& path : {folder_, folder_ / "missing" / "a.txt"}) {
    const std::string message = complaint_of([&] { return write_text_file(path, "text"), 0; });
    EXPECT_THAT(message, AllOf(HasSubstr(path.string()), Not(HasSubstr("\n"))));
  }
  EXPECT_EQ(number_of_files(), 0);
}

TEST_F(TextFile, KeepsTheModeOfTheFileAndLeavesAReadOnlyOneAlone) {
  write_text_file(path_, "first\n");
  for (const fs::perms mode : {fs::perms{0600}, fs::perms{0755}}) {
    fs::permissions(path_, mode);
    write_text_file(path_, "mine\n");
    EXPECT_EQ(fs::status(path_).permissions(), mode);
  }
  fs::permissions(path_, fs::perms{0444});
  EXPECT_THROW(write_text_file(path_, "text\n"), InputError);
  EXPECT_EQ(text_of(path_), "mine\n");
}

TEST_F(TextFile, ReplacesWhereALinkLeadsTo) {
  write_file(folder_ / "b" / "target.txt", "first\n");
  fs::create_symlink("b/target.txt", folder_ / "link");
  fs::create_symlink("link", folder_ / "link of link");
  fs::create_symlink("b/new.txt", folder_ / "dangling");
  write_text_file(folder_ / "link of link", "second\n");
  write_text_file(folder_ / "dangling", "third\n");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link") && fs::is_symlink(folder_ / "link of link"));
  EXPECT_EQ(text_of(folder_ / "b" / "target.txt"), "second\n");
  EXPECT_EQ(text_of(folder_ / "b" / "new.txt"), "third\n");
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_THROW(write_text_file(folder_ / "loop", "text"), InputError);
}

TEST_F(TextFile, IsWrittenThroughAPipe) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = text_of(pipe); });
  write_text_file(pipe, "text");
  reader.join();
  EXPECT_EQ(read, "text");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(TextFile, GoesIntoAnOpenDescriptorWhereItStands) {
  const int descriptor = open(path_.c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(write(descriptor, "before ", 7), 7);
  write_text_file("/dev/fd/" + std::to_string(descriptor), "text");
  ASSERT_EQ(write(descriptor, " after", 6), 6);
  close(descriptor);
  EXPECT_EQ(text_of(path_), "before text after");
}

/// By its descriptor: a test that fails must not harm the device.
TEST_F(TextFile, ThatADeviceHasNoRoomForIsReported) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const int descriptor = open("/dev/full", O_WRONLY);
  EXPECT_THROW(write_text_file("/proc/self/fd/" + std::to_string(descriptor), "text"), OutputError);
  close(descriptor);
}

/// As on a disk that is full after a kilobyte, in a process of its own.
[[noreturn]] void write_with_a_limit(const fs::path& path) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{1000, 1000};
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string said =
      complaint_of<OutputError>([&] { return write_text_file(path, std::string(100000, 'x')), 0; });
  std::fputs(said.c_str(), stderr);
  std::exit(1);
}

TEST_F(TextFile, ThatGrowsTooLargeLeavesTheOldOne) {
  write_text_file(path_, "mine\n");
  EXPECT_EXIT(write_with_a_limit(path_), testing::ExitedWithCode(1),
              "a.txt: cannot be written: File too large");
  EXPECT_EQ(text_of(path_), "mine\n");
  EXPECT_EQ(number_of_files(), 1);
}

TEST_F(TextFile, IsNotDraftedIntoWhatAnotherHasPutThere) {
  const fs::path other = write_file(folder_ / "other.txt", "another's\n");
  for (int number = 0; number < 200; ++number) {  // the names that drafts get
    fs::create_symlink(other, folder_ / (".ricochet." + std::to_string(getpid()) + "." +
                                         std::to_string(number) + ".part"));
  }
  write_text_file(path_, "mine\n");
  EXPECT_EQ(text_of(path_), "mine\n");
  EXPECT_EQ(text_of(other), "another's\n");
}

using MadeFolderTest = TemporaryFolder;

TEST_F(MadeFolderTest, IsTakenBackWhereNothingIsPutIn) {
  const fs::path outer = folder_ / "a", inner = outer / "b";
  for (const bool used : {false, true}) {
    {
      const MadeFolder made(inner);
      EXPECT_TRUE(fs::is_directory(inner));
      if (used) write_file(outer / "mine", "mine");
    }
    EXPECT_EQ(fs::exists(outer), used);
    EXPECT_EQ(fs::exists(outer / "mine"), used);
    EXPECT_FALSE(fs::exists(inner));
  }
}

TEST_F(MadeFolderTest, IsRefusedWhereItCannotBe) {
  write_file(folder_ / "file", "mine");
  fs::create_symlink("loop", folder_ / "loop");
  for (const char* name : {"file", "file/deeper/still", "loop", "loop/deeper"})
    EXPECT_THROW(MadeFolder{folder_ / name}, InputError) << name;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);
}

using Scratch = TemporaryFolder;

TEST_F(Scratch, FolderIsMadeAmongTemporaryOnesAndRemovedWithWhatIsInIt) {
  const char* const set = std::getenv("TMPDIR");
  const std::string before = set ? set : "/tmp";
  setenv("TMPDIR", folder_.c_str(), 1);
  {
    const ScratchFolder scratch, another;
    EXPECT_NE(scratch.path(), another.path());
    EXPECT_EQ(scratch.path().parent_path(), folder_);
    EXPECT_TRUE(fs::exists(write_file(scratch.path() / "within" / "file", "text")));
  }
  EXPECT_TRUE(fs::is_empty(folder_));
  setenv("TMPDIR", (folder_ / "missing").c_str(), 1);
  EXPECT_THROW(ScratchFolder(), OutputError);
  setenv("TMPDIR", before.c_str(), 1);
}

using FolderLocks = TemporaryFolder;

TEST_F(FolderLocks, AreHeldByOneProcessAlone) {
  const fs::path folder = folder_ / "out";
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
}

}  // namespace
}  // namespace ricochet
