#include "src/experiment/worker.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "ricochet/error.h"
#include "src/core/instance.h"
#include "src/experiment/merge.h"
#include "src/experiment/stored_fields.h"

namespace ricochet {

namespace {

// The first byte of a message says what follows it.
constexpr char improvement = 'i';
constexpr char waiting = 'w';
constexpr char finished = 'r';

RunRecord nothing_run_of(const Job& job) {
  return nothing_run(*job.problem, *job.solver, job.budget, job.number, job.shown);
}

/// Ends the process if no one reads any more.
void tell(int descriptor, char kind, const std::string& text) {
  if (!write_frame(descriptor, kind + text)) _exit(1);
}

/// The next job from the parent; nothing if there are no more.
std::optional<std::size_t> next_job(int descriptor) {
  const auto message = read_frame(descriptor);
  std::size_t job = 0;
  if (!message || message->size() != sizeof job) return std::nullopt;
  std::memcpy(&job, message->data(), sizeof job);
  return job;
}

RunRecord make(const Job& job, const std::function<void(const Improvement&)>& on_improvement) {
  const auto made_on = [&](const Problem& problem) {
    return run(problem, *job.solver, job.budget, job.number, on_improvement, job.shown);
  };
  if (job.perturbation == nullptr) return made_on(*job.problem);
  // The same draws for every solver, so that all get the same difficulty.
  const Problem& problem = *job.problem;
  return made_on(job.perturbation->perturbed(
      problem, seed_of(problem.name, job.perturbation->name, problem.instance, job.number)));
}

/// The main function of the process.
[[noreturn]] void work(const std::vector<Job>& jobs, const Limits& limits, int descriptor) {
  limit_resources(limits.megabytes);
  // A solver must neither read what this process was given nor write into results.
  lead_nowhere(STDIN_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  on_waiting([descriptor](const std::string& text) { tell(descriptor, waiting, text); });
  try {
    while (const auto job = next_job(descriptor)) {
      RunRecord record = make(jobs[*job], [&](const Improvement& step) {
        tell(descriptor, improvement, text_of(step));
      });
      record.trace.clear();  // already sent
      tell(descriptor, finished, text_of(record));
    }
  } catch (...) {
    _exit(1);
  }
  _exit(0);  // without the parent's exit handlers
}

}  // namespace

void check(const Limits& limits) {
  if (!(limits.seconds > 0)) {
    throw InputError(fmt::format("--run-seconds {}: must be > 0", limits.seconds));
  }
  if (!(limits.megabytes > 0)) {
    throw InputError(fmt::format("--run-megabytes {}: must be > 0", limits.megabytes));
  }
}

Worker::Worker(const std::vector<Job>& jobs, const Limits& limits)
    : jobs_(jobs), limits_(limits), born_(std::chrono::steady_clock::now()) {
  process_.emplace([&](int descriptor) { work(jobs, limits, descriptor); });
}

void Worker::begin(std::size_t job) {
  job_ = job;
  ++runs_;
  trace_.clear();
  waiting_.clear();
  record_.reset();
  deadline_ = std::chrono::steady_clock::now() +
              std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                  std::chrono::duration<double>(std::min(seconds(), 1e9)));
  // If it fails, listen() reports it.
  process_->tell({reinterpret_cast<const char*>(&job), sizeof job});
}

double Worker::seconds() const {
  return std::min(limits_.seconds, jobs_[job_].problem->longest_run.value_or(limits_.seconds));
}

std::chrono::steady_clock::duration Worker::age() const {
  return std::chrono::steady_clock::now() - born_;
}

bool Worker::listen() {
  if (!process_->listen()) return false;
  while (const auto message = process_->next()) {
    if (message->empty()) return false;
    const std::string text = message->substr(1);
    try {
      if (message->front() == improvement) {
        trace_.push_back(improvement_from(text));
      } else if (message->front() == waiting) {
        waiting_ = text;
      } else {
        record_ = record_from(text);
      }
    } catch (const std::exception&) {
      return false;
    }
  }
  return !record_;
}

/// Kills the process and all that it has started. Returns how it ended.
std::string Worker::kill_and_wait() {
  const bool late = std::chrono::steady_clock::now() >= deadline_;
  const int status = process_->end();
  process_.reset();
  killed_from_outside_ = !late && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  return late ? fmt::format("killed: it took more than {} s{}{}", seconds(),
                            waiting_.empty() ? "" : "; ", waiting_)
              : ending_in_words(status);
}

RunRecord Worker::record() {
  const Job& job = jobs_[job_];
  std::string wrong;
  if (record_) {
    record_->trace = std::move(trace_);
    wrong = impossibility(*record_);
    if (wrong.empty()) return *std::move(record_);
    trace_.clear();
  }
  RunRecord record = nothing_run_of(job);
  record.ledger.charged = job.budget.evaluations;
  record.trace = std::move(trace_);
  record.failure = kill_and_wait();
  if (wrong.empty()) wrong = impossibility(record);
  if (wrong.empty()) return record;
  record.trace.clear();
  record.failure = "its record says what cannot be: " + wrong;
  return record;
}

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
  std::set<const Solver*> solvers;
  for (const Job& job : jobs) {
    if (job.solver->prepare && solvers.insert(job.solver).second) job.solver->prepare();
  }
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

namespace {

using Json = nlohmann::json;

/// What goes through a pipe or to another rank, as CBOR: of a struct the values of its fields, in
/// the order of their list.
struct Message {
  template <class T>
  static Json of(const T& value) {
    if constexpr (std::is_enum_v<T>) {
      return static_cast<int>(value);
    } else if constexpr (HasFields<T>) {
      Json list = Json::array();
      visit_fields([&](const Field& /*field*/, const auto& x) { list.push_back(of(x)); }, value);
      return list;
    } else {
      return value;
    }
  }
  static Json of(const Vector& x) { return std::vector<double>(x.begin(), x.end()); }
  template <class T>
  static Json of(const std::optional<T>& value) {
    return value ? of(*value) : Json();
  }
  template <class T>
  static Json of(const std::vector<T>& list) {
    Json all = Json::array();
    for (const T& entry : list) all.push_back(of(entry));
    return all;
  }

