#include <gtest/gtest.h>

#include <set>
#include <string>

#include "src/report/page_template.h"
#include "src/report/report.h"
#include "src/studies/calibration/results.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

RankedFit ranked(const Interpretation& interpretation, std::vector<Unknown> free, double loss) {
  Fit fit{interpretation, std::move(free), natural_constants(), loss, ""};
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
  results.plan.convergence = ConvergencePlan{{some_search(1).global}, {1, 2}, 800, 400, 2};
  for (const RankedFit& r : {results.frontier[1], results.interpretations[0]}) {
    Convergence& one = results.convergence.emplace_back();
    Fit far = r.fit;
    far.loss *= 1.5;
    one.evaluations = 800;
    one.parameterisation.interpretation = r.fit.interpretation;
    one.searches = {{"nlopt-crs2", 1, {far, r.fit, r.fit}}, {"nlopt-crs2", 2, {far, far, r.fit}}};
    results.converged.push_back({r});
  }
  results.predictions = {{"C1", 9, 8.5}, {"C2", 2, std::nullopt}};
  results.sensitivities = {{"C1", {0.5, std::nullopt}}, {"C2", {-1, 2}}};
  results.profiles = {
      {Unknown::pull, 1, 0.5, 2, false, true, {{0.5, 22}, {1, 21}, {2, 21.5}}},
      {Unknown::counting_limit, 0.01, 0.009, 0.02, false, false, {{0.009, 22}, {0.01, 21}}}};
  return results;
}

report::Json data_from(const Results& results) {
  report::Json data = data_of(results);
  data["made"] = {{"version", "1.2.3"}, {"seconds", 4.5}};
  return data;
}

report::DrawnPage drawing_of(const Results& results) {
  return report::drawn(report::page_template("calibration"), data_from(results));
}

/// Rows of the first table of a section.
const std::vector<std::vector<report::Cell>>& rows_of(const report::Page& page,
                                                      const std::string& id) {
  for (const report::Section& section : page.sections) {
    if (section.id == id) return section.tables.at(0).rows;
  }
  throw std::logic_error("no section " + id);
}

std::set<std::string> ids_of(const report::Page& page) {
  std::set<std::string> ids;
  for (const report::Section& section : page.sections) ids.insert(section.id);
  return ids;
}

TEST(ResultsData, FillTablesAndChartsThatHoldTogether) {
  const report::Page page = drawing_of(some_results()).page;
  std::set<std::string> charts;
  for (const report::Section& section : page.sections) {
    EXPECT_FALSE(section.paragraphs.empty()) << section.id;
    for (const report::Figure& figure : section.figures) {
      EXPECT_NO_THROW(report::check(figure.chart)) << figure.chart.name;
      EXPECT_TRUE(charts.insert(figure.chart.name).second) << figure.chart.name;
    }
    for (const report::Table& table : section.tables) {
      EXPECT_FALSE(table.rows.empty()) << section.id;
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    }
  }
  EXPECT_EQ(ids_of(page),
            (std::set<std::string>{"interpretations", "answers", "convergence", "frontier",
                                   "predictions", "constants", "origin"}));
  EXPECT_EQ(charts, (std::set<std::string>{"error-against-parameterisation", "sensitivity"}));
}

TEST(ResultsData, ShowTheNumbersOfTheResults) {
  const Results results = some_results();
  const report::Page page = drawing_of(results).page;
  const Appraisal& a = results.interpretations[1].appraisal;
  const auto& interpretation = rows_of(page, "interpretations").at(1);
  EXPECT_EQ(interpretation[0].text, name_of(results.interpretations[1].fit.interpretation));
  EXPECT_NEAR(std::stod(interpretation[3].text), 100 * a.threshold_error, 0.05);
  EXPECT_NEAR(std::stod(interpretation[8].text), a.loudness, 0.005);
  EXPECT_EQ(interpretation[9].text, std::to_string(a.right_examples) + " of 20");
  const auto& interval = rows_of(page, "constants").at(0);
  EXPECT_EQ(interval[2].text, "0.5");
  EXPECT_EQ(interval[3].text, "open, 2");
  EXPECT_EQ(interval[5].state, report::State::bad);
  EXPECT_EQ(rows_of(page, "constants").at(1)[5].state, report::State::good);
  const auto& prediction = rows_of(page, "predictions");
  EXPECT_EQ(prediction.at(0)[4].text, "-5.7");  // 100 ln(8.5 / 9)
  EXPECT_EQ(prediction.at(1)[4].text, "–");
}

