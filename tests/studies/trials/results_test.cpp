#include "src/studies/trials/results.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "solvers/solvers.h"
#include "src/report/page_template.h"
#include "src/report/report.h"

namespace ricochet::studies::trials {
namespace {

using report::Json;

JudgedTrial with_misfits(const std::string& name, bool brief, std::vector<double> misfits) {
  JudgedTrial judged{{}, 1, {}, {}};
  judged.trial.name = name;
  judged.trial.brief = brief;
  for (const double misfit : misfits) judged.fits.push_back({{}, misfit});
  return judged;
}

TEST(TrialResults, CallATrialNearerIfAllItsSearchesAre) {
  Results results;
  results.baselines = {with_misfits("nothing", false, {30, 28}),
                       with_misfits("nothing-brief", true, {40, 40})};
  EXPECT_TRUE(results.is_nearer(with_misfits("a", false, {27, 27.9})));
  EXPECT_FALSE(results.is_nearer(with_misfits("a", false, {20, 28.1})));
  const JudgedTrial dear = with_misfits("a", true, {30, 35});
  EXPECT_EQ(results.baseline_of(dear).trial.name, "nothing-brief");
  EXPECT_TRUE(results.is_nearer(dear));
}

TEST(TrialResults, TellTheShareOfSpeedsThatDiffer) {
  EXPECT_EQ(differing_share({1, {1, 2, 3, 4}}, {1, {1, 2, 3, 5}}), 0.25);
}

/// No search at all.
const Json& some_results() {
  static const Json made = [] {
    TrialPlan plan{{all_solvers().front(), all_solvers().front(), 0}, 0, {1, 2}, 1.0, 4.5, {1, 2}};
    const auto folder =
        std::filesystem::path(testing::TempDir()) / ("trial_results_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    TrialFitStore store(folder / "fits.toml");
    Json data = data_of(try_all(plan, store));
    data["made"] = {{"version", "1"}, {"threads", 2}, {"seconds", 1.5}};
    return data;
  }();
  return made;
}

TEST(TrialResults, FillTheirPage) {
  const report::DrawnPage drawn = report::drawn(report::page_template("trials"), some_results());
  std::set<std::string> ids, charts;
  for (const report::Section& section : drawn.page.sections) {
    EXPECT_TRUE(ids.insert(section.id).second) << section.id;
    EXPECT_FALSE(section.paragraphs.empty()) << section.id;
    for (const report::Table& table : section.tables) EXPECT_FALSE(table.rows.empty());
    for (const report::Figure& figure : section.figures) {
      EXPECT_NO_THROW(report::check(figure.chart));
      EXPECT_TRUE(charts.insert(figure.chart.name).second) << figure.chart.name;
    }
  }
  EXPECT_EQ(ids, (std::set<std::string>{"trials", "claims", "integration", "draws", "origin"}));
  EXPECT_EQ(drawn.page.intro.front().substr(0, 6), "Found:");
}

TEST(TrialResults, SetEachClaimBesideThePapers) {
  const Json& claims = some_results()["claims"];
  EXPECT_EQ(claims[0]["name"], "the paper");
  EXPECT_EQ(claims[0]["claims"][2]["threshold"], 13.0);
  EXPECT_EQ(claims[0]["claims"][2]["count"], 5);
  EXPECT_EQ(claims.size(), 1 + some_results()["rows"].size());
  for (const Json& row : claims) EXPECT_EQ(row["claims"].size(), 10U);
  EXPECT_EQ(some_results()["draws"].size(), 6U) << "C5 to C10";
  EXPECT_EQ(some_results()["integrations"].size(), 2U);
}

}  // namespace
}  // namespace ricochet::studies::trials
