#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ricochet/recording.h"
#include "src/research/impact_test/test_scene.h"

namespace ricochet::studies::impact_test {

/// How a tool's simulation of a scene ended.
enum class Ending {
  answered,
  cannot,  ///< the tool says that it cannot express the scene
  error,   ///< it failed: an error, a crash, or an answer that is none
  never    ///< no answer within the time limit
};

/// What a tool says of a scene.
struct Answer {
  std::string scene;  ///< its name
  Ending ending = Ending::answered;
  std::string reason = {};                          ///< of another ending than answered
  std::vector<carrier_track::Impact> impacts = {};  ///< in order of time
  double seconds = 0;                               ///< [s], time that the simulation took
  double deepest = 0;                               ///< [m], deepest penetration of a wall
};

/// The answer in a line that a tool has written for this scene. A line that is no answer is an
/// error, whose reason says why. A tool may list impacts in any order, and of any speed.
Answer answer_in(std::string_view line, const std::string& scene);

/// A line as a tool writes it, but for `never`, which has a key of its own.
std::string line_of(const Answer& answer);

}  // namespace ricochet::studies::impact_test
