#include <gtest/gtest.h>

#include <string>

#include "src/analysis/comparison/study.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

Json group(const std::string& family) {
  return {{"family", family},
          {"problems", {{{"problem", family + "-1"}}}},
          {"budgets",
           {{{"budget", 10}, {"leader", {{"solver", "early"}}}},
            {{"budget", 50}, {"leader", {{"solver", "late"}}}}}}};
}

Json fast(const std::string& family, const std::string& solver, double share, Json budget = 50) {
  return {{"family", family},
          {"solver", solver},
          {"share", share},
          {"budget", std::move(budget)},
          {"largest", true}};
}

/// What a comparison of two families finds; nothing of machines, nothing disturbed.
Json found() {
  Json all = {
      {"groups", {group("count"), group("hs")}},
      {"speed_accuracy",
       {fast("all", "scan", 0.9, nullptr), fast("count", "scan", 0.5), fast("hs", "scan", 0.25),
        fast("count", "walk", 1), fast("hs", "run", 0.75), fast("count", "run", 0.125)}},
      {"speed_accuracy_charts", {{{"family", "count"}}, {{"family", "hs"}}}},
      {"leaders", {1, 2}},
      {"unsure_effects", 0}};
  for (const char* key : {"profile_families", "pair_families", "log_ratio_families",
                          "break_even_families", "formulations", "ceilings"}) {
    all[key] = {{{"family", "hs"}, {"of", key}}};
  }
  for (const char* key :
       {"machines", "machine_maps", "landscapes", "turns", "effects", "main_effects",
        "perturbations", "perturbation_names", "perturbation_rows", "atlas", "atlas_maps"}) {
    all[key] = Json::array();
  }
  return all;
}

TEST(Pages, AreOneForEachFamilyWithItsRows) {
  const Json data = in_pages(found());
  ASSERT_EQ(data["pages"].size(), 2U);
  EXPECT_EQ(data["pages"][0]["folder"], "count");
  EXPECT_EQ(data["pages"][0]["data"]["report"], "comparison_family");
  EXPECT_TRUE(data["pages"][0]["data"]["formulations"].empty());
  const Json& hs = data["pages"][1]["data"];
  EXPECT_EQ(hs["formulations"][0]["of"], "formulations");
  EXPECT_EQ(hs["break_even_families"][0]["of"], "break_even_families");
  EXPECT_EQ(hs["speed_accuracy_charts"].size(), 1U);
  EXPECT_FALSE(data.contains("groups"));
  EXPECT_FALSE(data.contains("formulations"));
  EXPECT_FALSE(data.contains("atlas"));
  EXPECT_EQ(data["leaders"].size(), 2U);
  EXPECT_EQ(data["families"][0]["leader"]["solver"], "late") << "with the largest budget";
}

TEST(Pages, HaveAMapOfWhoSolvesWhat) {
  const Json map = in_pages(found())["map"];
  ASSERT_EQ(map.size(), 3U);
  EXPECT_EQ(map[0]["solver"], "run") << "takes both, and solves more than scan";
  EXPECT_EQ(map[0]["shares"], (Json{0.125, 0.75}));
  EXPECT_EQ(map[1]["solver"], "scan");
  EXPECT_EQ(map[2]["shares"], (Json{1.0, nullptr}));
}

TEST(Pages, ShowOneChartOfAllWhereFamiliesAreJoined) {
  EXPECT_EQ(in_pages(found())["speed_accuracy_charts"].size(), 2U);
  Json all = found();
  all["speed_accuracy_charts"].push_back({{"family", "all"}});
  EXPECT_EQ(in_pages(all)["speed_accuracy_charts"], (Json{{{"family", "all"}}}));
}

TEST(Pages, AreOfMachinesAndOfFailuresWhereThereAreAny) {
  Json all = found();
  all["turns"] = {{{"factor", "friction"}}};
  all["perturbations"] = {{{"perturbation", "nan"}}};
  all["atlas"] = {{{"machine", "C1"}}};
  const Json data = in_pages(all);
  ASSERT_EQ(data["pages"].size(), 4U);
  EXPECT_EQ(data["pages"][2]["folder"], "across-machines");
  EXPECT_EQ(data["pages"][2]["data"]["turns"], all["turns"]);
  EXPECT_EQ(data["pages"][3]["folder"], "failure-atlas");
  EXPECT_EQ(data["pages"][3]["data"]["atlas"], all["atlas"]);
}

}  // namespace
}  // namespace ricochet::studies::comparison
