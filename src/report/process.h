#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace ricochet::report {

struct ProcessResult {
  int status;  ///< exit code, or 124 at the limit, 127 if not found, 128 + the signal that ended it
  std::string output, errors;
};

/// Runs the program arguments[0], found on PATH, with `input` on its standard input, and ends it at
/// the limit; no shell is involved. Of the environment it sees PATH alone, and the locale C.UTF-8,
/// so that nothing else can change its output.
/// Throws std::system_error if the system has no room for a process. Safe to call from several
/// threads.
ProcessResult run_process(const std::vector<std::string>& arguments, const std::string& input,
                          std::chrono::duration<double> limit);

}  // namespace ricochet::report
