#include "problems/own/ways.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ricochet/ricochet.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "solvers/outside/line_solver.h"
#include "solvers/outside/outside.h"
#include "src/core/child_process.h"
#include "src/core/files.h"
#include "src/core/names.h"

namespace ricochet::own {

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

constexpr std::size_t last_words = 300;  // bytes

[[noreturn]] void fail(const std::string& reason) {
  throw std::runtime_error(reason);
}

constexpr double longest = 1e8;  // [s], for a clock that counts nanoseconds

Clock::time_point deadline(const ProblemFile& file) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(std::min(file.program.seconds, longest)));
}

/// A slow program is nothing to report.
outside::Patience patience_for(const ProblemFile& file) {
  return {.notice = std::chrono::hours(24), .until = deadline(file)};
}

/// The end of what a program wrote to its standard error, as a part of a sentence.
std::string last_words_in(const fs::path& errors) {
  std::error_code none;
  const std::uintmax_t size = fs::exists(errors, none) ? fs::file_size(errors, none) : 0;
  const std::uintmax_t begin = size > last_words ? size - last_words : 0;
  std::ifstream in(errors, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(begin));
  std::string text(static_cast<std::size_t>(size - begin), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0)
    text.pop_back();
  return text.empty() ? "" : "; its last words: " + one_line(text);
}

/// A process of the thread that made it.
class OneThreadsWay : public Way {
 public:
  explicit OneThreadsWay(const ProblemFile& file) : file_(file) {}
  bool is_of_this_thread() const override {
    return getpid() == maker_ && std::this_thread::get_id() == thread_;
  }

 protected:
  const ProblemFile& file() const { return file_; }

 private:
  const ProblemFile& file_;
  const pid_t maker_ = getpid();
  const std::thread::id thread_ = std::this_thread::get_id();
};

/// Started once; reads a point a line and answers each with a line of values, as `ricochet
/// evaluate` does.
class Command : public OneThreadsWay {
 public:
  explicit Command(const ProblemFile& file)
      : OneThreadsWay(file),
        program_(outside::words_of(file.program.command),
                 {folder_of(file), errors(), file.program.megabytes}) {}

  Given evaluate(const Vector& x, bool derivatives) override {
    if (program_.has_spoken()) fail("wrote a line that it was not asked for");
    std::error_code none;
    fs::resize_file(errors(), 0, none);  // what a talkative program wrote before
    Json request = {{"x", std::vector<double>(x.begin(), x.end())}};
    if (derivatives) request["derivatives"] = true;
    if (file().program.residuals > 0) request["residuals"] = true;
    try {
      program_.send(request.dump() + "\n");
      const outside::Patience patience = patience_for(file());
      const auto line = program_.line(patience);
      if (!line) fail(program_.how_it_ended());
      return given_in_line(file(), *line, derivatives);
    } catch (const std::exception& error) {
      fail(error.what() + last_words_in(errors()));
    }
  }

 private:
  fs::path errors() const { return scratch_.path() / "errors"; }

  ScratchFolder scratch_;
  outside::LineProgram program_;
};

/// Started for each point, with the name of a file that has its coordinates, as NOMAD does; answers
/// with numbers on its standard output or, as Dakota's do, in a file.
class Executable : public OneThreadsWay {
 public:
  using OneThreadsWay::OneThreadsWay;

  Given evaluate(const Vector& x, bool /*derivatives*/) override {
    const fs::path results = scratch_.path() / "results", errors = scratch_.path() / "errors";
    for (const fs::path& old : {results, errors}) fs::remove(old);
    std::ofstream(scratch_.path() / "point") << text_of(x);
    const std::vector<std::string> words = call();
    const bool in_file = std::find(words.begin(), words.end(), results) != words.end();
    try {
      outside::LineProgram program(words, {folder_of(file()), errors, file().program.megabytes});
      const outside::Patience patience = patience_for(file());
      std::string text;
      while (const auto line = program.line(patience)) {
        text.append(*line).push_back('\n');
        if (text.size() > outside::longest_line) fail("printed more than 4 MiB");
      }
      const std::string end = program.how_it_ended();
      if (end != "ended with exit code 0") fail(end);
      return given_in_numbers(file(), in_file ? text_of_file(results) : text);
    } catch (const std::exception& error) {
      fail(error.what() + last_words_in(errors));
    }
  }

 private:
  /// The words of the call, with the names of the files in place of @in and @out, or behind it.
  std::vector<std::string> call() const {
    std::vector<std::string> words = outside::words_of(file().program.executable);
    const bool dakota = file().program.format == PointFormat::dakota;
    const auto put = [&](const char* mark, const char* name, bool needed) {
      const std::string path = scratch_.path() / name;
      const auto found = std::find(words.begin(), words.end(), mark);
      if (found != words.end()) {
        *found = path;
      } else if (needed) {
        words.push_back(path);
      }
    };
    put("@in", "point", true);
    put("@out", "results", dakota);
    return words;
  }

