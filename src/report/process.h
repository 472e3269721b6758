#pragma once

#include <string>
#include <vector>

namespace ricochet::report {

struct ProcessResult {
  int status;  ///< exit code, or 128 + the signal that ended it
  std::string output, errors;
};

/// Runs the program arguments[0], found on PATH, with `input` on its standard input; no shell is
/// involved. Of the environment it sees PATH alone, and the locale C.UTF-8, so that
/// nothing else can change its output.
/// Throws std::system_error if it cannot be started. Safe to call from several threads.
ProcessResult run_process(const std::vector<std::string>& arguments, const std::string& input);

}  // namespace ricochet::report
