#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::mpi {

/// A process of `ricochet`, which stands beside this program, that frames are exchanged with.
class Child {
 public:
  /// Throws std::system_error where there can be none.
  explicit Child(std::vector<std::string> arguments);

  /// Lets it end by itself.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Returns whether it still listens.
  bool tell(const std::string& message);

  /// Waits, but no longer than that, until there is something to hear, or it has ended.
  bool waits_for_news(std::chrono::milliseconds most);

  /// Nothing where it has ended.
  std::optional<std::string> hear();

  /// Ends what is told and waits for its end. Returns its exit code, or 128 and the signal.
  int wait();

 private:
  int to_ = -1, from_ = -1;
  pid_t process_ = -1;
};

}  // namespace ricochet::mpi
