#include "src/core/progress.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "src/core/names.h"

namespace ricochet {

namespace {

using std::chrono::steady_clock;

constexpr std::chrono::seconds between_lines{10};  // elsewhere than on a terminal

std::atomic<bool> silent = false;

/// The columns of the terminal that standard error is; many if it does not say.
std::size_t terminal_columns() {
  winsize size{};
  const bool says = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return says ? size.ws_col : 1000;
}

}  // namespace

void Progress::announce(std::string_view line) {
  if (!silent) std::fputs((one_line(line) + "\n").c_str(), stderr);
}

bool Progress::redraws() {
  const char* const terminal = std::getenv("TERM");
  const bool takes_escapes =
      terminal != nullptr && *terminal != '\0' && std::string_view(terminal) != "dumb";
  return takes_escapes && isatty(STDERR_FILENO) == 1;
}

void Progress::silence() {
  silent = true;
}

Progress::Progress(std::string what, double work, First first)
    : what_(std::move(what)),
      work_(work),
      redraws_(redraws()),
      start_(steady_clock::now()),
      drawn_(first == First::at_once ? start_ - between_lines : start_),
      interrupted_([this] {
        if (!silent.exchange(true) && redraws_) std::fputs("\n", stderr);  // the bar stays
      }) {}

Progress::~Progress() {
  if (redraws_ && !silent) draw(true);
}

void Progress::begin(std::string what, steady_clock::time_point start) {
  const std::lock_guard lock(mutex_);
  what_ = std::move(what);
  done_ = 0;
  start_ = start;
}

void Progress::advance(double work) {
  using namespace std::chrono_literals;
  const std::lock_guard lock(mutex_);
  done_ += work;
  if (silent || steady_clock::now() - drawn_ < (redraws_ ? 100ms : between_lines)) return;
  drawn_ = steady_clock::now();
  draw(false);
}

void Progress::draw(bool last) const {
  constexpr int width = 30;
  const double share = std::clamp(done_ / work_, 0.0, 1.0);
  const double elapsed = std::chrono::duration<double>(steady_clock::now() - start_).count();
  const std::string time =
      last ? fmt::format("{:.1f} s", elapsed)
           : (share > 0 ? fmt::format("{:.0f} s left", elapsed * (1 - share) / share)
                        : fmt::format("{:.0f} s", elapsed));
  if (redraws_) {
    const auto filled = static_cast<std::size_t>(share * width);
    const std::string bar = std::string(filled, '=') + std::string(width - filled, ' ');
    std::string line = fmt::format("{:<28} [{}] {:3.0f} %  {}", what_, bar, 100 * share, time);
    const std::size_t columns = terminal_columns();
    if (line.size() >= columns) line = fmt::format("{} {:.0f} %  {}", what_, 100 * share, time);
    line = fmt::format("\r\033[K{}{}", line.substr(0, columns - 1), last ? "\n" : "");
    std::fputs(line.c_str(), stderr);
  } else {
    std::fputs(fmt::format("{}: {:.0f} %, {}\n", what_, 100 * share, time).c_str(), stderr);
  }
  std::fflush(stderr);
}

void warn(const std::string& text) {
  static std::mutex mutex;
  static std::set<std::string> given;
  const std::lock_guard lock(mutex);
  if (given.insert(text).second) std::fputs(("warning: " + one_line(text) + "\n").c_str(), stderr);
}

namespace {

constexpr int interruptions[] = {SIGHUP, SIGINT, SIGTERM};

// Neither is ever destroyed: an interruption may come while the program ends.
std::recursive_mutex& mutex() {
  static auto& mutex = *new std::recursive_mutex;
  return mutex;
}
std::vector<const AtInterruption*>& registered() {
  static auto& registered = *new std::vector<const AtInterruption*>;
  return registered;
}

}  // namespace

void end_interrupted(int signal) {
  const Uninterrupted nothing_half_done;
  std::string said;
  for (auto each = registered().rbegin(); each != registered().rend(); ++each) {
    (*each)->work_();
    if (!(*each)->says_.empty()) said += "; " + (*each)->says_;
  }
  std::fputs(fmt::format("ricochet: interrupted{}\n", said).c_str(), stderr);
  _exit(128 + signal);
}

void end_tidily_when_interrupted() {
  sigset_t waited_for;
  sigemptyset(&waited_for);
  for (const int signal : interruptions) {
    struct sigaction now {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler != SIG_IGN) sigaddset(&waited_for, signal);
  }
  // Blocked in this thread and all that it starts. A thread of its own receives the signals: it may
  // do what a signal handler may not.
  pthread_sigmask(SIG_BLOCK, &waited_for, nullptr);
  std::thread([waited_for] {
    int signal = 0;
    sigwait(&waited_for, &signal);
    // Some programs, such as timeout(1), signal a process and then its whole group: this is not a
    // second interruption.
    const timespec echo{0, 50'000'000};
    sigtimedwait(&waited_for, nullptr, &echo);
    pthread_sigmask(SIG_UNBLOCK, &waited_for, nullptr);
    end_interrupted(signal);
  }).detach();
}

void end_at_once_when_interrupted() {
  sigset_t all;
  sigemptyset(&all);
  for (const int signal : interruptions) sigaddset(&all, signal);
  pthread_sigmask(SIG_UNBLOCK, &all, nullptr);
}

AtInterruption::AtInterruption(std::function<void()> work, std::string says)
    : work_(std::move(work)), says_(std::move(says)) {
  const Uninterrupted lock;
  registered().push_back(this);
}

AtInterruption::~AtInterruption() {
  const Uninterrupted lock;
  std::erase(registered(), this);
}

Uninterrupted::Uninterrupted() : lock_(mutex()) {}

}  // namespace ricochet
