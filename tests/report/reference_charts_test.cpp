#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/report/read_svg.h"

/// All charts that are committed.
namespace ricochet::report {
namespace {

namespace fs = std::filesystem;

TEST(ReferenceCharts, HaveTheirTextsWholeAndInThePicture) {
  int charts = 0;
  for (const auto& file : fs::recursive_directory_iterator(RICOCHET_SOURCE "/reports/reference")) {
    if (file.path().extension() != ".svg") continue;
    const fs::path name = file.path().filename();
    if (name == "machine-sketch.svg" || name == "machine.svg")
      continue;  // drawn by hand, in groups
    std::ifstream stream(file.path(), std::ios::binary);
    const ReadSvg svg({std::istreambuf_iterator<char>(stream), {}});
    EXPECT_EQ(svg.cut_texts(), "") << file.path();
    ++charts;
  }
  EXPECT_GT(charts, 100);
}

}  // namespace
}  // namespace ricochet::report
