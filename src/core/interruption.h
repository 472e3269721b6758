#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace ricochet {

/// From now on SIGHUP, SIGINT and SIGTERM, where they are not ignored, end the program tidily: what
/// is registered below is done, one line says so on standard error, and the exit code is 128 and
/// the signal. A second signal ends it at once. To be called before there is a second thread.
void end_tidily_when_interrupted();

/// Lets these signals end the program as the system does: for a program that takes its place.
void end_at_once_when_interrupted();

/// What is done if an interruption ends the program while this lives, latest first.
class AtInterruption {
 public:
  /// `says` is for the user: what was kept, and how to go on.
  explicit AtInterruption(std::function<void()> work, std::string says = "");
  ~AtInterruption();
  AtInterruption(const AtInterruption&) = delete;
  AtInterruption& operator=(const AtInterruption&) = delete;

 private:
  friend void end_interrupted(int signal);
  std::function<void()> work_;
  std::string says_;
};

/// While it lives, an interruption waits: for what must be done as a whole.
class Uninterrupted {
 public:
  Uninterrupted();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

}  // namespace ricochet
