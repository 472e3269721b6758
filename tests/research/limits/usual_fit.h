#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "gtest/gtest.h"
#include "src/research/limits/goal_search.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::limits {

/// The default interpretation as a fit.
inline Fit usual_fit() {
  const carrier_track::FittedInterpretation& fitted = carrier_track::default_interpretation();
  return {fitted.interpretation, fitted.free, fitted.constants, 0, ""};
}

/// The file of a store that does not exist yet.
inline std::filesystem::path no_file_yet() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("limits_" + std::to_string(getpid()) + test->name() + ".toml");
  std::filesystem::remove(file);
  return file;
}

}  // namespace ricochet::studies::limits
