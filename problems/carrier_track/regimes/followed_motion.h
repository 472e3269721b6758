#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "problems/carrier_track/motion/dual_simulation.h"
#include "problems/carrier_track/motion/observer.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "ricochet/machine.h"
#include "ricochet/problem.h"
#include "ricochet/scene.h"

/// What is watched of a motion that repeats while the speed changes.
namespace ricochet::carrier_track::inline regimes {

/// What stays the same within a regime.
struct Signature {
  int turns;       ///< in a period
  int collisions;  ///< in a period
  bool settled;
  bool rests;
  bool moves;

  bool operator==(const Signature&) const = default;

  /// Whether two motions are of one kind, though they may count differently.
  bool same_kind(const Signature& other) const {
    return turns == other.turns && settled == other.settled && rests == other.rests &&
           moves == other.moves;
  }
};

/// A margin of an impact as a function of the speed: ln(approach speed / counting limit).
struct Margin {
  double value;
  double slope;  ///< per unit of the logarithm of the speed
  /// Which impact of the period: the series of impacts on one wall that it belongs to, and its
  /// place there.
  std::size_t series = 0, place = 0;
};

/// The margins of a motion.
struct Margins {
  std::vector<Margin> known;
  /// By which walls the impacts are, and how many are in a series that does not end in a rest: it
  /// changes where the carrier starts or ceases to touch a wall.
  std::vector<std::size_t> structure;
};

Signature signature_of(const SteadyMotion& motion);

/// The place among a period's impacts of the `rank`-th fastest, rank 1 the fastest; nothing if
/// there are fewer.
std::optional<std::size_t> place_of_rank(const SteadyMotion& motion, int rank);

/// ln(speed / counting limit) of the `rank`-th fastest impact of a period, rank 1 the fastest: it
/// counts if that is > 0. At least -6, also where there is no such impact.
double rank_margin(const SteadyMotion& motion, int rank);

/// The margins of all impacts that are not far slower than the counting limit.
Margins margins_of(const SteadyMotion& motion);

/// Whether two motions of equal signature at speeds next to each other have the same collisions,
/// with speeds that differ by at most some 20 %.
bool is_near(const SteadyMotion& a, const SteadyMotion& b);

LongRun long_run_of(const SteadyMotion& motion);

// Exact derivatives of a periodic motion, by dual numbers.

/// One period of an orbit in dual numbers. Their derivatives are with respect to position, velocity
/// (both at the start of the period), speed of the driver plate, and up to two constants.
struct OrbitMap {
  using Number = DesignDual;
  static constexpr int position_index = 0, velocity_index = 1, omega_index = 2, constant_index = 3;

  std::vector<Number> speeds;  ///< [m/s], approach speeds of the impacts, by time
  std::vector<Wall> walls;     ///< of these impacts
  std::vector<Number> misses;  ///< [m] > 0, distances by which turning points miss a wall
  Number position, velocity;   ///< [m], [m/s], at the end
};

/// The constants of a scene that a border can be followed over, by the keys of its file, and
/// `clearance`: the upper wall moves.
std::vector<std::string> continuation_constants();

/// Sets the constant of that key, of a plain scene. Throws InputError for a key that is not among
/// continuation_constants().
void set_constant(Scene& scene, const std::string& key, double to);
double constant_named(const Scene& scene, const std::string& key);

/// Makes that constant of a scene the dual number's variable of that index.
void vary_constant(BasicScene<OrbitMap::Number>& scene, const std::string& key, int index);

/// The period that starts at `orbit`'s start, at rest if `rest` says so. At most two constants.
OrbitMap map_of(const Scene& orbit, Rest rest, std::span<const std::string> constants = {});

/// Derivatives along the orbit: how a number of the period changes with the speed and the constants
/// while the start follows, so that the motion stays periodic (implicit function theorem).
class AlongOrbit {
 public:
  AlongOrbit(const OrbitMap& map, Rest rest);

  /// The total derivative of `number` with respect to the speed (index 2) or a constant (3, 4).
  double operator()(const OrbitMap::Number& number, int index) const;

 private:
  double position_[3] = {};  // derivatives of the start
  double velocity_[3] = {};
};

/// Trace and determinant of the map's Jacobian.
struct MapInvariants {
  double trace, determinant;
};
MapInvariants invariants_of(const OrbitMap& map, Rest rest);

/// What happens in one period of a motion: its impacts, its rests and its longest flight.
class PeriodWatch : public Observer {
 public:
  /// Thrown by impact() past most_impacts: memory would not suffice for all that there may be.
  struct Full : std::runtime_error {
    explicit Full(double at) : std::runtime_error("a period has too many impacts"), time(at) {}
    double time;  ///< [s], since the start of the period
  };
  static constexpr std::size_t most_impacts = 400'000;

  /// A time without motion, or a flight, between two events.
  struct Stretch {
    double time = 0;      ///< [s], its start
    double duration = 0;  ///< [s]
    double position = 0;  ///< [m], at its start
  };

  void impact(double time, Wall wall, double speed) {
    if (speed <= 0) return;
    if (impacts_.size() == most_impacts) throw Full(time);
    impacts_.push_back({time, wall, speed});
  }

  void turn(double /*time*/, double position, Wall /*ahead*/) {
    lowest_ = std::min(lowest_, position);
    highest_ = std::max(highest_, position);
  }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    if (duration <= 0) return;
    if (path.harmonics != 0) {
      if (duration > flight_.duration) flight_ = {time, duration, path.position};
    } else if (!rests_.empty() && rests_.back().time + rests_.back().duration >= time) {
      rests_.back().duration = time + duration - rests_.back().time;
    } else {
      rests_.push_back({time, duration, path.position});
    }
  }

  const std::vector<Impact>& impacts() const { return impacts_; }

  /// The longest flight without an impact or a turning point; duration 0 if there is none.
  const Stretch& longest_flight() const { return flight_; }

  /// The longest rest; nullptr if there is none.
  const Stretch* longest_rest() const {
    const auto longer = [](const Stretch& a, const Stretch& b) { return a.duration < b.duration; };
    return rests_.empty() ? nullptr : &*std::max_element(rests_.begin(), rests_.end(), longer);
  }

  /// [m], of the turning points; lowest > highest if there is none.
  double lowest() const { return lowest_; }
  double highest() const { return highest_; }

  bool starts_at_rest() const { return !rests_.empty() && rests_.front().time == 0; }

  /// [s], at rest in all.
  double resting() const {
    double sum = 0;
    for (const Stretch& rest : rests_) sum += rest.duration;
    return sum;
  }

  void clear() {
    impacts_.clear();
    rests_.clear();
    flight_ = {};
    lowest_ = std::numeric_limits<double>::infinity();
    highest_ = -lowest_;
  }

 private:
  std::vector<Impact> impacts_;
  std::vector<Stretch> rests_;
  Stretch flight_;
  double lowest_ = std::numeric_limits<double>::infinity();
  double highest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace ricochet::carrier_track::inline regimes
