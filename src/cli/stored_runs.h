#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/benchmark/experiment/store/store.h"

namespace ricochet::cli {

/// Writes to standard error why runs may be missing in a store, if so.
void warn_of_missing_runs(const std::string& store);

/// Joins the stores of a campaign's parts into a new one.
int merge_stores(const std::vector<std::string>& parts, const std::string& out);

/// Prints the digest of a store.
int print_digest(const std::string& store);

/// Repeats a run of a store, which was read from `file`, and returns in what it differs; empty if
/// it is identical to the bit. Throws InputError as replay() does.
std::string repeated(const Store& store, const std::string& file, std::int64_t number,
                     bool allow_programs);

/// Repeats a stored run and says whether the results are identical to the bit: exit code 0, or 1.
/// Starts only the run's own solver, and that only if it is of the suite or programs are allowed.
/// `store`: a file, or archive, see archive_named(). `run`: its number, or its key as address_of()
/// writes it.
int replay(const std::string& store, const std::string& run, bool allow_programs, bool json);

}  // namespace ricochet::cli
