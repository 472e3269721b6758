#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "problems/carrier_track/suite/speed_problems.h"
#include "src/studies/reproduction/study.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using testing::HasSubstr;

CaseStudy study_of(const char* id) {
  CaseStudy c{find_case(id), scene_of(find_case(id), default_interpretation().scene), {}, {}, {}};
  c.borders.quiet = quiet_up_to(c.scene, quiet_per_turn, {slowest_speed, fastest_speed});
  return c;
}

const report::Results& levers() {
  static const report::Results results = [] {
    report::Results made;
    add_levers({study_of("C1"), study_of("C4"), study_of("C9")}, default_interpretation(), true,
               fastest_speed, made);
    return made;
  }();
  return results;
}

const report::Series& curve(const char* chart, const std::string& label) {
  return *std::ranges::find(levers().chart(chart)->series, label, &report::Series::label);
}

double speed_at(const report::Series& series, double position) {
  return std::ranges::find(series.samples, position, &report::Sample::position)->value.value();
}

TEST(ThresholdCurves, MeetThePapersCasesAndFallWithRestitution) {
  const report::Series& rough =
      curve("threshold-over-restitution", "friction 0.4, disturbance 0 N");
  EXPECT_EQ(speed_at(rough, 0.9), study_of("C4").borders.quiet);
  EXPECT_EQ(speed_at(curve("threshold-over-restitution", "friction 0.1, disturbance 0 N"), 0.1),
            study_of("C1").borders.quiet);
  EXPECT_EQ(rough.samples.front().position, 0.05);
  EXPECT_FALSE(rough.samples.front().value) << "quiet at every speed tried";
  for (std::size_t i = 2; i < rough.samples.size(); ++i)
    EXPECT_LT(rough.samples[i].value, rough.samples[i - 1].value);
  const auto& all = levers().chart("threshold-over-restitution")->series;
  EXPECT_EQ(all.size(), 3U) << "coarse ones have no disturbance; and the paper's points";
  EXPECT_TRUE(all.back().dark);
}

TEST(ThresholdCurves, OverTheCountingLimitAreThoseOfSuchMachines) {
  const char* by_limit = "threshold-over-counting-limit";
  EXPECT_EQ(levers().chart(by_limit)->series.size(), 2U) << "only without disturbance";
  const report::Series& series = curve(by_limit, "C1: restitution 0.1, friction 0.1");
  const double own = default_interpretation().scene.counting_limit;
  EXPECT_EQ(speed_at(series, own / 1e-3), study_of("C1").borders.quiet);
  Scene scene = study_of("C1").scene;
  std::string speeds;
  for (const double limit : {1e-3, 3e-3, own, 10e-3}) {
    scene.counting_limit = limit;
    const double speed = *quiet_up_to(scene, quiet_per_turn, {slowest_speed, fastest_speed});
    EXPECT_EQ(speed_at(series, limit / 1e-3), speed);
    speeds += fmt::format("{}{:.2f}", speeds.empty() ? "" : limit == 10e-3 ? " and " : ", ", speed);
  }
  EXPECT_THAT(text_of(*levers().value("moves")), HasSubstr("C1 is quiet up to " + speeds));
  const double least = speed_at(series, 10) / speed_at(series, 1);
  EXPECT_THAT(levers().chart(by_limit)->title, HasSubstr(fmt::format("{:.1f} times", least)));
  EXPECT_EQ(levers().chart(by_limit)->lines.at(0).label, "fitted");
}

/// Dimensions: lengths, times and masses have no scale of their own. Start and window do not matter
/// in the long run, and the pull hardly does.
TEST(Exponents, AddUpAsTheirDimensionsSay) {
  const Table& exponents = *levers().table("exponents");
  EXPECT_FALSE(exponents.has("C9")) << "it is disturbed";
  for (const char* id : {"C1", "C4"}) {
    std::map<std::string, double> of;
    each_row(exponents, [&](const Row& row) { of[row.text("constant")] = row.number(id); });
    const double drive = of["centrifugal mass radius"] + of["slider mass radius"];
    const double held = of["normal force"] + of["pull"];
    EXPECT_NEAR(drive + held + of["clearance"] + of["counting limit"], 0, 5e-3) << id;
    EXPECT_NEAR(of["mass"] + drive + held, 0, 5e-3) << id;
    EXPECT_NEAR(2 * held + of["counting limit"], 1, 5e-3) << id;
    EXPECT_GT(std::abs(of["counting limit"]), 0.1) << id;
  }
}

TEST(Exponents, AreTheLargestFirstWithWhatIsKnown) {
  double largest = 10;
  std::set<std::string> fitted;
  each_row(*levers().table("exponents"), [&](const Row& row) {
    const double most = std::max(std::abs(row.number("C1")), std::abs(row.number("C4")));
    EXPECT_LE(most, largest);
    largest = most;
    if (row.text("known") == "fitted") fitted.insert(row.text("constant"));
  });
  EXPECT_EQ(fitted,
            (std::set<std::string>{"centrifugal mass radius", "clearance", "counting limit"}));
}

}  // namespace
}  // namespace ricochet::studies::reproduction
