#include "problems/carrier_track/regimes/border_curve.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "ricochet/error.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr double converged = 1e-12;     // relative change of the speed
constexpr double farthest = 0.1;        // relative change of the speed in a step
constexpr double shortest_part = 1e-6;  // share of the way asked for
constexpr int iterations = 8;
constexpr int most_changes = 12;  // tries in a row that meet another motion, which may take long
constexpr double steep = 10;      // change of ln(speed) over the way, at a slope that turns back
constexpr double shortest_solved_part = 1e-4;  // the same for what is solved again
constexpr double beside_a_fold =
    1e-4;  // relative: there the orbit that vanishes is found with ease
constexpr double slope_difference =
    1e-5;  // relative, of the constant, for the slopes that are not exact

}  // namespace

BorderCurve::BorderCurve(const Border& border, const std::string& constant)
    : key_(constant),
      kind_(border.kind),
      before_(signature_of(border.before)),
      after_(signature_of(border.after)),
      rank_(std::min(border.before.collisions, border.after.collisions) + 1),
      onward_(border.after.omega() < border.before.omega() ? -1 : 1),
      motion_(border.before) {
  if (kind_ == RegimeEnd::irregular) {
    throw std::invalid_argument("the border of an irregular motion is no sharp one");
  }
  if (before_ == after_) throw std::invalid_argument("there is no border between equal motions");
  const auto start = solved(constant_named(motion_.orbit, key_), border.omega, motion_);
  if (!start) throw std::invalid_argument("the border has no derivative");
  here_ = *start;
}

Scene BorderCurve::machine_at(double constant) const {
  Scene scene = motion_.orbit;
  set_constant(scene, key_, constant);
  return scene;
}

std::optional<BorderPoint> BorderCurve::solved(double constant, double omega,
                                               SteadyMotion& motion) {
  if (kind_ == RegimeEnd::counting_limit) {
    SteadyMotion first = motion;
    if (const auto point = limit_passed(constant, omega, motion)) return point;
    // Where another impact becomes the one of that rank, Newton's method may go to and fro; and
    // where a body almost stays on a wall, dual numbers may round to another side than plain ones.
    if (end_ == CurveEnd::other_border) return std::nullopt;
    motion = std::move(first);
    const CurveEnd reason = end_;
    const auto point = solved_again(constant, omega, motion);
    if (!point) end_ = reason;
    return point;
  }
  if (kind_ == RegimeEnd::release && !before_.moves) return released(constant, omega, motion);
  return solved_again(constant, omega, motion);
}

