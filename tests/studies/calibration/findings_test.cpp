#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "src/studies/calibration/results.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

RankedFit ranked(const Interpretation& interpretation, std::vector<Unknown> free, double loss) {
  Fit fit{{interpretation, std::move(free), natural_constants()}, loss};
  fit.constants[static_cast<std::size_t>(Unknown::pull)] = 1;
  Appraisal appraisal = appraise(fit, 1.0);
  return {std::move(fit), std::move(appraisal)};
}

/// Results that nobody computed: the page has to stand whatever they say.
Results some_results() {
  Results results;
  results.plan.search = some_search(1);
  Interpretation other;
  other.tension = Tension::rotating;
  results.interpretations = {ranked(Interpretation{}, unknowns_of(Interpretation{}), 20),
                             ranked(other, unknowns_of(other), 30)};
  results.frontier = {
      ranked(Interpretation{}, {Unknown::pull, Unknown::counting_limit, Unknown::phase}, 20),
      ranked(Interpretation{}, {Unknown::pull, Unknown::counting_limit}, 21)};
  results.chosen = 1;
  results.usual =
      ranked(default_interpretation().interpretation, default_interpretation().free, 29);
  results.plan.long_searches = LongSearches{{some_search(1).global}, {1, 2}, 800, 400, 2};
  for (const RankedFit& r : {results.frontier[1], results.interpretations[0]}) {
    results.convergence.push_back({800, {r.fit, r.fit}});
    results.converged.push_back({r});
  }
  for (const auto& [what, factor] :
       {std::pair(LeftOut::nothing, 1.1), std::pair(LeftOut::machine, 1.2),
        std::pair(LeftOut::restitution, 1.3), std::pair(LeftOut::friction, 1.4)}) {
    for (const Case& c : all_cases()) {
      if (!c.claim.threshold) continue;
      const double paper = *c.claim.threshold;
      results.predictions.push_back({what, c.id, paper, factor * paper});
    }
  }
  results.profiles = {{Unknown::pull, 1, 0.5, 2, false, true},
                      {Unknown::counting_limit, 0.01, 0.009, 0.02, false, false}};
  return results;
}

std::string page_of(const Results& results) {
  report::Results found = findings_of(results);
  for (const char* name : {"version", "date", "seconds", "threads"})
    found.set(std::string("made.") + name, name == std::string("seconds") ? 1.0 : 2.0);
  return filled_page(report::page_source(report::page_template("calibration")), found);
}

TEST(Findings, FillThePage) {
  const report::Results found = findings_of(some_results());
  for (const report::Chart& chart : found.charts) EXPECT_NO_THROW(check(chart)) << chart.name;
  const std::string page = page_of(some_results());
  for (const char* heading :
       {"left out of it", "fitted, and how well", "constants does the fit need", "other searches",
        "open question", "else checks", "made this report"})
    EXPECT_THAT(page, HasSubstr(heading));
  for (const char* chart : {"left-out", "error-against-constants"})
    EXPECT_THAT(page, HasSubstr("(" + std::string(chart) + ".svg)"));
}

TEST(Findings, LeaveOutWhatOneInterpretationDoesNotHave) {
  Results results = some_results();
  results.interpretations.pop_back();
  results.convergence.clear();
  results.converged.clear();
  const std::string page = page_of(results);
  EXPECT_THAT(page, Not(HasSubstr("other searches")));
  EXPECT_THAT(page, Not(HasSubstr("the closest is")));
  EXPECT_THAT(page, HasSubstr("constants does the fit need"));
}

TEST(Findings, BeginWithTheErrorsAndTheirInterval) {
  // All errors of a kind are equal here, so that every sample of them has the same.
  const auto percent = [](double factor) {
    return fmt::format("{:.0f} %", 100 * std::log(factor));
  };
  const report::Results found = findings_of(some_results());
  const std::string finding = std::get<std::string>(*found.value("finding"));
  EXPECT_THAT(finding, HasSubstr("2 constants are fitted"));
  EXPECT_THAT(finding, HasSubstr("speed is 9.5 % (95 % interval 9.5 to 9.5 %)"));
  EXPECT_THAT(finding, EndsWith(std::get<std::string>(*found.value("prediction"))));
  EXPECT_THAT(finding, HasSubstr("whole machine, a threshold is " + percent(1.2) + " off"));
  EXPECT_THAT(finding, HasSubstr("its restitution " + percent(1.3)));
  EXPECT_THAT(finding, HasSubstr("its friction " + percent(1.4) + "."));
}

TEST(Findings, CountARefitForEachGroup) {
  const Table table = *findings_of(some_results()).table("left-out");
  ASSERT_EQ(table.rows.size(), 4U);  // no case was left out alone
  EXPECT_EQ(table[0]["refits"], Value(std::int64_t{0}));
  EXPECT_EQ(table[1]["refits"], Value(std::int64_t{4}));
  EXPECT_EQ(table[2]["refits"], Value(std::int64_t{2}));
  EXPECT_NEAR(table[3].number("worst"), std::log(1.4), 1e-12);
}

