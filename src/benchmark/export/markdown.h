#pragma once

#include <filesystem>

#include "src/store/store.h"

namespace ricochet::exports {

/// table.md, a table with a row for each question and competitor. Where runs failed, their
/// number is bold.
void write_markdown(const Store& store, const std::filesystem::path& folder);

}  // namespace ricochet::exports
