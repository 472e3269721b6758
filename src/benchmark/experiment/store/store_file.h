#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <memory>

namespace ricochet {

/// Throws InputError if the file is no store of this version of the suite, judging by its first
/// page. Writes nothing, and makes no file beside it.
void check_is_store(const std::filesystem::path& file);

/// Reads all of it, and throws InputError as Store::open and its readers do. Takes some seconds for
/// a million runs.
void check_store(const std::filesystem::path& file);

/// Opens the file of a store to read it, after these checks. Closes what a killed writer left open,
/// and rolls back what it left half changed; else writes nothing. Messages name the file `named`,
/// from which this one was unpacked, if that is not empty.
std::unique_ptr<SQLite::Database> opened_for_reading(const std::filesystem::path& file,
                                                     const std::filesystem::path& named = {});

/// Opens it to add runs; the caller must have checked it, and hold a WriterLock.
std::unique_ptr<SQLite::Database> opened_for_adding(const std::filesystem::path& file);

/// Moves all runs into the one file, which can be read in a read-only folder, and lets the database
/// read only. Leaves the runs in two files while others read them. Never waits.
void close(SQLite::Database& database);

}  // namespace ricochet
