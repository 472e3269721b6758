#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/experiment/stored_campaign.h"
#include "src/studies/paper/loss.h"

namespace ricochet::studies::calibration {

/// The result of a search.
struct Fit : carrier_track::Parameterisation {
  double loss = 0;
  carrier_track::CaseIds left_out = {};  ///< the cases left out of the fit
};

/// Solvers, evaluations and seed of a search.
struct Search {
  Solver global;
  Solver least_squares;      ///< polishes on the smooth loss
  Solver local;              ///< polishes on the loss
  std::int64_t evaluations;  ///< of the loss, in all
  int seed = 1;
};

Search with_evaluations(Search search, std::int64_t evaluations);

/// Whose loss is lowest, the first of equal ones; there must be one.
const Fit& best_of(const std::vector<Fit>& fits);

/// The runs of all searches, in a store that grows: a search may begin at what another one found.
/// What the store has is not run again. The budget of a run there is that of the whole run.
///
/// Runs are made in other processes, and depend only on the arguments. The members throw InputError
/// if the store was made by another program, or has other problems or solvers of the same names.
class Searches {
 public:
  Searches(std::filesystem::path file, Provenance provenance)
      : file_(std::move(file)), provenance_(std::move(provenance)) {}

  /// Fits the free parameters of each start: the global solver has two thirds of the evaluations,
  /// the least squares a sixth, the local solver a sixth, each from the best point so far. The
  /// losses of the starts have no effect. An interpretation whose evaluations are dearer has fewer
  /// of them: a sixtieth with one contact speed, a twentieth in the long run, a fifth later.
  std::vector<Fit> fits(const std::vector<Fit>& starts, const Search& search);

  /// The same by the two local solvers, with half of the evaluations each.
  std::vector<Fit> polished(const std::vector<Fit>& starts, const Search& search);

  /// What each solver with each seed finds, in this order, from random points: if it ends early, it
  /// restarts at another.
  std::vector<std::vector<Fit>> from_random_points(
      const std::vector<carrier_track::Parameterisation>& parameterisations,
      const std::vector<Solver>& solvers, const std::vector<int>& seeds, std::int64_t evaluations);

 private:
  struct Ongoing;
  struct Turn {
    const Solver* solver;
    std::int64_t evaluations;
  };

  std::vector<Fit> by_turns(const std::vector<Fit>& starts, int seed,
                            const std::vector<Turn>& turns);
  /// One run each, from the best point so far.
  void improve(std::vector<Ongoing>& searches);
  std::vector<RunRecord> records_of(const std::vector<Ongoing>& searches);

  std::filesystem::path file_;
  Provenance provenance_;
};

}  // namespace ricochet::studies::calibration
