#include "src/cli/verify.h"

#include <fmt/format.h>

#include "problems/carrier_track/check/oracle/hostile_scenes.h"
#include "problems/carrier_track/check/oracle/oracle.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/error.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"
#include "src/report/drawn_chart.h"
#include "src/report/json.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;
using report::Json;

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

}  // namespace

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

int verify(const studies::VerificationOptions& options, const std::string& folder, bool json) {
  studies::Finished finished = studies::run(studies::verification_study(options), false, folder);
  const bool failed = finished.data["failed"].get<bool>();
  if (json) {
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

}  // namespace ricochet::cli
