#include "src/studies/machine/study.h"

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "src/studies/machine/design_parameters.h"
#include "tests/studies/pages.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using report::Results;

TEST(DesignParameter, IsThereForWhatTheMachineHas) {
  const auto named = [](const char* name) { return testing::Field(&DesignParameter::name, name); };
  const Scene scene = case_scene("C1");
  EXPECT_THAT(design_parameters_of(scene), ElementsAre(named("restitution"), named("friction"),
                                                       named("clearance"), named("disturbance")));
  EXPECT_THAT(
      design_parameters_of(with(scene, set::wall_upper(infinity), set::friction(0), set::pull(0))),
      ElementsAre(named("restitution"), named("friction")));
}

TEST(DesignParameter, LeavesMachinesValidAndUnchangedAtItsOwnValue) {
  for (const char* id : {"C1", "C2", "C9", "C11"}) {
    for (const double friction : {0.0, 0.4, 1.0}) {
      const Scene scene = with(case_scene(id), set::friction(friction));
      for (const DesignParameter& parameter : design_parameters_of(scene)) {
        EXPECT_EQ(parameter.value(0), parameter.own);
        EXPECT_EQ(write_scene(parameter.turned(scene, parameter.own)), write_scene(scene))
            << parameter.name;
        for (const double share : {-1.0, -0.5, 0.5, 1.0}) {
          const double value = parameter.value(share);
          EXPECT_NO_THROW(parse_scene(write_scene(parameter.turned(scene, value)), "turned"))
              << parameter.name << " " << value;
        }
      }
    }
  }
}

TEST(DesignParameter, TurnsBothWallsAndKeepsTheStartInItsPlace) {
  const Scene scene =
      with(case_scene("C1"), set::restitution_lower(0.4), set::restitution_upper(0.8));
  const auto parameters = design_parameters_of(scene);
  const Scene softer = parameters[0].turned(scene, 0.2);
  EXPECT_DOUBLE_EQ(softer.restitution_lower, 0.2);
  EXPECT_DOUBLE_EQ(softer.restitution_upper, 0.4);
  const Scene harder = parameters[0].turned(scene, 0.7);  // half way to 1
  EXPECT_DOUBLE_EQ(harder.restitution_lower, 0.7);
  EXPECT_DOUBLE_EQ(harder.restitution_upper, 0.9);
  const Scene wider = parameters[2].turned(scene, parameters[2].most);
  EXPECT_DOUBLE_EQ(wider.wall_upper, 2 * scene.wall_upper);
  EXPECT_DOUBLE_EQ(wider.start_position, 2 * scene.start_position);
}

TEST(QuietByScan, IsThatOfAFineScanWhereNothingNarrowLiesBelow) {
  for (const char* id : {"C1", "C3", "C5"}) {
    const Scene scene = case_scene(id);
    double omega = 1;
    while (omega <= 18 && measured(at_speed(scene, omega), Measure::collisions) <= 7) {
      omega *= 1.0005;
    }
    const double quiet = quiet_by_scan(scene, {Measure::collisions, 7}, {1, 18}).value();
    EXPECT_NEAR(quiet, omega, 2e-3 * quiet) << id;
  }
  const Scene scene = case_scene("C1");
  EXPECT_EQ(quiet_by_scan(scene, {Measure::collisions, 999}, {1, 18}), 18) << "all quiet";
  EXPECT_FALSE(quiet_by_scan(scene, {Measure::collisions, 0}, {1, 18})) << "all loud";
}

TEST(QuietByScan, OfTheLongRunIsTheBorder) {
  for (const auto& [id, relative_error] : {std::pair("C1", 1e-10), std::pair("C5", 2e-3)}) {
    const double border = *quiet_up_to(case_scene(id), 2);
    const Limit limit{Measure::collisions_per_turn, 2};
    EXPECT_NEAR(*quiet_by_scan(case_scene(id), limit, {1, 18, 1.02}) / border, 1, relative_error);
  }
}

TEST(DesignLines, HaveEachMachineChangedInOneDesignParameter) {
  const Scene scene = case_scene("C1");
  const QuietSpeed answer = quiet_speed(scene, {Limit{Measure::collisions, 7}, 1e-2, 18});
  const auto lines = design_lines(scene, answer);
  ASSERT_EQ(lines.size(), 4U);
  for (const auto& [parameter, values, quiet] : lines) {
    ASSERT_EQ(quiet.size(), DesignLine::points);
    EXPECT_NEAR(*quiet[10], *answer.fastest_quiet, 0.02);
    EXPECT_EQ(quiet[20], quiet_by_scan(parameter.turned(scene, parameter.most), *answer.limit,
                                       *coarse_scan(scene, answer)))
        << parameter.name;
  }
  EXPECT_NE(lines[1].quiet[20], lines[1].quiet[10]);
}

Results design_of(const Scene& scene) {
  const QuietSpeed answer = quiet_speed(scene, {std::nullopt, 1e-2, 18});
  Results results;
  add_design(design_lines(scene, answer), answer, coarse_scan(scene, answer), results);
  return results;
}

TEST(DesignLines, SayFirstWhatGivesMost) {
  const Scene scene = case_scene("C4");
  const Results results = design_of(scene);
  const Table& table = *results.table("design-parameters");
  ASSERT_EQ(table.rows.size(), 4U);
  const double own = number_in(*results.value("design-own")).value();
  double before = 1e9;
  each_row(table, [&](const Row& row) {
    const double best = row.number("best_quiet");
    EXPECT_LE(best, std::exchange(before, best));
    EXPECT_NEAR(row.number("best_change"), best / own - 1, 1e-12);
    EXPECT_TRUE(row.number("worst_quiet") <= own && own <= best) << best;
  });
  EXPECT_EQ(table[0].text("design_parameter"), "friction");
  // Twice the friction, as the longest of its line.
  const Scene rougher = with(scene, set::friction(2 * scene.friction));
  EXPECT_EQ(table[0].number("best"), rougher.friction);
  EXPECT_NEAR(table[0].number("best_quiet"), *quiet_up_to(rougher, 2), 1e-6);
  EXPECT_EQ(results.parts.at("design")[0].id, "friction");
}

