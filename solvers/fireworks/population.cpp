#include "solvers/fireworks/population.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "solvers/fireworks/sparks.h"
#include "solvers/scaled_box.h"

namespace ricochet::fireworks {

Population::Population(Evaluator& evaluator, Eigen::Index room)
    : evaluator_(evaluator),
      points_(room, evaluator.dimension()),
      worths_(static_cast<std::size_t>(room)) {}

bool Population::add(const Vector& x) {
  const auto values = evaluator_.values(x);
  if (!values) return false;
  points_.row(size_) = x.transpose();
  worths_[static_cast<std::size_t>(size_)] = worth_of(*values, evaluator_.equalities());
  ++size_;
  return true;
}

void Population::keep(std::span<const Eigen::Index> chosen) {
  const auto count = static_cast<Eigen::Index>(chosen.size());
  Matrix points(count, points_.cols());
  std::vector<TrueValues> worths;
  worths.reserve(chosen.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index from = chosen[static_cast<std::size_t>(i)];
    points.row(i) = points_.row(from);
    worths.push_back(worth(from));
  }
  points_.topRows(count) = points;
  std::copy(worths.begin(), worths.end(), worths_.begin());
  size_ = count;
}

Solver member(std::string name,
              std::function<void(Evaluator&, const Vector& start, Random&)> until_refused) {
  Solver solver;
  solver.name = std::move(name);
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.stochastic = true;
  solver.capabilities.constraints = Capabilities::Constraints::all;
  solver.solve = [until_refused = std::move(until_refused)](Evaluator& evaluator,
                                                            const Vector& start,
                                                            Random& random) -> SolverTermination {
    until_refused(evaluator, start, random);
    return {stopped_by_evaluator};
  };
  return solver;
}

void check_number(const char* option, int number) {
  if (number < 1 || number > 1'000'000) {
    throw std::invalid_argument(std::string(option) + ": must be in 1..1000000");
  }
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Bound on the size of numbers: sums and differences of a few such numbers stay finite.
constexpr double largest = 1e300;

double usable(double value) {
  return std::abs(value) < largest ? value : infinity;
}

}  // namespace

TrueValues worth_of(const Values& values, Eigen::Index equalities) {
  const TrueValues true_values = true_values_of(values, equalities);
  return {usable(true_values.objective), usable(true_values.violation)};
}

Vector fitness_of(std::span<const TrueValues> worths) {
  double worst_feasible = -infinity;
  for (const TrueValues& worth : worths) {
    if (worth.violation == 0 && worth.objective < infinity) {
      worst_feasible = std::max(worst_feasible, worth.objective);
    }
  }
  if (worst_feasible == -infinity) worst_feasible = 0;
  Vector fitness(static_cast<Eigen::Index>(worths.size()));
  double worst = -infinity;
  for (Eigen::Index i = 0; i < fitness.size(); ++i) {
    const TrueValues& worth = worths[static_cast<std::size_t>(i)];
    fitness[i] = worth.violation > 0 ? worst_feasible + worth.violation : worth.objective;
    if (fitness[i] < infinity) worst = std::max(worst, fitness[i]);
  }
  if (worst == -infinity) worst = 0;
  return fitness.cwiseMin(worst);
}

namespace {

/// Draws an index with probabilities proportional to the weights, which are >= 0 and not all 0.
Eigen::Index spin(const Vector& weights, Random& random) {
  double left = share(random) * weights.sum();
  Eigen::Index last = 0;
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    last = i;
    left -= weights[i];
    if (left < 0) break;
  }
  return last;
}

/// For points in any dimension, pair by pair.
Vector sums_in_space(const Eigen::Ref<const Matrix>& points) {
  Vector sums = Vector::Zero(points.rows());
  Eigen::ArrayXd distance(points.rows());
  for (Eigen::Index i = 1; i < points.rows(); ++i) {
    auto to_earlier = distance.head(i);
    to_earlier = (points.col(0).head(i).array() - points(i, 0)).square();
    for (Eigen::Index k = 1; k < points.cols(); ++k) {
      to_earlier += (points.col(k).head(i).array() - points(i, k)).square();
    }
    to_earlier = to_earlier.sqrt();
    sums.head(i).array() += to_earlier;
    sums[i] = to_earlier.sum();
  }
  return sums;
}

/// For points on a line, sorted: from one point to the next, the distances to all points on one
/// side grow by the gap, those to all points on the other side shrink by it. Summing over pairs
/// would take most of the time of a run.
Vector sums_on_a_line(const Eigen::Ref<const Matrix>& points) {
  const auto count = static_cast<std::size_t>(points.rows());
  std::vector<std::pair<double, Eigen::Index>> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    order[i] = {points(row, 0), row};
  }
  // Tied points have the same sum, in any order.
  std::sort(order.begin(), order.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  Vector sums = Vector::Zero(points.rows());
  double to_left = 0, to_right = 0;
  for (std::size_t i = 1; i < count; ++i) {
    to_left += static_cast<double>(i) * (order[i].first - order[i - 1].first);
    sums[order[i].second] += to_left;
    const std::size_t j = count - 1 - i;
    to_right += static_cast<double>(i) * (order[j + 1].first - order[j].first);
    sums[order[j].second] += to_right;
  }
  return sums;
}

}  // namespace

