#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/progress.h"
#include "src/studies/simulators/suite.h"

/// Speed against accuracy of every simulator, and what each loses.
namespace ricochet::studies::simulators {

namespace {

using report::Chart;
using report::Mark;
using report::Scale;
using report::Series;

constexpr std::size_t most_shrunk = 3;  // scenes of a simulator
constexpr int most_asks = 200;          // of a simulator, to shrink a scene
constexpr std::chrono::seconds longest_shrinking{10};

/// A simulator at a level, with its scores scene by scene.
struct Measured {
  Tool tool;
  std::string version;
  bool own;
  Level level;
  std::vector<Score> scores = {};
  std::string cannot = {};   ///< a reason that it gives; empty if none
  std::string failure = {};  ///< the same for an error or for never
  Tally tally = {};
  std::vector<std::optional<double>> kinds = {};  ///< missed or invented per 1,000 impacts
  std::string worst = {};                         ///< kind; empty if it loses nothing
};

struct Results {
  const Plan& plan;
  Level shown;  ///< that tables compare, and whose scenes are shrunk: the usual one, if measured
  std::vector<ScoredScene> scenes = {};
  int impacts = 0;
  std::vector<Measured> measured = {};  ///< simulator by simulator, ricochet first
  Table missing{"missing", {{"tool"}, {"reason"}}};
  Table smallest{"smallest-scenes",
                 {{"tool"},
                  {"kind"},
                  {"scene", "smallest scene"},
                  {"impacts"},
                  {"from_impacts", "of"},
                  {"missed"},
                  {"invented"},
                  {"answered"}}};
};

/// Draws the scenes on all cores, and writes them for who wants to read them.
void draw(Results& results) {
  Progress progress("drawing scenes, with their true impacts", results.plan.scenes);
  results.scenes.resize(static_cast<std::size_t>(results.plan.scenes));
  tbb::parallel_for(std::size_t{0}, results.scenes.size(), [&](std::size_t k) {
    results.scenes[k] = drawn_scene(results.plan.seed, static_cast<int>(k));
    progress.advance(1);
  });
  std::string text;
  for (const ScoredScene& scored : results.scenes) {
    results.impacts += scored_impacts(scored.scene, scored.truth);
    text += json_of(scored).dump() + "\n";
  }
  write_text_file(results.plan.folder / "scenes.jsonl", text, SymbolicLinks::refused);
}

/// ricochet's own, and the tools that can be started. The others are noted.
std::vector<Simulator> simulators_of(Results& results) {
  std::vector<Simulator> simulators = own_simulators();
  for (const std::string& name : carrier_track::reference_integrators::methods_not_built())
    results.missing.add(name, "ricochet was built without SUNDIALS");
  for (const Tool& tool : results.plan.tools) {
    const FoundTool found = found_tool(tool, results.plan.folder / "drivers");
    if (found.reason.empty()) {
      simulators.push_back(simulator_of(found, results.plan.folder / "logs"));
    } else if (results.plan.needs_all) {
      throw InputError(
          fmt::format("{}: {}; --install-tools installs tools", tool.name, found.reason));
    } else {
      results.missing.add(tool.name, found.reason);
    }
  }
  return simulators;
}

std::vector<Answer> answers_of(const Results& results, const Simulator& simulator, Level level) {
  const int count = simulator.own ? results.plan.scenes : results.plan.tool_scenes;
  const std::span scenes(results.scenes.data(), static_cast<std::size_t>(count));
  Progress progress(fmt::format("{}, {}", simulator.tool.name, name_of(level)), count);
  const Ask ask = [&, asked = simulator.open(level)](const ScoredScene& scored) {
    Answer answer = asked(scored);
    progress.advance(1);
    return answer;
  };
  if (simulator.own) {
    std::vector<Answer> answers;
    for (const ScoredScene& scored : scenes) answers.push_back(ask(scored));
    return answers;
  }
  const report::Json origin = {{"version", suite_version},
                               {"seed", results.plan.seed},
                               {"tool", simulator.tool.name},
                               {"command", simulator.tool.run},
                               {"tool_version", simulator.version},
                               {"level", name_of(level)},
                               {"driver", driver_hash(simulator.tool)}};
  const auto folder = results.plan.folder / "answers" / name_of(level);
  return kept_answers(folder / (simulator.tool.name + ".jsonl"), origin.dump(), scenes, ask);
}

Measured measured_by(const Results& results, const Simulator& simulator, Level level) {
  Measured measured{simulator.tool, simulator.version, simulator.own, level};
  const std::vector<Answer> answers = answers_of(results, simulator, level);
  for (std::size_t k = 0; k < answers.size(); ++k) {
    measured.scores.push_back(score_of(answers[k], results.scenes[k]));
    const Ending ending = answers[k].ending;
    if (ending == Ending::answered) continue;
    std::string& reason = ending == Ending::cannot ? measured.cannot : measured.failure;
    if (reason.empty()) reason = answers[k].reason;
  }
  measured.tally = tally_of(measured.scores);
  double most = 0;
  for (const SceneKind& kind : scene_kinds()) {
    std::vector<Score> scores;
    for (std::size_t k = 0; k < answers.size(); ++k)
      if (results.scenes[k].scene.kind == kind.name) scores.push_back(measured.scores[k]);
    const auto wrong = tally_of(scores).wrong();
    measured.kinds.push_back(wrong);
    if (wrong.value_or(0) <= most) continue;
    most = *wrong;
    measured.worst = kind.name;
  }
  return measured;
}

/// The scenes to begin with, one of each of the kinds that break the simulator most: the one with
/// the fewest impacts. Answered ones come before those without an answer, which take the whole time
/// limit.
std::vector<std::size_t> scenes_to_shrink(const Results& results, const Measured& measured) {
  const auto kind_of = [&](std::size_t k) { return results.scenes[k].scene.kind; };
  const auto rank = [&](std::size_t k) {
    const Score& score = measured.scores[k];
    const auto kind = std::ranges::find(scene_kinds(), kind_of(k), &SceneKind::name);
    const auto wrong = measured.kinds[static_cast<std::size_t>(kind - scene_kinds().begin())];
    return std::tuple(score.ending != Ending::answered, -wrong.value_or(0), score.impacts);
  };
  std::map<std::string, std::size_t> firsts;  // by kind
  for (std::size_t k = 0; k < measured.scores.size(); ++k) {
    if (measured.scores[k].wrong() == 0) continue;
    const auto [first, is_new] = firsts.try_emplace(kind_of(k), k);
    if (!is_new && rank(k) < rank(first->second)) first->second = k;
  }
  std::vector<std::size_t> chosen;
  for (const auto& [kind, k] : firsts) chosen.push_back(k);
  std::ranges::sort(chosen, {}, rank);
  if (chosen.size() > most_shrunk) chosen.resize(most_shrunk);
  return chosen;
}

/// Shrinks scenes that break the simulator, and keeps them for who wants to try them.
void add_smallest(Results& results, const Measured& measured, const Simulator& simulator) {
  const auto chosen = scenes_to_shrink(results, measured);
  if (chosen.empty()) return;
  Progress::announce(fmt::format("shrinking scenes that break {}", simulator.tool.name));
  const Ask ask = simulator.open(measured.level);
  std::string lines;
  for (const std::size_t k : chosen) {
    const ScoredScene& from = results.scenes[k];
    Score score = measured.scores[k];
    const auto end = std::chrono::steady_clock::now() + longest_shrinking;
    const auto breaks = [&](const ScoredScene& scored) {
      if (std::chrono::steady_clock::now() > end) return false;
      const Score now = score_of(ask(scored), scored);
      if (now.wrong() == 0 || now.ending != score.ending) return false;
      score = now;
      return true;
    };
    const ScoredScene smallest = smallest_scene(from, breaks, most_asks);
    results.smallest.add(measured.tool.name, from.scene.kind, words_of(smallest.machine),
                         score.impacts, scored_impacts(from.scene, from.truth), score.missed,
                         score.invented, score.ending == Ending::answered);
    lines += json_of(smallest).dump() + "\n";
  }
  std::filesystem::create_directories(below(results.plan.folder, "smallest"));
  write_text_file(results.plan.folder / "smallest" / (simulator.tool.name + ".jsonl"), lines,
                  SymbolicLinks::refused);
}

void measure(Results& results) {
  std::filesystem::create_directories(results.plan.folder);
  const std::vector<Simulator> simulators = simulators_of(results);
  draw(results);
  const AtInterruption kept([] {}, fmt::format("answers are kept in {}: the same command goes on",
                                               (results.plan.folder / "answers").string()));
  for (const Simulator& simulator : simulators) {
    const auto& settings = simulator.tool.levels;
    const bool has_settings = !simulator.own || settings.front() != settings.back();
    for (const Level level : results.plan.levels) {
      if (!has_settings && level != results.shown) continue;
      try {
        results.measured.push_back(measured_by(results, simulator, level));
        if (level == results.shown) add_smallest(results, results.measured.back(), simulator);
      } catch (const ToolFailure& error) {
        results.missing.add(simulator.tool.name, error.what());
        break;
      }
    }
  }
}

/// The simulators at the shown level: ricochet first, then the others in the order of their losses.
std::vector<const Measured*> ranked(const Results& results) {
  std::vector<const Measured*> all;
  for (const Measured& m : results.measured)
    if (m.level == results.shown) all.push_back(&m);
  std::ranges::stable_sort(all, {}, [first = all.front()](const Measured* m) {
    return std::tuple(m != first, m->tally.wrong().value_or(1e9),
                      m->tally.seconds_per_impact.value_or(1e9));
  });
  return all;
}

/// The median, over the scenes that both have answered, of the time over that of ricochet.
std::optional<double> time_ratio(const Measured& measured, const Measured& ricochet) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < measured.scores.size(); ++k) {
    const auto &own = measured.scores[k].seconds_per_impact,
               &its = ricochet.scores[k].seconds_per_impact;
    if (own && its && *its > 0) ratios.push_back(*own / *its);
  }
  return median_of(std::move(ratios));
}

