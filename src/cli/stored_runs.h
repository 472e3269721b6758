#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "src/benchmark/experiment/campaign/completeness.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::cli {

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