Eigen::Index best_of(std::span<const TrueValues> worths, Ties ties, Random& random) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < worths.size(); ++i) {
    if (better(worths[i], worths[best])) best = i;
  }
  if (ties == Ties::any) {
    std::vector<std::size_t> equals = {best};
    for (std::size_t i = best + 1; i < worths.size(); ++i) {
      if (!better(worths[best], worths[i])) equals.push_back(i);
    }
    if (equals.size() > 1) best = equals[one_of(equals.size(), random)];
  }
  return static_cast<Eigen::Index>(best);
}

Vector distance_sums(const Eigen::Ref<const Matrix>& points) {
  const Vector sums = points.cols() == 1 ? sums_on_a_line(points) : sums_in_space(points);
  const double total = sums.sum();
  return total > 0 && std::isfinite(total) ? sums : Vector(Vector::Ones(points.rows()));
}

std::vector<Eigen::Index> selected(const Eigen::Ref<const Matrix>& points,
                                   std::span<const TrueValues> worths, int count,
                                   const SelectionOptions& options, Random& random) {
  std::vector<Eigen::Index> chosen = {best_of(worths, options.ties, random)};
  chosen.reserve(static_cast<std::size_t>(count));
  Vector weights = Vector::Ones(points.rows());
  if (options.others == Others::by_distance) weights = distance_sums(points);
  while (chosen.size() < static_cast<std::size_t>(count)) {
    if (!options.replacement) weights[chosen.back()] = 0;
    chosen.push_back(spin(weights, random));
  }
  return chosen;
}

namespace {

/// Eigenvalues of C are at least this, and C is mixed with as much of the unit matrix.
constexpr double least_value = 1e-8;
/// C is mixed with this much of its mean eigenvalue.
constexpr double shrinkage = 1e-4;

/// Weights of the better half, which add up to 1.
Vector weights_of(Eigen::Index sparks) {
  const Eigen::Index chosen = (sparks + 1) / 2;
  Vector weights(chosen);
  for (Eigen::Index i = 0; i < chosen; ++i) {
    weights[i] = std::log(static_cast<double>(chosen) + 0.5) - std::log(static_cast<double>(i + 1));
  }
  return weights / weights.sum();
}

}  // namespace

SearchDistribution::SearchDistribution(Vector mean, double scale)
    : mean_(std::move(mean)),
      scale_(scale),
      covariance_(Matrix::Identity(mean_.size(), mean_.size())),
      vectors_(covariance_),
      values_(Vector::Ones(mean_.size())),
      scale_path_(Vector::Zero(mean_.size())),
      shape_path_(Vector::Zero(mean_.size())) {}

double SearchDistribution::width() const {
  return scale_ * std::sqrt(values_.maxCoeff());
}

Vector SearchDistribution::draw(Random& random) const {
  const Vector standard = normal(mean_.size(), random);
  return mean_ + scale_ * (vectors_ * values_.cwiseSqrt().cwiseProduct(standard));
}

double SearchDistribution::distance(const Vector& x) const {
  const Vector along = vectors_.transpose() * (x - mean_) / scale_;
  return along.cwiseAbs2().cwiseQuotient(values_).sum();
}

