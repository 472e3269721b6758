#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "problems/carrier_track/regimes/border.h"
#include "src/core/bracketed_root.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr double sharp = 1e-13;       // relative width at which a bracket of speeds is a border
constexpr double small_margin = 0.2;  // margins so small on both sides of a border may pass 0
constexpr double first_reach_of_tip = 0.05;  // [rad], of the first stencil, to both sides
constexpr double first_step = 1e-2;          // down, of the width of the search
constexpr double narrowest = 1e-13;          // [rad], of phases that are beyond
constexpr double farthest_beside = 0.1;      // [rad], from a tip
constexpr int most_rounds = 200;

/// Places of speed and phase from which a quadratic dependence is known.
constexpr std::array<std::array<int, 2>, 7> stencil = {
    {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}}};

constexpr int tip_newton_steps = 10;
constexpr double longest_shift = 0.1;  // [rad]
constexpr double farthest_tip = 0.5;   // [rad], from the first phase

/// Which impact of a turn: the series of impacts on one wall that it belongs to, and its place.
struct ImpactPlace {
  int series, place;

  bool operator==(const ImpactPlace&) const = default;
};

/// Calls `visit(impact, place)` for the impacts of a turn, until that returns true.
template <class Visit>
void visit_impacts(const DisturbedTurn& turn, const Visit& visit) {
  ImpactPlace place{-1, 0};
  for (std::size_t i = 0; i < turn.impacts.size(); ++i) {
    const bool goes_on = i > 0 && turn.impacts[i].wall == turn.impacts[i - 1].wall;
    place = goes_on ? ImpactPlace{place.series, place.place + 1} : ImpactPlace{place.series + 1, 0};
    if (visit(turn.impacts[i], place)) return;
  }
}

std::optional<ImpactPlace> place_of_rank(const DisturbedTurn& turn, int rank) {
  if (rank < 1 || rank > static_cast<int>(turn.speeds.size())) return std::nullopt;
  const double speed = turn.speeds[static_cast<std::size_t>(rank - 1)];
  std::optional<ImpactPlace> found;
  visit_impacts(turn, [&](const Impact& impact, const ImpactPlace& place) {
    if (impact.speed == speed) found = place;
    return found.has_value();
  });
  return found;
}

std::optional<double> speed_at_place(const DisturbedTurn& turn, const ImpactPlace& wanted) {
  std::optional<double> found;
  visit_impacts(turn, [&](const Impact& impact, const ImpactPlace& place) {
    if (place == wanted) found = impact.speed;
    return found.has_value();
  });
  return found;
}

/// A speed, as a distance [rad/s] from the end of the search, over the phase.
struct Place {
  Place(double at_phase, double at_distance) : phase(at_phase), distance(at_distance) {}
  double phase, distance;
};

class Tip {
 public:
  Tip(const DisturbedMotion& motion, int rank, Extreme extreme, double until)
      : motion_(motion),
        rank_(rank),
        extreme_(extreme),
        until_(until),
        toward_(motion.omega() > until ? 1 : -1),
        width_(std::abs(motion.omega() - until)) {}

  std::optional<PhaseTip> from(double phase) {
    if (!(height({phase, width_}) < 0)) return std::nullopt;
    if (const std::optional<PhaseTip> tip = smooth_tip(phase)) return tip;
    return followed_tip(phase);
  }

