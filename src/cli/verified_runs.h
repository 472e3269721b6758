#pragma once

#include <functional>
#include <string>
#include <vector>

#include "src/benchmark/experiment/store/run_key.h"
#include "src/cli/command_line.h"

namespace ricochet::cli {

/// How many runs from elsewhere are repeated before they are taken.
struct Verification {
  int runs = 20;  ///< drawn at random among those that this build can repeat; 0: none
  bool allow_programs = false;
};

void add_verification(CLI::App* command, Verification& verification);

/// Repeats a random sample of the wanted runs of some stores. Returns in words, for the store that
/// they come to, how many there are, how many were repeated, the user and the date. Throws
/// InputError, naming file and run, if one differs from what is stored, by a bit.
std::string verified(const std::vector<std::string>& files,
                     const std::function<bool(const RunKey&)>& wanted,
                     const Verification& verification);

}  // namespace ricochet::cli
