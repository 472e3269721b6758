#pragma once

#include <sys/types.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "ricochet/solver.h"
#include "solvers/outside/plugin.h"
#include "src/core/child_process.h"

namespace ricochet::outside {

/// Longest line of either side, in bytes.
inline constexpr std::size_t longest_line = 4 << 20;

/// How long a line is waited for.
struct Patience {
  std::optional<std::chrono::seconds> limit = {};  ///< of silence; none: without end
  const char* after = "";                          ///< what it is counted from: "it was started"
  std::chrono::milliseconds notice{10'000};        ///< until tell_waiting() is called
  /// When the line must be there as a whole.
  std::optional<std::chrono::steady_clock::time_point> until = {};
};

/// Where and with what a program runs.
struct Surroundings {
  std::filesystem::path folder = {};     ///< empty: that of ricochet
  std::filesystem::path errors = {};     ///< file for its standard error; empty: that of ricochet
  std::optional<double> megabytes = {};  ///< of memory, besides that of ricochet
};

/// The words of a command, split as a shell does it, but no shell is used. Throws InputError if it
/// is not one program with its arguments.
std::vector<std::string> words_of(const std::string& command);

/// A program that exchanges lines with ricochet through its standard input and output. Only the
/// thread that started it may use it; the program, and whatever it has started, ends at the latest
/// with that thread.
///
/// A program that writes without reading, ends, or closes its streams blocks no one. One that does
/// nothing is waited for, unless there is a limit; tell_waiting() reports it meanwhile.
class LineProgram {
 public:
  /// Starts arguments[0], found on PATH. Throws std::system_error if the system has no resources
  /// for it. A program that does not exist ends with exit code 127.
  explicit LineProgram(std::vector<std::string> arguments, const Surroundings& surroundings = {});

  /// Takes over one end of a connection, a socket, at whose other end is a program of this name
  /// that somebody else started.
  LineProgram(int connection, std::string command);

  /// Closes the program's standard streams, or the connection, and kills it if it does not end
  /// within a second.
  ~LineProgram();
  LineProgram(const LineProgram&) = delete;
  LineProgram& operator=(const LineProgram&) = delete;

  /// Sends text that ends in a newline. Text to a program that has ended is lost; the next line()
  /// reports that end. Throws std::runtime_error if the program writes 4 MiB without reading.
  void send(std::string_view text);

  /// The program's next line, without the newline, valid until the next call of line() or send();
  /// nothing if the program has ended. Throws std::runtime_error if a line is longer than 4 MiB, or
  /// if none comes in time.
  std::optional<std::string_view> line(const Patience& patience = {});

  /// The number of lines written by the program and read so far.
  int lines() const { return lines_; }

  /// Returns true if the program has written output that is not yet read.
  bool has_spoken();

  /// Returns true if the calling thread of this very process started it.
  bool is_of_this_thread() const;

  /// How the program ended, e.g. "ended with exit code 1"; to be called after line() returned
  /// nothing.
  std::string how_it_ended();

 private:
  bool read_more(int limit_in_milliseconds);
  bool waited_for_more(const Patience& patience);
  void wait_to_send();

  /// The last line received, in words.
  std::string last_line() const;

  const pid_t maker_;
  const std::thread::id thread_;
  const std::string command_;
  std::optional<SupervisedProcess> process_;  // none of a connection
  Descriptor input_, output_;
  std::string read_;  // read but not yet returned, from begin_ on
  std::string last_;  // the beginning of the line returned last
  std::size_t begin_ = 0;
  bool at_end_ = false;  // of its output
  int lines_ = 0;
};

/// A program that serves many conversations at once by copies of itself, so that what it loads is
/// loaded once, also for processes that this one forks later. Its standard input is a socket of the
/// type SOCK_SEQPACKET, by which it receives the ends of connections; what it writes goes to
/// standard error. It ends with the thread that started it, and all copies with it.
class ForkingProgram {
 public:
  /// Starts arguments[0], found on PATH. Throws std::system_error if the system has no resources.
  explicit ForkingProgram(std::vector<std::string> arguments);

  /// Returns true if the calling thread started it, or a process that this one is forked from: no
  /// other thread may end before the program's conversations do.
  bool may_serve_this_thread() const;

  /// A copy to converse with, which ends at the latest with the object; null if the program has
  /// ended.
  std::unique_ptr<LineProgram> copy();

 private:
  const pid_t maker_;
  const std::thread::id thread_;
  const std::string command_;
  Descriptor control_;
  std::optional<SupervisedProcess> process_;
};

/// Reads the program's first line: what it claims. Throws std::runtime_error if it breaks the
/// protocol.
Claims greeting_of(LineProgram& program);

/// Processes that wait to be used again, each by the thread that made it.
template <class Process>
class WaitingProcesses {
 public:
  /// One of this thread, or null if none waits.
  std::unique_ptr<Process> take() {
    const std::scoped_lock lock(mutex_);
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [](const auto& each) { return each->is_of_this_thread(); });
    if (found == waiting_.end()) return nullptr;
    std::unique_ptr<Process> process = std::move(*found);
    waiting_.erase(found);
    return process;
  }

  void give_back(std::unique_ptr<Process> process) {
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(std::move(process));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<Process>> waiting_;
};

/// Programs of a solver that wait for a start, each for the thread that started it.
class WaitingPrograms {
 public:
  /// `start` starts a program and reads its greeting.
  explicit WaitingPrograms(std::function<std::unique_ptr<LineProgram>()> start)
      : start_(std::move(start)) {}

  /// One start of the solver, as Solver::solve, with text `first` before the problem. If the
  /// program ended after the last start, it is started again. Throws std::runtime_error if the
  /// program breaks the protocol or ends before it is done.
  SolverTermination solve(Evaluator& evaluator, const Vector& start, Random& random,
                          const std::string& first = "");

  void give_back(std::unique_ptr<LineProgram> program) { waiting_.give_back(std::move(program)); }

 private:
  const std::function<std::unique_ptr<LineProgram>()> start_;
  WaitingProcesses<LineProgram> waiting_;
};

/// A solver that is a program exchanging lines of JSON on its standard input and output; the README
/// describes the protocol. `command` is split as a shell does it, but no shell is used. The program
/// is started once for every thread that solves, and serves one start after the other until it ends
/// or the solver is destroyed. State that it keeps between starts may change its results.
///
/// If the program breaks the protocol, or ends before it is done, the run ends with a
/// std::runtime_error that names the line. Throws InputError if the program cannot be started or
/// does not declare itself.
Solver line_solver(const std::string& command);

}  // namespace ricochet::outside
