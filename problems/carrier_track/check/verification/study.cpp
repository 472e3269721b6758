#include "src/studies/verification/study.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/oracle/hostile_scenes.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/campaign/progress.h"
#include "src/core/error.h"
#include "src/studies/verification/scene_tally.h"

namespace ricochet::studies {
namespace {

using namespace carrier_track;
using report::Json;
using verification::SceneTally;

bool is_wrong(const Comparison& c) {
  return c.compared && c.certain && !c.agrees();
}

/// One row a hostility, then their sum; the indices of the scenes whose certain count is wrong, and
/// of those called certain with an impact without a partner.
Json compare_scenes(const VerificationOptions& options) {
  std::vector<Comparison> comparisons(static_cast<std::size_t>(options.scenes));
  {
    Progress progress("setting scenes against the oracle", options.scenes);
    tbb::parallel_for(0, options.scenes, [&](int i) {
      comparisons[static_cast<std::size_t>(i)] = compare(hostile_scene(options.seed, i).scene);
      progress.advance(1);
    });
  }
  std::vector<SceneTally> tallies;
  for (const Hostility h : all_hostilities()) tallies.emplace_back(std::string(name_of(h)));
  const std::size_t kinds = tallies.size();
  tallies.emplace_back("all");
  Json wrong = Json::array();
  Json unmatched = Json::array();
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    tallies[i % kinds].add(c);
    tallies.back().add(c);
    if (is_wrong(c)) wrong.push_back(i);
    if (c.compared && c.certain && c.missed + c.spurious > 0) unmatched.push_back(i);
  }
  Json rows = Json::array();
  for (const SceneTally& tally : tallies) rows.push_back(tally.data());
  return {{"seed", options.seed}, {"scenes", rows}, {"wrong", wrong}, {"unmatched", unmatched}};
}

/// The speeds 0.01, 0.02, ... rad/s below the threshold of a case; every tenth of them is set
/// against the oracle.
Json compare_quiet_speeds(const Case& a_case, const Scene& in_reading) {
  constexpr double step = 0.01;
  constexpr int stride = 10;
  const auto threshold = score(in_reading, a_case.claim, ScanOptions{}).threshold;
  int speeds = 0;
  while ((speeds + 1) * step < threshold.value_or(0.0)) ++speeds;
  const auto size = static_cast<std::size_t>(speeds);
  std::vector<char> certain(size);
  std::vector<Comparison> comparisons(size / stride);
  tbb::parallel_for(0, speeds, [&](int i) {
    const Scene scene = at_speed(in_reading, (i + 1) * step);
    const auto at = static_cast<std::size_t>(i);
    certain[at] = record(scene, default_width, 0).certainty.certain;
    if ((i + 1) % stride == 0) comparisons[at / stride] = compare(scene);
  });
  SceneTally tally(a_case.id);
  Json wrong = Json::array();
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    tally.add(comparisons[i]);
    if (is_wrong(comparisons[i])) wrong.push_back(static_cast<double>(i + 1) * stride * step);
  }
  const auto sure = static_cast<double>(std::count(certain.begin(), certain.end(), true));
  const Json compared = tally.data();
  return {{"case", a_case.id},
          {"threshold", threshold ? Json(*threshold) : Json()},
          {"speeds", speeds},
          {"certain", speeds > 0 ? sure / speeds : 0.0},
          {"compared", tally.compared()},
          {"wrong_certain", compared["wrong_certain"]},
          {"wrong_uncertain", compared["wrong_uncertain"]},
          {"wrong_at", wrong}};
}

Json compute(const VerificationOptions& options) {
  Json data = compare_scenes(options);
  data["quiet_speeds"] = Json::array();
  bool failed = !data["wrong"].empty();
  const std::vector<Case> cases = all_cases();
  Progress progress("setting quiet speeds against the oracle", static_cast<double>(cases.size()));
  for (const Case& a_case : cases) {
    Json row = compare_quiet_speeds(a_case, scene_of(a_case, default_reading().scene));
    failed = failed || !row["wrong_at"].empty();
    data["quiet_speeds"].push_back(std::move(row));
    progress.advance(1);
  }
  data["failed"] = failed;
  return data;
}

}  // namespace

Study verification_study(const VerificationOptions& options) {
  if (options.scenes < 1 || options.scenes > 100'000'000) {
    throw InputError(fmt::format("--scenes {}: must be within 1..100000000", options.scenes));
  }
  return {"verification", "", [options](bool /*quick*/) { return compute(options); }};
}

}  // namespace ricochet::studies
