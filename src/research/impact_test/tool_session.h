#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "solvers/outside/line_program.h"
#include "src/research/impact_test/answer.h"
#include "src/research/impact_test/tool_program.h"

namespace ricochet::studies::impact_test {

/// A tool that cannot be used at all. The message says why.
class ToolFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How long a tool is waited for.
struct TimeLimits {
  std::chrono::seconds start{60};  ///< for the first answer of a process: Python imports
  std::chrono::seconds scene{10};
};

/// A tool that is asked scene by scene. It runs until it fails: then it is killed, and started
/// again with the next scene. Only the thread that made the session may use it.
class ToolSession {
 public:
  /// The tool's standard error is added to the file `log`.
  ToolSession(const ToolProgram& program, Level level, const std::filesystem::path& log,
              TimeLimits limits = {});

  /// The tool's answer to a scene, whatever happens to the tool. Throws ToolFailure if it has
  /// failed `most_failed_starts` times without ever answering.
  Answer ask(const TestScene& scene);

  static constexpr int most_failed_starts = 3;

 private:
  void start();
  Answer answered(const TestScene& scene);
  Answer failed(const std::string& scene);

  std::vector<std::string> command_;
  std::filesystem::path log_;
  TimeLimits limits_;
  std::optional<outside::LineProgram> process_;
  bool has_answered_ = false;  // this process
  bool has_ever_answered_ = false;
  int failed_starts_ = 0;
};

}  // namespace ricochet::studies::impact_test
