#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "src/report/json.h"
#include "src/report/table.h"

namespace ricochet::studies::advice {

/// How many of a window's collisions the start causes.
struct StartShare {
  double omega;  ///< [rad/s]
  double turns;  ///< of the window
  int count;     ///< collisions in the window
  int of_start;  ///< those beyond what the motion after the window has in as many turns, rounded

  /// Returns true if the count says more about the start than about the motion that follows.
  bool dominates() const { return of_start >= 2 && 10 * of_start > count; }
};

/// Counts in the window and in the ten turns after it.
StartShare start_share(const carrier_track::Scene& scene, double omega);

/// The share at the speed [rad/s], of some near the answer, at which the start causes most; nothing
/// without speeds.
std::optional<StartShare> largest_start_share(const carrier_track::Scene& scene,
                                              const std::vector<double>& speeds);

/// What an engineer should know beside the answer, one line each: the restitutions if the walls
/// differ, the speed up to which friction holds the carrier, and whether the
/// window is too short, by the start's share in it.
std::vector<std::string> notes_on(const carrier_track::Scene& scene,
                                  const std::optional<StartShare>& share);

/// Revolutions per minute of 1 rad/s.
inline constexpr double rpm = 30 / std::numbers::pi;

/// "7.2 rad/s (68.8 rpm)"
std::string both_units(double omega);

/// The fastest quiet speed of a machine, with all results reported about it.
struct QuietSpeedAnswer {
  std::string name;
  carrier_track::Scene scene;
  carrier_track::QuietSpeed answer;
  std::vector<carrier_track::Sensitivity>
      sensitivities;  ///< empty if no speed divides quiet from loud
  double tolerance = 0;
  std::optional<carrier_track::ToleranceRange> range;
  std::optional<carrier_track::UncertainDivide> uncertain;  ///< by the file's own uncertainties
  std::optional<StartShare> start;    ///< at the quiet or the first loud speed
  std::vector<std::string> left_out;  ///< parts for which the TimeLimit left no time
  /// Of a limit in the long run that is not complete: of the speeds of which nothing is known.
  std::vector<carrier_track::SampledTurns> sampled = {};

  bool is_complete() const { return !answer.reached && left_out.empty(); }
};

/// Computes the answer and all that is reported; with `tolerance` 0 no machines are drawn for it.
/// `file` is where the scene comes from, for the uncertainties of its numbers. If a TimeLimit is
/// reached, the answer says what it leaves out; see quiet_speed().
QuietSpeedAnswer answer_quiet_speed(const std::string& name, const carrier_track::Scene& scene,
                                    const carrier_track::QuietSpeedOptions& options,
                                    double tolerance, const carrier_track::SceneFile& file = {});

/// A speed of a scan, a multiple of its step, without rounding errors in its last digits.
std::optional<double> rounded(const std::optional<double>& speed);

// The staircase of the counts, and the counts beside the answer, as tables.
Table step_table(const std::vector<carrier_track::Step>& steps);
Table level_table(const std::vector<carrier_track::Level>& levels);
Table around_table(const std::vector<carrier_track::CountThere>& around);

/// What is known if the answer is not complete, such as "nothing is known from 3.2 to 18 rad/s".
std::string known_part_of(const QuietSpeedAnswer& output);

/// The answer in one or two sentences.
std::string headline_of(const QuietSpeedAnswer& output);

/// Several lines for an engineer, the answer first.
std::string text_of(const QuietSpeedAnswer& output);

report::Json json_of(const QuietSpeedAnswer& output);

/// Whether a machine needs the planar model at a speed [rad/s]: if its second direction affects the
/// first there.
std::string planar_sentence(const carrier_track::Scene& scene, double omega);

/// The constant that moves the speed most, in a sentence; nothing without sensitivities.
std::optional<std::string> strongest_of(const QuietSpeedAnswer& output);

/// What a tolerance of all constants, and what the uncertainties of the file do to the answer;
/// nothing if they are not asked for.
std::optional<std::string> tolerance_sentence(const QuietSpeedAnswer& output);
std::optional<std::string> uncertainty_sentence(const QuietSpeedAnswer& output);

}  // namespace ricochet::studies::advice
