#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/studies/calibration/fit.h"

/// Do searches for the same parameters with other seeds and solvers converge to the same loss? A
/// result that depends on the seed is not a result.
namespace ricochet::studies::calibration {

/// Solvers, seeds and evaluations of the searches.
struct ConvergencePlan {
  std::vector<Solver> solvers;
  std::vector<int> seeds;
  std::int64_t evaluations = 0;  ///< of each search
  std::int64_t interpretation_evaluations =
      0;                            ///< of those that only rank interpretations, if they agree
  std::size_t interpretations = 0;  ///< number of the best, with the default free parameters
};

/// Checkpoints of a search, as shares of its evaluations.
inline constexpr double looked_at[] = {0.25, 0.5, 1};

/// Searches agree if the worst loss is at most this share above the best.
inline constexpr double agreement = 0.01;

/// One search.
struct LongSearch {
  std::string solver;
  int seed;
  std::vector<Fit> fits;  ///< the best at each checkpoint

  const Fit& last() const { return fits.back(); }
};

/// All searches with the same free parameters.
struct Convergence {
  carrier_track::Parameterisation parameterisation;
  std::int64_t evaluations = 0;  ///< of each search
  std::vector<LongSearch> searches;

  const Fit& best() const;

  /// Returns the final fits within `agreement` of the best of them.
  std::vector<Fit> as_good() const;

  /// Relative difference between the worst and the best loss of the searches.
  double spread(std::size_t look) const;

  /// The first checkpoint from which on all searches agree; nothing if they never do.
  std::optional<double> agreed_from() const;
};

/// Searches each parameterisation with every seed and solver, in parallel; searches in the store
/// are not repeated. A search begins at a uniform random point; if its solver ends early, it
/// restarts at another.
std::vector<Convergence> converge(
    const std::vector<carrier_track::Parameterisation>& parameterisations,
    const ConvergencePlan& plan, FitStore& store);

/// Which of two parameterisations has the lower loss.
struct OrderOfPairs {
  int all = 0;
  std::vector<std::pair<std::size_t, std::size_t>> ties;  ///< whose order depends on the search
};

OrderOfPairs order_of_pairs(const std::vector<Convergence>& all);

}  // namespace ricochet::studies::calibration
