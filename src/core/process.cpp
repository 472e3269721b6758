#include "src/core/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

#include "src/core/files.h"

namespace ricochet {

namespace {

/// A process that nobody may kill, such as one of another user, is left alone after so long.
constexpr std::chrono::seconds killing_limit(5);

void close_all_descriptors() {
  syscall(SYS_close_range, 0U, ~0U, 0U);  // by its number: for C libraries before 2.34
}

/// The processes whose parent this process is, as far as the kernel tells them.
std::string children() {
  std::string text;
  const int file = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  if (file < 0) return text;
  char piece[1024];
  for (;;) {
    const ssize_t count = read(file, piece, sizeof piece);
    if (count <= 0) break;
    text.append(piece, static_cast<std::size_t>(count));
  }
  close(file);
  return text;
}

/// Kills every child with its process group. Orphans become children, for the next call.
void kill_children() {
  const std::string text = children();
  const char* place = text.c_str();
  for (;;) {
    char* end = nullptr;
    const auto child = static_cast<pid_t>(std::strtol(place, &end, 10));
    if (end == place) return;
    place = end;
    const pid_t group = getpgid(child);
    if (group > 0 && group != getpgrp()) kill(-group, SIGKILL);
    kill(child, SIGKILL);
  }
}

/// Collects those that have ended. Returns false if no child is left.
bool reap(pid_t child, bool& gone, int& status) {
  for (;;) {
    int how = 0;
    const pid_t ended = waitpid(-1, &how, WNOHANG);
    if (ended == 0 || (ended < 0 && errno == EINTR)) return true;
    if (ended < 0) return false;
    if (ended != child) continue;
    gone = true;
    status = how;
  }
}

/// Ends this process as the child has ended, so that its parent sees the same.
[[noreturn]] void end_like(int status) {
  if (WIFSIGNALED(status)) {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const int number = WTERMSIG(status);
    std::signal(number, SIG_DFL);
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, number);
    sigprocmask(SIG_UNBLOCK, &only, nullptr);
    kill(getpid(), number);
  }
  _exit(WEXITSTATUS(status));
}

/// Waits until the child has ended or the owner has asked for its end or died, then kills the rest.
[[noreturn]] void watch(pid_t child) {
  sigset_t news;
  sigemptyset(&news);
  sigaddset(&news, SIGCHLD);
  sigaddset(&news, SIGTERM);
  bool gone = false;
  int status = 0;
  while (reap(child, gone, status) && !gone && sigwaitinfo(&news, nullptr) != SIGTERM) {
  }
  if (!gone) kill(-child, SIGKILL);
  const auto limit = std::chrono::steady_clock::now() + killing_limit;
  const timespec pause{0, 10'000'000};
  while (reap(child, gone, status) && std::chrono::steady_clock::now() < limit) {
    kill_children();
    sigtimedwait(&news, nullptr, &pause);
  }
  end_like(status);
}

/// The supervisor. `failure` takes the error number if no child can be started.
[[noreturn]] void supervise(pid_t owner, int failure, const std::function<void()>& work) {
  sigset_t all;
  sigset_t inherited;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &inherited);
  std::signal(SIGCHLD, SIG_DFL);
  char name[16] = {};
  prctl(PR_GET_NAME, name);
  setsid();  // neither the terminal nor a signal to the owner's group reaches it
  prctl(PR_SET_NAME, "supervisor");  // so that `pkill ricochet` does not reach it either
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != owner) _exit(1);
  const pid_t own = getpid();
  int ready[2] = {};
  const pid_t child = pipe2(ready, O_CLOEXEC) == 0 ? fork() : -1;
  if (child == 0) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != own) _exit(1);
    prctl(PR_SET_NAME, name);
    close(failure);
    close(ready[1]);
    // The work may stop its supervisor, for which the owner waits until that has closed its
    // descriptors.
    char nothing = 0;
    static_cast<void>(read(ready[0], &nothing, 1));
    close(ready[0]);
    sigprocmask(SIG_SETMASK, &inherited, nullptr);
    work();
    _exit(1);
  }
  const int error = errno;
  if (child < 0) {
    static_cast<void>(write(failure, &error, sizeof error));
    _exit(1);
  }
  setpgid(child, child);  // here and in the child, whichever is first
  close(failure);
  close_all_descriptors();
  close(ready[1]);  // if the kernel has no close_range()
  watch(child);
}

}  // namespace

