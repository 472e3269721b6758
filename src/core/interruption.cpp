#include "src/core/interruption.h"

#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <thread>
#include <utility>
#include <vector>

namespace ricochet {
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
