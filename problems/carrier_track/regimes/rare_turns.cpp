#include "problems/carrier_track/regimes/rare_turns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace ricochet::carrier_track::inline regimes {
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

}  // namespace ricochet::carrier_track::inline regimes
