#include "src/experiment/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "src/core/names.h"
#include "src/core/toml.h"

namespace ricochet {

/// A node as TOML text.
inline std::string text_of_node(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

/// A table of a plan and its place in it.
class PlanTable {
 public:
  PlanTable(const toml::table& table, std::string place)
      : table_(table), place_(std::move(place)) {}

  /// Throws InputError for unknown keys.
  void check_keys(const std::vector<std::string>& known) const {
    for (const auto& [key, node] : table_) {
      const std::string name(key.str());
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      throw InputError(
          fmt::format("{}: there is no key {}; {}", place_, name, what_instead(name, known)));
    }
  }

  void need(std::string_view key) const {
    if (!table_.contains(key)) throw InputError(fmt::format("{}: {} is missing", place_, key));
  }

  void read(std::string_view key, std::string& target) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    if (!node->is_string()) refuse(key, *node, "a text");
    target = node->as_string()->get();
  }

  void read(std::string_view key, double& target) const {
    const toml::node* node = table_.get(key);
    if (node != nullptr) target = finite(key, *node);
  }

  /// Any finite number, or a non-empty text; required.
  void read(std::string_view key, OptionValue& target) const {
    target = number_or_text(key, *table_.get(key));
  }

  /// One of them or a list.
  void read(std::string_view key, std::vector<OptionValue>& target) const {
    read_list(key, target, [&](const toml::node& node) { return number_or_text(key, node); });
  }

  void read(std::string_view key, std::optional<bool>& target) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    if (!node->is_boolean()) refuse(key, *node, "true or false");
    target = node->as_boolean()->get();
  }

  void read(std::string_view key, bool& target) const {
    std::optional<bool> value;
    read(key, value);
    target = value.value_or(target);
  }

  void read(std::string_view key, int& target) const {
    const toml::node* node = table_.get(key);
    if (node != nullptr) target = static_cast<int>(whole(key, *node, 1, 1'000'000));
  }

  /// One text or a list of texts.
  void read(std::string_view key, std::vector<std::string>& target) const {
    read_list(key, target, [&](const toml::node& node) {
      if (!node.is_string() || node.as_string()->get().empty()) refuse(key, node, "texts");
      return node.as_string()->get();
    });
  }

  /// Texts, and whole numbers converted to text.
  void read_prices(std::string_view key, std::vector<std::string>& target) const {
    read_list(key, target, [&](const toml::node& node) -> std::string {
      if (node.is_integer()) return std::to_string(whole(key, node, 0, 1'000'000'000));
      if (node.is_string()) {
        const std::string& price = node.as_string()->get();
        if (price == "n" || price == "measured") return price;
      }
      refuse(key, node, "\"n\", \"measured\" or a whole number >= 0");
    });
  }

  void read(std::string_view key, std::vector<double>& target, bool may_be_zero) const {
    read_list(key, target, [&](const toml::node& node) { return finite(key, node, may_be_zero); });
  }

  void read(std::string_view key, std::vector<std::int64_t>& target) const {
    read_list(key, target,
              [&](const toml::node& node) { return whole(key, node, 1, 1'000'000'000'000); });
    if (!std::is_sorted(target.begin(), target.end(), std::less_equal<>())) {
      throw InputError(
          fmt::format("{}: {} = [{}]: must rise", place_, key, fmt::join(target, ", ")));
    }
  }

  [[noreturn]] void refuse(std::string_view key, const toml::node& node,
                           std::string_view allowed) const {
    throw InputError(
        fmt::format("{}: {} = {}: must be {}", place_, key, text_of_node(node), allowed));
  }

 private:
  double finite(std::string_view key, const toml::node& node, bool may_be_zero = false) const {
    const auto number = node.is_number() ? node.value<double>() : std::nullopt;
    if (!number || !std::isfinite(*number) || *number < 0 || (*number == 0 && !may_be_zero)) {
      refuse(key, node, may_be_zero ? "finite numbers >= 0" : "finite numbers > 0");
    }
    return *number + 0.0;  // no -0
  }

  OptionValue number_or_text(std::string_view key, const toml::node& node) const {
    const auto number = node.is_number() ? node.value<double>() : std::nullopt;
    if (number && std::isfinite(*number)) return *number + 0.0;  // no -0
    if (node.is_string() && !node.as_string()->get().empty()) return node.as_string()->get();
    refuse(key, node, "a finite number or a text");
  }

  std::int64_t whole(std::string_view key, const toml::node& node, std::int64_t least,
                     std::int64_t most) const {
    const auto number = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
    if (!number || *number < least || *number > most) {
      refuse(key, node, fmt::format("a whole number from {} to {}", least, most));
    }
    return *number;
  }

  template <class Entry, class Read>
  void read_list(std::string_view key, std::vector<Entry>& target, Read read) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    target.clear();
    if (const toml::array* list = node->as_array()) {
      for (const toml::node& entry : *list) target.push_back(read(entry));
      auto sorted = target;
      std::sort(sorted.begin(), sorted.end());
      if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
        refuse(key, *node, "a list without repetitions");
      }
    } else {
      target.push_back(read(*node));
    }
  }

