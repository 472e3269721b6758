#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "src/core/time_limit.h"

/// What a walk from border to border does in another way for motions that repeat than for those
/// under a disturbance. Steps are in the logarithm of the speed.
namespace ricochet::carrier_track::inline regimes {

/// The largest modulus of the eigenvalues of a period.
inline double memory_of(const SteadyMotion& motion) {
  const double half = motion.trace / 2;
  const double square = half * half - motion.determinant;
  return square >= 0 ? std::abs(half) + std::sqrt(square) : std::sqrt(motion.determinant);
}
inline double memory_of(const DisturbedMotion& /*motion*/) {
  return 0;
}

/// Whether several motions may be possible at one speed: then the way to a border is looked at,
/// too.
inline bool may_have_others(const SteadyMotion& /*motion*/) {
  return true;
}
inline bool may_have_others(const DisturbedMotion& /*motion*/) {
  return false;
}

/// The longest step between motions with different impacts: one that appears may make others
/// slower, and two that were just about to count vanish between the ends of the step.
inline double unlike_step_of(const SteadyMotion& /*motion*/) {
  return 1e-5;
}
inline double unlike_step_of(const DisturbedMotion& /*motion*/) {
  return 1e-3;
}

/// The longest step: an impact may come and go within a longer one.
inline double longest_of(const SteadyMotion& /*motion*/) {
  return 0.02;
}
inline double longest_of(const DisturbedMotion& /*motion*/) {
  return 0.03;
}

/// The longest first step after a border: what ends there under a disturbance may begin again.
inline double longest_first_of(const SteadyMotion& /*motion*/) {
  return 0.01;
}
inline double longest_first_of(const DisturbedMotion& /*motion*/) {
  return 1e-3;
}

inline double shortest_of(const SteadyMotion& /*motion*/) {
  return 1e-7;
}
inline double shortest_of(const DisturbedMotion& /*motion*/) {
  return 1e-3;  // margins have no exact slopes there
}

/// The long run beyond a border with this long run before it.
inline LongRun long_run_beyond(const LongRun& /*before*/, RegimeEnd /*kind*/,
                               const SteadyMotion& motion) {
  return long_run_of(motion);
}
inline LongRun long_run_beyond(const LongRun& before, RegimeEnd kind,
                               const DisturbedMotion& motion) {
  // Where one impact passes the limit at one phase, no mean changes.
  if (kind != RegimeEnd::counting_limit) return long_run_of(motion);
  LongRun beyond = before;
  beyond.orbit = motion.machine;
  return beyond;
}

/// Takes the collisions of a motion into a regime.
inline void widen(Regime& regime, double least, double most) {
  regime.least_per_turn = std::min(regime.least_per_turn, least);
  regime.most_per_turn = std::max(regime.most_per_turn, most);
}
inline void widen(Regime& regime, const SteadyMotion& motion) {
  widen(regime, motion.collisions_per_turn(), motion.collisions_per_turn());
}
inline void widen(Regime& regime, const DisturbedMotion& motion) {
  widen(regime, motion.least, motion.most);
}

/// Lets a motion watch what another at its speed watches.
inline void join(SteadyMotion& /*motion*/, const SteadyMotion& /*other*/) {}
inline void join(DisturbedMotion& motion, const DisturbedMotion& other) {
  for (const DisturbedTurn& turn : other.watched)
    watch(motion, phase_in(motion, other, turn.phase));
}

namespace {

constexpr double step_after_border = 1e-4;  // at least, after a border
constexpr double rounding = 1e-12;
constexpr double irregular_step = 0.02;  // where the motion does not repeat

/// Whether the motion beyond such a border is another one, which may be far away.
bool is_jump(RegimeEnd kind) {
  return kind == RegimeEnd::grazing || kind == RegimeEnd::irregular ||
         kind == RegimeEnd::end_of_rest || kind == RegimeEnd::start_of_rest;
}

/// Takes the certainty from periodic motions in a narrow range between others that are not certain:
/// there are such ranges of all widths among irregular motions.
void doubt_islands(std::vector<Regime>& regimes) {
  const auto is_certain = [](const Regime& regime) { return regime.certain; };
  const auto end = regimes.end();
  auto first = std::find_if_not(regimes.begin(), end, is_certain);
  while (first != end) {
    first = std::find_if(first, end, is_certain);
    const auto last = std::find_if_not(first, end, is_certain);
    if (last == end) return;
    if (std::log(last->from / first->from) < irregular_step) {
      std::for_each(first, last, [](Regime& regime) { regime.certain = false; });
    }
    first = last;
  }
}

/// Follows a motion from border to border.
template <class Motion>
class Walk {
 public:
  Walk(const Motion& start, double to)
      : here_(start), margins_(margins_of(start)), from_(start.omega()), to_(to), covered_(from_) {}

