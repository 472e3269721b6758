#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "ricochet/problem.h"
#include "src/experiment/campaign.h"
#include "src/experiment/store.h"
#include "src/experiment/worker.h"

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

/// 16 hexadecimal digits that depend on every bit behind the scores of a problem's runs: box,
/// start, tolerance, weight, best value, formulations, the true values at start and best point, and
/// box, start and best point of its first instance. Equal hashes: runs can be compared.
std::string problem_hash(const Problem& problem);

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

/// Estimated processor time [s] of a campaign that has no runs yet.
struct Forecast {
  double search = 0;      ///< for the best values that are not known
  double runs = 0;        ///< with starting their processes, programs and libraries
  double report = 0;      ///< for the numbers and the pages
  double one_core = 0;    ///< of the report: its pages, which one core draws
  bool at_least = false;  ///< some solver could not be timed, and its own time is missing

  /// Elapsed time [s] on so many cores, if nothing else runs on them.
  double seconds(double cores) const;
};

/// Foretells from the time of evaluations in the box of every problem, of two short runs of every
/// solver and of some runs that do nothing, which are made for this purpose. Too low if solvers
/// become slower with the number of variables or evaluations; too high if runs end before their
/// budget is spent.
Forecast forecast_of(const Campaign& campaign);

/// A campaign whose runs are made on other machines: one process keeps the store, others make the
/// runs they are given. All know the same plan, so 8 bytes name a run: its place among the runs of
/// the shard. Messages are frames (child_process.h); how they are transported does not matter here.

/// Sends the list of runs that the store lacks, then adds the records that arrive, each after its
/// place and the content of its solver, until an empty message. Returns true if that arrived.
/// Throws InputError for a record that does not belong to its place, or whose solver has other
/// files.
bool serve_store(const Campaign& campaign, const Shard& shard, Store& store, int in, int out);

/// Makes the runs of every message, a list of places, and sends each record after its place and the
/// content of its solver as soon as the run has ended, until no further message comes. Throws as
/// require_unchanged() does.
void serve_runs(const Campaign& campaign, const Shard& shard, int in, int out);

}  // namespace ricochet