  const toml::table& table_;
  std::string place_;
};

namespace {

MachineGrid grid_from(const toml::table& table, const std::string& place) {
  const PlanTable in(table, place);
  in.need("around");
  MachineGrid grid;
  in.read("around", grid.around);
  for (const auto& [key, node] : table) {
    if (key == "around") continue;
    std::vector<OptionValue>& levels = grid.levels[std::string(key.str())];
    in.read(key.str(), levels);
    if (levels.empty()) in.refuse(key.str(), node, "a list of one or more");
  }
  return grid;
}

PlanPart part_from(const toml::table& table, const std::string& place) {
  const PlanTable in(table, place);
  in.check_keys({"name", "problems", "machines", "drawn_machines", "relocated_optimum", "variables",
                 "constrained", "solvers", "formulations", "smoothings", "perturbations",
                 "gradient_prices", "budgets", "instances", "seeds"});
  for (const char* key : {"problems", "solvers", "budgets"}) in.need(key);
  PlanPart part;
  in.read("name", part.name);
  if (part.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos) {
    in.refuse("name", *table.get("name"), "small letters, digits and hyphens");
  }
  in.read("problems", part.problems);
  if (const toml::node* machines = table.get("machines")) {
    if (!machines->is_table()) in.refuse("machines", *machines, "a table");
    part.machines = grid_from(*machines->as_table(), place + ", machines");
  }
  in.read("drawn_machines", part.drawn_machines);
  if (part.drawn_machines > 0 && !part.machines.around.empty()) {
    in.refuse("drawn_machines", *table.get("drawn_machines"), "left out where machines are named");
  }
  in.read("relocated_optimum", part.relocated_optimum);
  const bool searched = part.drawn_machines > 0 || !part.machines.around.empty();
  if (part.relocated_optimum && searched) {
    in.refuse("relocated_optimum", *table.get("relocated_optimum"),
              "left out where machines are named or drawn");
  }
  std::vector<std::int64_t> variables = {part.least_variables, part.most_variables};
  in.read("variables", variables);
  if (variables.empty() || variables.size() > 2) {
    in.refuse("variables", *table.get("variables"), "a number, or [least, most]");
  }
  part.least_variables = variables.front();
  part.most_variables = variables.back();
  in.read("constrained", part.constrained);
  in.read("solvers", part.solvers);
  in.read("formulations", part.formulations);
  in.read("smoothings", part.smoothings, false);
  in.read("perturbations", part.perturbations);
  if (part.relocated_optimum && part.perturbations != PlanPart().perturbations) {
    in.refuse("perturbations", *table.get("perturbations"),
              "left out where relocated_optimum is true");
  }
  in.read_prices("gradient_prices", part.gradient_prices);
  in.read("budgets", part.budgets);
  in.read("instances", part.instances);
  in.read("seeds", part.seeds);
  for (const auto& [key, empty] :
       {std::pair("problems", part.problems.empty()), std::pair("solvers", part.solvers.empty()),
        std::pair("formulations", part.formulations.empty()),
        std::pair("perturbations", part.perturbations.empty()),
        std::pair("gradient_prices", part.gradient_prices.empty()),
        std::pair("budgets", part.budgets.empty())}) {
    if (empty) in.refuse(key, *table.get(key), "a list of one or more");
  }
  return part;
}

VariedSolver solver_from(const toml::table& table, const std::string& place) {
  const PlanTable in(table, place);
  in.check_keys({"name", "of", "options"});
  for (const char* key : {"name", "of", "options"}) in.need(key);
  VariedSolver solver;
  in.read("name", solver.name);
  in.read("of", solver.of);
  if (!is_name(solver.name)) in.refuse("name", *table.get("name"), names_in_words);
  const toml::table* options = table.get("options")->as_table();
  if (options == nullptr)
    in.refuse("options", *table.get("options"), "a table of numbers and texts");
  const PlanTable values(*options, place + ", options");
  for (const auto& [key, node] : *options) {
    values.read(key.str(), solver.options[std::string(key.str())]);
  }
  return solver;
}

/// The tables [[key]] of a plan, each with its place for messages.
template <class Read>
void each_table(const toml::table& file, const std::string& origin, const char* key, Read read) {
  const toml::array* tables = file.get(key)->as_array();
  if (tables == nullptr || !tables->is_array_of_tables() || tables->empty()) {
    PlanTable(file, origin)
        .refuse(key, *file.get(key), fmt::format("one or more tables [[{}]]", key));
  }
  int number = 0;
  for (const toml::node& node : *tables) {
    read(*node.as_table(),
         fmt::format("{}:{}, {} {}", origin, node.source().begin.line, key, ++number));
  }
}

/// Whether the scenes of a plan may be files.
enum class SceneFiles { refused, read };

PlanScene scene_from(const toml::table& table, const std::string& place, SceneFiles files) {
  const PlanTable in(table, place);
  in.check_keys({"name", "file", "text"});
  in.need("name");
  PlanScene scene;
  in.read("name", scene.name);
  if (!is_name(scene.name)) in.refuse("name", *table.get("name"), names_in_words);
  const toml::node* file = table.get("file");
  if (files == SceneFiles::refused && file != nullptr) {
    in.refuse("file", *file, "left out: a stored plan has the text");
  }
  if ((file != nullptr) == table.contains("text")) {
    throw InputError(place + ": must have one of file and text");
  }
  std::string path;
  in.read("file", path);
  in.read("text", scene.text);
  if (file != nullptr) scene.text = read_toml_text(path);
  parse_toml(scene.text, file != nullptr ? path : place);  // else a plan of it could not be read
  return scene;
}

/// Adds what another plan has to run, but for its name, first instance and limits.
void add_plan(Plan& plan, const Plan& other) {
  plan.solvers.insert(plan.solvers.end(), other.solvers.begin(), other.solvers.end());
  plan.scenes.insert(plan.scenes.end(), other.scenes.begin(), other.scenes.end());
  plan.parts.insert(plan.parts.end(), other.parts.begin(), other.parts.end());
}

/// Throws InputError if two scenes or named parts have one name. (Of solvers, the campaign says
/// it.)
template <class List>
void check_names(const List& list, const std::string& origin, const std::string& what) {
  std::set<std::string> names;
  int number = 0;
  for (const auto& one : list) {
    ++number;
    if (one.name.empty() || names.insert(one.name).second) continue;
    throw InputError(fmt::format("{}, {} {}: name = '{}': must be unlike that of another {}",
                                 origin, what, number, one.name, what));
  }
}

Plan plan_of(const toml::table& file, const std::string& origin, SceneFiles files,
             const PlanByName& included) {
  const PlanTable in(file, origin);
  in.check_keys({"name", "include", "first_instance", "limits", "solver", "scene", "part"});
  Plan plan;
  in.read("name", plan.name);
  in.read("first_instance", plan.first_instance);
  if (const toml::node* limits = file.get("limits")) {
    if (!limits->is_table()) in.refuse("limits", *limits, "a table");
    const PlanTable table(*limits->as_table(), origin + ", limits");
    table.check_keys({"seconds", "megabytes"});
    table.read("seconds", plan.limits.seconds);
    table.read("megabytes", plan.limits.megabytes);
  }
  if (file.contains("solver")) {
    each_table(file, origin, "solver", [&](const toml::table& table, const std::string& place) {
      plan.solvers.push_back(solver_from(table, place));
    });
  }
  if (file.contains("scene")) {
    each_table(file, origin, "scene", [&](const toml::table& table, const std::string& place) {
      plan.scenes.push_back(scene_from(table, place, files));
    });
  }
  std::vector<std::string> include;
  in.read("include", include);
  if (include.empty()) in.need("part");
  if (file.contains("part"))
    each_table(file, origin, "part", [&](const toml::table& table, const std::string& place) {
      plan.parts.push_back(part_from(table, place));
    });
  if (!include.empty() && !included) {
    in.refuse("include", *file.get("include"), "left out: this plan is stored, or included itself");
  }
  for (const std::string& name : include) add_plan(plan, included(name));
  check_names(plan.scenes, origin, "scene");
  check_names(plan.parts, origin, "part");
  return plan;
}

/// A text quoted for TOML on one line. The output of toml++ cannot always be read back.
std::string quoted(const std::string& text) {
  std::string basic = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') basic += '\\';
    basic += code < 0x20 || code == 0x7F ? fmt::format("\\u{:04X}", code) : std::string(1, c);
  }
  return basic + '"';
}

