#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

namespace ricochet {

/// How a process ended, from the status of waitpid(): "crashed: Bus error", "ended the process,
/// with exit status 3".
std::string ending_in_words(int status);

/// A child process with everything that it starts: programs behind wrappers, daemons and orphans
/// included. Between it and its owner, which is this process, stands a supervisor: a small process
/// in a session of its own that adopts all orphans below it. All of them are killed when the child
/// ends, when end() is called, and when the owner ends in whatever way, also by SIGKILL.
class SupervisedProcess {
 public:
  /// Calls `work` in the child, whose exit code is 1 if it returns. The child leads a process group
  /// and dies with its supervisor. It ends at the latest with the thread that calls this. Throws
  /// std::system_error if the system has no resources for two processes.
  explicit SupervisedProcess(const std::function<void()>& work);

  /// As end(); nothing in a forked copy of the owner.
  ~SupervisedProcess();
  SupervisedProcess(const SupervisedProcess&) = delete;
  SupervisedProcess& operator=(const SupervisedProcess&) = delete;

  /// Readable once the child has ended, and nothing is left of it; -1 on a kernel before Linux 5.3.
  int descriptor() const { return descriptor_; }

  /// Waits for its end, at most so long. Returns whether it has ended.
  bool ends_within(int milliseconds);

  /// Kills what is left. Returns how the child ended, as waitpid() does.
  int end();

 private:
  const pid_t owner_;
  pid_t supervisor_ = -1;
  int descriptor_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

}  // namespace ricochet
