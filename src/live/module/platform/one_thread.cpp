// What the simulation takes from the machine that it runs on, where there is no clock and no vector
// of eight numbers.
#include "problems/carrier_track/motion/lanes.h"
#include "src/core/time_limit.h"

namespace ricochet {

/// No time passes: a race is bounded by its evaluations.
double processor_seconds() {
  return 0;
}

Stopwatch::Stopwatch() : started_(0) {}
double Stopwatch::read() {
  return 0;
}
double Stopwatch::glance() {
  return 0;
}
double Stopwatch::now() {
  return 0;
}

/// No time passes: there is no limit.
void check_time_limit() {}
void report_progress(const char* /*stage*/, double /*share*/) {}
void TimeLimit::report(const char* /*stage*/, double /*share*/) {}
WorkTime& work_time_of_this_thread() {
  static WorkTime none;
  return none;
}

}  // namespace ricochet

namespace ricochet::carrier_track::inline models {

/// Moves nobody, so that every body takes its next step by itself, with the same bits.
void fly(Lanes& lanes) {
  lanes.event.fill(Lanes::none);
}

}  // namespace ricochet::carrier_track::inline models
