#include "problems/carrier_track/counting/threshold.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "src/app/command_line.h"
#include "src/app/report.h"
#include "src/app/scene_choice.h"
#include "src/report/drawing.h"
#include "src/report/json.h"
#include "src/report/table.h"
#include "src/report/text.h"
#include "src/studies/machine/answer.h"
#include "src/studies/machine/charts.h"

namespace ricochet::cli {

namespace {

using namespace carrier_track;
using namespace studies::advice;
using report::Json;

struct ThresholdOptions {
  SceneChoice scene;
  bool all = false;  ///< every case of the paper
  bool json = false;
  std::string plot;  ///< SVG file for the staircase; empty: none
  QuietSpeedRequest asked;
};

Json restitution_of(const Scene& scene) {
  if (scene.restitution_lower == scene.restitution_upper) return scene.restitution_lower;
  return Json::array({scene.restitution_lower, scene.restitution_upper});
}

/// "5 at 9.5, 12 at 3": the counts at those speeds of the paper's examples that are wrong.
std::string wrong_examples(const Score& score) {
  std::string wrong;
  for (const Example& e : score.examples) {
    if (!e.right) wrong += fmt::format("{}{} at {}", wrong.empty() ? "" : ", ", e.count, e.omega);
  }
  return wrong;
}

/// The scores of the first scenes; they are missing of those for which there was no time.
Table score_table(const std::vector<ChosenScene>& scenes, const std::vector<Score>& scores) {
  Table table{"thresholds",
              {{"case", "scene"},
               {"restitution"},
               {"friction"},
               {"disturbance"},
               {"paper_threshold", "paper [rad/s]"},
               {"threshold", "threshold [rad/s]", ".4f"},
               {"first_loud", "first loud [rad/s]", ".3f"},
               {"misclassified", "misclassified [%]", ".2%"},
               {"purity", "", ".3f"},
               {"loudness", "loud / quiet", ".2f"},
               {"paper_quiet_count", "paper's count"},
               {"quiet_count", "quiet count"},
               {"interpretation"},
               {"evaluations"},
               {"seconds"},
               {"complete"},
               {"examples", "counts unlike the paper's"}}};
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto& [name, interpretation, scene, claim, source] = scenes[i];
    const Score* score = i < scores.size() ? &scores[i] : nullptr;
    table.add(name, scene.restitution_lower, scene.friction, scene.disturbance, claim.threshold,
              value_of(score, [](const Score& s) { return rounded(s.threshold); }),
              value_of(score, [](const Score& s) { return rounded(s.first_loud); }),
              value_of(score, &Score::misclassified), value_of(score, &Score::purity),
              value_of(score, &Score::loudness), claim.quiet_count,
              value_of(score, &Score::quiet_count), interpretation,
              value_of(score, &Score::evaluations), value_of(score, &Score::seconds),
              score != nullptr, score != nullptr ? wrong_examples(*score) : "");
  }
  return table;
}

Json json_of(const std::vector<ChosenScene>& scenes, const std::vector<Score>& scores) {
  Json rows = json_rows_of(score_table(scenes, scores));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i]["restitution"] = restitution_of(scenes[i].scene);
    rows[i]["examples"] = report::list_of(
        i < scores.size() ? scores[i].examples : std::vector<Example>(), [](const Example& e) {
          return Json{{"omega", e.omega},
                      {"side", e.loud ? "loud" : "quiet"},
                      {"count", e.count},
                      {"right", e.right}};
        });
  }
  return rows;
}

/// With the error of the threshold.
void print(const std::vector<ChosenScene>& scenes, const std::vector<Score>& scores) {
  const auto error = [](const Row& row) -> Value {
    const auto found = row.number_if("threshold"), claimed = row.number_if("paper_threshold");
    return found && claimed ? Value(*found / *claimed - 1) : Value();
  };
  const Table known = where(score_table(scenes, scores), "complete", true);
  print_table(only(with(known, {"error", "error [%]", "+.1%"}, error),
                   {"case", "threshold", "paper_threshold", "error", "first_loud", "quiet_count",
                    "paper_quiet_count", "misclassified", "purity", "loudness", "examples"}),
              false);
}

