#include "src/experiment/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "src/core/fields.h"
#include "src/core/toml_fields.h"

namespace ricochet {

bool PlanPart::takes(std::int64_t variables, std::int64_t constraints) const {
  return least_variables <= variables && variables <= most_variables &&
         (!constrained || *constrained == (constraints > 0));
}

template <class Visit, IsOf<Limits>... L>
void visit_fields(const Visit& visit, L&... l) {
  using enum Presence;
  visit(Field{"seconds", "s", "of a run", positive_number, stated}, l.seconds...);
  visit(Field{"megabytes", "1", "of a run", positive_number, stated}, l.megabytes...);
}

template <class Visit, IsOf<VariedSolver>... S>
void visit_fields(const Visit& visit, S&... s) {
  using enum Presence;
  visit(Field{"name", "", "", {}, required}, Name{s.name}...);
  visit(Field{"of", "", "", {}, required}, s.of...);
  visit(Field{"options", "", "", {}, required}, s.options...);
}

template <class Visit, IsOf<MachineGrid>... M>
void visit_fields(const Visit& visit, M&... m) {
  visit(Field{"around", "", "", {}, Presence::required}, m.around...);
  visit(Field{other_keys, "", "", {}, Presence::optional, Entries::distinct}, m.levels...);
}

std::string toml_text(const MachineGrid& grid) {
  const std::string levels = toml_entries(grid.levels);
  return fmt::format("{{ around = {}{}{} }}", toml_text(grid.around), levels.empty() ? "" : ", ",
                     levels);
}

/// Numbers of variables: one, or [least, most].
template <class Number>
struct Variables {
  Number& least;
  Number& most;

  bool operator==(const Variables& other) const {
    return least == other.least && most == other.most;
  }
};
template <class Number>
Variables(Number&, Number&) -> Variables<Number>;

void read_value(const TomlValue& value, Variables<std::int64_t> target) {
  const toml::array* list = value.node.as_array();
  if (list != nullptr && (list->empty() || list->size() > 2)) {
    value.refuse("a number, or [least, most]");
  }
  std::vector<std::int64_t> ends = {target.least, target.most};
  read_value(value, ends);
  target.least = ends.front();
  target.most = ends.back();
}

std::string toml_text(Variables<const std::int64_t> value) {
  if (value.least == value.most) return toml_text(value.least);
  return toml_text(std::vector{value.least, value.most});
}

/// Prices of a gradient: texts, of which those that are numbers are written as such.
template <class Texts>
struct Prices {
  Texts& texts;

