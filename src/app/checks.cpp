#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include "problems/carrier_track/check/oracle.h"
#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "src/app/command_line.h"
#include "src/app/other_program.h"
#include "src/core/names.h"
#include "src/report/drawing.h"
#include "src/report/json.h"
#include "src/report/table.h"
#include "src/studies/simulators/study.h"
#include "src/studies/verification/verification.h"

namespace ricochet::cli {

namespace {

using namespace carrier_track;
using report::Json;

struct VerifyOptions {
  studies::VerificationOptions verification;
  std::optional<int> scene_index;  ///< of a scene to show instead
  bool json = false;
};

/// Prints a scene as TOML or JSON, with the impacts of the library and of the oracle.
void show_hostile_scene(int seed, int index, bool json) {
  if (index < 0) throw InputError(fmt::format("--scene-index {}: must be >= 0", index));
  const HostileScene hostile = hostile_scene(seed, index);
  const OracleRun true_values = oracle_run(hostile.scene);
  const Recording recording = record(hostile.scene, 0.0, 0);
  if (json) {
    const Json shown = {{"hostility", carrier_track::name_of(hostile.hostility)},
                        {"closeness", hostile.closeness},
                        {"scene", write_scene(hostile.scene)},
                        {"count", recording.count},
                        {"certain", recording.certainty.certain},
                        {"oracle_count", true_values.count},
                        {"oracle_finished", true_values.finished},
                        {"impacts", json_rows_of(impact_table(recording.impacts))},
                        {"oracle_impacts", json_rows_of(impact_table(true_values.impacts))}};
    fmt::print("{}\n", shown.dump(2));
    return;
  }
  fmt::print("# {}, closeness {}: count {}, {}; oracle {}{}\n{}\n",
             carrier_track::name_of(hostile.hostility), hostile.closeness, recording.count,
             recording.certainty.certain ? "certain" : "uncertain", true_values.count,
             true_values.finished ? "" : ", broken off", write_scene(hostile.scene));
  for (const bool of_oracle : {false, true}) {
    fmt::print("# impacts of the {}\n", of_oracle ? "oracle" : "library");
    for (const Impact& i : of_oracle ? true_values.impacts : recording.impacts) {
      fmt::print("# {:.17g} s  {}  {:.17g} m/s\n", i.time, name_of(i.wall), i.speed);
    }
  }
}

int verify(const VerifyOptions& options, const std::string& folder) {
  if (options.scene_index) {
    show_hostile_scene(options.verification.seed, *options.scene_index, options.json);
    return 0;
  }
  studies::Finished finished =
      studies::run(studies::verification_study(options.verification), false, folder);
  const bool failed = finished.data["values"]["failed"].get<bool>();
  if (options.json) {
    const Json seconds = finished.data["made"]["seconds"];
    for (const char* key : {"report", "made"}) finished.data.erase(key);
    finished.data["seconds"] = seconds;
    fmt::print("{}\n", finished.data.dump(2));
  } else {
    fmt::print("{}", finished.epilogue);
  }
  report::require_none(finished.failures);
  return failed ? 1 : 0;
}

}  // namespace

void add_verify(CommandLine& line) {
  CLI::App* command = line.add("verify", summary_of("verify"),
                               "  ricochet verify --scenes 10000\n"
                               "  ricochet verify --scene-index 17");
  const auto options = std::make_shared<VerifyOptions>();
  add_value(command, "--scenes", options->verification.scenes,
            "Number of random and hostile scenes");
  add_value(command, "--seed", options->verification.seed, "Seed of the scenes");
  command->add_option("--scene-index", options->scene_index,
                      "Print this scene and both lists of impacts instead");
  add_format(command, options->json);
  const auto study = add_study_options(command, studies::verification_study(options->verification));
  line.on_call(command, [options, study] { return verify(*options, study->out); });
}

namespace {

namespace fs = std::filesystem;

using namespace studies::simulators;

struct SimulatorsOptions {
  std::optional<int> scenes;
  int seed = 1;
  std::string tools = "all";           ///< names or patterns, separated by commas; or none
  std::vector<std::string> own_tools;  ///< NAME=COMMAND each
  std::string levels = "loose,usual,tight";
  bool list = false;     ///< the tools, instead
  bool install = false;  ///< the tools, instead
  bool json = false;
};

/// The tools that come with ricochet.
std::vector<Tool> known_tools() {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  constexpr std::array places = {"../share/ricochet/simulators/tools.toml",
                                 "../../../../src/studies/simulators/tools/tools.toml"};
  for (const char* place : places) {
    const fs::path file = (program / place).lexically_normal();
    if (fs::exists(file)) return tools_in(file);
  }
  throw InputError(fmt::format("tools: {} is not there",
                               (program / places.front()).lexically_normal().string()));
}

std::vector<Tool> chosen_tools(const SimulatorsOptions& options) {
  std::vector<Tool> tools;
  if (options.tools != "none") tools = known_tools();
  if (options.tools != "none" && options.tools != "all") {
    std::vector<std::string> names;
    for (const Tool& tool : tools) names.push_back(tool.name);
    const std::vector<std::string> patterns = split_patterns(options.tools);
    require_fit(patterns, names, "--tools");
    std::erase_if(tools, [&](const Tool& tool) { return !fits_any(tool.name, patterns); });
  }
  for (const std::string& own : options.own_tools) {
    tools.push_back(own_tool(own));
    const auto same = std::ranges::count(tools, tools.back().name, &Tool::name);
    if (same > 1) throw InputError(fmt::format("--tool {}: the name is taken", own));
  }
  return tools;
}

studies::simulators::Level level_named(const std::string& name) {
  std::vector<std::string> names;
  for (const studies::simulators::Level level : all_levels) {
    names.push_back(name_of(level));
    if (names.back() == name) return level;
  }
  throw InputError(fmt::format("--levels {}: {}", name, what_instead(name, names)));
}

/// Throws InputError for an unknown tool or level.
studies::simulators::Plan plan_of(const SimulatorsOptions& options, const StudyOptions& study) {
  studies::simulators::Plan plan;
  plan.seed = options.seed;
  if (options.scenes) plan.scenes = plan.tool_scenes = *options.scenes;
  plan.levels.clear();
  plan.tools = chosen_tools(options);
  plan.needs_all = options.tools != "all";
  plan.folder = study.out;
  for (const std::string& name : split_patterns(options.levels)) {
    plan.levels.push_back(level_named(name));
  }
  std::ranges::sort(plan.levels);
  plan.levels.erase(std::unique(plan.levels.begin(), plan.levels.end()), plan.levels.end());
  return plan;
}

int compare_simulators(const SimulatorsOptions& options, const StudyOptions& study) {
  studies::Finished finished =
      studies::run(studies::simulators_study(plan_of(options, study)), study.quick, study.out);
  if (options.json) {
    for (const char* key : {"report", "made"}) finished.data.erase(key);
    fmt::print("{}\n", finished.data.dump(2));
  } else {
    fmt::print("{}", finished.epilogue);
  }
  report::require_none(finished.failures);
  return finished.data["values"]["lost"] == 0 ? 0 : 1;
}

int list_tools(const SimulatorsOptions& options, const StudyOptions& study) {
  Table table{"tools",
              {{"tool"}, {"title"}, {"kind"}, {"version"}, {"reason", "why it is missing"}}};
  for (const Tool& tool : chosen_tools(options)) {
    const FoundTool found = found_tool(tool, fs::path(study.out) / "drivers");
    const bool there = found.reason.empty();
    table.add(tool.name, tool.title, tool.kind, there ? value_of(found.version) : Value(),
              there ? Value() : value_of(found.reason));
  }
  print_table(options.json ? table : only(table, {"tool", "title", "version", "reason"}),
              options.json);
  return 0;
}

}  // namespace

void add_simulators(CommandLine& line) {
  CLI::App* command =
      line.add("simulators", summary_of("simulators"),
               "  ricochet simulators --quick\n"
               "  ricochet simulators --tools none --tool mine=./my-simulator --levels usual\n"
               "  ricochet simulators --tools 'scipy*,ode' --install-tools");
  const auto options = std::make_shared<SimulatorsOptions>();
  add_value(command, "--scenes", options->scenes,
            "Number of scenes, in place of 220 for ricochet and its methods and 44 for tools");
  add_value(command, "--seed", options->seed, "Seed of the scenes");
  add_value(command, "--tools", options->tools,
            "Names or patterns such as 'scipy*', all that are installed, or none");
  add_value(command, "--tool", options->own_tools,
            "A program of your own, too; docs/simulators.md says what it reads and writes",
            "NAME=COMMAND");
  add_value(command, "--levels", options->levels, "How exactly tools are asked to simulate");
  command->add_flag("--list-tools", options->list, "Instead: list the tools");
  command->add_flag("--install-tools", options->install,
                    "Instead: install the tools from Debian, and list them");
  add_format(command, options->json);
  const auto study = add_study_options(command, studies::simulators_study({}));
  line.on_call(command, [options, study] {
    if (options->install) install(chosen_tools(*options));
    if (options->install || options->list) return list_tools(*options, *study);
    return compare_simulators(*options, *study);
  });
}

}  // namespace ricochet::cli
