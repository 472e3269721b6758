#include "problems/carrier_track/regimes/steady_motion.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numbers>
#include <optional>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr int turns_at_most = 200;   // after which a motion without a period is averaged
constexpr int averaged_turns = 120;  // over which
constexpr std::size_t impacts_at_most = 200'000;  // before a motion is given up as not periodic
constexpr std::size_t longest_period = 8;         // in periods of the forcing
constexpr double same_state = 1e-13;  // relative; rounding adds up to some 1e-14 in a period
constexpr double close_state = 2e-3;  // relative; from here on Newton's method is tried
constexpr int newton_iterations = 25;

/// A body at the start of a period.
struct Body {
  double position, velocity;
};

/// What position and velocity are compared with.
struct Scales {
  double position, velocity;
};

Scales scales_of(const Scene& scene, const Body& a, const std::vector<Impact>& impacts) {
  double fastest = std::abs(a.velocity);
  for (const Impact& impact : impacts) fastest = std::max(fastest, impact.speed);
  const double clearance = scene.wall_upper - scene.wall_lower;
  const double position =
      std::isfinite(clearance) ? clearance : std::abs(a.position - scene.wall_lower);
  return {std::max(position, 1e-300), std::max(fastest, 1e-300)};
}

double apart(const Body& a, const Body& b, const Scales& scales) {
  return std::max(std::abs(a.position - b.position) / scales.position,
                  std::abs(a.velocity - b.velocity) / scales.velocity);
}

bool on_a_wall(const Scene& scene, double position) {
  return position == scene.wall_lower || position == scene.wall_upper;
}

Body start_of(const Scene& scene) {
  return {scene.start_position, scene.start_velocity};
}

void start_at(Scene& scene, const Body& body) {
  scene.start_position = std::clamp(body.position, scene.wall_lower, scene.wall_upper);
  scene.start_velocity = body.velocity;
}

/// Lets a scene begin `time` [s] later, with the body there.
void start_later(Scene& scene, double time, const Body& body) {
  constexpr double turn = 2 * std::numbers::pi;
  scene.phase = std::remainder(scene.phase + scene.omega * time, turn);
  scene.disturbance_phase =
      std::remainder(scene.disturbance_phase + scene.disturbance_frequency * time, turn);
  start_at(scene, body);
}

Body run(const Scene& scene, PeriodWatch& watch) {
  watch.clear();
  const End<double> end = ImpactModel<double>(scene).run(watch);
  return {end.position, end.velocity};
}

/// The state of a flight of the window at a later time.
Body state_at(Scene scene, double time) {
  Observer nobody;
  scene.window = Seconds{time};
  const End<double> end = ImpactModel<double>(scene).run(nobody);
  return {end.position, end.velocity};
}

/// What is said about the motion that starts as `orbit` does and lasts its window, as watched.
SteadyMotion described(const Scene& orbit, int turns, bool settled, const PeriodWatch& watch) {
  SteadyMotion motion;
  motion.orbit = orbit;
  motion.turns = turns;
  motion.settled = settled;
  const double duration = duration_of(orbit);
  motion.impacts = watch.impacts();
  for (const Impact& impact : motion.impacts) {
    if (is_counted(impact.speed, orbit.counting_limit)) ++motion.collisions;
    motion.energy += impact_loss(orbit, impact.wall) * impact.speed * impact.speed;
  }
  motion.share_at_rest = std::min(1.0, watch.resting() / duration);
  const PeriodWatch::Stretch* rest = watch.longest_rest();
  if (rest == nullptr) {
    motion.rest = Rest::never;
  } else if (rest->duration >= duration * (1 - 1e-12)) {
    motion.rest = Rest::always;
  } else {
    motion.rest = on_a_wall(orbit, rest->position) ? Rest::on_a_wall : Rest::in_the_gap;
  }
  return motion;
}

SteadyMotion described(const Scene& orbit, int turns, bool settled) {
  PeriodWatch watch;
  run(orbit, watch);
  return described(orbit, turns, settled, watch);
}

