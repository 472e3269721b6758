#pragma once

#include <cstdint>

namespace ricochet {

/// Processor time of one run, in its own thread, since construction. A reading takes as long as a
/// dozen cheap evaluations; glance() is for calls at every evaluation.
class Stopwatch {
 public:
  Stopwatch();

  /// [s], exact, without excluded work.
  double read();

  /// [s], of the last reading: about 0.1 ms old if glances are evenly spaced, and at most 64
  /// glances old.
  double glance();

  /// Does work whose time is not counted.
  template <class Work>
  void leave_out(Work work) {
    const double before = now();
    work();
    started_ += now() - before;
  }

 private:
  static double now();

  double started_;  // moved forward by excluded work
  double last_ = 0;
  std::int64_t glances_ = 0;  // since the last reading
  std::int64_t until_ = 1;    // glances from one reading to the next
};

}  // namespace ricochet
