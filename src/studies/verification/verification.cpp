#include "src/studies/verification/verification.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "src/core/progress.h"

namespace ricochet::studies::verification {

void SceneTally::add(const carrier_track::Comparison& c) {
  ++scenes;
  if (!c.compared) {
    ++broken_off;
    return;
  }
  called_certain += c.certain;
  certain = static_cast<double>(called_certain) / compared();
  if (!c.certain) {
    wrong_uncertain += !c.agrees();
    return;
  }
  wrong_certain += !c.agrees();
  missed += c.missed;
  spurious += c.spurious;
  matched += c.matched;
  if (c.missed > 0 || c.spurious > 0) return;
  time_error = std::max(time_error, c.time_error);
  speed_error = std::max(speed_error, c.speed_error);
}

}  // namespace ricochet::studies::verification

namespace ricochet::studies {

namespace {

using namespace carrier_track;
using verification::SceneTally;

/// The quiet speeds of a case: 0.01, 0.02, ... rad/s below its threshold.
struct QuietSpeeds {
  std::string case_;
  std::optional<double> threshold;  ///< [rad/s]
  int speeds;
  double certain;  ///< share
  int compared, wrong_certain, wrong_uncertain;
  std::vector<double> wrong_at;  ///< [rad/s], where a certain count is wrong
};
RICOCHET_FIELDS(QuietSpeeds, case_, threshold, speeds, certain, compared, wrong_certain,
                wrong_uncertain, wrong_at);

struct Verification {
  int seed;
  std::vector<SceneTally> scenes;      ///< one for each hostility, then all
  std::vector<std::size_t> wrong;      ///< numbers of the scenes whose certain count is wrong
  std::vector<std::size_t> unmatched;  ///< called certain, with an unmatched impact
  std::vector<QuietSpeeds> quiet_speeds;
  bool failed;
};
RICOCHET_FIELDS(Verification, seed, scenes, wrong, unmatched, quiet_speeds, failed);

bool is_wrong(const Comparison& c) {
  return c.compared && c.certain && !c.agrees();
}

Verification compare_scenes(const VerificationOptions& options) {
  std::vector<Comparison> comparisons(static_cast<std::size_t>(options.scenes));
  {
    Progress progress("setting scenes against the oracle", options.scenes);
    tbb::parallel_for(0, options.scenes, [&](int i) {
      comparisons[static_cast<std::size_t>(i)] = compare(hostile_scene(options.seed, i).scene);
      progress.advance(1);
    });
  }
  Verification data{options.seed, {}, {}, {}, {}, false};
  for (const Hostility h : all_hostilities()) data.scenes.push_back({std::string(name_of(h))});
  const std::size_t kinds = data.scenes.size();
  data.scenes.push_back({"all"});
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    data.scenes[i % kinds].add(c);
    data.scenes.back().add(c);
    if (is_wrong(c)) data.wrong.push_back(i);
    if (c.compared && c.certain && c.missed + c.spurious > 0) data.unmatched.push_back(i);
  }
  return data;
}

/// Compares every tenth of the speeds with the oracle.
QuietSpeeds compare_quiet_speeds(const Case& a_case, const Scene& in_interpretation) {
  constexpr double step = 0.01;
  constexpr int stride = 10;
  const auto threshold = score(in_interpretation, a_case.claim, ScanOptions{}).threshold;
  int speeds = 0;
  while ((speeds + 1) * step < threshold.value_or(0.0)) ++speeds;
  const auto size = static_cast<std::size_t>(speeds);
  std::vector<char> certain(size);
  std::vector<Comparison> comparisons(size / stride);
  tbb::parallel_for(0, speeds, [&](int i) {
    const Scene scene = at_speed(in_interpretation, (i + 1) * step);
    const auto at = static_cast<std::size_t>(i);
    certain[at] = record(scene, default_smoothing, 0).certainty.certain;
    if ((i + 1) % stride == 0) comparisons[at / stride] = compare(scene);
  });
  SceneTally tally{a_case.id};
  std::vector<double> wrong_at;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    tally.add(comparisons[i]);
    if (is_wrong(comparisons[i])) wrong_at.push_back(static_cast<double>(i + 1) * stride * step);
  }
  const auto sure = static_cast<double>(std::count(certain.begin(), certain.end(), true));
  return {a_case.id,
          threshold,
          speeds,
          speeds > 0 ? sure / speeds : 0.0,
          tally.compared(),
          tally.wrong_certain,
          tally.wrong_uncertain,
          std::move(wrong_at)};
}

Verification compute(const VerificationOptions& options) {
  Verification data = compare_scenes(options);
  data.failed = !data.wrong.empty();
  const std::vector<Case> cases = all_cases();
  Progress progress("setting quiet speeds against the oracle", static_cast<double>(cases.size()));
  for (const Case& a_case : cases) {
    data.quiet_speeds.push_back(compare_quiet_speeds(a_case, scene_of(a_case, default_machine())));
    data.failed = data.failed || !data.quiet_speeds.back().wrong_at.empty();
    progress.advance(1);
  }
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