double SearchDistribution::expected() const {
  const auto n = static_cast<double>(mean_.size());
  const double correction = 1 - 1 / (4 * n) + 1 / (21 * n * n);
  return n * correction * correction;
}

double SearchDistribution::radius_towards(const Vector& x) const {
  return (x - mean_).norm() * std::sqrt(expected() / distance(x));
}

void SearchDistribution::adapt(const Matrix& sparks, std::span<const Eigen::Index> order) {
  const auto n = static_cast<double>(mean_.size());
  const Vector weights = weights_of(sparks.rows());
  const double effective = 1 / weights.squaredNorm();
  const double path_rate = (4 + effective / n) / (n + 4 + 2 * effective / n);
  const double scale_rate = (effective + 2) / (n + effective + 5);
  const double rank_one = 2 / ((n + 1.3) * (n + 1.3) + effective);
  const double rank_many =
      std::min(1 - rank_one, 2 * (effective - 2 + 1 / effective) / ((n + 2) * (n + 2) + effective));

  const Eigen::Index chosen = weights.size();
  Matrix steps(mean_.size(), chosen);
  for (Eigen::Index i = 0; i < chosen; ++i) {
    steps.col(i) = sparks.row(order[static_cast<std::size_t>(i)]).transpose() - mean_;
  }
  const Vector moved = steps * weights;

  const double settled = 1 - std::pow(1 - scale_rate, 2 * generation_ + 1);
  const bool steady = scale_path_.squaredNorm() / n / settled < 2 + 4 / (n + 1);
  const auto path_gain = [&](double rate) {
    return std::sqrt(rate * (2 - rate) * effective) / scale_;
  };
  const Vector whitened =
      vectors_ * values_.cwiseSqrt().cwiseInverse().cwiseProduct(vectors_.transpose() * moved);
  scale_path_ = (1 - scale_rate) * scale_path_ + path_gain(scale_rate) * whitened;
  shape_path_ *= 1 - path_rate;
  if (steady) shape_path_ += path_gain(path_rate) * moved;

  const double kept = steady ? rank_one : rank_one * (1 - path_rate * (2 - path_rate));
  covariance_ *= 1 - least_value - kept - rank_many;
  covariance_ += rank_one * shape_path_ * shape_path_.transpose();
  covariance_ += rank_many / (scale_ * scale_) * steps * weights.asDiagonal() * steps.transpose();

  const double damping = 2 * effective / static_cast<double>(sparks.rows()) + 0.3 + scale_rate;
  const double growth = scale_rate / damping * (scale_path_.squaredNorm() / n - 1) / 2;
  scale_ *= std::exp(0.5 * std::min(1.0, growth));
  mean_ += moved;
  decompose();

  // The scale becomes the better half's mean distance; scale² C stays as it is.
  values_ = (1 - shrinkage) * values_.array() + shrinkage * values_.mean();
  const double spread = (steps.colwise() - moved).colwise().norm().mean();
  if (spread > 0) {
    values_ *= scale_ * scale_ / (spread * spread);
    scale_ = spread;
  }
  values_ = values_.cwiseMax(least_value);
  covariance_ = vectors_ * values_.asDiagonal() * vectors_.transpose();
  ++generation_;
}

void SearchDistribution::fit(const Matrix& points, double rate) {
  Matrix change = Matrix::Zero(mean_.size(), mean_.size());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vector point = points.row(i).transpose();
    const double there = distance(point);
    if (!(there > 0)) continue;
    const Vector step = (point - mean_) / scale_;
    change += (1 / expected() - 1 / there) * step * step.transpose();
  }
  covariance_ =
      (1 - least_value) * covariance_ + rate / static_cast<double>(points.rows()) * change;
  decompose();
  covariance_ = vectors_ * values_.asDiagonal() * vectors_.transpose();
}

void SearchDistribution::decompose() {
  covariance_.diagonal().array() += least_value;
  const Eigen::SelfAdjointEigenSolver<Matrix> solver((covariance_ + covariance_.transpose()) / 2);
  vectors_ = solver.eigenvectors();
  values_ = solver.eigenvalues().cwiseMax(least_value);
}

}  // namespace ricochet::fireworks
