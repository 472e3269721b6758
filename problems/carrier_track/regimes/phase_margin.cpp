#include "problems/carrier_track/regimes/phase_margin.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "problems/carrier_track/regimes/phase_window.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr int phase_bits = 24;         // of an extreme phase: its margin has twice as many
constexpr double widest_window = 0.1;  // [rad], to each side, in which extremes are searched
constexpr double narrowest_window = 1e-4;
constexpr double jump = 1e-4;            // more than that, where an impact appears or vanishes
constexpr double smooth = 1e-11;         // relative, what a polynomial may leave out
constexpr double refined_within = 0.02;  // margins nearer to 0 are searched, not interpolated

/// The least value of the parabola through the values at -1, 0 and 1, of which that at 0 is the
/// least.
double vertex_of(double before, double here, double after) {
  const double bend = before - 2 * here + after;
  if (!(bend > 0)) return here;
  const double place = (before - after) / (2 * bend);
  return here - bend * place * place / 2;
}

/// The margins of an impact over the even phases, with a sign that makes the extreme one the least.
class EvenMargins {
 public:
  EvenMargins(const DisturbedMotion& motion, int rank, Extreme extreme)
      : sign_(sign_of(extreme)), settled_(motion.settled) {
    for (const DisturbedTurn& turn : motion.turns) {
      values_.push_back(sign_ * margin_of(motion.machine, turn, rank));
    }
  }

  double sign() const { return sign_; }
  double at(std::size_t k) const { return values_[k % values_.size()]; }
  std::size_t deepest() const {
    return static_cast<std::size_t>(std::min_element(values_.begin(), values_.end()) -
                                    values_.begin());
  }

  /// Phases lower than both neighbours, the deepest first.
  std::vector<std::size_t> valleys() const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < values_.size(); ++k) {
      if (at(k) <= at(k + values_.size() - 1) && at(k) <= at(k + 1)) found.push_back(k);
    }
    std::sort(found.begin(), found.end(),
              [&](std::size_t a, std::size_t b) { return at(a) < at(b); });
    return found;
  }

  /// The least, between the phases by parabolas.
  double least() const {
    double least = at(deepest());
    if (!interpolates() || std::abs(least) >= -lowest_margin) return least;
    for (const std::size_t k : valleys()) {
      least = std::min(least, vertex_of(at(k + values_.size() - 1), at(k), at(k + 1)));
    }
    return least;
  }

  /// Whether the least may be on the other side of 0 than the parabola says, or is near 0. Where an
  /// impact appears, a parabola goes far beyond what is true.
  bool is_unsure() const {
    const double interpolated = least();
    return settled_ && values_.size() > 2 &&
           (std::abs(interpolated) <= refined_within || (interpolated > 0) != (at(deepest()) > 0));
  }

 private:
  bool interpolates() const { return settled_ && values_.size() > 2; }

  double sign_;
  bool settled_;
  std::vector<double> values_;
};

/// With the sign that makes an extreme the least.
struct Valley {
  double phase, value;
};

/// The least margin, with that sign, near `phase`: within a step of the phases, or as far as it
/// goes down.
Valley least_near(const DisturbedMotion& motion, int rank, double sign, double phase) {
  Valley found{phase, std::numeric_limits<double>::infinity()};
  bool jumps = false;
  double centre = phase;
  double around = widest_window;
  for (int windows = 0; windows < 10 && around > narrowest_window; ++windows) {
    const PhaseWindow window(motion, rank, centre, around);
    if (!window.is_known()) break;
    jumps = jumps || window.error() > jump;
    const PhaseWindow::Valley valley = window.least(sign);
    centre = valley.phase;
    if (!valley.inside) continue;
    if (window.error() <= smooth) {
      found = {valley.phase, valley.value};
      break;
    }
    around /= 8;
  }
  if (std::isfinite(found.value) && !jumps) return found;
  const double reach = 2 * std::numbers::pi / static_cast<double>(motion.turns.size());
  std::uintmax_t evaluations = 40;
  const auto [at, value] = boost::math::tools::brent_find_minima(
      [&](double there) { return sign * margin_of(motion.machine, turn_at(motion, there), rank); },
      phase - reach, phase + reach, phase_bits, evaluations);
  return value < found.value ? Valley{at, value} : found;
}

Valley searched(const DisturbedMotion& motion, int rank, const EvenMargins& margins) {
  Valley deepest{0, std::numeric_limits<double>::infinity()};
  for (const std::size_t k : margins.valleys()) {
    if (margins.at(k) > deepest.value + refined_within) continue;
    const double phase = motion.turns[k].phase;
    const Valley valley = least_near(motion, rank, margins.sign(), phase);
    if (margins.at(k) < deepest.value) deepest = {phase, margins.at(k)};
    if (valley.value < deepest.value) deepest = valley;
  }
  return deepest;
}

PhaseMargin found_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  if (motion.turns.empty()) {
    DisturbedMotion long_motion = motion;
    observe(long_motion);
    return found_margin(long_motion, rank, extreme);
  }
  const EvenMargins margins(motion, rank, extreme);
  Valley found{motion.turns[margins.deepest()].phase, margins.least()};
  if (margins.is_unsure()) found = searched(motion, rank, margins);
  for (const DisturbedTurn& turn : motion.watched) {
    const double value = margins.sign() * margin_of(motion.machine, turn, rank);
    if (value < found.value) found = {turn.phase, value};
  }
  return {margins.sign() * found.value, found.phase};
}

}  // namespace

PhaseMargin sampled_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  const EvenMargins margins(motion, rank, extreme);
  return {margins.sign() * margins.least(), motion.turns[margins.deepest()].phase};
}

PhaseMargin extreme_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  for (const KnownMargin& known : motion.known) {
    if (known.rank == rank && known.extreme == extreme) return {known.value, known.phase};
  }
  const PhaseMargin found = found_margin(motion, rank, extreme);
  motion.known.push_back({rank, extreme, found.value, found.phase});
  return found;
}

}  // namespace ricochet::carrier_track::inline regimes
