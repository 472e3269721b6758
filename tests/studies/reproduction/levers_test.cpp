#include "src/studies/reproduction/levers.h"

#include <gmock/gmock.h>

#include <map>

#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"
#include "src/studies/paper/interpretation.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

const Scene& interpretation() {
  return default_interpretation().scene;
}

std::vector<ThresholdCurve> curves_of(const std::vector<Case>& cases, bool coarse) {
  return restitution_curves(cases, interpretation(), coarse, fastest_speed);
}

std::optional<double> threshold_of(const Scene& scene) {
  return quiet_up_to(scene, quiet_per_turn, {slowest_speed, fastest_speed});
}

/// Expects that the case's threshold is on the curve of its friction and disturbance.
void expect_on(const std::vector<ThresholdCurve>& curves, const Case& c) {
  int met = 0;
  for (const ThresholdCurve& curve : curves) {
    if (curve.machine.friction != c.friction || curve.machine.disturbance != c.disturbance)
      continue;
    for (const CurvePoint& point : curve.points) {
      if (point.value != c.restitution) continue;
      EXPECT_EQ(point.speed, threshold_of(scene_of(c, interpretation()))) << c.id;
      ++met;
    }
  }
  EXPECT_EQ(met, 1) << c.id;
}

TEST(ThresholdCurves, MeetThePapersCases) {
  std::vector<Case> undisturbed;
  for (const char* id : {"C1", "C2", "C3", "C4"}) undisturbed.push_back(find_case(id));
  const auto curves = curves_of(undisturbed, false);
  EXPECT_EQ(curves.size(), 2U);  // frictions
  for (const Case& c : undisturbed) expect_on(curves, c);
  expect_on(curves_of({find_case("C9")}, false), find_case("C9"));
}

TEST(ThresholdCurves, FallWithRestitution) {
  const auto curves = curves_of({find_case("C3"), find_case("C9")}, true);
  ASSERT_EQ(curves.size(), 2U) << "coarse ones have no disturbance";
  for (const ThresholdCurve& curve : curves) {
    EXPECT_EQ(curve.machine.disturbance, 0);
    EXPECT_EQ(curve.points.front().value, 0.05);
    EXPECT_EQ(curve.points.back().value, 0.95);
    for (std::size_t i = 2; i < curve.points.size(); ++i) {
      EXPECT_LT(curve.points[i].speed, curve.points[i - 1].speed);
    }
  }
  EXPECT_FALSE(curves[1].points.front().speed) << "friction 0.4: quiet at every speed tried";
}

TEST(ThresholdCurves, OverTheCountingLimitAndTheClearanceAreThoseOfSuchMachines) {
  const std::vector<Case> cases = {find_case("C1"), find_case("C9")};
  const double own = interpretation().counting_limit;
  const auto by_limit =
      curves_over("counting_limit", {1e-3, own, 10e-3}, cases, interpretation(), fastest_speed);
  ASSERT_EQ(by_limit.size(), 1U) << "only without disturbance";
  Scene scene = scene_of(cases[0], interpretation());
  EXPECT_EQ(by_limit[0].points[1].speed, threshold_of(scene));
  scene.counting_limit = 10e-3;
  EXPECT_NEAR(*by_limit[0].points[2].speed, *threshold_of(scene), 1e-9);
  EXPECT_LT(by_limit[0].points[0].speed, by_limit[0].points[1].speed);
  const auto by_clearance =
      curves_over("clearance", {1e-3}, cases, interpretation(), fastest_speed);
  scene = scene_of(cases[0], interpretation());
  scene.wall_upper = scene.wall_lower + 1e-3;
  scene.start_position = scene.wall_lower + 0.5e-3;
  EXPECT_NEAR(*by_clearance[0].points[0].speed, *threshold_of(scene), 1e-9);
}

/// Dimensions: lengths, times and masses have no scale of their own. Start and window do not matter
/// in the long run, and the pull hardly does.
TEST(Exponents, AddUpAsTheirDimensionsSay) {
  std::vector<QuietCase> cases;
  for (const char* id : {"C1", "C4", "C9"}) {
    const Case c = find_case(id);
    cases.push_back({c, threshold_of(scene_of(c, interpretation()))});
  }
  const Levers levers = levers_of(cases, interpretation(), true, fastest_speed);
  ASSERT_EQ(levers.exponents.size(), 2U) << "C9 is disturbed";
  for (const CaseExponents& one : levers.exponents) {
    std::map<std::string, double> of;
    for (const Sensitivity& s : one.exponents) of[s.key] = s.percent;
    const double drive = of["centrifugal_mass_radius"] + of["slider_mass_radius"];
    const double held = of["normal_force"] + of["pull"];
    EXPECT_NEAR(drive + held + of["clearance"] + of["counting_limit"], 0, 2e-3) << one.id;
    EXPECT_NEAR(of["mass"] + drive + held, 0, 2e-3) << one.id;
    EXPECT_NEAR(2 * held + of["counting_limit"], 1, 2e-3) << one.id;
    EXPECT_GT(std::abs(of["counting_limit"]), 0.1) << one.id;
  }
}

TEST(EndEffects, AreFromPairsThatDifferInOneConstant) {
  const auto machine = [](double restitution, double friction, double disturbance, double speed) {
    return QuietCase{{"", restitution, friction, disturbance, {}}, speed};
  };
  std::vector<QuietCase> cases = {machine(0.1, 0.4, 0, 12), machine(0.1, 0.4, 1, 11.4),
                                  machine(0.9, 0.4, 0, 4), machine(0.1, 0.1, 0, 8)};
  const auto restitution = effect_of(&Case::restitution, cases);
  ASSERT_TRUE(restitution);
  EXPECT_DOUBLE_EQ(restitution->most, 4.0 / 12);
  EXPECT_EQ(restitution->pairs, 1U);
  EXPECT_EQ(told(*restitution), "divides it by 3.0");
  EXPECT_EQ(told(*effect_of(&Case::friction, cases)), "multiplies it by 1.5");
  EXPECT_EQ(told(*effect_of(&Case::disturbance, cases)), "lowers it by 5.0 %");
  cases.push_back(machine(0.1, 0.1, 1, 8.8));
  EXPECT_EQ(told(*effect_of(&Case::disturbance, cases)), "changes it by -5.0 to +10.0 %");
  cases.pop_back();
  cases.pop_back();
  EXPECT_FALSE(effect_of(&Case::friction, cases)) << "one friction";
}

TEST(EndEffects, AreReadFromCurves) {
  const std::vector<ThresholdCurve> curves = {{{}, {{0.1, 8}, {0.5, 4}, {0.9, 2}}},
                                              {{}, {{0.1, 6}, {0.5, 3.8}, {0.9, 1}}},
                                              {{}, {{0.1, 10}, {0.5, 7}, {0.9, {}}}}};
  const auto effect = effect_of(curves, 0.1, 0.9);
  ASSERT_TRUE(effect);
  EXPECT_EQ(effect->pairs, 2U);
  EXPECT_EQ(told(*effect), "divides it by 4.0 to 6.0");
  EXPECT_FALSE(effect_of(curves, 0.1, 0.8));
}

}  // namespace
}  // namespace ricochet::studies::reproduction
