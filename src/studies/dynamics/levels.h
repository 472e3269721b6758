#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/certainty.h"
#include "src/report/json.h"

/// How much of the model a scene needs: what the cheaper levels get wrong, and what each costs.
namespace ricochet::studies::dynamics {

struct LevelPlan {
  double step;                     ///< [rad/s] of the speeds, up to 18
  std::vector<double> directions;  ///< tan phi of the yarn; with 0 it pulls along x alone
  double stiffness;                ///< [N/m^1.5] of the compliant level, law exact-restitution
  std::size_t cost_stride;         ///< every which speed is timed at all levels
};

/// One case over all speeds.
struct LevelRow {
  std::string id;
  int speeds = 0;
  int certain = 0;                  ///< counts that the impact level is certain of
  int resolved = 0;                 ///< of the others, those that the compliant level is
  std::array<int, 6> doubts{};      ///< of the impact level, by Doubt
  std::vector<int> coupled;         ///< a direction: speeds that need both directions
  std::vector<int> wrong;           ///< of those, where x alone counts otherwise
  std::array<double, 4> seconds{};  ///< processor time of impact, compliant, planar, auto
};

struct LevelStudy {
  LevelPlan plan;
  std::vector<LevelRow> rows;  ///< a case each
};

/// Every case of the paper in the default reading. For the second direction, which the paper's
/// objective leaves out, the clearance of the first is taken, with the carrier in its middle.
LevelStudy study_levels(const LevelPlan& plan);

/// Which level a scene needs, what the cheaper ones get wrong, and what each costs.
report::Json data_of(const LevelStudy& study);

}  // namespace ricochet::studies::dynamics
