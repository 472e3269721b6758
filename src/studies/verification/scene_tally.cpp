#include "src/studies/verification/scene_tally.h"

#include <algorithm>

namespace ricochet::studies::verification {

void SceneTally::add(const carrier_track::Comparison& c) {
  ++scenes_;
  if (!c.compared) {
    ++broken_off_;
    return;
  }
  if (!c.certain) {
    wrong_uncertain_ += !c.agrees();
    return;
  }
  ++certain_;
  wrong_certain_ += !c.agrees();
  missed_ += c.missed;
  spurious_ += c.spurious;
  matched_ += c.matched;
  if (c.missed > 0 || c.spurious > 0) return;
  time_error_ = std::max(time_error_, c.time_error);
  speed_error_ = std::max(speed_error_, c.speed_error);
}

report::Json SceneTally::data() const {
  return {{"name", name_},
          {"scenes", scenes_},
          {"broken_off", broken_off_},
          {"certain", compared() > 0 ? static_cast<double>(certain_) / compared() : 0.0},
          {"wrong_certain", wrong_certain_},
          {"wrong_uncertain", wrong_uncertain_},
          {"missed", missed_},
          {"spurious", spurious_},
          {"matched", matched_},
          {"time_error", time_error_},
          {"speed_error", speed_error_}};
}

}  // namespace ricochet::studies::verification
