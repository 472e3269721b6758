#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "src/campaign/campaign.h"
#include "src/campaign/worker.h"
#include "src/store/store.h"

namespace ricochet {

/// One of several programs that share a campaign's runs: the `index`-th of `count`, from 1.
struct Shard {
  int index = 1;
  int count = 1;
};

/// A run of a campaign, ready to be made. It shares its problem with others.
struct PlannedRun {
  RunKey key;
  Job job;
  double length;  ///< of the run, about
};

/// Runs of a campaign, which outlives them.
class PlannedRuns {
 public:
  /// Those of a shard that are not in `done`, the longest first. Shards are disjoint and make up
  /// the whole, whatever is done.
  PlannedRuns(const Campaign& campaign, const Shard& shard, const std::set<RunKey>& done);

  /// One alone; none where it is none of the plan's.
  PlannedRuns(const Campaign& campaign, const RunKey& key);

  const std::vector<PlannedRun>& all() const { return runs_; }

 private:
  void add(const Campaign& campaign, const PlannedCell& cell, int instance, int run);

  std::map<std::tuple<std::size_t, std::string, int>, std::unique_ptr<Problem>> problems_;
  std::vector<PlannedRun> runs_;
};

/// Makes the runs of a shard that the store lacks, in other processes, and adds each as it ends.
/// What is in the store then does not depend on processes, shards and interruptions, but for times.
void make_runs(const Campaign& campaign, const Shard& shard, Store& store);

}  // namespace ricochet
