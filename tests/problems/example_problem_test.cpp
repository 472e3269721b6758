#include "tests/problems/example_problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/carrier_track/gradients/differences.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream stream(RICOCHET_SOURCE "/" + file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ExampleProblem, IsWhatContributingShows) {
  const std::string text = text_of("CONTRIBUTING.md");
  const std::string fence = "```cpp\n";
  const auto start = text.find(fence) + fence.size();
  const std::string code = text.substr(start, text.find("```", start) - start);
  EXPECT_GT(code.size(), 500U);
  EXPECT_THAT(text_of("tests/problems/example_problem.cpp"), testing::HasSubstr(code));
}

TEST(ExampleProblem, HasDerivatives) {
  const Problem problem = gentle_problem(machine_of(find_case("C1"), exploratory_scene()));
  EXPECT_EQ(problem.name, "gentle-C1");
  expect_derivatives_of_values(problem, Vector::Constant(1, 4.321), 1e-7, 1e-6);
}

}  // namespace
}  // namespace ricochet::carrier_track
