#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/certainty.h"
#include "src/report/json.h"
#include "src/research/dynamics/fidelity.h"

/// Which level of the model does a scene need? Errors of the cheaper levels, and the cost of each.
namespace ricochet::studies::dynamics {

struct LevelPlan {
  double step;                     ///< [rad/s] of the speeds, up to 18
  std::vector<double> directions;  ///< tan phi of the yarn; with 0 it pulls along x alone
  double stiffness;                ///< [N/m^1.5] of the compliant level, law exact-restitution
  std::size_t cost_stride;         ///< every how many speeds all levels are timed
};

/// One case over all speeds.
struct LevelRow {
  std::string id;
  int speeds = 0;
  int certain = 0;                  ///< counts that the impact level is certain of
  int resolved = 0;                 ///< the others of which the compliant level is certain
  std::array<int, 6> doubts{};      ///< of the impact level, by Doubt
  std::vector<int> coupled;         ///< for each direction: speeds that need both directions
  std::vector<int> wrong;           ///< of those, speeds where the count of x alone differs
  std::array<double, 4> seconds{};  ///< processor time of impact, compliant, planar, auto
};

struct LevelStudy {
  LevelPlan plan;
  std::vector<LevelRow> rows;  ///< one for each case
};

/// Studies every case of the paper in the default interpretation. The second direction, which is
/// not in the paper's objective, has the clearance of the first, with the carrier in its middle.
LevelStudy study_levels(const LevelPlan& plan);

/// All cases with one direction of the yarn.
struct LevelDirection {
  double tangent, coupled, wrong;  ///< the latter two as shares of the speeds
};
RICOCHET_WRITTEN_AS_JSON(LevelDirection, tangent, coupled, wrong);

/// How certain a case's counts are, and the reasons if they are not.
struct LevelCase {
  std::string case_;
  int speeds;
  double certain;  ///< share
  int margin, window, graze, sensitive, resolved;
};
RICOCHET_WRITTEN_AS_JSON(LevelCase, case_, speeds, certain, margin, window, graze, sensitive,
                         resolved);

/// Processor time of a count relative to hard walls in one direction.
struct LevelCosts {
  std::string case_;
  double compliant, planar, automatic;
};
RICOCHET_WRITTEN_AS_JSON(LevelCosts, case_, compliant, planar, automatic);

struct WrongShares {
  std::string case_;
  std::vector<double> shares;  ///< one for each direction
};
RICOCHET_WRITTEN_AS_JSON(WrongShares, case_, shares);

struct LevelData {
  double stiffness = {};
  std::vector<LevelDirection> directions = {};
  std::vector<LevelCase> cases = {};
  std::vector<LevelCosts> costs = {};
  std::vector<WrongShares> wrong = {};
  int speeds = 0, certain = 0;
  double certain_share = 0;
  int uncertain = 0, resolved = 0;
};
RICOCHET_WRITTEN_AS_JSON(LevelData, stiffness, directions, cases, costs, wrong, speeds, certain,
                         certain_share, uncertain, resolved);

/// Which level a scene needs, the errors of the cheaper ones, and the cost of each.
LevelData data_of(const LevelStudy& study);

/// A level of the model over all cases: its cost, and how often its count differs from that of hard
/// walls in one direction, the reference.
struct LevelCost {
  std::string level;
  bool reference;
  std::optional<double> cost, wrong;  ///< processor time over that of the reference; a share
};
RICOCHET_WRITTEN_AS_JSON(LevelCost, level, reference, cost, wrong);

/// Whether the second direction is needed.
struct PlanarNeed {
  double most_wrong;       ///< largest share of wrong counts without it
  double largest_tangent;  ///< of the pull across to the pull along
};
RICOCHET_WRITTEN_AS_JSON(PlanarNeed, most_wrong, largest_tangent);

std::vector<LevelCost> level_costs(const FidelityData& walls, const LevelData& levels);
PlanarNeed planar_need(const LevelData& levels);

}  // namespace ricochet::studies::dynamics
