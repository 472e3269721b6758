#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "src/benchmark/experiment/campaign/campaign.h"
#include "src/benchmark/experiment/campaign/relocated_optimum.h"
#include "src/benchmark/experiment/campaign/worker.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet {

/// One of several programs that share a campaign's runs: the `index`-th of `count`, from 1.
struct Shard {
  int index = 1;
  int count = 1;
};

/// The place of a run in a campaign.
struct PlannedPlace {
  const PlannedCell* cell;
  int instance, run;
  double length;  ///< estimated
};

/// All runs of a campaign, which must outlive them, the longest first. They are dealt to shards in
/// this order: the I-th of N gets those at I - 1, I - 1 + N, ...
std::vector<PlannedPlace> planned_places(const Campaign& campaign);

/// A run of a campaign, ready to be made. Runs share problems.
struct PlannedRun {
  RunKey key;
  Job job;
  double length;  ///< estimated
};

/// Runs of a campaign, which must outlive them.
class PlannedRuns {
 public:
  /// The runs of a shard that are not in `done`, the longest first. Shards are disjoint and
  /// together complete, whatever `done` is.
  PlannedRuns(const Campaign& campaign, const Shard& shard, const std::set<RunKey>& done);

  /// A single run; empty if the plan does not have it.
  PlannedRuns(const Campaign& campaign, const RunKey& key);

  const std::vector<PlannedRun>& all() const { return runs_; }

 private:
  void add(const Campaign& campaign, const PlannedCell& cell, int instance, int run);

  /// By problem, formulation, place of a relocated optimum and instance.
  std::map<std::tuple<std::size_t, std::string, std::optional<OptimumPlace>, int>,
           std::unique_ptr<Problem>>
      problems_;
  std::vector<PlannedRun> runs_;
};

/// Throws InputError if a file of a user's solver has changed since it was loaded: nobody knows
/// which of the two made a run that has just ended.
void require_unchanged(const Solver& solver);

/// Makes the runs of a shard that the store lacks, in other processes, and adds each as it ends,
/// then finishes the store. Except for times, the resulting store does not depend on processes,
/// shards and interruptions. Throws as require_unchanged() does, and keeps the runs before.
void make_runs(const Campaign& campaign, const Shard& shard, Store& store);

}  // namespace ricochet
