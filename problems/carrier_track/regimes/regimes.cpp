#include "ricochet/regimes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/error.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr double shortest_step = 1e-4;  // of the logarithm of the speed
constexpr double longest_step = 0.1;
constexpr double irregular_step = 0.02;  // where the motion does not repeat

/// Whether the cubic through the values and slopes at both ends of a step keeps its sign, and is
/// near enough to what it stands for: its error is of the size of `surprise`, the difference
/// between the rise and what the slopes say.
bool keeps_sign(const Margin& a, const Margin& b, double step) {
  if ((a.value > 0) != (b.value > 0)) return false;
  const double surprise = std::abs(b.value - a.value - step * (a.slope + b.slope) / 2);
  const double size = std::abs(a.value) + std::abs(b.value);
  if (surprise > 0.5 * size) return false;
  for (const double t : {0.25, 0.5, 0.75}) {
    const double s = 1 - t;
    const double there = s * s * (1 + 2 * t) * a.value + t * t * (1 + 2 * s) * b.value +
                         step * s * t * (s * a.slope - t * b.slope);
    if ((there > 0) != (a.value > 0)) return false;
  }
  return true;
}

/// The largest modulus of the eigenvalues of a period.
double memory_of(const SteadyMotion& motion) {
  const double half = motion.trace / 2;
  const double square = half * half - motion.determinant;
  return square >= 0 ? std::abs(half) + std::sqrt(square) : std::sqrt(motion.determinant);
}
double memory_of(const DisturbedMotion& /*motion*/) {
  return 0;
}

/// Takes the collisions of a motion into a regime.
void widen(Regime& regime, double least, double most) {
  regime.least_per_turn = std::min(regime.least_per_turn, least);
  regime.most_per_turn = std::max(regime.most_per_turn, most);
}
void widen(Regime& regime, const SteadyMotion& motion) {
  widen(regime, motion.collisions_per_turn(), motion.collisions_per_turn());
}
void widen(Regime& regime, const DisturbedMotion& motion) {
  widen(regime, motion.least, motion.most);
}

/// Follows a motion from border to border.
template <class Motion>
class Walk {
 public:
  Walk(const Motion& start, double to) : here_(start), margins_(margins_of(start)), to_(to) {}

  /// The regimes, up to the first in which a turn has more than `at_most` collisions.
  std::vector<Regime> regimes(double at_most) {
    open(here_, here_.omega());
    while (here_.omega() < to_ && !(regimes_.back().most_per_turn > at_most)) {
      if (!advance()) step_ /= 2;
    }
    if (here_.omega() < to_) to_ = here_.omega();
    close(here_, to_, RegimeEnd::range);
    return regimes_;
  }

 private:
  /// Takes a step, to its end or to the border within it; false if it is too long.
  bool advance() {
    const double length = std::min(signature_of(here_).settled ? step_ : irregular_step,
                                   std::log(to_ / here_.omega()));
    const double end = length < step_ ? std::min(to_, here_.omega() * std::exp(length))
                                      : here_.omega() * std::exp(length);
    Motion next = followed(here_, end >= to_ * (1 - 1e-15) ? to_ : end);
    const double step = std::log(next.omega() / here_.omega());
    if (!(signature_of(next) == signature_of(here_))) {
      if (step > longest_structured && signature_of(here_).moves) return false;
      const Border<Motion> border = first_border(here_, next);
      if (signature_of(border.after) == signature_of(here_)) {  // it moved, to rest elsewhere
        here_ = border.after;
        margins_ = margins_of(here_);
        return true;
      }
      close(border.before, border.omega, border.kind);
      open(border.after, border.omega);
      step_ = std::max(shortest_step, std::min(step_, 0.01));
      return true;
    }
    const std::vector<Margin> margins = margins_of(next);
    if (step > shortest_step && !smooth(margins, step)) return false;
    here_ = std::move(next);
    margins_ = margins;
    add(here_);
    step_ = std::min(longest_step, 2 * step_);
    return true;
  }

  bool smooth(const std::vector<Margin>& margins, double step) const {
    if (margins.size() != margins_.size()) return step <= 10 * shortest_step;
    for (std::size_t i = 0; i < margins.size(); ++i) {
      if (!keeps_sign(margins_[i], margins[i], step)) return false;
    }
    return true;
  }

  void open(const Motion& first, double from) {
    here_ = first;
    margins_ = margins_of(first);
    const Signature signature = signature_of(first);
    Regime regime{};
    regime.from = from;
    regime.first = long_run_of(first);
    regime.least_per_turn = regime.most_per_turn = regime.first.collisions_per_turn;
    regime.turns = signature.turns;
    regime.rests = signature.rests;
    regime.moves = signature.moves;
    regime.certain = signature.settled;
    regimes_.push_back(regime);
    sum_ = 0;
    added_ = 0;
    add(first);
  }

  /// Takes another motion into the regime.
  void add(const Motion& motion) {
    widen(regimes_.back(), motion);
    sum_ += long_run_of(motion).collisions_per_turn;
    regimes_.back().collisions_per_turn = sum_ / ++added_;
  }

  void close(const Motion& last, double to, RegimeEnd kind) {
    Regime& regime = regimes_.back();
    regime.to = to;
    regime.last = long_run_of(last);
    regime.ends_by = kind;
    regime.memory = memory_of(last);
  }

  static constexpr double longest_structured = 0.02;

  Motion here_;
  std::vector<Margin> margins_;
  double to_;
  double step_ = 0.01;
  double sum_ = 0;  // of the regime's collisions per turn
  int added_ = 0;
  std::vector<Regime> regimes_;
};

}  // namespace

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
  }
  return "";
}

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
  const bool disturbed = scene.disturbance != 0 && scene.disturbance_frequency != 0;
  return disturbed ? Walk(disturbed_motion(slow), options.to).regimes(at_most)
                   : Walk(steady_motion(slow), options.to).regimes(at_most);
}

}  // namespace

std::vector<Regime> regimes_of(const Scene& scene, const RegimeOptions& options) {
  return walked(scene, options, std::numeric_limits<double>::infinity());
}

double most_per_turn(const Scene& scene) {
  Scene hard = scene;
  hard.fidelity = Fidelity::impact;
  if (forcing_turns(hard) == 0) return disturbed_motion(hard).most;
  return steady_motion(hard).collisions_per_turn();
}

std::optional<double> quiet_up_to(const Scene& scene, double at_most,
                                  const RegimeOptions& options) {
  const Regime last = walked(scene, options, at_most).back();
  if (!(last.most_per_turn > at_most)) return last.to;
  return last.from > options.from ? std::optional(last.from) : std::nullopt;
}

}  // namespace ricochet::carrier_track::inline regimes