std::optional<double> microseconds_of(const Tally& tally) {
  const auto& seconds = tally.seconds_per_impact;
  return seconds ? std::optional(1e6 * *seconds) : std::nullopt;
}

Table simulators_table(const std::vector<const Measured*>& shown) {
  Table table{"simulators",
              {{"simulator"},
               {"version"},
               {"missed", "", ".1f"},
               {"invented", "", ".1f"},
               {"late", "", ".1f"},
               {"microseconds", "time [us]", ".3g"},
               {"ratio", "time ratio", ".1f"},
               {"worst", "worst kind"},
               {"title"},
               {"kind"},
               {"reasons"},
               {"sets"},
               {"advice"}}};
  for (const Measured* m : shown) {
    const Tally& tally = m->tally;
    const bool both = !m->cannot.empty() && !m->failure.empty();
    const std::string reasons = m->cannot + (both ? "; " : "") + m->failure;
    table.add(m->tool.name, m->version, tally.per_thousand(tally.missed),
              tally.per_thousand(tally.invented), tally.per_thousand(tally.late),
              microseconds_of(tally), time_ratio(*m, *shown.front()), m->worst, m->tool.title,
              m->tool.kind, reasons, m->tool.sets, m->tool.advice);
  }
  return table;
}

/// Every simulator at every level that it has.
Table levels_table(const Results& results) {
  Table table{"levels",
              {{"simulator"},
               {"level"},
               {"setting"},
               {"missed", "", ".1f"},
               {"invented", "", ".1f"},
               {"late", "", ".1f"},
               {"wrong_speed", "", ".1f"},
               {"time_error", "time error", ".1e"},
               {"penetration", "penetration [m]", ".1e"},
               {"microseconds", "time [us]", ".3g"},
               {"cannot"},
               {"errors"},
               {"never"}}};
  for (const Measured& m : results.measured) {
    const Tally& tally = m.tally;
    table.add(m.tool.name, name_of(m.level), m.tool.levels[static_cast<std::size_t>(m.level)],
              tally.per_thousand(tally.missed), tally.per_thousand(tally.invented),
              tally.per_thousand(tally.late), tally.per_thousand(tally.wrong_speed),
              tally.time_error, tally.penetration, microseconds_of(tally), tally.cannot,
              tally.errors, tally.never);
  }
  return table;
}