  std::string text_of(const Vector& x) const {
    if (file().program.format == PointFormat::numbers)
      return fmt::format("{:.17g}\n", fmt::join(x, " "));
    std::string text = fmt::format("{} variables\n", x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      text += fmt::format("{:.17g} {}\n", x[i], file().variables[static_cast<std::size_t>(i)].name);
    }
    const auto list = [&text](std::size_t size, const char* what, const auto& line) {
      text += fmt::format("{} {}\n", size, what);
      for (std::size_t i = 0; i < size; ++i) text += line(i) + "\n";
    };
    const std::vector<std::string>& outputs = file().program.outputs;
    list(outputs.size(), "functions",
         [&](std::size_t i) { return fmt::format("1 ASV_{}:{}", i + 1, outputs[i]); });
    list(file().variables.size(), "derivative_variables", [&](std::size_t i) {
      return fmt::format("{} DVV_{}:{}", i + 1, i + 1, file().variables[i].name);
    });
    return text + "0 analysis_components\n1 eval_id\n";
  }

  ScratchFolder scratch_;
};

/// A shared library in a child process, which it may crash.
class Library : public OneThreadsWay {
 public:
  explicit Library(const ProblemFile& file)
      : OneThreadsWay(file),
        path_(folder_of(file) / file.program.library),
        child_([this](int channel) { serve(channel); }) {}

  Given evaluate(const Vector& x, bool derivatives) override {
    std::string request(1, derivatives ? 'd' : 'v');
    request.append(reinterpret_cast<const char*>(x.data()),
                   static_cast<std::size_t>(x.size()) * sizeof(double));
    const auto until = deadline(file());
    child_.tell(request);
    std::optional<std::string> answer;
    while (!(answer = child_.next())) {
      if (!child_.has_news(until)) fail("took too long");
      if (!child_.listen()) fail(ending_in_words(child_.end()));
    }
    const std::string_view rest = std::string_view(*answer).substr(1);
    if (answer->front() == failed) fail(std::string(rest));
    Given given = nothing_given(file(), derivatives);
    if (!read_bytes(rest, given)) fail("wrote beyond its arrays");
    make_binary(file(), given.constraints);
    return given;
  }

 private:
  static constexpr char failed = 'f', done = 'd';
  using Function = decltype(&ricochet_evaluate);

  /// In the child.
  void serve(int channel) const {
    limit_resources(file().program.megabytes);
    lead_nowhere(STDIN_FILENO);
    void* library = dlopen(path_.c_str(), RTLD_NOW | RTLD_LOCAL);
    const char* reason = library == nullptr ? dlerror() : nullptr;
    Function function = nullptr;
    if (library != nullptr) {
      function = reinterpret_cast<Function>(dlsym(library, "ricochet_evaluate"));
      if (function == nullptr) reason = "it exports no ricochet_evaluate";
    }
    FrameReader reader;
    for (;;) {
      std::optional<std::string> request;
      while (!(request = reader.next())) {
        if (!reader.read_from(channel)) _exit(0);
      }
      if (!write_frame(channel, reason != nullptr ? failed + std::string(reason)
                                                  : answer_of(function, *request))) {
        _exit(0);
      }
    }
  }

  std::string answer_of(Function function, const std::string& request) const {
    Vector x(static_cast<Eigen::Index>(file().variables.size()));
    std::memcpy(x.data(), request.data() + 1, static_cast<std::size_t>(x.size()) * sizeof(double));
    Given given = nothing_given(file(), request[0] == 'd');
    const auto where = [](auto& part) { return part.size() == 0 ? nullptr : part.data(); };
    ricochet_values_at values{RICOCHET_ABI,
                              static_cast<std::int32_t>(x.size()),
                              static_cast<std::int32_t>(given.constraints.size()),
                              static_cast<std::int32_t>(given.residuals.size()),
                              &given.objective,
                              where(given.constraints),
                              where(given.gradient),
                              where(given.jacobian),
                              where(given.residuals),
                              where(given.residual_jacobian)};
    try {
      const std::int32_t code = function(x.data(), &values);
      if (code != 0) return fmt::format("{}returned {}", failed, code);
    } catch (const std::exception& error) {
      return fmt::format("{}threw: {}", failed, one_line(error.what()));
    } catch (...) {
      return fmt::format("{}threw what is no std::exception", failed);
    }
    if (given.residuals.size() > 0 && std::isnan(given.objective)) {
      given.objective = half_sum_of_squares(given.residuals);
    }
    return done + bytes_of(given);
  }

  const fs::path path_;
  ChildProcess child_;
};

}  // namespace

std::filesystem::path folder_of(const ProblemFile& file) {
  const fs::path folder = fs::absolute(file.path).parent_path();
  return folder.empty() ? fs::current_path() : folder;
}

std::unique_ptr<Way> way_of(const ProblemFile& file) {
  if (!file.program.command.empty()) return std::make_unique<Command>(file);
  if (!file.program.library.empty()) return std::make_unique<Library>(file);
  return std::make_unique<Executable>(file);
}

}  // namespace ricochet::own
