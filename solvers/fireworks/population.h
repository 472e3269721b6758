#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "ricochet/evaluator.h"
#include "ricochet/problem.h"
#include "ricochet/random.h"
#include "ricochet/solver.h"

namespace ricochet::fireworks {

/// Fireworks and sparks of one generation with their values as shown to the solver, in the order of
/// evaluation. The capacity is fixed.
class Population {
 public:
  Population(Evaluator& evaluator, Eigen::Index room);

  /// Evaluates a point of the box and adds it. Returns false, and adds nothing, once the evaluator
  /// refuses. There must be room.
  bool add(const Vector& x);

  Eigen::Index size() const { return size_; }

  /// One row for each point.
  auto points() const { return points_.topRows(size_); }
  auto point(Eigen::Index i) const { return points_.row(i).transpose(); }
  std::span<const TrueValues> worths() const {
    return {worths_.data(), static_cast<std::size_t>(size_)};
  }
  const TrueValues& worth(Eigen::Index i) const { return worths_[static_cast<std::size_t>(i)]; }

  /// Keeps these points, in this order; an index may be repeated.
  void keep(std::span<const Eigen::Index> chosen);

  void clear() { size_ = 0; }

 private:
  Evaluator& evaluator_;
  Matrix points_;
  std::vector<TrueValues> worths_;
  Eigen::Index size_ = 0;
};

/// A solver of the family, which continues from the start until the evaluator refuses. Takes every
/// problem whose box has room. Points are compared by the feasibility rules, see better().
/// Equalities are accepted too, but once they hold almost no spark keeps them.
Solver member(std::string name,
              std::function<void(Evaluator&, const Vector& start, Random&)> until_refused);

/// Throws std::invalid_argument, with the option's name, for a number outside [1, 10^6].
void check_number(const char* option, int number);

/// The values of a point, made comparable: an objective or a violation that is not a number below
/// 1e300 in size becomes infinite.
TrueValues worth_of(const Values& values, Eigen::Index equalities);

/// Numbers that rank points, for operators that need differences. A feasible point has its
/// objective. An infeasible one has the objective of the worst feasible point (0 if there is none)
/// plus its violation: the penalty without a parameter (Deb, Computer Methods in Applied Mechanics
/// and Engineering 186 (2000) 311, doi 10.1016/S0045-7825(99)00389-8). An infinite worth counts as
/// the worst finite one; if none is finite, all numbers are 0.
Vector fitness_of(std::span<const TrueValues> worths);

// Selection of the points that survive a generation.

/// Which of several equally good points is the best.
enum class Ties {
  first,  ///< the one evaluated first: the best firework never moves along a plateau
  any,    ///< one of them, drawn uniformly
};

/// How the survivors other than the best are drawn.
enum class Others {
  by_distance,  ///< with probability proportional to the sum of distances, equations (29) and (30)
  uniform,      ///< all equally likely, as in EFWA
};

struct SelectionOptions {
  Ties ties = Ties::first;
  Others others = Others::by_distance;
  bool replacement = true;  ///< a point, also the best, may be selected several times
};

/// Index of the best point by the feasibility rules, see better(); `worths` has at least one entry.
Eigen::Index best_of(std::span<const TrueValues> worths, Ties ties, Random& random);

/// Equation (29), the numerators of (30): for every point (row), the sum of its Euclidean distances
/// to all points. Returns all 1 if all sums are 0, because (30) would be 0 / 0, or if one is
/// infinite.
Vector distance_sums(const Eigen::Ref<const Matrix>& points);

/// Indices of `count` points, the best first, the others drawn. `count` is at most the number of
/// points.
std::vector<Eigen::Index> selected(const Eigen::Ref<const Matrix>& points,
                                   std::span<const TrueValues> worths, int count,
                                   const SelectionOptions& options, Random& random);

/// The multivariate normal distribution from which a firework of FWASSP draws its sparks: mean,
/// scale and covariance matrix, N(mean, scale² C). It adapts as in CMA-ES (Hansen, arXiv
/// 1604.00772), and is fitted to points of the surface that it shares with its neighbours. The
/// surface is where the squared Mahalanobis distance is expected(), that of a typical spark.
class SearchDistribution {
 public:
  /// C is the unit matrix; scale > 0. `mean` has at least one coordinate.
  SearchDistribution(Vector mean, double scale);

  const Vector& mean() const { return mean_; }

  /// Largest standard deviation over all directions.
  double width() const;

  Vector draw(Random& random) const;

  /// Squared Mahalanobis distance of x from the mean.
  double distance(const Vector& x) const;

  /// Square of the approximate mean length of a standard normal vector.
  double expected() const;

  /// Euclidean distance from the mean to the surface in the direction of x, which is not the mean.
  double radius_towards(const Vector& x) const;

  /// Moves to the better half of the sparks and adapts the covariance matrix and the scale. A row
  /// of `sparks` is a point; `order` lists the rows from the best to the worst.
  void adapt(const Matrix& sparks, std::span<const Eigen::Index> order);

  /// Changes the covariance matrix so that the surface comes nearer to each point (row): for one
  /// point and rate 1 it goes through it. 0 < rate <= 1. Points at the mean are ignored.
  void fit(const Matrix& points, double rate);

 private:
  void decompose();

  Vector mean_;
  double scale_;
  Matrix covariance_, vectors_;
  Vector values_;                   // eigenvalues of C
  Vector scale_path_, shape_path_;  // p_sigma and p_c of CMA-ES
  int generation_ = 0;
};

}  // namespace ricochet::fireworks
