#include "src/research/paper/throw.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "problems/carrier_track/scene/contact_restitution.h"
#include "src/core/bracketed_root.h"

namespace ricochet::carrier_track::inline paper {
namespace {

using std::numbers::pi;

/// The zero in (low, high], where f has the sign of -1 just above `low` and +1 at `high`.
template <class Function>
double zero_of(const Function& f, double low, double high) {
  const double at_low = f(low);
  if (at_low >= 0) return low;
  const double at_high = f(high);
  if (at_high <= 0) return high;
  const auto bracket =
      bracketed_root(f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(40));
  return (bracket.first + bracket.second) / 2;
}

/// A motion under cos(theta) + steady, from a place and a speed at an angle.
struct Path {
  double angle, place, speed, steady;

  double speed_at(double theta) const {
    return speed + std::sin(theta) - std::sin(angle) + steady * (theta - angle);
  }
  double place_at(double theta) const {
    const double way = theta - angle;
    return place + (speed - std::sin(angle)) * way + std::cos(angle) - std::cos(theta) +
           steady * way * way / 2;
  }
};

/// The angle at which `force` = cos(theta) + steady, positive at 0, ceases to be positive.
double fall_of(double steady) {
  return std::acos(std::clamp(-steady, -1.0, 1.0));
}

/// An impact of a throw, in units of the drive: forces by B omega^2, speeds by B omega / m.
struct Hit {
  double angle, speed;
};

/// The first impact of a throw across `clearance`.
std::optional<Hit> crossing(double clearance, double steady, double friction) {
  const double net = steady - friction;
  if (!(net > -1 && net < 1)) return std::nullopt;
  const Path path{-fall_of(net), 0, 0, net};
  // It slows down from where the force falls below friction, and stops within a turn.
  double last = fall_of(net);
  if (path.place_at(last) <= clearance) {
    last = zero_of([&](double theta) { return -path.speed_at(theta); }, last, path.angle + 2 * pi);
    if (path.place_at(last) <= clearance) return std::nullopt;
  }
  const double angle =
      zero_of([&](double theta) { return path.place_at(theta) - clearance; }, path.angle, last);
  return Hit{angle, path.speed_at(angle)};
}

/// The next impact on the same wall, off which the body moves with a speed.
std::optional<Hit> rebound(const Hit& hit, double kept, double steady, double friction) {
  // Towards the wall is positive.
  const Path away{hit.angle, 0, -kept * hit.speed, steady + friction};
  const double last = fall_of(steady + friction);
  if (hit.angle >= last || away.speed_at(last) < 0) return std::nullopt;  // carried off the wall
  const double turns = zero_of([&](double theta) { return away.speed_at(theta); }, hit.angle, last);
  const double ceases = fall_of(steady - friction);
  if (turns >= ceases) return std::nullopt;  // friction holds it, or the force has turned
  const Path back{turns, away.place_at(turns), 0, steady - friction};
  double stops = ceases;
  if (back.place_at(stops) <= 0) {
    stops = zero_of([&](double theta) { return -back.speed_at(theta); }, ceases,
                    std::min(ceases + pi, turns + 2 * pi));
    if (back.place_at(stops) <= 0) return std::nullopt;
  }
  const double angle = zero_of([&](double theta) { return back.place_at(theta); }, turns, stops);
  return Hit{angle, back.speed_at(angle)};
}

double amplitude_of(const Scene& scene) {
  return std::abs(scene.centrifugal_mass_radius - scene.slider_mass_radius);
}

}  // namespace

std::vector<double> throw_speeds(const Scene& scene, Wall towards, int impacts, double steady) {
  const double amplitude = amplitude_of(scene);  // [kg m]
  const double force = amplitude * scene.omega * scene.omega;
  const double friction = scene.friction * scene.normal_force / force;
  const double up = (steady - scene.pull) / force;
  const double along = towards == Wall::upper ? up : -up;
  const double clearance = scene.mass * (scene.wall_upper - scene.wall_lower) / amplitude;
  const double kept = scene.restitution_lower * returned_share(scene);
  std::vector<double> speeds;
  std::optional<Hit> hit = crossing(clearance, along, friction);
  while (hit && std::ssize(speeds) < impacts) {
    speeds.push_back(hit->speed * amplitude * scene.omega / scene.mass);
    hit = rebound(*hit, kept, along, friction);
  }
  return speeds;
}

namespace {

/// The speed [m/s] of the rank-th fastest impact of a turn, with a disturbance of this phase in the
/// throw towards the upper wall; 0 if there are fewer.
double ranked_speed(const Scene& scene, int rank, double phase, double later) {
  std::vector<double> speeds =
      throw_speeds(scene, Wall::upper, rank, scene.disturbance * std::cos(phase));
  const auto others =
      throw_speeds(scene, Wall::lower, rank, scene.disturbance * std::cos(phase + later));
  speeds.insert(speeds.end(), others.begin(), others.end());
  if (std::ssize(speeds) < rank) return 0;
  std::nth_element(speeds.begin(), speeds.begin() + (rank - 1), speeds.end(), std::greater<>());
  return speeds[static_cast<std::size_t>(rank - 1)];
}

}  // namespace

std::optional<double> throw_border(const Scene& scene, int at_most, Louder louder, double fastest) {
  const auto margin = [&](double omega) {
    Scene there = scene;
    there.omega = omega;
    const double later = pi * scene.disturbance_frequency / omega;  // half a turn
    const auto speed = [&](double phase) { return ranked_speed(there, at_most + 1, phase, later); };
    if (scene.disturbance == 0) return speed(0) - scene.counting_limit;
    if (louder == Louder::some) {  // one of the throws is loudest
      return std::max(speed(0), speed(pi - later)) - scene.counting_limit;
    }
    // Both throws are equally loud, for they have the same steady force.
    const double phase = (pi - later) / 2;
    return std::min(speed(phase), speed(phase + pi)) - scene.counting_limit;
  };
  const double held =
      scene.friction * scene.normal_force - std::abs(scene.pull) - std::abs(scene.disturbance);
  double low = std::max(1e-3, std::sqrt(std::max(0.0, held) / amplitude_of(scene)));
  if (margin(low) >= 0) return low;
  while (low < fastest) {
    const double high = std::min(fastest, low * 1.4);
    if (margin(high) > 0) return zero_of(margin, low, high);
    low = high;
  }
  return std::nullopt;
}

}  // namespace ricochet::carrier_track::inline paper
