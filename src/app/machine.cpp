#include <fmt/format.h>

#include "embedded/machine_template.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/scene.h"
#include "src/app/command_line.h"
#include "src/app/scene_choice.h"
#include "src/core/toml.h"
#include "src/studies/machine/study.h"

namespace ricochet::cli {
namespace {

struct AdviseOptions {
  SceneChoice machine;
  QuietSpeedRequest asked;
  std::string out = "reports/advice";
};

int new_machine() {
  fmt::print("{}", embedded::machine_template);
  return 0;
}

/// The machine file as JSON, by table and key; what is infinite there is a text.
report::Json json_of(const carrier_track::Scene& scene) {
  const std::string text = carrier_track::write_scene(scene);
  return report::Json::parse(json_of_toml(parse_toml(text, "the machine")));
}

report::Json json_of(const carrier_track::Uncertainty& each) {
  return {{"key", each.key},
          {"value", each.value},
          {"plus_minus", each.plus_minus},
          {"unit", each.unit}};
}

int check_machine(const SceneChoice& choice, bool json) {
  const ChosenScene chosen = choose_scene(choice);
  if (json) {
    const report::Json data = {
        {"name", chosen.name},
        {"machine", json_of(chosen.scene)},
        {"uncertain", report::list_of(chosen.source.uncertainties,
                                      [](const auto& each) { return json_of(each); })},
        {"doubts", carrier_track::doubts_about(chosen.scene)}};
    fmt::print("{}\n", data.dump(2));
    return 0;
  }
  fmt::print("{}\n", carrier_track::write_scene(chosen.scene));
  for (const carrier_track::Uncertainty& each : chosen.source.uncertainties) {
    fmt::print("# {} = {} is uncertain by +-{}{}.\n", each.key, each.value, each.plus_minus,
               each.unit == "1" ? "" : " " + each.unit);
  }
  const std::vector<std::string> doubts = carrier_track::doubts_about(chosen.scene);
  for (const std::string& doubt : doubts) fmt::print("# Is it meant? {}\n", doubt);
  fmt::print("# {}: every field is in its range{}.\n", chosen.name,
             doubts.empty() ? ", and nothing looks like a slip"
                            : fmt::format(", {} to look at again", doubts.size()));
  return 0;
}

int advise_machine(const AdviseOptions& options) {
  const QuietSpeedRequest& asked = options.asked;
  const ChosenScene chosen = choose_scene(options.machine);
  carrier_track::check_constant_speed(chosen.scene, chosen.name);
  studies::Study study = studies::advice_study(
      {chosen.name, chosen.scene, options_of(asked), asked.tolerance / 100, chosen.source});
  study.compute = [compute = study.compute, seconds = asked.seconds](bool quick) {
    return limited(seconds, [&] { return compute(quick); });
  };
  const studies::Finished finished = studies::run(study, false, options.out);
  tell(finished);
  const report::Json& missing = finished.data["values"]["missing"];
  return missing.is_null() ? 0 : report_incomplete(asked.seconds, missing);
}

}  // namespace

void add_machine(CommandLine& line) {
  CLI::App* command = line.add("machine", "Describe your own machine: new, check FILE, advise FILE",
                               "  ricochet machine new > machine.toml\n"
                               "  ricochet machine check machine.toml\n"
                               "  ricochet machine advise machine.toml --tolerance 5");
  command->require_subcommand(1);
  CLI::App* fresh = line.add_part(command, "new", "Print a machine file to start from");
  line.on_call(fresh, new_machine);
  CLI::App* check =
      line.add_part(command, "check", "List every field with unit and range, and likely mistakes");
  const auto checked = std::make_shared<SceneChoice>();
  add_machine_file(check, *checked);
  const auto as_json = std::make_shared<bool>(false);
  add_format(check, *as_json);
  line.on_call(check, [checked, as_json] { return check_machine(*checked, *as_json); });
  CLI::App* advise =
      line.add_part(command, "advise", "Write a page: how fast it may turn, and what to change");
  const auto options = std::make_shared<AdviseOptions>();
  add_machine_file(advise, options->machine);
  add_value(advise, "--out", options->out, "Folder for the page", "FOLDER");
  options->asked.seconds = 300;  // for all parts of the page
  add_request(advise, options->asked);
  line.on_call(advise, [options] { return advise_machine(*options); });
}

}  // namespace ricochet::cli