std::string toml_of(const OptionValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? toml_float(*number) : quoted(std::get<std::string>(value));
}

template <class List>
std::string list_of(const List& list) {
  std::vector<std::string> entries;
  for (const auto& entry : list) {
    using Entry = std::decay_t<decltype(entry)>;
    if constexpr (std::is_same_v<Entry, std::string>) {
      entries.push_back(quoted(entry));
    } else if constexpr (std::is_same_v<Entry, double>) {
      entries.push_back(toml_float(entry));
    } else {
      entries.push_back(std::to_string(entry));
    }
  }
  return fmt::format("[{}]", fmt::join(entries, ", "));
}

std::string text_of(const PlanPart& part) {
  std::string text = "\n[[part]]\n";
  const auto line = [&](const char* key, const std::string& value) {
    text += fmt::format("{} = {}\n", key, value);
  };
  const PlanPart usual;
  if (!part.name.empty()) line("name", quoted(part.name));
  line("problems", list_of(part.problems));
  if (!part.machines.around.empty()) {
    const MachineGrid& grid = part.machines;
    std::string inside = "around = " + quoted(grid.around);
    for (const auto& [key, values] : grid.levels) {
      std::vector<std::string> texts;
      for (const OptionValue& value : values) texts.push_back(toml_of(value));
      inside += fmt::format(", {} = [{}]", quoted(key), fmt::join(texts, ", "));
    }
    line("machines", "{ " + inside + " }");
  }
  if (part.drawn_machines > 0) line("drawn_machines", std::to_string(part.drawn_machines));
  if (part.relocated_optimum) line("relocated_optimum", "true");
  if (part.least_variables != usual.least_variables ||
      part.most_variables != usual.most_variables) {
    line("variables", part.least_variables == part.most_variables
                          ? std::to_string(part.least_variables)
                          : fmt::format("[{}, {}]", part.least_variables, part.most_variables));
  }
  if (part.constrained) line("constrained", *part.constrained ? "true" : "false");
  line("solvers", list_of(part.solvers));
  if (part.formulations != usual.formulations) line("formulations", list_of(part.formulations));
  if (!part.smoothings.empty()) line("smoothings", list_of(part.smoothings));
  if (part.perturbations != usual.perturbations) line("perturbations", list_of(part.perturbations));
  if (part.gradient_prices != usual.gradient_prices) {
    std::vector<std::string> prices;
    for (const std::string& price : part.gradient_prices) {
      prices.push_back(price == "n" || price == "measured" ? quoted(price) : price);
    }
    line("gradient_prices", fmt::format("[{}]", fmt::join(prices, ", ")));
  }
  line("budgets", list_of(part.budgets));
  line("instances", std::to_string(part.instances));
  if (part.seeds != usual.seeds) line("seeds", std::to_string(part.seeds));
  return text;
}

}  // namespace

