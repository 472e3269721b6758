#include "problems/carrier_track/questions/hard_machines.h"

#include <fmt/format.h>

#include <utility>

#include "embedded/hard_machines_text.h"
#include "problems/carrier_track/questions/gradient_cost.h"
#include "problems/carrier_track/questions/speed_range.h"
#include "problems/carrier_track/questions/top_speed.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "src/core/error.h"
#include "src/core/toml_text.h"

namespace ricochet::carrier_track::inline questions {
namespace {

/// What must be there of a table.
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
  hard.hardness = {entry.get<int>("pockets"),          entry.get<double>("first_end"),
                   entry.get<double>("last_begin"),    entry.get<double>("loud_before"),
                   entry.get<double>("bisection_gap"), entry.get<double>("bisection_share")};
  return hard;
}

}  // namespace

double pocket_share(const HardMachine& hard) {
  return (hard.best.point[0] - hard.hardness.last_begin) / (fastest_speed - slowest_speed);
}

HardMachines parse_hard_machines(const std::string& text, const std::string& origin) {
  const toml::table file = parse_toml(text, origin);
  HardMachines found{parse_fitted_reading(Entry(file, origin).get<std::string>("reading"), origin),
                     {}};
  for (const auto& [key, node] : file) {
    if (key == "reading") continue;
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
  text += fmt::format("\nreading = '''\n{}'''\n", write_fitted_reading(found.reading));
  for (const HardMachine& hard : found.machines) {
    const Hardness& h = hard.hardness;
    text += fmt::format("\n[{}]\naround = \"{}\"\ndraw = {}\nquiet_limit = {}\n", hard.machine.id,
                        hard.around, hard.draw, toml_float(hard.machine.quiet_limit));
    text += fmt::format("best_speed = {}\nprovenance = \"{}\"\n", toml_float(hard.best.point[0]),
                        hard.best.provenance);
    text +=
        fmt::format("pockets = {}\nfirst_end = {}\nlast_begin = {}\nloud_before = {}\n", h.pockets,
                    toml_float(h.first_end), toml_float(h.last_begin), toml_float(h.loud_before));
    text += fmt::format("bisection_gap = {}\nbisection_share = {}\nscene = '''\n{}'''\n",
                        toml_float(h.bisection_gap), toml_float(h.bisection_share),
                        write_scene(hard.machine.scene));
  }
  return text;
}

const HardMachines& found_hard_machines() {
  static const HardMachines found = parse_hard_machines(
      embedded::hard_machines_text, "problems/carrier_track/questions/hard_machines.toml");
  return found;
}

const std::vector<HardMachine>& hard_machines() {
  return found_hard_machines().machines;
}

Question hard_top_speed_question(const HardMachine& hard) {
  Question question = top_speed_question_of("hard-top-speed", hard.machine);
  question.machine = "hard-" + hard.machine.id;
  question.gradient_cost = gradient_cost(question.stated.dimension());
  question.stated = knowing(std::move(question.stated), hard.best);
  return question;
}

Family hard_family() {
  Family family{"hard-top-speed", {}};
  for (const HardMachine& hard : hard_machines()) {
    family.questions.push_back(hard_top_speed_question(hard));
  }
  return family;
}

}  // namespace ricochet::carrier_track::inline questions
