#include "problems/carrier_track/questions/machine.h"

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/core/error.h"

namespace ricochet::carrier_track::inline questions {

Machine machine_of(const Case& a_case, const Scene& reading) {
  const Scene scene = scene_of(a_case, reading);
  return {a_case.id, scene, quiet_limit(quiet_count(scene, a_case.claim, ScanOptions{})),
          a_case.claim.threshold, ""};
}

Machine machine_of(const Scene& scene, const std::string& origin) {
  if (!scene.profile.empty()) {
    throw InputError(
        origin +
        ": scene.omega is a profile: must be a number, because a threshold is of constant speeds");
  }
  const Score found = score(scene, Claim{}, ScanOptions{});
  return {"scene", scene, quiet_limit(found.quiet_count), found.threshold, ""};
}

std::vector<Machine> all_machines() {
  const FittedReading& reading = default_reading();
  std::vector<Machine> machines;
  for (const Case& a_case : all_cases()) {
    machines.push_back(machine_of(a_case, reading.scene));
    machines.back().reading = reading.name;
  }
  return machines;
}

}  // namespace ricochet::carrier_track::inline questions