 private:
  /// The tip where margins are smooth in speed and phase, by Newton's method on their differences:
  /// that of one impact is extreme, or those of two impacts are 0, which change places there.
  std::optional<PhaseTip> smooth_tip(double phase) const {
    Eigen::Vector2d at(width_ / 2, phase);
    Eigen::Vector2d reach(width_ / 2, first_reach_of_tip);
    std::optional<ImpactPlace> one;
    std::optional<ImpactPlace> other;
    for (int k = 0; k < tip_newton_steps; ++k) {
      std::vector<Scene> scenes;
      for (const auto& [i, j] : stencil) {
        scenes.push_back(machine_at(motion_, speed(at[0] + i * reach[0]), at[1] + j * reach[1]));
      }
      const std::vector<DisturbedTurn> turns = turns_of(scenes, motion_.turns_before);
      for (std::size_t i = 0; i < turns.size() && !other; ++i) {
        const std::optional<ImpactPlace> here = place_of_rank(turns[i], rank_);
        if (!here) return std::nullopt;
        if (i == 0) one = here;
        if (!(*here == *one)) other = here;
      }
      const std::optional<Differences> first = differences(turns, *one, reach);
      if (!first) return std::nullopt;
      Eigen::Vector2d step;
      double drift = -first->twist / first->bend;
      bool is_extreme = true;
      if (other) {
        const std::optional<Differences> second = differences(turns, *other, reach);
        if (!second) return std::nullopt;
        Eigen::Matrix2d jacobian;
        jacobian << first->slope, first->drift, second->slope, second->drift;
        step = -jacobian.inverse() * Eigen::Vector2d(first->value, second->value);
        drift = -(first->slope / first->drift + second->slope / second->drift) / 2;
      } else {
        is_extreme = (first->bend > 0) == (extreme_ == Extreme::least);
        step = first->to_extreme();
        if (!is_extreme || std::abs(step[1]) > longest_shift) {
          // Downhill, as far as another impact comes in.
          const double uphill = first->drift * sign_of(extreme_);
          step[1] = uphill > 0 ? -longest_shift : longest_shift;
          step[0] = -(first->value + first->drift * step[1]) / first->slope;
          is_extreme = false;
        }
      }
      if (!step.allFinite()) return std::nullopt;
      at += step;
      if (!(at[0] > 0 && at[0] < width_ && std::abs(at[1] - phase) < farthest_tip))
        return std::nullopt;
      // The next step would be about the square of this one.
      if (is_extreme && std::abs(step[0]) < 1e-9 * until_ && std::abs(step[1]) < 1e-3) {
        if (lower_beside({at[1], at[0]})) return std::nullopt;
        return PhaseTip{speed(at[0]), at[1], drift * toward_, true};
      }
      if (!is_extreme) continue;
      reach[0] = std::clamp(2 * std::abs(step[0]), 1e-5 * until_, 0.2 * reach[0]);
      reach[1] = std::clamp(2 * std::abs(step[1]), 1e-3, std::max(1e-3, 0.2 * reach[1]));
    }
    return std::nullopt;
  }

  /// A place a little nearer to the end, at a phase next to that of a tip, that is beyond.
  std::optional<Place> lower_beside(const Place& tip) const {
    std::vector<Place> places;
    std::vector<Scene> scenes;
    for (const double drop : {1e-6 * until_, 1e-9 * until_}) {
      if (drop > tip.distance) continue;
      for (double aside = 1e-7; aside < farthest_beside; aside *= 4) {
        for (const double side : {-aside, aside}) {
          const Place& place = places.emplace_back(tip.phase + side, tip.distance - drop);
          scenes.push_back(machine_at(motion_, speed(place.distance), place.phase));
        }
      }
    }
    if (places.empty()) return std::nullopt;
    const std::vector<DisturbedTurn> turns = turns_of(scenes, motion_.turns_before);
    for (std::size_t i = 0; i < turns.size(); ++i) {
      if (is_beyond(extreme_, margin_of(motion_.machine, turns[i], rank_))) return places[i];
    }
    return std::nullopt;
  }

