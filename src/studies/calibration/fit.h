#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/problem.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/studies/paper/loss.h"

namespace ricochet::studies::calibration {

/// Solvers, evaluations and first seed of a search.
struct Search {
  Solver global;
  Solver least_squares;      ///< polishes on the smooth loss
  Solver local;              ///< polishes on the loss
  std::int64_t evaluations;  ///< of the loss, in all
  int seed = 1;
};

/// The result of a search, and everything that determined it.
struct Fit {
  carrier_track::Interpretation interpretation;
  std::vector<carrier_track::Unknown> free;
  carrier_track::Constants constants;  ///< fitted and fixed
  double loss;
  carrier_track::CaseIds left_out;  ///< the cases left out of the fit
};

/// Name of an unknown parameter in words: "centrifugal mass radius".
std::string words_of(carrier_track::Unknown constant);

/// Fits the free parameters, starting at the values in `held`: the global solver has two thirds of
/// the evaluations, the least squares a sixth, the local solver a sixth; returns the best point of
/// all. The result depends only on search and parameterisation.
Fit fit(const carrier_track::Parameterisation& parameterisation, const Search& search,
        const carrier_track::CaseIds& left_out = {});

/// Only the two local searches, with all the evaluations.
Fit polish(const carrier_track::Parameterisation& parameterisation, const Search& search);

/// Returns the best point of a run within this number of evaluations as a fit; the values in
/// `held`, with the given loss, if nothing is better.
Fit best_within(std::int64_t evaluations, const RunRecord& record,
                const carrier_track::Parameterisation& parameterisation, double loss_of_held);

/// A requested fit: everything that determines the result of a search.
struct AskedFit {
  std::string kind;                                  ///< of search, solver and seed
  carrier_track::Parameterisation parameterisation;  ///< free parameters, and start of the search
  carrier_track::CaseIds left_out = {};              ///< the cases left out
  std::string options;                               ///< evaluations, and versions of the solvers
  std::function<double(const Fit&)> loss;            ///< what it minimises

  /// Everything except the options, as a short text.
  std::string name() const;
};

/// The solvers of a search with their versions, and its evaluations.
std::string options_of(const Search& search);

/// Hash of the data of every fit: the cases with their claims, and the bounds and natural values of
/// the unknown parameters.
std::string data_hash(const std::vector<carrier_track::Case>& cases,
                      const std::vector<carrier_track::UnknownParameter>& parameters);

/// Finished fits, kept in a TOML file, so that an interrupted study can be resumed. Thread-safe.
class FitStore {
 public:
  /// Reads the file if it exists. Throws InputError if it is not a file of fits, is truncated, or
  /// was made by another version of the suite or with other data (data_hash).
  explicit FitStore(std::filesystem::path file);

  /// Returns nothing if there is no such fit. If there is one that differs only in the options,
  /// prints a line on standard error, once. Throws InputError if the loss of a fit from the file
  /// does not match its parameters.
  std::optional<Fit> find(const AskedFit& asked) const;

  /// Stores one fit for each request, and replaces the file atomically. Throws InputError if that
  /// fails.
  void add(const std::vector<AskedFit>& asked, const std::vector<Fit>& fits);

 private:
  struct Kept {
    Fit fit;         ///< only its parameters and its loss
    bool from_file;  ///< not verified yet
  };

  void check_loss(const AskedFit& asked, const Fit& fit) const;

  std::filesystem::path file_;
  mutable std::mutex mutex_;
  mutable bool told_ = false;                                ///< about fits with other options
  std::map<std::string, std::map<std::string, Kept>> fits_;  ///< by name and options
};

/// A search to be run, and the fits requested of it.
struct FitTask {
  std::vector<AskedFit> asked;               ///< at least one; the last is the final one
  std::function<std::vector<Fit>()> search;  ///< returns a fit for each
  double work;                               ///< in any unit, the same for all tasks
};

/// Returns a task that runs fit().
FitTask fit_task(const std::string& kind, const carrier_track::Parameterisation& parameterisation,
                 const Search& search, const carrier_track::CaseIds& left_out = {});

/// Loads or computes all requested fits, in parallel, the longest searches first.
std::vector<std::vector<Fit>> searched(const std::string& what, const std::vector<FitTask>& tasks,
                                       FitStore& store);

/// The same; returns the final fit of each search.
std::vector<Fit> fits_by(const std::string& what, const std::vector<FitTask>& tasks,
                         FitStore& store);

Search with_evaluations(Search search, std::int64_t evaluations);

/// The best point so far of a problem whose objective is a loss.
struct BestPoint {
  Vector x;
  double loss;
};

/// The problem's start.
BestPoint start_of(const Problem& problem);

/// Runs a solver from the best point, which becomes the problem's start, and keeps an improvement.
/// Throws std::runtime_error if the run failed.
void improve(Problem& problem, const Solver& solver, std::int64_t evaluations, BestPoint& best);

}  // namespace ricochet::studies::calibration
