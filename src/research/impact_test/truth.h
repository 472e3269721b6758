#pragma once

#include <optional>
#include <vector>

#include "ricochet/random.h"
#include "src/research/impact_test/test_scene.h"

namespace ricochet::studies::impact_test {

/// An impact as it truly happens, to 1e-12 s, and how well it is conditioned.
struct TrueImpact {
  double time;  ///< [s]
  Wall wall;
  double speed;  ///< [m/s], of approach
  /// By how much the time [s] and the speed [m/s] change with a relative change of all numbers of
  /// the scene, divided by that change: the largest of a few changes of random signs.
  double time_sensitivity, speed_sensitivity;
};

/// The true impacts of a scene, faster than half of `slowest`, in order of time: those up to
/// `slowest` are not scored, but a tool may have them a little faster.
using Truth = std::vector<TrueImpact>;

/// Simulates in 80-bit numbers (oracle.h) and returns all impacts faster than half of `slowest`
/// [m/s]; without sensitivities. Nothing if the oracle gives up.
std::optional<std::vector<carrier_track::Impact>> exact_impacts(const TestScene& scene);

/// The same with sensitivities, up to the end of the scene or to where the scene stops being well
/// conditioned: before the first impact that appears, vanishes or changes its place in the order
/// when the numbers change by 1e-10, or whose time moves by more than `most_growth` mean times
/// between impacts per relative change. Nothing if the oracle gives up.
struct Conditioned {
  Truth impacts;
  double good_until;  ///< [s]
};
std::optional<Conditioned> conditioned_truth(const TestScene& scene, Random& random);

/// A relative change of 1e-5 then moves an impact by 1 % of the mean time between impacts at most.
inline constexpr double most_growth = 1e3;

/// The mean time between the scored impacts [s].
double mean_time_between(const TestScene& scene, const Truth& truth);

/// The number of impacts faster than `slowest`.
int scored_impacts(const TestScene& scene, const Truth& truth);

}  // namespace ricochet::studies::impact_test
