#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "src/core/files.h"
#include "src/studies/simulators/suite.h"

namespace ricochet::studies::simulators {

/// A scene of ten seconds with impacts on the lower wall at the times 1, 2, ... and speed 1, which
/// need not be a motion. Slower impacts than 0.1 do not count.
inline ScoredScene with_impacts(int number) {
  ScoredScene scored;
  scored.scene.scene = "made";
  scored.scene.kind = "bouncing";
  scored.scene.duration = number + 1;
  scored.scene.slowest = 0.1;
  for (int k = 1; k <= number; ++k) scored.truth.push_back({double(k), Wall::lower, 1, 0, 0});
  return scored;
}

/// The answer that has exactly the true impacts.
inline Answer right_answer(const ScoredScene& scored) {
  Answer answer{scored.scene.scene};
  for (const TrueImpact& i : scored.truth) answer.impacts.push_back({i.time, i.wall, i.speed});
  answer.seconds = 0.5;
  return answer;
}

inline std::string text_in(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::filesystem::path write_file(const std::filesystem::path& file,
                                        const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

}  // namespace ricochet::studies::simulators
