#pragma once

#include <vector>

#include "src/report/page.h"
#include "src/studies/reproduction/study.h"

/// The parts of the report, in its order. Each says first what it found.
namespace ricochet::studies::reproduction {

/// Paper and computation side by side: thresholds, quiet counts, the other parts of the score, and
/// the speeds that the paper's figures show.
report::Section threshold_section(const std::vector<CaseStudy>& cases);

/// How much of the thresholds, the paper's and those computed, formulas of one line explain.
report::Section theory_section(const std::vector<CaseStudy>& cases);

/// Collision count against speed, one chart a case.
report::Section curve_section(const std::vector<CaseStudy>& cases);

/// Conclusions A, B and C on a grid of restitution, friction and disturbance.
report::Section conclusion_section(const CountGrid& grid, const std::vector<Trend>& trends);

/// x(t) as in Figures 5-14.
report::Section path_section(const std::vector<CaseStudy>& cases);

/// Velocity and acceleration along the track, as in Figure 3.
report::Section crossing_section();

/// How well which solver finds the fewest collisions and the fastest quiet speed.
report::Section comparison_section(const Study& study);

/// Where the paper contradicts itself or is silent, and what is done about it.
report::Section contradiction_section(const Study& study);

/// What made this report.
report::Section provenance_section(const Study& study);

}  // namespace ricochet::studies::reproduction