  /// The regimes, up to the first in which a turn has more than `at_most` collisions.
  std::vector<Regime> regimes(double at_most) {
    try {
      open(here_, here_.omega());
      while (here_.omega() < to_ && !(regimes_.back().most_per_turn > at_most)) {
        report_progress("regimes", std::log(here_.omega() / from_) / std::log(to_ / from_));
        if (!advance()) step_ /= 2;
        covered_ = here_.omega();
      }
      end();
    } catch (const TimeLimitReached&) {
      if (regimes_.empty()) throw;
      cut();
    }
    doubt_islands(regimes_);
    return regimes_;
  }

 private:
  /// Takes a step, to its end or to the border within it; false if it is too long.
  bool advance() {
    const double length =
        std::min(is_certain() ? step_ : irregular_step, std::log(to_ / here_.omega()));
    const double end = length < step_ ? std::min(to_, here_.omega() * std::exp(length))
                                      : here_.omega() * std::exp(length);
    Motion next = followed(here_, end >= to_ * (1 - 1e-15) ? to_ : end);
    const double step = std::log(next.omega() / here_.omega());
    if (!(signature_of(next) == signature_of(here_))) {
      if (step > longest_structured && signature_of(here_).moves) return false;
      const Border<Motion> border = first_border(here_, next);
      // On the way there the motion may change, and change back.
      if (may_have_others(here_) && !reaches(border.before)) return false;
      if (is_passed(border)) return true;
      if (signature_of(border.after) == signature_of(here_)) {  // it moved, to rest elsewhere
        here_ = border.after;
        margins_ = margins_of(here_);
        return true;
      }
      cross(border, next);
      step_ = std::max(step_after_border, std::min(step_, longest_first_of(here_)));
      return true;
    }
    if (!reaches(next)) return false;
    here_ = std::move(next);
    observe(here_);
    margins_ = reached_ ? *std::move(reached_) : margins_of(here_);
    add(here_);
    step_ = std::min(longest_of(here_), 2 * step_);
    return true;
  }

  /// Whether the motion here goes on beyond a jump, which a long step has made into one of several
  /// motions that are possible there. Then it is followed on, some times; after these the regime
  /// is not certain.
  bool is_passed(const Border<Motion>& border) {
    if (!may_have_others(here_) || !is_certain() || !is_jump(border.kind)) return false;
    Motion beyond = followed(border.before, border.omega * (1 + just_beyond_a_jump));
    if (!(signature_of(beyond) == signature_of(here_)) || beyond.omega() >= to_) return false;
    if (++passed_ > most_passed) {
      regimes_.back().certain = false;
      return false;
    }
    here_ = std::move(beyond);
    margins_ = margins_of(here_);
    step_ = step_after_border;
    return true;
  }

  /// Ends the walk at the end of the range, or here if it has met what it looked for.
  void end() {
    if (here_.omega() >= to_ && regimes_.size() > 1 && is_one(to_, regimes_.back().from)) {
      // The last border and the end of the range are one.
      regimes_.pop_back();
      regimes_.back().to = to_;
      regimes_.back().ends_by = RegimeEnd::range;
      return;
    }
    if (here_.omega() < to_) to_ = here_.omega();
    close(here_, to_, RegimeEnd::range);
  }

  /// Ends the walk at the speed up to which it is known, wherever it was interrupted.
  void cut() {
    Regime& last = regimes_.back();
    const bool is_open = last.to == 0;
    if (is_open && here_.omega() == covered_) {
      close(here_, covered_, RegimeEnd::time_limit);
    } else if (is_open) {
      last.to = covered_;
      last.last = last.first;
    }
    last.ends_by = RegimeEnd::time_limit;
    last.certain = false;
    if (may_have_others(here_)) return;
    // The walk might have gone back to any of them.
    for (Regime& regime : regimes_) regime.certain = false;
  }

