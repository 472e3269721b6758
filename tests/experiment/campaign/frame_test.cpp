#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <thread>

#include "src/experiment/service.h"

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

}  // namespace
}  // namespace ricochet
