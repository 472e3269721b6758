#pragma once

#include <cstdint>

namespace ricochet {

/// Processor time of one run, in its own thread, from the making of the stopwatch on. A reading
/// takes as long as a dozen cheap evaluations, so whoever asks at each of them only glances.
class Stopwatch {
 public:
  Stopwatch();

  /// [s], exact, without what was left out.
  double read();

  /// [s], of the last reading, which is some 0.1 ms old where glances follow each other evenly, and
  /// 64 glances at most.
  double glance();

  /// Does some work off the clock.
  template <class Work>
  void leave_out(Work work) {
    const double before = now();
    work();
    started_ += now() - before;
  }

 private:
  static double now();

  double started_;  // moved on by what is left out
  double last_ = 0;
  std::int64_t glances_ = 0;  // since the last reading
  std::int64_t until_ = 1;    // glances from one reading to the next
};

}  // namespace ricochet
