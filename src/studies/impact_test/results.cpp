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
  Broken broken{measured.tool.name, from.scene.kind, from, from, score};
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

}  // namespace ricochet::studies::impact_test

namespace ricochet::studies {

Study impact_test_study(const impact_test::Plan& plan) {
  if (plan.scenes < 1 || plan.scenes > 1'000'000) {
    throw InputError(fmt::format("--scenes {}: must be within 1..1000000", plan.scenes));
  }
  const auto compute = [plan](bool quick) {
    impact_test::Plan chosen = plan;
    if (quick) chosen.scenes = std::min(chosen.scenes, impact_test::quick_scenes);
    return json_of(impact_test::results_of(impact_test::impact_test(chosen)));
  };
  return {"impact-test", fmt::format("A first look: {} scenes", impact_test::quick_scenes),
          compute};
}

}  // namespace ricochet::studies
