#include "problems/carrier_track/problems/machine.h"

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/problems/default_machine.h"
#include "problems/carrier_track/problems/quiet_rule.h"
#include "ricochet/error.h"

namespace ricochet::carrier_track::inline problems {

Machine machine_of(const Case& a_case, const Scene& constants) {
  const Scene scene = scene_of(a_case, constants);
  return {a_case.id, scene, quiet_limit(quiet_count(scene, a_case.claim, ScanOptions{})),
          a_case.claim.threshold, ""};
}

Machine machine_of(const Scene& scene, const std::string& origin) {
  if (!scene.profile.empty()) {
    throw InputError(
        origin +
        ": scene.omega is a profile: must be a number, because a threshold is of constant speeds");
  }
  const QuietRule rule = quiet_rule_of(scene, ScanOptions{}.step);
  return {"scene", scene, rule.limit, rule.threshold, ""};
}

std::vector<Machine> all_machines() {
  std::vector<Machine> machines;
  for (const Case& a_case : all_cases()) {
    machines.push_back(machine_of(a_case, default_machine()));
    machines.back().default_hash = default_machine_hash();
  }
  return machines;
}

}  // namespace ricochet::carrier_track::inline problems