TEST(DesignLines, AreMissingWhereNothingSaysWhatIsQuiet) {
  const Results results = design_of(planar_second_case());
  EXPECT_TRUE(results.table("design-parameters")->rows.empty());
  EXPECT_FALSE(results.parts.contains("design"));
  EXPECT_TRUE(is_missing(*results.value("design")));
}

/// As they are computed, with the six digits of data.json.
Results results_for(const Scene& scene, const QuietSpeedOptions& options) {
  return report::results_in(advice_study({"mine", scene, options, 0}).compute(false));
}

/// What is asked of C1 by default: it takes some seconds.
const Results& results_of_c1() {
  static const Results results = results_for(case_scene("C1"), {});
  return results;
}

constexpr double six_digits = 2e-6;

TEST(AdviceStudy, DrawsTheStaircaseWhereItIs) {
  const Scene scene = case_scene("C1");
  const Results results = results_for(scene, {Limit{Measure::collisions, 6}, 1e-3, 18});
  EXPECT_GT(results.chart("staircase")->series.at(0).samples.size(), 3U);
  const auto& energies = results.chart("energy")->series.at(0).samples;
  ASSERT_EQ(energies.size(), 300U);
  for (const report::Sample& sample : energies) {
    const double energy = 1e3 * measured(at_speed(scene, sample.position), Measure::energy);
    EXPECT_NEAR(*sample.value, energy, six_digits * energy);
  }
  EXPECT_FALSE(results.table("steps")->rows.empty());
  EXPECT_EQ(results.table("around")->rows.size(), 3U);
  EXPECT_TRUE(results.table("regimes")->rows.empty());
}

TEST(AdviceStudy, DrawsTheLongRunUnlessTheWindowIsLimitedAndThePathsBelowAndAbove) {
  const Results& results = results_of_c1();
  const auto regimes = regimes_of(case_scene("C1"));
  EXPECT_EQ(results.chart("staircase")->series.at(0).samples.size(), regimes.size() + 1);
  const Table& table = *results.table("regimes");
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(table[2].text("collisions"), "2");
  const auto near = [](double expected) {
    return testing::DoubleNear(expected, six_digits * expected);
  };
  EXPECT_THAT(table[2].number("to"), near(regimes[3].to));
  EXPECT_THAT(table[2].number("energy_per_turn"), near(regimes[3].last.energy_per_turn));
  EXPECT_THAT(table[2].number("fastest_impact"), near(regimes[3].last.fastest_impact));
  const auto& energies = results.chart("energy")->series.at(0).samples;
  ASSERT_EQ(energies.size(), 2 * regimes.size());
  EXPECT_THAT(*energies[7].value, near(1e3 * regimes[3].last.energy_per_turn));
  std::vector<double> counts;
  for (const report::Part& path : results.parts.at("paths")) {
    counts.push_back(number_in(*path.results.value("count")).value());
    EXPECT_EQ(path.results.chart("path")->series.at(1).samples.size(), counts.back()) << path.id;
  }
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_LT(counts[0], counts[1]);
}

TEST(AdviceStudy, SaysFirstWhatMovesTheSpeedMost) {
  const Table& changes = *results_of_c1().table("changes");
  const auto expected = sensitivities(case_scene("C1"), {Measure::collisions_per_turn, 2}, 8.08);
  ASSERT_GE(changes.rows.size(), 4U);
  ASSERT_LE(changes.rows.size(), expected.size());
  for (std::size_t i = 0; i < changes.rows.size(); ++i) {
    EXPECT_EQ(changes[i].text("constant"), expected[i].key);
    EXPECT_NEAR(changes[i].number("percent"), expected[i].percent, 1e-4);
  }
}

TEST(AdviceStudy, FillsItsPageWhateverTheAnswer) {
  const Scene c3 = case_scene("C3");
  const Results maxima =
      results_for(with(c3, set::rule(CountRule::peaks), set::peak_high(0.9 * c3.wall_upper),
                       set::peak_low(0.1 * c3.wall_upper)),
                  {Limit{Measure::collisions, 6}, 1e-2, 12});
  const Results doubtful =
      results_for(with(c3, set::wall_upper(0.8), set::seconds(1)), {std::nullopt, 1e-2, 5});
  for (const Results& results :
       {results_of_c1(), results_for(c3, {Limit{Measure::collisions, 99}, 1e-2, 4}),
        results_for(c3, {Limit{Measure::collisions, 0}, 1e-2, 4}), maxima, doubtful}) {
    const StudyPage page = study_page("advice", results);
    EXPECT_THAT(page.files.at("summary.md"), StartsWith("# How fast may mine turn?\n\nmine: "));
    EXPECT_THAT(page.terminal, StartsWith("mine: "));
  }
  EXPECT_THAT(ricochet::text_of(doubtful.table("doubts")->rows.at(0).at(0)),
              HasSubstr("0.8 m: walls so far apart"));
  ASSERT_FALSE(maxima.parts.at("paths").empty());
  for (const report::Part& path : maxima.parts.at("paths")) {
    EXPECT_EQ(*path.results.value("what-counts"), Value("maximum that counts"));
  }
}

}  // namespace
}  // namespace ricochet::studies::advice
