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

Eigen::Index count(std::size_t size) {
  return static_cast<Eigen::Index>(size);
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

/// A binary constraint as a number.
double binary(double value) {
  return std::isnan(value) ? missing : value <= 0 ? 0 : 1;
}

void make_binary(const ProblemFile& file, Vector& constraints) {
  for (std::size_t i = 0; i < file.constraints.size(); ++i) {
    if (file.constraints[i].kind != ConstraintKind::binary) continue;
    double& value = constraints[count(i)];
    value = binary(value);
  }
}

double half_sum_of_squares(const Vector& residuals) {
  return residuals.squaredNorm() / 2;
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
      return understood(*line, derivatives);
    } catch (const std::exception& error) {
      fail(error.what() + last_words_in(errors()));
    }
  }

 private:
  fs::path errors() const { return scratch_.path() / "errors"; }

  Given understood(std::string_view line, bool derivatives) const {
    const auto shown = [&] {
      return one_line(line.substr(0, 80)) + (line.size() > 80 ? "..." : "");
    };
    Json answer;
    try {
      answer = Json::parse(line);
    } catch (const Json::out_of_range&) {
      fail("answered with a number that is too large: " + shown());
    } catch (const Json::exception&) {
      fail("answered with what is no JSON: " + shown());
    }
    if (!answer.is_object()) fail("answered with what is no JSON object: " + shown());
    try {
      return values_in(answer, derivatives);
    } catch (const InputError& error) {
      fail(fmt::format("{}: {}", error.what(), shown()));
    }
  }

  Given values_in(const Json& answer, bool derivatives) const {
    static const std::vector<std::string> keys = {"objective", "constraints", "gradient",
                                                  "jacobian",  "residuals",   "residual_jacobian",
                                                  "error"};
    for (const auto& [key, value] : answer.items()) {
      // `ricochet evaluate` itself may be the program.
      if (key == "true_values" || key == "evaluations") continue;
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        throw InputError(
            fmt::format("{} is not expected; {}", one_line(key), what_instead(key, keys)));
    }
    if (answer.contains("error")) {
      const Json& error = answer["error"];
      fail("said: " + one_line(error.is_string() ? error.get<std::string>() : error.dump()));
    }
    Given given = nothing_given(file(), derivatives);
    const bool has_residuals = given.residuals.size() > 0;
    if (has_residuals) read(answer, "residuals", given.residuals);
    if (has_residuals && !answer.contains("objective")) {
      given.objective = half_sum_of_squares(given.residuals);
    } else {
      if (!answer.contains("objective")) throw InputError("objective is missing");
      given.objective = outside::asked_point(Json::array({answer["objective"]}), "objective", 1)[0];
    }
    if (!file().constraints.empty()) read(answer, "constraints", given.constraints);
    make_binary(file(), given.constraints);
    if (!derivatives) return given;
    read(answer, "gradient", given.gradient);
    if (!file().constraints.empty()) read(answer, "jacobian", given.jacobian);
    if (has_residuals) read(answer, "residual_jacobian", given.residual_jacobian);
    return given;
  }

  static void read(const Json& answer, const std::string& key, Vector& target) {
    if (!answer.contains(key)) throw InputError(key + " is missing");
    Json list = answer[key];
    if (list.is_array()) {
      for (Json& entry : list) {
        if (entry.is_boolean()) entry = entry.get<bool>() ? 0 : 1;  // of a binary constraint
      }
    }
    target = outside::asked_point(list, key, target.size());
  }

  static void read(const Json& answer, const std::string& key, Rows& target) {
    if (!answer.contains(key) || !answer[key].is_array() ||
        count(answer[key].size()) != target.rows()) {
      throw InputError(fmt::format("{} must have {} rows", key, target.rows()));
    }
    for (Eigen::Index i = 0; i < target.rows(); ++i) {
      target.row(i) = outside::asked_point(answer[key][static_cast<std::size_t>(i)],
                                           fmt::format("row {} of {}", i + 1, key), target.cols());
    }
  }

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
      return understood(in_file ? text_of_file(results) : text);
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

  /// The numbers of a text; after a number that is alone on its line a word may stand, as in
  /// Dakota's results.
  static std::vector<double> numbers_in(const std::string& text) {
    std::vector<double> numbers;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::replace_if(
          line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
      std::istringstream words(line);
      std::size_t of_line = 0;
      for (std::string word; words >> word; ++of_line) {
        if (const auto number = number_in(word)) {
          numbers.push_back(*number);
        } else if (of_line != 1 || words >> word) {
          fail("gave \"" + one_line(word.substr(0, 80)) + "\", which is no number");
        }
      }
    }
    return numbers;
  }

  /// A number as C, Fortran and others write it; NaN for one of the spellings of none: nan,
  /// -nan(ind), 1.#QNAN.
  static std::optional<double> number_in(std::string word) {
    for (char& letter : word) {
      letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
      if (letter == 'd') letter = 'e';
    }
    if (word.starts_with('+')) word.erase(0, 1);
    if (const auto number = number_of_text<double>(word)) return number;
    if (word.starts_with('-')) word.erase(0, 1);
    const bool none = word.starts_with("nan") || word.find('#') != std::string::npos;
    return none ? std::optional(missing) : std::nullopt;
  }

  Given understood(const std::string& text) const {
    const std::vector<double> numbers = numbers_in(text);
    const std::vector<std::string>& outputs = file().program.outputs;
    Given given = nothing_given(file(), false);
    const auto size_of = [&](const std::string& name) {
      return name == "residuals" ? static_cast<std::size_t>(given.residuals.size()) : 1;
    };
    std::size_t expected = 0;
    for (const std::string& name : outputs) expected += size_of(name);
    if (numbers.size() != expected) {
      fail(fmt::format("gave {} numbers, not {}: {}", numbers.size(), expected,
                       fmt::join(outputs, ", ")));
    }
    std::size_t at = 0;
    for (const std::string& name : outputs) {
      const auto values = Eigen::Map<const Vector>(&numbers[at], count(size_of(name)));
      at += size_of(name);
      if (name == "objective") given.objective = values[0];
      if (name == "residuals") given.residuals = values;
      for (std::size_t i = 0; i < file().constraints.size(); ++i) {
        if (file().constraints[i].name == name) given.constraints[count(i)] = values[0];
      }
    }
    if (std::find(outputs.begin(), outputs.end(), "objective") == outputs.end()) {
      given.objective = half_sum_of_squares(given.residuals);
    }
    make_binary(file(), given.constraints);
    return given;
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
    Vector x(count(file().variables.size()));
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
