#include "problems/carrier_track/regimes/followed_motion.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "problems/carrier_track/regimes/orbit_map.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

/// Impacts this much slower than the counting limit, in logarithms, matter to no border nearby.
constexpr double far_below = 3;

/// The step of the speed, relative, that the slope of a margin is taken over where it has no exact
/// derivative.
constexpr double slope_step = 1e-5;

}  // namespace

std::optional<std::size_t> place_of_rank(const SteadyMotion& motion, int rank) {
  const std::vector<Impact>& impacts = motion.impacts;
  if (rank < 1 || rank > static_cast<int>(impacts.size())) return std::nullopt;
  std::vector<std::size_t> places(impacts.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  const auto nth = places.begin() + (rank - 1);
  std::nth_element(places.begin(), nth, places.end(), [&](std::size_t a, std::size_t b) {
    return impacts[a].speed > impacts[b].speed;
  });
  return *nth;
}

Signature signature_of(const SteadyMotion& motion) {
  const bool settled =
      motion.settled && (motion.rest != Rest::never || motion.impacts.empty() || motion.stable());
  if (!settled)
    return {0, 0, 0, false, false, true};  // whatever it does, it does not keep doing so
  return {motion.turns,
          motion.collisions,
          motion.collisions,
          true,
          motion.rest == Rest::in_the_gap || motion.rest == Rest::on_a_wall,
          motion.rest != Rest::always};
}

double rank_margin(const SteadyMotion& motion, int rank, Extreme /*extreme*/) {
  const std::optional<std::size_t> place = place_of_rank(motion, rank);
  if (!place) return lowest_margin;
  const double speed = motion.impacts[*place].speed;
  return std::max(std::log(speed / motion.orbit.counting_limit), lowest_margin);
}

Signature signature_of(const DisturbedMotion& motion) {
  if (!motion.settled) return {0, 0, 0, false, false, true};
  return {1, motion.least, motion.most, true, motion.moves, motion.moves};
}

DisturbedMotion followed(const DisturbedMotion& motion, double omega) {
  return disturbed_motion(at_speed(motion.machine, omega));
}

std::vector<Margin> margins_of(const SteadyMotion& motion) {
  std::vector<Margin> margins;
  if (!motion.settled || motion.rest == Rest::always) return margins;
  std::optional<OrbitMap> map;
  for (const int rank : {motion.collisions, motion.collisions + 1}) {
    const std::optional<std::size_t> place = place_of_rank(motion, rank);
    if (!place || rank_margin(motion, rank) < -far_below) continue;
    if (!map) map = map_of(motion.orbit, motion.rest);
    if (*place >= map->speeds.size()) continue;
    const auto& speed = map->speeds[*place];
    const double slope = AlongOrbit(*map, motion.rest)(speed, OrbitMap::omega_index);
    margins.push_back({rank_margin(motion, rank), slope / speed.a * motion.omega()});
  }
  return margins;
}

std::vector<Margin> margins_of(const DisturbedMotion& motion) {
  std::vector<Margin> margins;
  if (!motion.settled || !motion.moves) return margins;
  DisturbedMotion faster = motion;
  faster.machine = at_speed(motion.machine, motion.omega() * (1 + slope_step));
  for (DisturbedTurn& turn : faster.turns) turn = turn_at(faster, turn.phase);
  for (const Extreme extreme : {Extreme::least, Extreme::most}) {
    const int collisions = extreme == Extreme::least ? motion.least : motion.most;
    for (const int rank : {collisions, collisions + 1}) {
      const double here = sampled_margin(motion, rank, extreme);
      if (rank == 0 || here < -far_below) continue;
      margins.push_back({here, (sampled_margin(faster, rank, extreme) - here) / slope_step});
    }
  }
  return margins;
}

LongRun long_run_of(const SteadyMotion& motion) {
  return {motion.orbit, motion.collisions_per_turn(), motion.energy_per_turn(),
          motion.fastest_impact(), motion.share_at_rest};
}

LongRun long_run_of(const DisturbedMotion& motion) {
  LongRun result{motion.machine, 0, 0, 0, 0};
  const auto count = static_cast<double>(motion.turns.size());
  for (const DisturbedTurn& turn : motion.turns) {
    result.collisions_per_turn += turn.collisions / count;
    result.energy_per_turn += turn.energy / count;
    result.share_at_rest += turn.share_at_rest / count;
    if (!turn.speeds.empty()) {
      result.fastest_impact = std::max(result.fastest_impact, turn.speeds.front());
    }
  }
  return result;
}

}  // namespace ricochet::carrier_track::inline regimes