/// Methods and tools: not ricochet and the levels of its model.
bool is_rival(const Measured& measured) {
  return !measured.tool.kind.starts_with("ricochet");
}

/// The kinds of scenes, with how many methods and tools miss or invent an impact in each.
Table kinds_table(const Results& results, const std::vector<const Measured*>& shown) {
  Table table{"kinds", {{"kind"}, {"what"}, {"harder"}, {"scenes"}, {"impacts"}, {"lost_by"}}};
  for (std::size_t k = 0; k < scene_kinds().size(); ++k) {
    const SceneKind& kind = scene_kinds()[k];
    int scenes = 0, impacts = 0;
    for (const ScoredScene& s : results.scenes) {
      if (s.scene.kind != kind.name) continue;
      ++scenes;
      impacts += scored_impacts(s.scene, s.truth);
    }
    table.add(kind.name, kind.what, kind.harder, scenes, impacts,
              std::ranges::count_if(shown, [&](const Measured* m) {
                return is_rival(*m) && m->kinds[k].value_or(0) > 0;
              }));
  }
  return table;
}

Chart kinds_chart(const std::vector<const Measured*>& shown, const Table& kinds) {
  const Table hardest = sorted(kinds, {"-lost_by"});
  Chart chart{.name = "kinds",
              .title = fmt::format("{:.0f} methods and tools lose impacts in scenes of the kind {}",
                                   hardest[0].number("lost_by"), hardest[0].text("kind")),
              .x = {"kind"},
              .y = {""},
              .heat_map = report::HeatMap{"per 1,000", {}, report::Range{0, 1000}},
              .width = 900,
              .height = 170 + 22 * static_cast<int>(shown.size()),
              .description =
                  "Heat map of the impacts that each simulator loses, over the kind of "
                  "scene."};
  for (const SceneKind& kind : scene_kinds()) chart.x.categories.push_back(kind.name);
  for (auto m = shown.rbegin(); m != shown.rend(); ++m) {
    chart.y.categories.push_back((*m)->tool.name);
    auto& row = chart.heat_map->rows.emplace_back();
    for (const auto& wrong : (*m)->kinds)
      row.push_back(wrong ? std::optional(std::min(*wrong, 1000.0)) : std::nullopt);
  }
  return chart;
}

