#include "src/research/impact_test/scene_set.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "ricochet/error.h"
#include "src/core/interruption.h"
#include "src/core/progress.h"
#include "src/core/text_file.h"

namespace ricochet::studies::impact_test {
namespace {

using report::Json;

/// Scenes are drawn, and then written, in groups of so many.
constexpr int drawn_at_once = 256;

/// The scenes of this seed and version that begin a file.
std::vector<ScoredScene> scenes_in(const std::filesystem::path& file, int seed, int count) {
  std::vector<ScoredScene> scenes;
  std::istringstream in(std::filesystem::exists(file) ? text_of_file(file) : "");
  for (std::string line; static_cast<int>(scenes.size()) < count && std::getline(in, line);) {
    const Json json = Json::parse(line, nullptr, false);
    try {
      if (json.at("version") != suite_version || json.at("seed") != seed) break;
      scenes.push_back(scored_scene_of(json));
    } catch (const Json::exception&) {
      break;  // a line that was cut off
    }
  }
  return scenes;
}

std::string text_of(const std::vector<ScoredScene>& scenes) {
  std::string text;
  for (const ScoredScene& scored : scenes) text += json_of(scored).dump() + "\n";
  return text;
}

}  // namespace

std::vector<ScoredScene> scene_set(int seed, int count, const std::filesystem::path& file) {
  std::vector<ScoredScene> scenes = scenes_in(file, seed, count);
  if (static_cast<int>(scenes.size()) == count) return scenes;
  write_text_file(file, text_of(scenes), SymbolicLinks::refused);
  const AtInterruption kept(
      [] {}, fmt::format("scenes are kept in {}: the same command goes on", file.string()));
  Progress progress("drawing scenes, with their true impacts", count);
  progress.advance(static_cast<double>(scenes.size()));
  while (static_cast<int>(scenes.size()) < count) {
    const int first = static_cast<int>(scenes.size());
    std::vector<ScoredScene> drawn(
        static_cast<std::size_t>(std::min(drawn_at_once, count - first)));
    tbb::parallel_for(std::size_t{0}, drawn.size(), [&](std::size_t k) {
      drawn[k] = drawn_scene(seed, first + static_cast<int>(k));
      progress.advance(1);
    });
    const Uninterrupted whole;
    std::ofstream(file, std::ios::binary | std::ios::app) << text_of(drawn);
    std::ranges::move(drawn, std::back_inserter(scenes));
  }
  return scenes;
}

}  // namespace ricochet::studies::impact_test