  template <class T>
  static void read(const Json& json, T& target) {
    if constexpr (std::is_enum_v<T>) {
      target = static_cast<T>(json.get<int>());
    } else if constexpr (HasFields<T>) {
      std::size_t k = 0;
      visit_fields([&](const Field& /*field*/, auto& x) { read(json.at(k++), x); }, target);
    } else {
      json.get_to(target);
    }
  }
  static void read(const Json& json, Vector& target) {
    const auto numbers = json.get<std::vector<double>>();
    target = Eigen::Map<const Vector>(numbers.data(), std::ssize(numbers));
  }
  template <class T>
  static void read(const Json& json, std::optional<T>& target) {
    if (!json.is_null()) read(json, target.emplace());
  }
  template <class T>
  static void read(const Json& json, std::vector<T>& target) {
    for (const Json& entry : json) read(entry, target.emplace_back());
  }

  template <class T>
  static std::string bytes_of(const T& value) {
    std::string bytes;
    Json::to_cbor(of(value), nlohmann::detail::output_adapter<char>(bytes));
    return bytes;
  }
  template <class T>
  static T from(const std::string& bytes) {
    T value{};
    read(Json::from_cbor(bytes), value);
    return value;
  }
};

}  // namespace

std::string text_of(const Improvement& improvement) {
  return Message::bytes_of(improvement);
}

Improvement improvement_from(const std::string& text) {
  return Message::from<Improvement>(text);
}

std::string text_of(const RunRecord& record) {
  return Message::bytes_of(record);
}

RunRecord record_from(const std::string& text) {
  return Message::from<RunRecord>(text);
}

}  // namespace ricochet
