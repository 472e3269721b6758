#include "problems/carrier_track/regimes/phase_tip.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace ricochet::carrier_track::inline regimes {

namespace {

/// Which impact of a turn: the series of impacts on one wall that it belongs to, and its place.
using PlaceInTurn = std::pair<int, int>;

/// Calls `visit(margin, place)` for the impacts of a turn.
template <class Visit>
void visit_impacts(const DisturbedTurn& turn, double counting_limit, const Visit& visit) {
  PlaceInTurn place{-1, 0};
  for (std::size_t i = 0; i < turn.impacts.size(); ++i) {
    const bool goes_on = i > 0 && turn.impacts[i].wall == turn.impacts[i - 1].wall;
    place = goes_on ? PlaceInTurn{place.first, place.second + 1} : PlaceInTurn{place.first + 1, 0};
    visit(std::log(turn.impacts[i].speed / counting_limit), place);
  }
}

class Tip {
 public:
  Tip(const DisturbedMotion& motion, int rank, Extreme extreme, double until)
      : motion_(motion),
        rank_(rank),
        extreme_(extreme),
        until_(until),
        phase_(extreme_turn(motion, rank, extreme).phase) {}

  /// Where margins are smooth in speed and phase, by Newton's method on their differences: that of
  /// one impact is 0 and extreme, or those of two impacts are 0, which change places there.
  std::optional<PhaseTip> smooth() const {
    const double width = std::abs(motion_.omega() - until_);
    Eigen::Vector2d at((motion_.omega() + until_) / 2, phase_);
    Eigen::Vector2d reach(width / 2, first_reach);
    std::optional<PlaceInTurn> one;
    std::optional<PlaceInTurn> other;
    for (int k = 0; k < most_steps; ++k) {
      std::vector<SpeedAndPhase> places;
      for (const auto& [i, j] : stencil) {
        places.push_back({at[0] + i * reach[0], at[1] + j * reach[1]});
      }
      const std::vector<DisturbedTurn> turns = turns_of(motion_, places);
      for (std::size_t i = 0; i < turns.size() && !other; ++i) {
        const std::optional<PlaceInTurn> here = place_of_rank(turns[i]);
        if (!here) return std::nullopt;
        if (i == 0) one = here;
        if (here != one) other = here;
      }
      const std::optional<Differences> first = differences(turns, *one, reach);
      if (!first) return std::nullopt;
      Eigen::Vector2d step;
      bool is_extreme = true;
      if (other) {
        const std::optional<Differences> second = differences(turns, *other, reach);
        if (!second) return std::nullopt;
        Eigen::Matrix2d jacobian;
        jacobian << first->slope, first->drift, second->slope, second->drift;
        step = -jacobian.inverse() * Eigen::Vector2d(first->value, second->value);
      } else {
        is_extreme = (first->bend > 0) == (extreme_ == Extreme::least);
        step = first->to_extreme();
        if (!is_extreme || std::abs(step[1]) > longest_shift) {
          // Towards the extreme, as far as another impact comes in.
          const bool forwards = (first->drift > 0) == (extreme_ == Extreme::most);
          step[1] = forwards ? longest_shift : -longest_shift;
          step[0] = -(first->value + first->drift * step[1]) / first->slope;
          is_extreme = false;
        }
      }
      if (!step.allFinite()) return std::nullopt;
      at += step;
      const bool between = (at[0] - until_) * (at[0] - motion_.omega()) < 0;
      if (!between || std::abs(at[1] - phase_) > farthest_tip) return std::nullopt;
      // The next step would be about the square of this one.
      if (is_extreme && std::abs(step[0]) < 1e-9 * until_ && std::abs(step[1]) < 1e-3) {
        return PhaseTip{at[0], at[1], true, true};
      }
      if (!is_extreme) continue;
      reach[0] =
          std::clamp(2 * std::abs(step[0]), 1e-5 * until_, std::max(1e-5 * until_, 0.2 * reach[0]));
      reach[1] = std::clamp(2 * std::abs(step[1]), 1e-3, std::max(1e-3, 0.2 * reach[1]));
    }
    return std::nullopt;
  }

  /// By bisection of the speed, with phases around those of such turns, which may be few and drift
  /// with the speed.
  PhaseTip bisected() const {
    SpeedAndPhase in{motion_.omega(), phase_};
    double drift = 0;
    double out = until_;
    const auto probe = [&](double omega) {
      const double guess = in.phase + drift * (omega - in.omega);
      const std::optional<double> phase = middle_beyond(omega, in.phase, guess);
      if (!phase) return false;
      drift = (*phase - in.phase) / (omega - in.omega);
      in = {omega, *phase};
      return true;
    };
    if (probe(out)) return {out, in.phase, false, false};
    for (int restarts = 0; restarts < most_restarts; ++restarts) {
      while (std::abs(in.omega - out) > sharp * out) {
        const double middle = (in.omega + out) / 2;
        if (!probe(middle)) out = middle;
      }
      // Far from the speeds at which they are known such turns may be overlooked.
      if (out == until_ || !probe(out)) break;
      out = until_;
    }
    const std::array<SpeedAndPhase, 2> beside = {{in, {out, in.phase}}};
    const auto turns = turns_of(motion_, beside);
    const bool is_smooth = std::all_of(turns.begin(), turns.end(), [&](const auto& turn) {
      return std::abs(turn.margin(rank_)) < without_jump;
    });
    return {in.omega, in.phase, true, is_smooth};
  }