  /// The margin of an impact at the middle of the stencil, and its derivatives.
  struct Differences {
    double value;
    double slope, drift;        // over the distance, over the phase
    double curve, bend, twist;  // twice over the distance, over the phase, over both

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
                                         const ImpactPlace& place,
                                         const Eigen::Vector2d& reach) const {
    std::array<double, stencil.size()> f;
    for (std::size_t i = 0; i < f.size(); ++i) {
      const std::optional<double> speed = speed_at_place(turns[i], place);
      if (!speed) return std::nullopt;
      f[i] = std::log(*speed / motion_.machine.counting_limit);
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

  double speed(double distance) const { return until_ + toward_ * distance; }

  /// < 0 in a turn that is beyond.
  double height(const Place& at) const {
    const double omega = speed(at.distance);
    const Scene machine = machine_at(motion_, omega, at.phase);
    const DisturbedTurn turn = turns_of({&machine, 1}, motion_.turns_before).front();
    const double margin = margin_of(machine, turn, rank_);
    const double size = std::max(std::abs(margin), std::numeric_limits<double>::min());
    return is_beyond(extreme_, margin) ? -size : size;
  }

  bool is_in(const Place& at) const { return height(at) < 0; }

  /// The tip by going down along the middles of the phases that are beyond, which may be few and
  /// drift with the speed. Nothing if that takes too many rounds.
  std::optional<PhaseTip> followed_tip(double phase) const {
    Place middle = middle_of({phase, width_});
    double drift = 0;  // of the middle over the distance
    double last_drift = 0;
    double step = first_step * width_;
    int flat = 0;  // rounds without a drop
    for (int k = 0; k < most_rounds; ++k) {
      const Place low = lowest_along(middle, drift, step);
      if (low.distance == 0) return PhaseTip{until_, low.phase, drift * toward_, false};
      const double drop = middle.distance - low.distance;
      flat = drop < sharp * until_ ? flat + 1 : 0;
      if (flat == 2) {
        const std::optional<Place> lower = lower_beside(low);
        if (!lower) return PhaseTip{speed(low.distance), low.phase, last_drift * toward_, true};
        middle = middle_of(*lower);
        drift = (middle.phase - low.phase) / (middle.distance - low.distance);
        flat = 0;
        continue;
      }
      const Place next = middle_of(low);
      if (drop > 0)
        last_drift = drift = (next.phase - middle.phase) / -drop;
      else
        drift = 0;
      step = std::max(drop / 2, sharp * until_);
      middle = next;
    }
    return std::nullopt;
  }

  /// The last place that is beyond on a line down from one that is; its first step is a guess.
  Place lowest_along(const Place& from, double drift, double step) const {
    const auto at = [&](double distance) {
      return Place{from.phase + drift * (distance - from.distance), distance};
    };
    double in = from.distance;
    double out = std::max(0.0, in - step);
    double height_in = height(from);
    double height_out = height(at(out));
    while (height_out < 0) {
      if (out == 0) return at(0);
      step *= 2;
      in = out;
      height_in = height_out;
      out = std::max(0.0, out - step);
      height_out = height(at(out));
    }
    const double tolerance = std::max(1e-6 * (in - out), sharp * until_ / 4);
    bool may_pass = true;
    while (in - out > tolerance) {
      if (may_pass && height_out < small_margin && height_in > -small_margin) {
        may_pass = false;
        std::tie(out, in) = bracketed_root(
            [&](double there) { return height(at(there)); }, out, in, height_out, height_in,
            [&](double a, double b) { return std::abs(b - a) <= tolerance; }, 12);
        if (!is_in(at(in))) break;
        continue;
      }
      const double half = 0.5 * (in + out);
      if (half == in || half == out) break;
      const double there = height(at(half));
      (there < 0 ? in : out) = half;
      (there < 0 ? height_in : height_out) = there;
    }
    return at(in);
  }

  /// The middle of the phases around a place that are beyond, at its distance.
  Place middle_of(const Place& inside) const {
    double ends[2];
    for (const int side : {0, 1}) {
      const double away = side == 0 ? -1 : 1;
      const auto at = [&](double reach) {
        return Place{inside.phase + away * reach, inside.distance};
      };
      double in = 0;
      double out = narrowest;
      while (out < farthest_tip && is_in(at(out))) {
        in = out;
        out *= 4;
      }
      while (out - in > 1e-2 * out && out > narrowest) {
        const double half = 0.5 * (in + out);
        (is_in(at(half)) ? in : out) = half;
      }
      ends[side] = away * in;
    }
    const Place middle{inside.phase + 0.5 * (ends[0] + ends[1]), inside.distance};
    return is_in(middle) ? middle : inside;
  }

  const DisturbedMotion& motion_;
  int rank_;
  Extreme extreme_;
  double until_, toward_, width_;
};

}  // namespace

std::optional<PhaseTip> phase_tip(const DisturbedMotion& motion, int rank, Extreme extreme,
                                  double phase, double until) {
  return Tip(motion, rank, extreme, until).from(phase);
}

}  // namespace ricochet::carrier_track::inline regimes
