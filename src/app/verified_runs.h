#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/app/command_line.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/store.h"

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

/// Writes to standard error why runs may be missing in a store, if so.
void warn_of_missing_runs(const std::string& store);

/// Checks a store, which was read from `file`, as check_content() does. Returns its campaign;
/// writes to standard error why this build cannot make it, if so, and returns nothing.
std::optional<Campaign> check_as_known(const Store& store, const std::string& file);

/// How complete a store is, which was read from `file`. Writes to standard error what is missing,
/// if anything is, or why this build cannot tell; then returns nothing. Throws InputError as
/// check_content() does.
std::optional<Completeness> told_completeness(const Store& store, const std::string& file);

/// "24 runs", or "16 of 24 planned runs" if some are missing.
std::string counted_runs(const Store& store, const std::optional<Completeness>& completeness);

}  // namespace ricochet::cli
