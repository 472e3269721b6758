#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/core/run.h"
#include "src/features/feature.h"

namespace ricochet {

/// One run to be made; problem, solver and feature outlive it.
struct Job {
  const Problem* problem;
  const Solver* solver;
  Budget budget;
  int number = 0;
  std::string shown = {};            ///< how, where that goes into the seed: see seed_of
  const Feature* feature = nullptr;  ///< that perturbs what the solver sees; null: none
};

/// What a run may take from the machine, whatever its budget: who takes more is killed.
struct Limits {
  double seconds = 600;     ///< > 0, by the clock on the wall
  double megabytes = 2000;  ///< > 0, of memory, beside what the parent holds
};

/// Throws InputError, naming the option, where a limit is none.
void check(const Limits& limits);

/// A process that makes runs, one after the other: a copy of this one, so that it knows all jobs.
/// A solver that crashes, hangs or eats memory costs its own run, the process, and nothing else.
class Worker {
 public:
  /// The jobs outlive it. Throws std::system_error where there can be no other process.
  Worker(const std::vector<Job>& jobs, const Limits& limits);

  /// Kills the process.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Begins the run of a job. The one before must have ended, and the process must be alive.
  void begin(std::size_t job);

  /// The job of the run.
  std::size_t job() const { return job_; }

  /// When the run is killed, unless it has ended.
  std::chrono::steady_clock::time_point deadline() const { return deadline_; }

  /// Has something to be read when there is news of the run.
  int descriptor() const { return descriptor_; }

  /// Takes the news. Returns whether the run goes on.
  bool listen();

  /// After the run has ended, or its deadline: its record. Of a run that did not come to its own
  /// end the record has what it had found, says what happened in `failure`, and is charged the
  /// whole budget; the process is dead then.
  RunRecord record();

  bool alive() const { return process_ >= 0; }

  /// Whether somebody else has killed the process, as one who wants its memory does.
  bool killed_from_outside() const { return killed_from_outside_; }

  /// Runs that it has begun.
  int runs() const { return runs_; }

  std::chrono::steady_clock::duration age() const;

 private:
  std::string kill_and_wait();

  const std::vector<Job>& jobs_;
  Limits limits_;
  std::chrono::steady_clock::time_point born_;
  pid_t process_ = -1;
  int descriptor_ = -1;
  std::size_t job_ = 0;
  int runs_ = 0;
  bool killed_from_outside_ = false;
  std::chrono::steady_clock::time_point deadline_;
  std::string unread_;  // of a message that has not wholly come
  std::vector<Improvement> trace_;
  std::optional<RunRecord> record_;
};

}  // namespace ricochet
