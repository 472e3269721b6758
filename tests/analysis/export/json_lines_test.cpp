#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "src/analysis/export/formats.h"
#include "tests/analysis/export/exported_store.h"

namespace ricochet::exports {
namespace {

using nlohmann::json;
using JsonLines = ExportedStore;

TEST_F(JsonLines, HaveEveryRun) {
  write_json(store, {}, out);
  const auto lines = lines_of(text_of(out / "runs.jsonl"));
  ASSERT_EQ(lines.size(), records.size());
  auto expected = records.begin();
  for (const std::string& line : lines) {
    const json run = json::parse(line);
    const auto& [key, record] = *expected++;
    EXPECT_EQ(run["key"]["problem"], key.cell.problem);
    EXPECT_EQ(run["key"]["solver"], key.cell.solver);
    EXPECT_EQ(run["key"]["instance"], key.instance);
    EXPECT_EQ(run["seed"], record.seed);
    EXPECT_EQ(run["failure"], record.failure);
    EXPECT_EQ(run["ledger"]["charged"], record.ledger.charged);
    EXPECT_TRUE(run["seconds_allowed"].is_null());
    EXPECT_EQ(run["terminations"][0]["starts"], 2);
    const double optimality_gap = optimality_gap_after(key, 1'000'000'000);
    EXPECT_EQ(run["verdict"]["solved"], optimality_gap <= problem(key.cell.problem).tolerance);
    ASSERT_EQ(run["improvements"].size(), record.trace.size());
    for (std::size_t k = 0; k < record.trace.size(); ++k) {
      const Improvement& step = record.trace[k];
      EXPECT_EQ(run["improvements"][k],
                json({step.evaluations, step.seconds, step.true_values.objective,
                      step.true_values.violation}));
    }
    EXPECT_EQ(run["returned"].is_null(), !record.returned);
  }
}

TEST_F(JsonLines, ComeWithTheCampaign) {
  write_json(store, {}, out);
  const json campaign = json::parse(text_of(out / "campaign.json"));
  EXPECT_EQ(campaign["plan"], description.plan);
  EXPECT_EQ(campaign["problems"][0]["factors"]["disturbance"], 1.0 / 3);
  EXPECT_EQ(campaign["solvers"][2]["name"], description.solvers[2].name);
}

TEST_F(JsonLines, AreValidWhateverBytesATextHas) {
  RunRecord record;
  record.failure = "\xff\xfe";
  add({{"wide", "original", "plain", "nlopt-cobyla", 99, "n"}, 1, 0}, record);
  write_json(store, {}, out);
  for (const std::string& line : lines_of(text_of(out / "runs.jsonl"))) {
    EXPECT_TRUE(json::accept(line)) << line;
  }
}

}  // namespace
}  // namespace ricochet::exports
