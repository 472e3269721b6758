#include "problems/carrier_track/regimes/border_curve.h"

#include <cmath>
#include <span>
#include <stdexcept>

#include "problems/carrier_track/regimes/orbit_map.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr double converged = 1e-12;     // relative change of the speed
constexpr double farthest = 0.1;        // relative change of the speed in a step
constexpr double shortest_part = 1e-6;  // share of the way asked for
constexpr int iterations = 8;

}  // namespace

BorderCurve::BorderCurve(const Border<SteadyMotion>& border, const std::string& constant)
    : key_(constant), rank_(border.before.collisions + 1), motion_(border.before) {
  if (border.kind != RegimeEnd::counting_limit || border.after.collisions < rank_) {
    throw std::invalid_argument("a border is followed where an impact starts to count");
  }
  const auto start = solved(constant_named(motion_.orbit, key_), border.omega, motion_);
  if (!start) throw std::invalid_argument("the border has no derivative");
  here_ = *start;
}

std::optional<BorderPoint> BorderCurve::solved(double constant, double omega,
                                               SteadyMotion& motion) const {
  const Signature kind = signature_of(motion);
  Scene scene = motion.orbit;
  set_constant(scene, key_, constant);
  for (int i = 0; i < iterations; ++i) {
    SteadyMotion next = followed(motion, at_speed(scene, omega));
    if (!signature_of(next).same_kind(kind)) return std::nullopt;
    const std::optional<std::size_t> place = place_of_rank(next, rank_);
    if (!place) return std::nullopt;
    const OrbitMap map = map_of(next.orbit, next.rest, std::span(&key_, 1));
    if (*place >= map.speeds.size()) return std::nullopt;
    const AlongOrbit along(map, next.rest);
    const OrbitMap::Number& speed = map.speeds[*place];
    const double rise = along(speed, OrbitMap::omega_index);
    const double limit_rise = key_ == "counting_limit" ? 1 : 0;
    const double step = (speed.a - scene.counting_limit) / rise;
    const double slope = -(along(speed, OrbitMap::constant_index) - limit_rise) / rise;
    motion = next;
    if (std::abs(step) <= converged * omega) return BorderPoint{constant, omega, slope};
    omega -= step;
    if (!(omega > 0) || !std::isfinite(omega)) return std::nullopt;
  }
  return std::nullopt;
}

bool BorderCurve::follow_to(double constant) {
  const double way = constant - here_.constant;
  double step = way;
  while (here_.constant != constant) {
    if (std::abs(step) < shortest_part * std::abs(way)) return false;
    const bool last = std::abs(step) >= std::abs(constant - here_.constant);
    const double there = last ? constant : here_.constant + step;
    const double guess = here_.omega + here_.slope * (there - here_.constant);
    SteadyMotion motion = motion_;
    const bool near = std::abs(guess / here_.omega - 1) < farthest;
    const auto point = near ? solved(there, guess, motion) : std::nullopt;
    if (!point || std::abs(point->omega / guess - 1) > farthest) {
      step /= 2;
      continue;
    }
    here_ = *point;
    motion_ = motion;
    step *= 2;
  }
  return true;
}

}  // namespace ricochet::carrier_track::inline regimes
