#pragma once

#include <vector>

#include "src/report/json.h"
#include "src/studies/reproduction/study.h"

/// The parts of the report's data. Speeds are in rad/s, errors and shares are fractions.
namespace ricochet::studies::reproduction {

/// What the paper says of every case and what is computed: by the case's id.
report::Json case_data(const std::vector<CaseStudy>& cases);

/// The speeds that the paper's figures show, those on the wrong side, a chart of the thresholds.
report::Json threshold_data(const std::vector<CaseStudy>& cases);

/// How much of the thresholds, the paper's and those computed, formulas of one line explain.
report::Json theory_data(const std::vector<CaseStudy>& cases);

/// Collision count against speed, one chart a case.
report::Json curve_data(const std::vector<CaseStudy>& cases);

/// Whether the count makes a step at the threshold of every case.
report::Json sharpness_data(const std::vector<CaseStudy>& cases);

/// The steps of every case's staircase, beside the threshold by the paper's rule.
report::Json step_data(const std::vector<CaseStudy>& cases);

/// Conclusions A, B and C on a grid of restitution, friction and disturbance.
report::Json conclusion_data(const CountGrid& grid, const std::vector<Trend>& trends);

/// x(t) of the cases without disturbance, at several speeds, with those of the cases that differ in
/// their disturbance alone; of the others as in Figures 9-14; and when the carrier hits its walls.
report::Json path_data(const std::vector<CaseStudy>& cases);

/// Velocity and acceleration along the track, as in Figure 3.
report::Json crossing_data();

/// How well which solver finds the fewest collisions and the fastest quiet speed.
report::Json comparison_data(const Results& results);

/// What the reading decides where the paper leaves something open, and its constants.
report::Json reading_data(const carrier_track::FittedReading& reading);

}  // namespace ricochet::studies::reproduction
