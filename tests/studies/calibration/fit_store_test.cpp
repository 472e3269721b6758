#include "src/studies/calibration/fit_store.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "src/core/error.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

std::filesystem::path fresh_file() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      (std::string("fits_") + std::to_string(getpid()) + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder / "fits.toml";
}

Fit some_fit() {
  const FittedReading& fitted = default_reading();
  Fit fit{fitted.reading, {Open::pull, Open::slowest}, fitted.constants, 1.0 / 3.0, "C2"};
  fit.constants[0] = 1.0 / 7.0;
  return fit;
}

TEST(FitStore, FindsWhatItWasGivenBitForBitAlsoAfterwards) {
  const auto file = fresh_file();
  {
    FitStore store(file);
    EXPECT_FALSE(store.find("key"));
    store.add("key", some_fit());
  }
  const auto found = FitStore(file).find("key");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->constants, some_fit().constants);
  EXPECT_EQ(found->misfit, 1.0 / 3.0);
  EXPECT_EQ(found->freed, some_fit().freed);
  EXPECT_EQ(found->reading, some_fit().reading);
  EXPECT_EQ(found->left_out, "C2");
}

TEST(FitStore, RefusesAFileOfSomethingElse) {
  for (const char* text : {"not toml at all [", "[scene]\nmass = 1\n", "[[fit]]\nkey = 'a'\n"}) {
    const auto file = fresh_file();
    std::ofstream(file) << text;
    EXPECT_THROW(FitStore{file}, InputError) << text;
  }
}

TEST(FitStore, HasAKeyForEverythingThatDecides) {
  const Freedom freedom = some_freedom();
  const Search search = some_search(10);
  const std::string key = key_of("fit", freedom, search, "");
  EXPECT_EQ(key_of("fit", freedom, search, ""), key);
  EXPECT_NE(key_of("pin", freedom, search, ""), key);
  EXPECT_NE(key_of("fit", freedom, search, "C1"), key);
  EXPECT_NE(key_of("fit", freedom, some_search(11), ""), key);
  Search other = search;
  other.seed = 2;
  EXPECT_NE(key_of("fit", freedom, other, ""), key);
  Freedom moved = freedom;
  moved.held[0] *= 1 + 1e-15;
  EXPECT_NE(key_of("fit", moved, search, ""), key);
  moved = freedom;
  moved.freed.pop_back();
  EXPECT_NE(key_of("fit", moved, search, ""), key);
}

}  // namespace
}  // namespace ricochet::studies::calibration
