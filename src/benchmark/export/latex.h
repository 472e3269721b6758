#pragma once

#include <filesystem>

#include "src/store/store.h"

namespace ricochet::exports {

/// table.tex, a longtable with a row for each question and competitor, and what it needs of
/// LaTeX in a comment. Where runs failed, their number is bold.
void write_latex(const Store& store, const std::filesystem::path& folder);

}  // namespace ricochet::exports
