#include "solvers/outside/line_solver.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>
#include <wordexp.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "solvers/outside/outside.h"
#include "solvers/outside/plugin.h"
#include "solvers/unit_box.h"
#include "src/core/names.h"
#include "src/core/process.h"

/// The protocol between a solver and ricochet: every line is a JSON object; null stands for a
/// number that is not finite. A violation throws std::runtime_error, which names the line and shows
/// its beginning.
namespace ricochet::outside {

/// Reads the program's first line: its claims.
Claims greeting_of(LineProgram& program);

/// Sends the evaluator's problem to a program and answers its requests until it is done. Returns
/// nothing if the program ended before it wrote a line. Once the run is over, the program may end
/// without reporting that it is done.
std::optional<SolverTermination> converse(LineProgram& program, Evaluator& evaluator,
                                          const Vector& start, std::uint32_t seed);

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

LineProgram::LineProgram(std::vector<std::string> arguments)
    : maker_(getpid()),
      thread_(std::this_thread::get_id()),
      command_(one_line(fmt::to_string(fmt::join(arguments, " ")))) {
  Descriptor its_input, its_output;
  open_pipe(its_input, input_);
  open_pipe(output_, its_output);
  fcntl(input_.number(), F_SETFL, O_NONBLOCK);
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  process_.emplace([&] { become(pointers.data(), its_input.number(), its_output.number()); });
}

LineProgram::~LineProgram() {
  if (getpid() != maker_) return;  // in a forked copy of the process that started it
  input_.close();
  output_.close();  // so that a program that is still writing also ends
  process_->ends_within(grace);
}

bool LineProgram::is_of_this_thread() const {
  return getpid() == maker_ && std::this_thread::get_id() == thread_;
}

std::string LineProgram::how_it_ended() {
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
  pollfd ends[] = {{output_.number(), POLLIN, 0}, {process_->descriptor(), POLLIN, 0}};
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
  const int limit = patience.limit ? static_cast<int>(patience.limit->count()) * 1000 : forever;
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
      throw std::runtime_error(
          fmt::format("wrote nothing for {} s after {}; {}; are its lines flushed?",
                      patience.limit->count(), patience.after, last_line()));
    }
  }
}

bool LineProgram::has_spoken() {
  if (begin_ < read_.size()) return true;
  pollfd end{output_.number(), POLLIN, 0};
  return poll(&end, 1, 0) == 1 && (end.revents & POLLIN) != 0;
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

namespace {

std::vector<std::string> words_of(const std::string& command) {
  wordexp_t found{};
  const int code = wordexp(command.c_str(), &found, WRDE_NOCMD);
  std::vector<std::string> words;
  if (code == 0) words.assign(found.we_wordv, found.we_wordv + found.we_wordc);
  if (code == 0 || code == WRDE_NOSPACE) wordfree(&found);
  if (words.empty()) {
    throw InputError(command + ": is not one program with its arguments; put what a shell shall " +
                     "do into a script");
  }
  return words;
}

/// Started programs that wait for a start, each for the thread that started it.
class WaitingPrograms {
 public:
  explicit WaitingPrograms(std::vector<std::string> words) : words_(std::move(words)) {}

  std::unique_ptr<LineProgram> start(Claims& claims) const {
    auto program = std::make_unique<LineProgram>(words_);
    claims = greeting_of(*program);
    return program;
  }

  /// A program of this thread, or null if none waits.
  std::unique_ptr<LineProgram> take() {
    const std::scoped_lock lock(mutex_);
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [](const auto& each) { return each->is_of_this_thread(); });
    if (found == waiting_.end()) return nullptr;
    auto program = std::move(*found);
    waiting_.erase(found);
    return program;
  }

  void give_back(std::unique_ptr<LineProgram> program) {
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(std::move(program));
  }

 private:
  const std::vector<std::string> words_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<LineProgram>> waiting_;
};

/// One start. If the program ended after the last start, it is started again.
SolverTermination solve(WaitingPrograms& programs, Evaluator& evaluator, const Vector& start,
                        Random& random) {
  const auto seed = static_cast<std::uint32_t>(random() >> 32U);
  std::optional<SolverTermination> exit;
  std::unique_ptr<LineProgram> program = programs.take();
  if (program) exit = converse(*program, evaluator, start, seed);
  if (!exit) {
    Claims known;
    program = programs.start(known);
    exit = converse(*program, evaluator, start, seed);
  }
  if (!exit) throw std::runtime_error(program->how_it_ended() + " when it was given a problem");
  programs.give_back(std::move(program));
  return *exit;
}

}  // namespace

