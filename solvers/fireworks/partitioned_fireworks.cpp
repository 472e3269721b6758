#include "solvers/fireworks/partitioned_fireworks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "solvers/fireworks/population.h"
#include "solvers/fireworks/sparks.h"

namespace ricochet::fireworks {

namespace {

constexpr double no_spread = 1e-6;  // of the sparks' values
constexpr double no_width = 5e-9;   // [box widths]
constexpr double covered = 0.85;    // share of the better sparks
constexpr double fit_rate = 0.5;
constexpr std::size_t most_fitted = 2;  // points for each firework

/// Coordinates are those of the free ones in the box, from 0 to 1.
struct AdaptiveFirework {
  SearchDistribution distribution;
  TrueValues worth;  // of its best point
  int waited = 0;    // generations without improvement
  Matrix sparks;     // of this generation; no rows if it restarted in it
  std::vector<TrueValues> worths;
  std::vector<Eigen::Index> order;  // of the sparks, from the best to the worst
};

/// A point to which a surface is fitted, and its distance in radii of the surface.
struct Fitted {
  double distance;
  Vector point;
};

class Partition {
 public:
  Partition(Evaluator& evaluator, const PartitionedFireworksOptions& options, const Vector& start,
            Random& random)
      : evaluator_(evaluator),
        options_(options),
        random_(random),
        box_(evaluator.lower(), evaluator.upper()),
        x_(start) {}

  /// Each returns false once the evaluator refuses.
  bool begin();
  bool next_generation();

 private:
  Vector drawn() const;
  std::optional<TrueValues> worth_at(const Vector& free);
  std::optional<AdaptiveFirework> new_firework(const Vector& at);
  bool explode(AdaptiveFirework& firework);
  bool is_stuck(const AdaptiveFirework& firework) const;
  std::vector<bool> restarting() const;
  void cooperate();

