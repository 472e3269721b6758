#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/report/site/stated.h"

/// What README and the documents say of the paper's cases is what the report of them computed.
namespace ricochet::site {
namespace {

constexpr double rpm = 30 / std::numbers::pi;  // of 1 rad/s

/// The report of the paper's cases.
class Cases : public Committed {
 public:
  Cases() : Committed("reproduction") {}

  double speed(const char* a_case, const char* column) const {
    return row("thresholds", a_case).number(column);
  }
  double exponent(const char* constant, const char* a_case) const {
    return row("exponents", constant).number(a_case);
  }
  double parameter(const char* name) const { return row("parameters", name).number("value"); }
  /// The least and the most of a column, without C11 and C12, of which the paper says nothing.
  std::pair<double, double> extent(const char* name, const char* column) const {
    double least = HUGE_VAL, most = -HUGE_VAL;
    each_row(table(name), [&](const Row& row) {
      if (row.text("case") == "C11" || row.text("case") == "C12") return;
      least = std::min(least, row.number(column));
      most = std::max(most, row.number(column));
    });
    return {least, most};
  }
};

/// How far off the thresholds are that the fit does not know.
std::string prediction() {
  return Committed("calibration").text("prediction");
}

TEST(StatedNumbers, OfReadmeAreThoseOfThePapersCases) {
  const Cases cases;
  Prose readme = part_of("README.md", "**How fast?**", "**What is the paper's fireworks");
  readme.states(fmt::format(
      "silent up to {:.2f} rad/s, hits each wall once a turn up to {:.2f} rad/s ({:.0f} rpm)",
      cases.speed("C1", "silent_up_to"), cases.speed("C1", "quiet_up_to"),
      cases.speed("C1", "quiet_up_to") * rpm));
  const char* by_limit = "threshold-over-counting-limit";
  readme.states(fmt::format(
      "a fitted number, {:.2f} mm/s: with 1 mm/s that speed is {:.2f} rad/s, with 10 mm/s {:.2f}.",
      1e3 * cases.parameter("counting_limit"), cases.at(by_limit, "C1", 1),
      cases.at(by_limit, "C1", 10)));
  readme.states(
      fmt::format("One per cent more of it moves the speed by {:.2f} %, one per cent more "
                  "restitution by {:.2f} "
                  "%, one per cent more clearance by {:.2f} %.",
                  cases.exponent("counting limit", "C1"), cases.exponent("restitution", "C1"),
                  cases.exponent("clearance", "C1")));
  const auto [least, most] = cases.extent("thresholds", "threshold");
  readme.states(fmt::format("quiet up to {:.1f} to {:.1f} rad/s ({:.0f} to {:.0f} rpm)", least,
                            most, least * rpm, most * rpm));
  readme.states("within " + error_of_the_fit() + " as a root mean square in log speed");
  readme.states(fmt::format(
      "could come as close as {:.1f} %",
      100 * cases.row("bounds", "the same whatever the disturbance").number("root_mean_square")));
  EXPECT_EQ(cases.value("fitted"), 5) << "five parameters";
  readme.states(prediction());
  // Of docs/paper.md, which dates it:
  readme.states("agrees as well: 5.9 % (95 % interval 3.6 to 7.9 %)");
  EXPECT_EQ(readme.numbers_left(), "");
}

TEST(StatedNumbers, OfTheThresholdsOfThePaperAreThoseOfItsCases) {
  const Cases cases;
  Prose paper = part_of("docs/paper.md", "## Are the thresholds real?", "## Which border of");
  const auto [least, most] = cases.extent("thresholds", "threshold_error");
  paper.states(fmt::format("come out within {:.0f} %, with a root-mean-square error of {}",
                           100 * std::max(-least, most), error_of_the_fit()));
  int same = 0, climbs = 0, elastic = 0;
  each_row(cases.table("steps"), [&](const Row& row) {
    const auto claim = row.number_if("paper_quiet_count");
    same += claim && *claim == row.number("quiet_count");
    if (cases.speed(row.text("case").c_str(), "restitution") != 0.9) return;
    ++elastic;
    climbs += row.text("rise") == "a climb";
  });
  paper.states(fmt::format("Of the quiet counts {} of {:.0f} are the paper's", same,
                           cases.value("compared")));
  EXPECT_EQ(cases.text("examples"),
            "Of the 20 speeds that the paper's figures show as quiet or loud, 20 come out on the "
            "paper's side.");
  paper.states("all 20 example speeds lie on the side that its figures show");
  paper.states(
      fmt::format("mass radius is {:.2f} kg m", cases.parameter("centrifugal_mass_radius")));
  paper.states(
      fmt::format("the fitted clearance is {:.2f} mm", 1e3 * cases.parameter("clearance")));
  paper.states(fmt::format("The paper's thresholds fall from {} to {} rad/s",
                           cases.speed("C1", "paper_threshold"),
                           cases.speed("C9", "paper_threshold")));
  EXPECT_GE(cases.speed("C9", "threshold"), cases.speed("C1", "threshold")) << "the model's do not";
  paper.states(fmt::format(
      "as close as {:.1f} %",
      100 * cases.row("bounds", "the same whatever the disturbance").number("root_mean_square")));
  paper.states(fmt::format("as much as the fit does ({:.0f} % left out)",
                           100 * cases.value("formula.left_out")));
  EXPECT_NEAR(cases.value("formula.error"), cases.value("error"), 0.005);
  paper.states(fmt::format("climbs gradually in {} of {} cases", climbs, elastic));
  const Row a = cases.row("conclusions", "A"), b = cases.row("conclusions", "B"),
            c = cases.row("conclusions", "C");
  EXPECT_EQ(a.number("disagree") + b.number("disagree"), 0);
  paper.states(
      fmt::format("(A) holds between all {} neighbours that differ, and (B) between all {}",
                  a.number("agree"), b.number("agree")));
  paper.states(
      fmt::format("(C) fails between {} of {}, and from end to end the count rises by "
                  "{:.0f} % at most",
                  c.number("disagree"), c.number("agree") + c.number("disagree"),
                  100 * (c.number("strongest") - 1)));
  paper.states(prediction());
  // Of the paper, and words:
  paper.states("mass and radius give 0.078");
  paper.states("√((1 - e) / (1 + e))");
  paper.states("At restitution 0.9");
  EXPECT_EQ(paper.numbers_left(), "");

  Prose bounds =
      part_of("docs/paper.md", "## How close can any model come?", "## What is the fireworks");
  bounds.states(fmt::format("Not within {:.1f} % of all ten", 100 * cases.value("bound")));
  bounds.states(fmt::format(
      "Not within {:.1f} % if its thresholds fall in proportion",
      100 * cases.row("bounds", "falling in proportion to the disturbance, or more steeply")
                .number("largest")));
  // Of a search for several goals:
  bounds.states("a worst threshold 4.8 % off, or a root-mean-square error of 3.5 %");
  bounds.states("(2026-11-23, version 0.1.0)");
  EXPECT_EQ(bounds.numbers_left(), "");
}

TEST(StatedNumbers, OfTheBordersAreThoseOfThePapersCases) {
  const Cases cases;
  Prose paper =
      part_of("docs/paper.md", "### The borders of the machine", "## Which interpretation of");
  each_row(cases.table("thresholds"), [&](const Row& row) {
    const auto claim = row.number_if("paper_threshold");
    paper.states(fmt::format("| {} | {}, {}, {} | {:.3f} | {:.3f} | {:.3f} | {} |",
                             row.text("case"), row.number("restitution"), row.number("friction"),
                             row.number("disturbance"), row.number("silent_up_to"),
                             row.number("quiet_up_to"), row.number("loud_from"),
                             claim ? fmt::format("{}", *claim) : "-"));
  });
  paper.states(
      fmt::format("is {:.1f} % for the end of \"at most 2\", and {:.1f} % for the speed from "
                  "which every turn has more",
                  100 * cases.value("quiet_error"), 100 * cases.value("loud_error")));
  paper.states("to which the machine was fitted, has " + error_of_the_fit());
  paper.states(
      fmt::format("its counting limit of {:.2f} mm/s", 1e3 * cases.parameter("counting_limit")));
  paper.states(
      fmt::format("At {:.2f} rad/s the second impact of a throw in C1 becomes faster than "
                  "{:.2f} mm/s, a fitted number",
                  cases.speed("C1", "quiet_up_to"), 1e3 * cases.parameter("counting_limit")));
  paper.states(
      fmt::format("one per cent more of it moves that border by {:+.2f} %, as much as one "
                  "per cent less restitution ({:.2f} % for one more) and more than all "
                  "else, the clearance ({:.2f} %) first",
                  cases.exponent("counting limit", "C1"), cases.exponent("restitution", "C1"),
                  cases.exponent("clearance", "C1")));
  const char* by_limit = "threshold-over-counting-limit";
  paper.states(fmt::format("with 1 to 10 mm/s the border lies at {:.1f} to {:.1f} rad/s",
                           cases.at(by_limit, "C1", 1), cases.at(by_limit, "C1", 10)));
  paper.states(
      fmt::format("The quiet count {:.0f} of C1", cases.row("steps", "C1").number("quiet_count")));
  paper.states(fmt::format("At 1 N the end of silence falls from {:.2f} to {:.2f} rad/s",
                           cases.speed("C1", "silent_up_to"), cases.speed("C9", "silent_up_to")));
  paper.states(fmt::format("becomes a range from {:.2f} to {:.2f} rad/s instead of {:.2f}",
                           cases.speed("C9", "quiet_up_to"), cases.speed("C9", "loud_from"),
                           cases.speed("C1", "quiet_up_to")));
  paper.states("9.59 mJ a turn");  // see the tests of `ricochet regimes`
  EXPECT_EQ(paper.numbers_left(), "2 2 ") << "the heads of the table";
}

TEST(StatedNumbers, OfThePagesAboutRegimesAreThoseOfThePapersCases) {
  const Cases cases;
  Prose why = part_of("docs/threshold-and-regimes.md", "## Why is there a threshold?",
                      "## When is a count certain?");
  std::string steps;
  for (const double restitution : {0.1, 0.9}) {
    int all = 0, same = 0;
    each_row(cases.table("steps"), [&](const Row& row) {
      if (cases.speed(row.text("case").c_str(), "restitution") != restitution) return;
      ++all;
      same += row.text("rise") == (restitution < 0.5 ? "a step" : "a climb");
    });
    steps += fmt::format("{}{} of {}", steps.empty() ? "" : ", ", same, all);
  }
  EXPECT_EQ(steps, "5 of 6, 6 of 6");
  why.states(
      "At restitution 0.1 the increase is a step in 5 of 6 cases of the paper; at 0.9 it is a "
      "gradual climb in 6 of 6 cases");
  Prose map = part_of("docs/threshold-and-regimes.md",
                      "That is the machine of the paper's cases C1 and C2", "The map has");
  map.states(fmt::format("{} against {:.2f} rad/s at restitution 0.1, and {} against {:.2f} at 0.9",
                         cases.speed("C1", "paper_threshold"), cases.speed("C1", "quiet_up_to"),
                         cases.speed("C2", "paper_threshold"), cases.speed("C2", "quiet_up_to")));
  const char* over = "threshold-over-restitution";
  const char* curve = "friction 0.1, disturbance 0 N";
  map.states(
      fmt::format("between restitutions of 0.05 and 0.2 it falls from {:.1f} to {:.1f} rad/s",
                  cases.at(over, curve, 0.05), cases.at(over, curve, 0.2)));
}

/// What the page says in words, whatever is computed.
TEST(StatedNumbers, LimitAndRestitutionMoveThePapersCasesAlike) {
  const Cases cases;
  for (const char* id : {"C1", "C2", "C3", "C4"}) {
    const double limit = cases.exponent("counting limit", id);
    EXPECT_NEAR(limit + cases.exponent("restitution", id), 0, 0.03) << id;
    EXPECT_GT(limit, 0.3) << id;
    EXPECT_LT(cases.exponent("restitution", id), 0) << id;
    EXPECT_LT(cases.exponent("clearance", id), 0) << id;
    EXPECT_GT(cases.exponent("friction", id), 0) << id;
    EXPECT_GT(limit, std::abs(cases.exponent("clearance", id))) << id;
  }
  EXPECT_GT(3.6, cases.speed("C10", "threshold")) << "Figure 13 with restitution 0.9";
}

TEST(StatedNumbers, ThatNothingStatesAreFound) {
  Prose document("C1 at 8.08\nrad/s, `7`, [3](4.md) and 5.");
  document.states("at 8.08 rad/s");
  EXPECT_EQ(document.numbers_left(), "3 5 ");
}

}  // namespace
}  // namespace ricochet::site
