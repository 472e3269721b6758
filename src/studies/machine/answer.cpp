#include "src/studies/machine/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"
#include "src/studies/machine/design_parameters.h"
#include "src/studies/machine/regime_tables.h"

namespace ricochet::studies::advice {

namespace {

using namespace carrier_track;
using report::Json;

constexpr int drawn_machines = 200;

std::string text_of(const Limit& limit) {
  switch (limit.measure) {
    case Measure::collisions:
      return fmt::format("at most {} collisions in the window", limit.at_most);
    case Measure::collisions_per_turn:
      return limit.at_most == quiet_per_turn
                 ? "at most 2 collisions a turn, one with each wall"
                 : fmt::format("at most {} collisions a turn", limit.at_most);
    case Measure::energy:
      return fmt::format("at most {} J into the walls in the window", limit.at_most);
    case Measure::impact_speed:
      return fmt::format("no impact faster than {} m/s", limit.at_most);
  }
  return "";
}

std::string key_of(Measure measure) {
  constexpr const char* keys[] = {"collisions", "collisions_per_turn", "energy", "impact_speed"};
  return keys[static_cast<std::size_t>(measure)];
}

std::string text_of(const ToleranceRange& range) {
  return fmt::format(
      "{} machines divide between {} and {}{}", range.machines - range.without,
      both_units(range.lowest), both_units(range.highest),
      range.without == 0
          ? ""
          : fmt::format("; {} not within two thirds and three halves of the speed", range.without));
}

std::string text_of(const UncertainDivide& uncertain) {
  std::string text = fmt::format(
      "With the uncertainties of the file, each uniform within its plus_minus, {}.\n"
      "To first order they move the divide by up to {:.3f} rad/s:",
      text_of(uncertain.range), uncertain.first_order);
  for (const auto& [key, change] : uncertain.effects) {
    text += fmt::format(" {} {:+.3f};", key, change);
  }
  text.back() = '.';
  return text;
}

Json json_of(const ToleranceRange& range) {
  return {{"lowest", range.lowest},
          {"highest", range.highest},
          {"machines", range.machines},
          {"without", range.without > 0 ? Json(range.without) : Json()}};
}

/// The speeds on both sides of the answer.
std::vector<double> speeds_beside(const QuietSpeed& answer) {
  std::vector<double> speeds;
  for (const auto& speed : {answer.fastest_quiet, answer.split.first_loud}) {
    if (speed) speeds.push_back(*speed);
  }
  return speeds;
}

/// Why there is no fastest quiet speed; null if there is one.
Json reason_of(const QuietSpeed& answer) {
  if (answer.fastest_quiet) return {};
  if (answer.loud_everywhere) return "loud at every speed";
  if (answer.split.first_loud) return "loud from the slowest speed on";
  if (answer.reached) return "the time limit was reached";
  return "the count makes no step";
}

/// The first regime up to the first loud speed that is not certain; nullptr if there is none.
const Regime* doubtful_regime(const QuietSpeed& answer) {
  const double loud = answer.split.first_loud.value_or(answer.options.fastest);
  for (const Regime& regime : answer.regimes) {
    if (regime.from < loud && !regime.certain) return &regime;
  }
  return nullptr;
}

}  // namespace

Table step_table(const std::vector<Step>& steps) {
  Table table{"steps",
              {{"omega", "speed [rad/s]", ".3f"},
               {"below", "collisions below, at most"},
               {"above", "above, at least"},
               {"reach", "holds up to [times its speed]", ".2f"},
               {"significance", "", ".3f"},
               {"first_loud", "first louder speed [rad/s]", ".3f"}}};
  for (const Step& step : steps) {
    table.add(rounded(step.omega), step.below, step.above, step.reach, step.significance,
              step.first_loud);
  }
  return table;
}

Table level_table(const std::vector<carrier_track::Level>& levels) {
  Table table{"levels",
              {{"from", "from [rad/s]", ".2f"},
               {"to", "to [rad/s]", ".2f"},
               {"low", "fewest"},
               {"typical", "median"},
               {"high", "most"}}};
  for (const carrier_track::Level& level : levels) {
    table.add(level.from, level.to, level.low, level.typical, level.high);
  }
  return table;
}

Table around_table(const std::vector<CountThere>& around) {
  Table table{"around",
              {{"omega", "speed [rad/s]", ".3f"},
               {"count", "collisions in the window"},
               {"per_turn", "a turn", ".3g"},
               {"certain", "certain", "mark"},
               {"doubt", "why not"}}};
  for (const CountThere& there : around) {
    table.add(rounded(there.omega), there.count, there.per_turn, there.certain, there.doubt);
  }
  return table;
}

std::string known_part_of(const QuietSpeedAnswer& output) {
  const QuietSpeed& answer = output.answer;
  std::string known;
  if (answer.reached && *answer.reached < answer.options.fastest) {
    if (answer.limit && !answer.split.first_loud) {
      known = fmt::format("up to {} it is quiet, {}; ", both_units(*answer.reached),
                          text_of(*answer.limit));
    }
    known += fmt::format("nothing is known from {:.6g} to {} rad/s", *answer.reached,
                         answer.options.fastest);
  } else if (answer.reached) {
    known = "the speeds are scanned, but not all that is said of them";
  }
  if (!output.left_out.empty()) {
    known +=
        fmt::format("{}left out: {}", known.empty() ? "" : "; ", fmt::join(output.left_out, ", "));
  }
  return known;
}

std::string headline_of(const QuietSpeedAnswer& output) {
  const QuietSpeed& answer = output.answer;
  const std::string range = fmt::format("up to {} rad/s", answer.options.fastest);
  if (answer.reached && !answer.fastest_quiet && !answer.split.first_loud) {
    return fmt::format("{}: the fastest quiet speed is not known: {}.", output.name,
                       known_part_of(output));
  }
  if (!answer.limit) {
    const auto& level = answer.staircase.levels.front();
    return fmt::format(
        "{}: there is no threshold {}: the count, {} to {}, makes no step by half or more. Say how "
        "much is too much: --allow, --allow-per-turn, --allow-energy or --allow-speed.",
        output.name, range, level.low, level.high);
  }
  if (!answer.split.first_loud) {
    return fmt::format("{}: every speed {} is quiet: {}.", output.name, range,
                       text_of(*answer.limit));
  }
  if (answer.loud_everywhere) {
    return fmt::format("{}: loud at every speed {}: {} is exceeded everywhere.", output.name, range,
                       text_of(*answer.limit));
  }
  if (!answer.fastest_quiet) {
    return fmt::format("{}: no speed is quiet: {} is broken at {} already.", output.name,
                       text_of(*answer.limit), both_units(*answer.split.first_loud));
  }
  return fmt::format("{}: the fastest quiet speed is {}: {}.", output.name,
                     both_units(*answer.fastest_quiet), text_of(*answer.limit));
}

std::optional<double> rounded(const std::optional<double>& speed) {
  return speed ? std::optional(std::round(*speed * 1e9) / 1e9) : std::nullopt;
}

QuietSpeedAnswer answer_quiet_speed(const std::string& name, const Scene& scene,
                                    const QuietSpeedOptions& options, double tolerance,
                                    const SceneFile& file) {
  QuietSpeedAnswer output{name, scene, quiet_speed(scene, options), {}, tolerance, {}, {}, {},
                          {},   {}};
  const QuietSpeed& answer = output.answer;
  const auto in_time = [&](const char* part, const auto& compute) {
    try {
      compute();
    } catch (const TimeLimitReached&) {
      output.left_out.emplace_back(part);
    }
  };
  if (!answer.is_of_the_long_run()) {
    in_time("share of the start",
            [&] { output.start = largest_start_share(scene, speeds_beside(answer)); });
  }
  if (!answer.limit || !answer.split.speed) return output;
  const Limit& limit = *answer.limit;
  const double divide = *answer.split.speed;
  in_time("sensitivities", [&] { output.sensitivities = sensitivities(scene, limit, divide); });
  if (tolerance > 0) {
    in_time("tolerance", [&] {
      output.range = tolerance_range(scene, limit, divide, tolerance, drawn_machines, 1);
    });
  }
  in_time("uncertainties",
          [&] { output.uncertain = uncertain_divide(file, limit, divide, drawn_machines, 1); });
  return output;
}

std::string text_of(const QuietSpeedAnswer& output) {
  const QuietSpeed& answer = output.answer;
  std::string text = headline_of(output) + "\n";
  if (!output.is_complete()) text += "Not complete: " + known_part_of(output) + ".\n";
  if (const Regime* doubtful = doubtful_regime(answer)) {
    text += fmt::format(
        "Not certain: from {:.3f} to {:.3f} rad/s borders between regimes may be missed, and turns "
        "with more collisions.\n",
        doubtful->from, doubtful->to);
  }
  if (answer.is_of_the_long_run()) {
    text += fmt::format("In the long run: {}.\n{}", summary_of(answer.regimes),
                        terminal_text_of(shown_regimes(answer.regimes)));
  } else if (answer.split.speed) {
    text += fmt::format("Quiet and loud divide best at {}.\n", both_units(*answer.split.speed));
  }
  text += text_of(output.sampled);
  if (!answer.around.empty()) text += terminal_text_of(around_table(answer.around));
  if (!answer.is_of_the_long_run() && !answer.reached) {
    text += answer.staircase.steps.empty()
                ? "The staircase has no step by half or more.\n"
                : "Steps of the staircase (a step is louder by half, and by two collisions):\n" +
                      terminal_text_of(step_table(answer.staircase.steps));
  }
  if (!answer.options.limit && !answer.staircase.steps.empty()) {
    text +=
        "Significance is how much louder times how long both levels last, on logarithmic axes; no "
        "speed beyond twice a step changes it, so that the end of the range does not matter.\n";
  }
  if (!output.sensitivities.empty()) {
    text += "One percent more moves this speed by:";
    for (const Sensitivity& s : output.sensitivities) {
      if (std::abs(s.percent) < 0.005) continue;
      text += fmt::format(" {} {:+.2f} %;", s.key, s.percent);
    }
    text.back() = '.';
    text += "\n";
  }
  for (const auto& sentence : {tolerance_sentence(output), uncertainty_sentence(output)}) {
    if (sentence) text += *sentence + "\n";
  }
  for (const std::string& note : notes_on(output.scene, output.start)) text += note + "\n";
  return text;
}

report::Json json_of(const QuietSpeedAnswer& output) {
  const QuietSpeed& answer = output.answer;
  Json moves = Json::object();
  for (const Sensitivity& s : output.sensitivities) moves[s.key] = s.percent;
  Json json = {
      {"regimes", json_rows_of(regime_table(answer.regimes))},
      {"fastest_quiet", rounded(answer.fastest_quiet)},
      {"fastest_quiet_rpm", Json()},
      {"limit", Json()},
      {"steps", json_rows_of(step_table(answer.staircase.steps))},
      {"levels", json_rows_of(level_table(answer.staircase.levels))},
      {"around", json_rows_of(around_table(answer.around))},
      {"percent_for_one", moves},
      {"reason", reason_of(answer)},
      {"complete", output.is_complete()},
      {"certain", answer.is_of_the_long_run() ? Json(doubtful_regime(answer) == nullptr) : Json()},
      {"reached", answer.reached},
      {"left_out", output.left_out},
      {"sampled", json_rows_of(sampled_table(output.sampled))},
      {"with_tolerance", Json()},
      {"with_uncertainties", Json()}};
  if (answer.fastest_quiet) json["fastest_quiet_rpm"] = *answer.fastest_quiet * rpm;
  json["release_speed"] = carrier_track::release_speed(output.scene);
  json["start_collisions"] = output.start ? Json(output.start->of_start) : Json();
  if (answer.limit) {
    json["limit"] = {{"measure", key_of(answer.limit->measure)},
                     {"at_most", answer.limit->at_most}};
  }
  if (output.range) {
    json["with_tolerance"] = {{"tolerance", output.tolerance}};
    json["with_tolerance"].update(json_of(*output.range));
  }
  if (output.uncertain) {
    Json effects = Json::object();
    for (const auto& [key, change] : output.uncertain->effects) effects[key] = change;
    Json& there = json["with_uncertainties"] = json_of(output.uncertain->range);
    there["first_order"] = output.uncertain->first_order;
    there["effects"] = effects;
  }
  return json;
}

namespace {

int count_in(const Scene& scene) {
  return static_cast<int>(std::lround(measured(scene, Measure::collisions)));
}

constexpr double later_turns = 10;

/// The scene with a longer window, by a ratio.
Scene with_longer_window(Scene scene, double ratio) {
  std::visit([ratio](auto& window) { window.count *= ratio; }, scene.window);
  return scene;
}

}  // namespace

std::string both_units(double omega) {
  return fmt::format("{:.3f} rad/s ({:.2f} rpm)", omega, omega * rpm);
}

StartShare start_share(const Scene& scene, double omega) {
  const Scene there = at_speed(scene, omega);
  const double turns = turns_of(there);
  const int count = count_in(there);
  const int later = count_in(with_longer_window(there, (turns + later_turns) / turns)) - count;
  const double of_motion = later * turns / later_turns;
  return {omega, turns, count,
          std::clamp(static_cast<int>(std::lround(count - of_motion)), 0, count)};
}

std::optional<StartShare> largest_start_share(const Scene& scene,
                                              const std::vector<double>& speeds) {
  std::optional<StartShare> largest;
  for (const double omega : speeds) {
    const StartShare share = start_share(scene, omega);
    if (!largest || share.of_start > largest->of_start) largest = share;
  }
  return largest;
}

std::vector<std::string> notes_on(const Scene& scene, const std::optional<StartShare>& share) {
  std::vector<std::string> notes;
  if (scene.restitution_lower != scene.restitution_upper) {
    notes.push_back(fmt::format("Restitution is {} at the lower wall and {} at the upper.",
                                scene.restitution_lower, scene.restitution_upper));
  }
  const std::optional<double> release = release_speed(scene);
  if (scene.friction * scene.normal_force > 0 && release != 0.0) {
    notes.push_back(
        release ? fmt::format("Friction holds the carrier still up to {}.", both_units(*release))
                : "Friction and the steady force hold the carrier still at every speed.");
  }
  if (share && share->dominates()) {
    notes.push_back(fmt::format(
        "The window of {:.3g} turns is short: {} of its {} collisions at {} are the start's, and "
        "do not come again. Take a longer window.",
        share->turns, share->of_start, share->count, both_units(share->omega)));
  }
  return notes;
}

std::string planar_sentence(const Scene& scene, double omega) {
  if (!scene.across) {
    return "No: the file has no clearance across the track. With a section [across] in your file "
           "the answer may differ.";
  }
  if (!couples(at_speed(scene, omega))) {
    return fmt::format(
        "No: at {:.3f} rad/s friction holds the carrier where it is across its track, so that the "
        "motion along it is the same.",
        omega);
  }
  return fmt::format(
      "Yes: at {:.3f} rad/s the carrier also moves across its track, or is pressed to a wall "
      "there, and friction couples this to the motion along it. With fidelity = \"planar\" in your "
      "file "
      "its window is counted in both directions.",
      omega);
}

std::optional<std::string> strongest_of(const QuietSpeedAnswer& output) {
  if (output.sensitivities.empty()) return std::nullopt;
  const auto& [key, percent] = output.sensitivities.front();
  const bool is_limit = key == "counting_limit";
  return fmt::format(
      "What moves this speed most is {}{}: one per cent more of it moves the speed by {:+.2f} %.",
      key, is_limit ? ", which says what counts as a collision" : "", percent);
}

std::optional<std::string> tolerance_sentence(const QuietSpeedAnswer& output) {
  if (!output.range) return std::nullopt;
  return fmt::format("With every constant uncertain by {:.3g} %, {}.", 100 * output.tolerance,
                     text_of(*output.range));
}

std::optional<std::string> uncertainty_sentence(const QuietSpeedAnswer& output) {
  return output.uncertain ? std::optional(text_of(*output.uncertain)) : std::nullopt;
}

}  // namespace ricochet::studies::advice
