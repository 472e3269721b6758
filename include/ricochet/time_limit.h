#pragma once

/// @file
/// A limit of the time that a computation may take.

#include <atomic>
#include <chrono>
#include <exception>

namespace ricochet {

/// The result that was asked for is not known when the time limit is reached.
class TimeLimitReached : public std::exception {
 public:
  const char* what() const noexcept override { return "the time limit is reached"; }
};

/// Limits the time of what is computed in this thread while the object lives, and in the threads
/// that share the work. When it is reached, simulate(), regimes_of() and quiet_speed() return what
/// they know by then, and how far it goes; all else that simulates throws TimeLimitReached. Results
/// that are there in time have the same bits as without a limit. Inside another limit, the one that
/// ends first holds.
class TimeLimit {
 public:
  /// `seconds`: of the wall clock, > 0; infinity: no limit.
  explicit TimeLimit(double seconds);
  ~TimeLimit();
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;

  /// Looks at the clock, unless it was reached before.
  bool is_reached();
  bool was_reached() const { return reached_.load(std::memory_order_relaxed); }

  /// What is computed now, such as "regimes", and the share of it that is done, in [0, 1]; nullptr
  /// before anything is reported. These may be called from other threads.
  const char* stage() const { return stage_.load(std::memory_order_relaxed); }
  double share() const { return share_.load(std::memory_order_relaxed); }
  void report(const char* stage, double share);

 private:
  std::chrono::steady_clock::time_point end_;
  TimeLimit* outer_;
  TimeLimit* outer_listener_;
  std::atomic<bool> reached_ = false;
  std::atomic<const char*> stage_ = nullptr;
  std::atomic<double> share_ = 0;
};

}  // namespace ricochet
