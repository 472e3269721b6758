#pragma once

#include "ricochet/evaluator.h"

namespace ricochet {

/// Processor time of this thread [s]: other threads and waiting do not count.
double processor_seconds();

/// Throws TimeLimitReached if the time limit of this thread is reached. For loops that simulate:
/// takes some nanoseconds, since it looks at the clock only now and then.
void check_time_limit();

/// Tells the owner of this thread's time limit how far the work is. `stage` is in static storage,
/// `share` in [0, 1]. Parts of parallel work have no say.
void report_progress(const char* stage, double share);

/// The time limits of a thread, to be handed on to those that share its work.
struct WorkTime {
  TimeLimit* limit = nullptr;     ///< the innermost; nullptr: none
  TimeLimit* listener = nullptr;  ///< hears of progress; nullptr: nobody
};

WorkTime& work_time_of_this_thread();

}  // namespace ricochet
