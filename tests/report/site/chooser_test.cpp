#include "src/report/site/chooser.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "src/report/site/entries.h"
#include "tests/report/site/made_up_reports.h"

namespace ricochet::site {
namespace {

const std::vector<FoundReport>& reference() {
  static const std::vector<FoundReport> reports =
      found_reports(std::filesystem::path(RICOCHET_SOURCE) / "reports/reference");
  return reports;
}

/// The page of the reference's comparison in that folder of the site.
const Json& page_data(const std::string& folder) {
  for (const FoundPage& page : largest_comparison(reference())->pages) {
    if (largest_comparison(reference())->folder + "/" + page.folder == folder) return page.data;
  }
  throw std::out_of_range(folder);
}

/// The success rate in the report's own data: of a family, or of a row under a perturbation.
double reported(const Situation& situation, const Choice& choice) {
  const Json& page = page_data(situation.folder);
  if (situation.perturbation == "plain") {
    for (const Json& budget : page["budgets"]) {
      if (budget["budget"] != situation.budget) continue;
      for (const Json& rating : budget["ratings"]) {
        const bool same =
            rating["solver"] == choice.solver && rating["formulation"] == choice.formulation;
        if (same) return rating["returned"];
      }
    }
    return -1;
  }
  std::size_t column = 0;
  while (page["perturbation_names"][column]["perturbation"] != situation.perturbation) ++column;
  const std::string entry = situation.family + ": " + choice.solver + ", " + choice.formulation;
  for (const Json& row : page["perturbation_rows"]) {
    if (row["entry"] == entry) return row["shares"][column];
  }
  return -1;
}

TEST(Chooser, SaysOfEveryEntryWhatTheComparisonsDataSay) {
  const Chooser chooser = chooser_of(*largest_comparison(reference()));
  std::size_t choices = 0;
  for (const Situation& situation : chooser.situations) {
    for (const Choice& choice : situation.entries) {
      EXPECT_EQ(choice.solved, reported(situation, choice))
          << situation.family << " " << situation.perturbation << " " << choice.solver;
      if (choice.lower) {
        EXPECT_LE(*choice.lower, choice.solved);
        EXPECT_GE(*choice.upper, choice.solved);
      }
      ++choices;
    }
  }
  EXPECT_GT(choices, 100U);
  EXPECT_EQ(chooser.troubles.size(), 9U);
}

TEST(Chooser, HasTheFirstEntriesOfEachFamilyByRank) {
  const Chooser chooser = chooser_of(*largest_comparison(reference()));
  for (const Situation& situation : chooser.situations) {
    if (situation.perturbation != "plain") continue;
    const Json& ratings = page_data(situation.folder)["budgets"][0]["ratings"];
    const auto first = std::ranges::find_if(ratings, [](const Json& rating) {
      return !rating["rank"].is_null() && rating["returned"] > 0;
    });
    EXPECT_EQ((*first)["solver"], situation.entries.front().solver) << situation.family;
    EXPECT_EQ(situation.problems,
              static_cast<std::int64_t>(page_data(situation.folder)["problems"].size()));
  }
}

TEST(Chooser, UnderAPerturbationHasTheEntryThatSolvesMost) {
  const Chooser chooser = chooser_of(*largest_comparison(reference()));
  for (const Situation& situation : chooser.situations) {
    if (situation.perturbation == "plain") continue;
    std::size_t column = 0;
    const Json& page = page_data(situation.folder);
    while (page["perturbation_names"][column]["perturbation"] != situation.perturbation) ++column;
    double most = 0;
    for (const Json& row : page["perturbation_rows"]) {
      if (row["family"] != situation.family || row["shares"][column].is_null()) continue;
      most = std::max(most, row["shares"][column].get<double>());
    }
    EXPECT_EQ(situation.entries.front().solved, most)
        << situation.family << " " << situation.perturbation;
  }
}

TEST(Chooser, KeepsTheFirstWithoutDerivativesToo) {
  Json data = small_comparison();
  data["solvers"] = Json::array();
  Json family = small_family();
  Json& ratings = family["budgets"][1]["ratings"];
  const Json rating = ratings[0];
  ratings = Json::array();
  for (const char* solver : {"a", "b", "c", "d", "plain-1", "plain-2", "plain-3", "plain-4"}) {
    ratings.push_back(rating);
    ratings.back()["solver"] = solver;
    const bool derivatives = std::string(solver).size() == 1;
    data["solvers"].push_back(
        {{"name", solver}, {"outside", false}, {"needs", derivatives ? "gradients" : "nothing"}});
  }
  const Chooser chooser = chooser_of(found_comparison(data, {family}));
  std::string solvers;
  for (const Choice& choice : chooser.situations.at(1).entries) solvers += choice.solver + " ";
  EXPECT_EQ(solvers, "a b c plain-1 plain-2 plain-3 ");
  EXPECT_TRUE(chooser.situations[1].entries[0].gradient);
  EXPECT_FALSE(chooser.situations[1].entries[3].gradient);
}

TEST(Chooser, LeavesOutWhoSolvedNothingAndMarksWhatIsTooEasy) {
  Json data = small_comparison();
  data["leaders"] = {{{"family", "count"}, {"budget", 100}, {"easy", true}, {"random", 4.5}}};
  Json family = small_family();
  family["budgets"][1]["ratings"][0]["returned"] = 0;
  const Chooser chooser =
      chooser_of(found_comparison(data, {family}), {{"co", "Short"}, {"count", "The count"}});
  EXPECT_EQ(chooser.situations.at(1).entries.at(0).solver, "mine");
  EXPECT_EQ(chooser.situations[1].random, 4.5);
  EXPECT_FALSE(chooser.situations[0].random);
  EXPECT_EQ(chooser.situations[0].title, "The count");
}

}  // namespace
}  // namespace ricochet::site