std::string ending_in_words(int status) {
  if (WIFSIGNALED(status)) return fmt::format("crashed: {}", strsignal(WTERMSIG(status)));
  return fmt::format("ended the process, with exit status {}", WEXITSTATUS(status));
}

SupervisedProcess::SupervisedProcess(const std::function<void()>& work) : owner_(getpid()) {
  int ends[2] = {};
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  supervisor_ = fork();
  if (supervisor_ == 0) {
    close(ends[0]);
    supervise(owner_, ends[1], work);
  }
  int error = supervisor_ < 0 ? errno : 0;
  close(ends[1]);
  if (supervisor_ > 0) {
    while (read(ends[0], &error, sizeof error) < 0 && errno == EINTR) {
    }
  }
  close(ends[0]);
  if (error != 0) {
    if (supervisor_ > 0) waitpid(supervisor_, nullptr, 0);
    throw std::system_error(error, std::generic_category(), "fork");
  }
  // By its number: glibc 2.36 does not declare pidfd_open for C++.
  descriptor_ = static_cast<int>(syscall(SYS_pidfd_open, supervisor_, 0));
}

SupervisedProcess::~SupervisedProcess() {
  if (getpid() == owner_) end();
  if (descriptor_ >= 0) close(descriptor_);
}

bool SupervisedProcess::ends_within(int milliseconds) {
  if (ended_) return true;
  pollfd process{descriptor_, POLLIN, 0};
  poll(&process, 1, milliseconds);
  ended_ = waitpid(supervisor_, &status_, WNOHANG) != 0;
  return ended_;
}

int SupervisedProcess::wait() {
  while (!ends_within(1000)) {
  }
  return status_;
}

int SupervisedProcess::end() {
  if (!ended_) {
    // The child may have stopped it, again and again: a clock of our own ends that.
    const auto limit = std::chrono::steady_clock::now() + 2 * killing_limit;
    int pause = 0;
    do {
      kill(supervisor_, std::chrono::steady_clock::now() < limit ? SIGTERM : SIGKILL);
      kill(supervisor_, SIGCONT);
      pause = std::min(pause + 10, 200);
    } while (!ends_within(pause));
  }
  return status_;
}

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// Address space of this process now [bytes].
double address_space() {
  std::int64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return static_cast<double>(pages * sysconf(_SC_PAGESIZE));
}

}  // namespace

void limit_resources(double megabytes) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (sanitized) return;
  const auto most = static_cast<rlim_t>(address_space() + 1e6 * std::min(megabytes, 1e9));
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
}

namespace {

/// Returns the limit with which so many descriptors are free: one more than the highest of them.
int limit_for(int number) {
  int limit = 0;
  for (int free = 0; free < number; ++limit) {
    if (fcntl(limit, F_GETFD) < 0) ++free;
  }
  return limit;
}

}  // namespace

void allow_further_open_files(int number) {
  const int needed = limit_for(number);
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  const rlim_t before = limit.rlim_cur;
  limit.rlim_cur = static_cast<rlim_t>(needed);
  if (before >= limit.rlim_cur) return;
  if (limit.rlim_cur <= limit.rlim_max && setrlimit(RLIMIT_NOFILE, &limit) == 0) return;
  throw OutputError(fmt::format("too many open files: the limit is {}; raise it with ulimit -n {}",
                                before, needed));
}

void lead_nowhere(int descriptor) {
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing < 0 || nothing == descriptor) return;
  dup2(nothing, descriptor);
  close(nothing);
}

namespace {

std::function<void(const std::string&)>& listener() {
  static std::function<void(const std::string&)> listener;
  return listener;
}

}  // namespace

void tell_waiting(const std::string& text) {
  if (!text.empty()) std::fputs((text + "\n").c_str(), stderr);
  if (listener()) listener()(text);
}

void on_waiting(std::function<void(const std::string&)> told) {
  listener() = std::move(told);
}

}  // namespace ricochet
