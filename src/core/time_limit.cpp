#include "src/core/time_limit.h"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace ricochet {

namespace {

constexpr double between_readings = 1e-4;  // [s], about
constexpr double most_glances = 64;        // between two readings: the cost is then negligible

}  // namespace

double Stopwatch::now() {
  return processor_seconds();
}

Stopwatch::Stopwatch() : started_(now()) {}

double Stopwatch::read() {
  last_ = now() - started_;
  return last_;
}

double Stopwatch::glance() {
  if (++glances_ < until_) return last_;
  const double before = last_;
  const double each = (read() - before) / static_cast<double>(glances_);
  const double fitting = each > 0 ? between_readings / each : most_glances;
  until_ = static_cast<std::int64_t>(std::clamp(fitting, 1.0, most_glances));
  glances_ = 0;
  return last_;
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

namespace {

using std::chrono::steady_clock;

constexpr double longest = 1e9;  // [s], 30 years: no limit

// A simulation takes microseconds, a reading of the clock some tens of nanoseconds.
constexpr unsigned checks_between_readings = 16;

constinit thread_local WorkTime here;
constinit thread_local unsigned checks = 0;

}  // namespace

TimeLimit::TimeLimit(double seconds)
    : end_(steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(
                                     std::chrono::duration<double>(std::min(seconds, longest)))),
      outer_(here.limit),
      outer_listener_(here.listener) {
  if (outer_ != nullptr) end_ = std::min(end_, outer_->end_);
  here = {this, this};
}

TimeLimit::~TimeLimit() {
  here = {outer_, outer_listener_};
}

bool TimeLimit::is_reached() {
  if (!was_reached() && steady_clock::now() >= end_)
    reached_.store(true, std::memory_order_relaxed);
  return was_reached();
}

void TimeLimit::report(const char* stage, double share) {
  stage_.store(stage, std::memory_order_relaxed);
  share_.store(share, std::memory_order_relaxed);
}

WorkTime& work_time_of_this_thread() {
  return here;
}

void check_time_limit() {
  if (here.limit == nullptr) return;
  const bool over = ++checks % checks_between_readings == 0 ? here.limit->is_reached()
                                                            : here.limit->was_reached();
  if (over) throw TimeLimitReached();
}

void report_progress(const char* stage, double share) {
  if (here.listener != nullptr) here.listener->report(stage, share);
}

}  // namespace ricochet