Plan plan_from(const std::string& text, const std::string& origin, const PlanByName& included) {
  return plan_of(parse_toml(text, origin), origin, SceneFiles::refused, included);
}

Plan read_plan(const std::string& file, const PlanByName& included) {
  return plan_of(parse_toml_file(file == "-" ? "/dev/stdin" : file), file, SceneFiles::read,
                 included);
}

std::string text_of(const Plan& plan) {
  std::string text = fmt::format("name = {}\n", quoted(plan.name));
  if (plan.first_instance != 1) text += fmt::format("first_instance = {}\n", plan.first_instance);
  text += fmt::format("\n[limits]\nseconds = {}\nmegabytes = {}\n", toml_float(plan.limits.seconds),
                      toml_float(plan.limits.megabytes));
  for (const VariedSolver& solver : plan.solvers) {
    std::vector<std::string> options;
    for (const auto& [key, value] : solver.options) {
      options.push_back(fmt::format("{} = {}", quoted(key), toml_of(value)));
    }
    text += fmt::format("\n[[solver]]\nname = {}\nof = {}\noptions = {{ {} }}\n",
                        quoted(solver.name), quoted(solver.of), fmt::join(options, ", "));
  }
  for (const PlanScene& scene : plan.scenes) {
    text +=
        fmt::format("\n[[scene]]\nname = {}\ntext = {}\n", quoted(scene.name), quoted(scene.text));
  }
  for (const PlanPart& part : plan.parts) text += text_of(part);
  return text;
}

}  // namespace ricochet