std::optional<BorderPoint> BorderCurve::limit_passed(double constant, double omega,
                                                     SteadyMotion& motion) {
  const Scene scene = machine_at(constant);
  for (int i = 0; i < iterations; ++i) {
    SteadyMotion next = followed(motion, at_speed(scene, omega));
    end_ = CurveEnd::other_border;
    if (!signature_of(next).same_kind(before_)) return std::nullopt;
    end_ = CurveEnd::impact_missing;
    const std::optional<std::size_t> place = place_of_rank(next, rank_);
    if (!place) return std::nullopt;
    const OrbitMap map = map_of(next.orbit, next.rest, std::span(&key_, 1));
    if (*place >= map.speeds.size()) return std::nullopt;
    end_ = CurveEnd::not_found;
    const AlongOrbit along(map, next.rest);
    const OrbitMap::Number& speed = map.speeds[*place];
    const double rise = along(speed, OrbitMap::omega_index);
    const double limit_rise = key_ == "counting_limit" ? 1 : 0;
    const double step = (speed.a - scene.counting_limit) / rise;
    const double slope = (limit_rise - along(speed, OrbitMap::constant_index)) / rise;
    motion = next;
    if (std::abs(step) <= converged * omega) return BorderPoint{constant, omega, slope};
    omega -= step;
    if (!(omega > 0) || !std::isfinite(omega)) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<BorderPoint> BorderCurve::released(double constant, double omega,
                                                 SteadyMotion& motion) {
  const Scene scene = machine_at(constant);
  const Scene& still = motion.orbit;
  const double position = still.start_position == still.wall_upper
                              ? scene.wall_upper
                              : std::min(still.start_position, scene.wall_upper);
  end_ = CurveEnd::not_found;
  for (int i = 0; i < iterations; ++i) {
    const ReleaseSlopes margin = release_slopes(at_speed(scene, omega), position, key_);
    const double step = margin.value / margin.over_omega;
    if (!std::isfinite(step)) return std::nullopt;
    if (std::abs(step) <= converged * omega) {
      motion = followed(motion, at_speed(scene, omega * (1 - onward_ * converged)));
      return BorderPoint{constant, omega, (0 - margin.over_constant) / margin.over_omega};
    }
    omega -= step;
    if (!(omega > 0)) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<double> BorderCurve::border_near(double constant, double omega,
                                               SteadyMotion& motion) {
  const Scene scene = machine_at(constant);
  end_ = CurveEnd::other_border;
  if (kind_ == RegimeEnd::fold) {
    const SteadyMotion near =
        followed(motion, at_speed(scene, omega * (1 - onward_ * beside_a_fold)));
    if (!(signature_of(near) == before_)) return std::nullopt;
    motion = near;
    return fold_near(near);
  }
  for (const double reach : {1e-6, 1e-4, 1e-2}) {
    const SteadyMotion near = followed(motion, at_speed(scene, omega * (1 - onward_ * reach)));
    if (!(signature_of(near) == before_)) continue;
    const SteadyMotion far = followed(near, omega * (1 + onward_ * reach));
    if (signature_of(far) == before_) continue;
    const Border border = first_border(near, far);
    if (border.kind != kind_ || !(signature_of(border.after) == after_)) continue;
    motion = border.before;
    return border.omega;
  }
  return std::nullopt;
}

std::optional<BorderPoint> BorderCurve::solved_again(double constant, double omega,
                                                     SteadyMotion& motion) {
  const std::optional<double> here = border_near(constant, omega, motion);
  if (!here) return std::nullopt;
  const double step = slope_difference * std::max(std::abs(constant), 1e-9);
  SteadyMotion beside = motion;
  const std::optional<double> low = border_near(constant - step, *here, beside);
  beside = motion;
  const std::optional<double> high = border_near(constant + step, *here, beside);
  if (!low && !high) return std::nullopt;
  const double width = (low ? step : 0) + (high ? step : 0);
  return BorderPoint{constant, *here, (high.value_or(*here) - low.value_or(*here)) / width};
}

bool BorderCurve::follow_to(double constant) {
  const double way = constant - here_.constant;
  double step = way;
  const bool exact = kind_ == RegimeEnd::counting_limit || kind_ == RegimeEnd::release;
  const double shortest = (exact ? shortest_part : shortest_solved_part) * std::abs(way);
  CurveEnd obstacle = CurveEnd::range;
  int changes = 0;
  while (here_.constant != constant) {
    if (std::abs(step) < shortest || changes > most_changes) {
      const double rise = std::abs(here_.slope * way / here_.omega);
      end_ = obstacle != CurveEnd::other_border && rise > steep ? CurveEnd::fold_back : obstacle;
      return false;
    }
    const bool last = std::abs(step) >= std::abs(constant - here_.constant);
    const double there = last ? constant : here_.constant + step;
    const double guess = here_.omega + here_.slope * (there - here_.constant);
    SteadyMotion motion = motion_;
    const bool near = std::abs(guess / here_.omega - 1) < farthest;
    end_ = CurveEnd::not_found;
    const auto point = near ? solved(there, guess, motion) : std::nullopt;
    if (!point || std::abs(point->omega / guess - 1) > farthest) {
      obstacle = end_;
      if (obstacle == CurveEnd::other_border) ++changes;
      step /= 2;
      continue;
    }
    here_ = *point;
    motion_ = motion;
    changes = 0;
    step *= 2;
  }
  end_ = CurveEnd::range;
  return true;
}

std::string name_of(CurveEnd end) {
  switch (end) {
    case CurveEnd::range:
      return "range";
    case CurveEnd::fold_back:
      return "fold-back";
    case CurveEnd::other_border:
      return "other-border";
    case CurveEnd::impact_missing:
      return "impact-missing";
    case CurveEnd::speeds:
      return "speeds";
    case CurveEnd::not_sharp:
      return "not-sharp";
    case CurveEnd::not_found:
      return "not-found";
  }
  return "";
}

Border border_between(const Regime& slower, const Regime& faster) {
  return {slower.to, slower.ends_by, steady_motion(slower.last.orbit),
          steady_motion(faster.first.orbit)};
}

}  // namespace ricochet::carrier_track::inline regimes
