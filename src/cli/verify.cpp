#include "src/cli/verify.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/gradients/surrogate.h"
#include "problems/carrier_track/oracle/comparison.h"
#include "problems/carrier_track/oracle/hostile_scenes.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "src/campaign/progress.h"
#include "src/cli/format.h"
#include "src/cli/scene_choice.h"
#include "src/core/error.h"
#include "src/report/text.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;

double share(int part, int whole) {
  return whole > 0 ? static_cast<double>(part) / whole : 0.0;
}

/// What many comparisons amount to.
struct Tally {
  std::string name;
  int scenes = 0;
  int broken_off = 0;  ///< by the oracle, at its cap
  int certain = 0;
  int wrong_certain = 0;    ///< counts called certain that are wrong
  int wrong_uncertain = 0;  ///< the others that are wrong
  int missed = 0;           ///< fast impacts, of scenes called certain
  int spurious = 0;
  int matched = 0;
  double time_error = 0;   ///< [s], of scenes called certain whose impacts all match
  double speed_error = 0;  ///< [m/s]

  void add(const Comparison& c) {
    ++scenes;
    if (!c.compared) {
      ++broken_off;
      return;
    }
    if (!c.certain) {
      wrong_uncertain += !c.agrees();
      return;
    }
    ++certain;
    wrong_certain += !c.agrees();
    missed += c.missed;
    spurious += c.spurious;
    matched += c.matched;
    if (c.missed > 0 || c.spurious > 0) return;
    time_error = std::max(time_error, c.time_error);
    speed_error = std::max(speed_error, c.speed_error);
  }

  Json json() const {
    return {{"name", name},
            {"scenes", scenes},
            {"broken_off", broken_off},
            {"certain", share(certain, scenes - broken_off)},
            {"wrong_certain", wrong_certain},
            {"wrong_uncertain", wrong_uncertain},
            {"missed", missed},
            {"spurious", spurious},
            {"matched", matched},
            {"time_error", time_error},
            {"speed_error", speed_error}};
  }
};

struct ScenesPart {
  std::vector<Tally> tallies;  ///< one a hostility, then their sum
  std::vector<int> wrong;      ///< indices of the scenes whose certain count is wrong
  std::vector<int> unmatched;  ///< of those called certain with an impact without partner
};

ScenesPart compare_scenes(const VerifyOptions& options) {
  std::vector<Comparison> comparisons(static_cast<std::size_t>(options.scenes));
  {
    Progress progress("setting scenes against the oracle", options.scenes);
    tbb::parallel_for(0, options.scenes, [&](int i) {
      comparisons[static_cast<std::size_t>(i)] = compare(hostile_scene(options.seed, i).scene);
      progress.advance(1);
    });
  }
  ScenesPart part;
  for (const Hostility h : all_hostilities()) part.tallies.push_back({std::string(name_of(h))});
  const std::size_t kinds = part.tallies.size();
  part.tallies.push_back({"all"});
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    part.tallies[i % kinds].add(c);
    part.tallies.back().add(c);
    if (!c.compared || !c.certain) continue;
    if (!c.agrees()) part.wrong.push_back(static_cast<int>(i));
    if (c.missed > 0 || c.spurious > 0) part.unmatched.push_back(static_cast<int>(i));
  }
  return part;
}

/// The speeds 0.01, 0.02, ... rad/s below the threshold of a case.
struct QuietSpeeds {
  std::string name;
  std::optional<double> threshold;  ///< [rad/s]
  int speeds = 0;
  int certain = 0;
  Tally against_oracle;       ///< every tenth of them
  std::vector<double> wrong;  ///< [rad/s], of those
};

QuietSpeeds compare_quiet_speeds(const ChosenScene& chosen) {
  constexpr double step = 0.01;
  constexpr int stride = 10;
  QuietSpeeds result;
  result.name = chosen.name;
  result.threshold = score(chosen.scene, chosen.claim, ScanOptions{}).threshold;
  while ((result.speeds + 1) * step < result.threshold.value_or(0.0)) ++result.speeds;
  const auto size = static_cast<std::size_t>(result.speeds);
  std::vector<char> certain(size);
  std::vector<Comparison> comparisons(size / stride);
  tbb::parallel_for(0, result.speeds, [&](int i) {
    const Scene scene = at_speed(chosen.scene, (i + 1) * step);
    const auto at = static_cast<std::size_t>(i);
    certain[at] = record(scene, default_width, 0).certainty.certain;
    if ((i + 1) % stride == 0) comparisons[at / stride] = compare(scene);
  });
  result.certain = static_cast<int>(std::count(certain.begin(), certain.end(), true));
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    result.against_oracle.add(comparisons[i]);
    if (comparisons[i].compared && comparisons[i].certain && !comparisons[i].agrees()) {
      result.wrong.push_back(static_cast<double>(i + 1) * stride * step);
    }
  }
  return result;
}

Json json_of(const QuietSpeeds& quiet) {
  return {{"case", quiet.name},
          {"threshold", cli::json_of(quiet.threshold)},
          {"speeds", quiet.speeds},
          {"certain", share(quiet.certain, quiet.speeds)},
          {"compared", quiet.against_oracle.scenes - quiet.against_oracle.broken_off},
          {"wrong_certain", quiet.against_oracle.wrong_certain},
          {"wrong_uncertain", quiet.against_oracle.wrong_uncertain},
          {"wrong_at", quiet.wrong}};
}

