#include "problems/carrier_track/check/random_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "problems/carrier_track/check/oracle.h"
#include "ricochet/machine.h"
#include "src/core/instance.h"

namespace ricochet::carrier_track::inline oracle {

Scene RandomScenes::next() {
  Scene scene;
  scene.mass = within(0.5, 2.0);
  scene.wall_lower = chance(0.5) ? 0.0 : within(-2e-3, 1e-3);
  const double gap = log_within(0.2e-3, 5e-3);
  scene.wall_upper = scene.wall_lower + gap;
  scene.restitution_lower = restitution();
  scene.restitution_upper = chance(0.5) ? scene.restitution_lower : restitution();
  scene.friction = chance(0.3) ? 0.0 : within(0.0, 0.5);
  scene.normal_force = within(0.0, 3.0);
  scene.pull = chance(0.2) ? 0.0 : within(-1.5, 1.5);
  scene.pull_rotates = chance(0.3);
  scene.omega = log_within(0.5, 20.0);
  scene.centrifugal = static_cast<Centrifugal>(random_() % 3);
  const double square = scene.omega * scene.omega;
  scene.centrifugal_mass_radius = chance(0.2) ? 0.0 : within(0.0, 2.0) / square;
  scene.slider_mass_radius = chance(0.5) ? 0.0 : within(0.0, 1.0) / square;
  scene.phase = within(-4.0, 4.0);
  scene.disturbance = chance(0.4) ? 0.0 : within(-1.0, 1.0);
  scene.disturbance_frequency = log_within(0.3, 40.0);
  scene.start_position = scene.wall_lower + gap * share_of_gap();
  scene.start_velocity = chance(0.3) ? 0.0 : within(-0.1, 0.1);
  if (chance(0.4)) {
    scene.window = Seconds{within(0.3, 2.0)};
  } else {
    scene.window = Revolutions{within(0.3, 2.0) * scene.omega / 6.28};
  }
  if (chance(0.1)) scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.counting_limit = log_within(1e-3, 2e-2);
  const std::uint64_t draw = phases_();
  if (draw % 2 == 0) scene.pull_phase = angle();
  if (draw / 2 % 2 == 0) scene.disturbance_phase = angle();
  scene.contact_friction = draw / 4 % 5 == 0;
  return scene;
}

Scene RandomScenes::next_planar() {
  Scene scene = next();
  scene.fidelity = Fidelity::planar;
  scene.contact_friction = false;
  Across<double>& y = scene.across.emplace();
  y.pull = scene.pull_rotates || chance(0.2) ? 0.0 : within(-1.5, 1.5);
  y.wall_lower = chance(0.5) ? 0.0 : within(-2e-3, 1e-3);
  const double gap = log_within(0.2e-3, 5e-3);
  y.wall_upper = y.wall_lower + gap;
  y.restitution_lower = restitution();
  y.restitution_upper = chance(0.5) ? y.restitution_lower : restitution();
  y.start_position = y.wall_lower + gap * share_of_gap();
  y.start_velocity = chance(0.3) ? 0.0 : within(-0.1, 0.1);
  if (chance(0.1)) y.wall_upper = std::numeric_limits<double>::infinity();
  return scene;
}

double RandomScenes::within(double a, double b) {
  return a + (b - a) * static_cast<double>(random_() >> 11) * 0x1p-53;
}

double RandomScenes::angle() {
  return -4 + 8 * static_cast<double>(phases_() >> 11) * 0x1p-53;
}

double RandomScenes::log_within(double a, double b) {
  return a * std::pow(b / a, within(0, 1));
}

bool RandomScenes::chance(double probability) {
  return within(0, 1) < probability;
}

int RandomScenes::below(int limit) {
  return static_cast<int>(random_() % static_cast<std::uint64_t>(limit));
}

double RandomScenes::restitution() {
  switch (random_() % 6) {
    case 0:
      return 0.0;
    case 1:
      return 0.1;
    case 2:
      return 0.9;
    case 3:
      return 1.0;
    default:
      return within(0.0, 1.0);
  }
}

double RandomScenes::share_of_gap() {
  switch (random_() % 6) {
    case 0:
      return 0.0;
    case 1:
      return 1.0;
    default:
      return within(0.0, 1.0);
  }
}

namespace {

constexpr int draws =
    1000;  // attempts at a scene with the required summit or impact; far more than needed

// In the order of Hostility.
constexpr std::array<std::string_view, 13> names = {
    "none",          "graze",      "counting limit", "restitution", "friction limit",
    "start on wall", "cancelling", "slow plate",     "fast plate",  "open above",
    "no pull",       "slow limit", "maxima"};

/// +-10^-k, k = 3..17.
double closeness(RandomScenes& random) {
  const double size = std::pow(10.0, -(3 + random.below(15)));
  return random.chance(0.5) ? size : -size;
}

double scaled(long double value, double closeness) {
  return static_cast<double>(value * (1 + static_cast<long double>(closeness)));
}

/// The same forces with a plate of another speed, over the same time.
void turn_at(Scene& scene, double omega) {
  const double scale = (scene.omega / omega) * (scene.omega / omega);
  scene.window =
      Seconds{std::min(2.0, std::holds_alternative<Seconds>(scene.window)
                                ? std::get<Seconds>(scene.window).count
                                : std::get<Revolutions>(scene.window).count * 6.28 / scene.omega)};
  scene.centrifugal_mass_radius *= scale;
  scene.slider_mass_radius *= scale;
  scene.omega = omega;
}

/// Puts the wall near a summit above all earlier ones, so that the motion before it is free.
HostileScene graze(RandomScenes& random) {
  for (int i = 0; i < draws; ++i) {
    HostileScene result{Hostility::graze, closeness(random), random.next()};
    Scene& scene = result.scene;
    scene.start_position -= scene.wall_lower;  // a double resolves the closest walls only from 0
    scene.wall_lower = 0;
    scene.start_position *= random.within(0, 1);
    scene.wall_upper = std::numeric_limits<double>::infinity();
    std::vector<long double> records;
    long double highest = scene.start_position;
    const OracleRun free = oracle_run(scene);
    if (!free.finished) continue;
    for (const Summit& summit : free.summits) {
      if (summit.height > highest) records.push_back(highest = summit.height);
    }
    // A clearance below a micrometre is not used.
    if (records.empty() || records.back() < 1e-6L) continue;
    const long double height =
        records[static_cast<std::size_t>(random.below(static_cast<int>(records.size())))];
    scene.wall_upper = scaled(height, result.closeness);
    if (height > 1e-6L && scene.wall_upper > scene.start_position) return result;
  }
  throw std::logic_error("no free path with a summit");
}

HostileScene counting_limit(RandomScenes& random) {
  for (int i = 0; i < draws; ++i) {
    HostileScene result{Hostility::counting_limit, closeness(random), random.next()};
    OracleRun run = oracle_run(result.scene);
    if (!run.finished) continue;
    std::vector<Impact>& impacts = run.impacts;
    impacts.erase(std::remove_if(impacts.begin(), impacts.end(),
                                 [](const Impact& impact) { return impact.speed < 1e-4; }),
                  impacts.end());
    if (impacts.empty()) continue;
    const auto chosen = static_cast<std::size_t>(random.below(static_cast<int>(impacts.size())));
    result.scene.counting_limit = scaled(impacts[chosen].speed, result.closeness);
    return result;
  }
  throw std::logic_error("no scene with an impact");
}

HostileScene friction_limit(RandomScenes& random) {
  HostileScene result{Hostility::friction_limit, closeness(random), random.next()};
  Scene& scene = result.scene;
  // Only a pull and the disturbance: the largest magnitude of their sum is that of the amplitudes.
  scene.centrifugal_mass_radius = scene.slider_mass_radius = 0;
  scene.pull_rotates = false;
  scene.disturbance = random.within(0.1, 1.0) * (scene.pull > 0 ? -1 : 1);
  scene.friction = random.within(0.1, 0.5);
  const long double force = std::abs(static_cast<long double>(scene.pull)) +
                            std::abs(static_cast<long double>(scene.disturbance));
  scene.normal_force = scaled(force / scene.friction, result.closeness);
  return result;
}

void cancel(RandomScenes& random, Scene& scene) {
  scene.centrifugal = Centrifugal::projected;
  scene.slider_mass_radius = 0;
  scene.pull_rotates = false;
  scene.phase = 0;
  scene.centrifugal_mass_radius = random.within(0.2, 2.0) / (scene.omega * scene.omega);
  const double amplitude = scene.centrifugal_mass_radius * scene.omega * scene.omega;
  scene.disturbance = -scaled(amplitude, closeness(random));
  scene.disturbance_frequency = scaled(scene.omega, closeness(random));
  if (random.chance(0.5)) scene.pull = 0;
  if (random.chance(0.5)) scene.friction = 0;
}

/// Handles the hostilities that do not need the scene's path.
void make_hostile(Hostility hostility, RandomScenes& random, Scene& scene) {
  const auto restitution = [&] {
    const int which = random.below(3);
    return which < 2 ? static_cast<double>(which) : 1 - std::abs(closeness(random));
  };
  switch (hostility) {
    case Hostility::restitution:
      scene.restitution_lower = restitution();
      scene.restitution_upper = restitution();
      break;
    case Hostility::start_on_wall:
      scene.start_velocity = 0;
      scene.start_position =
          random.chance(0.5) || std::isinf(scene.wall_upper) ? scene.wall_lower : scene.wall_upper;
      break;
    case Hostility::cancelling:
      cancel(random, scene);
      break;
    case Hostility::slow_plate:
      turn_at(scene, random.log_within(1e-6, 1e-2));
      break;
    case Hostility::fast_plate:
      turn_at(scene, random.log_within(1e2, 1e3));
      break;
    case Hostility::open_above:
      scene.wall_upper = std::numeric_limits<double>::infinity();
      break;
    case Hostility::no_pull:
      scene.pull = 0;
      break;
    case Hostility::slow_limit:
      scene.counting_limit = random.log_within(1e-15, 1e-9);
      break;
    case Hostility::maxima:
      scene.rule = CountRule::peaks;
      scene.peak_high = random.log_within(1e-4, 5e-3);
      scene.peak_low = random.log_within(1e-5, 3e-3);
      break;
    default:
      break;
  }
}

}  // namespace

const std::vector<Hostility>& all_hostilities() {
  static const std::vector<Hostility> list = [] {
    std::vector<Hostility> all;
    for (std::size_t k = 0; k < names.size(); ++k) all.push_back(static_cast<Hostility>(k));
    return all;
  }();
  return list;
}

std::string_view name_of(Hostility hostility) {
  return names.at(static_cast<std::size_t>(hostility));
}

HostileScene hostile_scene(int seed, int index) {
  const auto turn = static_cast<std::size_t>(index) % all_hostilities().size();
  return hostile_scene(all_hostilities()[turn], seed, index);
}

HostileScene hostile_scene(Hostility hostility, int seed, int index) {
  RandomScenes random(seed_of("hostile scenes", name_of(hostility), index, seed));
  switch (hostility) {
    case Hostility::graze:
      return graze(random);
    case Hostility::counting_limit:
      return counting_limit(random);
    case Hostility::friction_limit:
      return friction_limit(random);
    default:
      HostileScene result{hostility, 0, random.next()};
      make_hostile(hostility, random, result.scene);
      return result;
  }
}

}  // namespace ricochet::carrier_track::inline oracle