Solver line_solver(const std::string& command) {
  const std::vector<std::string> words = words_of(command);
  const Content content = content_of_command(words);  // before it is started
  const auto programs = std::make_shared<WaitingPrograms>(words);
  Claims claims;
  try {
    programs->give_back(programs->start(claims));
  } catch (const std::exception& error) {
    throw InputError(command + ": " + error.what());
  }
  Solver solver = solver_as_claimed(claims, command);
  solver.content = content.hash();
  solver.changed_file = [content] { return content.changed(); };
  solver.solve = [programs, command](Evaluator& evaluator, const Vector& start, Random& random) {
    try {
      return solve(*programs, evaluator, start, random);
    } catch (const std::exception& error) {
      throw std::runtime_error(command + ": " + error.what());
    }
  };
  return solver;
}

namespace {

using Json = nlohmann::ordered_json;

constexpr std::chrono::seconds patience{60};  // importing a large library takes long
constexpr int most_asked_when_over = 500;     // the same for every solver; see the tests
constexpr std::size_t shown_of_a_line = 80;   // bytes

/// One line of a program: an object with allowed keys only.
class Message {
 public:
  Message(const LineProgram& program, std::string_view line)
      : number_(program.lines()), line_(line), content_(Json::parse(line, nullptr, false)) {
    if (content_.is_discarded()) {
      refuse("is no JSON (what is for people to read belongs on standard error)");
    }
    if (!content_.is_object()) refuse("is no JSON object");
  }

  void allow(const std::vector<std::string>& keys) const {
    for (const auto& [key, value] : content_.items()) {
      if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
      refuse(fmt::format("knows no \"{}\"; {}", key, what_instead(key, keys)));
    }
  }

  bool has(const char* key) const { return content_.contains(key); }

  /// The value of the key, or `otherwise` if it is missing; `is` checks that it has the described
  /// type.
  template <class T>
  T get(const char* key, T otherwise, bool (Json::*is)() const noexcept, const char* type) const {
    if (!has(key)) return otherwise;
    if (!(content_[key].*is)()) refuse(fmt::format("\"{}\" is no {}", key, type));
    return content_[key].get<T>();
  }
  std::string text(const char* key) const {
    return get(key, std::string(), &Json::is_string, "text in quotes");
  }
  bool flag(const char* key) const { return get(key, false, &Json::is_boolean, "true or false"); }

  AskedPoints asked(Eigen::Index dimension) const {
    return understood([&] { return asked_points(content_, "ask", dimension); });
  }
  Vector point(const char* key, Eigen::Index dimension) const {
    return understood([&] { return asked_point(content_[key], key, dimension); });
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw std::runtime_error(fmt::format("output line {} {}: {}{}", number_, reason,
                                         one_line(line_.substr(0, shown_of_a_line)),
                                         line_.size() > shown_of_a_line ? "..." : ""));
  }

 private:
  /// What `read` returns; an InputError names the line.
  template <class Read>
  std::invoke_result_t<const Read&> understood(const Read& read) const {
    try {
      return read();
    } catch (const InputError& error) {
      refuse(error.what());
    }
  }

