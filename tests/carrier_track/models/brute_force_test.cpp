#include "tests/carrier_track/models/brute_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "problems/carrier_track/check/oracle.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

/// Below, hops are shorter than a step of the brute force, and each side ends a Zeno sequence at
/// its own speed.
constexpr double slowest_compared = 1e-6;  // [m/s]

/// How far the impact model and the brute force agree over many scenes.
struct Agreement {
  std::size_t listed = 0;           ///< impacts of the brute force
  std::vector<double> time_errors;  ///< [s], of those compared
  double worst_share = 0;           ///< largest time error, as a share of its error bar
  int certain = 0;                  ///< scenes whose count is certain

  double quantile(double share) {
    std::sort(time_errors.begin(), time_errors.end());
    return time_errors[static_cast<std::size_t>(share * static_cast<double>(time_errors.size()))];
  }
};

/// Compares a scene with the brute force at two steps, one four times the other. Their difference
/// is by theory fifteen times the error of the finer one, and serves as the bar; impacts count
/// until it grows beyond 0.1 ms, where the path is lost.
void compare(const Scene& scene, double step, Agreement& agreement) {
  const Recording model = record(scene, 0.25, 0);
  const BruteForce fine = brute_force(scene, step);
  const std::vector<Impact> reference = faster(fine.impacts, slowest_compared);
  const std::vector<Impact> coarse = faster(brute_force(scene, 4 * step).impacts, slowest_compared);
  const std::vector<Impact> actual = faster(model.impacts, slowest_compared);
  // The bars' floors are what the hops too slow to be followed may take.
  double time_bar = 1e-8;
  double speed_bar = 1e-8;
  std::size_t k = 0;
  for (; k < std::min(reference.size(), coarse.size()); ++k) {
    const double difference = std::abs(reference[k].time - coarse[k].time);
    if (reference[k].wall != coarse[k].wall || difference > 1e-4) break;
    time_bar = std::max(time_bar, difference);
    speed_bar = std::max(speed_bar, std::abs(reference[k].speed - coarse[k].speed));
    ASSERT_LT(k, actual.size()) << "an impact is missing";
    ASSERT_EQ(actual[k].wall, reference[k].wall) << "impact " << k;
    ASSERT_NEAR(actual[k].time, reference[k].time, time_bar) << "impact " << k;
    ASSERT_NEAR(actual[k].speed, reference[k].speed, speed_bar) << "impact " << k;
    const double error = std::abs(actual[k].time - reference[k].time);
    agreement.time_errors.push_back(error);
    agreement.worst_share = std::max(agreement.worst_share, error / time_bar);
  }
  if (k == reference.size() && k == coarse.size()) {
    EXPECT_EQ(actual.size(), k) << "an impact too many";
    EXPECT_NEAR(model.end.position, fine.position, 1e-6);
  }
  agreement.listed += reference.size();
  if (!model.certainty.certain) return;
  ++agreement.certain;
  EXPECT_EQ(model.count, std::ssize(faster(fine.impacts, scene.counting_limit)));
}

void record_property(Agreement& agreement) {
  testing::Test::RecordProperty("impacts", std::to_string(agreement.listed));
  testing::Test::RecordProperty("compared", std::to_string(agreement.time_errors.size()));
  testing::Test::RecordProperty("median_ns", std::to_string(agreement.quantile(0.5) * 1e9));
  testing::Test::RecordProperty("0.9_quantile_ns", std::to_string(agreement.quantile(0.9) * 1e9));
  testing::Test::RecordProperty("worst_share_of_bar", std::to_string(agreement.worst_share));
  testing::Test::RecordProperty("certain", std::to_string(agreement.certain));
}

TEST(BruteForce, FindsTheImpactsOfRandomScenes) {
  RandomScenes scenes(1);
  Agreement agreement;
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    compare(scenes.next(), 1e-5, agreement);
    if (testing::Test::HasFatalFailure()) return;
  }
  record_property(agreement);
  EXPECT_GT(agreement.listed, 6000U);
  EXPECT_GT(agreement.time_errors.size(), agreement.listed * 95 / 100);
  EXPECT_GT(agreement.certain, 390);
  EXPECT_LT(agreement.quantile(0.5), 1e-9);
}

TEST(BruteForce, FindsTheImpactsOfEveryCase) {
  Agreement agreement;
  RandomScenes draws(2);
  for (const Case& a_case : all_cases()) {
    Scene scene = scene_of(a_case, exploratory_scene());
    for (int i = 0; i < 8; ++i) {
      scene.omega = draws.within(1.5, 18.0);
      SCOPED_TRACE(a_case.id + " at " + std::to_string(scene.omega));
      compare(scene, 4e-6, agreement);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  record_property(agreement);
  EXPECT_GT(agreement.time_errors.size(), agreement.listed * 95 / 100);
  EXPECT_GT(agreement.certain, 90);
}

TEST(BruteForce, ConvergesWithTheSquareOfItsStep) {
  // What makes it a reference: the bars above rest on this order.
  RandomScenes scenes(3);
  double coarse = 0;
  double fine = 0;
  for (int i = 0; i < 40; ++i) {
    Scene scene = scenes.next();
    scene.friction = 0;
    scene.restitution_lower = scene.restitution_upper = 0.5;
    const double exact = record(scene, 0.25, 0).end.position;
    coarse += std::abs(brute_force(scene, 4e-4).position - exact);
    fine += std::abs(brute_force(scene, 1e-4).position - exact);
  }
  EXPECT_NEAR(std::log2(coarse / fine) / 2, 2.0, 0.5);
}

}  // namespace
}  // namespace ricochet::carrier_track
