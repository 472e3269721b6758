#include "src/studies/limits/symmetry.h"

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/questions/calibration.h"
#include "problems/carrier_track/questions/speed_range.h"
#include "src/core/random.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

constexpr double lowest_speed = 0.5;  // [rad/s]

double& the(Constants& constants, Open open) {
  return constants[static_cast<std::size_t>(open)];
}

/// Of what is projected on x, (m r_c - the slider's) counts, and the slider's is no open constant.
void scale_forces(Constants& constants, double factor, double centrifugal_factor) {
  the(constants, Open::pull) *= factor;
  the(constants, Open::normal_force) *= factor;
  double& mass_radius = the(constants, Open::centrifugal_mass_radius);
  mass_radius = slider_mass_radius + centrifugal_factor * (mass_radius - slider_mass_radius);
}

void compare(SymmetryCheck& check, int one, int other) {
  ++check.counts;
  check.alike += one == other ? 1 : 0;
}

}  // namespace

Constants scaled_in_space(const Constants& constants, double factor) {
  Constants scaled = constants;
  scale_forces(scaled, factor, factor);
  for (const Open open : {Open::clearance, Open::start_velocity, Open::slowest}) {
    the(scaled, open) *= factor;
  }
  return scaled;
}

Constants scaled_in_time(const Constants& constants, double factor) {
  Constants scaled = constants;
  scale_forces(scaled, factor * factor, 1);
  for (const Open open : {Open::start_velocity, Open::slowest}) the(scaled, open) *= factor;
  return scaled;
}

SymmetryChecks check_symmetries(const Reading& reading, double factor, int draws,
                                std::uint64_t seed) {
  SymmetryChecks checks{factor, {}, {}};
  const Freedom freedom = full_freedom(reading);
  Random random(seed);
  for (int draw = 0; draw < draws; ++draw) {
    Vector u(static_cast<Eigen::Index>(freedom.freed.size()));
    for (double& share : u) share = uniform(random);
    const Constants constants = constants_at(freedom, u);
    const Constants larger = scaled_in_space(constants, factor);
    const Constants faster = scaled_in_time(constants, factor);
    const double omega = lowest_speed + (fastest_speed - lowest_speed) * uniform(random);
    for (const char* id : {"C1", "C2", "C3", "C4"}) {
      const Case a_case = find_case(id);
      const int count = count_at(scene_of(a_case, reading, constants), omega);
      compare(checks.space, count, count_at(scene_of(a_case, reading, larger), omega));
      compare(checks.time, count, count_at(scene_of(a_case, reading, faster), factor * omega));
    }
  }
  return checks;
}

}  // namespace ricochet::studies::limits
