#include "src/analysis/statistics/running_time.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "src/analysis/statistics/intervals.h"

namespace ricochet {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Totals {
  double runs = 0, spent = 0, successes = 0;
};

Totals totals_of(const std::vector<Effort>& runs) {
  Totals totals;
  for (const Effort& run : runs) {
    if (!(run.spent >= 0 && std::isfinite(run.spent))) {
      throw std::invalid_argument("expected running time: an effort must be finite and >= 0");
    }
    ++totals.runs;
    totals.spent += run.spent;
    totals.successes += run.reached ? 1 : 0;
  }
  return totals;
}

/// Distance from a sum to its interval's end, if a and b are those of its two terms.
double joined(double a, double b, double correlation) {
  return std::sqrt(std::max(0.0, a * a + b * b + 2 * correlation * a * b));
}

}  // namespace

std::optional<double> expected_running_time(const std::vector<Effort>& runs) {
  const Totals totals = totals_of(runs);
  if (totals.successes == 0) return std::nullopt;
  return totals.spent / totals.successes;
}

Interval expected_running_time_interval(const std::vector<Effort>& runs, double confidence) {
  check_confidence(confidence);
  const auto [size, spent, successes] = totals_of(runs);
  if (size == 0) throw std::invalid_argument("expected_running_time_interval: no runs");
  const double mean = spent / size;
  const double share = successes / size;
  if (share == 0) {
    const double largest = 1 - std::pow((1 - confidence) / 2, 1 / size);  // Clopper and Pearson's
    return {mean / largest, infinity};
  }
  if (size == 1) return {0, infinity};
  if (mean == 0) return {0, 0};
  double squares = 0;
  double products = 0;  // with the indicator of failure
  for (const Effort& run : runs) {
    squares += std::pow(run.spent - mean, 2);
    products += (run.spent - mean) * (share - (run.reached ? 1 : 0));
  }
  const double failed_squares = size * share * (1 - share);
  const double correlation =
      squares > 0 && failed_squares > 0
          ? std::clamp(products / std::sqrt(squares * failed_squares), -1.0, 1.0)
          : 0;
  // The logarithm of the running time is that of the mean effort less that of the share.
  const double t = quantile(boost::math::students_t(size - 1), (1 + confidence) / 2);
  const double of_mean = t * std::sqrt(squares / (size * (size - 1))) / mean;
  const Interval wilson = wilson_interval(successes, size, confidence);
  const double estimate = mean / share;
  return {estimate * std::exp(-joined(of_mean, std::log(wilson.upper / share), correlation)),
          estimate * std::exp(joined(of_mean, std::log(share / wilson.lower), correlation))};
}

double shifted_geometric_mean(const std::vector<double>& costs, double shift, double floor) {
  if (costs.empty()) throw std::invalid_argument("shifted_geometric_mean: no costs");
  if (!(shift >= 0 && floor >= 0 && shift + floor > 0 && std::isfinite(shift + floor))) {
    throw std::invalid_argument("shifted_geometric_mean: shift and floor must be >= 0, one > 0");
  }
  double sum = 0;
  for (const double cost : costs) {
    if (!(cost >= 0)) throw std::invalid_argument("shifted_geometric_mean: a cost must be >= 0");
    sum += std::log(std::max(cost, floor) + shift);
  }
  return std::exp(sum / static_cast<double>(costs.size())) - shift;
}

std::size_t check_costs(const Costs& costs) {
  if (costs.empty() || costs.front().empty()) {
    throw std::invalid_argument("costs: a problem and a solver are needed");
  }
  for (const std::vector<double>& row : costs) {
    if (row.size() != costs.front().size()) {
      throw std::invalid_argument("costs: every problem needs a cost of every solver");
    }
    for (const double cost : row) {
      if (!(cost > 0)) throw std::invalid_argument("costs: a cost must be > 0");
    }
  }
  return costs.front().size();
}

}  // namespace ricochet
