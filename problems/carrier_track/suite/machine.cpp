#include "problems/carrier_track/suite/machine.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "embedded/default_machine_text.h"
#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/error.h"
#include "ricochet/random.h"
#include "ricochet/scene.h"
#include "src/core/instance.h"
#include "src/core/names.h"

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

namespace {

constexpr std::array grid_fidelities = {Fidelity::impact, Fidelity::compliant, Fidelity::planar};

/// [rad/s] between scanned speeds with compliant walls.
constexpr double coarse_step = 1e-2;

/// The levels of a number; nothing, for its own value, if none are named.
std::vector<std::optional<double>> levels_of(const MachineLevels& levels, const char* key) {
  const auto named = levels.find(key);
  if (named == levels.end()) return {std::nullopt};
  std::vector<std::optional<double>> numbers;
  for (const OptionValue& level : named->second) numbers.emplace_back(std::get<double>(level));
  return numbers;
}

/// The fidelities that are named; a single empty one if there are none.
std::vector<std::optional<Fidelity>> fidelities_of(const MachineLevels& all) {
  const auto named = all.find("fidelity");
  if (named == all.end()) return {std::nullopt};
  std::vector<std::optional<Fidelity>> levels;
  for (const OptionValue& wanted : named->second) {
    const auto level =
        std::find_if(grid_fidelities.begin(), grid_fidelities.end(), [&](Fidelity each) {
          return name_of(fidelity_names(), each) == std::get<std::string>(wanted);
        });
    if (level == grid_fidelities.end()) throw std::logic_error("a fidelity that is not allowed");
    levels.emplace_back(*level);
  }
  return levels;
}

Scene at_fidelity(Scene scene, Fidelity level) {
  scene.fidelity = level;
  if (level == Fidelity::compliant) scene.contact_law = ContactLaw::exact_restitution;
  if (level == Fidelity::planar) {
    scene.contact_friction = false;  // at the lateral walls
    if (scene.across) return scene;
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

/// Searches for the "quiet_limit" and, if it exists, the "threshold" of a machine.
Findings limits_of(const Scene& scene) {
  const QuietRule rule = quiet_rule_of(
      scene, scene.fidelity == Fidelity::compliant ? coarse_step : ScanOptions{}.step);
  Findings limits = {{"quiet_limit", rule.limit}};
  if (rule.threshold) limits["threshold"] = *rule.threshold;
  return limits;
}

/// A machine of the grid; its limits are searched for once.
class GridMachine {
 public:
  GridMachine(std::string id, Scene scene, bool names_fidelity)
      : machine_{std::move(id), std::move(scene), 0, std::nullopt, ""},
        names_fidelity_(names_fidelity) {}

  /// Its problems with these limits; with empty limits their values are not known to be right.
  std::vector<Family> families(const Findings& limits) const {
    Machine machine = machine_;
    if (limits.contains("quiet_limit")) machine.quiet_limit = limits.at("quiet_limit");
    if (limits.contains("threshold")) machine.threshold = limits.at("threshold");
    std::vector<Family> families = families_of({machine});
    for (Family& family : families) {
      std::erase_if(family.problems, [](const Problem& q) { return q.dimension() != 1; });
      for (Problem& problem : family.problems) add_fidelity(problem);
    }
    return families;
  }

  Problem problem(const std::string& name, const Findings& limits) const {
    for (const Family& family : families(limits)) {
      for (const Problem& problem : family.problems) {
        if (problem.name == name) return problem;
      }
    }
    throw std::logic_error(name + " is no problem of this machine");
  }

  Findings search(const std::string& name) {
    // Isolated: a thread that waits for its part of a scan must not start another search here.
    std::call_once(once_, [this] {
      tbb::this_task_arena::isolate([this] { limits_ = limits_of(machine_.scene); });
    });
    Findings found = scanned_best(problem(name, limits_));
    if (!found.empty()) found.insert(limits_.begin(), limits_.end());
    return found;
  }

 private:
  void add_fidelity(Problem& problem) const {
    if (names_fidelity_) {
      problem.factors["fidelity"] = static_cast<double>(machine_.scene.fidelity);
    }
    if (machine_.scene.fidelity == Fidelity::compliant) {
      problem.scan_step = std::max(problem.scan_step, coarse_step);
    }
  }

  Machine machine_;
  bool names_fidelity_;
  std::once_flag once_;
  Findings limits_;
};

/// What the machines of a grid are around: a case of the paper, or a machine of the user's.
struct Middle {
  std::string name;
  Scene scene;
  bool is_case;
};

Middle middle_of(const std::string& around, const std::string& text) {
  const std::vector<Case> cases = all_cases();
  if (text.empty()) {
    const Case middle = find_case(around);
    return {middle.id, scene_of(middle, default_machine()), true};
  }
  if (std::any_of(cases.begin(), cases.end(), [&](const Case& c) { return c.id == around; })) {
    throw InputError(
        fmt::format("scene {}: must not have the name of a case of the paper", around));
  }
  Scene scene = parse_scene(text, "scene " + around);
  check_constant_speed(scene, "scene " + around);
  return {around, std::move(scene), false};
}

/// Sets a number and adds it to the id. The ids of cases name all three numbers.
void set_level(const Middle& middle, const std::optional<double>& level, char letter,
               std::initializer_list<double*> targets, std::string& id) {
  if (level) {
    for (double* target : targets) *target = *level;
  }
  if (level || middle.is_case) id += fmt::format("-{}{}", letter, **targets.begin());
}

/// The machines of the grid.
std::vector<std::shared_ptr<GridMachine>> machines_of(const Middle& middle,
                                                      const MachineLevels& levels) {
  std::vector<std::shared_ptr<GridMachine>> machines;
  const auto fidelities = fidelities_of(levels);
  for (const auto& r : levels_of(levels, "restitution")) {
    for (const auto& f : levels_of(levels, "friction")) {
      for (const auto& d : levels_of(levels, "disturbance")) {
        for (const auto& level : fidelities) {
          std::string id = middle.name;
          Scene scene = middle.scene;
          set_level(middle, r, 'r', {&scene.restitution_lower, &scene.restitution_upper}, id);
          set_level(middle, f, 'f', {&scene.friction}, id);
          set_level(middle, d, 'd', {&scene.disturbance}, id);
          if (level) {
            id += fmt::format("-{}", name_of(fidelity_names(), *level));
            scene = at_fidelity(std::move(scene), *level);
          }
          check(scene, id);
          machines.push_back(
              std::make_shared<GridMachine>(std::move(id), std::move(scene), level.has_value()));
        }
      }
    }
  }
  return machines;
}

}  // namespace

std::map<std::string, std::vector<std::string>> machine_keys() {
  std::vector<std::string> fidelities;
  for (const Fidelity level : grid_fidelities) {
    fidelities.emplace_back(name_of(fidelity_names(), level));
  }
  return {{"restitution", {}}, {"friction", {}}, {"disturbance", {}}, {"fidelity", fidelities}};
}

std::vector<SearchedProblem> grid_problems(const std::string& around, const MachineLevels& levels,
                                           const std::string& scene) {
  std::vector<SearchedProblem> problems;
  for (const auto& machine : machines_of(middle_of(around, scene), levels)) {
    for (const Family& family : machine->families({})) {
      for (const Problem& problem : family.problems) {
        const std::string name = problem.name;
        problems.push_back({family.name, problem, [=] { return machine->search(name); },
                            [=](const Findings& found) {
                              return with_scanned_best(machine->problem(name, found), found);
                            }});
      }
    }
  }
  // In the suite's order of families.
  std::stable_sort(problems.begin(), problems.end(),
                   [](const auto& a, const auto& b) { return a.family < b.family; });
  return problems;
}

Machine drawn_machine(Machine machine, int number) {
  if (number < 0) throw std::invalid_argument(fmt::format("machine {}: must be >= 0", number));
  if (number == 0) return machine;
  Random random(seed_of(machine.id, "drawn machine", number, 0));
  for (const std::string& key : constants_of(machine.scene)) {
    const double change = drawn_tolerance * (2 * uniform(random) - 1);
    machine.scene = scaled(std::move(machine.scene), key, 1 + change);
  }
  machine.id += fmt::format("~{}", number);
  machine.default_hash.clear();
  return machine;
}

std::optional<SearchedProblem> drawn_problem(const Problem& problem, int number) {
  if (problem.dimension() != 1) return std::nullopt;
  static const std::vector<Machine> cases = all_machines();
  for (const Machine& machine : cases) {
    if (machine.id != problem.machine) continue;
    const Machine drawn = drawn_machine(machine, number);
    const std::string name = problem.name + drawn.id.substr(machine.id.size());
    for (const Family& family : families_of({drawn})) {
      for (const Problem& asked : family.problems) {
        if (asked.name != name) continue;
        return SearchedProblem{
            family.name, asked, [asked] { return scanned_best(asked); },
            [asked](const Findings& found) { return with_scanned_best(asked, found); }};
      }
    }
  }
  return std::nullopt;
}

const Scene& default_machine() {
  static const Scene machine = parse_scene(embedded::default_machine_text,
                                           "problems/carrier_track/suite/default_machine.toml");
  return machine;
}

const std::string& default_machine_hash() {
  static const std::string digits = [] {
    FnvHash hash;
    std::istringstream lines(write_scene(default_machine()));
    for (std::string line; std::getline(lines, line);) hash.add(line.substr(0, line.find("  #")));
    return fmt::format("{:016x}", hash.value());
  }();
  return digits;
}

}  // namespace ricochet::carrier_track::inline problems