void print(const ScenesPart& scenes, const std::vector<QuietSpeeds>& quiet, double seconds) {
  fmt::print("{:<15} {:>8} {:>7} {:>8} {:>9} {:>6} {:>6} {:>8} {:>9} {:>9} {:>9}\n", "scenes",
             "number", "capped", "certain", "disagree:", "sure", "unsure", "missed", "spurious",
             "time [s]", "v [m/s]");
  for (const Tally& t : scenes.tallies) {
    fmt::print("{:<15} {:>8} {:>7} {:>8.4f} {:>9} {:>6} {:>6} {:>8} {:>9} {:>9.1e} {:>9.1e}\n",
               t.name, t.scenes, t.broken_off, share(t.certain, t.scenes - t.broken_off), "",
               t.wrong_certain, t.wrong_uncertain, t.missed, t.spurious, t.time_error,
               t.speed_error);
  }
  for (const int i : scenes.wrong) fmt::print("WRONG: the certain count of scene {}\n", i);
  for (const int i : scenes.unmatched) fmt::print("impacts without a partner: scene {}\n", i);
  fmt::print("\n{:<15} {:>9} {:>7} {:>8} {:>9} {:>9} {:>6} {:>6}\n", "quiet speeds", "threshold",
             "speeds", "certain", "compared", "disagree:", "sure", "unsure");
  for (const QuietSpeeds& q : quiet) {
    fmt::print("{:<15} {:>9} {:>7} {:>8.4f} {:>9} {:>9} {:>6} {:>6}\n", q.name,
               report::text_or_dash(q.threshold, "{:.4f}"), q.speeds, share(q.certain, q.speeds),
               q.against_oracle.scenes - q.against_oracle.broken_off, "",
               q.against_oracle.wrong_certain, q.against_oracle.wrong_uncertain);
    for (const double omega : q.wrong) fmt::print("WRONG: {} at {:.2f} rad/s\n", q.name, omega);
  }
  fmt::print("{:.1f} s\n", seconds);
}

Json json_of(const std::vector<Impact>& impacts) {
  Json list = Json::array();
  for (const Impact& i : impacts) {
    list.push_back({{"time", i.time},
                    {"wall", i.wall == Wall::upper ? "upper" : "lower"},
                    {"speed", i.speed}});
  }
  return list;
}

/// One scene with both lists of impacts, to look at a disagreement.
int show(int seed, int index, bool json) {
  const HostileScene hostile = hostile_scene(seed, index);
  const OracleRun truth = oracle_run(hostile.scene);
  const Recording recording = record(hostile.scene, 0.0, 0);
  if (json) {
    const Json shown = {
        {"hostility", name_of(hostile.hostility)}, {"closeness", hostile.closeness},
        {"scene", write_scene(hostile.scene)},     {"count", recording.count},
        {"certain", recording.certainty.certain},  {"oracle_count", truth.count},
        {"oracle_finished", truth.finished},       {"impacts", json_of(recording.impacts)},
        {"oracle_impacts", json_of(truth.impacts)}};
    fmt::print("{}\n", shown.dump(2));
    return 0;
  }
  fmt::print("# {}, closeness {}: count {}, {}; oracle {}{}\n{}\n", name_of(hostile.hostility),
             hostile.closeness, recording.count,
             recording.certainty.certain ? "certain" : "uncertain", truth.count,
             truth.finished ? "" : ", broken off", write_scene(hostile.scene));
  for (const bool of_oracle : {false, true}) {
    fmt::print("# impacts of the {}\n", of_oracle ? "oracle" : "library");
    for (const Impact& i : of_oracle ? truth.impacts : recording.impacts) {
      fmt::print("# {:.17g} s  {}  {:.17g} m/s\n", i.time,
                 i.wall == Wall::upper ? "upper" : "lower", i.speed);
    }
  }
  return 0;
}

}  // namespace

int verify(const VerifyOptions& options) {
  if (options.scenes < 1 || options.scenes > 100'000'000) {
    throw InputError(fmt::format("--scenes {}: must be within 1..100000000", options.scenes));
  }
  if (options.scene_index) {
    if (*options.scene_index < 0) {
      throw InputError(fmt::format("--scene-index {}: must be >= 0", *options.scene_index));
    }
    return show(options.seed, *options.scene_index, options.json);
  }
  const auto start = std::chrono::steady_clock::now();
  const ScenesPart scenes = compare_scenes(options);
  std::vector<QuietSpeeds> quiet;
  {
    const auto cases = every_case();
    Progress progress("setting quiet speeds against the oracle", static_cast<double>(cases.size()));
    for (const ChosenScene& chosen : cases) {
      quiet.push_back(compare_quiet_speeds(chosen));
      progress.advance(1);
    }
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  bool right = scenes.wrong.empty();
  for (const QuietSpeeds& q : quiet) right = right && q.wrong.empty();
  if (options.json) {
    Json tallies = Json::array();
    for (const Tally& t : scenes.tallies) tallies.push_back(t.json());
    Json speeds = Json::array();
    for (const QuietSpeeds& q : quiet) speeds.push_back(json_of(q));
    const Json all = {{"seed", options.seed},   {"scenes", tallies},
                      {"wrong", scenes.wrong},  {"unmatched", scenes.unmatched},
                      {"quiet_speeds", speeds}, {"seconds", elapsed.count()}};
    fmt::print("{}\n", all.dump(2));
  } else {
    print(scenes, quiet, elapsed.count());
  }
  return right ? 0 : 1;
}

}  // namespace ricochet::cli
