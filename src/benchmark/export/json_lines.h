#pragma once

#include <filesystem>

#include "src/benchmark/experiment/store/store.h"

namespace ricochet::exports {

/// Writes campaign.json, the description of the campaign; runs.jsonl, one object on a line for each
/// run, with its key, budget, ledger, verdict and improvements; and README.txt. Numbers that JSON
/// cannot write are null.
void write_json(const Store& store, const std::filesystem::path& folder);

}  // namespace ricochet::exports
