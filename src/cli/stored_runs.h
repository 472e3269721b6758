#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "src/benchmark/experiment/campaign/completeness.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::cli {

/// Writes to standard error why runs may be missing in a store, if so.
void warn_of_missing_runs(const std::string& store);

/// How complete a store is, which was read from `file`. Writes to standard error what is missing,
/// if anything is, or why this build cannot tell; then returns nothing.
std::optional<Completeness> told_completeness(const Store& store, const std::string& file);

/// "24 runs", or "16 of 24 planned runs" if some are missing.
std::string counted_runs(const Store& store, const std::optional<Completeness>& completeness);

/// Repeats a run of a store, which was read from `file`, and returns in what it differs; empty if
/// it is identical to the bit. Throws InputError if the store has no such run, or as
/// announce_programs() does.
std::string repeated(const Store& store, const std::string& file, std::int64_t number,
                     bool allow_programs);

}  // namespace ricochet::cli