  /// Goes on beyond a border, which may be before the regime here: what began there was not seen.
  void cross(const Border<Motion>& border, const Motion& next) {
    const bool one_motion = !may_have_others(here_);
    if (!one_motion && is_one(border.omega, regimes_.back().from) &&
        is_one(here_.omega(), regimes_.back().from)) {
      join_borders(border.after);
    } else if (border.omega > (one_motion ? here_.omega() : regimes_.back().from)) {
      close(border.before, border.omega, border.kind);
      open(border.after, border.omega);
    } else if (!one_motion) {
      const Motion before = here_;
      close(before, before.omega(), border.kind);
      open(border.after, before.omega());
    } else if (++returned_ <= most_returned) {
      go_back_to(border);
    } else {
      regimes_.back().certain = false;
      here_ = next;
      margins_ = margins_of(here_);
      add(here_);
    }
  }

  /// Takes back the regime here, which is narrower than borders can be told apart: that at its
  /// start and the next one are one border, beyond which there is the motion `after`.
  void join_borders(const Motion& after) {
    const double from = regimes_.back().from;
    regimes_.pop_back();
    first_.pop_back();
    if (regimes_.empty() || !(signature_of(after) == signature_of(first_.back()))) {
      return open(after, from);
    }
    // An impact came and went: the regime before goes on.
    regimes_.back().to = 0;
    sum_ = regimes_.back().collisions_per_turn;
    added_ = 1;
    here_ = after;
    observe(here_);
    margins_ = margins_of(here_);
    add(here_);
  }

  /// Walks all again that comes after an earlier border.
  void go_back_to(const Border<Motion>& border) {
    if (border.omega == here_.omega()) regimes_.back().certain = false;  // it began before
    Motion after = border.after;
    while (regimes_.size() > 1 && border.omega <= regimes_.back().from * (1 + same_speed)) {
      // What begins at the same speed begins there together.
      if (border.omega >= regimes_.back().from * (1 - same_speed)) join(after, first_.back());
      regimes_.pop_back();
      first_.pop_back();
    }
    if (border.omega > regimes_.back().from) {
      close(border.before, border.omega, border.kind);
      open(after, border.omega);
    } else {
      const double start = regimes_.back().from;
      regimes_.clear();
      first_.clear();
      open(followed(after, start), start);
    }
  }

  /// Whether borders at these speeds are one.
  static bool is_one(double omega, double from) { return omega <= from * (1 + border_resolution); }

  bool is_certain() const { return regimes_.back().certain; }

  /// Whether a motion is surely the one here, followed without a border on the way; if not, and
  /// shorter steps are of no use, the regime is not certain.
  bool reaches(const Motion& there) {
    reached_.reset();
    if (!is_certain() || !signature_of(here_).moves) return true;
    const double step = std::log(there.omega() / here_.omega());
    reached_ = margins_of(there);
    if (step <= rounding || smooth(*reached_, step)) return true;
    if (step > shortest_of(there)) return false;
    regimes_.back().certain = is_near(here_, there);
    return true;
  }

  bool smooth(const Margins& margins, double step) const {
    if (margins.structure != margins_.structure) return step <= unlike_step_of(here_);
    auto before = margins_.known.begin();  // both are in order of series and place
    const auto place_of = [](const Margin& m) { return std::pair(m.series, m.place); };
    for (const Margin& margin : margins.known) {
      while (before != margins_.known.end() && place_of(*before) < place_of(margin)) ++before;
      if (before == margins_.known.end()) break;
      if (place_of(*before) == place_of(margin) && !keeps_sign(*before, margin, step)) return false;
    }
    return true;
  }

  void open(const Motion& first, double from) {
    here_ = first;
    observe(here_);
    margins_ = margins_of(first);
    const Signature signature = signature_of(first);
    Regime regime{};
    regime.from = from;
    regime.first = regimes_.empty()
                       ? long_run_of(first)
                       : long_run_beyond(regimes_.back().last, regimes_.back().ends_by, first);
    regime.least_per_turn = std::numeric_limits<double>::infinity();
    regime.most_per_turn = -regime.least_per_turn;
    regime.turns = signature.turns;
    regime.rests = signature.rests;
    regime.moves = signature.moves;
    regime.certain = signature.settled;
    regimes_.push_back(regime);
    first_.push_back(here_);
    sum_ = 0;
    added_ = 0;
    passed_ = 0;
    add(here_);
  }

  /// Takes another motion into the regime.
  void add(const Motion& motion) {
    widen(regimes_.back(), motion);
    sum_ += collisions_per_turn(motion);
    regimes_.back().collisions_per_turn = sum_ / ++added_;
  }

