#include "problems/carrier_track/regimes/phase_window.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr int parts = 32;  // of a window, in the search for its least margin
constexpr double golden = 0.6180339887498949;

using Row = std::vector<double>;  // speeds of one impact at the nodes

/// The speeds of the impacts of a turn, apart by the series of rebounds on a wall that they belong
/// to.
std::vector<Row> series_of(const DisturbedTurn& turn) {
  std::vector<Row> series;
  for (std::size_t i = 0; i < turn.impacts.size(); ++i) {
    if (i == 0 || turn.impacts[i].wall != turn.impacts[i - 1].wall) series.emplace_back();
    series.back().push_back(turn.impacts[i].speed);
  }
  return series;
}

/// The impacts that all turns have, each with its speed in every turn; none if the turns differ in
/// their series.
std::vector<Row> common_impacts(const std::vector<DisturbedTurn>& turns) {
  std::vector<std::vector<Row>> all;
  for (const DisturbedTurn& turn : turns) all.push_back(series_of(turn));
  std::vector<Row> rows;
  for (std::size_t s = 0; s < all[0].size(); ++s) {
    std::size_t length = all[0][s].size();
    for (const auto& series : all) {
      if (series.size() != all[0].size()) return {};
      length = std::min(length, series[s].size());
    }
    for (std::size_t i = 0; i < length; ++i) {
      Row& row = rows.emplace_back();
      for (const auto& series : all) row.push_back(series[s][i]);
    }
  }
  return rows;
}

using Cosines = std::array<std::array<double, PhaseWindow::nodes>, PhaseWindow::nodes>;

/// Of the Chebyshev polynomials at the nodes.
const Cosines& cosines() {
  constexpr std::size_t count = PhaseWindow::nodes;
  static const Cosines table = [] {
    Cosines all;
    for (std::size_t j = 0; j < count; ++j) {
      for (std::size_t k = 0; k < count; ++k) {
        const double angle = std::numbers::pi * (static_cast<double>(k) + 0.5) / count;
        all[j][k] = std::cos(static_cast<double>(j) * angle);
      }
    }
    return all;
  }();
  return table;
}

}  // namespace

PhaseWindow::PhaseWindow(const DisturbedMotion& motion, int rank, double centre, double reach)
    : rank_(rank), centre_(centre), reach_(reach), counting_limit_(motion.machine.counting_limit) {
  std::array<double, nodes> phases;
  for (std::size_t k = 0; k < nodes; ++k) {
    phases[k] =
        centre + reach * std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) / nodes);
  }
  fit(turns_at_phases(motion.machine, phases, motion.turns_before));
}

void PhaseWindow::fit(const std::vector<DisturbedTurn>& turns) {
  const auto place = static_cast<std::size_t>(rank_ - 1);
  double slowest = std::numeric_limits<double>::infinity();
  double fastest = 0;
  for (const DisturbedTurn& turn : turns) {
    if (rank_ < 1 || place >= turn.speeds.size()) return;
    slowest = std::min(slowest, turn.speeds[place]);
    fastest = std::max(fastest, turn.speeds[place]);
  }
  const double span = fastest - slowest;
  for (const Row& row : common_impacts(turns)) {
    const auto [least, most] = std::minmax_element(row.begin(), row.end());
    if (*least > fastest + span) {
      ++faster_;
      continue;
    }
    if (*most < slowest - span) continue;
    Polynomial& polynomial = speeds_.emplace_back();
    for (std::size_t j = 0; j < nodes; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < nodes; ++k) {
        sum += row[k] * cosines()[j][k];
      }
      polynomial[j] = sum * (j == 0 ? 1.0 : 2.0) / nodes;
    }
    // The coefficients of a smooth dependence fall.
    error_ = std::max(error_, std::abs(polynomial[nodes - 1]) / fastest);
  }
  known_ = faster_ <= place && place - faster_ < speeds_.size();
}

double PhaseWindow::speed_at(double place) const {
  std::vector<double>& speeds = there_;
  speeds.clear();
  for (const Polynomial& polynomial : speeds_) {
    double here = 0;
    double next = 0;
    for (std::size_t j = nodes - 1; j > 0; --j) {
      const double before = next;
      next = here;
      here = 2 * place * next - before + polynomial[j];
    }
    speeds.push_back(place * here - next + polynomial[0]);
  }
  const auto nth = speeds.begin() + (rank_ - 1 - static_cast<int>(faster_));
  std::nth_element(speeds.begin(), nth, speeds.end(), std::greater<>());
  return *nth;
}

PhaseWindow::Valley PhaseWindow::least(double sign) const {
  const auto value_at = [&](double place) { return sign * speed_at(place); };
  int deepest = 0;
  double value = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= parts; ++k) {
    const double there = value_at(2.0 * k / parts - 1);
    if (there < value) {
      value = there;
      deepest = k;
    }
  }
  // By the golden section: at the least there may be a kink, where two impacts change places.
  double low = std::max(-1.0, 2.0 * (deepest - 1) / parts - 1);
  double high = std::min(1.0, 2.0 * (deepest + 1) / parts - 1);
  double left = high - golden * (high - low);
  double right = low + golden * (high - low);
  double at_left = value_at(left);
  double at_right = value_at(right);
  while (high - low > 1e-12) {
    if (at_left < at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = value_at(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = value_at(right);
    }
  }
  const double place = (low + high) / 2;
  const double speed = sign * std::min({value, at_left, at_right});
  return {centre_ + reach_ * place, sign * std::log(speed / counting_limit_),
          deepest > 0 && deepest < parts};
}

}  // namespace ricochet::carrier_track::inline regimes
