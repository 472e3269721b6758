#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::mpi {

/// A child process of `ricochet`, the program beside this one, with which frames are exchanged.
class Child {
 public:
  /// Throws std::system_error if no process can be started.
  explicit Child(std::vector<std::string> arguments);

  /// Waits until it ends by itself.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Sends a message. Returns whether it still listens.
  bool tell(const std::string& message);

  /// Waits for at most this time. Returns true if there is a message or it has ended.
  bool waits_for_news(std::chrono::milliseconds most);

  /// The next message; nothing if it has ended.
  std::optional<std::string> hear();

  /// Closes its input and waits for its end. Returns its exit code, or 128 plus the signal.
  int wait();

 private:
  int to_ = -1, from_ = -1;
  pid_t process_ = -1;
};

}  // namespace ricochet::mpi