/// Prints the result of the paper's rule for a case.
void print_paper_rule(const ChosenScene& chosen, const Score& score, const ScanOptions& options) {
  fmt::print("By the paper's rule, for a window of {:.3g} turns after a fitted start: ",
             turns_of(chosen.scene));
  if (score.first_loud) {
    fmt::print("the lowest loud speed is {}.\n", both_units(*score.first_loud));
  } else {
    fmt::print("every speed up to {} rad/s is quiet.\n", options.highest);
  }
  fmt::print(
      "Quiet means at most {} in the window: 1.5 times the usual {}{}.\n",
      report::counted(static_cast<std::int64_t>(quiet_limit(score.quiet_count)), "collision"),
      score.quiet_count, chosen.claim.threshold ? " below the paper's threshold" : "");
  if (score.threshold) {
    fmt::print(
        "Quiet and loud divide best at {:.4f} rad/s; {:.2f} % of the speeds up to {} rad/s "
        "lie on the wrong side.\n",
        *score.threshold, 100 * score.misclassified, options.highest);
  }
  if (chosen.claim.threshold) {
    fmt::print("The paper has them divide at {} rad/s, with {} collisions below.\n",
               *chosen.claim.threshold,
               chosen.claim.quiet_count ? std::to_string(*chosen.claim.quiet_count) : "–");
  }
}

/// The scores of as many cases as there is time for.
std::vector<Score> scores_of(const std::vector<ChosenScene>& scenes, const ScanOptions& scan) {
  std::vector<Score> scores;
  try {
    for (const ChosenScene& chosen : scenes) {
      scores.push_back(score(chosen.scene, chosen.claim, scan));
    }
  } catch (const TimeLimitReached&) {
    // The rows say so.
  }
  return scores;
}

int threshold_of_all(const ScanOptions& scan, bool json, double seconds) {
  const std::vector<ChosenScene> scenes = every_case();
  const std::vector<Score> scores = limited(seconds, [&] { return scores_of(scenes, scan); });
  if (json) {
    fmt::print("{}\n", json_of(scenes, scores).dump(2));
  } else {
    print(scenes, scores);
  }
  if (scores.size() == scenes.size()) return 0;
  return report_incomplete(seconds,
                           fmt::format("{} of {} cases are known", scores.size(), scenes.size()));
}

/// Returns the score that corresponds to the answer for a machine.
Score score_of(const QuietSpeed& answer) {
  Score score;
  score.threshold = answer.split.speed;
  score.first_loud = answer.split.first_loud;
  score.misclassified = answer.split.misclassified;
  if (!answer.staircase.levels.empty()) score.quiet_count = answer.staircase.levels.front().typical;
  score.evaluations =
      static_cast<std::int64_t>(answer.scan.counts.size() + answer.fine.counts.size());
  return score;
}

/// The collisions over the speed, with the answer and the paper's claim.
report::Plot plot_of(const ChosenScene& chosen, const QuietSpeed& answer) {
  return report::plot_of({staircase_chart(answer, chosen.name + ": collisions against speed",
                                          {{answer.fastest_quiet, "fastest quiet speed"},
                                           {chosen.claim.threshold, "paper's threshold"}})});
}

int threshold(const ThresholdOptions& options) {
  const QuietSpeedOptions asked = options_of(options.asked);
  ScanOptions scan;
  scan.highest = asked.fastest;
  if (options.all) {
    if (!(options.scene.case_id.empty() && options.scene.scene_file.empty())) {
      throw InputError("--all stands alone: it takes neither --case nor --scene");
    }
    if (!options.scene.settings.empty()) {
      throw InputError("--all has the paper's cases as they are: it takes no --set");
    }
    if (asked.limit || options.asked.tolerance > 0) {
      throw InputError("--all is by the paper's rule: it takes no limit and no tolerance");
    }
    if (!options.plot.empty()) throw InputError("--all has no picture: it takes no --plot");
    return threshold_of_all(scan, options.json, options.asked.seconds);
  }
  const ChosenScene chosen = choose_scene(options.scene);
  carrier_track::check_constant_speed(chosen.scene, chosen.name);
  refuse_same_files({{"--plot", options.plot}}, {options.scene.scene_file});
  const auto start = std::chrono::steady_clock::now();
  bool by_the_paper =
      !asked.limit && !options.scene.case_id.empty() && options.scene.settings.empty();
  QuietSpeedAnswer output;
  Score score;
  const bool of_the_long_run = is_of_the_long_run(chosen.scene, limit_of(asked));
  limited(
      options.asked.seconds,
      [&] {
        try {
          output = answer_quiet_speed(chosen.name, chosen.scene, asked,
                                      options.asked.tolerance / 100, chosen.source);
        } catch (const TimeLimitReached&) {
          if (!of_the_long_run) throw;
          by_the_paper = false;
          output.name = chosen.name;
          output.scene = chosen.scene;
          output.answer.options = asked;
          output.answer.reached = slowest_of_a_range;
          return;
        }
        score = score_of(output.answer);
        try {
          if (by_the_paper) score = carrier_track::score(chosen.scene, chosen.claim, scan);
        } catch (const TimeLimitReached&) {
          output.left_out.emplace_back("paper's rule");
          by_the_paper = false;
        }
      },
      of_the_long_run ? seconds_to_sample(options.asked.seconds) : 0);
  if (of_the_long_run && output.answer.reached) {
    output.sampled = sampled_in_time(chosen.scene, *output.answer.reached, asked.fastest,
                                     seconds_to_sample(options.asked.seconds));
  }
  score.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report::Plot plot;
  if (!options.plot.empty()) plot = plot_of(chosen, output.answer);
  write_files({{options.plot, plot.svg}});
  if (options.json) {
    Json json = json_of(std::vector{chosen}, {score})[0];
    json.update(studies::advice::json_of(output));
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}", text_of(output));
    if (by_the_paper) print_paper_rule(chosen, score, scan);
  }
  report::require_none(plot.failures);
  if (output.is_complete()) return 0;
  return report_incomplete(options.asked.seconds, studies::advice::known_part_of(output));
}

}  // namespace

