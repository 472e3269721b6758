#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/report/results.h"
#include "src/report/site/study.h"
#include "src/studies/impact_test/score.h"
#include "src/studies/impact_test/simulator.h"

namespace ricochet::studies::impact_test {

struct Plan {
  int seed = 1;
  int scenes = 10'000;
  std::vector<Level> levels;
  std::vector<Tool> tools;       ///< beside ricochet's own levels
  bool needs_all = false;        ///< a tool that cannot be started is an error
  std::filesystem::path folder;  ///< keeps scenes, answers, drivers and logs
};

/// The level that tables compare, and whose scenes are shrunk: the usual one, if it is measured.
Level shown_level(const Plan& plan);

/// A simulator at a level.
struct Measured {
  Tool tool;
  std::string version;
  bool own;
  Level level;
  std::vector<Score> scores;  ///< one for each scene
  std::string cannot;         ///< a reason that it gives; empty if none
  std::string failure;        ///< the same for an error or for never
};

/// The smallest scene of a kind that was found to break a tool.
struct Broken {
  std::string tool, kind;
  ScoredScene from, smallest;
  Score score;  ///< of the smallest
};

/// A tool that cannot be started.
struct MissingTool {
  std::string tool, reason;
};

struct Results {
  Plan plan;
  std::vector<ScoredScene> scenes;
  std::vector<Measured> measured;  ///< simulator by simulator, ricochet first
  std::vector<MissingTool> missing;
  std::vector<Broken> broken;  ///< at most three for each simulator, of different kinds
};

/// Draws the scenes, asks everybody, and shrinks scenes that break somebody. Scenes and answers are
/// kept in the folder as they come, see scene_set and kept_answers. Throws InputError for a tool
/// that cannot be started if the plan needs all.
Results impact_test(const Plan& plan);

/// What the report has. Its value "lost" is what ricochet itself loses, per 1,000 impacts.
report::Results results_of(const Results& results);

}  // namespace ricochet::studies::impact_test

namespace ricochet::studies {

/// How many impacts simulators of impacts lose: ricochet, its own levels of the model, and tools.
/// `--quick` takes quick_scenes scenes.
Study impact_test_study(const impact_test::Plan& plan);

namespace impact_test {
inline constexpr int quick_scenes = 220;  ///< five of each kind and difficulty
}

}  // namespace ricochet::studies