std::string losses_in_words(const Measured& measured) {
  const double wrong = measured.tally.wrong().value_or(0);
  return wrong < 1000 ? fmt::format("{:.3g}", wrong) : fmt::format("{:.0f}", wrong);
}

/// Losses over the time of an impact: the levels of each simulator are joined, and the shown level
/// has its name.
Chart speed_accuracy_chart(const Results& results, const std::vector<const Measured*>& shown) {
  const Measured& most = **std::ranges::max_element(
      shown, {}, [](const Measured* m) { return m->tally.wrong().value_or(0); });
  const double least = 500.0 / std::max(results.impacts, 1);  // half an impact of all, per 1,000
  Chart chart{
      .name = "speed-accuracy",
      .title = fmt::format("Of 1,000 impacts ricochet loses {}, the other simulators up to {}",
                           losses_in_words(*shown.front()), losses_in_words(most)),
      .x = {"time per impact [s]", Scale::logarithmic},
      .y = {"impacts missed or invented, per 1,000", Scale::logarithmic},
      .lines = {{report::Direction::horizontal, least, "none"}},
      .width = 900,
      .height = 560};
  std::map<std::string, Series> kinds;
  std::string last;
  for (const Measured& m : results.measured) {
    if (m.tool.name != last) chart.series.push_back({.label = "", .samples = {}, .pale = true});
    last = m.tool.name;
    const auto seconds = m.tally.seconds_per_impact, wrong = m.tally.wrong();
    if (!seconds || !wrong) continue;
    const double drawn = std::max(*wrong, least);
    chart.series.back().samples.push_back({*seconds, drawn});
    Series& dots = kinds[m.tool.kind];
    dots.label = m.tool.kind;
    dots.mark = Mark::points;
    dots.samples.push_back({*seconds, drawn, {}, m.level == results.shown ? m.tool.name : ""});
  }
  std::erase_if(chart.series, [](const Series& series) { return series.samples.empty(); });
  for (Series& series : chart.series)
    std::ranges::sort(series.samples, {}, &report::Sample::position);
  for (auto& [kind, dots] : kinds) chart.series.push_back(std::move(dots));
  return chart;
}

