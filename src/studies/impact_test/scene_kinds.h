#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ricochet/random.h"
#include "ricochet/scene.h"
#include "src/studies/impact_test/smallest_scene.h"

namespace ricochet::studies::impact_test {

/// Draws of a scene's numbers.
class Draw {
 public:
  explicit Draw(Random& random) : random_(random) {}

  double within(double a, double b);
  double log_within(double a, double b);  ///< 0 < a < b, uniform in the logarithm
  bool chance(double probability);

 private:
  Random& random_;
};

/// A scene as it is drawn. Its window may yet be cut, and its counting limit is set from its
/// impacts.
struct DrawnScene {
  carrier_track::Scene machine;
  double slowest_share = 1e-3;  ///< of the fastest impact: slower impacts are not scored
};

/// A kind of scene. What gets closer, smaller or longer with the difficulty is its own.
struct SceneKind {
  std::string name;
  std::string what;    ///< in words
  std::string harder;  ///< what the difficulty changes, in words, with the range
  DrawnScene (*draw)(Draw& draw, int difficulty);
};

const std::vector<SceneKind>& scene_kinds();

/// The first `count` scenes of a seed, drawn on all cores and kept in the file: those that are
/// there, of this seed and version, are not drawn again. Shows progress.
std::vector<ScoredScene> scene_set(int seed, int count, const std::filesystem::path& file);

}  // namespace ricochet::studies::impact_test
