#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace ricochet {

/// A line on standard error with the share done and the time left, redrawn at most ten times a
/// second; silent where standard error is no terminal. Safe to advance from several threads.
class Progress {
 public:
  /// `work` > 0 is in any unit that grows evenly with time.
  Progress(std::string what, double work);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(double work);

 private:
  void draw(bool last);

  std::string what_;
  double work_;
  double done_ = 0;
  bool shown_;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point drawn_;
};

}  // namespace ricochet
