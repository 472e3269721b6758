#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace ricochet {

/// Tests in a folder of their own, which is empty at first. They run side by side, each in a
/// process of its own.
class TemporaryFolder : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("ricochet_core_" + std::to_string(getpid()));
};

}  // namespace ricochet
