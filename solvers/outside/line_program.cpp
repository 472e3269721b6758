#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <pthread.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "solvers/outside/line_solver.h"
#include "src/core/names.h"
#include "src/core/process.h"

namespace ricochet::outside {

namespace {

constexpr std::size_t chunk = 1 << 16;      // bytes: the capacity of a pipe
constexpr std::size_t kept_of_a_line = 80;  // bytes
constexpr int grace = 1000;                 // ms, for a program to end by itself
constexpr int forever = -1;

/// While this object lives, writing to a program that has ended is an error and does not end
/// ricochet.
class WithoutBrokenPipes {
 public:
  WithoutBrokenPipes() {
    sigemptyset(&signal_);
    sigaddset(&signal_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &signal_, &before_);
  }
  ~WithoutBrokenPipes() {
    const timespec at_once{};
    if (broken) sigtimedwait(&signal_, nullptr, &at_once);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutBrokenPipes(const WithoutBrokenPipes&) = delete;
  WithoutBrokenPipes& operator=(const WithoutBrokenPipes&) = delete;

  bool broken = false;

 private:
  sigset_t signal_{}, before_{};
};

[[noreturn]] void refuse(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void open_pipe(Descriptor& end_to_read, Descriptor& end_to_write) {
  int ends[2] = {};
  if (pipe2(ends, O_CLOEXEC) != 0) refuse("pipe");  // not inherited by other programs
  end_to_read.take(ends[0]);
  end_to_write.take(ends[1]);
}

std::vector<char*> pointers_to(std::vector<std::string>& arguments) {
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// A pair of connected sockets.
void open_sockets(int type, Descriptor& one, Descriptor& other) {
  int ends[2] = {};
  if (socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends) != 0) refuse("socketpair");
  one.take(ends[0]);
  other.take(ends[1]);
}

/// Replaces this process by the program. Between fork and exec only async-signal-safe calls are
/// allowed.
[[noreturn]] void become(char* const* arguments, int input, int output) {
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int ignored : {SIGPIPE, SIGXFSZ}) std::signal(ignored, SIG_DFL);
  execvp(arguments[0], arguments);
  _exit(errno == ENOENT ? 127 : 126);
}

}  // namespace

LineProgram::LineProgram(std::vector<std::string> arguments, const Surroundings& surroundings)
    : maker_(getpid()),
      thread_(std::this_thread::get_id()),
      command_(one_line(fmt::to_string(fmt::join(arguments, " ")))) {
  Descriptor its_input, its_output;
  open_pipe(its_input, input_);
  open_pipe(output_, its_output);
  fcntl(input_.number(), F_SETFL, O_NONBLOCK);
  const std::vector<char*> pointers = pointers_to(arguments);
  process_.emplace([&] {
    if (!surroundings.folder.empty() && chdir(surroundings.folder.c_str()) != 0) _exit(126);
    if (!surroundings.errors.empty()) {
      const int errors = open(surroundings.errors.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
      if (errors >= 0) dup2(errors, STDERR_FILENO);
    }
    if (surroundings.megabytes) limit_resources(*surroundings.megabytes);
    become(pointers.data(), its_input.number(), its_output.number());
  });
}

LineProgram::LineProgram(int connection, std::string command)
    : maker_(getpid()),
      thread_(std::this_thread::get_id()),
      command_(std::move(command)),
      input_(connection),
      output_(fcntl(connection, F_DUPFD_CLOEXEC, 0)) {
  if (output_.number() < 0) refuse("fcntl");
  fcntl(connection, F_SETFL, O_NONBLOCK);
}

LineProgram::~LineProgram() {
  if (getpid() != maker_) return;  // in a forked copy of the process that started it
  input_.close();
  output_.close();  // so that a program that is still writing also ends
  if (process_) process_->ends_within(grace);
}

bool LineProgram::is_of_this_thread() const {
  return getpid() == maker_ && std::this_thread::get_id() == thread_;
}

std::string LineProgram::how_it_ended() {
  if (!process_) return "closed its connection";
  if (!process_->ends_within(grace)) return "closed its standard output";
  const int status = process_->end();
  if (WIFSIGNALED(status)) {
    return fmt::format("was ended by signal {}, {}", WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  const int code = WEXITSTATUS(status);
  const char* usual = code == 127   ? ": there is no such program"
                      : code == 126 ? ": it cannot be run"
                                    : "";
  return fmt::format("ended with exit code {}{}", code, usual);
}

/// Waits for output and reads it into read_. Returns false at the time limit; sets at_end_ at the
/// end of the output.
bool LineProgram::read_more(int limit_in_milliseconds) {
  read_.erase(0, begin_);
  begin_ = 0;
  // A process that the program started may keep the output open after the program has ended.
  pollfd ends[] = {{output_.number(), POLLIN, 0},
                   {process_ ? process_->descriptor() : -1, POLLIN, 0}};
  if (poll(ends, 2, limit_in_milliseconds) == 0) return false;
  if (ends[0].revents == 0 && poll(ends, 1, 0) == 0) {  // nothing written just before either
    at_end_ = true;
    return true;
  }
  char piece[chunk];  // NOLINT: not zeroed, which would take longer than reading
  const ssize_t count = ::read(output_.number(), piece, chunk);
  read_.append(piece, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  at_end_ = count == 0 || (count < 0 && errno != EINTR);
  return true;
}

std::string LineProgram::last_line() const {
  return lines_ == 0 ? "no line received yet" : "last line received: " + one_line(last_);
}

/// Waits for output as long as the patience lasts. Returns false at its end.
bool LineProgram::waited_for_more(const Patience& patience) {
  const auto notice = static_cast<int>(patience.notice.count());
  int limit = patience.limit ? static_cast<int>(patience.limit->count()) * 1000 : forever;
  if (patience.until) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(
        *patience.until - std::chrono::steady_clock::now());
    limit = static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 1'000'000'000));
  }
  if (limit != forever && limit <= notice) return read_more(limit);
  if (read_more(notice)) return true;
  tell_waiting(fmt::format("waiting for {}; {}", command_, last_line()));
  const bool more = read_more(limit == forever ? forever : limit - notice);
  if (more) tell_waiting("");
  return more;
}

std::optional<std::string_view> LineProgram::line(const Patience& patience) {
  std::size_t searched = 0;  // from begin_ on
  for (;;) {
    const std::size_t end = read_.find('\n', begin_ + searched);
    if (end != std::string::npos || (at_end_ && begin_ < read_.size())) {
      const auto found = std::string_view(read_).substr(begin_, end - begin_);
      begin_ = std::min(end, read_.size() - 1) + 1;
      last_ = found.substr(0, kept_of_a_line);
      ++lines_;
      return found;
    }
    if (at_end_) return std::nullopt;
    searched = read_.size() - begin_;
    if (searched > longest_line) throw std::runtime_error("a line of more than 4 MiB");
    if (!waited_for_more(patience)) {
      if (patience.until) {
        const char* const hint = lines_ == 0 ? "; are its lines flushed?" : "";
        throw std::runtime_error("took too long; " + last_line() + hint);
      }
      throw std::runtime_error(
          fmt::format("wrote nothing for {} s after {}; {}; are its lines flushed?",
                      patience.limit->count(), patience.after, last_line()));
    }
  }
}

bool LineProgram::has_spoken() {
  if (begin_ < read_.size()) return true;
  pollfd end{output_.number(), POLLIN, 0};
  if (poll(&end, 1, 0) != 1 || (end.revents & POLLIN) == 0) return false;
  read_more(0);  // nothing where it is a socket that was closed
  return begin_ < read_.size();
}

/// Waits until the program accepts more, and reads meanwhile: the program may also be waiting to
/// write.
void LineProgram::wait_to_send() {
  pollfd ends[] = {{input_.number(), POLLOUT, 0}, {output_.number(), POLLIN, 0}};
  poll(ends, 2, forever);
  if (ends[0].revents != 0 || ends[1].revents == 0) return;
  read_more(forever);
  if (read_.size() > longest_line) throw std::runtime_error("4 MiB without reading an answer");
}

void LineProgram::send(std::string_view text) {
  WithoutBrokenPipes pipes;
  while (!text.empty() && !at_end_) {
    const ssize_t count = ::write(input_.number(), text.data(), text.size());
    if (count >= 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN) {
      wait_to_send();
    } else if (errno != EINTR) {
      pipes.broken = errno == EPIPE;
      return;
    }
  }
}

ForkingProgram::ForkingProgram(std::vector<std::string> arguments)
    : maker_(getpid()),
      thread_(std::this_thread::get_id()),
      command_(one_line(fmt::to_string(fmt::join(arguments, " ")))) {
  Descriptor its_control;
  open_sockets(SOCK_SEQPACKET, control_, its_control);
  const std::vector<char*> pointers = pointers_to(arguments);
  process_.emplace([&] { become(pointers.data(), its_control.number(), STDERR_FILENO); });
}

bool ForkingProgram::may_serve_this_thread() const {
  return getpid() != maker_ || std::this_thread::get_id() == thread_;
}

std::unique_ptr<LineProgram> ForkingProgram::copy() {
  Descriptor ours, its;
  open_sockets(SOCK_STREAM, ours, its);
  char byte = 0;
  iovec text{&byte, 1};
  alignas(cmsghdr) char space[CMSG_SPACE(sizeof(int))] = {};
  msghdr message{};
  message.msg_iov = &text;
  message.msg_iovlen = 1;
  message.msg_control = space;
  message.msg_controllen = sizeof space;
  cmsghdr* header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(int));
  const int number = its.number();
  std::memcpy(CMSG_DATA(header), &number, sizeof number);
  if (sendmsg(control_.number(), &message, MSG_NOSIGNAL) != 1) return nullptr;
  return std::make_unique<LineProgram>(ours.release(), command_);
}

}  // namespace ricochet::outside
