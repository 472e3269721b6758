#include "src/research/calibration/variant_results.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "ricochet/solvers.h"

namespace ricochet::studies::calibration {
namespace {

using report::Json;

JudgedVariant with_losses(const std::string& name, bool brief, std::vector<double> losses) {
  JudgedVariant judged{{}, 1, {}, {}};
  judged.variant.name = name;
  judged.variant.brief = brief;
  for (const double loss : losses) judged.fits.push_back({{}, {}, {}, loss, ""});
  return judged;
}

TEST(VariantResults, CallAVariantNearerIfAllItsSearchesAre) {
  VariantResults results;
  results.baselines = {with_losses("nothing", false, {30, 28}),
                       with_losses("nothing-brief", true, {40, 40})};
  EXPECT_TRUE(results.is_nearer(with_losses("a", false, {27, 27.9})));
  EXPECT_FALSE(results.is_nearer(with_losses("a", false, {20, 28.1})));
  const JudgedVariant dear = with_losses("a", true, {30, 35});
  EXPECT_EQ(results.baseline_of(dear).variant.name, "nothing-brief");
  EXPECT_TRUE(results.is_nearer(dear));
}

TEST(VariantResults, SetEachVariantBesideItsBaseline) {
  // No search at all.
  const VariantPlan plan{
      {all_solvers().front(), {}, all_solvers().front(), 0}, 0, {1, 2}, 1.0, 4.5, {1, 2}};
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("variants_" + std::to_string(getpid()) + ".toml");
  std::filesystem::remove(file);
  FitStore store(file);
  const VariantResults results = try_variants(plan, store);
  const auto loss = [](const JudgedVariant& each) { return each.best().loss; };
  EXPECT_TRUE(std::ranges::is_sorted(results.variants, {}, loss));
  const Json data = data_of(results);
  EXPECT_EQ(data["tried"], 12);
  ASSERT_EQ(data["rows"].size(), 3U + 12);
  EXPECT_EQ(data["rows"][0]["name"], "nothing");
  EXPECT_TRUE(data["rows"][0]["gain"].is_null());
  for (const Json& row : data["rows"]) {
    EXPECT_EQ(row["claims"].size(), 10U);
    EXPECT_EQ(row["errors"].size(), 10U);
    if (row["gain"].is_null()) continue;
    EXPECT_EQ(row["gain"], row["base_loss"].get<double>() - row["loss"].get<double>());
  }
  EXPECT_EQ(data["draws"].size(), 6U) << "C5 to C10";
  EXPECT_EQ(data["integrations"].size(), 2U);

  // Goes on from the file, to the same.
  const auto written = std::filesystem::last_write_time(file);
  FitStore again(file);
  EXPECT_EQ(data_of(try_variants(plan, again)).dump(), data.dump());
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
}

}  // namespace
}  // namespace ricochet::studies::calibration
