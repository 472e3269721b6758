#include "problems/carrier_track/regimes/sampled_turns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "src/core/time_limit.h"

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

namespace {

constexpr double circle = 2 * std::numbers::pi;
constexpr double narrowest_gap = 1e-4;  // [rad]
constexpr double narrow_gap = 1e-3;     // [rad], in which margins jump, if they change much
constexpr double slow = -1.5;           // margins that are lower are alike
constexpr double share_beside = 0.5;    // of the change over a gap, over its neighbours
constexpr double overshoot = 4;         // of a change over a gap, within it

/// The impacts of a turn that are not slow.
struct TurnSketch {
  double phase;                 // [rad]
  std::vector<double> margins;  // the fastest first
  double first = slow;          // margin of the first: another where a turn begins after it

  TurnSketch(const DisturbedTurn& turn, double at_phase, double counting_limit) : phase(at_phase) {
    const double slowest = counting_limit * std::exp(slow);
    for (const double speed : turn.speeds) {
      if (speed <= slowest) break;
      margins.push_back(std::log(speed / counting_limit));
    }
    if (!turn.impacts.empty()) {
      first = std::max(slow, std::log(turn.impacts.front().speed / counting_limit));
    }
  }

  double margin(std::size_t rank) const {
    return rank <= margins.size() ? margins[rank - 1] : slow;
  }
};

/// By how much margins change from one turn to another.
double change_between(const TurnSketch& a, const TurnSketch& b) {
  double change = std::abs(a.first - b.first);
  const std::size_t ranks = std::max(a.margins.size(), b.margins.size());
  for (std::size_t rank = 1; rank <= ranks; ++rank) {
    change = std::max(change, std::abs(a.margin(rank) - b.margin(rank)));
  }
  return change;
}

/// The turns of a motion at ever more phases.
class PhaseGaps {
 public:
  explicit PhaseGaps(const DisturbedMotion& motion)
      : motion_(motion), least_(motion.least), most_(motion.most) {
    for (const auto* turns : {&motion.turns, &motion.watched}) {
      for (const DisturbedTurn& turn : *turns) add(turn);
    }
    sort();
  }

  /// Halves the gaps in which rare turns may hide; takes the rare turns. False if there are none.
  bool halve(std::vector<DisturbedTurn>& rare) {
    const std::vector<double> middles = middles_of_gaps();
    for (DisturbedTurn& turn : turns_at_phases(motion_.machine, middles, motion_.turns_before)) {
      add(turn);
      if (turn.collisions >= least_ && turn.collisions <= most_) continue;
      least_ = std::min(least_, turn.collisions);
      most_ = std::max(most_, turn.collisions);
      rare.push_back(std::move(turn));
    }
    sort();
    return !middles.empty();
  }

 private:
  void add(const DisturbedTurn& turn) {
    const double away = std::fmod(turn.phase, circle);
    turns_.emplace_back(turn, away < 0 ? away + circle : away, motion_.machine.counting_limit);
  }

  void sort() {
    std::sort(turns_.begin(), turns_.end(),
              [](const TurnSketch& a, const TurnSketch& b) { return a.phase < b.phase; });
  }

  const TurnSketch& turn(std::size_t k) const { return turns_[k % turns_.size()]; }
  double gap_after(std::size_t k) const {
    return turn(k + 1).phase - turn(k).phase + (k + 1 == turns_.size() ? circle : 0);
  }

  /// How far margins of both turns are from other counts.
  double distance(const TurnSketch& a, const TurnSketch& b) const {
    const auto more = static_cast<std::size_t>(most_) + 1;
    const double above = -std::max(a.margin(more), b.margin(more));
    if (least_ == 0) return above;
    const auto fewer = static_cast<std::size_t>(least_);
    return std::min({above, a.margin(fewer), b.margin(fewer)});
  }

