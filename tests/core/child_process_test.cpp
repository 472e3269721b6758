#include "src/core/child_process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <thread>

namespace ricochet {
namespace {

TEST(Frame, IsReadAsItWasWrittenWhateverItsLength) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  std::mt19937_64 random(1);
  std::vector<std::string> messages = {"", std::string(1, '\0'), std::string(1'000'000, 'x')};
  for (int k = 0; k < 200; ++k) {
    std::string message(random() % 10'000, ' ');
    for (char& c : message) c = static_cast<char>(random());
    messages.push_back(message);
  }
  std::thread writer([&] {
    for (const std::string& message : messages) EXPECT_TRUE(write_frame(ends[1], message));
    close(ends[1]);
  });
  for (const std::string& message : messages) EXPECT_EQ(read_frame(ends[0]), message);
  EXPECT_EQ(read_frame(ends[0]), std::nullopt);
  writer.join();
  close(ends[0]);
}

TEST(Frame, IsNoneWhereItEndsWithinOrIsTooLong) {
  for (const std::string& bytes :
       {std::string("\5\0\0", 3), std::string("\5\0\0\0\0\0\0\0abcd", 12),
        std::string(8, '\xFF')}) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    ASSERT_EQ(write(ends[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    close(ends[1]);
    EXPECT_EQ(read_frame(ends[0]), std::nullopt);
    close(ends[0]);
  }
}

TEST(Frame, IsNotWrittenWhereNobodyReads) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  EXPECT_FALSE(write_frame(ends[1], "a"));
  std::signal(SIGPIPE, before);
  close(ends[1]);
}

TEST(Frame, IsTakenFromPiecesOfAnyLength) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  FrameReader reader;
  const std::string two = std::string("\3\0\0\0\0\0\0\0abc", 11) + std::string(8, '\0');
  for (const char byte : two.substr(0, 10)) {
    ASSERT_EQ(write(ends[1], &byte, 1), 1);
    EXPECT_TRUE(reader.read_from(ends[0]));
    EXPECT_EQ(reader.next(), std::nullopt);
  }
  ASSERT_EQ(write(ends[1], two.data() + 10, two.size() - 10), 9);
  EXPECT_TRUE(reader.read_from(ends[0]));
  EXPECT_EQ(reader.next(), "abc");
  EXPECT_EQ(reader.next(), "");
  EXPECT_EQ(reader.next(), std::nullopt);
  ASSERT_EQ(write(ends[1], std::string(8, '\xff').data(), 8), 8);
  EXPECT_FALSE(reader.read_from(ends[0])) << "no message has that length";
  close(ends[1]);
  close(ends[0]);
}

TEST(ChildProcess, AnswersUntilItIsTold) {
  ChildProcess child([](int descriptor) {
    while (const auto message = read_frame(descriptor)) write_frame(descriptor, *message + "!");
    _exit(7);
  });
  for (const std::string& message : {std::string("a"), std::string(300'000, 'b')}) {
    ASSERT_TRUE(child.tell(message));
    EXPECT_EQ(child.hear(), message + "!");
  }
  EXPECT_FALSE(child.has_news(std::chrono::steady_clock::now() + std::chrono::milliseconds(20)));
  EXPECT_EQ(WEXITSTATUS(child.finish()), 7);
  EXPECT_EQ(child.hear(), std::nullopt);
  EXPECT_FALSE(child.tell("a"));
}

TEST(ChildProcess, EndsWithAllThatItHasStartedWhenAsked) {
  ChildProcess child([](int descriptor) {
    write_frame(descriptor, "there");
    for (;;) pause();
  });
  EXPECT_EQ(child.hear(), "there");
  EXPECT_EQ(WTERMSIG(child.end()), SIGKILL);
}

}  // namespace
}  // namespace ricochet