  void close(const Motion& last, double to, RegimeEnd kind) {
    Regime& regime = regimes_.back();
    regime.to = to;
    regime.last = long_run_of(last);
    regime.ends_by = kind;
    regime.memory = memory_of(last);
    // Between jumps so near to each other, motions may hide that no step meets.
    const RegimeEnd start = regimes_.size() > 1 ? regimes_.end()[-2].ends_by : RegimeEnd::range;
    const bool jumps = is_jump(kind) || is_jump(start);
    if (jumps && std::log(to / regime.from) < step_after_border) regime.certain = false;
  }

  static constexpr double longest_structured = 0.02;
  static constexpr double just_beyond_a_jump = 1e-9;  // relative
  static constexpr int most_passed = 20;
  static constexpr double same_speed = 1e-9;  // relative, of two borders
  static constexpr int most_returned = 1000;

  Motion here_;
  Margins margins_;
  std::optional<Margins> reached_;  // of the motion that reaches() was last asked for
  double from_, to_;
  double covered_;  // the regimes are known up to here
  double step_ = 0.01;
  double sum_ = 0;  // of the regime's collisions per turn
  int added_ = 0;
  int returned_ = 0;  // times that the walk went back to an earlier border
  int passed_ = 0;    // jumps in the regime beyond which its motion goes on
  std::vector<Regime> regimes_;
  std::vector<Motion> first_;  // of each regime
};

}  // namespace

bool has_regimes(const Scene& scene) {
  return scene.rule == CountRule::impacts && scene.profile.empty() &&
         (scene.fidelity == Fidelity::impact || scene.fidelity == Fidelity::automatic);
}

void check_regimes_exist(const Scene& scene, const std::string& origin) {
  if (scene.rule != CountRule::impacts) {
    throw InputError(origin + ": count.rule: must be \"impacts\": regimes are told by impacts");
  }
  if (scene.fidelity != Fidelity::impact && scene.fidelity != Fidelity::automatic) {
    throw InputError(origin +
                     ": model.fidelity: must be \"impact\" or \"auto\": only between hard "
                     "walls in one direction is the long run known exactly");
  }
}

namespace {

std::vector<Regime> walked(const Scene& scene, const RegimeOptions& options, double at_most) {
  check(scene, "scene");
  check_constant_speed(scene, "scene");
  check_regimes_exist(scene, "scene");
  if (!(options.from >= slowest_regime && options.to > options.from &&
        options.to <= fastest_regime)) {
    throw InputError(fmt::format("speeds {} to {}: must rise, within {}..{} [rad/s]", options.from,
                                 options.to, slowest_regime, fastest_regime));
  }
  Scene hard = scene;
  hard.fidelity = Fidelity::impact;
  const Scene slow = at_speed(hard, options.from);
  Scene turn = slow;
  turn.window = Revolutions{1};
  check(turn, "scene, in a turn at the slowest speed");
  report_progress("regimes", 0);
  return is_disturbed(scene) ? Walk(disturbed_motion(slow), options.to).regimes(at_most)
                             : Walk(steady_motion(slow), options.to).regimes(at_most);
}

}  // namespace

std::vector<Regime> regimes_of(const Scene& scene, const RegimeOptions& options) {
  return walked(scene, options, std::numeric_limits<double>::infinity());
}

double most_per_turn(const Scene& scene) {
  Scene hard = scene;
  hard.fidelity = Fidelity::impact;
  if (forcing_turns(hard) == 0) {
    DisturbedMotion motion = disturbed_motion(hard);
    observe(motion);
    return motion.most;
  }
  return steady_motion(hard).collisions_per_turn();
}

std::optional<double> quiet_up_to(const Scene& scene, double at_most,
                                  const RegimeOptions& options) {
  const Regime last = walked(scene, options, at_most).back();
  if (last.ends_by == RegimeEnd::time_limit) throw TimeLimitReached();
  if (!(last.most_per_turn > at_most)) return last.to;
  return last.from > options.from ? std::optional(last.from) : std::nullopt;
}

std::string name_of(RegimeEnd end) {
  switch (end) {
    case RegimeEnd::release:
      return "release";
    case RegimeEnd::counting_limit:
      return "counting-limit";
    case RegimeEnd::grazing:
      return "grazing";
    case RegimeEnd::end_of_rest:
      return "end-of-rest";
    case RegimeEnd::start_of_rest:
      return "start-of-rest";
    case RegimeEnd::flip:
      return "flip";
    case RegimeEnd::fold:
      return "fold";
    case RegimeEnd::irregular:
      return "irregular";
    case RegimeEnd::range:
      return "range";
    case RegimeEnd::time_limit:
      return "time-limit";
  }
  return "";
}

}  // namespace ricochet::carrier_track::inline regimes
