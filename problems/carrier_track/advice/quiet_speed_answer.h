#pragma once

#include <optional>
#include <string>

#include "problems/carrier_track/advice/answer_notes.h"
#include "problems/carrier_track/answer/sensitivity.h"
#include "problems/carrier_track/answer/uncertainty.h"
#include "problems/carrier_track/regimes/sampled_turns.h"
#include "ricochet/threshold.h"
#include "src/report/json.h"

namespace ricochet::studies::advice {

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

/// What is known if the answer is not complete, such as "nothing is known from 3.2 to 18 rad/s".
std::string known_part_of(const QuietSpeedAnswer& output);

/// The answer in one or two sentences.
std::string headline_of(const QuietSpeedAnswer& output);

/// Several lines for an engineer, the answer first.
std::string text_of(const QuietSpeedAnswer& output);

report::Json json_of(const QuietSpeedAnswer& output);

}  // namespace ricochet::studies::advice