std::string finding_of(const Results& results, const std::vector<const Measured*>& shown) {
  const Tally& own = shown.front()->tally;
  std::string text = fmt::format(
      "Of {} impacts, ricochet loses {} per 1,000, and takes {:.2g} µs per impact.",
      results.impacts, losses_in_words(*shown.front()), microseconds_of(own).value_or(0));
  std::vector<const Measured*> rivals;
  std::ranges::copy_if(shown, std::back_inserter(rivals),
                       [](const Measured* m) { return is_rival(*m) && m->tally.wrong(); });
  if (rivals.empty()) return text;
  const auto clean =
      std::ranges::count_if(rivals, [](const Measured* m) { return m->tally.wrong() == 0; });
  const auto told = [](const Measured* m) {
    return fmt::format("{}, {}", m->tool.name, losses_in_words(*m));
  };
  return text + fmt::format(
                    " Of {} other methods and tools, {} lose none and {} lose some: the best, {} "
                    "per 1,000 in {:.0f} times the time; the worst, {}.",
                    rivals.size(), clean, std::ssize(rivals) - clean, told(rivals.front()),
                    time_ratio(*rivals.front(), *shown.front()).value_or(0), told(rivals.back()));
}

}  // namespace

void add_losses(report::Results& all, const Plan& plan) {
  const bool usual = std::ranges::find(plan.levels, Level::usual) != plan.levels.end();
  Results results{plan, usual ? Level::usual : plan.levels.front()};
  measure(results);
  const std::vector<const Measured*> shown = ranked(results);
  all.set("losses-finding", finding_of(results, shown));
  all.set("suite", suite_version);
  all.set("seed", plan.seed);
  all.set("scenes", results.scenes.size());
  all.set("impacts", results.impacts);
  all.set("tool-scenes", plan.tool_scenes);
  all.set("tool-seconds", TimeLimits().scene.count());
  all.set("level", name_of(results.shown));
  all.set("lost", shown.front()->tally.wrong());
  all.set("rivals", std::ranges::count_if(shown, [](const Measured* m) { return is_rival(*m); }));
  all.add(simulators_table(shown));
  all.add(levels_table(results));
  Table kinds = kinds_table(results, shown);
  all.add(kinds_chart(shown, kinds));
  all.add(std::move(kinds));
  all.add(sorted(std::move(results.smallest), {"impacts"}));
  all.add(std::move(results.missing));
  all.add(speed_accuracy_chart(results, shown));
}

}  // namespace ricochet::studies::simulators
