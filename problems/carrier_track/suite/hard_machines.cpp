#include "problems/carrier_track/suite/hard_machines.h"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "embedded/hard_machines_text.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/profile.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "src/core/toml_fields.h"

namespace ricochet::carrier_track::inline problems {

namespace {

/// A scene as the text of its own file, within another one.
template <class Text>
struct SceneText {
  Text& scene;

  bool operator==(const SceneText& other) const {
    return write_scene(scene) == write_scene(other.scene);
  }
};
template <class Text>
SceneText(Text&) -> SceneText<Text>;

void read_value(const TomlValue& value, SceneText<Scene> target) {
  std::string text;
  read_value(value, text);
  target.scene =
      parse_scene(text, fmt::format("{}: {}", value.in.place(), value.in.named(value.field.key)));
}

std::string toml_text(SceneText<const Scene> value) {
  return fmt::format("'''\n{}'''", write_scene(value.scene));
}

}  // namespace

template <class Visit, IsOf<HardMachine>... H>
void visit_fields(const Visit& visit, H&... h) {
  const auto text = [](std::string_view key) { return Field{key, "", "", {}, Presence::required}; };
  const auto number = [](std::string_view key, std::string_view unit, Range range = {}) {
    return Field{key, unit, "", range, Presence::required};
  };
  visit(text("around"), h.around...);
  visit(number("draw", "1", whole_number(0)), h.draw...);
  visit(number("quiet_limit", "1"), h.machine.quiet_limit...);
  visit(number("best_speed", "rad/s"), h.best.point[0]...);
  visit(text("provenance"), h.best.provenance...);
  visit(number("quiet_intervals", "1", whole_number(0)), h.hardness.quiet_intervals...);
  visit(number("first_end", "rad/s"), h.hardness.first_end...);
  visit(number("last_begin", "rad/s"), h.hardness.last_begin...);
  visit(number("loud_before", "rad/s"), h.hardness.loud_before...);
  visit(number("bisection_gap", "rad/s"), h.hardness.bisection_gap...);
  visit(number("bisection_share", "1"), h.hardness.bisection_share...);
  visit(text("scene"), SceneText{h.machine.scene}...);
}

namespace {

/// A file of hard machines, by their numbers.
struct HardMachinesFile {
  Scene constants;
  std::map<std::string, HardMachine> machines = {};
};

template <class Visit, IsOf<HardMachinesFile>... F>
void visit_fields(const Visit& visit, F&... f) {
  visit(Field{"constants", "", "", {}, Presence::required}, SceneText{f.constants}...);
  visit(Field{other_keys}, f.machines...);
}

}  // namespace

double quiet_interval_share(const HardMachine& hard) {
  return (hard.best.point[0] - hard.hardness.last_begin) / (fastest_speed - slowest_speed);
}

HardMachines parse_hard_machines(const std::string& text, const std::string& origin) {
  auto file = fields_from<HardMachinesFile>(text, origin);
  HardMachines found{file.constants, {}};
  for (auto& [id, hard] : file.machines) {
    hard.machine.id = id;
    hard.best.value = -hard.best.point[0];
    found.machines.push_back(std::move(hard));
  }
  return found;
}

std::string write_hard_machines(const HardMachines& found) {
  HardMachinesFile file{found.constants};
  for (const HardMachine& hard : found.machines) file.machines[hard.machine.id] = hard;
  return "# Machines that are quiet again far beyond their first loud speed, the hardest first: "
         "from\n"
         "# `ricochet best-values --hard-machines`. Speeds in rad/s; what each line means: "
         "hard_machines.h.\n\n" +
         toml_of_fields(file);
}

const HardMachines& found_hard_machines() {
  static const HardMachines found = parse_hard_machines(
      embedded::hard_machines_text, "problems/carrier_track/suite/hard_machines.toml");
  return found;
}

const std::vector<HardMachine>& hard_machines() {
  return found_hard_machines().machines;
}

Problem hard_top_speed_problem(const HardMachine& hard) {
  Problem problem = top_speed_problem_of("hard-top-speed", hard.machine);
  problem.machine = "hard-" + hard.machine.id;
  problem.gradient_cost = gradient_cost(problem.dimension());
  return knowing(std::move(problem), hard.best);
}

Family hard_family() {
  Family family{"hard-top-speed", {}};
  for (const HardMachine& hard : hard_machines()) {
    family.problems.push_back(hard_top_speed_problem(hard));
  }
  return family;
}

}  // namespace ricochet::carrier_track::inline problems
