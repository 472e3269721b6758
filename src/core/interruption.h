#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace ricochet {

/// From now on SIGHUP, SIGINT and SIGTERM, unless ignored, end the program tidily: the work
/// registered below is done, one line on standard error reports it, and the exit code is 128 plus
/// the signal. A second signal ends the program at once. Must be called before a second thread
/// starts.
void end_tidily_when_interrupted();

/// Restores the system's handling of these signals: for a program that replaces this one.
void end_at_once_when_interrupted();

/// Work to do if an interruption ends the program while this object lives; the latest first.
class AtInterruption {
 public:
  /// `says` is a message for the user: what was kept, and how to continue.
  explicit AtInterruption(std::function<void()> work, std::string says = "");
  ~AtInterruption();
  AtInterruption(const AtInterruption&) = delete;
  AtInterruption& operator=(const AtInterruption&) = delete;

 private:
  friend void end_interrupted(int signal);
  std::function<void()> work_;
  std::string says_;
};

/// While this object lives, an interruption waits: for work that must not be cut in two.
class Uninterrupted {
 public:
  Uninterrupted();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

}  // namespace ricochet
