#pragma once

#include <optional>
#include <string>

#include "src/report/chart.h"
#include "src/report/site/front.h"
#include "src/report/site/navigation.h"

namespace ricochet::site {

/// The page about the machines, src/report/site/machines.md, from what the reports say, see
/// site_results(): how fast the paper's turn, what moves that speed, and whether the level of the
/// model matters.
OwnFiles machine_page(report::Results site);
Place machine_place();

/// Shows each machine of a table (case, silent_up_to, quiet_up_to, paper_threshold [rad/s]) as a
/// column: silent, quiet and loud speeds, and the paper's threshold.
report::Chart regimes_chart(const ricochet::Table& thresholds);

/// The range of the machines' fastest quiet speeds in a sentence; nothing if none has one.
std::optional<std::string> speed_sentence(const ricochet::Table& thresholds);

}  // namespace ricochet::site
