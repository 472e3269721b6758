#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

#include "src/core/interruption.h"

namespace ricochet {

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

}  // namespace ricochet
