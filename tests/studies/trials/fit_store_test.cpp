#include "src/studies/trials/fit_store.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "src/core/error.h"

namespace ricochet::studies::trials {
namespace {

std::filesystem::path fresh_store() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(testing::TempDir()) /
                      (std::string("trial_fits_") + std::to_string(getpid()) + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder / "fits.toml";
}

TEST(TrialFitStore, FindsWhatItWasGivenBitForBitAlsoAfterwards) {
  const auto file = fresh_store();
  TrialFit fit{{carrier_track::natural_constants(), {1.0 / 3, 1e-17}}, 1.0 / 7};
  fit.constants.base[2] = 1.0 / 9;
  {
    TrialFitStore store(file);
    EXPECT_FALSE(store.find("key"));
    store.add("key", fit);
    store.add("another", {{carrier_track::natural_constants(), {}}, 2});
  }
  const auto found = TrialFitStore(file).find("key");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->constants.base, fit.constants.base);
  EXPECT_EQ(found->constants.own, fit.constants.own);
  EXPECT_EQ(found->misfit, fit.misfit);
  EXPECT_TRUE(TrialFitStore(file).find("another")->constants.own.empty());
}

TEST(TrialFitStore, RefusesAFileOfSomethingElse) {
  for (const char* text : {"no toml [", "[[fit]]\nkey = 'a'\n", "[[trial]]\nkey = 'a'\n"}) {
    const auto file = fresh_store();
    std::ofstream(file) << text;
    EXPECT_THROW(TrialFitStore{file}, InputError) << text;
  }
}

}  // namespace
}  // namespace ricochet::studies::trials