TEST(ResultsData, SayWhichConstantIsHeldNextAndAtWhat) {
  const auto rows = rows_of(drawing_of(some_results()).page, "frontier");
  EXPECT_EQ(rows.at(0)[1].text, "none");
  EXPECT_EQ(rows.at(1)[1].text, "phase = 0 rad");
}

TEST(ResultsData, ShowWhereSearchesEndAlike) {
  Results results = some_results();
  results.convergence[1].searches[1].fits.back().loss = 24;
  EXPECT_EQ(data_from(results)["convergence"]["ties"].size(), 1U);
  const auto rows = rows_of(drawing_of(results).page, "convergence");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0][2].text, "20.00");  // by rising loss
  EXPECT_EQ(rows[0][3].text, "24.00");
  EXPECT_EQ(rows[0][6].text, "–");
  EXPECT_EQ(rows[0][6].state, report::State::bad);
  EXPECT_EQ(rows[1][1].text, "2");
  EXPECT_EQ(rows[1][2].text, "21.00");
  EXPECT_EQ(rows[1][4].text, "800");
  EXPECT_EQ(rows[1][5].text, "50, 50, 0");
  EXPECT_EQ(rows[1][6].text, "800");
  EXPECT_EQ(rows[1][6].state, report::State::good);
}

TEST(ResultsData, SayWithWhatOtherCommandsCompute) {
  Results results = some_results();
  const auto paragraph = [&] {
    for (const report::Section& section : drawing_of(results).page.sections) {
      if (section.id == "frontier") return section.notes.at(0);
    }
    return std::string();
  };
  EXPECT_NE(paragraph().find(name_of(default_interpretation().interpretation) +
                             " with 5 constants: loss 29.00"),
            std::string::npos)
      << paragraph();
  results.usual = results.choice();
  EXPECT_NE(paragraph().find("it is what every other command computes with"), std::string::npos);
}

TEST(ResultsData, ChooseOfTheConvergedRowsTheOneWithTheLowestCriterion) {
  Results results = some_results();
  results.converged[0][0].appraisal.criterion = -20;
  results.converged[1][0].appraisal.criterion = -30;
  results.converged[0].push_back(results.converged[0][0]);
  results.converged[0][0].appraisal.threshold_error = 0.04;
  results.converged[0][1].appraisal.threshold_error = 0.123;
  EXPECT_EQ(&results.choice(), &results.converged[1][0]);
  const auto rows = rows_of(drawing_of(results).page, "convergence");
  EXPECT_EQ(rows[1][7].text, "2");
  EXPECT_EQ(rows[1][8].text, "4.0 to 12.3");
  EXPECT_EQ(rows[1].back().state, report::State::neutral);
  EXPECT_EQ(rows[0].back().state, report::State::good);
  results.converged.clear();
  EXPECT_EQ(&results.choice(), &results.frontier[1]);
}

TEST(ResultsData, EndTheCommandWithTheRankedTable) {
  const std::string epilogue = drawing_of(some_results()).epilogue;
  const std::string name = name_of(Interpretation{});
  EXPECT_NE(epilogue.find("\n" + name + std::string(59 - name.size(), ' ')), std::string::npos)
      << epilogue;
  EXPECT_NE(epilogue.find("\n\nThe best interpretation, with fewer"), std::string::npos)
      << epilogue;
}

TEST(ResultsData, LeaveOutWhatOneInterpretationDoesNotHave) {
  Results results = some_results();
  results.interpretations.pop_back();
  results.convergence.clear();
  EXPECT_EQ(ids_of(drawing_of(results).page),
            (std::set<std::string>{"frontier", "predictions", "constants", "origin"}));
}

}  // namespace
}  // namespace ricochet::studies::calibration
