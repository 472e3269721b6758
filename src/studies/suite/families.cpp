#include <fmt/format.h>

#include <stdexcept>

#include "problems/carrier_track/scene/scene_file.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/classic/classic.h"
#include "problems/held_out/held_out.h"
#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "src/studies/paper/loss.h"
#include "src/studies/suite/suite.h"

namespace ricochet {
namespace {

constexpr double longest_threshold = 60;  // [s]

}  // namespace

std::vector<Family> suite_families(const std::string& scene_file,
                                   const std::vector<std::string>& settings) {
  if (!scene_file.empty()) {
    const carrier_track::Scene scene = carrier_track::read_scene_file(scene_file, settings).scene;
    // What is quiet for the machine is part of its problems.
    const TimeLimit limit(longest_threshold);
    try {
      return carrier_track::families_of({carrier_track::machine_of(scene, scene_file)});
    } catch (const TimeLimitReached&) {
      throw std::runtime_error(
          fmt::format("{}: its problems need its threshold, which is not known after {} s: see "
                      "`ricochet threshold`",
                      scene_file, longest_threshold));
    }
  }
  if (!settings.empty()) {
    throw InputError("--set " + settings.front() + ": changes a machine file: give --scene FILE");
  }
  std::vector<Family> families = all_families();
  families.push_back(carrier_track::calibration_family());
  families.push_back(classic::pathological_family());
  for (Family& family : held_out::families()) families.push_back(std::move(family));
  return families;
}

}  // namespace ricochet
