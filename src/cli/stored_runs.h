#pragma once

#include <cstdint>
#include <string>

#include "src/benchmark/experiment/store/store.h"

namespace ricochet::cli {

/// Writes to standard error why runs may be missing in a store, if so.
void warn_of_missing_runs(const std::string& store);

/// Repeats a run of a store, which was read from `file`, and returns in what it differs; empty if
/// it is identical to the bit. Throws InputError if the store has no such run, or as
/// announce_programs() does.
std::string repeated(const Store& store, const std::string& file, std::int64_t number,
                     bool allow_programs);

}  // namespace ricochet::cli
