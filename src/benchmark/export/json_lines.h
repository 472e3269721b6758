#pragma once

#include <filesystem>

#include "src/store/store.h"

namespace ricochet::exports {

/// campaign.json: what the campaign was; runs.jsonl: an object a line for each run, with its
/// key, budget, ledger, verdict and improvements; README.txt. What JSON has no number for is
/// null.
void write_json(const Store& store, const std::filesystem::path& folder);

}  // namespace ricochet::exports
