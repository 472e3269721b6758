#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <memory>

namespace ricochet {

/// Throws InputError if the file is no store of this version of the suite, judging by its first
/// page. Writes nothing, and makes no file beside it.
void check_is_store(const std::filesystem::path& file);

/// Opens the file of a store to read it. Throws InputError as Store::open does. Writes nothing to
/// it, except that an interrupted change is rolled back.
std::unique_ptr<SQLite::Database> opened_for_reading(const std::filesystem::path& file);

/// Opens it to add runs, after the same checks; the caller must hold a WriterLock.
std::unique_ptr<SQLite::Database> opened_for_adding(const std::filesystem::path& file);

/// Closes a database to which runs were added, so that all of it is in one file that can be read in
/// a read-only folder; skipped while others read it.
void close(std::unique_ptr<SQLite::Database> database);

}  // namespace ricochet
