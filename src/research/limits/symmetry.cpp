#include "src/research/limits/symmetry.h"

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/problems/speed_range.h"
#include "ricochet/random.h"
#include "src/research/paper/calibration_problem.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

constexpr double lowest_speed = 0.5;  // [rad/s]

double& the(Constants& constants, Unknown open) {
  return constants[static_cast<std::size_t>(open)];
}

/// Of the part projected on x, (m r_c - the slider's) counts, and the slider's is not an unknown
/// parameter.
void scale_forces(Constants& constants, double factor, double centrifugal_factor) {
  the(constants, Unknown::pull) *= factor;
  the(constants, Unknown::normal_force) *= factor;
  double& mass_radius = the(constants, Unknown::centrifugal_mass_radius);
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
  for (const Unknown open :
       {Unknown::clearance, Unknown::start_velocity, Unknown::counting_limit}) {
    the(scaled, open) *= factor;
  }
  return scaled;
}

Constants scaled_in_time(const Constants& constants, double factor) {
  Constants scaled = constants;
  scale_forces(scaled, factor * factor, 1);
  for (const Unknown open : {Unknown::start_velocity, Unknown::counting_limit})
    the(scaled, open) *= factor;
  return scaled;
}

SymmetryChecks check_symmetries(const Interpretation& interpretation, double factor, int draws,
                                std::uint64_t seed) {
  SymmetryChecks checks{factor, {}, {}};
  const Parameterisation parameterisation = full_parameterisation(interpretation);
  Random random(seed);
  for (int draw = 0; draw < draws; ++draw) {
    Vector u(static_cast<Eigen::Index>(parameterisation.free.size()));
    for (double& share : u) share = uniform(random);
    const Constants constants = constants_at(parameterisation, u);
    const Constants larger = scaled_in_space(constants, factor);
    const Constants faster = scaled_in_time(constants, factor);
    const double omega = lowest_speed + (fastest_speed - lowest_speed) * uniform(random);
    for (const char* id : {"C1", "C2", "C3", "C4"}) {
      const Case a_case = find_case(id);
      const int count = count_at(scene_of(a_case, interpretation, constants), omega);
      compare(checks.space, count, count_at(scene_of(a_case, interpretation, larger), omega));
      compare(checks.time, count,
              count_at(scene_of(a_case, interpretation, faster), factor * omega));
    }
  }
  return checks;
}

}  // namespace ricochet::studies::limits
