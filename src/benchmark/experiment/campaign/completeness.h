#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/benchmark/experiment/campaign/campaign.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet {

/// How many of a campaign's planned runs its store has, and of what runs are missing. A run that
/// failed or reached a limit is present.
struct Completeness {
  struct Part {
    std::string name;  ///< of the plan, or "part 2"
    std::int64_t planned = 0;
    std::int64_t present = 0;
  };

  std::int64_t planned = 0;
  std::int64_t present = 0;
  std::vector<Part> parts;
  std::string missing_shards;  ///< e.g. "shard 2 of 3", if these make up what is missing
  std::vector<std::string> missing_problems, missing_solvers;  ///< that lack runs
  std::vector<int> missing_instances;
  /// Solvers that this build lacks: of their runs only those that are present count as planned.
  std::vector<std::string> unknown_solvers;

  std::int64_t missing() const { return planned - present; }

  /// Returns true if runs are missing, or may be.
  bool is_in_doubt() const { return missing() > 0 || !unknown_solvers.empty(); }
};

/// The campaign is that of the store; it may lack solvers.
Completeness completeness_of(const Campaign& campaign, const Store& store);

/// E.g. "16 of 24 planned runs are present, 8 are missing: shard 2 of 3; of count-C1; of scan; on
/// instances 2, 5"; "all 24 planned runs are present".
std::string in_words(const Completeness& completeness);

/// The same as a sentence on top of a table or a file of explanations.
std::string as_sentence(const Completeness& completeness);

}  // namespace ricochet
