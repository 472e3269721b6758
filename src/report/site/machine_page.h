#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/site/entries.h"
#include "src/report/site/front.h"
#include "src/report/site/navigation.h"

namespace ricochet::site {

/// The page about the machines, src/report/site/machines.md, from what the reports say, see
/// site_results(): how fast the paper's turn, what moves that speed, and whether the level of the
/// model matters.
OwnFiles machine_page(report::Results site, const std::vector<FoundReport>& reports);
Place machine_place();

/// Shows each machine of a table (case, silent_up_to, quiet_up_to, paper_threshold [rad/s]) as a
/// column: silent, quiet and loud speeds, and the paper's threshold.
report::Chart regimes_chart(const ricochet::Table& thresholds);

/// The range of the machines' fastest quiet speeds in a sentence; nothing if none has one.
std::optional<std::string> speed_sentence(const ricochet::Table& thresholds);

/// How the counts of other levels of the model compare with those of hard walls.
struct ModelLevels {
  struct Walls {
    std::string stiffness;        ///< [N/m^1.5], "1e10"
    std::int64_t compared;        ///< counts
    std::optional<double> share;  ///< of them, equal
  };

  std::vector<Walls> walls;  ///< compliant, the softest first
  double most_wrong;         ///< largest share of counts that differ with the second direction
  double largest_tangent;    ///< of the pull across to that along, up to which that holds
};

/// Reads them from the first report of the simulation's methods. Nothing if there is none that can
/// be read.
std::optional<ModelLevels> model_levels(const std::vector<FoundReport>& reports);

/// "Compliant walls of 1e10 N/m^1.5 agree with hard ones in 29 % of 72 counts, ..."; nothing
/// without walls.
std::optional<std::string> walls_sentence(const ModelLevels& levels);
/// Whether the planar model changes a count.
std::string planar_sentence(const ModelLevels& levels);

}  // namespace ricochet::site
