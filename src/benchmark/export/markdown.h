#pragma once

#include <filesystem>

#include "src/benchmark/experiment/campaign/completeness.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::exports {

/// Writes table.md, a table with a row for each problem and entry. If runs failed, their number is
/// bold.
void write_markdown(const Store& store, const Completeness& completeness,
                    const std::filesystem::path& folder);

}  // namespace ricochet::exports