 private:
  /// Places of speed and phase from which a quadratic dependence is known.
  static constexpr std::array<std::array<int, 2>, 7> stencil = {
      {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}}};

  static constexpr int most_steps = 10;
  static constexpr double first_reach = 0.05;   // [rad], of the first stencil, to both sides
  static constexpr double longest_shift = 0.1;  // [rad]
  static constexpr double farthest_tip = 0.5;   // [rad], from the first phase
  static constexpr double sharp = 1e-9;  // relative width at which a bracket of speeds is a border
  static constexpr double farthest_probe = 0.1;  // [rad]
  static constexpr int probes_beside = 7;  // on each side, four times as near from one to the next
  static constexpr double without_jump = 1e-5;  // a margin so small on both sides passes 0
  static constexpr int most_restarts = 20;

  /// The margin of an impact at the middle of the stencil, and its derivatives.
  struct Differences {
    double value;
    double slope, drift;        // over the speed, over the phase
    double curve, bend, twist;  // twice over the speed, over the phase, over both

    /// The step to where the margin is 0 and its drift is 0.
    Eigen::Vector2d to_extreme() const {
      Eigen::Vector2d step = Eigen::Vector2d::Zero();
      for (int n = 0; n < 6; ++n) {
        const double d = step[0];
        const double p = step[1];
        const double at_step =
            value + slope * d + drift * p + curve * d * d / 2 + bend * p * p / 2 + twist * d * p;
        const double drift_there = drift + bend * p + twist * d;
        Eigen::Matrix2d jacobian;
        jacobian << slope + curve * d + twist * p, drift_there, twist, bend;
        step -= jacobian.inverse() * Eigen::Vector2d(at_step, drift_there);
      }
      return step;
    }
  };

  /// Nothing if a turn lacks the impact.
  std::optional<Differences> differences(const std::vector<DisturbedTurn>& turns,
                                         const PlaceInTurn& wanted,
                                         const Eigen::Vector2d& reach) const {
    std::array<double, stencil.size()> f;
    for (std::size_t i = 0; i < f.size(); ++i) {
      bool found = false;
      visit_impacts(turns[i], limit(), [&](double margin, const PlaceInTurn& place) {
        if (place != wanted) return;
        found = true;
        f[i] = margin;
      });
      if (!found) return std::nullopt;
    }
    const double d = reach[0];
    const double p = reach[1];
    const double twist = (f[5] - f[1] - f[3] + 2 * f[0] - f[2] - f[4] + f[6]) / (2 * d * p);
    return Differences{f[0],
                       (f[1] - f[2]) / (2 * d),
                       (f[3] - f[4]) / (2 * p),
                       (f[1] - 2 * f[0] + f[2]) / (d * d),
                       (f[3] - 2 * f[0] + f[4]) / (p * p),
                       twist};
  }

  std::optional<PlaceInTurn> place_of_rank(const DisturbedTurn& turn) const {
    std::optional<PlaceInTurn> found;
    visit_impacts(turn, limit(), [&](double margin, const PlaceInTurn& place) {
      if (margin == turn.margin(rank_)) found = place;
    });
    return found;
  }

  /// The middle one of phases around `centre` that have such turns at a speed; `guess` is another
  /// phase to look at.
  std::optional<double> middle_beyond(double omega, double centre, double guess) const {
    std::vector<SpeedAndPhase> places = {{omega, centre}, {omega, guess}};
    double aside = farthest_probe;
    for (int k = 0; k < probes_beside; ++k, aside /= 4) {
      places.push_back({omega, guess - aside});
      places.push_back({omega, guess + aside});
    }
    std::vector<double> beyond;
    for (const DisturbedTurn& turn : turns_of(motion_, places)) {
      if (is_beyond(turn, rank_, extreme_)) beyond.push_back(turn.phase);
    }
    if (beyond.empty()) return std::nullopt;
    const auto middle = beyond.begin() + static_cast<std::ptrdiff_t>(beyond.size() / 2);
    std::nth_element(beyond.begin(), middle, beyond.end());
    return *middle;
  }

  double limit() const { return motion_.machine.counting_limit; }

  const DisturbedMotion& motion_;
  int rank_;
  Extreme extreme_;
  double until_, phase_;
};

}  // namespace

PhaseTip phase_tip(const DisturbedMotion& motion, int rank, Extreme extreme, double until) {
  const Tip tip(motion, rank, extreme, until);
  const std::optional<PhaseTip> smooth = tip.smooth();
  return smooth ? *smooth : tip.bisected();
}

}  // namespace ricochet::carrier_track::inline regimes
