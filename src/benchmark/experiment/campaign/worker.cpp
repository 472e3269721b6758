#include "src/benchmark/experiment/campaign/worker.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>

#include "ricochet/error.h"
#include "src/benchmark/experiment/campaign/record_text.h"
#include "src/core/seed.h"

namespace ricochet {
namespace {

// The head of a message: its length and its kind. The content follows.
struct Head {
  std::uint64_t length;
  enum class Kind : std::uint64_t { improvement, record } kind;
};

/// A record is much shorter; a longer message comes from a broken process.
constexpr std::uint64_t longest_message = 1ULL << 30;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool sanitized = false;
#endif

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Address space of this process now [bytes].
double address_space() {
  std::int64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return static_cast<double>(pages * sysconf(_SC_PAGESIZE));
}

/// Limits the memory of this process; not with sanitizers, whose own memory is unlimited.
void limit_memory(double megabytes) {
  if (sanitized) return;
  const auto most = static_cast<rlim_t>(address_space() + 1e6 * std::min(megabytes, 1e9));
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
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
[[noreturn]] void work(const std::vector<Job>& jobs, const Limits& limits, pid_t parent,
                       int descriptor) {
  setpgid(0, 0);  // so that it can be killed with whatever it starts
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  limit_memory(limits.megabytes);
  dup2(STDERR_FILENO, STDOUT_FILENO);  // output of a solver must not get into results
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

std::string in_words(int status) {
  if (WIFSIGNALED(status)) return fmt::format("crashed: {}", strsignal(WTERMSIG(status)));
  return fmt::format("ended the process, with exit status {}", WEXITSTATUS(status));
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
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    work(jobs, limits, parent, ends[1]);
  }
  const int error = errno;
  close(ends[1]);
  descriptor_ = ends[0];
  if (process_ < 0) {
    close(descriptor_);
    errno = error;
    fail("fork");
  }
  setpgid(process_, process_);  // here and in the child, whichever is first
}

void Worker::begin(std::size_t job) {
  job_ = job;
  ++runs_;
  trace_.clear();
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
  kill_and_wait();
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

/// Kills the process and those it has started. Returns how it ended.
std::string Worker::kill_and_wait() {
  if (process_ < 0) return {};
  const bool late = std::chrono::steady_clock::now() >= deadline_;
  kill(-process_, SIGKILL);
  kill(process_, SIGKILL);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  killed_from_outside_ = !late && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  return late ? fmt::format("killed: it took more than {} s", limits_.seconds) : in_words(status);
}

RunRecord Worker::record() {
  if (record_) {
    record_->trace = std::move(trace_);
    return *std::move(record_);
  }
  const Job& job = jobs_[job_];
  RunRecord record = nothing_run_of(job);
  record.ledger.charged = job.budget.evaluations;
  record.trace = std::move(trace_);
  record.failure = kill_and_wait();
  return record;
}

}  // namespace ricochet
