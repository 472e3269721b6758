#pragma once

#include <optional>

namespace ricochet::cli {

struct VerifyOptions {
  int scenes = 10000;
  int seed = 1;
  std::optional<int> scene_index;  ///< shows this scene instead
  bool json = false;
};

/// Sets the impact model against the oracle: over random and hostile scenes, and over the quiet
/// speeds of every case. Returns the exit code: 1 where a count called certain is wrong.
int verify(const VerifyOptions& options);

}  // namespace ricochet::cli
