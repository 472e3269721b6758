#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/run.h"
#include "src/core/child_process.h"
#include "src/experiment/perturbations.h"

namespace ricochet {

/// One run to be made; problem, solver and perturbation must outlive it.
struct Job {
  const Problem* problem;
  const Solver* solver;
  Budget budget;
  int number = 0;
  std::string shown = {};  ///< formulation and perturbation, for the seed: see seed_of
  const Perturbation* perturbation = nullptr;  ///< perturbs what the solver sees; null: none
};

/// Resource limits of a run besides its budget; a run that exceeds one is killed.
struct Limits {
  double seconds = 600;     ///< > 0, wall-clock time
  double megabytes = 2000;  ///< > 0, memory besides the parent's
};

/// Throws InputError, naming the option, for an invalid limit.
void check(const Limits& limits);

/// A process that makes runs, one after the other. It is a fork of this one, so it knows all jobs.
/// If a solver crashes, hangs or exhausts memory, only its own run and this process are lost.
class Worker {
 public:
  /// The jobs must outlive it. Throws std::system_error if no process can be started.
  Worker(const std::vector<Job>& jobs, const Limits& limits);
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Begins the run of a job. The previous run must have ended, and the process must be alive.
  void begin(std::size_t job);

  /// The job of the current run.
  std::size_t job() const { return job_; }

  /// The time when the run is killed, unless it has ended.
  std::chrono::steady_clock::time_point deadline() const { return deadline_; }

  /// Readable when there is news of the run.
  int descriptor() const { return process_->descriptor(); }

  /// Reads the news. Returns whether the run continues.
  bool listen();

  /// The record of the run; to be called after it has ended or its deadline has passed. If the run
  /// did not end by itself, the record has its improvements so far, says what happened in
  /// `failure`, and is charged the whole budget; the process is dead then.
  RunRecord record();

  bool alive() const { return process_.has_value(); }

  /// Returns true if the process was killed from outside, e.g. for lack of memory.
  bool killed_from_outside() const { return killed_from_outside_; }

  /// Number of runs begun.
  int runs() const { return runs_; }

  std::chrono::steady_clock::duration age() const;

 private:
  double seconds() const;  ///< time limit of the run
  std::string kill_and_wait();

  const std::vector<Job>& jobs_;
  Limits limits_;
  std::chrono::steady_clock::time_point born_;
  std::optional<ChildProcess> process_;
  std::size_t job_ = 0;
  int runs_ = 0;
  bool killed_from_outside_ = false;
  std::chrono::steady_clock::time_point deadline_;
  std::vector<Improvement> trace_;
  std::string waiting_;  // what the run waits for, if it has said so; see tell_waiting()
  std::optional<RunRecord> record_;
};

/// Makes all runs in the given order in other processes, one on every core. Passes each record to
/// `done`, with the index of its job, as soon as its run has ended. Except for times, records do
/// not depend on how the runs were distributed. If a run ends its process, it is made once more in
/// a fresh one, unless it was the first there, so that leftovers of other runs cannot make it fail.
/// A run whose process was killed from outside is also made once more. Throws the exceptions of
/// `done`, OutputError if too few files may be open, and std::system_error if no process can be
/// started; then no process is left.
void run_all(const std::vector<Job>& jobs, const Limits& limits,
             const std::function<void(std::size_t, RunRecord)>& done);

/// Number of files, pipes and sockets that run_all opens with so many processes at a time.
int open_files_of_runs(std::size_t processes);

/// Number of processes that run_all has at a time, if there are enough jobs.
std::size_t processes_of_runs();

/// The messages of one process to another about a run: bytes that keep every bit of every number,
/// including NaN and infinity.
std::string text_of(const RunRecord& record);
std::string text_of(const Improvement& improvement);

/// Reads either of them again. Throws std::exception if the text is neither.
RunRecord record_from(const std::string& text);
Improvement improvement_from(const std::string& text);

}  // namespace ricochet
