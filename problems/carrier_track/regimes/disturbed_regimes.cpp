#include "problems/carrier_track/regimes/disturbed_regimes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/phase_tip.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "src/core/bracketed_root.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

bool same_kind(const DisturbedMotion& a, const DisturbedMotion& b) {
  return a.moves == b.moves && a.settled == b.settled;
}

/// The phases at which a motion has its fewest and its most collisions.
std::vector<double> extreme_phases(const DisturbedMotion& motion) {
  if (motion.turns.empty()) return {};
  return {extreme_turn(motion, motion.least + 1, Extreme::least).phase,
          extreme_turn(motion, motion.most, Extreme::most).phase};
}

/// Where the turns begin or end in which the rank-th fastest impact counts (of the most), or does
/// not (of the least).
struct Change {
  double omega;
  Extreme extreme;
  int rank;
  bool begins;
  RegimeEnd kind;
  LongRun at;
};

/// A range of speeds in which the motion is of one kind.
class Stretch {
 public:
  Stretch(DisturbedMotion first, double from)
      : from_(from), first_least_(first.least), first_most_(first.most) {
    first_ = long_run_of(first);
    samples_.push_back(std::move(first));
  }

  const DisturbedMotion& last() const { return samples_.back(); }

  /// Up to which speed the borders are known.
  double covered() const { return solves() ? samples_[solved_].omega() : samples_.back().omega(); }

  /// Whether a turn up to there has more collisions.
  bool exceeds(double at_most) const {
    return std::any_of(samples_.begin(), samples_.begin() + 1 + solved_,
                       [&](const auto& motion) { return motion.most > at_most; });
  }

  /// Takes the motion at the next speed.
  void take(DisturbedMotion motion) {
    samples_.push_back(std::move(motion));
    solve(1);
  }

  /// The regimes, after the last motion.
  std::vector<Regime> ended(double to, RegimeEnd kind) {
    solve(0);
    return regimes(to, kind, long_run_of(last()));
  }

  /// The regimes as far as they are known.
  std::vector<Regime> cut() const {
    LongRun last = first_;
    for (const Change& change : changes_) {
      if (change.omega <= covered() && change.omega > last.orbit.omega) last = change.at;
    }
    std::vector<Regime> known = regimes(covered(), RegimeEnd::time_limit, last);
    for (Regime& regime : known) regime.certain = false;
    return known;
  }

 private:
  static constexpr double shortest_step = 1e-3;       // of the logarithm of the speed
  static constexpr double lowest = -1.5;              // margins that are lower are alike
  static constexpr double beside = 3e-9;              // relative, where a border is looked at
  static constexpr double grazing_resolution = 1e-8;  // relative, as border_resolution
  static constexpr double look_ahead = 1e-3;          // relative
  static constexpr int most_tips = 8;                 // that are tried, of other phases

  bool solves() const { return samples_[0].moves && samples_[0].settled; }

  /// Finds the borders between the motions, but for the last `left` steps.
  void solve(std::size_t left) {
    while (solved_ + 1 + left < samples_.size()) {
      const std::size_t k = solved_;
      if (solves() && may_hide(k)) {
        const double middle = std::sqrt(samples_[k].omega() * samples_[k + 1].omega());
        DisturbedMotion between = motion_at(middle, extreme_phases(samples_[k]));
        if (same_kind(between, samples_[k])) {
          samples_.insert(samples_.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                          std::move(between));
          continue;
        }
        samples_[k].resolved = false;
      }
      if (solves()) find_changes(k);
      ++solved_;
    }
  }

  DisturbedMotion motion_at(double omega, const std::vector<double>& also) const {
    return disturbed_motion(at_speed(samples_[0].machine, omega), also);
  }

  /// Whether a margin that has one sign at two neighbours may have the other between them: if the
  /// lines through both and their other neighbours meet beyond 0, or pass it.
  bool may_hide(std::size_t k) const {
    const DisturbedMotion& a = samples_[k];
    const DisturbedMotion& b = samples_[k + 1];
    if (std::log(b.omega() / a.omega()) <= shortest_step) return false;
    return passes(k, std::max(a.most, b.most) + 1, Extreme::most, 1) ||
           passes(k, std::min(a.most, b.most), Extreme::most, -1) ||
           passes(k, std::max(a.least, b.least) + 1, Extreme::least, 1) ||
           passes(k, std::min(a.least, b.least), Extreme::least, -1);
  }

