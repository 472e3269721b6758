#include "src/benchmark/experiment/campaign/runner.h"

#include <poll.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <utility>

#include "src/core/open_files.h"

namespace ricochet {
namespace {

using Clock = std::chrono::steady_clock;

/// A process is replaced at this age, so that leftovers of solvers do not accumulate; a new process
/// takes a few milliseconds.
constexpr std::chrono::seconds old_age(1);

/// Jobs that wait, in order.
class Queue {
 public:
  explicit Queue(std::size_t jobs) : jobs_(jobs) {}

  bool empty() const { return again_.empty() && next_ == jobs_; }

  /// Returns true if the next job needs a fresh process.
  bool alone() const { return !again_.empty(); }

  std::size_t take() {
    if (again_.empty()) return next_++;
    const std::size_t job = again_.back();
    again_.pop_back();
    return job;
  }

  /// Puts a job back for a second try in a fresh process: its failure may be caused by earlier runs
  /// in the same process, or its process was killed from outside. Returns false if the job already
  /// had its second try.
  bool put_back(std::size_t job) {
    if (!had_another_try_.insert(job).second) return false;
    again_.push_back(job);
    return true;
  }

 private:
  std::size_t jobs_;
  std::size_t next_ = 0;
  std::vector<std::size_t> again_;
  std::set<std::size_t> had_another_try_;
};

/// Waits for news of any worker, at most until a deadline. Returns for each whether it has news.
std::vector<bool> wait_for(const std::vector<std::unique_ptr<Worker>>& workers) {
  std::vector<pollfd> descriptors;
  auto deadline = Clock::time_point::max();
  for (const auto& worker : workers) {
    descriptors.push_back({worker->descriptor(), POLLIN, 0});
    deadline = std::min(deadline, worker->deadline());
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
  // At most an hour, so that it fits into an int.
  poll(descriptors.data(), descriptors.size(),
       static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 3'600'000)));
  std::vector<bool> news;
  for (const pollfd& each : descriptors) news.push_back(each.revents != 0);
  return news;
}

/// A worker that runs the next job: this one if it may continue, else a new one.
std::unique_ptr<Worker> at_work(std::unique_ptr<Worker> worker, Queue& queue,
                                const std::vector<Job>& jobs, const Limits& limits) {
  const bool goes_on = worker && worker->alive() && worker->age() < old_age && !queue.alone();
  if (!goes_on) worker = std::make_unique<Worker>(jobs, limits);
  worker->begin(queue.take());
  return worker;
}

}  // namespace

int open_files_of_runs(std::size_t processes) {
  // In each process: what a program or a shared library needs. Measured: 6. With too few, a run
  // would be kept as one whose solver failed.
  constexpr int of_run = 12;
  // A socket, and a descriptor of the process; one process more is started before an old one ends.
  return of_run + 2 * (static_cast<int>(processes) + 1);
}

std::size_t processes_of_runs() {
  return std::max<std::size_t>(
      1, tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

void run_all(const std::vector<Job>& jobs, const Limits& limits,
             const std::function<void(std::size_t, RunRecord)>& done) {
  const std::size_t at_once = std::min(processes_of_runs(), jobs.size());
  allow_further_open_files(open_files_of_runs(at_once));
  Queue queue(jobs.size());
  std::vector<std::unique_ptr<Worker>> workers;
  while (workers.size() < at_once) {
    workers.push_back(at_work(nullptr, queue, jobs, limits));
  }
  while (!workers.empty()) {
    const std::vector<bool> news = wait_for(workers);
    for (std::size_t w = 0; w < workers.size(); ++w) {
      Worker& worker = *workers[w];
      const bool goes_on = !news[w] || worker.listen();
      if (goes_on && Clock::now() < worker.deadline()) continue;
      RunRecord record = worker.record();
      const bool blameless = !worker.alive() && (worker.runs() > 1 || worker.killed_from_outside());
      if (!blameless || !queue.put_back(worker.job())) {
        done(worker.job(), std::move(record));
      }
      workers[w] = queue.empty() ? nullptr : at_work(std::move(workers[w]), queue, jobs, limits);
    }
    std::erase(workers, nullptr);
  }
}

std::vector<RunRecord> run_all(const std::vector<Job>& jobs, Progress& progress) {
  std::vector<RunRecord> records(jobs.size());
  run_all(jobs, Limits{}, [&](std::size_t job, RunRecord record) {
    records[job] = std::move(record);
    progress.advance(1);
  });
  return records;
}

}  // namespace ricochet
