#include "src/cli/threshold.h"

#include <fmt/format.h>

#include <cmath>

#include "problems/carrier_track/counting/threshold.h"
#include "src/campaign/progress.h"
#include "src/cli/format.h"
#include "src/core/error.h"
#include "src/report/text.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;

Json restitution_of(const Scene& scene) {
  if (scene.restitution_lower == scene.restitution_upper) return scene.restitution_lower;
  return Json::array({scene.restitution_lower, scene.restitution_upper});
}

/// A multiple of the scan's step without the last digits of its rounding.
Json speed_of(const std::optional<double>& speed) {
  constexpr double digits = 1e9;
  return speed ? Json(std::round(*speed * digits) / digits) : Json(nullptr);
}

Json json_of(const ChosenScene& chosen, const Score& score) {
  Json examples = Json::array();
  for (const Example& e : score.examples) {
    examples.push_back({{"omega", e.omega},
                        {"side", e.loud ? "loud" : "quiet"},
                        {"count", e.count},
                        {"right", e.right}});
  }
  return {{"case", chosen.name},
          {"restitution", restitution_of(chosen.scene)},
          {"friction", chosen.scene.friction},
          {"disturbance", chosen.scene.disturbance},
          {"paper_threshold", cli::json_of(chosen.claim.threshold)},
          {"threshold", speed_of(score.threshold)},
          {"first_loud", speed_of(score.first_loud)},
          {"misclassified", score.misclassified},
          {"purity", cli::json_of(score.purity)},
          {"loudness", cli::json_of(score.loudness)},
          {"paper_quiet_count", cli::json_of(chosen.claim.quiet_count)},
          {"quiet_count", score.quiet_count},
          {"reading", chosen.reading},
          {"evaluations", score.evaluations},
          {"seconds", score.seconds},
          {"examples", examples}};
}

void print_header() {
  fmt::print("{:<12} {:>9} {:>6} {:>7} {:>10} {:>7} {:>7} {:>7} {:>6} {:>6}  {}\n", "scene",
             "threshold", "paper", "error", "first loud", "quiet", "paper", "misclas", "purity",
             "loud/q", "examples");
}

void print_row(const ChosenScene& chosen, const Score& score) {
  std::string error = "-";
  if (chosen.claim.threshold && score.threshold) {
    error = fmt::format("{:+.1f} %", 100 * (*score.threshold / *chosen.claim.threshold - 1));
  }
  std::string examples;
  for (const Example& e : score.examples) {
    examples += fmt::format("{}{} at {}: {}", examples.empty() ? "" : ", ", e.omega, e.count,
                            e.right ? "right" : "WRONG");
  }
  fmt::print("{:<12} {:>9} {:>6} {:>7} {:>10} {:>7} {:>7} {:>7.4f} {:>6} {:>6}  {}\n", chosen.name,
             report::text_or_dash(score.threshold, "{:.4f}"),
             report::text_or_dash(chosen.claim.threshold, "{}"), error,
             report::text_or_dash(score.first_loud, "{:.3f}"), score.quiet_count,
             report::text_or_dash(chosen.claim.quiet_count, "{}"), score.misclassified,
             report::text_or_dash(score.purity, "{:.3f}"),
             report::text_or_dash(score.loudness, "{:.2f}"), examples);
}

/// What an engineer wants to know, in words.
void print_advice(const ChosenScene& chosen, const Score& score, const ScanOptions& options) {
  fmt::print("{}: ", chosen.name);
  if (score.first_loud) {
    fmt::print("stay below {:.3f} rad/s, the lowest speed that is loud.\n", *score.first_loud);
  } else {
    fmt::print("every speed up to {} rad/s is quiet.\n", options.highest);
  }
  fmt::print("Quiet means at most {} collisions in the window: 1.5 times the usual {}.\n",
             std::floor(quiet_limit(score.quiet_count)), score.quiet_count);
  if (score.threshold) {
    fmt::print(
        "Quiet and loud divide best at {:.4f} rad/s; {:.2f} % of the speeds up to {} rad/s "
        "lie on the wrong side.\n",
        *score.threshold, 100 * score.misclassified, options.highest);
  }
  if (chosen.claim.threshold) {
    fmt::print("The paper has them divide at {} rad/s, with {} collisions below.\n",
               *chosen.claim.threshold, report::text_or_dash(chosen.claim.quiet_count, "{}"));
  }
}

}  // namespace

int threshold(const ThresholdOptions& options) {
  if (options.all && !(options.scene.case_id.empty() && options.scene.scene_file.empty())) {
    throw InputError("--all stands alone: it takes neither --case nor --scene");
  }
  ScanOptions scan;
  scan.highest = options.fastest;
  if (!(scan.highest >= 0.1 && scan.highest <= 1000)) {
    throw InputError(
        fmt::format("--fastest {}: must be within 0.1..1000 [rad/s]", options.fastest));
  }
  const auto scenes =
      options.all ? every_case() : std::vector<ChosenScene>{choose_scene(options.scene)};
  for (const ChosenScene& chosen : scenes) {
    if (chosen.scene.profile.empty()) continue;
    throw InputError(chosen.name +
                     ": scene.omega is a profile: must be a number, because a threshold is of "
                     "constant speeds");
  }
  std::vector<Score> scores;
  {
    Progress progress("scanning speeds", static_cast<double>(scenes.size()));
    for (const ChosenScene& chosen : scenes) {
      scores.push_back(score(chosen.scene, chosen.claim, scan));
      progress.advance(1);
    }
  }
  if (options.json) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < scenes.size(); ++i) rows.push_back(json_of(scenes[i], scores[i]));
    fmt::print("{}\n", (options.all ? rows : rows.front()).dump(2));
    return 0;
  }
  if (!options.all) {
    print_advice(scenes.front(), scores.front(), scan);
    return 0;
  }
  print_header();
  for (std::size_t i = 0; i < scenes.size(); ++i) print_row(scenes[i], scores[i]);
  return 0;
}

}  // namespace ricochet::cli