/// The orbit of `turns` turns near the start of `scene` that never rests, by Newton's method.
std::optional<SteadyMotion> orbit_near(Scene scene, int turns) {
  scene.window = Revolutions{static_cast<double>(turns)};
  PeriodWatch watch;
  run(scene, watch);
  if (watch.longest_rest() != nullptr) return std::nullopt;
  const Scales scales = scales_of(scene, start_of(scene), watch.impacts());
  const Body first = start_of(scene);
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < newton_iterations; ++i) {
    const OrbitMap map = map_of(scene, Rest::never);
    const double miss_x = map.position.a - scene.start_position;
    const double miss_v = map.velocity.a - scene.start_velocity;
    const double a = map.position.v[0] - 1;
    const double b = map.position.v[1];
    const double c = map.velocity.v[0];
    const double d = map.velocity.v[1] - 1;
    const double determinant = a * d - b * c;
    const Body step{(b * miss_v - d * miss_x) / determinant,
                    (c * miss_x - a * miss_v) / determinant};
    const double size = apart(step, {0, 0}, scales);
    if (!std::isfinite(size)) return std::nullopt;
    const Body next{scene.start_position + step.position, scene.start_velocity + step.velocity};
    if (next.position < scene.wall_lower || next.position > scene.wall_upper) return std::nullopt;
    if (apart(next, first, scales) > 0.2) return std::nullopt;  // another orbit
    // Rounding ends the decrease of the steps.
    if (size < 1e-15 || (size < 1e-9 && size >= 0.5 * before)) {
      SteadyMotion motion = described(scene, turns, true);
      const MapInvariants invariants = invariants_of(map, Rest::never);
      motion.trace = invariants.trace;
      motion.determinant = invariants.determinant;
      if (motion.rest != Rest::never) return std::nullopt;
      return motion;
    }
    if (i > 3 && size >= 0.9 * before) return std::nullopt;  // does not converge
    before = size;
    start_at(scene, next);
  }
  return std::nullopt;
}

/// The shortest period, in periods of `turns`, of an orbit that was found for a multiple of it.
SteadyMotion shortest(const SteadyMotion& motion, int forcing) {
  for (int turns = forcing; turns < motion.turns; turns += forcing) {
    if (motion.turns % turns != 0) continue;
    const std::optional<SteadyMotion> shorter = orbit_near(motion.orbit, turns);
    if (shorter && apart(start_of(shorter->orbit), start_of(motion.orbit),
                         scales_of(motion.orbit, start_of(motion.orbit), motion.impacts)) < 1e-9) {
      return *shorter;
    }
  }
  return motion;
}

/// Follows a motion from its start until it repeats itself.
class Settling {
 public:
  explicit Settling(const Scene& scene) : scene_(scene), forcing_(forcing_turns(scene)) {
    scene_.window = Revolutions{static_cast<double>(forcing_)};
  }

  SteadyMotion settled() {
    try {
      return until_it_repeats();
    } catch (const PeriodWatch::Full& full) {
      return averaged_over(0.999 * full.time);
    }
  }

 private:
  SteadyMotion until_it_repeats() {
    int shifts = 0;
    for (int turns = 0; turns < turns_at_most; turns += forcing_) {
      const Body here = start_of(scene_);
      const Body next = run(scene_, watch_);
      impacts_ += watch_.impacts().size();
      if (impacts_ > impacts_at_most) break;
      if (!watch_.starts_at_rest() && watch_.longest_rest() != nullptr && shifts < 8) {
        start_in_rest();
        ++shifts;
        continue;
      }
      states_.push_front(here);
      if (states_.size() > longest_period) states_.pop_back();
      if (const std::optional<SteadyMotion> motion = repeated(next)) return *motion;
      start_at(scene_, drifted(here, next));
    }
    const std::size_t in_a_turn = std::max<std::size_t>(1, watch_.impacts().size());
    const int turns = std::clamp(static_cast<int>(impacts_at_most / in_a_turn), 1, averaged_turns);
    scene_.window = Revolutions{static_cast<double>(turns)};
    return described(scene_, turns, false);
  }

  /// The averages of a motion with so many impacts that only a part of a turn [s] is simulated.
  SteadyMotion averaged_over(double time) {
    scene_.window = Seconds{time};
    SteadyMotion motion = described(scene_, 1, false);
    const double turns = turns_of(scene_);
    constexpr double most = std::numeric_limits<int>::max();
    motion.collisions = static_cast<int>(std::min(most, motion.collisions / turns));
    motion.energy /= turns;
    motion.orbit.window = Revolutions{1};
    return motion;
  }

  /// Lets the period start in the middle of its longest rest.
  void start_in_rest() {
    const PeriodWatch::Stretch& rest = *watch_.longest_rest();
    start_later(scene_, rest.time + rest.duration / 2, {rest.position, 0});
    states_.clear();
  }

  /// The motion, if the state after a period is one before it.
  std::optional<SteadyMotion> repeated(const Body& next) {
    const Scales scales = scales_of(scene_, next, watch_.impacts());
    const bool rests = watch_.starts_at_rest();
    const bool due = ++periods_ == next_try_;
    if (due) next_try_ *= 4;
    for (std::size_t k = 0; k < states_.size(); ++k) {
      const int turns = static_cast<int>(k + 1) * forcing_;
      const double difference = apart(next, states_[k], scales);
      const bool same = difference <= same_state;
      // Without impacts Newton's method has nothing to find: any place between the walls would do.
      if (same && (rests || watch_.impacts().empty())) return plain_orbit(turns);
      // Near a bifurcation a motion settles slowly: Newton's method ends it.
      if (!rests && !watch_.impacts().empty() && (same || (due && difference < close_state))) {
        if (const std::optional<SteadyMotion> motion = flying_orbit(next, turns)) return motion;
      }
    }
    return std::nullopt;
  }

