#pragma once

#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "tests/support/test.h"

namespace ricochet {

/// A pipe that is closed at the end.
class Pipe {
 public:
  Pipe() { EXPECT_EQ(pipe(ends_), 0); }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void stop_reading() { close_end(0); }
  void stop_writing() { close_end(1); }

  void put(std::string_view bytes) const {
    EXPECT_EQ(write(ends_[1], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }

  /// All that is still to be read, once no process holds the end for writing any more.
  std::string rest() {
    stop_writing();
    std::string all;
    char byte = 0;
    while (read(ends_[0], &byte, 1) == 1) all += byte;
    return all;
  }
  bool is_held_by_nobody() { return rest().empty(); }

 private:
  void close_end(int end) {
    if (ends_[end] >= 0) close(ends_[end]);
    ends_[end] = -1;
  }

  int ends_[2] = {-1, -1};
};

/// Whether terminals can be made here: not so in a bare chroot, without /dev/pts.
inline bool has_terminals() {
  int ours = -1, terminal = -1;
  if (openpty(&ours, &terminal, nullptr, nullptr, nullptr) != 0) return false;
  close(ours), close(terminal);
  return true;
}

/// What `work` writes to standard error where that is a terminal of so many columns; 0: of unknown
/// width.
template <class Work>
std::string shown_on_terminal(const Work& work, unsigned short columns = 0) {
  int ours = -1, terminal = -1;
  const winsize size{24, columns, 0, 0};
  EXPECT_EQ(openpty(&ours, &terminal, nullptr, nullptr, &size), 0);
  const int standard_error = dup(STDERR_FILENO);
  dup2(terminal, STDERR_FILENO);
  work();
  dup2(standard_error, STDERR_FILENO);
  std::string shown(1000, '\0');
  shown.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(ours, shown.data(), 1000))));
  for (const int each : {ours, terminal, standard_error}) close(each);
  return shown;
}

}  // namespace ricochet