  bool passes(std::size_t k, int rank, Extreme extreme, double sign) const {
    if (rank == 0) return false;
    const auto at = [&](std::size_t i) {
      const DisturbedMotion& motion = samples_[i];
      const double margin = extreme_turn(motion, rank, extreme).margin(rank);
      return std::array{std::log(motion.omega()), sign * std::max(margin, lowest)};
    };
    const auto [x1, y1] = at(k);
    const auto [x2, y2] = at(k + 1);
    const auto slope_to = [&](std::size_t i, double x, double y) {
      const auto [there, value] = at(i);
      return (value - y) / (there - x);
    };
    const double rise = k == 0 ? 0 : slope_to(k - 1, x1, y1);
    const double fall = k + 2 == samples_.size() ? 0 : slope_to(k + 2, x2, y2);
    // One line alone may pass 0, and the margin jump where an impact vanishes.
    const double alone = std::max(y1 + rise * (x2 - x1), y2 + fall * (x1 - x2));
    if (rise <= 0 || fall >= 0) return alone > 0;
    const double meet = std::clamp((y2 - y1 + rise * x1 - fall * x2) / (rise - fall), x1, x2);
    return std::max(y1 + rise * (meet - x1), y2 + fall * (meet - x2)) > 0;
  }

  void find_changes(std::size_t k) {
    const auto [least, most] = std::pair(samples_[k].least, samples_[k].most);
    const auto [later_least, later_most] = std::pair(samples_[k + 1].least, samples_[k + 1].most);
    for (int rank = later_most; rank > most; --rank) find_begin(k + 1, rank, Extreme::most);
    for (int rank = later_least + 1; rank <= least; ++rank) find_begin(k + 1, rank, Extreme::least);
    for (int rank = most; rank > later_most; --rank) find_end(k, rank, Extreme::most);
    for (int rank = least + 1; rank <= later_least; ++rank) find_end(k, rank, Extreme::least);
  }

  /// Finds where such turns begin that a motion has: before the one before, if that has them
  /// unseen.
  void find_begin(std::size_t inside, int rank, Extreme extreme) {
    while (inside > 0) {
      const std::size_t outside = inside - 1;
      if (!has_beyond(samples_[outside], rank, extreme) &&
          find_change(inside, outside, rank, extreme)) {
        return;
      }
      inside = outside;
    }
    changes_.push_back({from_, extreme, rank, true, RegimeEnd::grazing, first_});
  }

  /// Finds where such turns end that a motion has, unless the next one has them unseen.
  void find_end(std::size_t inside, int rank, Extreme extreme) {
    if (!has_beyond(samples_[inside + 1], rank, extreme)) {
      find_change(inside, inside + 1, rank, extreme);
    }
  }

  /// False if the motion outside has such turns, too, which it knows then.
  bool find_change(std::size_t inside, std::size_t outside, int rank, Extreme extreme) {
    DisturbedMotion in = samples_[inside];
    DisturbedMotion& out = samples_[outside];
    const double away = outside < inside ? -beside : beside;
    PhaseTip tip{};
    for (int tries = 0; tries < most_tips; ++tries) {
      const double last = tip.omega;
      if (out.turns_before > in.turns_before) {  // what erases the start there does so here, too
        in.turns_before = out.turns_before;
        in.machine.start_position = out.machine.start_position;
      }
      tip = phase_tip(in, out, rank, extreme);
      if (!tip.is_reached) {
        DisturbedMotion again = motion_at(out.omega(), {tip.phase});
        if (same_kind(again, out)) out = std::move(again);
        if (has_beyond(out, rank, extreme)) return false;
        out.resolved = false;
        tip.omega = out.omega();
      }
      DisturbedMotion end = motion_at(tip.omega * (1 + away), {tip.phase});
      if (end.moves && !end.settled) out.resolved = false;
      const bool goes_on = same_kind(end, in) && has_beyond(end, rank, extreme) &&
                           (out.omega() - end.omega()) * away > 0;
      in = std::move(end);
      if (!goes_on || std::abs(tip.omega - last) <= 3 * beside * last) break;
    }
    add_change(tip, extreme, rank, outside < inside, in);
    if (outside < inside) return true;
    // Such turns may begin again next to where they end.
    const DisturbedMotion again = motion_at(tip.omega * (1 + look_ahead), {tip.phase});
    if (again.omega() >= out.omega() || !same_kind(again, in)) return true;
    if (!has_beyond(again, rank, extreme) || has_beyond(in, rank, extreme)) return true;
    const PhaseTip begin = phase_tip(again, in, rank, extreme);
    const PhaseTip end = phase_tip(again, out, rank, extreme);
    if (!begin.is_reached || !end.is_reached) {
      out.resolved = false;
      return true;
    }
    add_change(begin, extreme, rank, true, again);
    add_change(end, extreme, rank, false, again);
    return true;
  }

