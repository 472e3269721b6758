#pragma once

#include <span>
#include <vector>

#include "ricochet/random.h"

namespace ricochet::fireworks {

/// How many of d coordinates a spark moves, and which.
enum class Moved {
  all,      ///< every one
  rounded,  ///< round(d U(0, 1)) of them, drawn without replacement: maybe none (Tan & Zhu's paper)
  ceiled,   ///< ceil(d U(0, 1)) of them: at least one (Tan & Zhu's program)
  coins,    ///< each with probability 1/2: maybe none (EFWA, dynFWA)
};

/// Draws the coordinates that each spark moves, from those given.
class Coordinates {
 public:
  explicit Coordinates(std::vector<Eigen::Index> all) : all_(std::move(all)) {}

  /// The coordinates that move, in any order; valid until the next call.
  std::span<const Eigen::Index> draw(Moved moved, Random& random);

 private:
  /// Draws `count` coordinates without replacement and moves them to the front.
  std::span<const Eigen::Index> first(std::size_t count, Random& random);

  std::vector<Eigen::Index> all_;
};

}  // namespace ricochet::fireworks