  Evaluator& evaluator_;
  const PartitionedFireworksOptions& options_;
  Random& random_;
  Box box_;
  Vector x_;
  std::vector<AdaptiveFirework> fireworks_;
};

/// The better of two fireworks by all of their sparks: -1 the first, 1 the second, 0 neither. One
/// without sparks is worse.
int better_one(const AdaptiveFirework& a, const AdaptiveFirework& b) {
  if (a.order.empty() || b.order.empty()) {
    return static_cast<int>(a.order.empty()) - static_cast<int>(b.order.empty());
  }
  const auto at = [](const AdaptiveFirework& firework, Eigen::Index i) {
    return firework.worths[static_cast<std::size_t>(i)];
  };
  if (better(at(a, a.order.back()), at(b, b.order.front()))) return -1;
  return better(at(b, b.order.back()), at(a, a.order.front())) ? 1 : 0;
}

bool covers(const SearchDistribution& distribution, const AdaptiveFirework& other) {
  const std::size_t half = other.order.size() / 2;
  const auto inside = std::count_if(
      other.order.begin(), other.order.begin() + static_cast<std::ptrdiff_t>(half),
      [&](Eigen::Index i) {
        return distribution.distance(other.sparks.row(i).transpose()) < distribution.expected();
      });
  return static_cast<double>(inside) > covered * static_cast<double>(half);
}

/// The point so many radii from `from` towards `to`, but in the box.
Fitted fitted_point(const Vector& from, const Vector& to, double radii, double radius) {
  const Vector step = radii * radius * (to - from).normalized();
  double part = 1;
  for (Eigen::Index k = 0; k < step.size(); ++k) {
    const double room = step[k] > 0 ? 1 - from[k] : from[k];
    if (std::abs(step[k]) > room) part = std::min(part, room / std::abs(step[k]));
  }
  return {part * std::abs(radii), from + part * step};
}

Vector Partition::drawn() const {
  Vector free(static_cast<Eigen::Index>(box_.free().size()));
  for (Eigen::Index k = 0; k < free.size(); ++k) free[k] = share(random_);
  return free;
}

std::optional<TrueValues> Partition::worth_at(const Vector& free) {
  for (Eigen::Index k = 0; k < free.size(); ++k) {
    const Eigen::Index i = box_.free()[static_cast<std::size_t>(k)];
    x_[i] = std::min(box_.lower()[i] + free[k] * box_.width()[i], box_.upper()[i]);
  }
  const auto values = evaluator_.values(x_);
  if (!values) return std::nullopt;
  return worth_of(*values, evaluator_.equalities());
}

std::optional<AdaptiveFirework> Partition::new_firework(const Vector& at) {
  const auto worth = worth_at(at);
  if (!worth) return std::nullopt;
  return AdaptiveFirework{SearchDistribution(at, options_.initial_scale), *worth, 0, {}, {}, {}};
}

bool Partition::begin() {
  Vector at(static_cast<Eigen::Index>(box_.free().size()));
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    const Eigen::Index i = box_.free()[static_cast<std::size_t>(k)];
    at[k] = (x_[i] - box_.lower()[i]) / box_.width()[i];
  }
  for (int i = 0; i < options_.fireworks; ++i) {
    auto firework = new_firework(i == 0 ? at : drawn());
    if (!firework) return false;
    fireworks_.push_back(std::move(*firework));
  }
  return true;
}

bool Partition::explode(AdaptiveFirework& firework) {
  firework.sparks.resize(options_.sparks, firework.distribution.mean().size());
  firework.worths.clear();
  bool improved = false;
  for (Eigen::Index i = 0; i < options_.sparks; ++i) {
    Vector spark = firework.distribution.draw(random_);
    for (double& coordinate : spark) {
      if (!(coordinate >= 0 && coordinate <= 1)) coordinate = share(random_);
    }
    const auto worth = worth_at(spark);
    if (!worth) return false;
    firework.sparks.row(i) = spark.transpose();
    firework.worths.push_back(*worth);
    if (better(*worth, firework.worth)) {
      firework.worth = *worth;
      improved = true;
    }
  }
  firework.waited = improved ? 0 : firework.waited + 1;
  firework.order.resize(firework.worths.size());
  std::iota(firework.order.begin(), firework.order.end(), Eigen::Index{0});
  std::ranges::stable_sort(firework.order, [&](Eigen::Index a, Eigen::Index b) {
    const TrueValues& one = firework.worths[static_cast<std::size_t>(a)];
    const TrueValues& other = firework.worths[static_cast<std::size_t>(b)];
    return std::tie(one.violation, one.objective) < std::tie(other.violation, other.objective);
  });
  firework.distribution.adapt(firework.sparks, firework.order);
  return true;
}

bool Partition::is_stuck(const AdaptiveFirework& firework) const {
  const Vector values = fitness_of(firework.worths);
  const double spread = std::sqrt((values.array() - values.mean()).square().mean());
  return spread < no_spread || firework.distribution.width() < no_width ||
         firework.waited > options_.patience;
}

std::vector<bool> Partition::restarting() const {
  std::vector<bool> restarts;
  for (const AdaptiveFirework& firework : fireworks_) restarts.push_back(is_stuck(firework));
  std::vector<std::size_t> from_best(fireworks_.size());
  std::iota(from_best.begin(), from_best.end(), std::size_t{0});
  std::ranges::stable_sort(from_best, [&](std::size_t a, std::size_t b) {
    return better(fireworks_[a].worth, fireworks_[b].worth);
  });
  for (std::size_t i = 0; i < from_best.size(); ++i) {
    for (std::size_t j = i + 1; j < from_best.size(); ++j) {
      if (restarts[from_best[i]] || restarts[from_best[j]]) continue;
      restarts[from_best[j]] =
          covers(fireworks_[from_best[i]].distribution, fireworks_[from_best[j]]);
    }
  }
  return restarts;
}

void Partition::cooperate() {
  std::vector<std::vector<Fitted>> fitted(fireworks_.size());
  for (std::size_t i = 0; i < fireworks_.size(); ++i) {
    for (std::size_t j = i + 1; j < fireworks_.size(); ++j) {
      const SearchDistribution& one = fireworks_[i].distribution;
      const SearchDistribution& other = fireworks_[j].distribution;
      const double apart = (one.mean() - other.mean()).norm();
      if (!(apart > 0)) continue;
      const double radius = one.radius_towards(other.mean());
      const double other_radius = other.radius_towards(one.mean());
      const int which = better_one(fireworks_[i], fireworks_[j]);
      const bool alone = which != 0;
      if (which >= 0) {
        const double radii = fitted_radius(apart, radius, other_radius, alone);
        fitted[i].push_back(fitted_point(one.mean(), other.mean(), radii, radius));
      }
      if (which <= 0) {
        const double radii = fitted_radius(apart, other_radius, radius, alone);
        fitted[j].push_back(fitted_point(other.mean(), one.mean(), radii, other_radius));
      }
    }
  }
  for (std::size_t i = 0; i < fireworks_.size(); ++i) {
    std::vector<Fitted>& points = fitted[i];
    if (points.empty()) continue;
    std::ranges::stable_sort(points, {}, &Fitted::distance);
    points.resize(std::min(points.size(), most_fitted), points.front());
    SearchDistribution& distribution = fireworks_[i].distribution;
    Matrix rows(static_cast<Eigen::Index>(points.size()), distribution.mean().size());
    for (Eigen::Index k = 0; k < rows.rows(); ++k) {
      rows.row(k) = points[static_cast<std::size_t>(k)].point.transpose();
    }
    distribution.fit(rows, fit_rate);
  }
}

bool Partition::next_generation() {
  for (AdaptiveFirework& firework : fireworks_) {
    if (!explode(firework)) return false;
  }
  const std::vector<bool> restarts = restarting();
  for (std::size_t i = 0; i < fireworks_.size(); ++i) {
    if (!restarts[i]) continue;
    auto firework = new_firework(drawn());
    if (!firework) return false;
    fireworks_[i] = std::move(*firework);
  }
  cooperate();
  return true;
}

}  // namespace

double fitted_radius(double apart, double radius, double other_radius, bool alone) {
  const double gap = apart - radius - other_radius;
  const double radii = (radius + (alone ? gap : gap / 2)) / radius;
  return std::copysign(std::clamp(std::abs(radii), 0.5, 2.0), radii);
}

Solver partitioned_fireworks(std::string name, const PartitionedFireworksOptions& options) {
  check_number("fireworks", options.fireworks);
  check_number("sparks", options.sparks);
  check_number("patience", options.patience);
  if (!(options.initial_scale > 0 && options.initial_scale <= 1)) {
    throw std::invalid_argument("initial_scale: must be in (0, 1]");
  }
  return member(std::move(name),
                [options](Evaluator& evaluator, const Vector& start, Random& random) {
                  Partition partition(evaluator, options, start, random);
                  if (!partition.begin()) return;
                  while (partition.next_generation()) {
                  }
                });
}

}  // namespace ricochet::fireworks
