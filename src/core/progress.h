#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

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

/// The share done and the time left, on standard error: a line that is redrawn at most ten times a
/// second on a terminal, a new line every ten seconds elsewhere. What cannot be written is lost: it
/// ends no command. advance() may be called from several threads.
class Progress {
 public:
  /// When the first line is drawn elsewhere than on a terminal.
  enum class First { after_ten_seconds, at_once };

  /// `work` > 0 is in any unit proportional to time.
  Progress(std::string what, double work, First first = First::after_ten_seconds);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(double work);

  /// Goes over to other work, as much in its own unit, that was begun then.
  void begin(std::string what, std::chrono::steady_clock::time_point start);

  /// Writes a line of its own that announces the next step.
  static void announce(std::string_view line);

  /// Returns true if standard error is a terminal that takes escape sequences: not where TERM is
  /// "dumb" or not set.
  static bool redraws();

  /// Suppresses all output from now on.
  static void silence();

 private:
  void draw(bool last) const;

  std::string what_;
  double work_;
  double done_ = 0;
  bool redraws_;  ///< on a terminal
  std::mutex mutex_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point drawn_;
  AtInterruption interrupted_;
};

/// Writes "warning: TEXT" as a line to standard error, only once for each text. May be called from
/// several threads at once.
void warn(const std::string& text);

}  // namespace ricochet
