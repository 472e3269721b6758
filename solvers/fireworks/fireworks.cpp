#include "solvers/fireworks/fireworks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "solvers/unit_box.h"
#include "src/core/instance.h"

namespace ricochet {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The objective, or infinity where a sum of such values would not be a number.
double usable(double objective) {
  return std::abs(objective) < 1e300 ? objective : infinity;
}

/// Objectives with the worst usable one in place of those that are not.
Vector ranked(const Vector& objectives) {
  Vector result = objectives.unaryExpr(&usable);
  double worst = -infinity;
  for (const double f : result) {
    if (f < infinity) worst = std::max(worst, f);
  }
  if (worst == -infinity) worst = 0;  // none is usable: all are tied
  return result.cwiseMin(worst);
}

/// Fireworks and sparks of one generation, in the order in which they were evaluated.
class Generation {
 public:
  Generation(Evaluator& evaluator, const FireworksOptions& options, Random& random)
      : evaluator_(evaluator), options_(options), random_(random) {}

  /// Fills the sky: `start` and uniform points. Returns false once the evaluator refuses.
  bool begin(const Vector& start) {
    if (!add(start)) return false;
    for (int i = 1; i < options_.fireworks; ++i) {
      if (!add(uniform_point(evaluator_.problem(), random_))) return false;
    }
    return true;
  }

  /// Sets off all fireworks. Returns false once the evaluator refuses.
  bool explode() {
    const Vector objectives = Eigen::Map<const Vector>(objectives_.data(), options_.fireworks);
    const std::vector<int> counts = spark_counts(objectives, options_);
    const Vector amplitude = amplitudes(objectives, options_);
    for (int i = 0; i < options_.fireworks; ++i) {
      for (int k = 0; k < counts[static_cast<std::size_t>(i)]; ++k) {
        if (!add(spark(firework(i), amplitude[i]))) return false;
      }
    }
    std::uniform_int_distribution<int> any(0, options_.fireworks - 1);
    for (int k = 0; k < options_.gaussian_sparks; ++k) {
      if (!add(gaussian_spark(firework(any(random_))))) return false;
    }
    return true;
  }

  /// Leaves the best and, drawn by their distances, as many others as make up the fireworks.
  void select() {
    std::vector<std::size_t> chosen = {static_cast<std::size_t>(
        std::min_element(objectives_.begin(), objectives_.end()) - objectives_.begin())};
    Matrix points(dimension(), static_cast<Eigen::Index>(points_.size()));
    for (std::size_t k = 0; k < points_.size(); ++k) {
      points.col(static_cast<Eigen::Index>(k)) = points_[k];
    }
    const std::vector<double> weights = roulette_weights(points);
    std::discrete_distribution<std::size_t> roulette(weights.begin(), weights.end());
    while (chosen.size() < static_cast<std::size_t>(options_.fireworks)) {
      chosen.push_back(roulette(random_));
    }
    std::vector<Vector> points_left;
    std::vector<double> objectives_left;
    for (const std::size_t k : chosen) {
      points_left.push_back(points_[k]);
      objectives_left.push_back(objectives_[k]);
    }
    points_ = std::move(points_left);
    objectives_ = std::move(objectives_left);
  }

 private:
  Eigen::Index dimension() const { return evaluator_.problem().dimension(); }
  const Vector& firework(int i) const { return points_[static_cast<std::size_t>(i)]; }

  /// Equation (26).
  Vector spark(Vector x, double amplitude) {
    std::uniform_real_distribution<double> offset(-amplitude, amplitude);
    for (double& coordinate : x) coordinate += offset(random_);
    return x;
  }

  /// Equation (27).
  Vector gaussian_spark(const Vector& x) {
    return x * std::normal_distribution<double>(1.0, 1.0)(random_);
  }

  bool add(const Vector& x) {
    const Vector inside = mapped(x, evaluator_.problem().lower, evaluator_.problem().upper);
    const auto objective = evaluator_.objective(inside);
    if (!objective) return false;
    points_.push_back(inside);
    objectives_.push_back(usable(*objective));
    return true;
  }

  Evaluator& evaluator_;
  const FireworksOptions& options_;
  Random& random_;
  std::vector<Vector> points_;  // the fireworks first
  std::vector<double> objectives_;
};

}  // namespace

std::vector<int> spark_counts(const Vector& objectives, const FireworksOptions& options) {
  const Vector f = ranked(objectives);
  const double worst = f.maxCoeff();
  const double total = (worst - f.array()).sum() + options.epsilon;
  const double fewest = options.fewest * options.sparks;
  const double most = options.most * options.sparks;
  std::vector<int> counts;
  for (const double value : f) {
    double share = options.sparks * (worst - value + options.epsilon) / total;  // (23)
    if (share > most) {
      share = most;
    } else if (share < fewest || options.third_branch == ThirdBranch::as_printed) {
      share = fewest;
    }
    counts.push_back(static_cast<int>(std::round(share)));  // (24)
  }
  return counts;
}

Vector amplitudes(const Vector& objectives, const FireworksOptions& options) {
  const Vector f = ranked(objectives);
  const Vector excess = f.array() - f.minCoeff();
  return options.amplitude * (excess.array() + options.epsilon) / (excess.sum() + options.epsilon);
}

Vector mapped(const Vector& x, const Vector& lower, const Vector& upper) {
  Vector result = x;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (x[k] >= lower[k] && x[k] <= upper[k]) continue;
    const double width = upper[k] - lower[k];
    result[k] = width > 0 ? lower[k] + std::fmod(std::abs(x[k]), width) : lower[k];
  }
  return result;
}

std::vector<double> roulette_weights(const Matrix& points) {
  std::vector<double> weights;
  for (const auto& point : points.colwise()) {
    weights.push_back((points.colwise() - point).colwise().norm().sum());
  }
  const bool apart = std::any_of(weights.begin(), weights.end(), [](double w) { return w > 0; });
  return apart ? weights : std::vector<double>(weights.size(), 1.0);
}

Solver fireworks(std::string name, const FireworksOptions& options) {
  if (options.fireworks < 1) throw std::invalid_argument("fireworks: there must be at least 1");
  if (!(options.amplitude >= 0)) throw std::invalid_argument("amplitude: must be >= 0");
  Solver solver;
  solver.name = std::move(name);
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.stochastic = true;
  solver.accepts = [](const Problem& problem) {
    return has_room(problem) && problem.constraints == 0;
  };
  solver.solve = [options](Evaluator& evaluator, const Vector& start,
                           Random& random) -> SolverExit {
    Generation generation(evaluator, options, random);
    if (!generation.begin(start)) return {stopped_by_evaluator};
    while (generation.explode()) generation.select();
    return {stopped_by_evaluator};
  };
  return solver;
}

}  // namespace ricochet
