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
  Tip(const DisturbedMotion& motion, const DisturbedMotion& other, int rank, Extreme extreme)
      : motion_(motion),
        rank_(rank),
        extreme_(extreme),
        until_(other.omega()),
        in_{motion.omega(), extreme_turn(motion, rank, extreme).phase},
        out_(until_) {
    const double margin = extreme_turn(motion, rank, extreme).margin(rank);
    const double there = extreme_turn(other, rank, extreme).margin(rank);
    if (margin != there) share_ = std::clamp(margin / (margin - there), 0.02, 0.98);
  }

  PhaseTip found() {
    if (const std::optional<double> tip = smooth(first_reach)) return {*tip, in_.phase, true, true};
    if (probe(out_)) return {out_, in_.phase, false, false};
    for (int restarts = 0; restarts < most_restarts; ++restarts) {
      double next_try = width() / 30;
      while (width() > sharp * out_) {
        const double middle = (in_.omega + out_) / 2;
        if (!probe(middle)) out_ = middle;
        if (width() > next_try) continue;
        next_try /= 300;
        share_ = 0.5;
        const double reach = first_reach * std::sqrt(width() / std::abs(motion_.omega() - until_));
        const std::optional<double> tip = smooth(reach);
        if (tip) return {*tip, in_.phase, true, true};
      }
      // Far from the speeds at which they are known such turns may be overlooked.
      if (!probe(out_)) break;
      if (out_ == until_) return {out_, in_.phase, false, false};
      out_ = until_;
    }
    return {in_.omega, in_.phase, true, false};
  }

 private:
  double width() const { return std::abs(in_.omega - out_); }

  /// The tip where margins are smooth in speed and phase, by Newton's method on their differences:
  /// that of one impact is 0 and extreme, or those of two impacts are 0, which change places there.
  /// The phase is then that of the tip.
  std::optional<double> smooth(double phase_reach) {
    Eigen::Vector2d at(in_.omega + share_ * (out_ - in_.omega), in_.phase);
    Eigen::Vector2d reach(width() * std::min({0.2, share_, 1 - share_}), phase_reach);
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
      const bool between = (at[0] - until_) * (at[0] - in_.omega) < 0;
      if (!between || std::abs(at[1] - in_.phase) > farthest_tip) return std::nullopt;
      // The next step would be about the square of this one.
      if (is_extreme && std::abs(step[0]) < 1e-9 * until_ && std::abs(step[1]) < 1e-3) {
        in_.phase = at[1];
        return at[0];
      }
      if (!is_extreme) continue;
      reach[0] =
          std::clamp(2 * std::abs(step[0]), 1e-5 * until_, std::max(1e-5 * until_, 0.2 * reach[0]));
      reach[1] = std::clamp(2 * std::abs(step[1]), 1e-3, std::max(1e-3, 0.2 * reach[1]));
    }
    return std::nullopt;
  }

  /// Looks for such turns at a speed, at phases around those where they are known; these may be few
  /// and drift with the speed. Takes their place if there are some.
  bool probe(double omega) {
    const double guess = in_.phase + drift_ * (omega - in_.omega);
    std::vector<SpeedAndPhase> places = {{omega, in_.phase}, {omega, guess}};
    double aside = farthest_probe;
    for (int k = 0; k < probes_beside; ++k, aside /= 4) {
      places.push_back({omega, guess - aside});
      places.push_back({omega, guess + aside});
    }
    std::vector<double> beyond;
    for (const DisturbedTurn& turn : turns_of(motion_, places)) {
      if (is_beyond(turn, rank_, extreme_)) beyond.push_back(turn.phase);
    }
    if (beyond.empty()) return false;
    const auto middle = beyond.begin() + static_cast<std::ptrdiff_t>(beyond.size() / 2);
    std::nth_element(beyond.begin(), middle, beyond.end());
    drift_ = (*middle - in_.phase) / (omega - in_.omega);
    in_ = {omega, *middle};
    return true;
  }

  /// Places of speed and phase from which a quadratic dependence is known.
  static constexpr std::array<std::array<int, 2>, 7> stencil = {
      {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}}};

  static constexpr int most_steps = 10;
  static constexpr double first_reach = 0.05;   // [rad], of the first stencil, to both sides
  static constexpr double longest_shift = 0.1;  // [rad]
  static constexpr double farthest_tip = 0.5;   // [rad], from the first phase
  static constexpr double sharp = 1e-9;  // relative width at which a bracket of speeds is a border
  static constexpr double farthest_probe = 0.1;  // [rad]
  static constexpr int probes_beside = 11;  // on each side, four times as near from one to the next
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

  double limit() const { return motion_.machine.counting_limit; }

  const DisturbedMotion& motion_;
  int rank_;
  Extreme extreme_;
  double until_;
  SpeedAndPhase in_;    // of such turns
  double out_;          // the speed at which none are known
  double drift_ = 0;    // of the phase over the speed
  double share_ = 0.5;  // of the way to out_, at which the tip is expected
};

}  // namespace

PhaseTip phase_tip(const DisturbedMotion& motion, const DisturbedMotion& other, int rank,
                   Extreme extreme) {
  return Tip(motion, other, rank, extreme).found();
}

}  // namespace ricochet::carrier_track::inline regimes
