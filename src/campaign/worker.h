#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "src/core/run.h"

namespace ricochet {

/// One run to be made; problem and solver outlive it.
struct Job {
  const Problem* problem;
  const Solver* solver;
  Budget budget;
  int number = 0;
};

/// What a run may take from the machine, whatever its budget: who takes more is killed.
struct Limits {
  double seconds = 600;     ///< > 0, by the clock on the wall
  double megabytes = 2000;  ///< > 0, of memory, beside what the parent holds
};

/// Throws InputError, naming the option, where a limit is none.
void check(const Limits& limits);

/// One run in a process of its own: a copy of this one, so that it starts within a millisecond and
/// leaves nothing behind. A solver that crashes, hangs or eats memory costs its own run and nothing
/// else.
class Worker {
 public:
  /// Throws std::system_error where there can be no other process.
  Worker(const Job& job, const Limits& limits);

  /// Kills the process where it still runs.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Has something to be read when there is news.
  int descriptor() const { return descriptor_; }

  /// Takes the news. Returns whether the run goes on.
  bool listen();

  /// When it is killed, unless it has ended.
  std::chrono::steady_clock::time_point deadline() const { return deadline_; }

  /// After the run has ended, or its deadline: its record. Of a run that did not come to its own
  /// end the record has what it had found, says what happened in `failure`, and is charged the
  /// whole budget.
  RunRecord record();

 private:
  void take(const std::string& message);
  std::string kill_and_wait();

  Job job_;
  Limits limits_;
  pid_t process_ = -1;
  int descriptor_ = -1;
  std::chrono::steady_clock::time_point deadline_;
  std::string unread_;  // of a message that has not wholly come
  std::vector<Improvement> trace_;
  std::optional<RunRecord> record_;
};

}  // namespace ricochet
