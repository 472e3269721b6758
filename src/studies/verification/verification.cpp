#include "src/studies/verification/verification.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <string>
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

namespace ricochet::studies {

namespace {

using namespace carrier_track;

bool is_certain(const Comparison& c) {
  return c.compared && c.certain;
}

bool is_wrong(const Comparison& c) {
  return c.compared && !c.agrees();
}

/// "WRONG: scene 3, scene 8."; nothing for none.
std::optional<std::string> listed(const std::string& what, const std::vector<std::string>& names) {
  if (names.empty()) return {};
  return fmt::format("{}: {}.", what, fmt::join(names, ", "));
}

constexpr const char* wrong_count = "WRONG: the certain count of";

/// Returns whether a count called certain is wrong.
bool compare_scenes(const VerificationOptions& options, report::Results& results) {
  std::vector<Comparison> comparisons(static_cast<std::size_t>(options.scenes));
  Progress progress("setting scenes against the oracle", options.scenes);
  tbb::parallel_for(0, options.scenes, [&](int i) {
    comparisons[static_cast<std::size_t>(i)] = compare(hostile_scene(options.seed, i).scene);
    progress.advance(1);
  });
  Table table{"scenes"};
  const auto add = [&](const std::string& name, const std::vector<Comparison>& some) {
    Table row = tally(name, some);
    table.columns = row.columns;
    table.add_row(std::move(row.rows.front()));
  };
  const auto& kinds = all_hostilities();
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    std::vector<Comparison> own;
    for (std::size_t i = k; i < comparisons.size(); i += kinds.size())
      own.push_back(comparisons[i]);
    add(std::string(name_of(kinds[k])), own);
  }
  add("all", comparisons);
  std::vector<std::string> wrong, unmatched;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    if (!is_certain(c)) continue;
    if (is_wrong(c)) wrong.push_back(fmt::format("scene {}", i));
    if (c.missed + c.spurious > 0) unmatched.push_back(fmt::format("scene {}", i));
  }
  results.set("wrong", listed(wrong_count, wrong));
  results.set("unmatched",
              listed("Called certain, with an impact that the oracle does not have", unmatched));
  results.add(std::move(table));
  return !wrong.empty();
}

/// Compares every tenth of the speeds below each case's threshold, 0.01, 0.02, ... rad/s, with the
/// oracle. Returns whether a count called certain is wrong.
bool compare_quiet_speeds(report::Results& results) {
  constexpr double step = 0.01;
  constexpr int stride = 10;
  Table table{"quiet-speeds",
              {{"case"},
               {"threshold", "threshold [rad/s]", ".4f"},
               {"speeds"},
               {"certain", "certain [%]", ".2%"},
               {"compared"},
               {"wrong_certain", "wrong, called certain"},
               {"wrong_uncertain", "wrong, called uncertain"}}};
  std::vector<std::string> wrong;
  const std::vector<Case> cases = all_cases();
  Progress progress("setting quiet speeds against the oracle", static_cast<double>(cases.size()));
  for (const Case& a_case : cases) {
    const Scene machine = scene_of(a_case, default_machine());
    const auto threshold = score(machine, a_case.claim, ScanOptions{}).threshold;
    int speeds = 0;
    while ((speeds + 1) * step < threshold.value_or(0.0)) ++speeds;
    std::vector<char> certain(static_cast<std::size_t>(speeds));
    std::vector<Comparison> comparisons(certain.size() / stride);
    tbb::parallel_for(0, speeds, [&](int i) {
      const Scene scene = at_speed(machine, (i + 1) * step);
      const auto at = static_cast<std::size_t>(i);
      certain[at] = record(scene, default_smoothing, 0).certainty.certain;
      if ((i + 1) % stride == 0) comparisons[at / stride] = compare(scene);
    });
    for (std::size_t i = 0; i < comparisons.size(); ++i) {
      if (is_certain(comparisons[i]) && is_wrong(comparisons[i]))
        wrong.push_back(fmt::format("{} at {:.2f} rad/s", a_case.id,
                                    static_cast<double>(i + 1) * stride * step));
    }
    const auto sure = static_cast<double>(std::ranges::count(certain, true));
    const Table own = tally(a_case.id, comparisons);
    table.add(a_case.id, threshold, speeds, speeds > 0 ? sure / speeds : 0.0,
              std::ranges::count_if(comparisons, &Comparison::compared), own[0]["wrong_certain"],
              own[0]["wrong_uncertain"]);
    progress.advance(1);
  }
  results.set("wrong-speeds", listed(wrong_count, wrong));
  results.add(std::move(table));
  return !wrong.empty();
}

}  // namespace

Table tally(const std::string& name, const std::vector<Comparison>& comparisons) {
  int capped = 0, certain = 0, wrong_certain = 0, wrong_uncertain = 0;
  int missed = 0, spurious = 0, matched = 0;
  double time_error = 0, speed_error = 0;
  for (const Comparison& c : comparisons) {
    capped += !c.compared;
    certain += is_certain(c);
    (c.certain ? wrong_certain : wrong_uncertain) += is_wrong(c);
    if (!is_certain(c)) continue;
    missed += c.missed;
    spurious += c.spurious;
    matched += c.matched;
    if (c.missed > 0 || c.spurious > 0) continue;
    time_error = std::max(time_error, c.time_error);
    speed_error = std::max(speed_error, c.speed_error);
  }
  const int compared = static_cast<int>(comparisons.size()) - capped;
  Table row{"tally",
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
  row.add(name, comparisons.size(), capped,
          compared > 0 ? static_cast<double>(certain) / compared : 0.0, wrong_certain,
          wrong_uncertain, missed, spurious, matched, time_error, speed_error);
  return row;
}

Study verification_study(const VerificationOptions& options) {
  if (options.scenes < 1 || options.scenes > 100'000'000) {
    throw InputError(fmt::format("--scenes {}: must be within 1..100000000", options.scenes));
  }
  return {"verification", "", [options](bool /*quick*/) {
            report::Results results;
            const bool wrong_scenes = compare_scenes(options, results);
            const bool failed = compare_quiet_speeds(results) || wrong_scenes;
            results.set("failed", failed);
            results.set("seed", options.seed);
            results.set("finding", failed ? "There is a count called certain that is wrong."
                                          : "No count called certain is wrong.");
            return json_of(results);
          }};
}

}  // namespace ricochet::studies
