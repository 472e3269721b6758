#include "src/studies/verification/verification.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
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
#include "src/report/results.h"
#include "src/report/table.h"

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

/// Comparisons of scenes with the oracle, and what is wrong in them.
struct Verification {
  Table scenes{"scenes",
               {{"scenes"},
                {"number"},
                {"capped"},
                {"certain", "certain [%]", ".2%"},
                {"wrong_certain", "wrong, called certain"},
                {"wrong_uncertain", "wrong, called uncertain"},
                {"missed"},
                {"spurious"},
                {"matched"},
                {"time_error", "time error [s]", ".1e"},
                {"speed_error", "speed error [m/s]", ".1e"}}};
  Table quiet_speeds{"quiet-speeds",
                     {{"case"},
                      {"threshold", "threshold [rad/s]", ".4f"},
                      {"speeds"},
                      {"certain", "certain [%]", ".2%"},
                      {"compared"},
                      {"wrong_certain", "wrong, called certain"},
                      {"wrong_uncertain", "wrong, called uncertain"}}};
  std::vector<std::string> wrong;      ///< scenes whose certain count is wrong
  std::vector<std::string> unmatched;  ///< called certain, with an unmatched impact
  std::vector<std::string> wrong_speeds;
};

bool is_wrong(const Comparison& c) {
  return c.compared && c.certain && !c.agrees();
}

void compare_scenes(const VerificationOptions& options, Verification& found) {
  std::vector<Comparison> comparisons(static_cast<std::size_t>(options.scenes));
  {
    Progress progress("setting scenes against the oracle", options.scenes);
    tbb::parallel_for(0, options.scenes, [&](int i) {
      comparisons[static_cast<std::size_t>(i)] = compare(hostile_scene(options.seed, i).scene);
      progress.advance(1);
    });
  }
  std::vector<SceneTally> tallies;
  for (const Hostility h : all_hostilities()) tallies.push_back({std::string(name_of(h))});
  const std::size_t kinds = tallies.size();
  tallies.push_back({"all"});
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    tallies[i % kinds].add(c);
    tallies.back().add(c);
    if (is_wrong(c)) found.wrong.push_back(fmt::format("scene {}", i));
    if (c.compared && c.certain && c.missed + c.spurious > 0)
      found.unmatched.push_back(fmt::format("scene {}", i));
  }
  for (const SceneTally& t : tallies) {
    found.scenes.add(t.name, t.scenes, t.broken_off, t.certain, t.wrong_certain, t.wrong_uncertain,
                     t.missed, t.spurious, t.matched, t.time_error, t.speed_error);
  }
}

/// Compares every tenth of the speeds below a case's threshold, 0.01, 0.02, ... rad/s, with the
/// oracle.
void compare_quiet_speeds(const Case& a_case, const Scene& in_interpretation, Verification& found) {
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
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    tally.add(comparisons[i]);
    if (is_wrong(comparisons[i])) {
      found.wrong_speeds.push_back(
          fmt::format("{} at {:.2f} rad/s", a_case.id, static_cast<double>(i + 1) * stride * step));
    }
  }
  const auto sure = static_cast<double>(std::count(certain.begin(), certain.end(), true));
  found.quiet_speeds.add(a_case.id, threshold, speeds, speeds > 0 ? sure / speeds : 0.0,
                         tally.compared(), tally.wrong_certain, tally.wrong_uncertain);
}

/// "Wrong: scene 3, scene 8"; nothing for none.
std::optional<std::string> listed(const std::string& what, const std::vector<std::string>& names) {
  if (names.empty()) return {};
  return fmt::format("{}: {}.", what, fmt::join(names, ", "));
}

report::Results compute(const VerificationOptions& options) {
  Verification found;
  compare_scenes(options, found);
  const std::vector<Case> cases = all_cases();
  Progress progress("setting quiet speeds against the oracle", static_cast<double>(cases.size()));
  for (const Case& a_case : cases) {
    compare_quiet_speeds(a_case, scene_of(a_case, default_machine()), found);
    progress.advance(1);
  }
  const bool failed = !found.wrong.empty() || !found.wrong_speeds.empty();
  report::Results results;
  results.set("failed", failed);
  results.set("seed", options.seed);
  results.set("finding", failed ? "There is a count called certain that is wrong."
                                : "No count called certain is wrong.");
  results.set("wrong", listed("WRONG: the certain count of", found.wrong));
  results.set("unmatched", listed("Called certain, with an impact that the oracle does not have",
                                  found.unmatched));
  results.set("wrong-speeds", listed("WRONG: the certain count of", found.wrong_speeds));
  results.add(std::move(found.scenes));
  results.add(std::move(found.quiet_speeds));
  return results;
}

}  // namespace

Study verification_study(const VerificationOptions& options) {
  if (options.scenes < 1 || options.scenes > 100'000'000) {
    throw InputError(fmt::format("--scenes {}: must be within 1..100000000", options.scenes));
  }
  return {"verification", "", [options](bool /*quick*/) { return json_of(compute(options)); }};
}

}  // namespace ricochet::studies