void add_threshold(CommandLine& line) {
  CLI::App* command = line.add("threshold", "Find the fastest quiet speed, to 1e-3 rad/s",
                               "  ricochet threshold --scene machine.toml --plot staircase.svg\n"
                               "  ricochet threshold --all --format json");
  const auto options = std::make_shared<ThresholdOptions>();
  add_scene_choice(command, options->scene);
  add_format(command, options->json);
  command->add_flag("--all", options->all, "Every case of the paper");
  add_request(command, options->asked);
  add_value(command, "--plot", options->plot, "SVG file for a chart of the counts", "FILE");
  line.on_call(command, [options] { return threshold(*options); });
}

namespace {

using carrier_track::Limit;
using carrier_track::Measure;

std::optional<Limit> limit_of(const QuietSpeedRequest& request) {
  const std::pair<Measure, std::optional<double>> asked[] = {
      {Measure::collisions, request.allow},
      {Measure::collisions_per_turn, request.allow_per_turn},
      {Measure::energy, request.allow_energy},
      {Measure::impact_speed, request.allow_speed}};
  std::optional<Limit> limit;
  for (const auto& [measure, at_most] : asked) {
    if (!at_most) continue;
    if (limit) {
      throw InputError("--allow, --allow-per-turn, --allow-energy, --allow-speed: one at a time");
    }
    if (!(*at_most >= 0 && std::isfinite(*at_most))) {
      throw InputError(fmt::format("what is allowed is {}: must be finite and >= 0", *at_most));
    }
    limit = {measure, *at_most};
  }
  return limit;
}

}  // namespace

void add_request(CLI::App* command, QuietSpeedRequest& asked) {
  add_seconds(command, asked.seconds);
  add_value(command, "--fastest", asked.fastest, "End of the speed range [rad/s]");
  command->add_option("--allow", asked.allow, "Limit: collisions in the window");
  command->add_option("--allow-per-turn", asked.allow_per_turn, "Limit: collisions per turn");
  command->add_option("--allow-energy", asked.allow_energy,
                      "Limit: energy [J] that the walls dissipate in the window");
  command->add_option("--allow-speed", asked.allow_speed,
                      "Limit: speed [m/s] of the fastest impact");
  command->add_option("--tolerance", asked.tolerance,
                      "Uncertainty of every constant [%]; prints the range of the answer");
}

carrier_track::QuietSpeedOptions options_of(const QuietSpeedRequest& request) {
  if (!(request.fastest >= carrier_track::shortest_range &&
        request.fastest <= carrier_track::longest_range)) {
    throw InputError(fmt::format("--fastest {}: must be within {}..{} [rad/s]", request.fastest,
                                 carrier_track::shortest_range, carrier_track::longest_range));
  }
  if (!(request.tolerance >= 0 && request.tolerance <= 50)) {
    throw InputError(fmt::format("--tolerance {}: must be within 0..50 [%]", request.tolerance));
  }
  return {.limit = limit_of(request), .fastest = request.fastest};
}

}  // namespace ricochet::cli
