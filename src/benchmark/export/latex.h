#pragma once

#include <filesystem>

#include "src/benchmark/experiment/campaign/completeness.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::exports {

/// Writes table.tex, a longtable with a row for each problem and entry; a comment in it lists the
/// LaTeX packages it needs. If runs failed, their number is bold.
void write_latex(const Store& store, const Completeness& completeness,
                 const std::filesystem::path& folder);

}  // namespace ricochet::exports
