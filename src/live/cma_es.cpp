#include "src/live/cma_es.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "solvers/unit_box.h"

namespace ricochet::live {
namespace {

constexpr double shortest_step = 1e-6;  // of the box
constexpr const char* short_steps = "its steps are shorter than 1e-6 of the box";

// Table 1 of the tutorial, for n = 1.
constexpr double n = 1;
constexpr std::size_t offspring = 4;  // lambda = 4 + floor(3 ln n)
constexpr std::size_t parents = 2;    // mu = lambda / 2

struct Parameters {
  std::array<double, parents> weights{};
  double effective = 0;  ///< mu_eff
  double step_rate, step_damping, path_rate, rank_one, rank_mu;

  Parameters() {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < parents; ++i) {
      weights[i] = std::log((offspring + 1) / 2.0) - std::log(static_cast<double>(i + 1));
      sum += weights[i];
    }
    for (double& weight : weights) {
      weight /= sum;
      squares += weight * weight;
    }
    effective = 1 / squares;
    step_rate = (effective + 2) / (n + effective + 5);
    step_damping = 1 + 2 * std::max(0.0, std::sqrt((effective - 1) / (n + 1)) - 1) + step_rate;
    path_rate = (4 + effective / n) / (n + 4 + 2 * effective / n);
    rank_one = 2 / ((n + 1.3) * (n + 1.3) + effective);
    rank_mu = std::min(
        1 - rank_one, 2 * (0.25 + effective - 2 + 1 / effective) / ((n + 2) * (n + 2) + effective));
  }
};

struct Offspring {
  double u, value;  ///< u in the unit box
};

/// Mean, step and variance of the search distribution, N(mean, step^2 variance).
class Strategy {
 public:
  Strategy(double mean, double step) : mean_(mean), step_(step) {}

  double draw(Random& random) const {
    const double u = mean_ + width() * normal(1, random)[0];
    return std::clamp(u, 0.0, 1.0);
  }

  double width() const { return step_ * std::sqrt(variance_); }

  /// Moves to the best of these offspring, which are sorted.
  void adapt(const std::array<Offspring, offspring>& sorted) {
    double moved = 0, spread = 0;
    for (std::size_t i = 0; i < parents; ++i) {
      const double y = (sorted[i].u - mean_) / step_;
      moved += with_.weights[i] * y;
      spread += with_.weights[i] * y * y;
    }
    mean_ += step_ * moved;
    ++generation_;
    const auto gain = [this](double rate) {
      return std::sqrt(rate * (2 - rate) * with_.effective);
    };
    step_path_ =
        (1 - with_.step_rate) * step_path_ + gain(with_.step_rate) * moved / std::sqrt(variance_);
    const double expected = std::sqrt(2 / std::numbers::pi);  // of |N(0, 1)|
    const double settled = std::sqrt(1 - std::pow(1 - with_.step_rate, 2 * generation_));
    const bool steady = std::abs(step_path_) / settled < (1.4 + 2 / (n + 1)) * expected;
    path_ = (1 - with_.path_rate) * path_ + (steady ? gain(with_.path_rate) * moved : 0);
    const double lost = steady ? 0 : with_.rank_one * with_.path_rate * (2 - with_.path_rate);
    variance_ = (1 + lost - with_.rank_one - with_.rank_mu) * variance_ +
                with_.rank_one * path_ * path_ + with_.rank_mu * spread;
    step_ *= std::exp(with_.step_rate / with_.step_damping * (std::abs(step_path_) / expected - 1));
  }

 private:
  Parameters with_;
  double mean_, step_;
  double variance_ = 1;
  double step_path_ = 0, path_ = 0;
  int generation_ = 0;
};

SolverTermination minimise(UnitBox box, const Vector& start, double initial_step, Random& random) {
  Strategy strategy(box.to_unit(start)[0], initial_step);
  while (strategy.width() >= shortest_step) {
    std::array<Offspring, offspring> drawn{};
    for (Offspring& one : drawn) {
      one.u = strategy.draw(random);
      const auto values = box.values(Vector::Constant(1, one.u));
      if (!values) return {stopped_by_evaluator};
      one.value = values->objective;
    }
    std::stable_sort(drawn.begin(), drawn.end(),
                     [](const Offspring& a, const Offspring& b) { return a.value < b.value; });
    strategy.adapt(drawn);
  }
  return {short_steps};
}

}  // namespace

Solver cma_es(double initial_step) {
  Solver solver;
  solver.name = "cma-es";
  solver.stochastic = true;
  solver.solve = [initial_step](Evaluator& evaluator, const Vector& start, Random& random) {
    return minimise(UnitBox(evaluator), start, initial_step, random);
  };
  return solver;
}

}  // namespace ricochet::live