  bool operator==(const Prices& other) const { return texts == other.texts; }
};
template <class Texts>
Prices(Texts&) -> Prices<Texts>;

bool is_word_for_price(const std::string& price) {
  return price == "n" || price == "measured";
}

void read_value(const TomlValue& value, Prices<std::vector<std::string>> target) {
  read_list(value, target.texts, [](const TomlValue& entry, std::string& price) {
    if (entry.node.is_integer()) {
      std::int64_t evaluations = 0;
      read_value(entry, evaluations);
      price = std::to_string(evaluations);
      return;
    }
    if (entry.node.is_string()) price = entry.node.as_string()->get();
    if (!is_word_for_price(price)) entry.refuse("\"n\", \"measured\" or a whole number >= 0");
  });
}

std::string toml_text(Prices<const std::vector<std::string>> prices) {
  std::vector<std::string> entries;
  for (const std::string& price : prices.texts) {
    entries.push_back(is_word_for_price(price) ? toml_text(price) : price);
  }
  return fmt::format("[{}]", fmt::join(entries, ", "));
}

template <class Visit, IsOf<PlanPart>... P>
void visit_fields(const Visit& visit, P&... p) {
  using enum Presence;
  using enum Entries;
  const auto list = [](std::string_view key, Presence presence = optional) {
    return Field{key, "", "", {}, presence, distinct};
  };
  visit(Field{"name"}, p.name...);
  visit(list("problems", required), p.problems...);
  visit(Field{"machines"}, p.machines...);
  visit(Field{"drawn_machines", "1", "", whole_number(1)}, p.drawn_machines...);
  visit(Field{"relocated_optimum"}, p.relocated_optimum...);
  visit(Field{"variables", "1", "", whole_number(1, 1e12), optional, rising},
        Variables{p.least_variables, p.most_variables}...);
  visit(Field{"constrained"}, p.constrained...);
  visit(list("solvers", required), p.solvers...);
  visit(list("formulations"), p.formulations...);
  visit(Field{"smoothings", "1", "", positive_number, optional, distinct}, p.smoothings...);
  visit(list("perturbations"), p.perturbations...);
  visit(Field{"gradient_prices", "1", "", whole_number(0, 1e9), optional, distinct},
        Prices{p.gradient_prices}...);
  visit(Field{"budgets", "1", "", whole_number(1, 1e12), required, rising}, p.budgets...);
  visit(Field{"instances", "1", "", whole_number(1), stated}, p.instances...);
  visit(Field{"seeds", "1", "", whole_number(1)}, p.seeds...);
}

void check_fields(const TomlTable& in, const PlanPart& part) {
  if (part.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string::npos) {
    in.refuse("name", "small letters, digits and hyphens");
  }
  const bool machines = !part.machines.around.empty();
  if (part.drawn_machines > 0 && machines) {
    in.refuse("drawn_machines", "left out where machines are named");
  }
  if (part.relocated_optimum && (machines || part.drawn_machines > 0)) {
    in.refuse("relocated_optimum", "left out where machines are named or drawn");
  }
  if (part.relocated_optimum && part.perturbations != PlanPart().perturbations) {
    in.refuse("perturbations", "left out where relocated_optimum is true");
  }
}

namespace {

/// A [[scene]] of a plan file.
struct FileScene {
  std::string name;
  std::optional<std::string> file, text;
};

template <class Visit, IsOf<FileScene>... S>
void visit_fields(const Visit& visit, S&... s) {
  visit(Field{"name", "", "", {}, Presence::required}, Name{s.name}...);
  visit(Field{"file"}, s.file...);
  visit(Field{"text"}, s.text...);
}

void check_fields(const TomlTable& in, const FileScene& scene) {
  if (scene.file.has_value() == scene.text.has_value()) {
    throw InputError(in.place() + ": must have one of file and text");
  }
  if (scene.text) parse_toml(*scene.text, in.place());  // else a plan of it could not be read
}

/// A plan file.
struct PlanFile {
  Plan plan;
  std::vector<std::string> include = {};
  std::vector<FileScene> scenes = {};
};

template <class Visit, IsOf<PlanFile>... F>
void visit_fields(const Visit& visit, F&... f) {
  using enum Presence;
  visit(Field{"name", "", "", {}, stated}, f.plan.name...);
  visit(Field{"include", "", "", {}, optional, Entries::distinct}, f.include...);
  visit(Field{"first_instance", "1", "", whole_number(1)}, f.plan.first_instance...);
  visit(Field{"limits"}, f.plan.limits...);
  visit(Field{"solver"}, f.plan.solvers...);
  visit(Field{"scene"}, f.scenes...);
  visit(Field{"part"}, f.plan.parts...);
}

/// Whether the scenes of a plan may be files.
enum class SceneFiles { refused, read };

PlanScene scene_from(const FileScene& given, const std::string& place, SceneFiles files) {
  if (files == SceneFiles::refused && given.file) {
    throw InputError(fmt::format("{}: file = '{}': must be left out: a stored plan has the text",
                                 place, *given.file));
  }
  if (given.text) return {given.name, *given.text};
  const std::string text = read_toml_text(*given.file);
  parse_toml(text, *given.file);
  return {given.name, text};
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

Plan plan_of(const toml::table& text, const std::string& origin, SceneFiles files,
             const PlanByName& included) {
  const TomlTable in(&text, origin);
  PlanFile file;
  read_fields(in, file);
  Plan plan = std::move(file.plan);
  for (const FileScene& scene : file.scenes) {
    plan.scenes.push_back(
        scene_from(scene, fmt::format("{}, scene {}", origin, plan.scenes.size() + 1), files));
  }
  if (file.include.empty()) in.need("part");
  if (!file.include.empty() && !included) {
    in.refuse("include", "left out: this plan is stored, or included itself");
  }
  for (const std::string& name : file.include) add_plan(plan, included(name));
  check_names(plan.scenes, origin, "scene");
  check_names(plan.parts, origin, "part");
  return plan;
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
  PlanFile file{plan};
  for (const PlanScene& scene : plan.scenes) file.scenes.push_back({scene.name, {}, scene.text});
  return toml_of_fields(file);
}

}  // namespace ricochet