  int number_;
  std::string_view line_;
  Json content_;
};

Json list_of(const Vector& vector) {
  Json list = Json::array();
  for (const double value : vector) list.push_back(value);
  return list;
}

Json rows_of(const Matrix& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push_back(list_of(matrix.row(i)));
  return rows;
}

void send(LineProgram& program, const Json& message) {
  // Names of problems come from the user: invalid UTF-8 in them is replaced.
  program.send(message.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

Json description_of(Evaluator& evaluator, const Vector& start, std::uint32_t seed) {
  return {{"ricochet", 1},
          {"name", evaluator.name()},
          {"dimension", evaluator.dimension()},
          {"lower", list_of(evaluator.lower())},
          {"upper", list_of(evaluator.upper())},
          {"start", list_of(start)},
          {"constraints", evaluator.constraints()},
          {"equalities", evaluator.equalities()},
          {"derivatives", evaluator.has_derivatives()},
          {"residuals", evaluator.has_residuals()},
          {"budget", evaluator.remaining()},
          {"seed", seed}};
}

/// The residuals at a point, with their Jacobian if `derivatives`; nothing once the run is over.
std::optional<Json> told_residuals(Evaluator& evaluator, const Vector& x, bool derivatives) {
  if (!derivatives) {
    const auto values = evaluator.residual_values(x);
    if (!values) return std::nullopt;
    return Json{{"residuals", list_of(*values)}};
  }
  const auto known = evaluator.residuals(x);
  if (!known) return std::nullopt;
  return Json{{"residuals", list_of(known->values)},
              {"residual_jacobian", rows_of(known->jacobian)}};
}

/// The reply for one point; nothing once the run is over.
std::optional<Json> told(Evaluator& evaluator, const Vector& x, bool derivatives) {
  if (!derivatives) {
    const auto values = evaluator.values(x);
    if (!values) return std::nullopt;
    return Json{{"objective", values->objective}, {"constraints", list_of(values->constraints)}};
  }
  const auto known = evaluator.derivatives(x);
  if (!known) return std::nullopt;
  return Json{{"objective", known->values.objective},
              {"constraints", list_of(known->values.constraints)},
              {"gradient", list_of(known->gradient)},
              {"jacobian", rows_of(known->jacobian)}};
}

/// The reply to a request; nothing once the run is over.
std::optional<Json> answer(Evaluator& evaluator, const Message& message) {
  const AskedPoints asked = message.asked(evaluator.dimension());
  const auto [derivatives, residuals] = asked.wanted;
  if (residuals && !evaluator.has_residuals()) {
    message.refuse("wants residuals, but the problem has none");
  }
  if (derivatives && !residuals && !evaluator.has_derivatives()) {
    message.refuse("wants derivatives, but the problem has none");
  }
  std::vector<Json> replies;
  for (const Vector& x : asked.points) {
    std::optional<Json> one =
        residuals ? told_residuals(evaluator, x, derivatives) : told(evaluator, x, derivatives);
    if (!one) return std::nullopt;
    replies.push_back(std::move(*one));
  }
  Json result = joined(std::move(replies), asked.list);
  result["remaining"] = evaluator.remaining();
  return result;
}

SolverTermination exit_of(const Evaluator& evaluator, const Message& message) {
  message.allow({"done", "point"});
  SolverTermination exit{one_line(message.text("done"))};
  if (message.has("point")) {
    exit.point = message.point("point", evaluator.dimension());
  }
  if (evaluator.over()) exit.reason = stopped_by_evaluator;
  return exit;
}

}  // namespace

Claims greeting_of(LineProgram& program) {
  const auto line = program.line(Patience{patience, "it was started"});
  if (!line) throw std::runtime_error(program.how_it_ended() + ", and has not said what it is");
  const Message greeting(program, *line);
  greeting.allow({"name", "version", "takes_constraints", "needs_derivatives", "needs_residuals",
                  "stochastic"});
  return {greeting.text("name"),
          greeting.text("version"),
          greeting.get("takes_constraints", 0, &Json::is_number_integer, "whole number"),
          greeting.flag("needs_derivatives"),
          greeting.flag("needs_residuals"),
          greeting.flag("stochastic")};
}

std::optional<SolverTermination> converse(LineProgram& program, Evaluator& evaluator,
                                          const Vector& start, std::uint32_t seed) {
  if (program.has_spoken()) {
    throw std::runtime_error(
        fmt::format("spoke after output line {}, when it was done", program.lines()));
  }
  const int lines_before = program.lines();
  send(program, description_of(evaluator, start, seed));
  int asked_when_over = 0;
  for (;;) {
    const auto line =
        program.line(evaluator.over() ? Patience{patience, "it was told to stop"} : Patience{});
    if (!line && program.lines() == lines_before) return std::nullopt;
    if (!line && evaluator.over()) return SolverTermination{stopped_by_evaluator};
    if (!line)
      throw std::runtime_error(program.how_it_ended() + ", and has not said that it is done");
    const Message message(program, *line);
    if (message.has("done")) return exit_of(evaluator, message);
    if (!message.has("ask")) message.refuse("has neither \"ask\" nor \"done\"");
    if (evaluator.over() && ++asked_when_over > most_asked_when_over) {
      message.refuse("asks on, long after it was told to stop");
    }
    const std::optional<Json> found = evaluator.over() ? std::nullopt : answer(evaluator, message);
    send(program, found ? *found : Json{{"stop", true}});
  }
}

}  // namespace ricochet::outside
