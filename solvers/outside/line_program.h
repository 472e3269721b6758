#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace ricochet::outside {

/// A file descriptor that is closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void close();
  void take(int number);

 private:
  int number_;  // -1: none
};

/// How long a line is waited for, and after what.
struct Patience {
  std::chrono::seconds limit;
  const char* after;  ///< e.g. "it was started"
};

/// A program that lines are exchanged with, through its standard input and output. Its standard
/// error is ours. For the thread that started it alone; it ends when that thread does, at the
/// latest.
///
/// A program that writes without reading, ends, or closes its streams blocks nobody. One that does
/// nothing at all is waited for, unless there is a limit.
class LineProgram {
 public:
  /// Starts arguments[0], found on PATH. Throws std::system_error if the system has no room for it.
  /// A program that is not there ends with exit code 127.
  explicit LineProgram(std::vector<std::string> arguments);

  /// Closes its standard streams, and ends it where it does not do so itself within a second.
  ~LineProgram();
  LineProgram(const LineProgram&) = delete;
  LineProgram& operator=(const LineProgram&) = delete;

  /// Sends text that ends in a newline. What a program does not take because it ended is lost: the
  /// next line() says so. Throws std::runtime_error where it writes 4 MiB without reading.
  void send(std::string_view text);

  /// Its next line, without the newline, until the next call of line() or send(); nothing once it
  /// has ended. Throws std::runtime_error where a line is longer than 4 MiB, or none comes within
  /// the limit.
  std::optional<std::string_view> line(const std::optional<Patience>& patience = std::nullopt);

  /// Lines that it has written so far, and that were read.
  int lines() const { return lines_; }

  /// Whether it has written what nobody has read.
  bool has_spoken();

  /// Whether it was started by the calling thread of this very process.
  bool is_of_this_thread() const;

  /// "ended with exit code 1": how it did, once line() returned nothing.
  std::string how_it_ended();

 private:
  bool read_more(int limit_in_milliseconds);
  void wait_to_send();
  bool ends_within(int milliseconds);

  const pid_t maker_;
  const std::thread::id thread_;
  pid_t child_ = 0;
  bool ended_ = false;  // and was waited for
  int status_ = 0;
  Descriptor process_;  // readable once it has ended
  Descriptor input_, output_;
  std::string read_;  // and not yet handed out, from begin_ on
  std::size_t begin_ = 0;
  bool at_end_ = false;  // of what it writes
  int lines_ = 0;
};

}  // namespace ricochet::outside
