#include "problems/carrier_track/suite/hard_machines.h"

#include <fmt/format.h>

#include <utility>

#include "embedded/hard_machines_text.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/profile.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/error.h"
#include "ricochet/scene.h"
#include "src/core/toml.h"

namespace ricochet::carrier_track::inline problems {

namespace {

/// Reads the required values of a table.
class Entry {
 public:
  Entry(const toml::table& table, std::string place) : table_(table), place_(std::move(place)) {}

  const std::string& place() const { return place_; }

  template <class Value>
  Value get(const char* key) const {
    const auto found = table_[key].value<Value>();
    if (!found) throw InputError(fmt::format("{}: {} is missing or not of its kind", place_, key));
    return *found;
  }

 private:
  const toml::table& table_;
  std::string place_;
};

HardMachine hard_machine_of(const std::string& id, const Entry& entry) {
  HardMachine hard;
  hard.around = entry.get<std::string>("around");
  hard.draw = entry.get<int>("draw");
  hard.machine.id = id;
  hard.machine.scene = parse_scene(entry.get<std::string>("scene"), entry.place());
  hard.machine.quiet_limit = entry.get<double>("quiet_limit");
  const auto speed = entry.get<double>("best_speed");
  hard.best = {-speed, Vector::Constant(1, speed), entry.get<std::string>("provenance")};
  hard.hardness = {entry.get<int>("quiet_intervals"),  entry.get<double>("first_end"),
                   entry.get<double>("last_begin"),    entry.get<double>("loud_before"),
                   entry.get<double>("bisection_gap"), entry.get<double>("bisection_share")};
  return hard;
}

}  // namespace

double quiet_interval_share(const HardMachine& hard) {
  return (hard.best.point[0] - hard.hardness.last_begin) / (fastest_speed - slowest_speed);
}

HardMachines parse_hard_machines(const std::string& text, const std::string& origin) {
  const toml::table file = parse_toml(text, origin);
  HardMachines found{parse_scene(Entry(file, origin).get<std::string>("constants"), origin), {}};
  for (const auto& [key, node] : file) {
    if (key == "constants") continue;
    const std::string id(key.str());
    const std::string place = fmt::format("{}: {}", origin, id);
    const toml::table* table = node.as_table();
    if (table == nullptr) throw InputError(place + ": must be a table");
    found.machines.push_back(hard_machine_of(id, Entry(*table, place)));
  }
  return found;
}

std::string write_hard_machines(const HardMachines& found) {
  std::string text =
      "# Machines that are quiet again far beyond their first loud speed, the hardest first: from\n"
      "# `ricochet best-values --hard-machines`. Speeds in rad/s; what each line means: "
      "hard_machines.h.\n";
  text += fmt::format("\nconstants = '''\n{}'''\n", write_scene(found.constants));
  for (const HardMachine& hard : found.machines) {
    const Hardness& h = hard.hardness;
    text += fmt::format("\n[{}]\naround = \"{}\"\ndraw = {}\nquiet_limit = {}\n", hard.machine.id,
                        hard.around, hard.draw, toml_float(hard.machine.quiet_limit));
    text += fmt::format("best_speed = {}\nprovenance = \"{}\"\n", toml_float(hard.best.point[0]),
                        hard.best.provenance);
    text += fmt::format("quiet_intervals = {}\nfirst_end = {}\nlast_begin = {}\nloud_before = {}\n",
                        h.quiet_intervals, toml_float(h.first_end), toml_float(h.last_begin),
                        toml_float(h.loud_before));
    text += fmt::format("bisection_gap = {}\nbisection_share = {}\nscene = '''\n{}'''\n",
                        toml_float(h.bisection_gap), toml_float(h.bisection_share),
                        write_scene(hard.machine.scene));
  }
  return text;
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
