#pragma once

#include <SQLiteCpp/Database.h>

#include "src/benchmark/experiment/store/store.h"

namespace ricochet {

/// Writes the description into the tables of schema.sql, which must be empty. The caller opens the
/// transaction. Throws InputError if two problems or two solvers have the same name.
void add_description(SQLite::Database& database, const CampaignDescription& description);

/// Reads the description. Throws Damage if it differs from what was written, and the exceptions of
/// SQLite.
CampaignDescription description_in(SQLite::Database& database);

}  // namespace ricochet
