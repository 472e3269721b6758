#include "src/studies/impact_test/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "ricochet/error.h"
#include "src/core/files.h"
#include "src/core/progress.h"
#include "src/studies/impact_test/scene_kinds.h"
#include "src/studies/impact_test/score.h"
#include "src/studies/impact_test/smallest_scene.h"
#include "src/studies/impact_test/tool.h"

namespace ricochet::studies::impact_test {

namespace {

constexpr std::size_t most_shrunk = 3;  // scenes of a tool
constexpr int most_asks = 200;          // of a tool, to shrink a scene
constexpr std::chrono::seconds longest_shrinking{30};

/// The tools that can be started, behind ricochet's own levels. The others are noted.
std::vector<Simulator> simulators_of(const Plan& plan, std::vector<MissingTool>& missing) {
  std::vector<Simulator> simulators = own_simulators();
  for (const Tool& tool : plan.tools) {
    const FoundTool found = found_tool(tool, plan.folder / "drivers");
    if (found.program) {
      simulators.push_back(simulator_of(*found.program, plan.folder / "logs"));
    } else if (plan.needs_all) {
      throw InputError(
          fmt::format("{}: {}; --install-tools installs tools", tool.name, found.reason));
    } else {
      missing.push_back({tool.name, found.reason});
    }
  }
  return simulators;
}

/// The first line of a file of answers.
std::string origin_of(const Plan& plan, const Simulator& simulator, Level level) {
  return report::Json{{"version", suite_version},          {"seed", plan.seed},
                      {"tool", simulator.tool.name},       {"command", simulator.tool.run},
                      {"tool_version", simulator.version}, {"level", name_of(level)}}
      .dump();
}

std::vector<Answer> answers_of(const Results& results, const Simulator& simulator, Level level) {
  const Plan& plan = results.plan;
  Progress progress(fmt::format("{}, {}", simulator.tool.name, name_of(level)), plan.scenes);
  const Ask ask = simulator.open(level);
  std::vector<Answer> answers;
  if (simulator.own) {
    for (const ScoredScene& scored : results.scenes) {
      answers.push_back(ask(scored));
      progress.advance(1);
    }
    return answers;
  }
  const auto file = plan.folder / "answers" / name_of(level) / (simulator.tool.name + ".jsonl");
  return kept_answers(file, origin_of(plan, simulator, level), results.scenes,
                      [&](const ScoredScene& scored) {
                        Answer answer = ask(scored);
                        progress.advance(1);
                        return answer;
                      });
}

Measured measured_by(const Results& results, const Simulator& simulator, Level level) {
  Measured measured{simulator.tool, simulator.version, simulator.own, level, {}, "", ""};
  const std::vector<Answer> answers = answers_of(results, simulator, level);
  for (std::size_t k = 0; k < answers.size(); ++k) {
    measured.scores.push_back(score_of(answers[k], results.scenes[k]));
    const Ending ending = answers[k].ending;
    if (ending == Ending::answered) continue;
    std::string& reason = ending == Ending::cannot ? measured.cannot : measured.failure;
    if (reason.empty()) reason = answers[k].reason;
  }
  return measured;
}

/// The scenes to begin with, one of each of the kinds that break the simulator most, relative to
/// their impacts: the one with the fewest impacts. Answered ones come before those without an
/// answer, which take the whole time limit.
std::vector<std::size_t> scenes_to_shrink(const Results& results, const Measured& measured) {
  std::map<std::string, std::pair<int, int>> kinds;  // wrong, impacts
  for (std::size_t k = 0; k < measured.scores.size(); ++k) {
    auto& [wrong, impacts] = kinds[results.scenes[k].scene.kind];
    wrong += measured.scores[k].wrong();
    impacts += measured.scores[k].impacts;
  }
  const auto share = [&](std::size_t k) {
    const auto [wrong, impacts] = kinds[results.scenes[k].scene.kind];
    return impacts == 0 ? 0.0 : 1.0 * wrong / impacts;
  };
  const auto rank = [&](std::size_t k) {
    const Score& score = measured.scores[k];
    return std::tuple(score.ending != Ending::answered, -share(k), score.impacts);
  };
  std::map<std::string, std::size_t> firsts;  // by kind
  for (std::size_t k = 0; k < measured.scores.size(); ++k) {
    if (measured.scores[k].wrong() == 0) continue;
    const auto [first, is_new] = firsts.try_emplace(results.scenes[k].scene.kind, k);
    if (!is_new && rank(k) < rank(first->second)) first->second = k;
  }
  std::vector<std::size_t> chosen;
  for (const auto& [kind, k] : firsts) chosen.push_back(k);
  std::ranges::sort(chosen, {}, rank);
  if (chosen.size() > most_shrunk) chosen.resize(most_shrunk);
  return chosen;
}

Broken shrunk(const ScoredScene& from, const Score& score, const Measured& measured,
              const Ask& ask) {
  Broken broken{measured.tool.name, from.scene.kind, measured.level, from, from, score};
  const auto end = std::chrono::steady_clock::now() + longest_shrinking;
  const auto breaks = [&](const ScoredScene& scored) {
    if (std::chrono::steady_clock::now() > end) return false;
    const Score now = score_of(ask(scored), scored);
    if (now.wrong() == 0 || now.ending != broken.score.ending) return false;
    broken.score = now;
    return true;
  };
  broken.smallest = smallest_scene(from, breaks, most_asks);
  return broken;
}

/// Shrinks scenes that break the simulator, and keeps them for who wants to try them.
void add_broken(Results& results, const Measured& measured, const Simulator& simulator) {
  const auto chosen = scenes_to_shrink(results, measured);
  if (chosen.empty()) return;
  Progress::announce(fmt::format("shrinking scenes that break {}", simulator.tool.name));
  const Ask ask = simulator.open(measured.level);
  std::string lines;
  for (const std::size_t k : chosen) {
    results.broken.push_back(shrunk(results.scenes[k], measured.scores[k], measured, ask));
    lines += json_of(results.broken.back().smallest).dump() + "\n";
  }
  const auto folder = results.plan.folder / "smallest";
  std::filesystem::create_directories(below(results.plan.folder, "smallest"));
  write_text_file(folder / (simulator.tool.name + ".jsonl"), lines, SymbolicLinks::refused);
}

}  // namespace

Level shown_level(const Plan& plan) {
  const bool usual = std::ranges::find(plan.levels, Level::usual) != plan.levels.end();
  return usual ? Level::usual : plan.levels.front();
}

Results impact_test(const Plan& plan) {
  Results results{plan, {}, {}, {}, {}};
  std::filesystem::create_directories(plan.folder);
  const std::vector<Simulator> simulators = simulators_of(plan, results.missing);
  results.scenes = scene_set(plan.seed, plan.scenes, plan.folder / "scenes.jsonl");
  const AtInterruption kept([] {}, fmt::format("answers are kept in {}: the same command goes on",
                                               (plan.folder / "answers").string()));
  for (const Simulator& simulator : simulators) {
    for (const Level level : plan.levels) {
      try {
        Measured measured = measured_by(results, simulator, level);
        if (level == shown_level(plan)) add_broken(results, measured, simulator);
        results.measured.push_back(std::move(measured));
      } catch (const ToolFailure& error) {
        results.missing.push_back({simulator.tool.name, error.what()});
        break;
      }
    }
  }
  return results;
}

namespace {

using report::Json;
using report::list_of;

bool any_scene(const TestScene& /*scene*/) {
  return true;
}

std::function<bool(const TestScene&)> of_kind(const std::string& kind) {
  return [kind](const TestScene& scene) { return scene.kind == kind; };
}

std::function<bool(const TestScene&)> of_difficulty(int difficulty) {
  return [difficulty](const TestScene& scene) { return scene.difficulty == difficulty; };
}

/// What is lost of a group of scenes, per 1,000 impacts.
Json losses(const Tally& tally) {
  return {{"impacts", tally.impacts},
          {"missed", tally.per_thousand(tally.missed)},
          {"invented", tally.per_thousand(tally.invented)},
          {"wrong", tally.per_thousand(tally.missed + tally.invented)}};
}

/// A number that is drawn on a logarithmic axis: at least `least`.
Json drawn(const std::optional<double>& value, double least) {
  return value ? Json(std::max(*value, least)) : Json();
}

/// Least numbers that are drawn.
constexpr double least_time_error = 1e-16;

/// Half an impact of all, per 1,000.
double least_wrong(const Results& results) {
  int impacts = 0;
  for (const ScoredScene& s : results.scenes) impacts += scored_impacts(s.scene, s.truth);
  return 500.0 / std::max(impacts, 1);
}

/// The scores of one of ricochet's own levels at a level of accuracy: its times are a unit.
const std::vector<Score>& unit_of(const Results& results, const std::string& own, Level level) {
  const auto found = std::ranges::find_if(
      results.measured, [&](const Measured& m) { return m.tool.name == own && m.level == level; });
  return found->scores;
}

Json row_of(const Results& results, const Measured& measured) {
  const Tally tally = tally_of(measured.scores, results.scenes, any_scene);
  const auto& seconds = tally.seconds_per_impact;
  Json row = {{"tool", measured.tool.name},
              {"level", name_of(measured.level)},
              {"setting", measured.tool.levels[static_cast<std::size_t>(measured.level)]},
              {"own", measured.own},
              {"reference", measured.tool.name == "ricochet"},
              {"answered", tally.answered},
              {"cannot", tally.cannot},
              {"errors", tally.errors},
              {"never", tally.never},
              {"late", tally.per_thousand(tally.late)},
              {"wrong_speed", tally.per_thousand(tally.wrong_speed)},
              {"time_error", tally.time_error},
              {"penetration", tally.penetration},
              {"energy", tally.energy_gained},
              {"most_energy", tally.most_energy_gained},
              {"seconds", seconds},
              {"microseconds", seconds ? Json(1e6 * *seconds) : Json()},
              {"ratio", time_ratio(measured.scores, unit_of(results, "ricochet", measured.level))},
              {"scan_ratio",
               time_ratio(measured.scores, unit_of(results, "ricochet-scan", measured.level))}};
  row.update(losses(tally));
  row["reasons"] = measured.cannot.empty() || measured.failure.empty()
                       ? measured.cannot + measured.failure
                       : measured.cannot + "; " + measured.failure;
  return row;
}

/// A simulator at the shown level: by difficulty and by kind.
Json standing_of(const Results& results, const Measured& measured) {
  Json row = row_of(results, measured);
  row["title"] = measured.tool.title;
  row["kind"] = measured.tool.kind;
  row["version"] = measured.version;
  row["settings"] = Json::array();
  for (const Level level : results.plan.levels) {
    const std::string& words = measured.tool.levels[static_cast<std::size_t>(level)];
    if (!words.empty()) row["settings"].push_back(name_of(level) + ": " + words);
  }
  row["sets"] = measured.tool.sets;
  row["advice"] = measured.tool.advice;
  row["difficulties"] = Json::array();
  for (int d = 1; d <= difficulties; ++d) {
    row["difficulties"].push_back(
        losses(tally_of(measured.scores, results.scenes, of_difficulty(d))));
  }
  row["kinds"] = Json::array();
  Json worst;
  for (const SceneKind& kind : scene_kinds()) {
    const Json cell = losses(tally_of(measured.scores, results.scenes, of_kind(kind.name)));
    row["kinds"].push_back(
        cell["wrong"].is_null() ? Json() : Json(std::min(cell["wrong"].get<double>(), 1000.0)));
    if (cell["wrong"].is_null()) continue;
    if (worst.is_null() || cell["wrong"] > worst["wrong"]) {
      worst = {{"kind", kind.name}, {"wrong", cell["wrong"]}};
    }
  }
  row["worst"] = !worst.is_null() && worst["wrong"] > 0 ? worst : Json();
  return row;
}

/// Whom nothing is lost by, then the others in the order of their losses; ricochet first.
Json standings_of(const Results& results) {
  std::vector<Json> rows;
  for (const Measured& m : results.measured) {
    if (m.level == shown_level(results.plan)) rows.push_back(standing_of(results, m));
  }
  const auto loss = [](const Json& row) {
    return std::tuple(row["reference"] != true,
                      row["wrong"].is_null() ? 1e9 : row["wrong"].get<double>(),
                      row["seconds"].is_null() ? 1e9 : row["seconds"].get<double>());
  };
  std::ranges::stable_sort(rows, {}, loss);
  return rows;
}

/// Time and errors of a simulator at a level, as they are drawn.
Json drawn_level(const Results& results, const Measured& measured) {
  const Tally tally = tally_of(measured.scores, results.scenes, any_scene);
  const auto wrong = tally.per_thousand(tally.missed + tally.invented);
  return {{"seconds", tally.seconds_per_impact},
          {"wrong", drawn(wrong, least_wrong(results))},
          {"error", drawn(tally.time_error, least_time_error)}};
}

/// The levels of each simulator: what a tighter setting buys.
Json series_of(const Results& results) {
  Json series = Json::array();
  for (const Measured& m : results.measured) {
    if (series.empty() || series.back()["tool"] != m.tool.name) {
      series.push_back({{"tool", m.tool.name}, {"rows", Json::array()}});
    }
    series.back()["rows"].push_back(drawn_level(results, m));
  }
  return series;
}

/// The same by kind of simulator; the level that is shown has the simulator's name.
Json dots_of(const Results& results) {
  std::map<std::string, Json> kinds;
  for (const Measured& m : results.measured) {
    Json row = drawn_level(results, m);
    row["name"] = m.level == shown_level(results.plan) ? m.tool.name : "";
    kinds[m.tool.kind].push_back(std::move(row));
  }
  Json dots = Json::array();
  for (auto& [kind, rows] : kinds) dots.push_back({{"kind", kind}, {"rows", std::move(rows)}});
  return dots;
}

Json json_of_broken(const Broken& broken) {
  return {{"tool", broken.tool},
          {"level", name_of(broken.level)},
          {"kind", broken.kind},
          {"scene", words_of(broken.smallest.machine)},
          {"from", broken.from.scene.scene},
          {"from_impacts", scored_impacts(broken.from.scene, broken.from.truth)},
          {"impacts", broken.score.impacts},
          {"missed", broken.score.missed},
          {"invented", broken.score.invented},
          {"answered", broken.score.ending == Ending::answered}};
}

Json kinds_data(const Results& results) {
  Json kinds = Json::array();
  for (const SceneKind& kind : scene_kinds()) {
    int scenes = 0, impacts = 0;
    for (const ScoredScene& s : results.scenes) {
      if (s.scene.kind != kind.name) continue;
      ++scenes;
      impacts += scored_impacts(s.scene, s.truth);
    }
    kinds.push_back({{"name", kind.name},
                     {"what", kind.what},
                     {"harder", kind.harder},
                     {"scenes", scenes},
                     {"impacts", impacts}});
  }
  return kinds;
}

/// The kind of scene in which most tools miss or invent an impact.
Json hardest_kind(const Json& standings) {
  Json hardest = {{"tools", 0}};
  for (std::size_t k = 0; k < scene_kinds().size(); ++k) {
    const auto tools = std::ranges::count_if(standings, [&](const Json& row) {
      return row["own"] == false && row["kinds"][k].is_number() && row["kinds"][k] > 0;
    });
    if (tools > hardest["tools"]) hardest = {{"kind", scene_kinds()[k].name}, {"tools", tools}};
  }
  return hardest.contains("kind") ? hardest : Json();
}

/// The scores of the tools, in a few numbers for the headline.
Json finding_data(const Json& standings) {
  int others = 0, clean = 0;
  Json best, worst;
  for (const Json& row : standings) {
    if (row["own"] == true || row["wrong"].is_null()) continue;
    ++others;
    clean += row["wrong"] == 0 ? 1 : 0;
    const Json one = {{"tool", row["tool"]}, {"wrong", row["wrong"]}, {"ratio", row["ratio"]}};
    if (best.is_null()) best = one;
    worst = one;
  }
  return {{"tools", others},
          {"clean", clean},
          {"best", best},
          {"worst", worst},
          {"hardest", hardest_kind(standings)}};
}

}  // namespace

Json data_of(const Results& results) {
  const Json standings = standings_of(results);
  Json rows = Json::array();
  for (const Measured& m : results.measured) rows.push_back(row_of(results, m));
  int impacts = 0;
  double sensitivity = 0;
  for (const ScoredScene& s : results.scenes) {
    impacts += scored_impacts(s.scene, s.truth);
    for (const TrueImpact& i : s.truth) sensitivity = std::max(sensitivity, i.time_sensitivity);
  }
  Json own = Json::array();
  for (const Json& row : rows) {
    if (row["own"] != true) continue;
    own.push_back(Json::object());
    for (const char* key : {"tool", "level", "setting", "missed", "invented", "late", "wrong_speed",
                            "penetration", "microseconds", "ratio"}) {
      own.back()[key] = row[key];
    }
  }
  return {{"suite",
           {{"version", suite_version},
            {"seed", results.plan.seed},
            {"scenes", results.scenes.size()},
            {"impacts", impacts},
            {"kinds", scene_kinds().size()},
            {"sensitivity", sensitivity}}},
          {"shown", name_of(shown_level(results.plan))},
          {"kinds", kinds_data(results)},
          {"difficulties", {"1", "2", "3", "4"}},
          {"standings", standings},
          {"ours", standings.front()},
          {"found", finding_data(standings)},
          {"rows", rows},
          {"own_rows", own},
          {"series", series_of(results)},
          {"dots", dots_of(results)},
          {"broken", list_of(results.broken, json_of_broken)},
          {"missing", list_of(results.missing,
                              [](const MissingTool& m) -> Json {
                                return {{"tool", m.tool}, {"reason", m.reason}};
                              })},
          {"least_wrong", least_wrong(results)}};
}

}  // namespace ricochet::studies::impact_test

namespace ricochet::studies {

Study impact_test_study(const impact_test::Plan& plan) {
  if (plan.scenes < 1 || plan.scenes > 1'000'000) {
    throw InputError(fmt::format("--scenes {}: must be within 1..1000000", plan.scenes));
  }
  const auto compute = [plan](bool quick) {
    impact_test::Plan chosen = plan;
    if (quick) chosen.scenes = std::min(chosen.scenes, impact_test::quick_scenes);
    return impact_test::data_of(impact_test::impact_test(chosen));
  };
  return {"impact-test", fmt::format("A first look: {} scenes", impact_test::quick_scenes),
          compute};
}

}  // namespace ricochet::studies
