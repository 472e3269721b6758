#pragma once

#include <filesystem>

namespace ricochet {

/// Throws Damage if a file is not what SQLite writes beside a database and its killed writer
/// leaves: frames with the right checksums, of which the last may be torn. SQLite itself would take
/// no notice of what comes after a wrong one, and remove it.
/// https://www.sqlite.org/fileformat2.html#the_write_ahead_log
void check_log(const std::filesystem::path& log);

}  // namespace ricochet