  std::optional<SteadyMotion> plain_orbit(int turns) {
    Scene orbit = scene_;
    orbit.window = Revolutions{static_cast<double>(turns)};
    // The period was simulated just now.
    SteadyMotion motion =
        turns == forcing_ ? described(orbit, turns, true, watch_) : described(orbit, turns, true);
    if (motion.rest == Rest::in_the_gap) {
      motion.trace = invariants_of(map_of(orbit, motion.rest), motion.rest).trace;
    }
    return motion;
  }

  std::optional<SteadyMotion> flying_orbit(const Body& next, int turns) {
    Scene there = scene_;
    start_at(there, next);
    // In the middle of a flight the state depends smoothly on that at another time.
    const PeriodWatch::Stretch& flight = watch_.longest_flight();
    const double time = flight.time + flight.duration / 2;
    start_later(there, time, state_at(there, time));
    const std::optional<SteadyMotion> motion = orbit_near(there, turns);
    if (!motion || !motion->stable()) return std::nullopt;
    return shortest(*motion, forcing_);
  }

  /// The state after a period; a body between the walls that touched none and has its velocity
  /// again moves by the same distance in every period until it reaches a wall: these periods are
  /// left out.
  Body drifted(const Body& here, const Body& next) const {
    const double drift = next.position - here.position;
    const double fastest = std::max(std::abs(here.velocity), std::abs(next.velocity));
    const bool glides = watch_.impacts().empty() && !on_a_wall(scene_, here.position) &&
                        std::abs(next.velocity - here.velocity) <= same_state * fastest &&
                        drift != 0;
    if (!glides) return next;
    const double highest = std::max(watch_.highest() - here.position, 0.0);
    const double lowest = std::max(here.position - watch_.lowest(), 0.0);
    const double room = drift > 0 ? scene_.wall_upper - next.position - highest
                                  : next.position - lowest - scene_.wall_lower;
    const double periods = std::floor(room / std::abs(drift)) - 1;
    if (!(periods > 1) || !std::isfinite(periods)) return next;
    return {next.position + periods * drift, next.velocity};
  }

  Scene scene_;
  int forcing_;
  PeriodWatch watch_;
  std::deque<Body> states_;  // the latest first
  std::size_t impacts_ = 0;
  int periods_ = 0;
  int next_try_ = 12;
};

}  // namespace

double SteadyMotion::fastest_impact() const {
  double fastest = 0;
  for (const Impact& impact : impacts) fastest = std::max(fastest, impact.speed);
  return fastest;
}

int forcing_turns(const Scene& scene) {
  if (scene.disturbance == 0 || scene.disturbance_frequency == 0) return 1;
  constexpr double most_cycles =
      1e4;  // in a period; a faster force is as good as one that never repeats
  const double ratio = scene.disturbance_frequency / scene.omega;
  for (int turns = 1; turns <= 16; ++turns) {
    const double cycles = ratio * turns;
    if (cycles > 0.5 && cycles < most_cycles &&
        std::abs(cycles - std::round(cycles)) < 1e-12 * cycles)
      return turns;
  }
  return 0;
}

SteadyMotion steady_motion(const Scene& scene) {
  return Settling(scene).settled();
}

SteadyMotion followed(const SteadyMotion& motion, double omega) {
  return followed(motion, at_speed(motion.orbit, omega));
}

SteadyMotion followed(const SteadyMotion& motion, const Scene& scene) {
  Scene there = scene;
  there.phase = motion.orbit.phase;
  there.disturbance_phase = motion.orbit.disturbance_phase;
  there.start_position = motion.orbit.start_position;
  there.start_velocity = motion.orbit.start_velocity;
  if (motion.orbit.start_position == motion.orbit.wall_upper)
    there.start_position = there.wall_upper;
  if (motion.orbit.start_position == motion.orbit.wall_lower)
    there.start_position = there.wall_lower;
  there.start_position = std::clamp(there.start_position, there.wall_lower, there.wall_upper);
  if (motion.settled && motion.rest == Rest::never) {
    if (const std::optional<SteadyMotion> same = orbit_near(there, motion.turns)) return *same;
  }
  return steady_motion(there);
}

}  // namespace ricochet::carrier_track::inline regimes
