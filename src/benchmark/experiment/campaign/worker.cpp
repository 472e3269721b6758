#include "src/benchmark/experiment/campaign/worker.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "ricochet/error.h"
#include "src/benchmark/experiment/campaign/record_text.h"
#include "src/benchmark/experiment/store/possible_record.h"
#include "src/core/open_files.h"
#include "src/core/resource_limits.h"
#include "src/core/seed.h"
#include "src/core/waiting.h"

namespace ricochet {
namespace {

// The head of a message: its length and its kind. The content follows.
struct Head {
  std::uint64_t length;
  enum class Kind : std::uint64_t { improvement, waiting, record } kind;
};

/// A record is much shorter; a longer message comes from a broken process.
constexpr std::uint64_t longest_message = 1ULL << 30;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

RunRecord nothing_run_of(const Job& job) {
  return nothing_run(*job.problem, *job.solver, job.budget, job.number, job.shown);
}

/// Writes all bytes; ends the process if no one reads any more.
void write_all(int descriptor, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = write(descriptor, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(1);
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
}

void tell(int descriptor, Head::Kind kind, const std::string& text) {
  const Head head{text.size(), kind};
  std::string message(reinterpret_cast<const char*>(&head), sizeof head);
  message += text;
  write_all(descriptor, message.data(), message.size());
}

/// The next job from the parent; nothing if there are no more.
std::optional<std::size_t> next_job(int descriptor) {
  std::size_t job = 0;
  ssize_t count = 0;
  do {
    count = read(descriptor, &job, sizeof job);
  } while (count < 0 && errno == EINTR);
  return count == sizeof job ? std::optional(job) : std::nullopt;
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
  on_waiting(
      [descriptor](const std::string& text) { tell(descriptor, Head::Kind::waiting, text); });
  try {
    while (const auto job = next_job(descriptor)) {
      RunRecord record = make(jobs[*job], [&](const Improvement& step) {
        tell(descriptor, Head::Kind::improvement, text_of(step));
      });
      record.trace.clear();  // already sent
      tell(descriptor, Head::Kind::record, text_of(record));
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
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail("socketpair");
  std::fflush(nullptr);  // buffered output is the parent's to write
  descriptor_ = ends[0];
  try {
    process_.emplace([&] {
      close(ends[0]);
      work(jobs, limits, ends[1]);
    });
  } catch (...) {
    close(ends[0]);
    close(ends[1]);
    throw;
  }
  close(ends[1]);
}

void Worker::begin(std::size_t job) {
  job_ = job;
  ++runs_;
  trace_.clear();
  waiting_.clear();
  record_.reset();
  deadline_ = std::chrono::steady_clock::now() +
              std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                  std::chrono::duration<double>(std::min(limits_.seconds, 1e9)));
  // If it fails, listen() reports it.
  static_cast<void>(send(descriptor_, &job, sizeof job, MSG_NOSIGNAL));
}

std::chrono::steady_clock::duration Worker::age() const {
  return std::chrono::steady_clock::now() - born_;
}

Worker::~Worker() {
  process_.reset();
  close(descriptor_);
}

bool Worker::listen() {
  char buffer[1 << 16];
  const ssize_t count = read(descriptor_, buffer, sizeof buffer);
  if (count < 0 && errno == EINTR) return true;
  if (count <= 0) return false;
  unread_.append(buffer, static_cast<std::size_t>(count));
  std::size_t taken = 0;
  Head head{};
  while (unread_.size() - taken >= sizeof head) {
    std::memcpy(&head, unread_.data() + taken, sizeof head);
    if (head.length > longest_message) return false;
    if (unread_.size() - taken - sizeof head < head.length) break;
    const std::string text = unread_.substr(taken + sizeof head, head.length);
    try {
      if (head.kind == Head::Kind::improvement) {
        trace_.push_back(improvement_from(text));
      } else if (head.kind == Head::Kind::waiting) {
        waiting_ = text;
      } else {
        record_ = record_from(text);
      }
    } catch (const std::exception&) {
      return false;
    }
    taken += sizeof head + head.length;
  }
  unread_.erase(0, taken);
  return !record_;
}

/// Kills the process and all that it has started. Returns how it ended.
std::string Worker::kill_and_wait() {
  const bool late = std::chrono::steady_clock::now() >= deadline_;
  const int status = process_->end();
  process_.reset();
  killed_from_outside_ = !late && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  return late ? fmt::format("killed: it took more than {} s{}{}", limits_.seconds,
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

}  // namespace ricochet
