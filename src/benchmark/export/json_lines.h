#pragma once

#include <filesystem>

#include "src/benchmark/experiment/campaign/completeness.h"
#include "src/benchmark/experiment/store/store.h"
#include "src/report/json.h"

namespace ricochet::exports {

/// The numbers of planned, present and missing runs, of all and by part, and of what runs are
/// missing.
report::Json json_of(const Completeness& completeness);

/// Writes campaign.json, the description of the campaign; runs.jsonl, one object on a line for each
/// run, with its key, budget, ledger, verdict and improvements; and README.txt. Numbers that JSON
/// cannot write are null.
void write_json(const Store& store, const Completeness& completeness,
                const std::filesystem::path& folder);

}  // namespace ricochet::exports
