#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>

#include "src/report/report.h"
#include "src/report/results.h"
#include "src/report/text.h"

/// What the committed comparison says of who is first, in several places, is one thing.
namespace ricochet::site {
namespace {

namespace fs = std::filesystem;
using report::Results;

const fs::path comparison = fs::path(RICOCHET_SOURCE) / "reports/reference/comparison";

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Results results_in_folder(const fs::path& folder) {
  return report::results_of(report::data_in(bytes_of(folder / "data.json")));
}

/// Calls `use` with the folder of each page.
template <class Use>
void each_page(const Use& use) {
  use(comparison);
  for (const auto& entry : fs::directory_iterator(comparison))
    if (entry.is_directory()) use(entry.path());
}

/// Calls `use` with each part of a family's page.
template <class Use>
void each_family(const Use& use) {
  each_page([&](const fs::path& folder) {
    const Results page = results_in_folder(folder);
    const auto parts = page.parts.find("families");
    if (parts == page.parts.end()) return;
    for (const report::Part& part : parts->second)
      if (part.results.parts.contains("budgets")) use(part);
  });
}

TEST(ReferenceComparison, HasOneFirstAndOneProbabilityOfEachFamily) {
  const Results main = results_in_folder(comparison);
  const Table& leaders = *main.table("leaders");
  int named = 0;
  each_family([&](const report::Part& part) {
    for (const report::Part& budget : part.results.parts.at("budgets")) {
      const Row leader = leaders
                             .find([&](const Row& row) {
                               return row.text("family") == part.id &&
                                      row.number("budget") == std::stod(budget.id);
                             })
                             .value();
      const Table ratings = sorted(*budget.results.table("ratings"), {"rank"});
      const Row first = ratings[0];
      EXPECT_EQ(first["rank"], (*budget.results.table("ratings"))[0]["rank"]) << "best first";
      if (is_missing(leader["solver"])) continue;  // none solves, or random search is enough
      ++named;
      EXPECT_EQ(leader["solver"], first["solver"]) << part.id;
      EXPECT_EQ(leader["formulation"], first["formulation"]) << part.id;
      EXPECT_EQ(leader["best"], first["best"]) << part.id;
      EXPECT_EQ(leader["returned"], first["returned"]) << part.id;
      const bool most = is_missing(leader["most"]);
      // Rates have three digits here: who solves hardly more is named, but looks as good.
      const Table more = where(ratings, [&](const Row& row) {
        const double ahead = row.number("returned") - first.number("returned");
        const bool is_first =
            row["solver"] == first["solver"] && row["formulation"] == first["formulation"];
        return !is_missing(row["rank"]) && !is_first && (most ? ahead > 0 : ahead >= 0);
      });
      EXPECT_EQ(most, more.rows.empty())
          << part.id << ": whoever solves more than the first is named beside it";
    }
  });
  EXPECT_GT(named, 10);
}

TEST(ReferenceComparison, SaysOfASolverWhereItIsFirst) {
  const Results main = results_in_folder(comparison);
  const Table leaders = where(*main.table("leaders"), "largest", true);
  const Results page = results_in_folder(comparison / "solvers");
  int firsts = 0;
  each_row(*page.table("solvers"), [&](const Row& solver) {
    std::string names;
    each_row(where(leaders, "solver", solver["solver"]), [&](const Row& row) {
      names += (names.empty() ? "" : ", ") + row.text("family");
      ++firsts;
    });
    EXPECT_EQ(solver.text("first"), names) << solver.text("solver");
  });
  EXPECT_GT(firsts, 10);
}

TEST(ReferenceComparison, MarksAFirstThatWasTunedToTheSuite) {
  const Results main = results_in_folder(comparison);
  int marked = 0;
  each_row(*main.table("leaders"), [&](const Row& row) {
    const std::string solver = row.text("solver");
    if (!solver.starts_with("continuation-") || solver.ends_with("-tuned")) return;
    EXPECT_EQ(row.text("tuned"), " (tuned to this suite)");
    ++marked;
  });
  EXPECT_GT(marked, 0);
}

bool has_interval(const report::Chart& chart) {
  for (const report::Series& series : chart.series)
    for (const report::Sample& sample : series.samples)
      if (sample.spread) return true;
  return false;
}

/// The charts of this name, in the results and their parts, that have no interval.
int charts_without(const Results& results, const std::string& name) {
  const report::Chart* chart = results.chart(name);
  int without = chart != nullptr && !has_interval(*chart) ? 1 : 0;
  for (const auto& [list, parts] : results.parts)
    for (const report::Part& part : parts) without += charts_without(part.results, name);
  return without;
}

TEST(ReferenceComparison, PromisesNoIntervalWhereAChartHasNone) {
  static const std::regex captioned(R"(\{\{chart ([a-z-]+)\}\}([^\n]*))");
  int promises = 0;
  each_page([&](const fs::path& folder) {
    const std::string kind = report::data_in(bytes_of(folder / "data.json")).at("report");
    const Results results = results_in_folder(folder);
    const std::string page = report::page_template(kind);
    for (std::sregex_iterator it(page.begin(), page.end(), captioned), end; it != end; ++it) {
      if ((*it)[2].str().find("interval") == std::string::npos) continue;
      ++promises;
      EXPECT_EQ(charts_without(results, (*it)[1]), 0) << folder << ": " << (*it)[1];
    }
  });
  EXPECT_GT(promises, 0);
}

/// The page of Robustness says that most runs fail that restart where a problem does in a part of
/// its box, even if they solved it before.
TEST(ReferenceComparison, HasMostRunsFailOnProblemsThatDo) {
  const Results page = results_in_folder(comparison / "robustness");
  const Table& endings = *page.table("pathological");
  for (const auto& [problem, ending] :
       {std::pair("throws", "threw"), {"hangs", "killed"}, {"crashes", "crashed"}}) {
    const Table rows = where(endings, "problem", "pathological-" + std::string(problem));
    ASSERT_EQ(rows.rows.size(), 1U) << problem;
    EXPECT_GT(rows[0].number(ending), 0.5 * rows[0].number("runs")) << problem;
    EXPECT_GT(rows[0].number("found"), rows[0].number("solved")) << problem;
  }
}

TEST(ReferenceComparison, IsReadInTwoEvenings) {
  int words = 0;
  each_page([&](const fs::path& folder) {
    std::istringstream text(bytes_of(folder / "summary.md"));
    for (std::string word; text >> word;) ++words;
  });
  EXPECT_GT(words, 5'000);
  EXPECT_LT(words, 50'000);
}

}  // namespace
}  // namespace ricochet::site
