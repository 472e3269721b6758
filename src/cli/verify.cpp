#include <fmt/format.h>

#include <optional>

#include "problems/carrier_track/check/oracle/hostile_scenes.h"
#include "problems/carrier_track/check/oracle/oracle.h"
#include "problems/carrier_track/check/verification/study.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/error.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"
#include "src/cli/commands.h"
#include "src/cli/other_program.h"
#include "src/cli/shared_options.h"
#include "src/report/drawn_chart.h"
#include "src/report/json.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;
using report::Json;

struct VerifyOptions {
  studies::VerificationOptions verification;
  std::optional<int> scene_index;  ///< of a scene to show instead
  bool json = false;
};

const char* name_of(Wall wall) {
  return wall == Wall::upper ? "upper" : "lower";
}

Json json_of(const std::vector<Impact>& impacts) {
  Json list = Json::array();
  for (const Impact& i : impacts) {
    list.push_back({{"time", i.time}, {"wall", name_of(i.wall)}, {"speed", i.speed}});
  }
  return list;
}

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
                        {"impacts", json_of(recording.impacts)},
                        {"oracle_impacts", json_of(true_values.impacts)}};
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
  const bool failed = finished.data["failed"].get<bool>();
  if (options.json) {
    const Json seconds = finished.data["made"]["seconds"];
    for (const char* key : {"report", "made", "failed"}) finished.data.erase(key);
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
  command
      ->add_option("--scenes", options->verification.scenes, "Number of random and hostile scenes")
      ->capture_default_str();
  command->add_option("--seed", options->verification.seed, "Seed of the scenes")
      ->capture_default_str();
  command->add_option("--scene-index", options->scene_index,
                      "Print this scene and both lists of impacts instead");
  add_format(command, options->json);
  const auto study = add_study_options(command, studies::verification_study(options->verification));
  line.on_call(command, [options, study] { return verify(*options, study->out); });
}

}  // namespace ricochet::cli
