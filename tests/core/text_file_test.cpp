#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "tests/support/files.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;

class TextFile : public TemporaryFolder {
 protected:
  static std::string content(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
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

TEST_F(TextFile, KeepsTheModeOfTheFile) {
  const fs::path path = folder_ / "a.txt";
  write_text_file(path, "first\n");
  for (const fs::perms mode : {fs::perms{0600}, fs::perms{0755}}) {
    fs::permissions(path, mode);
    write_text_file(path, "second\n");
    EXPECT_EQ(fs::status(path).permissions(), mode);
  }
}

TEST_F(TextFile, LeavesAReadOnlyFileAlone) {
  const fs::path path = folder_ / "a.txt";
  write_text_file(path, "mine\n");
  fs::permissions(path, fs::perms{0444});
  EXPECT_THROW(write_text_file(path, "text\n"), InputError);
  EXPECT_EQ(content(path), "mine\n");
}

TEST_F(TextFile, ReplacesWhereALinkLeadsTo) {
  fs::create_directory(folder_ / "b");
  write_text_file(folder_ / "b" / "target.txt", "first\n");
  fs::create_symlink("b/target.txt", folder_ / "link");
  fs::create_symlink("link", folder_ / "link of link");
  fs::create_symlink("b/new.txt", folder_ / "dangling");
  write_text_file(folder_ / "link of link", "second\n");
  write_text_file(folder_ / "dangling", "third\n");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link") && fs::is_symlink(folder_ / "link of link"));
  EXPECT_EQ(content(folder_ / "b" / "target.txt"), "second\n");
  EXPECT_EQ(content(folder_ / "b" / "new.txt"), "third\n");
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_THROW(write_text_file(folder_ / "loop", "text"), InputError);
}

TEST_F(TextFile, IsWrittenThroughAPipe) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = content(pipe); });
  write_text_file(pipe, "text");
  reader.join();
  EXPECT_EQ(read, "text");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(TextFile, GoesIntoAnOpenDescriptorWhereItStands) {
  const fs::path path = folder_ / "a.txt";
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(write(descriptor, "before ", 7), 7);
  write_text_file("/dev/fd/" + std::to_string(descriptor), "text");
  ASSERT_EQ(write(descriptor, " after", 6), 6);
  close(descriptor);
  EXPECT_EQ(content(path), "before text after");
}

/// By its descriptor: a test that fails must not harm the device.
TEST_F(TextFile, ThatADeviceHasNoRoomForIsReported) {
  const int descriptor = open("/dev/full", O_WRONLY);
  EXPECT_THROW(write_text_file("/proc/self/fd/" + std::to_string(descriptor), "text"), OutputError);
  close(descriptor);
}

/// As on a disk that is full after a kilobyte, in a process of its own.
[[noreturn]] void write_with_a_limit(const fs::path& path) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{1000, 1000};
  setrlimit(RLIMIT_FSIZE, &limit);
  try {
    write_text_file(path, std::string(100000, 'x'));
  } catch (const OutputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::exit(1);
  }
  std::exit(0);
}

TEST_F(TextFile, ThatGrowsTooLargeLeavesTheOldOne) {
  const fs::path path = folder_ / "a.txt";
  write_text_file(path, "mine\n");
  EXPECT_EXIT(write_with_a_limit(path), testing::ExitedWithCode(1),
              "a.txt: cannot be written: File too large");
  EXPECT_EQ(content(path), "mine\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "no draft is left behind";
}

TEST_F(TextFile, IsNotDraftedIntoWhatAnotherHasPutThere) {
  const fs::path other = folder_ / "other.txt";
  write_text_file(other, "another's\n");
  for (int number = 0; number < 200; ++number) {  // the names that drafts get
    fs::create_symlink(other, folder_ / (".ricochet." + std::to_string(getpid()) + "." +
                                         std::to_string(number) + ".part"));
  }
  write_text_file(folder_ / "a.txt", "mine\n");
  EXPECT_EQ(content(folder_ / "a.txt"), "mine\n");
  EXPECT_EQ(content(other), "another's\n");
}

TEST_F(TextFile, DraftThatIsNotCommittedLeavesNoTrace) {
  { const TextDraft draft(folder_ / "a.txt", "text"); }
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace ricochet
