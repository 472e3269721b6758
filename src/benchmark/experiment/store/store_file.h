#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <memory>

namespace ricochet {

/// Throws InputError where there is no file of a store with this version of the tables, by its
/// first page. Nothing is written, nor made beside it.
void check_is_store(const std::filesystem::path& file);

/// Opens the file of a store to read it. Throws InputError as Store::open does. Nothing is written
/// to it, but that a change which was interrupted is taken back.
std::unique_ptr<SQLite::Database> opened_for_reading(const std::filesystem::path& file);

/// Opens it to add runs, after the same checks; the caller has a WriterLock.
std::unique_ptr<SQLite::Database> opened_for_adding(const std::filesystem::path& file);

/// Closes a database to which runs were added, so that all of it is in one file that can be read
/// where nothing can be written; unless others read it at this moment.
void close(std::unique_ptr<SQLite::Database> database);

}  // namespace ricochet
