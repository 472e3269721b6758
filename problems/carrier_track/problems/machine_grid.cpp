#include "problems/carrier_track/questions/machine_grid.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/carrier_track/questions/families.h"
#include "problems/carrier_track/scene/enum_names.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "src/core/error.h"

namespace ricochet::carrier_track::inline questions {
namespace {

constexpr std::array grid_fidelities = {Fidelity::impact, Fidelity::compliant, Fidelity::planar};

/// [rad/s] between speeds that are scanned at the level of compliant walls.
constexpr double coarse_step = 1e-2;

std::vector<double> levels_of(const std::vector<double>& named, double own) {
  return named.empty() ? std::vector{own} : named;
}

/// The levels named; one that is none where no level is.
std::vector<std::optional<Fidelity>> fidelities_of(const std::vector<std::string>& names) {
  if (names.empty()) return {std::nullopt};
  std::vector<std::optional<Fidelity>> levels;
  for (const std::string& wanted : names) {
    levels.emplace_back();
    for (const Fidelity level : grid_fidelities) {
      if (wanted == name_of(fidelity_names(), level)) levels.back() = level;
    }
    if (!levels.back()) {
      throw InputError(fmt::format(
          "machines, fidelity = {}: must be \"impact\", \"compliant\" or \"planar\"", wanted));
    }
  }
  return levels;
}

Scene at_fidelity(Scene scene, Fidelity level) {
  scene.fidelity = level;
  if (level == Fidelity::compliant) scene.contact_law = ContactLaw::exact_restitution;
  if (level == Fidelity::planar) {
    scene.contact_friction = false;  // of the walls across
    scene.across = Across<double>{scene.pull_rotates ? 0 : scene.pull,
                                  scene.wall_lower,
                                  scene.wall_upper,
                                  scene.restitution_lower,
                                  scene.restitution_upper,
                                  (scene.wall_lower + scene.wall_upper) / 2,
                                  0.0};
  }
  return scene;
}

Machine machine_in_grid(const std::string& id, const Scene& scene) {
  const bool coarse = scene.fidelity == Fidelity::compliant;
  const ScanOptions options = coarse ? ScanOptions{coarse_step, 1} : ScanOptions{};
  const Score found = score(scene, Claim{}, options);
  return {id, scene, quiet_limit(found.quiet_count), found.threshold, ""};
}

/// What families_of does not know.
void add_fidelity(Question& question, const std::vector<Machine>& machines) {
  for (const Machine& machine : machines) {
    if (machine.id != question.machine) continue;
    question.factors["fidelity"] = static_cast<double>(machine.scene.fidelity);
    if (machine.scene.fidelity == Fidelity::compliant) {
      question.scan_step = std::max(question.scan_step, coarse_step);
    }
  }
}

}  // namespace

std::vector<Family> grid_families(const std::string& around, const MachineLevels& levels) {
  const Case middle = find_case(around);
  std::vector<std::pair<std::string, Scene>> scenes;
  const auto fidelities = fidelities_of(levels.fidelity);
  for (const double r : levels_of(levels.restitution, middle.restitution)) {
    for (const double f : levels_of(levels.friction, middle.friction)) {
      for (const double d : levels_of(levels.disturbance, middle.disturbance)) {
        for (const auto& level : fidelities) {
          std::string id = fmt::format("{}-r{}-f{}-d{}", middle.id, r, f, d);
          Scene scene = scene_of({id, r, f, d, {}}, default_reading().scene);
          if (level) {
            id += fmt::format("-{}", name_of(fidelity_names(), *level));
            scene = at_fidelity(std::move(scene), *level);
          }
          check(scene, id);
          scenes.emplace_back(std::move(id), std::move(scene));
        }
      }
    }
  }
  std::vector<Machine> machines(scenes.size());
  tbb::parallel_for(std::size_t{0}, scenes.size(), [&](std::size_t k) {
    machines[k] = machine_in_grid(scenes[k].first, scenes[k].second);
  });
  std::vector<Family> families = families_of(machines);
  if (levels.fidelity.empty()) return families;
  for (Family& family : families) {
    for (Question& question : family.questions) add_fidelity(question, machines);
  }
  return families;
}

}  // namespace ricochet::carrier_track::inline questions
