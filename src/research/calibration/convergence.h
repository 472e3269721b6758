#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/studies/calibration/fit_store.h"

/// Whether searches of the same constants, from other seeds and by other solvers, end alike: a
/// result that another seed changes is no result.
namespace ricochet::studies::calibration {

/// Who searches, from which seeds, and how long.
struct ConvergencePlan {
  std::vector<Solver> solvers;
  std::vector<int> seeds;
  std::int64_t evaluations = 0;          ///< of each search
  std::int64_t reading_evaluations = 0;  ///< of those that only rank readings, where they agree
  std::size_t readings = 0;              ///< so many of the best, each as free as the default one
};

/// What has been spent when a search is looked at, as a share of its evaluations.
inline constexpr double looked_at[] = {0.25, 0.5, 1};

/// Searches agree where the worst of them is no further than this from the best.
inline constexpr double agreement = 0.01;

/// One search.
struct LongSearch {
  std::string solver;
  int seed;
  std::vector<Fit> fits;  ///< the best after each of looked_at

  const Fit& last() const { return fits.back(); }
};

/// All searches of one freedom.
struct Convergence {
  carrier_track::Freedom freedom;
  std::int64_t evaluations = 0;  ///< of each search
  std::vector<LongSearch> searches;

  const Fit& best() const;

  /// What the searches end with that is within `agreement` of the best of them.
  std::vector<Fit> as_good() const;

  /// By how much the worst misfit of the searches is above the best of them, as a share of that.
  double spread(std::size_t look) const;

  /// The first of looked_at from which on all searches agree; nothing where they never do.
  std::optional<double> agreed_from() const;
};

/// Searches each freedom from every seed by every solver, in parallel; what the store holds is not
/// searched again. A search begins at a uniform point and, where its solver ends, anew at another.
std::vector<Convergence> converge(const std::vector<carrier_track::Freedom>& freedoms,
                                  const ConvergencePlan& plan, FitStore& store);

/// Which of two freedoms has the lower misfit.
struct OrderOfPairs {
  int all = 0;
  std::vector<std::pair<std::size_t, std::size_t>> ties;  ///< on which searches do not agree
};

OrderOfPairs order_of_pairs(const std::vector<Convergence>& all);

}  // namespace ricochet::studies::calibration
