#include "problems/carrier_track/check/method.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "problems/carrier_track/check/push.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline reference_integrators {

Forces::Forces(const Scene& scene) {
  const long double mass = scene.mass;
  double fastest = 0;
  const auto force = applied_force(scene);
  for (std::size_t k = 0; k < force.size(); ++k) {
    const auto& [from, terms] = force[k];
    const auto end = k + 1 < force.size() ? force[k + 1].from : duration_of(scene);
    const double span = std::max(static_cast<double>(end - from), 0.0);
    Piece piece{static_cast<double>(from), {}, {}};
    const auto rounded = [](const std::array<long double, 3>& p, long double by) {
      return Polynomial{static_cast<double>(p[0] * by), static_cast<double>(p[1] * by),
                        static_cast<double>(p[2] * by)};
    };
    for (const PushTerm& term : terms) {
      const Term wave{rounded(term.amplitude, 1 / mass), rounded(term.phase, 1)};
      const auto& [a, p] = wave;
      const auto together = [&a = a, &p = p](const Term& other) {
        return other.phase[1] == p[1] && p[2] == 0 && other.phase[2] == 0 && a[1] == 0 &&
               a[2] == 0 && other.amplitude[1] == 0 && other.amplitude[2] == 0;
      };
      const auto same = std::find_if(piece.waves.begin(), piece.waves.end(), together);
      if (p[1] == 0 && p[2] == 0) {
        for (std::size_t i = 0; i < a.size(); ++i) piece.steady[i] += a[i] * std::cos(p[0]);
      } else if (same == piece.waves.end()) {
        piece.waves.push_back(wave);
      } else {  // one cosine for both
        const auto sum =
            same->amplitude[0] * std::complex(std::cos(same->phase[0]), std::sin(same->phase[0])) +
            a[0] * std::complex(std::cos(p[0]), std::sin(p[0]));
        same->amplitude[0] = std::abs(sum);
        same->phase[0] = std::arg(sum);
      }
    }
    double bound = std::max(std::abs(at(piece.steady, 0)), std::abs(at(piece.steady, span)));
    for (const auto& [a, p] : piece.waves) {
      bound += std::max(std::abs(at(a, 0)), std::abs(at(a, span)));
      fastest = std::max({fastest, std::abs(slope(p, 0)), std::abs(slope(p, span))});
    }
    strongest_ = std::max(strongest_, bound);
    pieces_.push_back(std::move(piece));
  }
  shortest_period_ = 2 * std::numbers::pi / fastest;
}

double Forces::applied_rate(double time, double in) const {
  const Piece& piece = at(in);
  const double u = time - piece.from;
  double sum = slope(piece.steady, u);
  for (const auto& [a, p] : piece.waves) {
    sum += slope(a, u) * std::cos(at(p, u)) - at(a, u) * slope(p, u) * std::sin(at(p, u));
  }
  return sum;
}

double Forces::smooth_until(double time) const {
  const Piece* next = &at(time) + 1;
  return next == pieces_.data() + pieces_.size() ? std::numeric_limits<double>::infinity()
                                                 : next->from;
}

namespace {

/// K d^n / m.
double spring(const WallForce& wall, double depth) {
  if (wall.exponent == 1.5) return wall.stiffness * depth * std::sqrt(depth);
  return wall.exponent == 1 ? wall.stiffness * depth
                            : wall.stiffness * std::pow(depth, wall.exponent);
}

}  // namespace

double WallForce::operator()(const State& state) const {
  const double d = depth(state.position);
  if (!(d > 0)) return 0;
  const int outward = state.position < lower ? +1 : -1;
  const double rate = -outward * state.velocity;
  const double damping = outward > 0 ? lower_damping : upper_damping;
  if (viscous) {
    const double force = stiffness * d + damping * rate;
    return outward * (pulls ? force : std::max(0.0, force));
  }
  return outward * spring(*this, d) * (1 + damping / speed * rate);
}

WallForce::Slopes WallForce::slopes(const State& state) const {
  const double d = depth(state.position);
  if (!(d > 0)) return {0, 0};
  const int outward = state.position < lower ? +1 : -1;
  const double rate = -outward * state.velocity;
  const double damping = outward > 0 ? lower_damping : upper_damping;
  if (viscous) {
    const bool acts = pulls || stiffness * d + damping * rate > 0;
    return acts ? Slopes{-stiffness, -damping} : Slopes{0, 0};
  }
  const double force = spring(*this, d);
  const double factor = damping / speed;
  return {-exponent * force / d * (1 + factor * rate), -factor * force};
}

