#include "problems/carrier_track/regimes/phase_tip.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr double sharp = 1e-13;       // relative width at which a bracket of speeds is a border
constexpr double small_margin = 0.2;  // margins so small on both sides of a border may pass 0
constexpr double first_reach = 0.05;  // [rad], to both sides, of the first three phases
constexpr double last_reach = 1e-6;   // the nearest three
constexpr double nearer = 1.0 / 16;   // the next reach
constexpr double off_shape = 0.1;  // of a parabola or two lines: how far a speed may be off theirs
constexpr int most_rounds = 100;

/// Places of speed and phase from which a quadratic dependence is known.
constexpr std::array<std::array<int, 2>, 7> stencil = {
    {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}}};

constexpr int newton_steps = 10;
constexpr double longest_shift = 0.1;  // [rad]
constexpr double farthest = 0.5;       // [rad], from the first phase

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
    Place lowest = edge(phase, width_ / 2, width_ / 2, 1e-3 * width_);
    double reach = first_reach;
    for (int k = 0; k < most_rounds && reach > last_reach && lowest.distance > 0; ++k) {
      const double tolerance = std::max(1e-4 * reach * reach, sharp) * until_;
      const auto near = [&](double there) {
        return edge(there, lowest.distance, 30 * tolerance, tolerance);
      };
      const Place centre = near(lowest.phase);
      const Place left = near(centre.phase - reach);
      const Place right = near(centre.phase + reach);
      if (std::min(left.distance, right.distance) < centre.distance - tolerance) {
        lowest = left.distance < right.distance ? left : right;
        reach = std::min(2 * reach, first_reach);
        continue;
      }
      if (std::max(left.distance, right.distance) >= width_) {  // too far aside
        lowest = centre;
        reach *= nearer;
        continue;
      }
      const double bend = left.distance - 2 * centre.distance + right.distance;
      if (!(bend > tolerance)) break;  // flat
      const double shift = (left.distance - right.distance) / (2 * bend);
      const double drop = bend * shift * shift / 2;
      const Place vertex = near(centre.phase + reach * shift);
      lowest = lower(centre, vertex);
      if (std::abs(vertex.distance - (centre.distance - drop)) < off_shape * bend) {
        if (drop < sharp * until_) break;
      } else {
        // Two edges meet: where lines through two places on each do.
        const double beside = reach / 8;
        const Place more_left = near(left.phase + beside);
        const Place more_right = near(right.phase - beside);
        const double fall = (left.distance - more_left.distance) / beside;
        const double rise = (right.distance - more_right.distance) / beside;
        if (fall + rise > 0) {
          const double meet =
              (left.distance - right.distance + 2 * reach * rise) / (fall + rise) - reach;
          if (std::abs(meet) < reach) lowest = lower(lowest, near(centre.phase + meet));
        }
      }
      reach *= nearer;
    }
    if (lowest.distance > 0) {
      lowest = edge(lowest.phase, lowest.distance, 10 * sharp * until_, sharp * until_);
    }
    return PhaseTip{speed(lowest.distance), lowest.phase, lowest.distance > 0};
  }

 private:
  /// The tip where margins are smooth in speed and phase, by Newton's method on their differences:
  /// that of one impact is extreme, or those of two impacts are 0, which change places there.
  std::optional<PhaseTip> smooth_tip(double phase) const {
    Eigen::Vector2d at(width_ / 2, phase);
    Eigen::Vector2d reach(width_ / 2, first_reach);
    std::optional<ImpactPlace> one;
    std::optional<ImpactPlace> other;
    for (int k = 0; k < newton_steps; ++k) {
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
          // Downhill, as far as another impact comes in.
          const double uphill = first->drift * sign_of(extreme_);
          step[1] = uphill > 0 ? -longest_shift : longest_shift;
          step[0] = -(first->value + first->drift * step[1]) / first->slope;
          is_extreme = false;
        }
      }
      if (!step.allFinite()) return std::nullopt;
      at += step;
      if (!(at[0] > 0 && at[0] < width_ && std::abs(at[1] - phase) < farthest)) return std::nullopt;
      // The next step would be about the square of this one.
      if (is_extreme && std::abs(step[0]) < 1e-9 * until_ && std::abs(step[1]) < 1e-3) {
        if (!is_lowest(at)) return std::nullopt;
        return PhaseTip{speed(at[0]), at[1], true};
      }
      if (!is_extreme) continue;
      reach[0] = std::clamp(2 * std::abs(step[0]), 1e-5 * until_, 0.2 * reach[0]);
      reach[1] = std::clamp(2 * std::abs(step[1]), 1e-3, std::max(1e-3, 0.2 * reach[1]));
    }
    return std::nullopt;
  }

  /// Whether no turns next to that distance and phase are beyond a little nearer to the end.
  bool is_lowest(const Eigen::Vector2d& at) const {
    std::vector<Scene> scenes;
    for (const double aside : {-1e-3, -1e-5, 1e-5, 1e-3}) {
      scenes.push_back(machine_at(motion_, speed(at[0] - 1e-9 * until_), at[1] + aside));
    }
    const std::vector<DisturbedTurn> turns = turns_of(scenes, motion_.turns_before);
    return std::none_of(turns.begin(), turns.end(), [&](const DisturbedTurn& turn) {
      return is_beyond(extreme_, margin_of(motion_.machine, turn, rank_));
    });
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

  static const Place& lower(const Place& a, const Place& b) {
    return b.distance < a.distance ? b : a;
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

  /// Where the turns at a phase begin to be beyond, near a guess; 0 if they are from the end of the
  /// search on, the width of the search if they are not at its start.
  Place edge(double phase, double guess, double around, double tolerance) const {
    double low = std::max(0.0, guess - around);
    double high = std::min(width_, guess + around);
    double at_low = height({phase, low});
    double step = around;
    while (at_low < 0) {
      if (low == 0) return {phase, 0};
      high = low;
      step *= 8;
      low = std::max(0.0, low - step);
      at_low = height({phase, low});
    }
    double at_high = height({phase, high});
    step = around;
    while (at_high > 0) {
      if (high == width_) return {phase, width_};
      low = high;
      at_low = at_high;
      step *= 8;
      high = std::min(width_, high + step);
      at_high = height({phase, high});
    }
    bool may_pass = true;
    while (high - low > tolerance) {
      if (may_pass && at_low < small_margin && at_high > -small_margin) {
        may_pass = false;
        std::uintmax_t evaluations = 12;
        std::tie(low, high) = boost::math::tools::toms748_solve(
            [&](double there) {
              return height({phase, there});
            },
            low, high, at_low, at_high,
            [&](double a, double b) { return std::abs(b - a) <= tolerance; }, evaluations);
        continue;
      }
      const double middle = 0.5 * (low + high);
      if (middle == low || middle == high) break;
      const double there = height({phase, middle});
      (there < 0 ? high : low) = middle;
      (there < 0 ? at_high : at_low) = there;
    }
    return {phase, 0.5 * (low + high)};
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
