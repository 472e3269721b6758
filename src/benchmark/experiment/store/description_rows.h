#pragma once

#include <SQLiteCpp/Database.h>

#include "src/store/store.h"

namespace ricochet {

/// Writes the description into the tables of schema.sql, which are empty. The caller opens the
/// transaction. Throws InputError where two questions or two solvers have the same name.
void add_description(SQLite::Database& database, const CampaignDescription& description);

/// Reads it again. Throws Damage where it is not what was written, and what SQLite throws.
CampaignDescription description_in(SQLite::Database& database);

}  // namespace ricochet