WallForce wall_force_of(const Scene& scene) {
  WallForce wall;
  wall.lower = scene.wall_lower;
  wall.upper = scene.wall_upper;
  wall.stiffness = scene.stiffness / scene.mass;
  wall.viscous = scene.contact_law == ContactLaw::kelvin_voigt;
  wall.exponent = wall.viscous ? 1 : scene.contact_exponent;
  const double unit = wall.viscous ? 2 * std::sqrt(wall.stiffness) : 1;
  wall.lower_damping = unit * damping_factor(scene.contact_law, lower_restitution(scene));
  wall.upper_damping = unit * damping_factor(scene.contact_law, upper_restitution(scene));
  wall.speed = scene.contact_speed.value_or(1);
  return wall;
}

System::System(const Scene& scene)
    : forces(scene),
      lower(scene.wall_lower),
      upper(scene.wall_upper),
      window(duration_of(scene)),
      length(scene.wall_upper - scene.wall_lower),
      friction(scene.friction * scene.normal_force / scene.mass) {
  if (!std::isfinite(length)) length = scene.start_position - scene.wall_lower;
  if (!(length > 0)) length = 1;
  if (scene.fidelity == Fidelity::compliant) wall = wall_force_of(scene);
}

WallForce::Slopes System::slopes(const State& state) const {
  WallForce::Slopes sum = wall ? wall->slopes(state) : WallForce::Slopes{0, 0};
  if (creep > 0) {
    const double share = std::tanh(state.velocity / creep);
    sum.by_velocity -= friction / creep * (1 - share * share);
  }
  return sum;
}

namespace {

struct Slope {
  double value, slope;
};

/// The point where f, positive at `lower` or right behind it, and not at `upper`, has fallen to
/// zero, to a few roundings of `upper`; `lower` if f is nowhere positive. f(time) returns a Slope.
/// Newton's iteration in a bracket, from the root of a parabola through both ends.
///
/// NOTE: an integration with event location spends most of its time here; for these smooth, nearly
/// parabolic functions this needs half the time of toms748_solve.
template <class Function>
double fall(Function f, double lower, double upper) {
  const double width = 4 * std::numeric_limits<double>::epsilon() * upper;
  const double length = upper - lower;
  const auto [start, slope_at_start] = f(lower);
  const double bend = (f(upper).value - start - slope_at_start * length) / (length * length);
  const double root = std::sqrt(slope_at_start * slope_at_start - 4 * bend * start);
  double next = lower + (slope_at_start > 0 ? -0.5 * (slope_at_start + root) / bend
                                            : 2 * start / (root - slope_at_start));
  double time = upper;
  while (upper - lower > width) {
    if (!(next > lower && next < upper)) next = lower + 0.5 * (upper - lower);
    const bool converged = std::abs(next - time) <= width;
    time = next;
    if (converged) break;
    const auto [value, slope] = f(time);
    (value > 0 ? lower : upper) = time;
    next = time - value / slope;
  }
  return time;
}

/// The first event of the last step of a method, from `begin` to `end` [s], for motion in
/// `direction`, which changes at velocity zeros. Events are detected by the signs of velocity and
/// distance at both ends; in a step whose velocity changes sign, also at the velocity zero. So an
/// event that starts and ends between two velocity zeros of one step is missed.
std::optional<Landing> first_event(const System& system, Method& method, int& direction,
                                   double begin, double end, const State& at_end) {
  const auto ahead = [&](double position) {
    return direction > 0 ? system.upper - position : position - system.lower;
  };
  const auto reach = [&](double from, double to) {
    const auto distance = [&](double t) {
      const State state = method.at(t);
      return Slope{ahead(state.position), -direction * state.velocity};
    };
    const double time = fall(distance, from, to);
    return Landing{direction > 0 ? Finish::upper_wall : Finish::lower_wall, time, method.at(time)};
  };
  double from = begin;
  if (direction * at_end.velocity < 0) {
    const auto speed = [&](double t) {
      const State state = method.at(t);
      return Slope{direction * state.velocity, direction * system.acceleration(t, state)};
    };
    const double turn = fall(speed, begin, end);
    const State at_turn = method.at(turn);
    if (ahead(at_turn.position) < 0) return reach(begin, turn);
    if (system.friction > 0) return Landing{Finish::turn, turn, at_turn};
    direction = -direction;
    from = turn;
  }
  if (ahead(at_end.position) < 0) return reach(from, end);
  return std::nullopt;
}

}  // namespace

Landing Method::fly(const Leg& leg) {
  system_.start = leg.start;
  system_.direction = leg.direction;
  start(leg.state);
  int direction = leg.direction;
  for (double begin = 0;;) {
    if (++steps_ > most_steps) throw std::runtime_error("more than 1000000 steps");
    const double passed = step();
    const bool last = passed >= leg.longest;
    const double end = last ? leg.longest : passed;
    const State at_end = at(end);
    const auto landing = first_event(system_, *this, direction, begin, end, at_end);
    if (landing || last) {
      const Landing found = landing.value_or(Landing{Finish::limit, end, at_end});
      if (found.duration > 0) last_flight_ = found.duration;
      return found;
    }
    begin = end;
  }
}

}  // namespace ricochet::carrier_track::inline reference_integrators