  void add_change(const PhaseTip& tip, Extreme extreme, int rank, bool begins,
                  const DisturbedMotion& beside_it) {
    LongRun at = long_run_of(beside_it);
    at.orbit = at_speed(at.orbit, tip.omega);
    changes_.push_back({tip.omega, extreme, rank, begins,
                        tip.is_smooth ? RegimeEnd::counting_limit : RegimeEnd::grazing,
                        std::move(at)});
  }

  Regime regime_from(double from, const LongRun& first) const {
    Regime regime{};
    regime.from = from;
    regime.first = first;
    regime.turns = samples_[0].settled ? 1 : 0;
    regime.moves = samples_[0].moves;
    regime.rests = regime.moves && samples_[0].settled;
    return regime;
  }

  void close(Regime& regime, double to, RegimeEnd kind, const LongRun& last) const {
    regime.to = to;
    regime.ends_by = kind;
    regime.last = last;
    regime.collisions_per_turn = (regime.first.collisions_per_turn + last.collisions_per_turn) / 2;
    regime.certain = samples_[0].settled;
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      const double slower = samples_[k == 0 ? 0 : k - 1].omega();
      const double faster = samples_[std::min(k + 1, samples_.size() - 1)].omega();
      if (!samples_[k].resolved && slower < to && faster > regime.from) regime.certain = false;
    }
  }

  /// Of the changes up to a speed.
  std::vector<Regime> regimes(double to, RegimeEnd kind, const LongRun& last) const {
    std::map<int, int> most;   // how many ranges of speeds there are in which a rank counts
    std::map<int, int> least;  // the same in which one does not
    int ranks = 0;
    for (const DisturbedMotion& motion : samples_) ranks = std::max(ranks, motion.most);
    for (int rank = 1; rank <= ranks; ++rank) {
      most[rank] = first_most_ >= rank ? 1 : 0;
      least[rank] = first_least_ < rank ? 1 : 0;
    }
    std::vector<Change> changes = changes_;
    std::stable_sort(changes.begin(), changes.end(),
                     [](const Change& a, const Change& b) { return a.omega < b.omega; });
    std::vector<Regime> found = {regime_from(from_, first_)};
    const auto take_counts = [&] {
      Regime& regime = found.back();
      if (!solves()) {
        regime.least_per_turn = samples_[0].least;
        for (const DisturbedMotion& motion : samples_) {
          regime.least_per_turn = std::min<double>(regime.least_per_turn, motion.least);
          regime.most_per_turn = std::max<double>(regime.most_per_turn, motion.most);
        }
        return;
      }
      regime.most_per_turn = 0;
      for (const auto& [rank, count] : most) {
        if (count > 0) regime.most_per_turn = rank;
      }
      regime.least_per_turn = regime.most_per_turn;
      for (const auto& [rank, count] : least) {
        if (count > 0) regime.least_per_turn = std::min<double>(regime.least_per_turn, rank - 1);
      }
    };
    take_counts();
    for (const Change& change : changes) {
      const double resolution =
          change.kind == RegimeEnd::grazing ? grazing_resolution : border_resolution;
      if (change.omega >= to * (1 - border_resolution)) break;
      if (change.omega > found.back().from * (1 + resolution)) {
        close(found.back(), change.omega, change.kind, change.at);
        found.push_back(regime_from(change.omega, change.at));
      }
      (change.extreme == Extreme::most ? most : least)[change.rank] += change.begins ? 1 : -1;
      take_counts();
      const Regime& here = found.back();
      if (found.size() > 1 && found.end()[-2].least_per_turn == here.least_per_turn &&
          found.end()[-2].most_per_turn == here.most_per_turn) {
        found.pop_back();
      }
    }
    close(found.back(), to, kind, last);
    return found;
  }

  double from_;
  int first_least_, first_most_;  // as first seen: what is found there later is a change
  LongRun first_;
  std::vector<DisturbedMotion> samples_;
  std::size_t solved_ = 0;  // the borders up to this sample are known
  std::vector<Change> changes_;
};

/// The border between motions of two kinds, and the motions on its sides.
struct KindBorder {
  double omega;
  RegimeEnd kind;
  DisturbedMotion before, after;
};

