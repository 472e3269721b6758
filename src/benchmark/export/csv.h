#pragma once

#include <filesystem>

#include "src/store/store.h"

namespace ricochet::exports {

/// runs.csv, improvements.csv, questions.csv and a README.txt that says what their columns
/// are. Numbers read back to the same bits; what is missing is empty. Control characters in
/// texts are shown as \x0a, and the middle of texts beyond 4000 bytes is left out.
void write_csv(const Store& store, const std::filesystem::path& folder);

}  // namespace ricochet::exports
