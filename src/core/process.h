#pragma once

#include <sys/types.h>

#include <chrono>
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

  /// Waits until it ends by itself. Returns how the child ended, as waitpid() does.
  int wait();

  /// Kills what is left. Returns the same.
  int end();

 private:
  const pid_t owner_;
  pid_t supervisor_ = -1;
  int descriptor_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

/// Limits this process, a child: `megabytes` of memory besides what it has now, and no core file.
/// With sanitizers memory is not limited, since their own needs the whole address space.
void limit_resources(double megabytes);

/// Lets this process open so many files, pipes and sockets besides those that it has open. Throws
/// OutputError with the system's limit if that is too low.
void allow_further_open_files(int number);

/// From now on nothing can be read from this descriptor, and what is written to it is lost.
void lead_nowhere(int descriptor);

/// Tells that this thread has waited long for something outside the program, such as "waiting for
/// python3 mine.py; last line received: ..."; an empty text tells that the wait is over. A text is
/// written to standard error as a line.
void tell_waiting(const std::string& text);

/// From now on tell_waiting() also calls this. Must be called before a second thread waits.
void on_waiting(std::function<void(const std::string&)> told);

}  // namespace ricochet