KindBorder kind_border(DisturbedMotion before, DisturbedMotion after) {
  constexpr double narrow = 1e-13;        // relative
  constexpr double blurred = 1e-4;        // relative, of borders beside motions that do not settle
  constexpr double just_released = 1e-4;  // relative, where a new motion is large enough to be seen
  if (before.moves != after.moves) {
    const DisturbedMotion& still = before.moves ? after : before;
    const auto margin = [&](double omega) {
      return release_margin(at_speed(still.machine, omega), still.machine.start_position);
    };
    const double low = before.omega(), high = after.omega();
    const auto [a, b] =
        bracketed_root(margin, low, high, margin(low), margin(high),
                       [](double x, double y) { return std::abs(y - x) <= narrow * y; });
    const double omega = (a + b) / 2;
    if (b - a <= narrow * b) {
      const auto beside = [&](double by) {
        return disturbed_motion(at_speed(still.machine, omega * (1 + by)));
      };
      const double away = before.moves ? -1 : 1;  // where the carrier moves
      DisturbedMotion moving = beside(away * just_released);
      // Next to the border the motion may be so slow that no impact counts.
      for (double by = just_released / 8; by > 1e-9 && moving.most > 0; by /= 8) {
        DisturbedMotion nearer = beside(away * by);
        if (nearer.settled && nearer.moves && nearer.most == 0) moving = std::move(nearer);
      }
      DisturbedMotion held = beside(-away * narrow);
      if (before.moves) std::swap(moving, held);
      return {omega, RegimeEnd::release, std::move(held), std::move(moving)};
    }
  }
  while (after.omega() - before.omega() > blurred * after.omega()) {
    DisturbedMotion middle =
        disturbed_motion(at_speed(before.machine, (before.omega() + after.omega()) / 2));
    (same_kind(middle, before) ? before : after) = std::move(middle);
  }
  const RegimeEnd kind = before.moves != after.moves ? RegimeEnd::release : RegimeEnd::irregular;
  const double known = before.settled ? before.omega() : after.omega();
  return {known, kind, std::move(before), std::move(after)};
}

}  // namespace

std::vector<Regime> disturbed_regimes(const Scene& scene, const RegimeOptions& options,
                                      double at_most) {
  // Steps of the logarithm of the speed.
  constexpr double first_step = 1e-3;  // where another kind of motion begins
  constexpr double longest_step = 0.03;
  constexpr double longest_mixed_step = 0.01;
  constexpr double irregular_step = 0.02;  // where the motion does not settle
  std::vector<Regime> found;
  std::optional<Stretch> stretch;
  const auto keep = [&](std::vector<Regime> more) {
    found.insert(found.end(), more.begin(), more.end());
  };
  try {
    stretch.emplace(disturbed_motion(at_speed(scene, options.from)), options.from);
    double step = first_step;
    while (stretch->last().omega() < options.to && !stretch->exceeds(at_most)) {
      const DisturbedMotion& here = stretch->last();
      report_progress("regimes",
                      std::log(here.omega() / options.from) / std::log(options.to / options.from));
      const double length = here.settled ? step : irregular_step;
      double omega = here.omega() * std::exp(length);
      if (omega > options.to * (1 - 1e-6)) omega = options.to;
      DisturbedMotion next = disturbed_motion(at_speed(here.machine, omega), extreme_phases(here));
      // Where phases count differently, turns that few have come and go.
      step = std::min(2 * step, next.least == next.most ? longest_step : longest_mixed_step);
      if (same_kind(here, next)) {
        stretch->take(std::move(next));
        continue;
      }
      KindBorder border = kind_border(here, std::move(next));
      if (border.before.omega() > here.omega() && same_kind(border.before, here)) {
        stretch->take(std::move(border.before));
      }
      keep(stretch->ended(border.omega, border.kind));
      stretch.emplace(std::move(border.after), border.omega);
      step = first_step;
    }
    keep(stretch->ended(stretch->last().omega(), RegimeEnd::range));
  } catch (const TimeLimitReached&) {
    if (!stretch) throw;
    keep(stretch->cut());
    for (Regime& regime : found) regime.certain = false;
  }
  const auto louder = std::find_if(found.begin(), found.end(), [&](const Regime& regime) {
    return regime.most_per_turn > at_most;
  });
  if (louder != found.end()) found.erase(louder + 1, found.end());
  return found;
}

}  // namespace ricochet::carrier_track::inline regimes
