#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/regimes/disturbed_motion.h"
#include "problems/carrier_track/regimes/disturbed_regimes.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

// Steps are in the logarithm of the speed.
constexpr double longest_step = 0.02;        // an impact may come and go within a longer one
constexpr double longest_first_step = 0.01;  // after a border
constexpr double step_after_border = 1e-4;   // at least, after a border
constexpr double shortest_step = 1e-7;
/// The longest step between motions with different impacts: one that appears may make others
/// slower, and two that were just about to count vanish between the ends of the step.
constexpr double unlike_step = 1e-5;
constexpr double rounding = 1e-12;
constexpr double irregular_step = 0.02;  // where the motion does not repeat

/// The largest modulus of the eigenvalues of a period.
double memory_of(const SteadyMotion& motion) {
  const double half = motion.trace / 2;
  const double square = half * half - motion.determinant;
  return square >= 0 ? std::abs(half) + std::sqrt(square) : std::sqrt(motion.determinant);
}

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
class Walk {
 public:
  Walk(const SteadyMotion& start, double to)
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
    return regimes_;
  }

 private:
  /// Takes a step, to its end or to the border within it; false if it is too long.
  bool advance() {
    const double length =
        std::min(is_certain() ? step_ : irregular_step, std::log(to_ / here_.omega()));
    const double end = length < step_ ? std::min(to_, here_.omega() * std::exp(length))
                                      : here_.omega() * std::exp(length);
    SteadyMotion next = followed(here_, end >= to_ * (1 - 1e-15) ? to_ : end);
    const double step = std::log(next.omega() / here_.omega());
    if (!(signature_of(next) == signature_of(here_))) {
      if (step > longest_structured && signature_of(here_).moves) return false;
      const Border border = first_border(here_, next);
      // On the way there the motion may change, and change back.
      if (!reaches(border.before)) return false;
      if (is_passed(border)) return true;
      if (signature_of(border.after) == signature_of(here_)) {  // it moved, to rest elsewhere
        here_ = border.after;
        margins_ = margins_of(here_);
        return true;
      }
      cross(border);
      step_ = std::max(step_after_border, std::min(step_, longest_first_step));
      return true;
    }
    if (!reaches(next)) return false;
    here_ = std::move(next);
    margins_ = reached_ ? *std::move(reached_) : margins_of(here_);
    add(here_);
    step_ = std::min(longest_step, 2 * step_);
    return true;
  }

  /// Whether the motion here goes on beyond a jump, which a long step has made into one of several
  /// motions that are possible there. Then it is followed on, some times; after these the regime
  /// is not certain.
  bool is_passed(const Border& border) {
    if (!is_certain() || !is_jump(border.kind)) return false;
    SteadyMotion beyond = followed(border.before, border.omega * (1 + just_beyond_a_jump));
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
  }

  /// Goes on beyond a border, which may be before the regime here: what began there was not seen.
  void cross(const Border& border) {
    if (is_one(border.omega, regimes_.back().from) && is_one(here_.omega(), regimes_.back().from)) {
      join_borders(border.after);
    } else if (border.omega > regimes_.back().from) {
      close(border.before, border.omega, border.kind);
      open(border.after, border.omega);
    } else {
      const SteadyMotion before = here_;
      close(before, before.omega(), border.kind);
      open(border.after, before.omega());
    }
  }

  /// Takes back the regime here, which is narrower than borders can be told apart: that at its
  /// start and the next one are one border, beyond which there is the motion `after`.
  void join_borders(const SteadyMotion& after) {
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
    margins_ = margins_of(here_);
    add(here_);
  }

  /// Whether borders at these speeds are one.
  static bool is_one(double omega, double from) { return omega <= from * (1 + border_resolution); }

  bool is_certain() const { return regimes_.back().certain; }

  /// Whether a motion is surely the one here, followed without a border on the way; if not, and
  /// shorter steps are of no use, the regime is not certain.
  bool reaches(const SteadyMotion& there) {
    reached_.reset();
    if (!is_certain() || !signature_of(here_).moves) return true;
    const double step = std::log(there.omega() / here_.omega());
    reached_ = margins_of(there);
    if (step <= rounding || smooth(*reached_, step)) return true;
    if (step > shortest_step) return false;
    regimes_.back().certain = is_near(here_, there);
    return true;
  }

  bool smooth(const Margins& margins, double step) const {
    if (margins.structure != margins_.structure) return step <= unlike_step;
    auto before = margins_.known.begin();  // both are in order of series and place
    const auto place_of = [](const Margin& m) { return std::pair(m.series, m.place); };
    for (const Margin& margin : margins.known) {
      while (before != margins_.known.end() && place_of(*before) < place_of(margin)) ++before;
      if (before == margins_.known.end()) break;
      if (place_of(*before) == place_of(margin) && !keeps_sign(*before, margin, step)) return false;
    }
    return true;
  }

  void open(const SteadyMotion& first, double from) {
    here_ = first;
    margins_ = margins_of(first);
    const Signature signature = signature_of(first);
    Regime regime{};
    regime.from = from;
    regime.first = long_run_of(first);
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
  void add(const SteadyMotion& motion) {
    const double collisions = motion.collisions_per_turn();
    Regime& regime = regimes_.back();
    regime.least_per_turn = std::min(regime.least_per_turn, collisions);
    regime.most_per_turn = std::max(regime.most_per_turn, collisions);
    sum_ += collisions;
    regime.collisions_per_turn = sum_ / ++added_;
  }

  void close(const SteadyMotion& last, double to, RegimeEnd kind) {
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

  SteadyMotion here_;
  Margins margins_;
  std::optional<Margins> reached_;  // of the motion that reaches() was last asked for
  double from_, to_;
  double covered_;  // the regimes are known up to here
  double step_ = 0.01;
  double sum_ = 0;  // of the regime's collisions per turn
  int added_ = 0;
  int passed_ = 0;  // jumps in the regime beyond which its motion goes on
  std::vector<Regime> regimes_;
  std::vector<SteadyMotion> first_;  // of each regime
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
  std::vector<Regime> found = is_disturbed(scene)
                                  ? disturbed_regimes(hard, options, at_most)
                                  : Walk(steady_motion(slow), options.to).regimes(at_most);
  doubt_islands(found);
  return found;
}

}  // namespace

std::vector<Regime> regimes_of(const Scene& scene, const RegimeOptions& options) {
  return walked(scene, options, std::numeric_limits<double>::infinity());
}

double most_per_turn(const Scene& scene) {
  Scene hard = scene;
  hard.fidelity = Fidelity::impact;
  if (forcing_turns(hard) == 0) {
    return disturbed_motion(hard).most;
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
