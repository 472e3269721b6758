#include "problems/carrier_track/check/verification/scene_tally.h"

#include <algorithm>

namespace ricochet::studies::verification {

void SceneTally::add(const carrier_track::Comparison& c) {
  ++scenes;
  if (!c.compared) {
    ++broken_off;
    return;
  }
  called_certain += c.certain;
  certain = static_cast<double>(called_certain) / compared();
  if (!c.certain) {
    wrong_uncertain += !c.agrees();
    return;
  }
  wrong_certain += !c.agrees();
  missed += c.missed;
  spurious += c.spurious;
  matched += c.matched;
  if (c.missed > 0 || c.spurious > 0) return;
  time_error = std::max(time_error, c.time_error);
  speed_error = std::max(speed_error, c.speed_error);
}

}  // namespace ricochet::studies::verification
