#include "problems/carrier_track/regimes/followed_motion.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/regimes/orbit_map.h"
#include "problems/carrier_track/regimes/phase_margin.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

/// Impacts this much slower than the counting limit, in logarithms, matter to no border nearby.
constexpr double far_below = 3;

/// The step of the speed, relative, that the slope of a margin is taken over where it has no exact
/// derivative.
constexpr double slope_step = 1e-5;

/// A series of impacts ends in a rest if its last is this slow, relative to the counting limit.
constexpr double end_of_series = 1e-3;

constexpr double near_speeds = 0.2;  // of the logarithm

/// The impacts of a period that count.
std::vector<Impact> collisions_of(const SteadyMotion& motion) {
  std::vector<Impact> found;
  for (const Impact& impact : motion.impacts) {
    if (is_counted(impact.speed, motion.orbit.counting_limit)) found.push_back(impact);
  }
  return found;
}

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

double collisions_per_turn(const SteadyMotion& motion) {
  return motion.collisions_per_turn();
}

double collisions_per_turn(const DisturbedMotion& motion) {
  double sum = 0;
  for (const DisturbedTurn& turn : motion.turns) sum += turn.collisions;
  return sum / static_cast<double>(motion.turns.size());
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

bool is_near(const SteadyMotion& a, const SteadyMotion& b) {
  const std::vector<Impact> first = collisions_of(a);
  std::vector<Impact> second = collisions_of(b);
  if (first.size() != second.size()) return false;
  const auto alike = [](const Impact& x, const Impact& y) {
    return x.wall == y.wall && std::abs(std::log(x.speed / y.speed)) <= near_speeds;
  };
  // Each may start at another of its rests.
  for (std::size_t k = 0; k < second.size(); ++k) {
    if (std::equal(first.begin(), first.end(), second.begin(), alike)) return true;
    std::rotate(second.begin(), second.begin() + 1, second.end());
  }
  return second.empty();
}

bool is_near(const DisturbedMotion& /*a*/, const DisturbedMotion& /*b*/) {
  return true;
}

Margins margins_of(const SteadyMotion& motion) {
  Margins margins;
  if (!motion.settled || motion.rest == Rest::always || motion.impacts.empty()) return margins;
  const OrbitMap map = map_of(motion.orbit, motion.rest);
  const AlongOrbit along(map, motion.rest);
  const double limit = motion.orbit.counting_limit;
  std::size_t series = 0;
  std::size_t place = 0;
  const std::size_t size = std::min(motion.impacts.size(), map.speeds.size());
  for (std::size_t i = 0; i < size; ++i) {
    const Impact& impact = motion.impacts[i];
    const double value = std::log(impact.speed / limit);
    if (value > -far_below) {
      const auto& speed = map.speeds[i];
      margins.known.push_back(
          {value, along(speed, OrbitMap::omega_index) / speed.a * motion.omega(), series, place});
    }
    ++place;
    if (i + 1 == size || motion.impacts[i + 1].wall != impact.wall) {
      const bool rests = impact.speed < end_of_series * limit;
      margins.structure.push_back(2 * (rests ? 0 : place) + (impact.wall == Wall::upper ? 1 : 0));
      ++series;
      place = 0;
    }
  }
  return margins;
}

Margins margins_of(const DisturbedMotion& motion) {
  Margins margins;
  if (!motion.settled || !motion.moves) return margins;
  struct Watched {
    int rank;
    Extreme extreme;
    PhaseMargin margin;
  };
  std::vector<Watched> watched;
  std::vector<double> phases;
  for (const Extreme extreme : {Extreme::least, Extreme::most}) {
    const int collisions = extreme == Extreme::least ? motion.least : motion.most;
    for (const int rank : {collisions, collisions + 1}) {
      const PhaseMargin margin = sampled_margin(motion, rank, extreme);
      if (rank == 0 || margin.value < -far_below) continue;
      watched.push_back({rank, extreme, margin});
      phases.push_back(margin.phase);
    }
  }
  // Where a margin is extreme, it changes with the speed as it does at that phase.
  const Scene faster = at_speed(motion.machine, motion.omega() * (1 + slope_step));
  const std::vector<DisturbedTurn> turns = turns_at_phases(faster, phases, motion.turns_before);
  for (std::size_t i = 0; i < watched.size(); ++i) {
    const auto& [rank, extreme, margin] = watched[i];
    const auto here = std::find_if(motion.turns.begin(), motion.turns.end(),
                                   [&](const auto& turn) { return turn.phase == phases[i]; });
    const double rise = margin_of(faster, turns[i], rank) - margin_of(faster, *here, rank);
    margins.known.push_back({margin.value, rise / slope_step, i, 0});
  }
  margins.structure.push_back(margins.known.size());
  return margins;
}

LongRun long_run_of(const SteadyMotion& motion) {
  return {motion.orbit, motion.collisions_per_turn(), motion.energy_per_turn(),
          motion.fastest_impact(), motion.share_at_rest};
}

}  // namespace ricochet::carrier_track::inline regimes