TEST(Findings, CountThresholdsThatAFitDoesNotGive) {
  Results results = some_results();
  results.predictions.back().predicted.reset();
  const Table table = *findings_of(results).table("left-out");
  EXPECT_EQ(table[0].number("missing"), 0);
  EXPECT_EQ(table[3].number("missing"), 1);
  EXPECT_NEAR(table[3].number("worst"), std::log(2.0), 1e-12) << "it counts as one of ln 2";
}

TEST(Findings, SayWhatTheCurveOfFixedConstantsReads) {
  Results results = some_results();
  results.converged[0][0].appraisal.threshold_error = 0.0123;
  results.converged[0][0].appraisal.criterion = -1e3;  // is chosen
  results.frontier[1].appraisal.threshold_error = 0.0456;
  const report::Results found = findings_of(results);
  const report::Chart& chart = *found.chart("error-against-constants");
  const auto curve = std::ranges::find(chart.series, "fixed one by one", &report::Series::label);
  ASSERT_NE(curve, chart.series.end());
  const auto at = std::ranges::find(curve->samples, 2, &report::Sample::position);
  ASSERT_NE(at, curve->samples.end());
  const std::string read = fmt::format("{:.1f} %", at->value.value());
  EXPECT_EQ(read, "4.6 %");
  EXPECT_EQ(chart.title,
            "2 fitted constants: 1.2 % if searched at length, " + read + " if fixed one by one");
}

TEST(Findings, ShowTheNumbersOfTheResults) {
  const Results results = some_results();
  const report::Results found = findings_of(results);
  const Row r = (*found.table("interpretations"))[1];
  const Appraisal& a = results.interpretations[1].appraisal;
  EXPECT_EQ(r.text("interpretation"), name_of(results.interpretations[1].fit.interpretation));
  EXPECT_EQ(r.number("loss"), 30);
  EXPECT_EQ(r.number("error"), a.threshold_error);
  EXPECT_EQ(r.number("purity"), a.purity);
  EXPECT_EQ(r.number("loudness"), a.loudness);
  EXPECT_EQ(r.number("right_examples"), a.right_examples);
  EXPECT_EQ(r.number("criterion"), a.criterion);
  const Table& constants = *found.table("constants");
  const auto pull =
      constants.find([](const Row& row) { return row.text("constant") == "pull"; }).value();
  EXPECT_TRUE(pull.is("fitted"));
  EXPECT_EQ(pull.number("from"), 0.5);
  EXPECT_FALSE(pull.is("determined"));
  EXPECT_EQ(std::get<std::string>(*found.value("open-ends")),
            "The interval ends only where values are no longer allowed for: pull.");
}

TEST(Findings, SayWhichConstantIsFixedNextAndAtWhat) {
  const Table frontier = *findings_of(some_results()).table("frontier");
  EXPECT_EQ(frontier[0].text("fixed"), "none");
  EXPECT_EQ(frontier[1].text("fixed"), "phase = 0 rad");
}

TEST(Findings, ListOtherAnswersOnly) {
  const Table answers = *findings_of(some_results()).table("answers");
  ASSERT_EQ(answers.rows.size(), 1U);
  EXPECT_EQ(answers[0].text("closest"), "constant");
  EXPECT_EQ(answers[0].text("answer"), "rotating");
  EXPECT_EQ(answers[0].number("loss"), 30);
}

TEST(Findings, ShowWhereSearchesEndAlike) {
  Results results = some_results();
  results.convergence[1].fits[1].loss = 24;
  const report::Results found = findings_of(results);
  const Table& searches = *found.table("searches");
  ASSERT_EQ(searches.rows.size(), 2U);
  EXPECT_EQ(searches[0].number("best"), 20);  // by rising loss
  EXPECT_EQ(searches[0].number("nlopt-crs2-2"), 24);
  EXPECT_EQ(std::get<std::string>(*found.value("agreement")),
            "The 2 searches end within 1 % of the best of them in 1 of 2 rows.");
}

TEST(Findings, SayWithWhatOtherCommandsCompute) {
  Results results = some_results();
  EXPECT_THAT(page_of(results), HasSubstr(": 5 constants, loss 29.00 in place of"));
  results.usual = results.choice();
  EXPECT_THAT(page_of(results), Not(HasSubstr("Every other command")));
}

TEST(Findings, ChooseOfTheConvergedRowsTheOneWithTheLowestCriterion) {
  Results results = some_results();
  results.converged[0][0].appraisal.criterion = -20;
  results.converged[1][0].appraisal.criterion = -30;
  results.converged[0].push_back(results.converged[0][0]);
  results.converged[0][0].appraisal.threshold_error = 0.04;
  results.converged[0][1].appraisal.threshold_error = 0.123;
  EXPECT_EQ(&results.choice(), &results.converged[1][0]);
  const Table searches = *findings_of(results).table("searches");
  EXPECT_EQ(searches[1].number("as_good"), 2);
  EXPECT_EQ(searches[1].number("least_error"), 0.04);
  EXPECT_EQ(searches[1].number("largest_error"), 0.123);
  EXPECT_TRUE(searches[0].is("chosen"));
  EXPECT_FALSE(searches[1].is("chosen"));
  results.converged.clear();
  EXPECT_EQ(&results.choice(), &results.frontier[1]);
}

}  // namespace
}  // namespace ricochet::studies::calibration