  std::vector<double> middles_of_gaps() const {
    const std::size_t count = turns_.size();
    std::vector<double> changes;
    for (std::size_t k = 0; k < count; ++k) changes.push_back(change_between(turn(k), turn(k + 1)));
    std::vector<double> middles;
    for (std::size_t k = 0; k < count; ++k) {
      const double gap = gap_after(k);
      if (gap <= narrowest_gap) continue;
      double change = changes[k];
      for (const std::size_t beside : {(k + 1) % count, (k + count - 1) % count}) {
        const double here = changes[beside] * std::min(1.0, gap / gap_after(beside));
        change = std::max(change, share_beside * here);
      }
      const double reach = gap > narrow_gap ? overshoot : 1;
      if (reach * change > distance(turn(k), turn(k + 1))) {
        middles.push_back(turn(k).phase + gap / 2);
      }
    }
    return middles;
  }

  const DisturbedMotion& motion_;
  int least_, most_;
  std::vector<TurnSketch> turns_;
};

}  // namespace

std::vector<DisturbedTurn> rare_turns(const DisturbedMotion& motion) {
  std::vector<DisturbedTurn> rare;
  PhaseGaps gaps(motion);
  while (gaps.halve(rare)) {
  }
  return rare;
}

namespace {

constexpr int sampled_speeds = 24;

/// Collisions by the turn in which they happen.
struct TurnCounts : Observer {
  static constexpr bool hears_impacts_alone = true;

  double counting_limit = 0;
  double period = 0;  ///< [s], of a turn
  std::vector<int> counts = std::vector<int>(2 * sampled_turns_each);

  void impact(double time, Wall /*wall*/, double speed) {
    if (!is_counted(speed, counting_limit)) return;
    const auto index = static_cast<std::size_t>(time / period);
    ++counts[std::min(index, counts.size() - 1)];
  }
};

SampledTurns turns_at(const Scene& machine, double omega) {
  Scene scene = at_speed(machine, omega);
  scene.fidelity = Fidelity::impact;
  begin_turns_at_rest(scene);
  scene.window = Revolutions{2 * sampled_turns_each};
  const auto phases = static_cast<std::size_t>(is_disturbed(scene) ? sampled_phases : 1);
  TurnCounts none;
  none.counting_limit = scene.counting_limit;
  none.period = 2 * std::numbers::pi / omega;
  std::vector<TurnCounts> heard(phases, none);
  const auto model_at = [&](std::size_t k) {
    Scene there = scene;
    there.disturbance_phase +=
        2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(phases);
    return ImpactModel<double>(there);
  };
  const auto outcomes =
      run_in_lanes(phases, model_at, [&](std::size_t k) -> TurnCounts& { return heard[k]; });
  SampledTurns result{omega, 0, 0};
  for (std::size_t k = 0; k < phases; ++k) {
    if (outcomes[k].failure) std::rethrow_exception(outcomes[k].failure);
    const auto settled = heard[k].counts.begin() + sampled_turns_each;
    const int all = std::accumulate(settled, heard[k].counts.end(), 0);
    result.mean_per_turn += all / static_cast<double>(phases * sampled_turns_each);
    result.most_per_turn =
        std::max(result.most_per_turn, *std::max_element(settled, heard[k].counts.end()));
  }
  return result;
}

}  // namespace

std::vector<SampledTurns> sampled_turns(const Scene& scene, double from, double to) {
  std::vector<SampledTurns> sampled;
  try {
    // A turn at a slow speed takes longest.
    for (int k = sampled_speeds - 1; k >= 0; --k) {
      report_progress("simulations at single speeds", 1 - (k + 1.0) / sampled_speeds);
      const double omega =
          k == sampled_speeds - 1 ? to : from * std::pow(to / from, k / (sampled_speeds - 1.0));
      sampled.push_back(turns_at(scene, omega));
    }
  } catch (const TimeLimitReached&) {
    // The speeds that had time are returned.
  } catch (const std::runtime_error&) {
    // More impacts than a simulation may have: at slower speeds, turns have even more.
  }
  std::reverse(sampled.begin(), sampled.end());
  return sampled;
}

}  // namespace ricochet::carrier_track::inline regimes
